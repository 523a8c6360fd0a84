"""The canonical text of a specification: what its digest is taken over.

It is JSON of the validated records, not of what was written: defaults are filled in, implied
inputs stand like declared ones, ranges have one pair per element, and neither formatting nor the
order of keys matters. States, inputs and entries keep their order, because it is the order of
memory, arguments and functions. An equation written as expressions stands in its normal form; one
written in Python stands by the definitions it makes, so that renaming or reformatting the function
changes nothing.
"""

from __future__ import annotations

import json
from collections.abc import Mapping, Sequence
from dataclasses import asdict, fields
from typing import Any

from symnav.blocks import Block
from symnav.spec.records import Binding, Entry, Frame, Input


def canonical_text(
    name: str,
    description: str,
    frames: Sequence[Frame],
    blocks: Sequence[Block],
    inputs: Mapping[str, Input],
    entries: Sequence[tuple[Entry, tuple[str, ...]]],
    scalars: Sequence[str],
) -> str:
    """JSON with sorted keys; entries come with the lines of their user equation."""
    document = {
        "name": name,
        "description": description,
        "frames": sorted((asdict(frame) for frame in frames), key=lambda frame: frame["name"]),
        "state": [_block(block) for block in blocks],
        "inputs": [_input(given) for given in inputs.values()],
        "entries": [_entry(entry, lines) for entry, lines in entries],
        "scalars": list(scalars),
    }
    return json.dumps(document, sort_keys=True, indent=1, allow_nan=False) + "\n"


def _block(block: Block) -> dict[str, Any]:
    return {"kind": block.kind, **{f.name: getattr(block, f.name) for f in fields(block)}}


def _input(given: Input) -> dict[str, Any]:
    return {**_block(given.block), "item": given.item, "integer": given.integer}


def _entry(entry: Entry, lines: tuple[str, ...]) -> dict[str, Any]:
    plain = {
        f.name: getattr(entry, f.name)
        for f in fields(entry)
        if f.name not in ("model", "path", "bindings")
    }
    model = entry.model
    identity = {"name": model.name, "section": model.section, "title": model.title}
    bindings = {role: _binding(binding) for role, binding in entry.bindings.items()}
    return {**plain, "model": identity, "bindings": bindings, "equation": list(lines)}


def _binding(binding: Binding) -> dict[str, Any]:
    return {"to": type(binding).__name__, **asdict(binding)}
