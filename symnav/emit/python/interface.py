"""``_interface.py``: what a package's functions and its state look like, as data."""

from __future__ import annotations

from collections.abc import Iterator

from symnav import errors, ir
from symnav.emit.lanes import lanes_of
from symnav.emit.python.documentation import documentation
from symnav.emit.python.names import result_names
from symnav.emit.python.shapes import (
    argument_of,
    is_scalar,
    output_shape,
    slot_element,
    slot_range,
)
from symnav.emit.python.text import (
    Group,
    call,
    docstring,
    integers,
    lay_out,
    literal,
    numbers,
    quoted,
    strings,
    tuple_of,
)
from symnav.emit.templates import render

_STATE = "_STATE"


def interface(module: ir.Module) -> str:
    """Render ``_interface.py``."""
    results = result_names(module.functions)
    shared = _state_argument(module)
    state = ["", "", *_argument(module.functions[0], shared, _STATE)] if shared else []
    lines = [
        *_results(module, results),
        *state,
        *(
            line
            for function in module.functions
            for line in _signature(function, results[function.name], shared)
        ),
        *_blocks(module),
    ]
    text = "\n".join(lines)
    return render(
        "package/_interface.py.j2",
        name=module.name,
        imported=_imported(module),
        infinite="math.inf" in text,
        stateful=bool(module.state.blocks),
        lines=lines,
    )


def _imported(module: ir.Module) -> list[str]:
    """The records that the data is made of."""
    names = {"Argument", "Array", "Domain", "Kind", "Output", "Signature"}
    if any(list(_conditions(function)) for function in module.functions):
        names |= {"Condition", "Status"}
    outputs = [output for function in module.functions for output in function.outputs]
    indices = {index for output in outputs for entry in output.entries for index in entry.index}
    if any(isinstance(index, ir.Offset) for index in indices):
        names.add("Slot")
    return sorted(names)


def _state_argument(module: ir.Module) -> ir.Argument | None:
    for function in module.functions:
        for argument in function.arguments:
            if argument.name == "x":
                return argument
    return None


def _results(module: ir.Module, results: dict[str, str]) -> Iterator[str]:
    for function in module.functions:
        yield from ["", "", f"class {results[function.name]}(NamedTuple):"]
        yield f'    """What ``{function.name}`` returns."""'
        yield ""
        for output in function.outputs:
            yield f"    {output.name}: Array"
            text = f"{output.description.rstrip('.')}; shape {output_shape(function, output)}."
            yield from docstring([text], 1)
        yield "    status: Any"
        if function.maximum is not None:
            yield "    item_status: Array"


def _signature(function: ir.Function, result: str, shared: ir.Argument | None) -> Iterator[str]:
    yield from ["", "", f"{function.name.upper()} = Signature("]
    yield f"    {quoted(function.name)},"
    text = docstring(documentation(function, result), 1)
    yield from [*text[:-1], f"{text[-1]},", f"    {result},"]
    arguments = [
        _STATE if argument == shared else _argument_piece(function, argument)
        for argument in function.arguments
    ]
    yield from lay_out(tuple_of(arguments), after=",", depth=1)
    outputs = [_output(function, output) for output in function.outputs]
    yield from lay_out(tuple_of(outputs), after=",", depth=1)
    conditions = list(_conditions(function))
    if conditions:
        yield from lay_out(tuple_of(conditions), before="conditions=", after=",", depth=1)
    for name, value, default in (
        ("maximum", function.maximum, None),
        ("reject", function.items is ir.Items.REJECT and function.maximum is not None, False),
        ("guarded", function.checks_inputs, True),
        ("column_major", function.column_major, False),
        ("single_difference", function.single_difference, False),
        ("lanes", lanes_of(function) if function.maximum is None else 0, 0),
    ):
        if value != default:
            yield f"    {name}={value},"
    yield ")"


def _argument(function: ir.Function, argument: ir.Argument, target: str) -> list[str]:
    return lay_out(_argument_piece(function, argument), before=f"{target} = ")


def _argument_piece(function: ir.Function, argument: ir.Argument) -> Group:
    flags = {
        "item": argument.item,
        "integer": argument.integer,
        "scalar": is_scalar(function, argument),
    }
    return call(
        "Argument",
        quoted(argument.name),
        str(argument.size),
        tuple_of(_domain(domain) for domain in argument.domains),
        *(f"{name}=True" for name, value in flags.items() if value),
    )


def _domain(domain: ir.Domain) -> Group:
    normed = domain.kind in (ir.Kind.QUATERNION, ir.Kind.MATRIX)
    return call(
        "Domain",
        quoted(domain.name),
        str(domain.start),
        str(domain.size),
        f"Kind.{domain.kind.name}",
        numbers(domain.lower),
        numbers(domain.upper),
        quoted(domain.unit),
        quoted(domain.frame),
        strings(domain.labels),
        *([repr(domain.tolerance)] if normed else []),
    )


def _output(function: ir.Function, output: ir.Output) -> Group:
    places = [_place(function, output, entry) for entry in output.entries]
    fixed = [place for place in places if isinstance(place, int)]
    texts = [str(place) if isinstance(place, int) else place for place in places]
    piece = integers(fixed) if len(fixed) == len(places) else tuple_of(texts)
    item = ["item=True"] if output.item and function.maximum is not None else []
    return call("Output", quoted(output.name), integers(output.shape), piece, *item)


def _place(function: ir.Function, output: ir.Output, entry: ir.Entry) -> int | Group:
    """Where a non-zero stands in the flattened output."""
    base, stride = 0, 1
    slots: list[tuple[int, int, ir.Offset]] = []
    for index, length in zip(reversed(entry.index), reversed(output.shape), strict=True):
        if isinstance(index, ir.Offset):
            slots.append((stride, length, index))
            base += index.base * stride
        else:
            base += index * stride
        stride *= length
    if not slots:
        return base
    if len(slots) > 1:
        raise errors.InputError(
            f"{function.name}: an element of {output.name} is placed by two run-time indices; "
            "one is supported"
        )
    ((step, length, offset),) = slots
    return _slot(function, base, step, length, offset)


def _slot(function: ir.Function, base: int, step: int, length: int, offset: ir.Offset) -> Group:
    """A place that depends on an index, with the indices that are allowed."""
    argument = argument_of(function, offset.slot.argument)
    element = "None" if is_scalar(function, argument) else str(slot_element(offset))
    ends = [str(index) for index in slot_range(function, offset, length)]
    return call("Slot", str(base), str(step), quoted(argument.name), element, *ends)


def _conditions(function: ir.Function) -> Iterator[Group]:
    for step in (*function.shared, *function.item):
        if isinstance(step, ir.Check) and function.checks_domain:
            meaning = quoted(" ".join(step.comment.split()) or step.target)
            bounds = (literal(step.lower), literal(step.upper))
            yield call("Condition", f"Status.{step.status.name}", *bounds, meaning)


def _blocks(module: ir.Module) -> Iterator[str]:
    blocks = module.state.blocks
    if not blocks:
        return
    yield from ["", "", "class StateBlocks(NamedTuple):"]
    yield f'    """The blocks of the state of ``{module.name}``."""'
    yield ""
    for block in blocks:
        yield f"    {block.name}: Array"
    yield from ["", ""]
    yield from lay_out(tuple_of(_block(block) for block in blocks), before="_BLOCKS = ")
    yield ""
    yield from [f"_DIGEST = {quoted(module.state.digest)}"]


def _block(block: ir.StateBlock) -> Group:
    return call(
        "Block",
        quoted(block.name),
        strings(block.storage.labels),
        quoted(block.storage.unit),
        quoted(block.storage.frame),
        numbers(block.initial),
        strings(block.error_labels),
        quoted(block.error_unit),
        quoted(block.error_frame),
        quoted(block.convention),
    )
