"""From a module to the Python files of its package, the NumPy kernels aside."""

from __future__ import annotations

from collections.abc import Sequence

from symnav import ir
from symnav.emit.python.compiled import casadi, native
from symnav.emit.python.interface import interface
from symnav.emit.python.names import result_names
from symnav.emit.python.shapes import entries
from symnav.emit.python.straight import sources
from symnav.emit.python.stubs import backend_stub, stub
from symnav.emit.templates import plain, render

_STATIC = (
    "_arrays.py",
    "_batches.py",
    "_blocks.py",
    "_calls.py",
    "_compiled.py",
    "_explain.py",
    "_extension.py",
    "_foreign.py",
    "_kernels.py",
    "_lanes.py",
    "_masked.py",
    "_numbers.py",
    "_places.py",
    "_runtime.py",
    "_state.py",
    "_straight.py",
    "_tables.py",
)


def emit(module: ir.Module, single: ir.Module | None = None) -> dict[str, str]:
    """Render the package.

    Args:
        module: the functions in double precision.
        single: those that exist in single precision as well, when any do.

    Returns:
        Every Python file but ``numpy.py``, the stubs of all of them, and the C through which
        Python's arrays reach the exported C.
    """
    files = {name: plain(f"package/{name}") for name in _STATIC}
    files["native.py"] = native(module)
    files["native.pyi"] = backend_stub(module.functions, threaded=True)
    files |= sources(module)
    files["casadi.py"] = casadi(module)
    files["casadi.pyi"] = backend_stub(entries(module))
    if single is not None:
        files["native_f32.py"] = native(single)
        files |= sources(single)
        files["native_f32.pyi"] = stub(single, (), threaded=True)
    backends = ["casadi", "native", *(["native_f32"] if single is not None else []), "numpy"]
    files["__init__.py"] = _package(module, backends)
    files["__init__.pyi"] = stub(module, backends)
    files["_interface.py"] = interface(module)
    files["numpy.pyi"] = backend_stub(module.functions)
    files["py.typed"] = ""
    return files


def _rank(name: str) -> tuple[int, str]:
    """Constants, then classes, then functions."""
    return (0 if name.isupper() else 1 if name[0].isupper() else 2), name


def _package(module: ir.Module, backends: Sequence[str]) -> str:
    functions = [function.name for function in module.functions]
    stateful = bool(module.state.blocks)
    single = any(function.maximum is None for function in module.functions)
    results = list(result_names(module.functions).values()) + ["StateBlocks"] * stateful
    own = ["BACKEND", "GuardError", "Status", *["State"] * stateful, *["Blocks"] * single]
    return render(
        "package/__init__.py.j2",
        name=module.name,
        functions=functions,
        results=sorted(results),
        backends=backends,
        single=single,
        stateful=stateful,
        exported=sorted([*own, *functions, *results], key=_rank),
    )
