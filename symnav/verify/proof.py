"""Compare every back end of a generated package with the witnesses, over samples and edges.

Input: the spec, its derivations and the imported package. Output: a ``ProofSheet``.
"""

from __future__ import annotations

import importlib
from collections.abc import Callable, Iterator, Mapping, Sequence
from dataclasses import dataclass, field
from typing import Any

import numpy as np
from mpmath import mp
from numpy.typing import NDArray

from symnav import ir
from symnav.binding import STATE
from symnav.derive import Derivation, DerivedOutput
from symnav.spec.records import Spec
from symnav.verify.comparison import Array, Indices, Worst, differences, forget_remainders
from symnav.verify.differencing import differenced
from symnav.verify.exact import DIGITS, Exact
from symnav.verify.manifold import prove_layout
from symnav.verify.references import References, quantities
from symnav.verify.sampling import Samples, draw
from symnav.verify.scale import ScaleOf, Scales
from symnav.verify.sheet import DIFFERENCED, LIMITS, Finding, ProofSheet, Row, roundings, underflow

#: What references call the outputs that have another name here.
_REFERENCE_NAMES = {"value_covariance": "covariance", "jacobian_fix": "noise_map"}
BACKENDS = ("native", "numpy", "casadi")


@dataclass
class _FunctionProof:
    """Comparisons of one function, and how many of its samples were judged with fifty digits."""

    spec: Spec
    derivation: Derivation
    samples: Samples
    worst: dict[tuple[str, str], Worst] = field(default_factory=dict)
    judged: int = 0
    notes: list[str] = field(default_factory=list)

    def compare(
        self,
        output: DerivedOutput,
        comparison: str,
        a: Array,
        b: Array,
        scales: Scales,
        rows: Indices,
    ) -> None:
        """Record |a - b| of one output at the scale of what it is compared by."""
        scale = scales.limited(LIMITS[comparison], roundings(comparison), underflow(comparison))
        if comparison.startswith("casadi"):
            # Automatic differentiation cancels terms of its own, as large as its largest result.
            scale = np.broadcast_to(
                scale.max(axis=tuple(range(1, scale.ndim)), keepdims=True), scale.shape
            )
        with np.errstate(all="ignore"):
            error = np.abs(a - b)
        self.record(output, comparison, error, scale, rows)

    def record(
        self, output: DerivedOutput, comparison: str, error: Array, scale: Array, rows: Indices
    ) -> None:
        """Take in the errors of one output at their scale, block by block of its columns."""
        for block, columns, unit in self._blocks(output):
            worst = self.worst.setdefault((block, comparison), Worst(unit))
            worst.add(error[..., columns], scale[..., columns], rows)

    def rows(self) -> Iterator[Row]:
        """The comparisons as rows of the sheet."""
        for (block, comparison), worst in self.worst.items():
            yield Row(
                self.derivation.name, block, comparison, worst.relative, worst.absolute,
                worst.unit, worst.samples, self._reproduction(worst.index),
            )  # fmt: skip

    def _blocks(self, output: DerivedOutput) -> list[tuple[str, slice, str]]:
        """Column ranges of a Jacobian by state block; a value is one block."""
        if output.kind != "jacobian":
            return [(output.name, slice(None), output.unit)]
        if output.by:
            return [(f"d/d {output.by}", slice(None), "")]
        touched = {column for _, column in output.entries}
        blocks = []
        for place in self.spec.layout.places.values():
            columns = range(place.error.start, place.error.stop)
            if touched.intersection(columns) or output.slots:
                blocks.append((f"d/d {place.block.name}", place.error, ""))
        zero = [c for c in range(output.columns) if c not in touched]
        if zero and not output.slots:
            blocks.append(("d/d (zero columns)", np.array(zero), ""))  # type: ignore[arg-type]
        return blocks

    def _reproduction(self, index: int) -> str:
        flat = self.samples.flat()
        if index < 0:
            return ""
        arguments = ", ".join(f"{name}={a[index].tolist()!r}" for name, a in flat.items())
        return f"  {self.derivation.name}({arguments})"


def prove(
    spec: Spec,
    derivations: Sequence[Derivation],
    layout_functions: Sequence[Derivation],
    package: Any,
    *,
    samples: int,
    seed: int,
    reference: References | None = None,
    progress: Callable[[str], None] = lambda _stage: None,
) -> ProofSheet:
    """Run every comparison.

    Args:
        spec: the specification.
        derivations: one per entry.
        layout_functions: retract and local, or none where there is no state.
        package: the imported generated package.
        samples: per function; those of single edges come on top.
        seed: of the samples.
        reference: evaluates a model written from the book, if given.
        progress: told the name of each function.
    """
    rows: list[Row] = []
    findings: list[Finding] = []
    notes: list[str] = []
    judged: dict[str, int] = {}
    backends = {}
    for name in (*BACKENDS, "native_f32"):
        module = _backend(package, name)
        if module is None:
            if name != "native_f32" or "float" in spec.scalars:
                notes.append(f"back end {name} was not available; nothing was compared with it")
        else:
            backends[name] = module
    for derivation in derivations:
        progress(derivation.name)
        drawn = draw(spec, derivation, samples, seed)
        proof = _FunctionProof(spec, derivation, drawn)
        findings += _prove_function(proof, backends, reference)
        rows += proof.rows()
        notes += proof.notes
        judged[derivation.name] = proof.judged
    if layout_functions:
        progress("retract and local")
        rows += prove_layout(spec, layout_functions, backends, samples, seed)
    return ProofSheet(spec.name, tuple(rows), tuple(findings), tuple(notes), samples, seed, judged)


def _backend(package: Any, name: str) -> Any:
    try:
        return importlib.import_module(f"{package.__name__}.{name}")
    except ImportError:
        return None


def _prove_function(
    proof: _FunctionProof, backends: Mapping[str, Any], reference: References | None
) -> list[Finding]:
    derivation = proof.derivation
    flat = proof.samples.flat()
    results = {
        name: _evaluate(getattr(module, derivation.name), proof.samples, derivation)
        for name, module in backends.items()
        if hasattr(module, derivation.name)
    }
    findings = _statuses(derivation, results)
    good, wanting = _domain(proof, results["numpy"].ok)
    findings += wanting
    if not good.size:
        return findings
    scales = ScaleOf(derivation).outputs({name: a[good] for name, a in flat.items()})
    for output in derivation.outputs:
        if "native" in results:
            a, b = results["native"].get(output, good), results["numpy"].get(output, good)
            proof.compare(output, "native vs numpy", a, b, scales[output.name], good)
    findings += _compare_differences(proof, backends, good)
    few = proof.samples.judged(good)
    proof.judged = len(few)
    _compare_exact(proof, results, scales, good, few)
    if reference is not None and derivation.entry is not None:
        if not reference.has(derivation.entry.model.name):
            proof.notes.append(f"{derivation.name}: no reference for {derivation.entry.model.name}")
        _compare_reference(proof, reference, results["numpy"], scales, good, few)
    return findings


def _compare_differences(
    proof: _FunctionProof, backends: Mapping[str, Any], good: Indices
) -> list[Finding]:
    """Single differences, where the entry asks for them."""
    derivation, samples = proof.derivation, proof.samples
    findings: list[Finding] = []
    if derivation.entry is None or not derivation.entry.single_difference:
        return findings
    per_item = [name for name, array in samples.arguments.items() if array.ndim == 3]
    inside = np.zeros((samples.count, samples.items or 1), dtype=np.bool_)
    inside.ravel()[good] = True
    for name in DIFFERENCED:
        if name in backends:
            function = getattr(backends[name], derivation.name)
            found = differenced(derivation, name, function, _given(samples), per_item, inside)
            for one in found:
                if isinstance(one, Finding):
                    findings.append(one)
                else:
                    proof.record(one.output, one.comparison, one.error, one.scale, one.rows)
    return findings


def _domain(proof: _FunctionProof, ok: NDArray[np.bool_]) -> tuple[Indices, list[Finding]]:
    """The rows that can be compared, and whether they are too few.

    Without guards the code has no verdict: the terms that they would watch are evaluated here.
    """
    derivation = proof.derivation
    if derivation.entry is not None and derivation.entry.guards == "assume":
        inside = ScaleOf(derivation).inside(proof.samples.flat())
        if not inside.all():
            proof.notes.append(
                f"{derivation.name} leaves its guards out: of {ok.size} states inside the declared "
                f"ranges {np.count_nonzero(~inside)} are outside the domain of the equation, where "
                "nothing is proven; its caller has to keep away from them"
            )
        ok = ok & inside
    good = np.flatnonzero(ok)
    if not good.size:
        message = (
            f"no state inside the declared ranges could be evaluated: all {ok.size} of them are "
            "outside the domain of the equation; change the ranges or the equation"
        )
        return good, [Finding(derivation.name, message)]
    if good.size < max(4, ok.size // 4):
        message = f"only {good.size} of {ok.size} samples are inside the domain"
        return good, [Finding(derivation.name, message)]
    return good, []


@dataclass
class _Evaluated:
    """Outputs of one back end, flattened to one row per sample and item."""

    outputs: Mapping[str, Array]
    ok: NDArray[np.bool_]
    status: NDArray[np.int64]
    whole: NDArray[np.int64]

    def get(self, output: DerivedOutput, rows: Indices) -> Array:
        """(R, rows) or (R, rows, columns) of the samples chosen."""
        shape = (output.rows, output.columns) if output.kind == "jacobian" else (output.rows,)
        flat: Array = self.outputs[output.name].reshape(len(self.ok), *shape)
        chosen: Array = flat[rows]
        return chosen


def _given(samples: Samples) -> dict[str, Any]:
    """Arguments by name; what is one number has no axis for it."""
    return {
        name: a[..., 0] if name != STATE and a.shape[-1] == 1 else a
        for name, a in samples.typed().items()
    }


def _evaluate(function: Any, samples: Samples, derivation: Derivation) -> _Evaluated:
    result = function(**_given(samples))
    outputs = {
        o.name: np.asarray(getattr(result, o.name), dtype=np.float64) for o in derivation.outputs
    }
    status = whole = np.asarray(result.status)
    if samples.items is not None:
        item = np.asarray(result.item_status)
        refused = np.where(np.isin(status, (ir.Status.OK, ir.Status.PARTIAL)), 0, status)
        status = np.where(refused[:, None] != 0, refused[:, None], item).reshape(-1)
    return _Evaluated(outputs, status == 0, status, whole)


def _statuses(derivation: Derivation, results: Mapping[str, _Evaluated]) -> list[Finding]:
    """Back ends must agree on which samples are outside the domain.

    CasADi's own C has no guards on intermediate values, and single precision meets the limits of
    the ranges elsewhere; neither is asked.
    """
    findings = []
    for name, result in results.items():
        if name != "native":
            continue
        for own, judge in (
            (result.status, results["numpy"].status),
            (result.whole, results["numpy"].whole),
        ):
            different = np.flatnonzero(own != judge)
            if different.size:
                k = int(different[0])
                message = f"status of {name} is {own[k]}, of numpy {judge[k]}, in sample {k}"
                findings.append(Finding(derivation.name, message))
    return findings


def _compare_exact(
    proof: _FunctionProof,
    results: Mapping[str, _Evaluated],
    scales: Mapping[str, Scales],
    good: Indices,
    few: Indices,
) -> None:
    derivation = proof.derivation
    flat = proof.samples.flat()
    exact = Exact(proof.spec, derivation)
    place = {int(row): k for k, row in enumerate(good)}
    with mp.workdps(DIGITS):
        for row in few:
            chosen = np.array([row])
            numbers = {n: [mp.mpf(float(v)) for v in a[row]] for n, a in flat.items()}
            truth = exact.outputs(numbers)
            for output in derivation.outputs:
                plain = output.name in derivation.equation.outputs
                against = "50 digits" if plain else "differences"
                scale = scales[output.name].at(np.array([place[int(row)]]))
                for name, result in results.items():
                    if name == "native_f32" and not result.ok[row]:
                        continue
                    label = "float" if name == "native_f32" else name
                    got = result.get(output, chosen)
                    # The difference is formed with all digits, so that it is not lost in rounding.
                    error = differences(got, truth[output.name])
                    if not plain:
                        forget_remainders(error, got)
                    proof.compare(
                        output, f"{label} vs {against}", error, np.zeros_like(error), scale, chosen
                    )


def _compare_reference(
    proof: _FunctionProof,
    reference: References,
    result: _Evaluated,
    scales: Mapping[str, Scales],
    good: Indices,
    few: Indices,
) -> None:
    derivation = proof.derivation
    entry = derivation.entry
    assert entry is not None
    flat = proof.samples.flat()
    place = {int(row): k for k, row in enumerate(good)}
    with mp.workdps(DIGITS):
        for row in few:
            chosen = np.array([row])
            numbers = {n: [mp.mpf(float(v)) for v in a[row]] for n, a in flat.items()}
            options = {**entry.options, "axes_frame": entry.frames.get("level", "")}
            truth = reference(entry.model.name, quantities(proof.spec, entry, numbers), options)
            for output in derivation.outputs:
                name = _REFERENCE_NAMES.get(output.name, output.name)
                if name in truth:
                    got = result.get(output, chosen)
                    error = differences(got, truth[name])
                    forget_remainders(error, got)  # it may differentiate by differences
                    scale = scales[output.name].at(np.array([place[int(row)]]))
                    proof.compare(
                        output, "numpy vs reference", error, np.zeros_like(error), scale, chosen
                    )
