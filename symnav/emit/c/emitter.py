"""From a module to the files of its C tree."""

from __future__ import annotations

import re
from collections import Counter
from collections.abc import Mapping, Sequence

from symnav import errors, ir
from symnav.emit.c.ahead import FETCH_AHEAD
from symnav.emit.c.arguments import with_free_names
from symnav.emit.c.blocks import Blocks
from symnav.emit.c.border import Border
from symnav.emit.c.comments import fitted
from symnav.emit.c.difference import Differenced
from symnav.emit.c.documentation import banner
from symnav.emit.c.entry_points import Single
from symnav.emit.c.header import Section, functions_header, types_header
from symnav.emit.c.items import ItemLoops
from symnav.emit.c.kernel import Kernel
from symnav.emit.c.mapped import Mapped
from symnav.emit.c.slots import refuse_slots_beyond
from symnav.emit.c.target import Target, target_of
from symnav.emit.c.trigonometry import trigonometry_header
from symnav.emit.templates import render

# The inline helpers of the check file and what each of them calls, callees in front of callers.
_HELPERS: Mapping[str, tuple[str, ...]] = {
    "first_failure": (),
    "both_failures": (),
    "first_of_both": (),
    "is_within": (),
    "magnitude_of": (),
    "is_centred": ("magnitude_of",),
    "are_two_within": ("is_within",),
    "are_three_within": ("is_within",),
    "are_four_within": ("is_within",),
    "are_two_centred": ("is_centred",),
    "are_three_centred": ("is_centred",),
    "are_four_centred": ("is_centred",),
    "is_equal": (),
    "is_outside": ("is_within",),
    "is_beyond": ("magnitude_of",),
    "guarded": (),
    "take_value": ("is_within",),
    "take_centred": ("is_beyond",),
    "read_value": ("is_within",),
    "read_centred": ("is_beyond",),
    "is_index_outside": (),
    "take_index": (),
    "is_near_quaternion": (),
    "is_near_matrix": (),
    "is_skewed_quaternion": (),
    "is_skewed_matrix": ("is_beyond",),
    "smaller_of": (),
    "larger_of": (),
    "fetch_ahead": (),
    "rows_to_lanes": ("fetch_ahead",),
    "lanes_to_rows": ("fetch_ahead",),
    "indices_to_lanes": (),
}


# Methods of evaluation under which a type has no excess precision; 16 is about half precision only.
_WIDER: Mapping[ir.Scalar, str] = {
    ir.Scalar.DOUBLE: "(FLT_EVAL_METHOD == 2)",
    ir.Scalar.FLOAT: "((FLT_EVAL_METHOD != 0) && (FLT_EVAL_METHOD != 16))",
}


def emit(module: ir.Module) -> dict[str, str]:
    """Render the C tree of a module.

    Args:
        module: functions of one scalar type.

    Returns:
        Text by path: two headers below ``c/include/<prefix>/``; the helpers, sine and cosine
        where they are wanted, and for every function its kernel and its entry points, below
        ``c/src/``.

    Raises:
        InputError: when two functions would share a symbol, a constant does not fit the type, or a
            slot reaches beyond what it addresses.
    """
    target = target_of(module)
    sources = _sources_of(module, target)
    kernels = [source.kernel for source in sources]
    described = [_section(source) for source in sources]
    _refuse_collisions(described)
    include, src = f"c/include/{target.prefix}", "c/src"
    files = {
        f"{include}/{target.prefix}_types.h": types_header(module, target),
        f"{include}/{target.prefix}.h": functions_header(module, target, described),
        f"{src}/{target.prefix}_check.h": _check_header(module, target, kernels),
    }
    if any(kernel.is_trigonometric for kernel in kernels):
        files[f"{src}/{target.prefix}_trigonometry.h"] = trigonometry_header(module, target)
    for source in sources:
        symbol, title = source.kernel.symbol, source.kernel.function.title
        files[f"{src}/{symbol}_kernel.h"] = _kernel_header(module, source.kernel)
        lead = banner(module, f"{symbol}.c", f"{title}: entry points.")
        files[f"{src}/{symbol}.c"] = source.source(lead)
        if source.kernel.function.checks_at_border:
            border = Border(source.kernel)
            lead = banner(module, f"{border.symbol}.c", f"{title}: check of the inputs.")
            files[f"{src}/{border.symbol}.c"] = border.source(lead)
    return {path: _finished(text, target) for path, text in files.items()}


def _finished(text: str, target: Target) -> str:
    """A file as it is written: lines that fit, and one end of line at its end."""
    return fitted(_with_own_flags(text, target)).rstrip("\n") + "\n"


def _with_own_flags(text: str, target: Target) -> str:
    """A file in which the type of flags has the name of its tree.

    Templates say ``flag_t``. Trees of two scalar types can be linked into one program, where a
    name must not stand for two types (MISRA C:2012, 5.6).
    """
    return re.sub(r"\bflag_t\b", f"{target.prefix}_flag_t", text)


def sections(module: ir.Module) -> tuple[Section, ...]:
    """Every function of a module with its entry points, in the order of the header."""
    return tuple(_section(source) for source in _sources_of(module, target_of(module)))


def _section(source: Single | Mapped | Differenced) -> Section:
    """A function with all its entry points."""
    kernel = source.kernel
    border = [Border(kernel).entry_point()] if kernel.function.checks_at_border else []
    return Section(kernel, [*source.entry_points(), *border])


def _sources_of(module: ir.Module, target: Target) -> list[Single | Mapped | Differenced]:
    for function in module.functions:
        refuse_slots_beyond(function)
    kernels = [
        Kernel(target, with_free_names(function), f"{target.prefix}_{function.name}")
        for function in module.functions
    ]
    return [_source_of(kernel, batches=module.batches) for kernel in kernels]


def _source_of(kernel: Kernel, *, batches: bool) -> Single | Mapped | Differenced:
    """What writes the source file of a function."""
    if not kernel.mapped:
        return Single(kernel, batches)
    mapped = Mapped(kernel, batches)
    return Differenced(mapped) if kernel.function.single_difference else mapped


def _kernel_header(module: ir.Module, kernel: Kernel) -> str:
    title = kernel.function.title
    return render(
        "c/kernel.h.j2",
        banner=banner(module, f"{kernel.symbol}_kernel.h", f"{title}: kernel."),
        target=kernel.target,
        symbol=kernel.symbol,
        structs=kernel.structs,
        routines=kernel.routines(),
        trigonometric=kernel.is_trigonometric,
    )


def _check_header(module: ir.Module, target: Target, kernels: Sequence[Kernel]) -> str:
    wanted = set().union(*(kernel.helpers() for kernel in kernels))
    border = [Border(kernel) for kernel in kernels if kernel.function.checks_at_border]
    wanted |= set().union(*(one.helpers() for one in border))
    wanted |= set().union(*(ItemLoops(kernel).helpers() for kernel in kernels if kernel.mapped))
    if module.batches:
        wanted.add(FETCH_AHEAD)
        wanted.update(*(Blocks(kernel).helpers() for kernel in kernels if not kernel.mapped))
    if any(
        kernel.function.single_difference and kernel.function.checks_domain for kernel in kernels
    ):
        wanted.add("take_value")
    for helper in reversed(tuple(_HELPERS)):
        if helper in wanted:
            wanted.update(_HELPERS[helper])
    brief = "Guards and helpers that the kernels share."
    double = target.scalar is ir.Scalar.DOUBLE
    return render(
        "c/check.h.j2",
        banner=banner(module, f"{target.prefix}_check.h", brief),
        target=target,
        helpers=[f"c/helpers/{helper}.j2" for helper in _HELPERS if helper in wanted],
        flag="uint64_t" if double else "uint32_t",
        digits="DBL_MANT_DIG" if double else "FLT_MANT_DIG",
        bits=53 if double else 24,
        sign=63 if double else 31,
        wider=_WIDER[target.scalar],
        zero=target.literal(0.0),
        half=target.literal(0.5),
        one=target.literal(1.0),
        fabs=target.function("fabs"),
    )


def _refuse_collisions(described: Sequence[Section]) -> None:
    """Two entry points of one name would be one function to the linker."""
    counter = Counter(entry.symbol for section in described for entry in section.entries)
    repeated = sorted(symbol for symbol, count in counter.items() if count > 1)
    if repeated:
        raise errors.InputError(
            f"two functions would both define {', '.join(repeated)} in C; rename one of them"
        )
