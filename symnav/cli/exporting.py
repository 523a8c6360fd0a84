"""The verb that writes the flight-software bundle: export."""

from __future__ import annotations

import shlex
from pathlib import Path
from typing import TYPE_CHECKING, Any

import click

from symnav.cli.console import Verb, changes, progress, show_table, write_json
from symnav.errors import InputError, ProofError

if TYPE_CHECKING:
    from symnav.export import Tolerance
    from symnav.export.proofs.proving import Proven


class _Folder(click.Path):
    """A folder that has a name: an empty word, as of a variable that is not set, means none."""

    def convert(self, value: Any, param: click.Parameter | None, ctx: click.Context | None) -> Any:
        """Refuses the empty word, which would be the current folder."""
        if value == "":
            self.fail("the name is empty; give a folder, '.' for the current one.", param, ctx)
        return super().convert(value, param, ctx)


def _tolerance(_ctx: click.Context, _option: click.Parameter, words: tuple[str, ...]) -> Tolerance:
    """What the words of ``--tolerance`` mean together."""
    from symnav.export import Tolerance

    try:
        return Tolerance.read(words)
    except InputError as error:
        raise click.BadParameter(f"{error}.") from None


@click.command(
    cls=Verb,
    epilog="""\b
Examples:
  symnav export rover.toml --to flight/rover
  symnav export rover.toml --to flight/rover --scalar float --tolerance gps=0.01
  symnav export rover.toml --to flight/rover --scalar float --tolerance 0.01 --tolerance imu=60
  symnav export rover.toml --to flight/rover --guards outer
  symnav export rover.toml --to flight/rover --prove
""",
)
@click.argument("spec")
@click.option(
    "--to",
    "folder",
    type=_Folder(path_type=Path, file_okay=False),
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
    multiple=True,
    callback=_tolerance,
    metavar="[FUNCTION=]NUMBER",
    help="Refuse when rounding can move a value of FUNCTION, or of any measurement or correction, "
    "by more than this. The number is in the unit of each value, function by function: m for one, "
    "m/s^2 for another. Jacobians do not count. May be repeated; a function's own goes first.",
)
@click.option("--batches", is_flag=True, help="Entry points for many epochs as well.")
@click.option(
    "--guards",
    type=click.Choice(("status", "outer", "assume")),
    default=None,
    help="Where checks stand instead of where SPEC says: in every call; inputs in a function of "
    "their own, to be called where data enter; or nowhere.",
)
@click.option("--prove", is_flag=True, help="Run every proof whose tool is installed.")
@click.option("--force", is_flag=True, help="Write over changes made by hand.")
@click.pass_context
def export(
    ctx: click.Context,
    spec: str,
    folder: Path,
    scalar: str,
    tolerance: Tolerance,
    batches: bool,
    guards: str | None,
    prove: bool,
    force: bool,
    as_json: bool,
) -> None:
    """Write SPEC as a bundle of C for flight software.

    The bundle holds headers, sources, tests, build files, documents and proofs. Its kernels are
    byte for byte those the Python extension is compiled from. Nothing is written when the
    specification has mistakes or a tolerance is exceeded. With --prove every proof whose tool is
    installed is run and recorded in proof/; exits with 3 when one fails.
    """
    from symnav import pipeline

    with progress() as reporter:
        loaded = pipeline.load(spec)
        done = pipeline.export(
            loaded,
            folder,
            scalar=scalar,
            tolerance=tolerance,
            batches=batches,
            guards=guards,
            proofs=prove,
            force=force,
            progress=reporter.stage,
        )
    failed = done.proven is not None and not done.proven.passed
    follow = f"make -C {shlex.quote(str(done.folder))} check"
    if as_json:
        trees = [
            dict(zip(("prefix", "scalar", "functions"), tree, strict=True)) for tree in done.trees
        ]
        found = {"written": done.written, "unchanged": done.unchanged, "next": follow}
        shown = {} if done.proven is None else done.proven.as_dict()
        write_json({"bundle": done.folder, "name": done.name, "trees": trees, **found, **shown})
        ctx.exit(ProofError.exit_code if failed else 0)
    click.echo(f"{done.folder}: {changes(done.folder, done.written)}")
    for prefix, kind, functions in done.trees:
        if functions:
            click.echo(f"  {prefix} ({kind}): {', '.join(functions)}")
    if done.proven is not None:
        _print(done.proven)
    click.echo(f"next: {follow}, then read {done.folder / 'README.md'}")
    ctx.exit(ProofError.exit_code if failed else 0)


def _print(proven: Proven) -> None:
    """What every tool showed, what failed, and what did not run."""
    from rich.table import Table

    table = Table()
    for heading in ("Tool", "Version", "Shown", "Verdict"):
        table.add_column(heading)
    table.add_column("Seconds", justify="right")
    for record in proven.records:
        verdict = record.verdict.value
        seconds = f"{record.seconds:.1f}"
        table.add_row(record.tool, record.version, record.shown, verdict, seconds)
    show_table(table)
    for record in proven.records:
        for finding in record.findings:
            click.echo(f"  {record.tool}: {finding}")
    for record in proven.missing:
        click.echo(f"Did not run: {record.tool}: {record.shown}.")
