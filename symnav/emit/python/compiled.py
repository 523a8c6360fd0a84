"""The doors to compiled C: ``native.py``, with a straight way in for one epoch, and ``casadi.py``.

A call for one epoch costs less than a microsecond, most of it in Python; so it is written out for
each function: C looks at all arrays, makes those of the result, and computes. What C declines
takes the general way.
"""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import dataclass

from symnav import ir
from symnav.emit.python.names import result_names
from symnav.emit.python.shapes import entries, signature_name
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
    doors = [_door(function, results[function.name]) for function in module.functions]
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


def _door(function: ir.Function, result: str) -> Door:
    """Both ways into a function; columns need memory of their own, so they have only one."""
    name = f"_{function.name}_function"
    made = call("_compiled.CompiledFunction", "_library", signature_name(function))
    head = lay_out(made, before=f"{name} = ")
    public = [name, "__name__"]
    straight: list[str] = []
    if has_epoch(function):
        entry = call("_library.call", quoted(function.name), f"_interface.{result}")
        head += lay_out(entry, before=f"_{function.name}_straight = ")
        straight += _straight(function)
        public.append(f"_{function.name}_call")
    published = lay_out(call("_calls.publish", *public), before=f"{function.name} = ")
    return Door(tuple(head), tuple(straight), tuple(published))


def _straight(function: ir.Function) -> Iterator[str]:
    """A function that goes straight to the C when its arguments are as the C wants them."""
    names = [argument.name for argument in function.arguments]
    first = ["x: Any = None", "/"] if names[:1] == ["x"] else []
    inputs = [f"{name}: Any = None" for name in names if name != "x"]
    # What is too much goes the general way, which says so as every back end does.
    rest = ["*_more: Any", *inputs, "out: Any = None", "**_other: Any"]
    head = call(f"_{function.name}_call", *first, *rest)
    yield from lay_out(head, before="def ", after=" -> Any:")
    own = call(f"_{function.name}_straight", *names, "out")
    yield from lay_out(own, before="_found = None if _more or _other else ", depth=1)
    yield "    if _found is not None:"
    yield "        return _found"
    state = tuple_of(["x", "*_more"]) if first else "_more"
    known = ", ".join([*(f'"{name}": {name}' for name in names if name != "x"), "**_other"])
    general = call(f"_{function.name}_function.call", state, f"{{{known}}}", "out")
    yield from lay_out(general, before="return ", depth=1)
