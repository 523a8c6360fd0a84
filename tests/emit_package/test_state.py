"""The state object: slices, packing, names, and the maps to and from its error."""

from __future__ import annotations

import copy
import pickle
from types import ModuleType

import numpy as np
import pytest

from tests.emit_numpy import modules, packages


def test_slices_into_both_vectors(package: ModuleType) -> None:
    """Every block by its name, in storage and in the error."""
    state = package.State
    assert (state.size, state.error_size, state.error.size) == (13, 12, 12)
    assert state.names == ("position", "attitude", "bias_gps", "bias_galileo", "ambiguity")
    assert (state.position, state.attitude) == (slice(0, 3), slice(3, 7))
    assert (state.error.attitude, state.error.ambiguity) == (slice(3, 6), slice(8, 12))
    assert state.slices["bias_galileo"] == slice(8, 9)
    assert state.units["attitude"] == "1"
    assert state.error.units["attitude"] == "rad"
    assert state.frames["position"] == "n"
    assert state.labels[:5] == (
        "position x", "position y", "position z", "attitude w", "attitude x",
    )  # fmt: skip
    assert state.labels[7] == "bias_gps"
    assert len(state.error.labels) == 12
    assert state.conventions["position"] == "x = x0 + d"
    assert state.digest == "0" * 64


def test_names_of_blocks_are_read_only(package: ModuleType) -> None:
    """Tables cannot be changed by accident."""
    with pytest.raises(TypeError):
        package.State.units["position"] = "km"
    with pytest.raises(ValueError, match="read-only"):
        package.State.initial[0] = 1.0


def test_copies_and_pickles(package: ModuleType) -> None:
    """The state travels by its name; what is part of it, whole."""
    state = package.State
    assert pickle.loads(pickle.dumps(state)) is state
    assert copy.deepcopy({"filter": state})["filter"] is state
    for other in (pickle.loads(pickle.dumps(state.error)), copy.deepcopy(state.error)):
        assert (other.attitude, other.labels) == (state.error.attitude, state.error.labels)
        assert other.units == state.error.units
        with pytest.raises(TypeError):
            other.units["position"] = "km"


def test_pack_and_unpack(package: ModuleType, rng: np.random.Generator) -> None:
    """One is the other backwards, over leading axes; a block of one element has no axis."""
    x = packages.states(rng, 4, 2)
    blocks = package.State.unpack(x)
    assert blocks._fields == package.State.names
    assert blocks.bias_gps.shape == (4, 2)
    assert blocks.ambiguity.shape == (4, 2, 4)
    assert np.array_equal(package.State.pack(**blocks._asdict()), x)


def test_unpack_gives_views(package: ModuleType, rng: np.random.Generator) -> None:
    """Writing to a block writes to the state."""
    x = packages.states(rng, 2)
    package.State.unpack(x).position[:] = 5.0
    assert (x[:, :3] == 5.0).all()


def test_pack_broadcasts_and_fills_in(package: ModuleType) -> None:
    """Blocks broadcast against each other; what is not given has its initial value."""
    x = package.State.pack(position=np.zeros((3, 1, 3)), bias_gps=[1.0, 2.0])
    assert x.shape == (3, 2, 13)
    assert x[1, 1].tolist() == [0, 0, 0, 1, 0, 0, 0, 2, 0.5, 0.5, 0.5, 0.5, 0.5]
    assert np.array_equal(package.State.pack(), package.State.initial)
    assert package.State.pack(bias_gps=1j).dtype == np.complex128


def test_wrong_blocks(package: ModuleType) -> None:
    """Names and shapes are checked."""
    with pytest.raises(TypeError, match="pack: no block 'velocity'; the state holds position, at"):
        package.State.pack(velocity=np.zeros(3))
    with pytest.raises(ValueError, match=r"attitude: expected \(\.\.\., 4\); got \(3,\)"):
        package.State.pack(attitude=np.zeros(3))
    with pytest.raises(ValueError, match=r"x: expected \(\.\.\., 13\) = position\[3\] .*got \(12,"):
        package.State.unpack(np.zeros(12))


@pytest.mark.parametrize("batch", packages.BATCHES, ids=str)
def test_retract_and_local(
    package: ModuleType, rng: np.random.Generator, batch: tuple[int, ...]
) -> None:
    """Local finds the error that retract took, to the order these fixtures keep."""
    x, d = packages.states(rng, *batch), rng.uniform(-1e-7, 1e-7, size=(*batch, 12))
    y = package.State.retract(x, d)
    assert y.shape == x.shape
    assert package.State.local(x, y) == pytest.approx(d, abs=3e-14 * 100)


def test_retract_guards(package: ModuleType, rng: np.random.Generator) -> None:
    """The maps are functions like the others."""
    with pytest.raises(package.GuardError, match=r"retract: RANGE: d\[2\]"):
        package.State.retract(packages.states(rng), np.full(12, 1e3) + (np.arange(12) == 2))


def test_a_package_without_a_state(tmp_path: ModuleType) -> None:
    """Functions of inputs alone make a package as well."""
    from pathlib import Path

    from symnav import ir

    module = ir.Module(
        "plain",
        ir.Scalar.DOUBLE,
        ir.State((), 0, 0, "2" * 64),
        (modules.operations(),),
        "3" * 64,
        "symnav 0",
    )
    folder = Path(str(tmp_path)) / "plain"
    plain = packages.load(packages.write(packages.text_of(module), folder))
    assert plain.operations(a=1.0, b=2.0).value[0] == 3.0
    assert not hasattr(plain, "State")
    assert "State" not in (folder / "__init__.pyi").read_text()


def test_pack_takes_numbers_only(package: ModuleType) -> None:
    """Text or objects name their block."""
    name = package.State.names[0]
    for value in ("a", ["a", "b", "c"], None):
        with pytest.raises(TypeError, match=f"pack: {name} must be numbers"):
            package.State.pack(**{name: value})
