"""Runs the demonstration on a specification: generate, build, verify, import, position.

Input: a specification with a broadcast orbit and a pseudorange with and without the Sagnac term.
Output: what every stage gave.
"""

from __future__ import annotations

from collections.abc import Callable, Mapping
from dataclasses import dataclass
from pathlib import Path
from types import ModuleType
from typing import Any

import numpy as np

from symnav import pipeline
from symnav.blocks.vector import VectorBlock
from symnav.build import BuildResult, find_compiler
from symnav.demo.models import Array, GeneratedModels
from symnav.demo.results import DemoResult
from symnav.demo.run import Progress, run
from symnav.errors import BuildError, InputError
from symnav.spec.records import Binding, Entry, Spec, ToInput, ToState
from symnav.verify.sheet import ProofSheet

_DELAYS = ("satellite_position", "satellite_clock", "troposphere", "ionosphere")
_RANGE_ROLES = frozenset({"position", "clock_bias", *_DELAYS})


@dataclass(frozen=True, slots=True)
class Demonstration:
    """What the stages gave.

    Attributes:
        spec: the specification.
        generated: the package written.
        built: its extensions; None where there is no C compiler.
        sheet: the proof.
        backend: what the package runs on, ``native`` or ``numpy``.
        positioning: the receiver's positions from recorded observations.
    """

    spec: Spec
    generated: pipeline.Generated
    built: BuildResult | None
    sheet: ProofSheet
    backend: str
    positioning: DemoResult

    @property
    def passed(self) -> bool:
        """Whether the proof holds and the promised accuracy is reached."""
        return self.sheet.passed and not self.positioning.shortfalls()

    def as_dict(self) -> dict[str, Any]:
        """Nested dictionaries, sequences, numbers and strings."""
        return {
            "model": self.spec.name,
            "package": self.generated.package,
            "seconds": self.generated.seconds,
            "compiled": None if self.built is None else sorted(self.built.modules),
            "backend": self.backend,
            "proof": self.sheet.as_dict(),
            "positioning": self.positioning.as_dict(),
            "shortfalls": self.positioning.shortfalls(),
            "passed": self.passed,
        }


def demonstrate(
    spec: str | Path,
    out: Path,
    *,
    samples: int,
    seed: int,
    stage: Callable[[str], None],
    count: Progress,
) -> Demonstration:
    """Goes from a specification to positions.

    Args:
        spec: a file or the name of a shipped model.
        out: folder that receives the package.
        samples: random states per function in the proof.
        seed: seed of those states.
        stage: told what begins.
        count: told about each epoch.

    Raises:
        InputError: the specification lacks what positioning needs; nothing is written.
    """
    loaded = pipeline.load(spec)
    entries = choose(loaded)
    generated = pipeline.generate(loaded, out, progress=stage)
    built = pipeline.build(generated.package, progress=stage) if _has_compiler() else None
    sheet = pipeline.verify(loaded, samples=samples, seed=seed, reference=None, progress=stage)
    package = pipeline.import_package(generated.package)
    positioning = run(entries.models(package), count)
    return Demonstration(loaded, generated, built, sheet, package.BACKEND, positioning)


def _has_compiler() -> bool:
    try:
        find_compiler()
    except BuildError:
        return False
    return True


@dataclass(frozen=True, slots=True)
class Chosen:
    """The entries of a specification that the demonstration runs."""

    orbit: Entry
    ranges: Entry
    ranges_without_sagnac: Entry

    def models(self, package: ModuleType) -> GeneratedModels:
        """Their functions in an imported package."""
        return GeneratedModels(
            _Orbit(getattr(package, self.orbit.name), _arguments(self.orbit)),
            _ranges(package, self.ranges),
            _ranges(package, self.ranges_without_sagnac),
        )


def choose(spec: Spec) -> Chosen:
    """Finds the entries that can position a receiver.

    Raises:
        InputError: at least one is missing; the message says what each needs.
    """
    orbits = [e for e in spec.entries if _is_orbit(e)]
    ranges = [e for e in spec.entries if _is_range(e, spec)]
    turned = [e for e in ranges if e.options["sagnac"] != "none"]
    plain = [e for e in ranges if e.options["sagnac"] == "none"]
    if orbits and turned and plain:
        return Chosen(orbits[0], turned[0], plain[0])
    usable = (
        "an earth-fixed position and a clock bias in metres in the state and "
        f"{', '.join(_DELAYS)} as inputs, nothing else bound"
    )
    needs = (
        (orbits, "a measurement of model broadcast_orbit for gps with every quantity an input"),
        (turned, f"a measurement of model pseudorange with the Sagnac term, with {usable}"),
        (plain, f"a measurement of model pseudorange with sagnac = 'none', with {usable}"),
    )
    lacking = [f"  {words}" for found, words in needs if not found]
    raise InputError("\n".join([f"{spec.name}: the demonstration lacks", *lacking]))


def _is_orbit(entry: Entry) -> bool:
    return (
        entry.model.name == "broadcast_orbit"
        and entry.options["system"] == "gps"
        and set(_arguments(entry)) == {role.name for role in entry.model.roles}
    )


def _is_range(entry: Entry, spec: Spec) -> bool:
    bindings = entry.bindings
    if entry.model.name != "pseudorange" or set(bindings) != _RANGE_ROLES:
        return False
    position, clock = (_added(bindings[role], spec) for role in ("position", "clock_bias"))
    return (
        position is not None
        and clock is not None
        and clock.unit == "m"
        and set(_DELAYS) <= set(_arguments(entry))
    )


def _added(binding: Binding, spec: Spec) -> VectorBlock | None:
    """The state block bound to, when a correction is simply added to it."""
    block = spec.layout.places[binding.block].block if isinstance(binding, ToState) else None
    if not isinstance(block, VectorBlock) or block.error_sign != "true_minus_estimate":
        return None
    return block if block.error_frame in ("", block.frame) else None


def _arguments(entry: Entry) -> Mapping[str, str]:
    """Arguments of the generated function, by the quantity bound to them."""
    bound = entry.bindings.items()
    return {role: binding.name for role, binding in bound if isinstance(binding, ToInput)}


@dataclass(frozen=True, slots=True)
class _OrbitState:
    position: Array
    velocity: Array
    clock: Array


@dataclass(frozen=True, slots=True)
class _Orbit:
    """A generated broadcast orbit under the names of its quantities."""

    function: Callable[..., Any]
    arguments: Mapping[str, str]

    def __call__(self, **quantities: Array) -> _OrbitState:
        result = self.function(**{self.arguments[role]: v for role, v in quantities.items()})
        return _OrbitState(result.position, result.velocity, result.clock)


@dataclass(frozen=True, slots=True)
class _Prediction:
    value: Array
    jacobian: Array


@dataclass(frozen=True, slots=True)
class _Ranges:
    """A generated pseudorange over position and clock alone; other blocks keep initial values."""

    function: Callable[..., Any]
    arguments: Mapping[str, str]
    initial: Array
    elements: tuple[int, ...]
    columns: tuple[int, ...]

    def __call__(self, x: Array, /, **quantities: Array) -> _Prediction:
        state = self.initial.copy()
        state[list(self.elements)] = x
        named = {self.arguments[role]: values for role, values in quantities.items()}
        result = self.function(state, **named)
        return _Prediction(result.value, result.jacobian[:, list(self.columns)])


def _ranges(package: ModuleType, entry: Entry) -> _Ranges:
    state = package.State
    blocks = [entry.bindings[role] for role in ("position", "clock_bias")]
    names = [block.block for block in blocks if isinstance(block, ToState)]
    return _Ranges(
        getattr(package, entry.name),
        _arguments(entry),
        np.asarray(state.initial, dtype=np.float64),
        _indices(state.size, [getattr(state, name) for name in names]),
        _indices(state.error_size, [getattr(state.error, name) for name in names]),
    )


def _indices(size: int, parts: list[slice]) -> tuple[int, ...]:
    return tuple(np.concatenate([np.arange(size)[part] for part in parts]).tolist())
