"""The entry points of a tree as its public headers declare them.

Drivers of proofs see what a caller sees: they are written from the text of the headers, so that
whatever a header promises is what is proven.
"""

from __future__ import annotations

import re
from collections.abc import Mapping
from dataclasses import dataclass

from symnav.export.records import Tree

_ENTRY = re.compile(r"/\*\*\n(?P<comment>(?: \*[^\n]*\n)+?) \*/\n(?P<head>\w+_status_t [^;{]*);")
_HEAD = re.compile(r"\w+ (?P<symbol>\w+)\((?P<parameters>.*)\)")
_PARAMETER = re.compile(r"(?P<const>const )?(?P<type>\w+) (?P<name>\w+)(?:\[\w+ ?(?P<size>.*)\])?")
_MACRO = re.compile(r"^#define (\w+) (\d+)$", re.MULTILINE)
_ENUMERATOR = re.compile(r"^    (\w+) = (\d+),", re.MULTILINE)


@dataclass(frozen=True, slots=True)
class Parameter:
    """A parameter of an entry point.

    Attributes:
        type: of the parameter, or of its elements.
        name: identifier.
        written: True for an output.
        array: True for a pointer.
        size: number of elements of one call as the header says it; empty where it says none.
    """

    type: str
    name: str
    written: bool
    array: bool
    size: str


@dataclass(frozen=True, slots=True)
class Prototype:
    """An entry point.

    Attributes:
        symbol: its name.
        parameters: in order.
        statuses: the statuses its documentation lists, without the prefix.
    """

    symbol: str
    parameters: tuple[Parameter, ...]
    statuses: tuple[str, ...]

    @property
    def names(self) -> tuple[str, ...]:
        """Names of its parameters."""
        return tuple(parameter.name for parameter in self.parameters)


def prototypes(tree: Tree) -> tuple[Prototype, ...]:
    """Every entry point of a tree, in the order of its header.

    Raises:
        AssertionError: when the header holds a parameter that cannot be read.
    """
    text = tree.files[f"include/{tree.prefix}/{tree.prefix}.h"]
    return tuple(_prototype(entry["head"], entry["comment"]) for entry in _ENTRY.finditer(text))


def constants(tree: Tree) -> Mapping[str, int]:
    """The integer macros and enumerators of the headers and sources of a tree, by name."""
    found: dict[str, int] = {}
    for _, text in sorted(tree.files.items()):
        for pattern in (_MACRO, _ENUMERATOR):
            found.update((name, int(value)) for name, value in pattern.findall(text))
    return found


def value_of(size: str, known: Mapping[str, int]) -> int:
    """The number a size of a header stands for: sums, differences and products of constants."""
    text = re.sub(r"[A-Z]\w+", lambda match: str(known[match[0]]), size)
    terms = text.replace("(", " ").replace(")", " ").split()
    if not all(term.isdigit() or term in "+-*" for term in terms):
        raise AssertionError(f"a size that cannot be read: {size}")
    return _product(text)


def _product(text: str) -> int:
    """Value of a product whose factors are numbers or ``(number - number)``."""
    result = 1
    for factor in re.split(r" \* ", text):
        first, *rest = factor.strip("() ").split(" - ")
        result *= int(first) - sum(int(number) for number in rest)
    return result


def _prototype(head: str, comment: str) -> Prototype:
    found = _HEAD.fullmatch(" ".join(head.split()).replace("( ", "("))
    if found is None:
        raise AssertionError(f"an entry point that cannot be read: {head}")
    said = " ".join(line.lstrip(" *") for line in comment.splitlines()).partition("@return ")[2]
    listed = found["parameters"].split(", ")
    return Prototype(
        found["symbol"],
        tuple(_parameter(declaration) for declaration in listed),
        tuple(re.findall(r"\b([A-Z]+) \(", said)),
    )


def _parameter(declaration: str) -> Parameter:
    found = _PARAMETER.fullmatch(declaration)
    if found is None:
        raise AssertionError(f"a parameter that cannot be read: {declaration}")
    array = "[" in declaration
    size = found["size"] or ""
    return Parameter(found["type"], found["name"], array and not found["const"], array, size)
