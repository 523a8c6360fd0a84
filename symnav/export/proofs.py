"""What a bundle holds to be proven with: drivers, scripts and budgets of the proof runners."""

from __future__ import annotations

from collections.abc import Mapping

from symnav.export import eva, fuzzing
from symnav.export.records import Bundle


def files(bundle: Bundle) -> Mapping[str, str]:
    """The inputs of the proofs, below ``proof/``."""
    return {**eva.files(bundle), **fuzzing.files(bundle)}
