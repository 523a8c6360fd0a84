"""Type stubs: what editors complete and type checkers check, with every argument by its name."""

from __future__ import annotations

from collections.abc import Iterator, Sequence

from symnav import ir
from symnav.emit.python.documentation import documentation
from symnav.emit.python.names import form_name, result_names
from symnav.emit.python.shapes import is_map, jacobians, values
from symnav.emit.python.text import call, docstring, lay_out
from symnav.emit.templates import render

_ARRAY = "_Array"


def stub(module: ir.Module, backends: Sequence[str], *, threaded: bool = False) -> str:
    """Render the stub that defines every type, for one floating-point type.

    Args:
        module: the functions.
        backends: names of the back ends that stand beside it in the package, for the package's
            own stub; empty for the stub of a back end.
        threaded: True for a back end whose batches can share threads.
    """
    results = result_names(module.functions)
    real = "np.float64" if module.scalar is ir.Scalar.DOUBLE else "np.float32"
    return render(
        "package/functions.pyi.j2",
        name=module.name,
        real=real,
        backends=backends,
        mapped=any(function.single_difference for function in module.functions),
        functions=[
            {
                "name": function.name,
                "result": results[function.name],
                "form": form_name(function),
                "fields": list(_fields(function)),
                "lines": list(_form(function, results[function.name])),
            }
            for function in module.functions
        ],
        state=list(_state(module)) if backends and module.state.blocks else [],
        single=any(function.maximum is None for function in module.functions),
        threaded=threaded,
    )


def backend_stub(functions: Sequence[ir.Function], *, threaded: bool = False) -> str:
    """Render the stub of a back end whose functions are typed like those of the package.

    Args:
        functions: that it has.
        threaded: True when its batches can share threads.
    """
    listed = [{"name": function.name, "form": form_name(function)} for function in functions]
    forms = sorted(form_name(function) for function in functions)
    return render("package/backend.pyi.j2", functions=listed, forms=forms, threaded=threaded)


def _fields(function: ir.Function) -> Iterator[str]:
    yield from (f"{output.name}: {_ARRAY}" for output in function.outputs)
    yield "status: Any"
    if function.maximum is not None:
        yield "item_status: NDArray[np.uint8]"


def _form(function: ir.Function, result: str) -> Iterator[str]:
    """The members of the type of a function."""
    for output in jacobians(function):
        yield f"    {output.name}_rows: NDArray[np.int32]"
        yield f"    {output.name}_columns: NDArray[np.int32]"
    target = f"{result} | Sequence[{_ARRAY}] | Mapping[str, {_ARRAY}] | None"
    joint = _method(function, "__call__", target, result)
    yield from [*joint[:-1], joint[-1].removesuffix(" ...")]
    yield from docstring(documentation(function, result), 2)
    yield from _method(function, "bind", target, f"Callable[[], {result}]")
    some = f"{_ARRAY} | Sequence[{_ARRAY}] | Mapping[str, {_ARRAY}] | None"
    yield from _method(function, "value", some, _arrays(values(function)))
    if jacobians(function):
        yield from _method(function, "jacobian", some, _arrays(jacobians(function)))
        yield from _method(function, "nonzeros", some, _arrays(jacobians(function)))
    if function.maximum is None:
        yield from _blocks(function)
    if function.single_difference:
        yield from _method(function, "single_difference", target, result, "reference: int")
        yield f"    def difference_matrix(self, count: int, reference: int) -> {_ARRAY}: ..."
        yield (
            "    def difference_covariance(self, sigma: ArrayLike, reference: int) "
            f"-> {_ARRAY}: ..."
        )


def _blocks(function: ir.Function) -> Iterator[str]:
    """Calls for epochs side by side."""
    yield "    lanes: int"
    yield f"    def to_lanes(self, rows: ArrayLike) -> {_ARRAY}: ..."
    target, extra = f"Blocks | Mapping[str, {_ARRAY}] | None", "epochs: int | None = None"
    yield f"    def from_lanes(self, blocked: ArrayLike, {extra}) -> {_ARRAY}: ..."
    yield from _method(function, "blocks", target, "Blocks", extra)
    yield from _method(function, "bind_blocks", target, "Callable[[], Blocks]", extra)


def _method(function: ir.Function, name: str, target: str, result: str, *extra: str) -> list[str]:
    names = [argument.name for argument in function.arguments]
    first = ["x: ArrayLike", "/"] if names[:1] == ["x"] else []
    inputs = [f"{name}: ArrayLike" for name in names if name != "x"]
    parameters = ["self", *first, "*", *inputs, *extra, f"out: {target} = None"]
    head = call(name, *parameters)
    return lay_out(head, before="def ", after=f" -> {result}: ...", depth=1)


def _arrays(outputs: Sequence[ir.Output]) -> str:
    if len(outputs) == 1:
        return _ARRAY
    return f"tuple[{', '.join([_ARRAY] * len(outputs))}]" if outputs else "tuple[()]"


def _state(module: ir.Module) -> Iterator[str]:
    """The types of the state object."""
    blocks = module.state.blocks
    yield from ["", "class StateBlocks(NamedTuple):"]
    yield from (f"    {block.name}: {_ARRAY}" for block in blocks)
    yield from ["", "class _Vector:"]
    yield from ["    size: int", "    names: tuple[str, ...]", "    labels: tuple[str, ...]"]
    yield from ["    units: Mapping[str, str]", "    frames: Mapping[str, str]"]
    yield "    slices: Mapping[str, slice]"
    yield from (f"    {block.name}: slice" for block in blocks)
    yield from ["", "class _State(_Vector):"]
    yield from ["    error: _Vector", "    error_size: int", "    digest: str"]
    yield from [f"    initial: {_ARRAY}", "    conventions: Mapping[str, str]"]
    parameters = [f"{block.name}: ArrayLike = ..." for block in blocks]
    pack = call("pack", "self", "*", *parameters)
    yield from lay_out(pack, before="def ", after=f" -> {_ARRAY}: ...", depth=1)
    yield "    def unpack(self, x: ArrayLike) -> StateBlocks: ..."
    for function in module.functions:
        if is_map(function):
            yield from _map(function)


def _map(function: ir.Function) -> list[str]:
    """Retract or local as methods of the state, both vectors by position."""
    first, second, *inputs = (f"{argument.name}: ArrayLike" for argument in function.arguments)
    head = call(function.name, "self", first, second, *(["*", *inputs] if inputs else []))
    return lay_out(head, before="def ", after=f" -> {_ARRAY}: ...", depth=1)
