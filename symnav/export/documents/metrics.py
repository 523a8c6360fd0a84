"""``docs/metrics.json``: sizes of files and functions, and what the functions compute.

Everything is counted from the text and the intermediate representation, so that no tool is needed
and the same bundle gives the same numbers. What depends on a compiler is not here.
"""

from __future__ import annotations

import json
import re
from collections.abc import Iterator
from dataclasses import dataclass
from math import prod

from symnav import ir
from symnav.emit import c
from symnav.export.records import Bundle, Tree
from symnav.lower.passes.counts import count_operations

PATH = "docs/metrics.json"

_COMMENT = re.compile(r"/\*.*?\*/", re.DOTALL)
_DECISION = re.compile(r"\b(?:if|for|while|case)\b|&&|\|\||\?")
# What only the static proof sees, and the marks around it.
_PROOF = re.compile(r"^#ifdef __FRAMAC__.*?^#else\n|^#endif\n(?=\})", re.DOTALL | re.MULTILINE)
_NAME = re.compile(r"(\w+)\(")


@dataclass(frozen=True, slots=True)
class Measured:
    """One function of C.

    Attributes:
        name: identifier.
        code: lines with code, from the one with the name to the brace that ends the body.
        complexity: cyclomatic: one more than decisions, each operand of ``&&`` and ``||`` one.
        parameters: how many.
    """

    name: str
    code: int
    complexity: int
    parameters: int


def document(bundle: Bundle) -> str:
    """The metrics as JSON."""
    content = {
        "files": {
            path: _file(text) for tree in bundle.trees for path, text in sorted(tree.files.items())
        },
        "equations": {
            section.kernel.symbol: _equation(tree, section.kernel.function)
            for tree in bundle.trees
            for section in c.sections(tree.module)
        },
    }
    return json.dumps(content, indent=2) + "\n"


def measure(text: str) -> Iterator[Measured]:
    """Every function a file of the bundle defines, in order, as a compiler sees it.

    Heads start in the first column, and so does the brace that ends a body.
    """
    lines = _PROOF.sub("", _bare(text)).splitlines()
    head: list[str] = []
    first = 0
    for number, line in enumerate(lines):
        if line == "{" and head:
            last = lines.index("}", number)
            yield _measured(head, lines[first : last + 1], lines[number:last])
            head = []
        elif line.startswith(" ") and head:
            head.append(line)
        elif re.match(r"\w", line) and not line.endswith(";"):
            head, first = [line], number
        else:
            head = []


def _measured(head: list[str], whole: list[str], body: list[str]) -> Measured:
    text = " ".join(head)
    listed = text[text.index("(") + 1 : text.rindex(")")].strip()
    found = _NAME.search(text)
    assert found is not None
    named = next(k for k, line in enumerate(whole) if _NAME.search(line))
    return Measured(
        found[1],
        sum(1 for line in whole[named:] if line.strip()),
        1 + len(_DECISION.findall("\n".join(body))),
        0 if listed in ("", "void") else listed.count(",") + 1,
    )


def _file(text: str) -> dict[str, object]:
    return {
        "bytes": len(text.encode()),
        "lines": len(text.splitlines()),
        "code": sum(1 for line in _bare(text).splitlines() if line.strip()),
        "functions": {
            one.name: {
                "code": one.code,
                "complexity": one.complexity,
                "parameters": one.parameters,
            }
            for one in measure(text)
        },
    }


def _equation(tree: Tree, function: ir.Function) -> dict[str, object]:
    real = 8 if tree.module.scalar is ir.Scalar.DOUBLE else 4
    counts = count_operations(function)
    steps = (*function.shared, *function.item)
    content: dict[str, object] = {
        "operations": {k.value: v for k, v in sorted(counts.shared.items())},
        "guards": sum(isinstance(step, ir.Check) for step in steps),
        "inputs": {a.name: a.size for a in function.arguments},
        "outputs": {
            o.name: {
                "elements": prod(o.shape),
                "bytes": real * prod(o.shape),
                "non_zeros": len(o.entries),
            }
            for o in function.outputs
        },
    }
    if function.maximum is not None:
        content["operations_per_item"] = {k.value: v for k, v in sorted(counts.item.items())}
        content["most_items"] = function.maximum
    return content


def _bare(text: str) -> str:
    """The text without comments, line for line."""
    return _COMMENT.sub(lambda match: "\n" * match[0].count("\n"), text)
