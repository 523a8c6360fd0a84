"""Identifiers: which names a user may give, which the generated code keeps, and macro names.

A name ends up in C, in C++ (headers are included there), in Python and in documentation, so it
must be an identifier everywhere, must not depend on case, and must not be a name that the
generated code itself gives. Every function that refuses a name says why.
"""

from __future__ import annotations

import keyword
import re
from collections.abc import Iterable, Mapping
from enum import StrEnum


def words(text: str) -> frozenset[str]:
    """The words of a text."""
    return frozenset(text.split())


#: C99 promises 31 significant characters; the rest of a symbol is the prefix and the function.
LONGEST = 31

C_KEYWORDS = words(
    """
    auto break case char const continue default do double else enum extern float for goto if
    inline int long register restrict return short signed sizeof static struct switch typedef
    union unsigned void volatile while alignas alignof bool constexpr false nullptr static_assert
    thread_local true typeof typeof_unqual asm fortran
    """
)

CPP_KEYWORDS = words(
    """
    and and_eq bitand bitor catch char16_t char32_t char8_t class co_await co_return co_yield compl
    concept const_cast consteval constinit decltype delete dynamic_cast explicit export friend
    mutable namespace new noexcept not not_eq operator or or_eq private protected public
    reinterpret_cast requires static_cast template this throw try typeid typename using virtual
    wchar_t xor xor_eq
    """
)

PYTHON_KEYWORDS = frozenset(keyword.kwlist)

_MATH_FUNCTIONS = words(
    """
    acos acosh asin asinh atan atan2 atanh cbrt ceil copysign cos cosh erf erfc exp exp2 expm1 fabs
    fdim floor fma fmax fmin fmod frexp hypot ilogb ldexp lgamma llrint llround log log10 log1p
    log2 logb lrint lround modf nan nearbyint nextafter nexttoward pow remainder remquo rint round
    scalbln scalbn sin sinh sqrt tan tanh tgamma trunc
    j0 j1 jn y0 y1 yn gamma drem significand scalb finite isinf isnan
    """
)

#: Functions and macros of math.h, with the historical ones that compilers still declare.
MATH_NAMES = frozenset(
    f"{name}{suffix}" for name in _MATH_FUNCTIONS for suffix in ("", "f", "l")
) | words(
    """
    signgam fpclassify isfinite isnormal signbit isgreater isgreaterequal isless islessequal
    islessgreater isunordered HUGE_VAL HUGE_VALF HUGE_VALL INFINITY NAN float_t double_t
    FP_NAN FP_INFINITE FP_NORMAL FP_SUBNORMAL FP_ZERO FP_ILOGB0 FP_ILOGBNAN MAXFLOAT
    math_errhandling MATH_ERRNO MATH_ERREXCEPT
    M_E M_LOG2E M_LOG10E M_LN2 M_LN10 M_PI M_PI_2 M_PI_4 M_1_PI M_2_PI M_2_SQRTPI M_SQRT2 M_SQRT1_2
    """
)

#: Macros and names that headers or compilers put in every C file.
C_MACROS = words("NULL EOF errno assert offsetof complex imaginary I linux unix noreturn abs div")

_WIDTHS = ("8", "16", "32", "64", "_LEAST8", "_LEAST16", "_LEAST32", "_LEAST64", "_FAST8",
           "_FAST16", "_FAST32", "_FAST64", "MAX", "PTR")  # fmt: skip

#: Types and limits of stdint.h, stddef.h and float.h. Generated C or Python.h includes them, so
#: inside the C a user's name that is one of them becomes another.
STANDARD_NAMES = frozenset(
    name
    for width in _WIDTHS
    for sign in ("", "u")
    for name in (
        f"{sign}int{width}_t".lower(),
        *(f"{sign}INT{width}_{end}".upper() for end in ("MAX", "MIN", "WIDTH")),
    )
) | words(
    """
    size_t ptrdiff_t max_align_t SIZE_MAX PTRDIFF_MAX PTRDIFF_MIN WCHAR_MAX WCHAR_MIN WINT_MAX
    WINT_MIN SIG_ATOMIC_MAX SIG_ATOMIC_MIN FLT_RADIX FLT_ROUNDS FLT_EVAL_METHOD DECIMAL_DIG
    """
) | frozenset(
    f"{kind}_{limit}"
    for kind in ("FLT", "DBL", "LDBL")
    for limit in (
        "MAX", "MIN", "EPSILON", "DIG", "MANT_DIG", "MAX_EXP", "MIN_EXP", "MAX_10_EXP",
        "MIN_10_EXP", "TRUE_MIN", "DECIMAL_DIG", "HAS_SUBNORM",
    )
)  # fmt: skip

#: Helpers and types that the files of the generated C share; likewise.
HELPER_NAMES = words(
    """
    are_four_centred are_four_within are_three_centred are_three_within are_two_centred
    are_two_within both_failures cosine_of fetch_ahead first_failure first_of_both flag_t guarded
    indices_to_lanes is_beyond is_centred is_equal is_index_outside is_near_matrix
    is_near_quaternion is_outside is_skewed_matrix is_skewed_quaternion is_within lanes_to_rows
    larger_of magnitude_of near_cosine near_sine nearest_multiple read_centred read_value
    rows_to_lanes sine_of smaller_of take_centred take_index take_value turn_of
    """
)

#: Arguments and outputs of generated functions.
ARGUMENT_NAMES = words(
    """
    x d y n out value jacobian residual status item_status epochs nonzeros
    guards self np xp
    """
)

#: Attributes of the generated ``State``.
STATE_ATTRIBUTES = words(
    """
    size error_size names error units frames labels pack unpack retract local digest initial count
    index slices conventions
    """
)

#: Modules, classes, files and enumerations of a generated package.
FUNCTION_NAMES = words(
    """
    State StateBlocks Blocks BACKEND GuardError Status set_threads numpy native native_f32 casadi c
    retract local types check state status real version manifest
    bits_t flag_t real_t status_t turn_t
    """
)

#: What the Python files and stubs of a package themselves call by name, beside functions.
PYTHON_NAMES = words(
    """
    len int float str slice tuple Any ArrayLike Callable Mapping NamedTuple NDArray Protocol
    Sequence TypeAlias np
    """
)

#: What CasADi's generator adds to the C of every package, beside numbered helpers.
CASADI_NAMES = words("sq sign casadi_version casadi_int_size casadi_real_size")
_CASADI_NUMBERED = re.compile(r"[cfs]\d+", re.IGNORECASE)

#: Packages whose names are those of headers of the system, Python or NumPy: R_OK, npy_intp ...
_SYSTEM_PACKAGES = words("f r w x")
_SYSTEM_CAPITALS = re.compile(r"(Py|Npy)[A-Z]")
_SYSTEM_PREFIXES = ("have_", "npy_", "py_", "pyctype_", "pymacconfig_")

#: Suffixes of the entry points made from one function, the last ones by CasADi's generator.
FUNCTION_SUFFIXES = (
    "value", "jacobian", "nz", "batch", "batch_nz", "blocks", "lanes", "sd", "difference_matrix",
    "difference_covariance", "kernel", "jacobian_rows", "jacobian_columns",
    "alloc_mem", "init_mem", "free_mem", "checkout", "release", "incref", "decref", "n_in",
    "n_out", "name_in", "name_out", "default_in", "sparsity_in", "sparsity_out", "work",
    "work_bytes",
)  # fmt: skip

#: Words of the specification that stand where a name could stand.
BINDING_WORDS = frozenset({"input", "none"})

#: Names that no definition inside a generated function may take.
RESERVED = (
    C_KEYWORDS
    | CPP_KEYWORDS
    | PYTHON_KEYWORDS
    | MATH_NAMES
    | C_MACROS
    | ARGUMENT_NAMES
    | frozenset({"bad", "ok"})
)

_IDENTIFIER = re.compile(r"[A-Za-z][A-Za-z0-9_]*")


class Use(StrEnum):
    """What a name is given to; decides which generated names it must keep clear of."""

    PACKAGE = "package"
    STATE = "state block"
    INPUT = "input"
    FUNCTION = "measurement or correction"
    TERM = "term"
    FRAME = "frame"
    SYSTEM = "satellite system"


_GENERATED: Mapping[Use, frozenset[str]] = {
    Use.PACKAGE: frozenset({"symnav", "numpy", "casadi", "cffi", "generated"}),
    Use.STATE: ARGUMENT_NAMES | STATE_ATTRIBUTES,
    Use.INPUT: ARGUMENT_NAMES,
    Use.FUNCTION: FUNCTION_NAMES,
    Use.TERM: ARGUMENT_NAMES,
    Use.FRAME: frozenset(),
    Use.SYSTEM: frozenset(),
}


def fault(name: str, use: Use) -> str | None:
    """Why a name cannot be given, or None when it can."""
    return _shape_fault(name) or (None if use is Use.FRAME else _word_fault(name, use))


def _shape_fault(name: str) -> str | None:
    if name.startswith("_"):
        return f"{name!r} starts with an underscore, which C and Python keep for themselves"
    if not _IDENTIFIER.fullmatch(name):
        return (
            f"{name!r} is not an identifier; use letters, digits and underscores, "
            "starting with a letter"
        )
    if "__" in name:
        return f"{name!r} has a double underscore, which C++ keeps for itself"
    if name.endswith("_"):
        return f"{name!r} ends with an underscore, which generated names use"
    if len(name) > LONGEST:
        return f"{name!r} has {len(name)} characters; {LONGEST} are allowed"
    return None


def _word_fault(name: str, use: Use) -> str | None:
    for words, what in (
        (C_KEYWORDS, "a keyword of C"),
        (CPP_KEYWORDS, "a keyword of C++"),
        (PYTHON_KEYWORDS, "a keyword of Python"),
        (MATH_NAMES, "declared by math.h"),
        (C_MACROS, "a name of the C library or a compiler"),
        (BINDING_WORDS, "a word of the specification"),
    ):
        if name in words:
            return f"{name!r} is {what}; choose another name"
    folded = {word.lower() for word in _GENERATED[use]}
    if name.lower() in folded or (use is Use.INPUT and name.startswith("jacobian_")):
        return f"{name!r} is a name that the generated code gives itself; choose another name"
    if use is Use.FUNCTION:
        return _function_fault(name)
    return _package_fault(name) if use is Use.PACKAGE else None


def _function_fault(name: str) -> str | None:
    if f"{name}_".lower().startswith("f32_"):
        return f"{name!r} leads the names of the single-precision C; choose another name"
    if name in PYTHON_NAMES:
        return f"{name!r} is a name that the generated Python calls; choose another name"
    if name.lower() in CASADI_NAMES or _CASADI_NUMBERED.fullmatch(name):
        return f"{name!r} is a name of CasADi's helpers in the generated C; choose another name"
    return None


def _package_fault(name: str) -> str | None:
    """Why the names that a package's name leads would be those of other headers."""
    if name.lower() in _SYSTEM_PACKAGES:
        return f"{name!r} gives {macro(name, 'ok')}, a macro of unistd.h; choose another name"
    if f"{name}_".lower().startswith(_SYSTEM_PREFIXES) or _SYSTEM_CAPITALS.match(name):
        return f"{name!r} leads names of the headers of Python and NumPy; choose another name"
    if name.isupper():
        return f"{name!r} is upper case, which C keeps for macros; use lower case"
    return None


def clash(name: str, taken: Iterable[str]) -> str | None:
    """The name already taken that differs from this one in nothing or only in case."""
    return next((other for other in taken if other.lower() == name.lower()), None)


def entry_point_clash(name: str, functions: Iterable[str]) -> str | None:
    """The function whose entry points would include this name, if any."""
    for other in functions:
        if name != other and name.lower() in {f"{other}_{s}".lower() for s in FUNCTION_SUFFIXES}:
            return other
    return None


def step_clash(name: str, arguments: Iterable[str]) -> str | None:
    """The argument whose batch step would have this name, if any."""
    return next((other for other in arguments if name == f"{other}_step"), None)


def symbol(prefix: str, *parts: str) -> str:
    """A C symbol: ``rover_gps_value``."""
    return "_".join([prefix, *parts])


def macro(prefix: str, *parts: str) -> str:
    """A C macro or enumerator: ``ROVER_GPS_MAX_ITEMS``."""
    return symbol(prefix, *parts).upper()
