"""The verb that writes the flight-software bundle: export."""

from __future__ import annotations

import shlex
from pathlib import Path

import click

from symnav.cli.console import Verb, progress, write_json


@click.command(
    cls=Verb,
    epilog="""\b
Examples:
  symnav export rover.toml --to flight/rover
  symnav export rover.toml --to flight/rover --scalar float --tolerance 0.01
""",
)
@click.argument("spec")
@click.option(
    "--to",
    "folder",
    type=click.Path(path_type=Path, file_okay=False),
    required=True,
    metavar="DIR",
    help="Folder that becomes the bundle.",
)
@click.option(
    "--scalar",
    type=click.Choice(("double", "float")),
    default="double",
    show_default=True,
    help="Floating-point type; what must be double stays in files of its own.",
)
@click.option(
    "--tolerance",
    type=click.FloatRange(min=0.0, min_open=True),
    default=None,
    metavar="NUMBER",
    help="Refuse when rounding can move a value of a measurement or correction by more than this, "
    "in the value's unit; Jacobians do not count.",
)
@click.option("--force", is_flag=True, help="Write over changes made by hand.")
def export(
    spec: str, folder: Path, scalar: str, tolerance: float | None, force: bool, as_json: bool
) -> None:
    """Write SPEC as a bundle of C for flight software.

    The bundle holds headers, sources, tests, build files, documents and proofs. Its kernels are
    byte for byte those the Python extension is compiled from. Nothing is written when the
    specification has mistakes or a tolerance is exceeded.
    """
    from symnav import pipeline

    with progress() as reporter:
        loaded = pipeline.load(spec)
        done = pipeline.export(
            loaded,
            folder,
            scalar=scalar,
            tolerance=tolerance,
            force=force,
            progress=reporter.stage,
        )
    follow = f"make -C {shlex.quote(str(done.folder))} check"
    if as_json:
        trees = [
            dict(zip(("prefix", "scalar", "functions"), tree, strict=True)) for tree in done.trees
        ]
        found = {"written": done.written, "unchanged": done.unchanged, "next": follow}
        write_json({"bundle": done.folder, "name": done.name, "trees": trees, **found})
        return
    what = "unchanged" if done.unchanged else f"{len(done.written)} files written"
    click.echo(f"{done.folder}: {what}")
    for prefix, kind, functions in done.trees:
        if functions:
            click.echo(f"  {prefix} ({kind}): {', '.join(functions)}")
    click.echo(f"next: {follow}, then read {done.folder / 'README.md'}")
