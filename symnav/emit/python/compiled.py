"""The doors to compiled C: ``native.py``, with a straight way in for one epoch, and ``casadi.py``.

A call for one epoch costs less than a microsecond, most of it in Python; so it is written out for
each function: arrays are made, and C looks at them all and computes. What C declines takes the
general way.
"""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import dataclass

from symnav import ir
from symnav.emit.python.names import result_names
from symnav.emit.python.shapes import entries, is_scalar, signature_name
from symnav.emit.python.straight import has_epoch
from symnav.emit.python.text import call, lay_out, quoted, tuple_of
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
    if has_epoch(function):
        entry = call("_library.straight", quoted(function.name))
        head += lay_out(entry, before=f"_{function.name}_straight = ")
        straight += _straight(function, result, kind)
        public.append(f"_{function.name}_call")
    published = lay_out(call("_calls.publish", *public), before=f"{function.name} = ")
    return Door(tuple(head), tuple(straight), tuple(published))


def _straight(function: ir.Function, result: str, kind: str) -> Iterator[str]:
    """A function that goes straight to the C when its arguments are as the C wants them.

    What has no axes raises one of the errors that lead the general way.
    """
    names = [argument.name for argument in function.arguments]
    first = ["x: Any = None", "/"] if names[:1] == ["x"] else []
    inputs = [f"{name}: Any = None" for name in names if name != "x"]
    head = call(f"_{function.name}_call", *first, "*", *inputs, "out: Any = None", "**_other: Any")
    yield from lay_out(head, before="def ", after=" -> Any:")
    yield "    try:"
    yield f"        if {' and '.join(_tests(function))}:"
    items = [argument for argument in function.arguments if argument.item]
    if items:
        yield f"            n = len({items[0].name})"
    yield "            if out is None:"
    for output in function.outputs:
        yield f"                {output.name} = _empty({_shape(function, output)}{kind})"
    yield "            else:"
    results = [output.name for output in function.outputs]
    fields = len(results) + (1 if function.maximum is None else 2)
    written = call("_outputs", "out", str(len(results)), str(fields))
    yield from lay_out(written, before=f"{tuple_of(results)} = ", depth=4)
    if function.maximum is not None:
        yield "            item_status = _empty(n, _byte)"
    status = ["item_status"] if function.maximum is not None else []
    given = tuple_of(["_array", *names, *results, *status])
    yield from lay_out(given, before="given = ", depth=3)
    yield f"            if not _{function.name}_straight(_id(given)):"
    returned = call("_tuple", f"_interface.{result}", tuple_of([*results, "_OK", *status]))
    yield from lay_out(returned, before="return ", depth=4)
    yield "    except _UNFIT:"
    yield "        pass"
    state = tuple_of(["x"] if first else [])
    known = ", ".join([*(f'"{name}": {name}' for name in names if name != "x"), "**_other"])
    rest = call(f"_{function.name}_function.call", state, f"{{{known}}}", "out")
    yield from lay_out(rest, before="return ", depth=1)


def _tests(function: ir.Function) -> Iterator[str]:
    """What is looked at before arrays are made: no unknown argument, and one epoch."""
    yield "not _other"
    for argument in function.arguments:
        rank = argument.item + (not is_scalar(function, argument))
        if rank:
            yield f"{argument.name}.ndim == {rank}"
            return


def _shape(function: ir.Function, output: ir.Output) -> str:
    axes = ["n"] if output.item and function.maximum is not None else []
    axes += [str(length) for length in output.shape]
    return axes[0] if len(axes) == 1 else str(tuple_of(axes))
