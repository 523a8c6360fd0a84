"""Specific force from increments and rates under every option, both routes."""

from __future__ import annotations

from dataclasses import replace
from fractions import Fraction
from typing import Any

import pytest

from symnav.equations import library
from symnav.equations.specific_force import HARMONIC, polynomial_weights
from symnav.errors import EquationError
from tests.core.judging import check, product_of
from tests.core.specs import Case, derived, inertial, rotation, vector
from tests.reference import sculling


@pytest.mark.parametrize("kind", ["polynomial", "harmonic", "none"])
@pytest.mark.parametrize("samples", [1, 2, 3, 4, 5])
def test_sub_samples(samples: int, kind: str) -> None:
    """Any number of sub-samples with biases, in the state."""
    check(inertial(samples, kind))


@pytest.mark.parametrize(
    ("correction", "epoch", "output"),
    product_of(
        ["half", "exact", "none"], ["start", "mid", "end"], ["specific_force", "delta_velocity"]
    ),
)
def test_rotation_correction(correction: str, epoch: str, output: str) -> None:
    """Every correction for every epoch, with Jacobians toward inputs."""
    case = inertial(2, "polynomial", rotation=correction, epoch=epoch, output=output)
    by = ("dth", "dv") if output == "delta_velocity" else ("dt",)
    check(replace(case, entry={"jacobian_inputs": by}))


@pytest.mark.parametrize("storage", ["wxyz", "dcm"])
def test_attitude_as_an_input(storage: str) -> None:
    """As in NavToolkit: everything given, Jacobians toward the increments and the attitude."""
    case = inertial(1)
    check(
        replace(
            case,
            blocks=[vector("padding", 1)],
            inputs=[rotation("q", storage=storage), *case.blocks[1:], *case.inputs],
            entry={"jacobian_inputs": ("q", "dth", "dv", "dt", "ba")},
        )
    )


def test_constants() -> None:
    """A fixed interval, fixed biases, a fixed attitude."""
    case = inertial(2, "polynomial", rotation="exact")
    fixed: dict[str, Any] = {**case.bindings, "dt": (0.01,)}
    check(replace(case, bindings=fixed))
    fixed |= {"gyro_bias": (0.1, 0.2, -0.05), "attitude": (0.5, 0.5, -0.5, 0.5)}
    check(replace(case, bindings=fixed))


def test_increments_as_states() -> None:
    """Nothing forbids it."""
    case = inertial(2, "polynomial", rotation="exact")
    check(replace(case, blocks=[*case.blocks, *case.inputs], inputs=[]))  # type: ignore[list-item]


def test_without_attitude() -> None:
    """The result stays in the body frame."""
    case = inertial(2, "polynomial", rotation="exact")
    bindings = {role: name for role, name in case.bindings.items() if role != "attitude"}
    check(replace(case, bindings=bindings))


@pytest.mark.parametrize("biased", [True, False])
def test_previous_increment(biased: bool) -> None:
    """One sample with memory of the interval before."""
    case = inertial(1, "polynomial")
    before = [vector("dth0", 3, "rad", "b", 0.2), vector("dv0", 3, "m/s", "b", 50.0)]
    bindings: dict[str, Any] = {
        **case.bindings,
        "previous_delta_theta": "dth0",
        "previous_delta_velocity": "dv0",
    }
    if not biased:
        del bindings["gyro_bias"], bindings["accelerometer_bias"]
    check(
        replace(
            case,
            inputs=[*case.inputs, *before],
            bindings=bindings,
            entry={"jacobian_inputs": ("dth0", "dv0", "dth")},
        )
    )


@pytest.mark.parametrize(
    ("kind", "correction", "epoch"),
    product_of(["polynomial", "none"], ["half", "exact"], ["start", "mid", "end"]),
)
def test_rates(kind: str, correction: str, epoch: str) -> None:
    """Rates at both ends of the interval."""
    base = inertial(1)
    rates = {
        "angular_rate_start": vector("w0", 3, "rad/s", "b", 3.0),
        "angular_rate_end": vector("w1", 3, "rad/s", "b", 3.0),
        "specific_force_start": vector("f0", 3, "m/s^2", "b", 50.0),
        "specific_force_end": vector("f1", 3, "m/s^2", "b", 50.0),
    }
    kept = {r: n for r, n in base.bindings.items() if not r.startswith("delta")}
    case = Case(
        "specific_force",
        base.blocks,
        [*rates.values(), vector("dt", 1, "s", bound=0.1, positive=True)],
        {**kept, **{role: block.name for role, block in rates.items()}},
        base.frames,
        {"input": "rates", "sculling": kind, "rotation": correction, "epoch": epoch},
        {"jacobian_inputs": ("w0", "w1", "f0", "f1", "dt") if correction == "half" else ()},
    )
    check(case)


@pytest.mark.parametrize("epoch", ["start", "mid", "end"])
def test_small_and_large_turns(epoch: str) -> None:
    """The series serve the whole declared range: from nothing to a radian."""
    base = inertial(1, rotation="exact", epoch=epoch)
    for angle in (0.0, 0.7):
        case = replace(base, inputs=[vector("dth", 3, "rad", "b", 0.8), *base.inputs[1:]], entry={})
        check(case, dth=(0.6 * angle, -0.8 * angle, angle), bg=(0.0, 0.0, 0.0))


def biased(bound: float) -> Case:
    """Exact rotation with a gyro bias of a declared size, over an interval of 0.1 s at most."""
    base = inertial(1, rotation="exact")
    attitude, _, accelerometer = base.blocks
    bias = vector("bg", unit="rad/s", frame="b", bound=bound)
    return replace(base, blocks=[attitude, bias, accelerometer])


@pytest.mark.parametrize("epoch", ["start", "mid", "end"])
def test_bias_adds_to_the_turn(epoch: str) -> None:
    """The series reach as far as the increments and the bias together."""
    case = biased(2.0)
    case = replace(case, options={**case.options, "epoch": epoch})
    check(case, dth=(0.2, -0.2, 0.2), bg=(-2.0, 2.0, -2.0), dt=(0.1,))


def test_a_bias_beyond_all_turns_is_guarded() -> None:
    """Where the declared bias could more than double the turn, the turn itself is checked."""
    for bound, guarded in ((1.9, False), (3.0, True), (50.0, True)):
        found = {d.symbol.name: d.guard for d in derived(biased(bound).spec()).definitions}
        guard = found["theta_squared"]
        assert (guard is not None) == guarded
        assert guard is None or guard.upper == pytest.approx(4 * 3 * 0.2**2)


def test_a_turn_beyond_pi_is_refused() -> None:
    """The declared range must keep the series inside its domain."""
    base = inertial(1, rotation="exact")
    wide = replace(base, inputs=[vector("dth", 3, "rad", "b", 2.0), *base.inputs[1:]])
    with pytest.raises(EquationError, match="below pi"):
        derived(wide.spec())


@pytest.mark.parametrize("count", [2, 3, 4, 5])
def test_weights(count: int) -> None:
    """Both families against their own derivation; W from i < j of an antisymmetric form."""
    expected = sculling.polynomial_weights(count, 0)
    for (i, j), weight in polynomial_weights(count).items():
        assert weight == expected[i][j] == -expected[j][i]
    harmonic = sculling.harmonic_weights(count)
    assert list(HARMONIC[count]) == [harmonic[k][count - 1] for k in range(count - 1)]


def test_declared_weights_of_the_book() -> None:
    """Two samples: 2/3; three: 57/80 and 33/80."""
    assert polynomial_weights(2) == {(0, 1): Fraction(2, 3)}
    assert polynomial_weights(3) == {
        (0, 1): Fraction(57, 80), (0, 2): Fraction(33, 80), (1, 2): Fraction(57, 80),
    }  # fmt: skip


def problems(bound: str, **options: Any) -> set[str]:
    """Keywords that the model's own rules complain about."""
    model = library()["specific_force"]
    full = {option.name: option.default for option in model.options}
    return {key for key, _ in model.check({**full, **options}, frozenset(bound.split()))}


def test_rules() -> None:
    """Each rule speaks, and only where it is broken."""
    both = "delta_theta delta_velocity dt"
    ends = "angular_rate_start angular_rate_end specific_force_start specific_force_end"
    previous = f"{both} previous_delta_theta previous_delta_velocity"
    assert problems(both) == set()
    assert problems(previous) == set()
    assert problems(f"{ends} dt", input="rates") == set()
    assert problems("delta_theta delta_velocity", output="delta_velocity") == set()
    assert problems("delta_theta delta_velocity") == {"dt"}
    assert problems("delta_theta dt") == {"delta_velocity"}
    assert problems(f"{both} angular_rate_end") == {"angular_rate_end"}
    assert problems(f"{ends} dt delta_theta", input="rates") == {"delta_theta"}
    assert problems(f"{both} previous_delta_theta") == {"previous_delta_theta"}
    assert problems(previous, samples=2) == {"samples"}
    assert problems(previous, sculling="none") == {"sculling"}
    assert problems(f"{ends} dt", input="rates", sculling="harmonic") == {"sculling"}
    plain = {"input": "rates", "rotation": "none", "increments": "compensated"}
    assert problems(f"{ends} dt", **plain) == {"increments"}
    assert problems(f"{ends} dt", **plain, sculling="none") == set()
    assert problems(f"{ends} dt", input="rates", samples=3) == {"samples"}
    assert problems(previous, sculling="harmonic") == {"sculling"}
    assert problems(both, increments="compensated") == {"increments"}
    assert problems(both, increments="compensated", rotation="none") == set()
    compensated = {"increments": "compensated", "rotation": "none", "samples": 2}
    assert problems(both, **compensated) == {"increments"}
    assert problems(both, **compensated, sculling="none") == set()
    gyro = "delta_theta delta_velocity gyro_bias"
    assert problems(gyro, output="delta_velocity") == {"dt"}
