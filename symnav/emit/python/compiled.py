"""The doors to compiled C: ``native.py``, with a straight way in for one epoch, and ``casadi.py``.

A call for one epoch with arrays of the right type costs a microsecond, most of it in Python; so
its checks are written out for each function, and everything else takes the general way.
"""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import dataclass

from symnav import ir
from symnav.emit.python.names import result_names
from symnav.emit.python.shapes import entries, is_scalar, signature_name
from symnav.emit.python.text import WIDTH, call, lay_out, quoted, tuple_of
from symnav.emit.templates import render

_REALS = {ir.Scalar.DOUBLE: "float64", ir.Scalar.FLOAT: "float32"}


@dataclass(frozen=True, slots=True)
class Door:
    """What the template of ``native.py`` says about one function.

    Attributes:
        head: lines that make the general way in.
        straight: lines of the straight way in; empty when only the general way is open.
        public: lines that define the public function.
    """

    head: tuple[str, ...]
    straight: tuple[str, ...]
    public: tuple[str, ...]


def native(module: ir.Module) -> str:
    """Render ``native.py``, or ``native_f32.py`` for a module in single precision."""
    results = result_names(module.functions)
    kind = "" if module.scalar is ir.Scalar.DOUBLE else ", _real"
    doors = [_door(function, results[function.name], kind) for function in module.functions]
    return render(
        "package/native.py.j2",
        prefix=module.name,
        real=_REALS[module.scalar],
        doors=doors,
    )


def casadi(module: ir.Module) -> str:
    """Render ``casadi.py``, for all but the maps of the state."""
    lines = [line for function in entries(module) for line in _foreign(module, function)]
    return render("package/casadi.py.j2", name=module.name, lines=lines)


def _foreign(module: ir.Module, function: ir.Function) -> list[str]:
    """The definition of a function in CasADi's C."""
    own = call("_foreign.ForeignFunction", "_module", quoted(module.name), signature_name(function))
    public = call("_calls.publish", own, "__name__")
    return lay_out(public, before=f"{function.name} = ")


def _door(function: ir.Function, result: str, kind: str) -> Door:
    """Both ways into a function; columns need memory of their own, so they have only one."""
    name = f"_{function.name}_function"
    made = call("_compiled.CompiledFunction", "_library", signature_name(function))
    head = lay_out(made, before=f"{name} = ")
    public = [name, "__name__"]
    straight: list[str] = []
    if not function.column_major:
        entry = call("_library.entry", quoted(function.name))
        head += lay_out(entry, before=f"_{function.name}_entry = ")
        straight += _straight(function, result, kind)
        public.append(f"_{function.name}_call")
    published = lay_out(call("_calls.publish", *public), before=f"{function.name} = ")
    return Door(tuple(head), tuple(straight), tuple(published))


def _straight(function: ir.Function, result: str, kind: str) -> Iterator[str]:
    """A function that goes straight to the C when its arguments are as the C wants them.

    What has the type and the shape of an array but no contiguous memory raises one of the errors
    that lead the general way.
    """
    names = [argument.name for argument in function.arguments]
    first = ["x: Any = None", "/"] if names[:1] == ["x"] else []
    inputs = [f"{name}: Any = None" for name in names if name != "x"]
    head = call(f"_{function.name}_call", *first, "*", *inputs, "out: Any = None", "**_other: Any")
    yield from lay_out(head, before="def ", after=" -> Any:")
    yield "    try:"
    yield "        if ("
    yield "            not _other"
    yield from (f"            and {test}" for test in _tests(function))
    yield "        ):"
    yield "            if out is None:"
    for output in function.outputs:
        yield f"                {output.name} = _empty({_shape(function, output)}{kind})"
    yield "            else:"
    yield from _writing(function)
    if function.maximum is not None:
        yield "            item_status = _empty(n, _byte)"
    entry = call(f"_{function.name}_entry", *_pointers(function))
    yield from lay_out(entry, before="if not ", after=":", depth=3)
    items = ["item_status"] if function.maximum is not None else []
    fields = tuple_of([*(output.name for output in function.outputs), "_OK", *items])
    yield from lay_out(call("_tuple", f"_interface.{result}", fields), before="return ", depth=4)
    yield "    except _UNFIT:"
    yield "        pass"
    state = tuple_of(["x"] if first else [])
    known = ", ".join([*(f'"{name}": {name}' for name in names if name != "x"), "**_other"])
    rest = call(f"_{function.name}_function.call", state, f"{{{known}}}", "out")
    yield from lay_out(rest, before="return ", depth=1)


def _writing(function: ir.Function) -> Iterator[str]:
    """Arrays that were given to write to: what is simple is tested here, the rest by ``given``."""
    names = tuple_of([output.name for output in function.outputs])
    count = len(function.outputs)
    yield f"                written = out[:{count}]"
    yield from lay_out(names, after=" = written", depth=4)
    yield "                if not ("
    fields = count + (1 if function.maximum is None else 2)
    yield f"                    len(out) in ({count}, {fields})"
    for test in _writable(function):
        line = f"                    and {test}"
        long = line.replace(" or ", f"\n{' ' * 24}or ")
        yield from (long if len(line) > WIDTH else line).split("\n")
    yield "                ):"
    given = call(f"_{function.name}_function.given", "out", *_given(function))
    yield from lay_out(given, before="written = ", depth=5)
    yield from lay_out(names, after=" = written", depth=5)


def _writable(function: ir.Function) -> Iterator[str]:
    """Conditions under which the C can write to arrays: those that own their memory overlap none.

    An array can overlap one that owns its memory only by being it, or a view of it.
    """
    arrays = {
        argument.name: _expected(function, argument)
        for argument in function.arguments
        if argument.item or not is_scalar(function, argument)
    }
    for name in arrays:
        yield f"({name}.base is None or _apart({name}, written))"
    for output in function.outputs:
        name = output.name
        axes = ["n"] if output.item and function.maximum is not None else []
        axes += [str(length) for length in output.shape]
        yield f"{name}.dtype is _real"
        yield from _shaped(name, axes)
        yield f"(flags := {name}.flags).carray"
        yield "flags.owndata"
        yield from (
            f"{name} is not {other}"
            for other, shape in arrays.items()
            if len(shape) == len(axes)
            and all(a == b or "n" in (a, b) for a, b in zip(shape, axes, strict=True))
        )
        arrays[name] = axes


def _shaped(name: str, axes: list[str]) -> Iterator[str]:
    """Conditions on a shape; one axis is looked at alone, since a tuple costs twice as much."""
    if len(axes) == 1:
        yield f"{name}.ndim == 1"
        yield f"len({name}) == {axes[0]}"
    else:
        yield f"{name}.shape == {tuple_of(axes)}"


def _tests(function: ir.Function) -> Iterator[str]:
    """Conditions under which the C can read every argument where it lies."""
    items = [argument for argument in function.arguments if argument.item]
    if items:
        yield f"(n := len({items[0].name})) <= {function.maximum}"
    for argument in function.arguments:
        if is_scalar(function, argument) and not argument.item:
            yield f"type({argument.name}) is {'int' if argument.integer else 'float'}"
            continue
        kind = "_integer" if argument.integer else "_real"
        yield f"{argument.name}.dtype is {kind}"
        yield from _shaped(argument.name, _expected(function, argument))


def _expected(function: ir.Function, argument: ir.Argument) -> list[str]:
    axes = ["n"] if argument.item else []
    return axes + ([] if is_scalar(function, argument) else [str(argument.size)])


def _given(function: ir.Function) -> list[str]:
    """The arrays of a call, which those it writes to must not overlap, and the number of items."""
    arrays = [
        argument.name
        for argument in function.arguments
        if argument.item or not is_scalar(function, argument)
    ]
    return [str(tuple_of(arrays)), *(["n"] if function.maximum is not None else [])]


def _shape(function: ir.Function, output: ir.Output) -> str:
    axes = ["n"] if output.item and function.maximum is not None else []
    axes += [str(length) for length in output.shape]
    return axes[0] if len(axes) == 1 else str(tuple_of(axes))


def _pointers(function: ir.Function) -> Iterator[str]:
    for number, argument in enumerate(function.arguments):
        kind = "_integers" if argument.integer else "_reals"
        if is_scalar(function, argument) and not argument.item:
            yield f"_new({kind}, ({argument.name},))"
        else:
            yield f"_pointer({kind}, {argument.name})"
        if number == 0 and function.maximum is not None:
            yield "n"
    yield from (f"_pointer(_reals, {output.name})" for output in function.outputs)
    if function.maximum is not None:
        yield "_pointer(_bytes, item_status)"
