"""Measuring generated code: what is timed computes the right thing, and what is reported is so."""

from __future__ import annotations

import json
import shutil
from pathlib import Path

import numpy as np
import pytest
from click.testing import CliRunner

from symnav import pipeline
from symnav.bench import Row, compared
from symnav.bench.adapters import EPOCHS, Entries
from symnav.bench.program import built, run
from symnav.bench.quiet import HALF, Burst, Quiet, least_room, medians, quietest
from symnav.cli import main
from symnav.verify.records import records

pytestmark = pytest.mark.skipif(shutil.which("gcc") is None, reason="needs gcc")
ITEMS = 5


@pytest.mark.parametrize("name", ["gps", "range", "imu"])
def test_adapters_call_what_they_say(name: str, tmp_path: Path) -> None:
    """Dense, non-zeros and batch give what the package's NumPy gives, selectors included."""
    spec = pipeline.load("rover")
    made = pipeline.generate(spec, tmp_path)
    derived = pipeline.derive(spec)
    package = pipeline.import_package(made.package)
    (derivation,) = (d for d in derived.entries if d.name == name)
    drawn = records(spec, [derivation], package.numpy, ITEMS)[name][:EPOCHS]
    assert len(drawn) == EPOCHS
    (function,) = (f for f in pipeline.c_route(spec, derived) if f.name == name)
    entries = Entries("rover", function, made.package / "c", ITEMS)
    assert drawn.shape == (EPOCHS, entries.record)
    forms = [entries.dense("dense"), entries.nonzeros("nonzeros"), entries.batch("batch")]
    taken = run(built(forms, "o2", tmp_path / "bench"), drawn, 1)
    given = {}
    for argument in function.arguments:
        start = entries.offsets[argument.name]
        part = drawn[:, start : start + entries.length(argument)]
        shape = (EPOCHS, ITEMS, argument.size) if argument.item else (EPOCHS, argument.size)
        array = part.reshape(shape)
        if argument.size == 1 and argument.name != "x":
            array = array[..., 0]
        given[argument.name] = array.astype(np.int32) if argument.integer else array
    expected = getattr(package.numpy, name)(given.pop("x"), **given)
    assert not expected.status.any()
    values = [np.asarray(getattr(expected, output.name)) for output in function.outputs]
    dense = np.hstack([value.reshape(EPOCHS, -1) for value in values])
    scale = np.abs(dense).max()
    assert np.abs(taken.outputs["dense"] - dense).max() < 1e-12 * scale
    stacked = np.concatenate([value.ravel() for value in values])
    assert np.abs(taken.outputs["batch"][0] - stacked).max() < 1e-12 * scale
    plain = np.hstack([v.reshape(EPOCHS, -1) for v in values[:-1]])
    assert np.abs(taken.outputs["nonzeros"][:, : plain.shape[1]] - plain).max() < 1e-12 * scale
    assert set(taken.ns) == {"dense", "nonzeros", "batch"} and min(taken.ns.values()) > 0.0


def test_whole_rounds_with_a_core_to_themselves_count() -> None:
    """What shares the core for one candidate spoils the round for all: they stay comparable."""
    quiet = [{"a": Burst(ns, 4.6), "b": Burst(2 * ns, 4.7)} for ns in (10.0, 12.0, 14.0)]
    shared = [
        {"a": Burst(30.0, 2.1), "b": Burst(20.0, 4.9)},
        {"a": Burst(1.0, 4.9), "b": Burst(40.0, 2.2)},
    ]
    rounds = iter([shared[0], quiet[0], shared[1], quiet[1]])
    taken = quietest(lambda: [next(rounds)], 2, Quiet(4.5, 60.0))
    assert taken == ([quiet[0], quiet[1]], True) and next(rounds, None) is None
    assert medians(taken[0]) == {"a": 11.0, "b": 22.0}
    assert quietest(lambda: quiet, 2, Quiet(4.5, 60.0)) == ([quiet[1], quiet[2]], True)


def test_a_core_that_stays_shared_is_told() -> None:
    """There are as many rounds as were asked for, the best of them, after the patience is over."""
    rooms = iter([2.1, 2.4, 2.2, 2.3])
    taken, alone = quietest(lambda: [{"one": Burst(30.0, next(rooms))}], 3, Quiet(3.5, 0.0))
    assert not alone and [one["one"].room for one in taken] == [2.1, 2.2, 2.4]


def test_room_of_this_machine(tmp_path: Path) -> None:
    """Additions in a cycle: more than half of a core does, fewer than any whole one."""
    assert HALF <= least_room(0.2, tmp_path) < 16.0


def test_verb(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    """A row for every form of every function; the second run knows the first."""
    monkeypatch.setenv("SYMNAV_CACHE_DIR", str(tmp_path))
    command = ["bench", "warpos_gps", "--repetitions", "1", "--json"]
    runs = [json.loads(CliRunner().invoke(main, command).stdout) for _ in range(2)]
    names = [e.name for e in pipeline.load("warpos_gps").entries]
    for made in runs:
        assert {row["function"] for row in made["functions"]} == set(names)
        assert all(row["code"] > 0 and row["ns"] > 0 for row in made["functions"])
    assert all(row["change"] is None for row in runs[0]["functions"])
    assert all(row["change"] > 0 for row in runs[1]["functions"])
    plain = CliRunner().invoke(main, command[:-1])
    assert plain.exit_code == 0 and "nonzeros" in plain.stdout


def test_verb_says_what_shared_its_core(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    """Times that are too long are not passed over."""
    monkeypatch.setenv("SYMNAV_CACHE_DIR", str(tmp_path))
    alone, shared = (Row(n, "dense", None, 10.0, 1, 1, 1, alone=n == "f") for n in "fg")
    monkeypatch.setattr("symnav.bench.bench", lambda *_, **__: [alone, shared])
    said = CliRunner().invoke(main, ["bench", "warpos_gps"]).stdout.splitlines()[-1]
    assert said == "The core did something else while g ran: these times are too long."
    monkeypatch.setattr("symnav.bench.bench", lambda *_, **__: [alone])
    assert "too long" not in CliRunner().invoke(main, ["bench", "warpos_gps"]).stdout


def test_only_the_same_is_compared(tmp_path: Path) -> None:
    """Another number of items or other flags have no history."""
    file = tmp_path / "spec.json"
    row = Row("f", "dense", 8, 10.0, 1, 1, 1)
    assert compared([row], file, "v3")[0].change is None
    assert compared([Row("f", "dense", 8, 15.0, 1, 1, 1)], file, "v3")[0].change == 1.5
    assert compared([row], file, "o2")[0].change is None
    assert compared([Row("f", "dense", 32, 15.0, 1, 1, 1)], file, "v3")[0].change is None


def test_missing_compiler_is_named(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    """One line says what is missing."""
    monkeypatch.setenv("PATH", str(tmp_path))
    done = CliRunner().invoke(main, ["bench", "warpos_gps"])
    assert done.exit_code == 1
    assert "gcc is needed to measure" in done.stderr


@pytest.mark.parametrize("name", [name for name, _ in pipeline.shipped()])
def test_every_shipped_model_has_records(name: str, tmp_path: Path) -> None:
    """Samples of its declared ranges that are inside its domain, all eight items of each."""
    spec = pipeline.load(name)
    functions = pipeline.import_package(pipeline.generate(spec, tmp_path).package).numpy
    found = records(spec, pipeline.derive(spec).entries, functions, 8)
    assert all(len(rows) >= 4 for rows in found.values())
