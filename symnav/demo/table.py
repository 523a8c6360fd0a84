"""The demonstration's summary for a terminal."""

from __future__ import annotations

from typing import TYPE_CHECKING

from symnav.demo.results import (
    LARGEST_MEDIAN_ERROR,
    LARGEST_POSTFIT_RMS,
    DemoResult,
    VariantResult,
)

if TYPE_CHECKING:
    from rich.table import Table

_NOT_SOLVED = "-"


def summary_table(result: DemoResult) -> Table:
    """Makes the table of all variants; rich is imported here, so that nothing else pays for it."""
    from rich.table import Table

    table = Table(
        title=result.data,
        caption=(
            f"promised: all epochs, median 3-D error at most {LARGEST_MEDIAN_ERROR} m, "
            f"post-fit rms at most {LARGEST_POSTFIT_RMS} m"
        ),
    )
    table.add_column("solution")
    headings = ("epochs", "satellites", "median 3-D, m", "95 % 3-D, m", "post-fit rms, m")
    for heading in headings:
        table.add_column(heading, justify="right")
    table.add_row(*_cells(result.full), style="bold", end_section=True)
    for variant in result.ablations:
        table.add_row(*_cells(variant))
    return table


def summary_line(result: DemoResult) -> str:
    """Says in one line what was reached and what leaving a correction out costs."""
    full = result.full
    head = f"{len(full.solved)} of {full.epochs} epochs"
    if full.accuracy is None:
        return head
    accuracy = full.accuracy
    head += (
        f", {accuracy.median_satellites:g} satellites, median 3-D error "
        f"{accuracy.median_error_3d:.2f} m, post-fit rms {accuracy.postfit_rms:.2f} m"
    )
    costs = [f"{v.label} {_error(v)}" for v in result.ablations if v.required]
    return f"{head} ({', '.join(costs)})"


def _error(variant: VariantResult) -> str:
    accuracy = variant.accuracy
    return "not solvable" if accuracy is None else f"{_metres(accuracy.median_error_3d)} m"


def _cells(variant: VariantResult) -> tuple[str, ...]:
    epochs = f"{len(variant.solved)} of {variant.epochs}"
    accuracy = variant.accuracy
    if accuracy is None:
        return (variant.label, epochs, *[_NOT_SOLVED] * 4)
    fewest, most = accuracy.fewest_satellites, accuracy.most_satellites
    return (
        variant.label,
        epochs,
        str(fewest) if fewest == most else f"{fewest} to {most}",
        _metres(accuracy.median_error_3d),
        _metres(accuracy.percentile_95_error_3d),
        _metres(accuracy.postfit_rms),
    )


def _metres(value: float) -> str:
    """Centimetres matter up to a kilometre, not beyond."""
    return f"{value:.2f}" if value < 1_000.0 else f"{value:,.0f}"
