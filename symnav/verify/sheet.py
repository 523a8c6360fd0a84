"""The proof sheet: worst error per output block, what it is measured against, and the verdict."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import dataclass, field
from typing import TYPE_CHECKING, Any

if TYPE_CHECKING:
    from rich.console import Console

#: Comparisons of the differenced form with what it is made of, by back end.
DIFFERENCED: Mapping[str, str] = {
    backend: f"{backend} difference vs rows" for backend in ("native", "numpy")
}

#: Limits of the columns, relative to the scale of an error (``scale.py``).
LIMITS: Mapping[str, float] = {
    "native vs numpy": 8 * 2.0**-52,
    "native vs 50 digits": 1e-13,
    "numpy vs 50 digits": 1e-13,
    "casadi vs 50 digits": 1e-13,
    "native vs differences": 1e-12,
    "numpy vs differences": 1e-12,
    "casadi vs differences": 1e-12,
    "float vs 50 digits": 64 * 2.0**-23,
    "float vs differences": 64 * 2.0**-23,
    "numpy vs reference": 1e-13,
    **dict.fromkeys(DIFFERENCED.values(), 2.0**-52),
    "native retract then local": 1e-13,
    "numpy retract then local": 1e-13,
    "native retract vs 50 digits": 1e-13,
}


def roundings(comparison: str) -> float:
    """What a comparison may be off at the full scale (``scale.py``), where the strict one vanishes.

    Eight units in the last place of the type; sixty-four for CasADi's C, whose automatic
    differentiation has intermediate terms of its own.
    """
    if comparison.startswith("float"):
        return LIMITS[comparison]
    return (64 if comparison.startswith("casadi") else 8) * 2.0**-52


def underflow(comparison: str) -> float:
    """What a comparison may be off in absolute terms, where numbers are too small for the type.

    Eight of the smallest numbers the type has: a product below them is rounded to one or to zero.
    """
    return 8 * (2.0**-149 if comparison.startswith("float") else 2.0**-1074)


@dataclass(frozen=True)
class Row:
    """One comparison of one block of one output.

    Attributes:
        function: name of the generated function.
        block: output, and for Jacobians the state block or input of the columns.
        comparison: key of ``LIMITS``.
        relative: worst error over its scale.
        absolute: worst error in the block's unit.
        unit: that unit.
        samples: how many values were compared.
        reproduction: arguments of the worst sample as Python source.
    """

    function: str
    block: str
    comparison: str
    relative: float
    absolute: float
    unit: str
    samples: int
    reproduction: str

    @property
    def limit(self) -> float:
        """Largest relative error allowed."""
        return LIMITS[self.comparison]

    @property
    def passed(self) -> bool:
        """True when the error is inside the limit (and not NaN) and something was compared."""
        return self.samples > 0 and self.relative <= self.limit

    @property
    def ulp(self) -> float:
        """The relative error in units of the last place of a double at the scale."""
        return self.relative / 2.0**-52


@dataclass(frozen=True)
class Finding:
    """A failed check that is not a number, such as a status that differs between back ends."""

    function: str
    message: str


@dataclass(frozen=True)
class ProofSheet:
    """Everything a verification compared.

    Attributes:
        spec: name of the specification.
        rows: comparisons.
        findings: failures that are not numbers.
        notes: what was not compared, and why.
        samples: samples per function, those of single edges not counted.
        seed: of the samples.
        judged: how many states of each function were judged with fifty digits.
    """

    spec: str
    rows: tuple[Row, ...]
    findings: tuple[Finding, ...]
    notes: tuple[str, ...]
    samples: int
    seed: int
    judged: Mapping[str, int] = field(default_factory=dict)

    @property
    def passed(self) -> bool:
        """True when every row passed and nothing was found."""
        return bool(self.rows) and not self.findings and all(row.passed for row in self.rows)

    def failures(self) -> tuple[str, ...]:
        """One paragraph per failure, each with a reproduction to paste."""
        texts = [f"{finding.function}: {finding.message}" for finding in self.findings]
        for row in self.rows:
            if not row.passed:
                texts.append(
                    f"{row.function} {row.block}, {row.comparison}: {row.relative:.2e} of the "
                    f"scale ({row.absolute:.2e} {row.unit}); the limit is {row.limit:.1e}\n"
                    f"{row.reproduction}"
                )
        return tuple(texts)

    def as_dict(self) -> dict[str, Any]:
        """For ``--json``."""
        return {
            "spec": self.spec,
            "passed": self.passed,
            "samples": self.samples,
            "seed": self.seed,
            "judged": dict(self.judged),
            "rows": [
                {
                    "function": row.function,
                    "block": row.block,
                    "comparison": row.comparison,
                    "relative": row.relative,
                    "ulp": row.ulp,
                    "absolute": row.absolute,
                    "unit": row.unit,
                    "limit": row.limit,
                    "samples": row.samples,
                    "passed": row.passed,
                }
                for row in self.rows
            ],
            "failures": list(self.failures()),
            "notes": list(self.notes),
        }

    def render(self, console: Console) -> None:
        """Print the sheet: one line per block, one column per kind of comparison."""
        from rich import box
        from rich.table import Table

        verdict = "PASS" if self.passed else "FAIL"
        table = Table(
            title=f"Proof sheet of {self.spec}: {verdict}", title_justify="left",
            box=box.SIMPLE_HEAD, pad_edge=False, padding=(0, 1),
        )  # fmt: skip
        for title in ("function", "block"):
            table.add_column(title, overflow="fold")
        for title in ("C-NumPy", "C", "NumPy", "CasADi", "float32", "book", "worst"):
            table.add_column(title, justify="right", no_wrap=True)
        for (function, block), rows in self._grouped().items():
            table.add_row(*_line(function, block, rows))
        console.print(table)
        console.print(
            "C-NumPy: in units of the last place. Others: error over its scale, |h| + sum "
            "|dh/dx||x|, against 50-digit values and, for Jacobians, 50-digit differences through "
            "the retract; where that scale vanishes, over the rounding of the intermediate terms. "
            "book: against the references given.",
            highlight=False,
        )
        if self.judged:
            counts = ", ".join(f"{name} {count}" for name, count in self.judged.items())
            console.print(
                f"States judged with 50 digits, every edge inside the ranges among them: {counts}.",
                highlight=False,
                markup=False,
            )
        differenced = [row for row in self.rows if row.comparison in DIFFERENCED.values()]
        if differenced:
            names = ", ".join(dict.fromkeys(row.function for row in differenced))
            worst = max(row.ulp for row in differenced)
            console.print(
                f"Single differences of C and NumPy, against differences of rows: {names}; "
                f"{worst:.2f} units in the last place at most.",
                highlight=False,
                markup=False,
            )
        for note in self.notes:
            console.print(f"note: {note}", highlight=False, markup=False)
        for failure in self.failures():
            console.print(f"FAIL {failure}", highlight=False, markup=False)

    def _grouped(self) -> dict[tuple[str, str], dict[str, Row]]:
        groups: dict[tuple[str, str], dict[str, Row]] = {}
        for row in self.rows:
            groups.setdefault((row.function, row.block), {})[row.comparison] = row
        return groups


def _line(function: str, block: str, rows: Mapping[str, Row]) -> Sequence[str]:
    def cell(*names: str) -> str:
        """The worst of several comparisons; an exclamation mark where one failed."""
        found = [rows[name] for name in names if name in rows]
        if not found:
            return ""
        worst = max(row.relative for row in found)
        return f"{worst:.1e}" + ("" if all(row.passed for row in found) else " !")

    agreement = rows.get("native vs numpy")
    worst = max(rows.values(), key=lambda row: row.relative / row.limit)
    return (
        function,
        block,
        "" if agreement is None else f"{agreement.ulp:.2f}" + ("" if agreement.passed else " !"),
        cell("native vs 50 digits", "native vs differences", "native retract vs 50 digits",
             "native retract then local"),
        cell("numpy vs 50 digits", "numpy vs differences", "numpy retract then local"),
        cell("casadi vs 50 digits", "casadi vs differences"),
        cell("float vs 50 digits", "float vs differences"),
        cell("numpy vs reference"),
        f"{worst.absolute:.1e} {worst.unit}",
    )  # fmt: skip
