"""The parts of an IR function that no arithmetic touches: arguments, outputs, documentation."""

from __future__ import annotations

from collections.abc import Iterator, Mapping, Sequence
from dataclasses import replace

import sympy as sp

from symnav import ir
from symnav.binding import STATE
from symnav.blocks import Block, RotationBlock
from symnav.derive import Derivation, DerivedOutput
from symnav.layout import Place
from symnav.spec.records import Entry, Input, Spec

#: Values of a lowered output: (row, column) -> expression, as in ``DerivedOutput.entries``.
Values = Mapping[tuple[int, int], ir.Expression]


def function(
    spec: Spec,
    derivation: Derivation,
    shared: Sequence[ir.Step],
    item: Sequence[ir.Step],
    values: Mapping[str, Values],
    slots: Mapping[str, ir.Load],
) -> ir.Function:
    """Assemble the record from lowered steps and output values.

    Args:
        spec: for arguments and labels.
        derivation: what was lowered.
        shared: steps evaluated once.
        item: steps evaluated per item.
        values: expressions per output name.
        slots: slot symbol name -> its load.
    """
    entry = derivation.entry
    outputs = tuple(
        _output(spec, derivation, output, values[output.name], slots)
        for output in derivation.outputs
    )
    arguments = tuple(_argument(spec, derivation, name) for name in derivation.arguments)
    common = {
        "name": derivation.name,
        "arguments": arguments,
        "shared": tuple(shared),
        "item": tuple(item),
        "outputs": outputs,
    }
    if entry is None:
        return ir.Function(**common, **_layout_facts(spec, derivation.name))  # type: ignore[arg-type]
    return ir.Function(**common, **_entry_facts(entry))  # type: ignore[arg-type]


def _entry_facts(entry: Entry) -> dict[str, object]:
    model = entry.model
    role = ir.Role.CORRECTION if model.section == "correction" else ir.Role.MEASUREMENT
    return {
        "role": role,
        "title": model.title,
        "equation": model.equation,
        "source": model.source,
        "conventions": tuple(model.conventions(entry.options)),
        "maximum": entry.maximum if model.mapped else None,
        "items": ir.Items(entry.items),
        "guards": ir.Guards(entry.guards),
        "column_major": entry.column_major,
        "single_difference": entry.single_difference,
    }


def _layout_facts(spec: Spec, name: str) -> dict[str, object]:
    retract = name == "retract"
    return {
        "role": ir.Role.RETRACT if retract else ir.Role.LOCAL,
        "title": "State moved by an error" if retract else "Error between two states",
        "equation": "value = x (+) d" if retract else "value = y (-) x, so that x (+) value = y",
        "source": "the error conventions of the blocks",
        "conventions": tuple(_renormalisation(spec)) if retract else (),
        "maximum": None,
        "items": ir.Items.REJECT,
        "guards": ir.Guards.STATUS,
        "column_major": False,
        "single_difference": False,
    }


def _renormalisation(spec: Spec) -> Iterator[str]:
    """What a caller has to do who feeds retracted quaternions back."""
    blocks = [block for block in spec.layout.blocks if isinstance(block, RotationBlock)]
    judged = [block for block in blocks if _is_quaternion(block)]
    added = ", ".join(block.name for block in judged if block.error == "storage")
    renewed = ("storage", "rotation_vector")
    turned = ", ".join(block.name for block in judged if block.error not in renewed)
    if turned:
        yield (
            f"Products of unit quaternions drift from unit norm by rounding ({turned}): "
            "renormalise after every update, for which q *= 1.5 - 0.5 |q|^2 is enough; else calls "
            "end in QNORM, in single precision after some hundred."
        )
    if added:
        yield (
            f"The sum of a quaternion and an error is no unit quaternion ({added}): divide it by "
            "its norm after every update, else calls end in QNORM."
        )


# -- arguments -----------------------------------------------------------------------------------


def _argument(spec: Spec, derivation: Derivation, name: str) -> ir.Argument:
    if name == STATE or (derivation.entry is None and name == "y"):
        read = _read_elements(derivation)
        domains = tuple(_state_domain(derivation, place, read) for place in _places(spec))
        return ir.Argument(name, spec.layout.size, False, False, domains)
    if derivation.entry is None and name == "d":
        domains = tuple(_error_domain(place) for place in spec.layout.places.values())
        return ir.Argument(name, spec.layout.error_size, False, False, domains)
    declared = spec.inputs[name]
    domain = _domain(declared.block, 0, _kind(declared))
    size = declared.block.storage_size
    return ir.Argument(name, size, declared.item, declared.integer, (domain,))


def _places(spec: Spec) -> tuple[Place, ...]:
    return tuple(spec.layout.places.values())


def _read_elements(derivation: Derivation) -> set[int]:
    """First elements of the state symbols that anything depends on."""
    used: set[sp.Basic] = set()
    for definition in derivation.definitions:
        used |= definition.expression.free_symbols
    for output in derivation.outputs:
        for e in output.entries.values():
            used |= e.free_symbols
    return {o.index for s, o in derivation.origins.items() if s in used and o.argument == STATE}


def _state_domain(derivation: Derivation, place: Place, read: set[int]) -> ir.Domain:
    """A block of the state; a measurement does not guard what it does not read."""
    domain = storage_domain(place)
    if derivation.entry is None or read.intersection(
        range(place.storage.start, place.storage.stop)
    ):
        return domain
    return replace(domain, kind=ir.Kind.UNREAD)


def storage_domain(place: Place) -> ir.Domain:
    """The stored elements of a state block."""
    kind = ir.Kind.QUATERNION if _is_quaternion(place.block) else ir.Kind.REAL
    return _domain(place.block, place.start, kind)


def _error_domain(place: Place) -> ir.Domain:
    block, size = place.block, place.block.error_size
    bound = 6.0 if block.units[1] == "rad" else 1e9
    return ir.Domain(
        block.name, place.error_start, size, ir.Kind.REAL, (-bound,) * size, (bound,) * size, 0.0,
        block.units[1], block.frames[1], block.error_labels, f"Error of {block.name}.",
    )  # fmt: skip


def _domain(block: Block, start: int, kind: ir.Kind) -> ir.Domain:
    return ir.Domain(
        block.name, start, block.storage_size, kind, block.lower, block.upper,
        block.norm_tolerance, block.units[0], block.frames[0], block.storage_labels,
        block.description,
    )  # fmt: skip


def _kind(declared: Input) -> ir.Kind:
    if declared.integer:
        return ir.Kind.INTEGER
    if isinstance(declared.block, RotationBlock) and declared.block.storage == "dcm":
        return ir.Kind.MATRIX
    return ir.Kind.QUATERNION if _is_quaternion(declared.block) else ir.Kind.REAL


def _is_quaternion(block: Block) -> bool:
    return isinstance(block, RotationBlock) and block.storage != "dcm" and not block.normalise


# -- outputs -------------------------------------------------------------------------------------


def _output(
    spec: Spec,
    derivation: Derivation,
    output: DerivedOutput,
    values: Values,
    slots: Mapping[str, ir.Load],
) -> ir.Output:
    # A measurement keeps its one row, so that its Jacobian is a matrix; other results are scalars.
    primary = output.name in (derivation.outputs[0].name, "residual")
    alone = derivation.mapped or (output.kind == "value" and not primary)
    scalar = output.rows == 1 and alone
    rows = () if scalar else (output.rows,)
    jacobian = output.kind == "jacobian"
    shape = (*rows, output.columns) if jacobian else rows
    entries = []
    for (row, column), value in values.items():
        index: tuple[int | ir.Offset, ...] = () if scalar else (row,)
        if jacobian:
            slot = output.slots.get(column)
            index += (column if slot is None else ir.Offset(column, slots[slot.name]),)
        entries.append(ir.Entry(index, value))
    return ir.Output(
        output.name,
        shape,
        derivation.mapped,
        tuple(entries),
        _rows(spec, derivation, output),
        _columns(spec, output) if jacobian else (),
        output.unit,
        output.frame,
        _description(output),
    )


def _rows(spec: Spec, derivation: Derivation, output: DerivedOutput) -> tuple[ir.Section, ...]:
    if derivation.entry is None:
        return tuple(
            _section(place.block, place.start, storage=True)
            if derivation.name == "retract"
            else _section(place.block, place.error_start, storage=False)
            for place in spec.layout.places.values()
        )
    labels = ("x", "y", "z") if output.rows == 3 else tuple(str(i) for i in range(output.rows))
    primary = derivation.outputs[0].unit if output.kind == "jacobian" else output.unit
    name = "value" if output.kind == "jacobian" else output.name
    return (ir.Section(name, 0, output.rows, primary, labels),)


def _columns(spec: Spec, output: DerivedOutput) -> tuple[ir.Section, ...]:
    if output.by:
        block = spec.inputs[output.by].block
        return (_section(block, 0, storage=output.columns != block.error_size),)
    return tuple(
        _section(place.block, place.error_start, storage=False)
        for place in spec.layout.places.values()
    )


def _section(block: Block, start: int, *, storage: bool) -> ir.Section:
    if storage:
        return ir.Section(
            block.name, start, block.storage_size, block.units[0], block.storage_labels
        )
    return ir.Section(block.name, start, block.error_size, block.units[1], block.error_labels)


def _description(output: DerivedOutput) -> str:
    if output.kind == "jacobian":
        by = output.by or "the error of the state"
        return f"Derivative of the value by {by}."
    return {
        "value": "Value of the equation.",
        "residual": "Measured less predicted value.",
        "value_covariance": "Covariance of the value, row-major.",
    }.get(output.name, f"{output.name.replace('_', ' ').capitalize()}.")


# -- module --------------------------------------------------------------------------------------


def state(spec: Spec) -> ir.State:
    """The layout as the emitters see it."""
    blocks = tuple(
        ir.StateBlock(
            place.block.name,
            place.block.kind,
            storage_domain(place),
            place.error_start,
            place.block.error_size,
            place.block.units[1],
            place.block.frames[1],
            place.block.error_labels,
            place.block.convention,
            place.block.initial,
        )
        for place in spec.layout.places.values()
    )
    return ir.State(blocks, spec.layout.size, spec.layout.error_size, spec.layout.digest)
