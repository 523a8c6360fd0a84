"""SymForce: its geometry, its derivatives in the tangent space, its C++."""

from __future__ import annotations

from collections.abc import Iterator
from pathlib import Path
from typing import Any

from benchmarks.contestants.contestant import Contestant, natural, symbol_of
from benchmarks.problems import Functions, Problem
from symnav.bench.candidate import Candidate

EIGEN = Path("/usr/include/eigen3")


def contestants(problem: Problem, folder: Path) -> Iterator[Contestant]:
    """One contestant, where SymForce is installed and Eigen is there."""
    try:
        import symforce
    except ImportError:
        return
    if not EIGEN.is_dir():
        return
    symforce.logger.setLevel("ERROR")
    symforce.set_epsilon_to_zero()
    yield _contestant(problem, folder / "symforce")


def _contestant(problem: Problem, folder: Path) -> Contestant:
    import symforce.symbolic as sf
    from symforce import codegen, values

    sizes = {name: size for name, size in problem.sizes.items() if size}
    given = values.Values(**{n: sf.Matrix(s, 1).symbolic(n) for n, s in sizes.items()})
    value, nonzeros = _derived(problem, given)
    outputs = values.Values(value=sf.Matrix(value), nz=sf.Matrix(nonzeros))
    name = f"{problem.name}_symforce"
    data = codegen.Codegen(
        inputs=given, outputs=outputs, config=codegen.CppConfig(), name=name
    ).generate_function(output_dir=folder, skip_directory_nesting=True)
    header = Path(data.generated_files[0])
    arguments = [
        f"*reinterpret_cast<const Eigen::Matrix<double, {size}, 1> *>(in + {problem.offsets[n]})"
        for n, size in sizes.items()
    ]
    outputs_ = [
        f"reinterpret_cast<Eigen::Matrix<double, {len(value)}, 1> *>(out)",
        f"reinterpret_cast<Eigen::Matrix<double, {len(nonzeros)}, 1> *>(out + {len(value)})",
    ]
    function = "".join(part.capitalize() for part in name.split("_"))
    call = ",\n        ".join([*arguments, *outputs_])
    symbol = symbol_of(problem, "symforce")
    source = (
        f'#include "{header.name}"\n\n'
        f'extern "C" void {symbol}(const double *in, double *out)\n'
        f"{{\n    sym::{function}<double>({call});\n}}\n"
    )
    order = natural(problem)
    candidate = Candidate(
        name="symforce", symbol=symbol, source=source, size=len(order), language="c++",
        include=(header.parent, EIGEN),
    )  # fmt: skip
    text = header.read_text(encoding="utf-8")
    return Contestant(
        problem=problem, candidate=candidate, order=order, text=text, functions=(function,)
    )


def _derived(problem: Problem, given: Any) -> tuple[list[Any], list[Any]]:
    """Values and non-zeros, the quaternion's columns from SymForce's own tangent space."""
    import symforce.symbolic as sf

    parts = {name: list(given[name]) for name in given}
    functions = Functions(sf.sqrt, sf.sin, sf.cos)
    value = sf.Matrix(problem.equation(parts, functions))
    w, x, y, z = parts["q"]
    rotation = sf.Rot3(sf.Quaternion(xyz=sf.V3(x, y, z), w=w))
    blocks = []
    for name, _size in problem.state:
        block = rotation if name == "q" else sf.Matrix(parts[name])
        blocks.append(value.jacobian(block))
    slopes = [[entry for block in blocks for entry in block[row, :]] for row in range(len(value))]
    return list(value), [slopes[row][column] for row, column in problem.pattern]
