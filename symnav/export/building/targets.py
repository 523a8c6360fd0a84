"""Runs of a bundle on a bare Cortex-M: start-up code, and a program that counts instructions.

``test/semihost/`` holds what stands between a reset and ``main``, a Makefile, a CMake toolchain
file, and ``count.c``: it calls every function with inputs inside their ranges and prints what came
out, bit by bit, and how many instructions a call took. The same file runs on any host.
"""

from __future__ import annotations

import textwrap
from collections.abc import Iterable, Iterator
from dataclasses import dataclass
from itertools import accumulate
from typing import Any

import numpy as np
from numpy.typing import NDArray

from symnav import ir
from symnav.emit.templates import render
from symnav.errors import ProofError
from symnav.export.arithmetic import evaluation
from symnav.export.records import Bundle, Tree
from symnav.verify import sampling

FOLDER = "test/semihost"
Real = NDArray[Any]
SAMPLES = 8
ITEMS = 8
DRAWN = 64
SEED = 20
TICK = 40
"""Instructions of one tick of the 25 MHz timer, when each takes a nanosecond of its clock."""

_PLAIN = ("startup.c", "semihost.c", "semihost.h", "mps2.ld", "targets.mk",
          "toolchain-arm-none-eabi.cmake")  # fmt: skip
_MADE = ("Makefile", "count.c")


@dataclass(frozen=True)
class Given:
    """An input array of one function.

    Attributes:
        name: of the array.
        type: of its elements.
        size: elements of one sample.
        rows: literals of every sample, in lines.
    """

    name: str
    type: str
    size: int
    rows: tuple[tuple[str, ...], ...]


@dataclass(frozen=True)
class Form:
    """One way to call a function.

    Attributes:
        symbol: what is called.
        call: its arguments.
        scalar: type of its numbers.
        out: the array its outputs go to.
        words: 32-bit words of all outputs.
        blocks: a number for every element of the outputs, one for what shares a unit; in lines.
    """

    symbol: str
    call: tuple[str, ...]
    scalar: ir.Scalar
    out: str
    words: int
    blocks: tuple[str, ...]


def files(bundle: Bundle) -> dict[str, str]:
    """The files below ``test/semihost``."""
    context = {
        "name": bundle.name,
        "trees": bundle.trees,
        "samples": SAMPLES,
        "instructions": TICK,
        "items": max(function.maximum or 0 for _, function in bundle.functions()),
        "outputs": [_room(tree, bundle) for tree in bundle.trees if tree.module.functions],
        "given": [one for tree, function in bundle.functions() for one in _given(
            bundle, tree, function)],
        "forms": list(_forms(bundle)),
    }  # fmt: skip
    templates = {name: f"export/{FOLDER}/{name}" for name in _PLAIN}
    templates |= {name: f"export/{FOLDER}/{name}.j2" for name in _MADE}
    return {f"{FOLDER}/{name}": render(path, **context) for name, path in templates.items()}


def _room(tree: Tree, bundle: Bundle) -> dict[str, str | int]:
    """The array that takes the outputs of a tree's functions."""
    most = max(form.words for form in _forms(bundle) if form.out == _out(tree))
    real = f"{tree.prefix}_real_t"
    return {"type": real, "name": _out(tree), "size": most // _words(tree.module.scalar)}


def _out(tree: Tree) -> str:
    return f"{tree.prefix}_out"


def _words(scalar: ir.Scalar) -> int:
    return 2 if scalar is ir.Scalar.DOUBLE else 1


def _items(function: ir.Function) -> int:
    return min(ITEMS, function.maximum) if function.maximum is not None else 1


def _given(bundle: Bundle, tree: Tree, function: ir.Function) -> Iterator[Given]:
    """Inputs of a function: random, inside the declared ranges, and none that a guard refuses."""
    rows = _samples(bundle, function, tree.module.scalar)
    for argument in function.arguments:
        yield Given(
            name=_name(tree, function, argument),
            type="int32_t" if argument.integer else f"{tree.prefix}_real_t",
            size=argument.size * _room_of(function, argument.item),
            rows=tuple(
                _lines(_literal(element, argument, tree.module.scalar) for element in row)
                for row in rows[argument.name]
            ),
        )


def _samples(bundle: Bundle, function: ir.Function, scalar: ir.Scalar) -> dict[str, Real]:
    """Every argument, a row for every sample, item after item.

    An item that a guard refuses is replaced by another of its sample.

    Raises:
        ProofError: when guards refuse nearly everything that is drawn.
    """
    derivation = next(d for d in bundle.derivations if d.name == function.name)
    drawn = sampling.draw(bundle.spec, derivation, DRAWN, SEED, _items(function))
    flat = drawn.flat()
    kinds = {
        a.name: np.int32 if a.integer else evaluation.kind_of(scalar) for a in function.arguments
    }
    rows: dict[str, Real] = {name: flat[name].astype(kind) for name, kind in kinds.items()}
    items = drawn.items or 1
    passed = evaluation.evaluate(function, scalar, rows).ok.reshape(-1, items)
    random = np.array([label == sampling.RANDOM for label in drawn.labels[::items]])
    samples = np.flatnonzero(passed.any(axis=1) & random)[:SAMPLES]
    if len(samples) < SAMPLES:
        raise ProofError(
            f"{function.name}: guards refuse nearly all that is drawn inside the declared ranges; "
            "change the ranges or the equation"
        )
    good = [k * items + np.resize(np.flatnonzero(passed[k]), items) for k in samples]
    return {
        a.name: np.stack([rows[a.name][at if a.item else at[:1]].ravel() for at in good])
        for a in function.arguments
    }


def _name(tree: Tree, function: ir.Function, argument: ir.Argument) -> str:
    return f"{tree.prefix}_{function.name}_{argument.name}_given"


def _literal(element: float, argument: ir.Argument, scalar: ir.Scalar) -> str:
    """Exact, in hexadecimal."""
    if argument.integer:
        return str(int(element))
    return float(element).hex() + ("F" if scalar is ir.Scalar.FLOAT else "")


def _forms(bundle: Bundle) -> Iterator[Form]:
    """The dense and the sparse form of every function."""
    for tree, function in bundle.functions():
        jacobians = [o for o in function.outputs if _sparse(o)]
        yield _form(tree, function, "", [_dense_blocks(function, o) for o in function.outputs])
        if any(output.entries for output in jacobians):
            kept = [o for o in function.outputs if o not in jacobians or o.entries]
            yield _form(tree, function, "_nz", [
                _sparse_blocks(function, o) if o in jacobians else _dense_blocks(function, o)
                for o in kept
            ])  # fmt: skip


def _sparse(output: ir.Output) -> bool:
    return output.name.startswith("jacobian")


def _form(
    tree: Tree, function: ir.Function, suffix: str, blocks: list[list[tuple[str, int, int]]]
) -> Form:
    """A call; every array of the items has room for the most of them, as its declaration says."""
    mapped = function.maximum is not None
    places = [f"&{_out(tree)}[{at}]" for at in accumulate(map(len, blocks[:-1]), initial=0)]
    first, *rest = [f"{_name(tree, function, argument)}[k]" for argument in function.arguments]
    count = [str(_items(function))] if mapped else []
    call = (first, *count, *rest, *places, *(["item_status"] if mapped else []))
    together = [block for output in blocks for block in output]
    numbers = {block: k for k, block in enumerate(dict.fromkeys(together))}
    return Form(
        symbol=f"{tree.prefix}_{function.name}{suffix}",
        call=call,
        scalar=tree.module.scalar,
        out=_out(tree),
        words=len(together) * _words(tree.module.scalar),
        blocks=_lines(str(numbers[block]) for block in together),
    )


def _dense_blocks(function: ir.Function, output: ir.Output) -> list[tuple[str, int, int]]:
    """The block of every element of an output, as it is stored: what has one unit."""
    indices = list(np.ndindex(*output.shape))
    if function.column_major and len(output.shape) == 2:
        indices.sort(key=lambda index: (index[1], index[0]))
    return [_block(output, index) for index in indices] * _room_of(function, output.item)


def _sparse_blocks(function: ir.Function, output: ir.Output) -> list[tuple[str, int, int]]:
    """The same of the non-zeros: each is stored for one item after the other."""
    room = _room_of(function, output.item)
    starts = [tuple(i.base if isinstance(i, ir.Offset) else i for i in entry.index)
              for entry in output.entries]  # fmt: skip
    return [_block(output, index) for index in starts for _ in range(room)]


def _block(output: ir.Output, index: tuple[int, ...]) -> tuple[str, int, int]:
    """Name of an output, sections of a row and of a column."""
    row, column = (
        (0, *index)[-2:] if len(output.shape) < 2 and _sparse(output) else (*index, 0, 0)[:2]
    )
    return output.name, _section(output.rows, row), _section(output.columns, column)


def _section(sections: tuple[ir.Section, ...], index: int) -> int:
    return sum(section.start <= index for section in sections)


def _lines(literals: Iterable[str]) -> tuple[str, ...]:
    return tuple(textwrap.wrap(", ".join(literals), 90))


def _room_of(function: ir.Function, item: bool) -> int:
    return (function.maximum or 1) if item else 1
