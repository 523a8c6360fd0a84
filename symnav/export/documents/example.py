"""The example of the bundle's README: a whole program that calls one function."""

from __future__ import annotations

import math
from collections.abc import Iterator
from math import prod

from symnav import ir
from symnav.emit import c
from symnav.emit.c import comments
from symnav.emit.c.entries import EntryPoint
from symnav.emit.c.header import Section
from symnav.emit.c.pieces import Parameter, call
from symnav.emit.c.target import Target
from symnav.emit.templates import render
from symnav.export.building.build_files import model_digest
from symnav.export.records import Bundle, Tree

_WANTED = (ir.Role.MEASUREMENT, ir.Role.CORRECTION, ir.Role.RETRACT, ir.Role.LOCAL)


def program(bundle: Bundle) -> str:
    """C that includes the public headers, insists on layout and function, and calls it."""
    tree, section = _chosen(bundle)
    function, target = section.kernel.function, section.kernel.target
    entry = section.entries[0]
    given = {argument.name: argument for argument in function.arguments}
    inputs = [p for p in entry.parameters if p.direction == "in"]
    outputs = [p for p in entry.parameters if p.direction == "out"]
    return render(
        "export/docs/example.c.j2",
        prefix=tree.prefix,
        macro=target.macro,
        digest=f"0x{tree.module.state.digest[:8].upper()}U",
        model=f"0x{model_digest(tree, function.name)[:8].upper()}U",
        symbol=f"{tree.prefix}_{function.name}",
        inputs=[
            line
            for parameter in inputs
            for line in _input(parameter, given.get(parameter.name), target)
        ],
        outputs=[f"{_local(parameter, target)};" for parameter in outputs],
        call=list(_calls(section)),
        result=function.outputs[0].name,
        count=prod(function.outputs[0].shape),
    )


def _calls(section: Section) -> Iterator[str]:
    """The call, behind that of the check of its inputs where they are checked on their own."""
    target = section.kernel.target
    entry, *others = section.entries
    invocation = _call(entry)
    border = next((other for other in others if other.border), None)
    if border is None:
        yield from comments.code(f"const {target.status} status = {invocation};")
        return
    yield from comments.code(f"{target.status} status = {_call(border)};")
    yield ""
    yield f"    if (status == {target.macro}_OK) {{"
    yield from comments.code(f"status = {invocation};", depth=2)
    yield "    }"


def _call(entry: EntryPoint) -> str:
    return call(entry.symbol, [p.name for p in entry.parameters])


def _chosen(bundle: Bundle) -> tuple[Tree, Section]:
    """The first measurement, else correction, of the first tree that has any function."""
    found = [(tree, section) for tree in bundle.trees for section in c.sections(tree.module)]
    return min(found, key=lambda pair: _WANTED.index(pair[1].kernel.function.role))


def _local(parameter: Parameter, target: Target) -> str:
    """A parameter's declaration as that of a local variable."""
    return parameter.declaration.replace(f"{target.macro}_RESTRICT ", "")


def _input(parameter: Parameter, argument: ir.Argument | None, target: Target) -> Iterator[str]:
    if argument is None:  # the number of items
        yield f"const {parameter.declaration} = 1;"
        return
    values = values_of(argument)
    texts = [str(int(v)) if argument.integer else target.literal(v) for v in values]
    text = f"{_local(parameter, target)} = {{{', '.join(texts)}}};"
    first, *rest = comments.code(text)
    yield first.strip()
    yield from (line.removeprefix("    ") for line in rest)


def values_of(argument: ir.Argument) -> list[float]:
    """Elements inside the declared ranges, short to read and different from each other.

    Satellites stand far up their ranges, away from any antenna.
    """
    values: list[float] = []
    for domain in argument.domains:
        if domain.kind is ir.Kind.QUATERNION:
            values += [1.0 if label == "w" else 0.0 for label in domain.labels]
        elif domain.kind is ir.Kind.MATRIX:
            values += [1.0 if k % 4 == 0 else 0.0 for k in range(domain.size)]
        elif domain.kind is ir.Kind.INTEGER:
            values += domain.lower
        else:
            share = 0.75 if argument.item else 0.5
            values += [_element(domain, k, share) for k in range(domain.size)]
    return values


def _element(domain: ir.Domain, k: int, share: float) -> float:
    """A number of two digits and some steps, so far up the range, where there is one."""
    lower, upper = domain.lower[k], domain.upper[k]
    exact = lower + share * (upper - lower)
    magnitude = math.floor(math.log10(upper - lower))
    step = 10.0 ** min(0, magnitude - 1)
    short = round(round(exact, 1 - magnitude) + (k + 1) * step, max(0, 1 - magnitude))
    return short if lower <= short <= upper else exact
