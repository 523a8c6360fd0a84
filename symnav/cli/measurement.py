"""The verb that measures generated code: bench."""

from __future__ import annotations

import click

from symnav.cli.console import Verb, progress, show_columns, write_json

FLAG_SETS = ("o2", "v3", "native")


@click.command(
    cls=Verb,
    epilog="""\b
Examples:
  symnav bench rover.toml
  symnav bench rover.toml --flags native --items 32
""",
)
@click.argument("spec")
@click.option(
    "--flags",
    type=click.Choice(FLAG_SETS),
    default="v3",
    show_default=True,
    help="Compiler flags: -O2, -O3 for AVX2 machines, or -O3 for this one.",
)
@click.option(
    "--items",
    type=click.IntRange(min=1),
    default=8,
    show_default=True,
    help="Satellites in each call of a mapped function.",
)
@click.option(
    "--repetitions",
    type=click.IntRange(min=1),
    default=15,
    show_default=True,
    help="Bursts of each form; the median counts.",
)
def bench(spec: str, flags: str, items: int, repetitions: int, as_json: bool) -> None:
    """Time the C of SPEC: nanoseconds, operations, code and stack of every function.

    Dense, non-zeros and batch forms are called in turn over the same random inputs. The last
    column compares with the last run of the same specification and flags on this machine.
    """
    from symnav import pipeline
    from symnav.bench import bench as measure

    with progress() as reporter:
        rows = measure(
            pipeline.load(spec),
            flags=flags,
            items=items,
            repetitions=repetitions,
            progress=reporter.stage,
        )
    if as_json:
        write_json({"spec": spec, "flags": flags, "functions": [vars(row) for row in rows]})
        return
    table = [["function", "form", "items", "ns", "operations", "code bytes", "stack bytes", "then"]]
    table += [
        [
            row.function, row.form, "" if row.items is None else str(row.items), f"{row.ns:.1f}",
            str(row.operations), str(row.code), str(row.stack),
            "" if row.change is None else f"x {row.change:.2f}",
        ]
        for row in rows
    ]  # fmt: skip
    show_columns(table)
    shared = sorted({row.function for row in rows if not row.alone})
    if shared:
        names = ", ".join(shared)
        click.echo(f"The core did something else while {names} ran: these times are too long.")
