"""Writes the figures of ``docs/performance.md``: tables and plot from the files of three runs.

usage: python benchmarks/page.py     reads benchmarks/results/{o2,v3,native,numpy}.json
"""

from __future__ import annotations

import json
import math
import platform
import re
import subprocess
import sys
from collections.abc import Iterator, Mapping
from importlib.metadata import PackageNotFoundError, version
from itertools import product
from pathlib import Path
from typing import Any

sys.path.insert(0, str(Path(__file__).resolve().parents[1]))

HERE = Path(__file__).parent
RESULTS = HERE / "results"
DOCS = HERE.parent / "docs"
MODELS = ("gps", "ekfcal", "pr8", "pr32", "imu1", "imu4")
RIVALS = ("symforce", "casadi", "casadi_sym", "sympy_cse", "hand")
COLOURS = {
    "symnav_nz": "#0b6e4f", "hand": "#9aa0a6", "sympy_cse": "#c9a227", "symforce": "#b5523b",
    "casadi_sym": "#7a8fb8", "casadi": "#3d5a98",
}  # fmt: skip

Figures = Mapping[str, Mapping[str, Mapping[str, Any]]]


def main() -> None:
    """Reads the results, writes the tables and draws the plot."""
    runs = {flags: _read(flags) for flags in ("o2", "v3", "native")}
    text = "\n".join(page(runs)) + "\n"
    (DOCS / "performance-results.md").write_text(text, encoding="utf-8")
    draw(runs["v3"], DOCS / "performance.svg")


def _read(flags: str) -> Figures:
    found: Figures = json.loads((RESULTS / f"{flags}.json").read_text(encoding="utf-8"))
    return found


def page(runs: Mapping[str, Figures]) -> Iterator[str]:
    """The tables, in Markdown."""
    yield "<!-- Written by benchmarks/page.py; do not edit. -->"
    yield ""
    yield f"Measured on {machine()}; {versions()}."
    yield ""
    for flags, figures in runs.items():
        yield from times(flags, figures)
    yield from ratios(runs)
    yield from many_epochs(runs["v3"])
    yield from floors(runs["v3"])
    yield from sizes(runs)
    yield from python_calls(runs["v3"])
    if (RESULTS / "numpy.json").exists():
        yield from numpy_route(json.loads((RESULTS / "numpy.json").read_text(encoding="utf-8")))


def times(flags: str, figures: Figures) -> Iterator[str]:
    """Nanoseconds of one epoch."""
    yield f"## One epoch, `--flags {flags}` (ns)"
    yield ""
    yield from table(
        ["contestant", *MODELS],
        [
            [f"`{name}`", *(number(figures[model][name]["ns"]) for model in MODELS)]
            for name in ("symnav_nz", "symnav_dense", "symnav_nz_guarded", "symnav_dense_guarded",
                         "symnav_batch_guarded", *RIVALS)
        ],
    )  # fmt: skip


def ratios(runs: Mapping[str, Figures]) -> Iterator[str]:
    """How the non-zeros form compares, over the six models and at its worst."""
    yield "## `symnav_nz` over the others (geometric mean of six models)"
    yield ""
    rows = []
    for flags, figures in runs.items():
        means = [
            math.exp(
                sum(math.log(figures[m]["symnav_nz"]["ns"] / figures[m][r]["ns"]) for m in MODELS)
                / len(MODELS)
            )
            for r in RIVALS
        ]
        worst = max(
            (figures[m]["symnav_nz"]["ns"] / min(figures[m][r]["ns"] for r in RIVALS), m)
            for m in MODELS
        )
        rows.append(
            [f"`{flags}`", *(f"{mean:.2f}" for mean in means), f"{worst[0]:.2f} ({worst[1]})"]
        )
    yield from table(["flags", *(f"`{r}`" for r in RIVALS), "worst against the best"], rows)


def many_epochs(figures: Figures) -> Iterator[str]:
    """Batches and blocks beside the same code called row by row, where they were measured."""
    names = [
        f"symnav_{form}{guarded}"
        for guarded in ("", "_guarded")
        for form in ("nz", "batch", "batch_nz", "blocks")
    ]
    measured = [n for n in names if any(n in figures[m] for m in MODELS)]
    yield "## One epoch of 64 in one call, `--flags v3` (ns)"
    yield ""
    yield from table(
        ["contestant", *MODELS],
        [
            [
                f"`{n}`",
                *(number(figures[m][n]["ns"]) if n in figures[m] else "" for m in MODELS),
            ]
            for n in measured
        ],
    )


def floors(figures: Figures) -> Iterator[str]:
    """What loads, stores, divisions, roots and sines alone take."""
    yield "## Distance to loads, stores, divisions, roots and sines alone, `--flags v3` (ns)"
    yield ""
    rows = [
        ["`floor`", *(number(figures[m]["floor"]["ns"]) for m in MODELS)],
        ["`symnav_nz`", *(number(figures[m]["symnav_nz"]["ns"]) for m in MODELS)],
        [
            "ratio",
            *(f"{figures[m]['symnav_nz']['ns'] / figures[m]['floor']['ns']:.1f}" for m in MODELS),
        ],
    ]
    yield from table(["", *MODELS], rows)


def sizes(runs: Mapping[str, Figures]) -> Iterator[str]:
    """Operations, lines, code and stack."""
    yield "## Operations of one evaluation, as executed"
    yield ""
    names = ("symnav_nz", *RIVALS)
    yield from table(
        ["contestant", *MODELS],
        [[f"`{n}`", *(str(runs["v3"][m][n]["ops"]) for m in MODELS)] for n in names],
    )
    yield "## Lines of code of the functions that compute"
    yield ""
    yield from table(
        ["contestant", *MODELS],
        [
            [f"`{n}`", *(str(runs["v3"][m][n]["lines"]) for m in MODELS)]
            for n in ("symnav_nz", "symnav_nz_guarded", *RIVALS)
        ],
    )
    for flags in ("o2", "v3"):
        yield f"## Machine code / stack, `--flags {flags}` (bytes)"
        yield ""
        figures = runs[flags]
        yield from table(
            ["contestant", *MODELS],
            [
                [
                    f"`{n}`",
                    *(f"{figures[m][n]['bytes']} / {figures[m][n]['stack']}" for m in MODELS),
                ]
                for n in ("symnav_nz", "symnav_nz_guarded", *RIVALS)
            ],
        )


def python_calls(figures: Figures) -> Iterator[str]:
    """Calls from Python."""
    yield "## Calls from Python (ns for one evaluation)"
    yield ""
    chosen = ("gps", "pr8", "imu4")
    kinds = ("python_", "batch_", "small_batch_")
    names = sorted({n for m in chosen for n in figures[m] if n.startswith(kinds)})
    yield from table(
        ["way", *chosen],
        [
            [f"`{n}`", *(number(figures[m][n]["ns"]) if n in figures[m] else "" for m in chosen)]
            for n in names
        ],
    )
    yield "Above the C of the package, `symnav_packaged`:"
    yield ""
    yield from table(
        ["way", *MODELS],
        [
            [
                f"`{name}`",
                *(
                    number(figures[m][name]["ns"] - figures[m]["symnav_packaged"]["ns"])
                    for m in MODELS
                ),
            ]
            for name in ("python_bound", "python_checked")
        ],
    )
    stream, copy = (figures["gps"][n]["ns"] for n in ("stream_native", "stream_copy"))
    yield (
        f"A million epochs of gps from row-major arrays take {number(stream)} ns each; a copy of "
        f"the same bytes takes {number(copy)} ns, {copy / stream:.2f} of it."
    )
    yield ""


def numpy_route(figures: Mapping[str, Mapping[str, Mapping[str, float]]]) -> Iterator[str]:
    """The NumPy back end against ``lambdify``, by number of epochs."""
    for epochs in next(iter(figures.values())):
        found = {model: figures[model][epochs] for model in MODELS}
        many = "one epoch" if int(epochs) == 1 else f"{int(epochs):,} epochs in one call"
        yield f"## The NumPy route, {many} (ns for one epoch)"
        yield ""
        names = dict.fromkeys(name for times in found.values() for name in times)
        rows = [
            [f"`{n}`", *(number(found[m][n]) if n in found[m] else "" for m in MODELS)]
            for n in names
        ]
        for own, rival in product(("numpy", "numpy_assume"), ("lambdify_dense", "lambdify_flat")):
            ratios = (found[m][own] / found[m][rival] for m in MODELS)
            rows.append([f"`{own}` over `{rival}`", *(f"{ratio:.2f}" for ratio in ratios)])
        yield from table(["way", *MODELS], rows)


def table(headings: list[str], rows: list[list[str]]) -> Iterator[str]:
    """A Markdown table, numbers to the right."""
    yield "| " + " | ".join(headings) + " |"
    yield "|---|" + "---:|" * (len(headings) - 1)
    for row in rows:
        yield "| " + " | ".join(row) + " |"
    yield ""


def number(value: float) -> str:
    """Three digits are what a run repeats."""
    return f"{value:.0f}" if value >= 100 else f"{value:.1f}"


def machine() -> str:
    """Processor and system."""
    text = subprocess.run(["lscpu"], capture_output=True, text=True, check=False).stdout
    facts = dict(re.findall(r"^([^:\n]+):\s+(.*)$", text, flags=re.MULTILINE))
    model = facts.get("Model name", platform.processor())
    family = f"family {facts.get('CPU family', '?')} model {facts.get('Model', '?')}"
    return f"{facts.get('CPU(s)', '?')} processors of {model} ({family}), {platform.system()}"


def versions() -> str:
    """Compiler and rivals."""
    gcc = subprocess.run(["gcc", "--version"], capture_output=True, text=True, check=False).stdout
    found = [gcc.splitlines()[0].removeprefix("gcc ") if gcc else "no gcc"]
    for name in ("casadi", "sympy", "symforce", "numpy", "cffi", "numba", "jax"):
        try:
            found.append(f"{name} {version(name)}")
        except PackageNotFoundError:
            continue
    return f"gcc {', '.join(found)}"


def draw(figures: Figures, file: Path) -> None:
    """Time over that of ``symnav_nz``, model by model."""
    import matplotlib

    matplotlib.use("svg")
    matplotlib.rcParams["svg.hashsalt"] = "symnav"
    from matplotlib import pyplot

    names = list(COLOURS)
    width = 0.8 / len(names)
    canvas, axes = pyplot.subplots(figsize=(9.0, 3.6))
    for k, name in enumerate(names):
        heights = [figures[m][name]["ns"] / figures[m]["symnav_nz"]["ns"] for m in MODELS]
        places = [i + (k - (len(names) - 1) / 2) * width for i in range(len(MODELS))]
        axes.bar(places, heights, 0.92 * width, label=name, color=COLOURS[name])
    axes.axhline(1.0, color="#444444", linewidth=0.8)
    labels = [f"{m}\n{number(figures[m]['symnav_nz']['ns'])} ns" for m in MODELS]
    axes.set_xticks(range(len(MODELS)), labels)
    axes.set_ylabel("time over symnav_nz")
    axes.spines[["top", "right"]].set_visible(False)
    axes.legend(ncols=3, frameon=False, fontsize=8, loc="upper left")
    canvas.tight_layout()
    canvas.savefig(file, metadata={"Date": None})


if __name__ == "__main__":
    main()
