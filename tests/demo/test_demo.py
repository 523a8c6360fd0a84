"""The whole demonstration with independent models: the figures symnav promises."""

from __future__ import annotations

import json
from dataclasses import dataclass, replace

import numpy as np
import pytest
from rich.console import Console

from symnav.demo.models import Array, GeneratedModels
from symnav.demo.results import Accuracy, DemoResult, VariantResult, summarise
from symnav.demo.rinex import NavigationFile, ObservationFile
from symnav.demo.run import run
from symnav.demo.table import summary_line, summary_table
from tests.demo.book_models import BookOrbit, BookRange, OrbitState


def accuracy(variant: VariantResult) -> Accuracy:
    """The statistics of a variant that must have some."""
    assert variant.accuracy is not None
    return variant.accuracy


def test_promised_figures(result: DemoResult) -> None:
    """All epochs, 2.5 m of median 3-D error, 1.5 m of residuals."""
    full = accuracy(result.full)
    assert (len(result.full.solved), result.full.epochs) == (60, 60)
    assert full.median_error_3d <= 2.5
    assert full.percentile_95_error_3d <= 2.5
    assert full.postfit_rms <= 1.5
    assert full.fewest_satellites >= 8
    assert result.shortfalls() == ()


def test_every_correction_is_worth_something(result: DemoResult) -> None:
    """Leaving one out costs what physics says: metres for TGD, tens for Sagnac, far for clocks."""
    full = accuracy(result.full)
    cost = {v.name: accuracy(v).median_error_3d - full.median_error_3d for v in result.ablations}
    assert 20.0 < cost["without_sagnac"] < 45.0
    assert 1.0 < cost["without_group_delay"] < 15.0
    assert cost["without_clock"] > 1_000.0
    assert 1.0 < cost["without_troposphere"] < 15.0
    assert 0.5 < cost["without_ionosphere"] < 15.0


def test_sagnac_is_an_eastward_error(result: DemoResult) -> None:
    """Earth turns east while the signal travels, so without the term the fix slips east."""
    (without,) = [v for v in result.ablations if v.name == "without_sagnac"]
    east, north, up = accuracy(without).mean_error_enu
    assert east > 20.0
    assert max(abs(north), abs(up)) < 5.0


@dataclass(frozen=True)
class WithoutHarmonics:
    """A faulty orbit model: the second-harmonic corrections are forgotten."""

    right: BookOrbit

    def __call__(self, *, time: Array, **message: Array) -> OrbitState:
        """Evaluates with the six amplitudes at zero."""
        nothing = {name: np.zeros_like(time) for name in ("cuc", "cus", "crc", "crs", "cic", "cis")}
        return self.right(time=time, **{**message, **nothing})


def test_a_faulty_orbit_model_is_noticed(book: GeneratedModels) -> None:
    """The figures come from the models that are passed in, not from somewhere else."""
    faulty = run(replace(book, broadcast_orbit=WithoutHarmonics(BookOrbit())))
    assert any("median" in sentence for sentence in faulty.shortfalls())
    assert any("rms" in sentence for sentence in faulty.shortfalls())


@pytest.mark.parametrize(("gm", "good"), [(3.986005e14, True), (3.986005e14 * 1.0001, False)])
def test_messages_at_the_end_of_their_service(
    monkeypatch: pytest.MonkeyPatch,
    book: GeneratedModels,
    observations: ObservationFile,
    navigation: NavigationFile,
    gm: float,
    good: bool,
) -> None:
    """Extrapolated over two hours, messages still place the receiver, and a wrong GM shows.

    The recorded minute lies at the reference time of the messages that ``run`` chooses, where the
    mean motion plays no part; the messages for two o'clock exercise it.
    """
    later = tuple(m for m in navigation.ephemerides if m.age(2149, 475200.0) < -3600.0)
    monkeypatch.setattr(
        "symnav.demo.run.load_data", lambda: (observations, replace(navigation, ephemerides=later))
    )
    far = run(replace(book, broadcast_orbit=BookOrbit(gm=gm))).full
    assert len(far.solved) == 60
    assert (accuracy(far).median_error_3d < 4.0) is good


def test_missing_sagnac_in_the_model_is_noticed() -> None:
    """With the same model in both places, the ablation is no worse and the demonstration fails."""
    same = GeneratedModels(BookOrbit(), BookRange(), BookRange())
    assert run(same).shortfalls() == ("the solution without Sagnac is not worse",)


def test_progress(book: GeneratedModels, result: DemoResult) -> None:
    """Each variant reports each epoch."""
    seen: list[tuple[str, int, int]] = []
    run(book, progress=lambda label, done, total: seen.append((label, done, total)))
    labels = [result.full.label, *(v.label for v in result.ablations)]
    assert seen == [(label, done, 60) for label in labels for done in range(1, 61)]


def test_json(result: DemoResult) -> None:
    """The result survives a round trip through JSON."""
    back = json.loads(json.dumps(result.as_dict(), allow_nan=False))
    assert back["full"]["accuracy"]["median_error_3d"] == accuracy(result.full).median_error_3d
    assert len(back["full"]["solved"]) == 60
    assert {v["name"] for v in back["ablations"]} >= {"without_sagnac", "without_clock"}


def test_statistics(result: DemoResult) -> None:
    """Hand-made epochs with known median, percentile and pooled rms."""
    first = result.full.solved[0]
    made = [
        replace(first, error_3d=float(k), postfit_rms=rms, satellites=tuple("abcdefgh"[:n]))
        for k, (rms, n) in enumerate([(1.0, 4), (2.0, 8), (1.0, 4)])
    ]
    figures = summarise(made)
    assert figures is not None
    assert figures.median_error_3d == 1.0
    assert figures.percentile_95_error_3d == pytest.approx(1.9)
    assert figures.postfit_rms == pytest.approx(((4 * 1 + 8 * 4 + 4 * 1) / 16) ** 0.5)
    assert (figures.fewest_satellites, figures.median_satellites) == (4, 4.0)
    assert figures.most_satellites == 8
    assert summarise([]) is None


def test_table(result: DemoResult) -> None:
    """Table and line show the figures of every variant."""
    console = Console(width=140, color_system=None)
    with console.capture() as captured:
        console.print(summary_table(result))
    shown = captured.get()
    for variant in (result.full, *result.ablations):
        assert variant.label in shown
    assert "60 of 60" in shown
    assert f"{accuracy(result.full).median_error_3d:.2f}" in shown
    line = summary_line(result)
    assert line.startswith("60 of 60 epochs, 10 satellites, median 3-D error 1.")
    assert all(words in line for words in ("without Sagnac", "without TGD", "without satellite"))


def test_nothing_solved_is_said(
    monkeypatch: pytest.MonkeyPatch,
    book: GeneratedModels,
    observations: ObservationFile,
    navigation: NavigationFile,
) -> None:
    """Without any message there is no solution, no statistics and no crash."""
    monkeypatch.setattr(
        "symnav.demo.run.load_data", lambda: (observations, replace(navigation, ephemerides=()))
    )
    nothing = run(book)
    assert nothing.full.accuracy is None
    assert "0 usable satellites" in nothing.full.unsolved[0].reason
    assert nothing.shortfalls() == ("0 of 60 epochs are solved",)
    assert summary_line(nothing) == "0 of 60 epochs"
    console = Console(width=140, color_system=None)
    with console.capture() as captured:
        console.print(summary_table(nothing))
    assert "0 of 60" in captured.get()
