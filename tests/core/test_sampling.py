"""Which states a proof looks at: every edge of every quantity, and what models ask for."""

from __future__ import annotations

import ast
from collections.abc import Iterator
from functools import cache
from importlib import import_module
from pathlib import Path

import numpy as np
import pytest
from mpmath import mpf

from symnav import pipeline, verify
from symnav.blocks.rotation import CONVENTIONS
from symnav.derive import Derivation
from symnav.equations import library
from symnav.spec.records import Spec
from symnav.verify.edges import edges
from symnav.verify.manifold import prove_layout
from symnav.verify.proof import prove
from symnav.verify.references import quantities
from symnav.verify.sampling import MIXED, RANDOM, Samples, draw
from tests.core.specs import vector
from tests.reference.pseudorange import antenna

WRONG_AT_IDENTITY = """
import numpy

_right = gps


def gps(x, *arguments, **inputs):
    result = _right(x, *arguments, **inputs)
    at = (x[..., 6:10] == numpy.array([1.0, 0.0, 0.0, 0.0])).all(axis=-1)
    result.value[at] += 1e-3
    return result
"""


@cache
def of_model(name: str) -> tuple[Spec, tuple[Derivation, ...]]:
    """A shipped model and its derivations."""
    spec = pipeline.load(name)
    return spec, pipeline.derive(spec).entries


def judged(spec: Spec, derivation: Derivation, count: int) -> list[str]:
    """What the states compared with fifty digits show, were all inside the domain."""
    samples = draw(spec, derivation, count, 1)
    rows = samples.judged(np.arange(len(samples.labels)))
    return [samples.labels[row] for row in rows]


@pytest.mark.parametrize("count", [8, 40, 200])
@pytest.mark.parametrize("name", [name for name, _ in pipeline.shipped()])
def test_every_edge_is_judged(name: str, count: int) -> None:
    """Once each, of every block and input that is read, whatever the number of samples."""
    spec, entries = of_model(name)
    for derivation in entries:
        shown = judged(spec, derivation, count)
        alone = [label for label in shown if label not in (RANDOM, MIXED)]
        assert len(alone) == len(set(alone))
        blocks = [spec.inputs[a].block for a in derivation.arguments if a != "x"]
        blocks += [spec.layout.places[name].block for name in states(spec, derivation)]
        expected = {f"{block.name}: {edge.name}" for block in blocks for edge in edges(block)}
        assert expected <= set(alone)
        assert shown.count(RANDOM) >= 4 and shown.count(MIXED) == 4


def states(spec: Spec, derivation: Derivation) -> Iterator[str]:
    """The state blocks a function reads."""
    read = {o.index for o in derivation.origins.values() if o.argument == "x"}
    for name, place in spec.layout.places.items():
        if read.intersection(range(place.storage.start, place.storage.stop)):
            yield name


@pytest.mark.parametrize("samples", [40, 200])
def test_an_error_at_one_edge_is_found(samples: int, tmp_path: Path) -> None:
    """A function that is wrong where the body is level, and nowhere else."""
    spec = pipeline.load("rover")
    derived_ = pipeline.derive(spec)
    package = pipeline.generate(spec, tmp_path).package
    text = (package / "numpy.py").read_text()
    (package / "numpy.py").write_text(text + WRONG_AT_IDENTITY)
    imported = pipeline.import_package(package)
    gps = [d for d in derived_.entries if d.name == "gps"]
    sheet = prove(spec, gps, derived_.layout, imported, samples=samples, seed=1)
    assert [(r.block, r.comparison) for r in sheet.rows if not r.passed] == [
        ("value", "numpy vs 50 digits")
    ]


def test_edges_that_coincide_are_one() -> None:
    """A range that begins above zero has no zero of its own."""
    block = vector("dt", 1, "s", bound=0.05, positive=True)
    assert [edge.name for edge in edges(block)] == ["zero", "upper end", "almost zero"]


def staged(name: str) -> tuple[Spec, Derivation, Samples]:
    """The samples of the first mapped function of a shipped model."""
    spec, entries = of_model(name)
    derivation = next(d for d in entries if d.mapped)
    return spec, derivation, draw(spec, derivation, 20, 1)


@pytest.mark.parametrize("name", ["rover", "farrell_tightly_coupled", "single_point"])
def test_satellites_stand_above_and_below(name: str) -> None:
    """Seen from the antenna, wherever its position is resolved; the reference says where it is."""
    spec, derivation, samples = staged(name)
    assert derivation.entry is not None
    flat = samples.flat()
    found = [k for k, label in enumerate(samples.labels) if "the antenna" in label]
    assert len(found) == 2
    for k in found:
        numbers = {argument: [mpf(float(v)) for v in a[k]] for argument, a in flat.items()}
        q = quantities(spec, derivation.entry, numbers)
        a = np.array([float(e) for e in antenna(q, {})])
        s = np.array([float(e) for e in q["satellite_position"]["value"]])
        sine = np.linalg.norm(np.cross(s, a)) / (np.linalg.norm(s) * np.linalg.norm(a))
        assert sine < 1e-12
        assert ("above" in samples.labels[k]) == (s @ a > 0.0)


def test_reference_range_is_the_length() -> None:
    """In every sample, whatever the edges of either are."""
    _, _, samples = staged("reference_relative")
    flat = samples.flat()
    length = np.linalg.norm(flat["satellite_difference"], axis=1)
    assert np.allclose(flat["reference_range"][:, 0], length, rtol=1e-14)


def test_increments_of_the_bias_alone() -> None:
    """Nothing is left of them: the rotation vanishes although neither increment nor bias does."""
    spec, entries = of_model("rover")
    imu = next(d for d in entries if d.name == "imu")
    assert any("no rotation beside the bias" in label for label in judged(spec, imu, 40))


@pytest.mark.parametrize("module", ["sampling", "scenes", "edges"])
def test_sampling_names_no_role(module: str) -> None:
    """A new model needs no change there."""
    roles = {role.name for model in library().values() for role in model.roles}
    text = (Path(verify.__file__).parent / f"{module}.py").read_text(encoding="utf-8")
    words = {n.value for n in ast.walk(ast.parse(text)) if isinstance(n, ast.Constant)}
    assert words & roles == set()


ATTITUDE = """
name = "turned"
[[frame]]
name = "n"
axes = "ned"
[[frame]]
name = "b"
axes = "free"
[[state]]
name = "attitude"
kind = "rotation"
maps = "b -> n"
storage = "{storage}"
error = "{error}"
[[state]]
name = "narrow"
kind = "vector"
size = 40
unit = "1"
range = [-1.0, 1.0]
[[measurement]]
name = "down"
equation = ["narrow[0]"]
"""


@pytest.mark.parametrize("storage", ["wxyz", "xyzw"])
@pytest.mark.parametrize("error", CONVENTIONS)
def test_every_convention_leads_back(error: str, storage: str, tmp_path: Path) -> None:
    """Retract and local are inverses at the errors drawn, whatever the seed."""
    path = tmp_path / "turned.toml"
    path.write_text(ATTITUDE.format(error=error, storage=storage))
    spec = pipeline.load(path)
    layout = pipeline.derive(spec).layout
    package = pipeline.import_package(pipeline.generate(spec, tmp_path).package)
    backend = {"numpy": import_module(f"{package.__name__}.numpy")}
    for seed in range(1, 6):
        for row in prove_layout(spec, layout, backend, 200, seed):
            assert row.passed, (seed, row)
            assert row.samples > 100
