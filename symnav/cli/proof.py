"""The verb that proves a specification: verify."""

from __future__ import annotations

from pathlib import Path

import click

from symnav.cli.console import Verb, console, progress, write_json
from symnav.errors import ProofError

SAMPLES = 200
SEED = 1


@click.command(
    cls=Verb,
    epilog="""\b
Examples:
  symnav verify rover.toml
  symnav verify farrell_tightly_coupled --samples 1000 --seed 7
  symnav verify rover.toml --reference tests/reference
""",
)
@click.argument("spec")
@click.option(
    "--reference",
    type=click.Path(path_type=Path, exists=True, file_okay=False),
    metavar="DIR",
    help="Compare with the references in DIR as well.",
)
@click.option(
    "--samples",
    type=click.IntRange(min=4),
    default=SAMPLES,
    show_default=True,
    help="States per function, random or with several edges; one per single edge comes on top.",
)
@click.option(
    "--seed",
    type=click.IntRange(min=0),
    default=SEED,
    show_default=True,
    help="Seed of the random states.",
)
@click.pass_context
def verify(
    ctx: click.Context,
    spec: str,
    reference: Path | None,
    samples: int,
    seed: int,
    as_json: bool,
) -> None:
    """Prove generated code and print the proof sheet.

    C, NumPy, CasADi's own C, 50-digit arithmetic and differences of the unsimplified equation are
    compared at random, edge and singular states inside the declared ranges. With 50 digits, at one
    state for every edge and at eight others; the sheet says how many. Exits with 3 when a
    comparison fails.
    """
    from symnav import pipeline

    with progress() as reporter:
        sheet = pipeline.verify(
            pipeline.load(spec),
            samples=samples,
            seed=seed,
            reference=reference,
            progress=reporter.stage,
        )
    if as_json:
        write_json(sheet.as_dict())
    else:
        sheet.render(console())
    ctx.exit(0 if sheet.passed else ProofError.exit_code)
