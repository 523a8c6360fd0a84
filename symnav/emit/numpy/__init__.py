"""The NumPy back end: ``numpy.py``, kernels over any library that follows the array API."""

from __future__ import annotations

import re

from symnav import ir
from symnav.emit.numpy.kernel import kernel_of
from symnav.emit.templates import render


def emit(module: ir.Module) -> dict[str, str]:
    """Render the back end.

    Args:
        module: lowered by either route.

    Returns:
        ``numpy.py``; it imports the files that ``symnav.emit.python`` renders.
    """
    kernels = [kernel_of(function) for function in module.functions]
    lines = [line for kernel in kernels for line in kernel.body]
    text = render(
        "numpy/numpy.py.j2",
        name=module.name,
        kernels=kernels,
        infinite=any(re.search(r"\b_inf\b", line) for line in lines),
        checked=any("_runtime." in line for line in lines),
    )
    return {"numpy.py": text}
