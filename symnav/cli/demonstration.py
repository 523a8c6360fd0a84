"""The verb that shows the whole path on recorded observations: demo."""

from __future__ import annotations

from pathlib import Path
from typing import TYPE_CHECKING

import click

from symnav.cli.console import Verb, console, progress, show_columns, show_table, write_json
from symnav.cli.proof import SEED
from symnav.errors import ProofError

if TYPE_CHECKING:
    from symnav.demo.wiring import Demonstration

SPEC = "single_point"
SAMPLES = 20


@click.command(
    cls=Verb,
    epilog="""\b
Examples:
  symnav demo                                     the shipped model single_point
  symnav demo my_receiver.toml --out /tmp/demo
""",
)
@click.argument("spec", default=SPEC)
@click.option(
    "--out",
    type=click.Path(path_type=Path, file_okay=False),
    default=Path("generated"),
    show_default=True,
    metavar="DIR",
    help="Folder that receives the package.",
)
@click.option(
    "--samples",
    type=click.IntRange(min=4),
    default=SAMPLES,
    show_default=True,
    help="Random states per function in the proof.",
)
@click.option(
    "--seed",
    type=click.IntRange(min=0),
    default=SEED,
    show_default=True,
    help="Seed of the random states.",
)
@click.pass_context
def demo(ctx: click.Context, spec: str, out: Path, samples: int, seed: int, as_json: bool) -> None:
    """Position a recorded GPS receiver with generated code.

    SPEC is generated, built and verified first. It needs a broadcast_orbit and two pseudorange
    measurements, with and without the Sagnac term, over an earth-fixed position and a clock bias
    in metres. A minute of recorded GPS observations comes with symnav. Exits with 3 when the
    proof fails or the promised accuracy is not reached.
    """
    from symnav.demo.wiring import demonstrate

    with progress() as reporter:
        outcome = demonstrate(
            spec, out, samples=samples, seed=seed, stage=reporter.stage, count=reporter.count
        )
    if as_json:
        write_json(outcome.as_dict())
    else:
        _show(outcome)
    ctx.exit(0 if outcome.passed else ProofError.exit_code)


def _show(outcome: Demonstration) -> None:
    from symnav.demo.table import summary_line, summary_table

    show_columns(_steps(outcome))
    click.echo()
    outcome.sheet.render(console())
    click.echo()
    show_table(summary_table(outcome.positioning))
    click.echo(f"real data: {summary_line(outcome.positioning)}")
    for sentence in outcome.positioning.shortfalls():
        click.echo(f"promise not kept: {sentence}", err=True)


def _steps(outcome: Demonstration) -> list[tuple[str, str]]:
    """What happened before the proof."""
    spec = outcome.spec
    blocks = " ".join(f"{block.name}[{block.storage_size}]" for block in spec.layout.blocks)
    seconds = sum(outcome.generated.seconds.values())
    extension = "no C compiler: the package runs on NumPy; symnav doctor says how to get one"
    if outcome.built is not None:
        extension = " and ".join(sorted(outcome.built.modules))
    return [
        ("model", f"{spec.name}: {blocks}"),
        ("functions", " ".join(entry.name for entry in spec.entries)),
        ("generate", f"{outcome.generated.package} ({seconds:.1f} s)"),
        ("build", extension),
        ("back end", outcome.backend),
    ]
