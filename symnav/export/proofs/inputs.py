"""What a bundle holds to be proven with: drivers, scripts and budgets of the proof runners."""

from __future__ import annotations

import json
from collections.abc import Mapping
from dataclasses import asdict

from symnav.emit.templates import render
from symnav.export.documents.deviations import DEVIATIONS
from symnav.export.proofs import eva, fuzzing
from symnav.export.records import Bundle


def files(bundle: Bundle) -> Mapping[str, str]:
    """The inputs of the proofs, below ``proof/``, and the configuration of clang-tidy."""
    budget = {
        "standard": "MISRA C:2012 as far as the addon of cppcheck 2.22 checks it",
        "deviations": [asdict(deviation) for deviation in DEVIATIONS],
    }
    return {
        **eva.files(bundle),
        **fuzzing.files(bundle),
        ".clang-tidy": render("export/proof/clang-tidy.j2"),
        "proof/misra.json": json.dumps(budget, indent=2) + "\n",
        "proof/README.md": render(
            "export/proof/README.md.j2",
            name=bundle.name,
            others=(),
            border=any(function.checks_at_border for _, function in bundle.functions()),
        ),
    }
