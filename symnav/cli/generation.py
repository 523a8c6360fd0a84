"""The verbs that make and check a generated package: generate, build, check."""

from __future__ import annotations

from pathlib import Path

import click

from symnav.cli.console import Verb, changes, progress, without_collector, write_json
from symnav.errors import HandEditedError, StaleError

_EXIT_CODES = {"fresh": 0, "stale": StaleError.exit_code, "hand-edited": HandEditedError.exit_code}
_FOLDER = click.Path(path_type=Path, file_okay=False)


@click.command(
    cls=Verb,
    epilog="""\b
Examples:
  symnav generate rover.toml --out generated      writes generated/rover
  symnav generate farrell_tightly_coupled --out /tmp/models
""",
)
@click.argument("spec")
@click.option(
    "--out",
    type=_FOLDER,
    default=Path("generated"),
    show_default=True,
    metavar="DIR",
    help="Folder that receives the package.",
)
@click.option("--force", is_flag=True, help="Write over changes made by hand.")
def generate(spec: str, out: Path, force: bool, as_json: bool) -> None:
    """Derive SPEC and write its package.

    The package, C and NumPy, goes to a folder of its own in DIR. SPEC is a file or the name of a
    shipped model (symnav list). Nothing is written when the specification has mistakes.
    """
    with without_collector(), progress() as reporter:
        from symnav import pipeline

        loaded = pipeline.load(spec)
        done = pipeline.generate(loaded, out, progress=reporter.stage, force=force)
    if as_json:
        write_json(
            {
                "package": done.package,
                "written": done.written,
                "unchanged": done.unchanged,
                "seconds": done.seconds,
            }
        )
        return
    what = changes(done.package, done.written)
    click.echo(f"{done.package}: {what} ({sum(done.seconds.values()):.1f} s)")


@click.command(
    cls=Verb,
    epilog="""\b
Examples:
  symnav build generated/rover
  symnav build generated/rover --native           for this processor only
""",
)
@click.argument("package", metavar="DIR", type=click.Path(path_type=Path))
@click.option(
    "--native", is_flag=True, help="Let the compiler use every instruction of this processor."
)
def build(package: Path, native: bool, as_json: bool) -> None:
    """Compile the C of a generated package.

    The extension lands beside the C in DIR, where importing the package finds it.
    """
    from symnav import pipeline

    pipeline.check(package)  # refuses what is no generated package
    with progress() as reporter:
        result = pipeline.build(package, native=native, progress=reporter.stage)
    if as_json:
        write_json({"package": package, "modules": result.modules, "compiled": result.compiled})
        return
    for name, module in result.modules.items():
        what = "compiled" if name in result.compiled else "up to date"
        click.echo(f"{package / module.name}: {what}")


@click.command(
    cls=Verb,
    epilog="""\b
Examples:
  symnav check generated/rover                    are the files as they were written?
  symnav check generated/rover rover.toml         and is the specification still the same?
""",
)
@click.argument("package", metavar="DIR", type=click.Path(path_type=Path))
@click.argument("spec", required=False)
@click.pass_context
def check(ctx: click.Context, package: Path, spec: str | None, as_json: bool) -> None:
    """Say whether a package is fresh, stale or hand-edited.

    Without SPEC, the files are compared with what generation wrote; with it, the specification
    is compared as well. Exits with 0, 4 or 5.
    """
    from symnav import pipeline

    report = pipeline.check(package, None if spec is None else pipeline.load(spec))
    if as_json:
        found = {"state": report.state, "files": report.files, "reasons": report.reasons}
        write_json({"package": package, **found})
    else:
        click.echo(f"{package}: {report.state}")
        for reason in report.reasons:
            click.echo(f"  {reason}")
    ctx.exit(_EXIT_CODES[report.state])
