"""State block kinds: storage size, error size, retract, local and the tangent rule of each."""

from symnav.blocks.base import Block, GeodeticPoint, Nominal, Value, frame_map
from symnav.blocks.connections import connecting
from symnav.blocks.geodetic import GeodeticBlock
from symnav.blocks.heading import HeadingBlock
from symnav.blocks.rotation import RotationBlock
from symnav.blocks.vector import ScalarBlock, VectorBlock

#: Every kind a spec may name.
KINDS: dict[str, type[Block]] = {
    kind.kind: kind
    for kind in (VectorBlock, ScalarBlock, RotationBlock, HeadingBlock, GeodeticBlock)
}

__all__ = [
    "KINDS",
    "Block",
    "GeodeticBlock",
    "GeodeticPoint",
    "HeadingBlock",
    "Nominal",
    "RotationBlock",
    "ScalarBlock",
    "Value",
    "VectorBlock",
    "connecting",
    "frame_map",
]
