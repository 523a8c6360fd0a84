"""The command line: one verb per step, each a thin shell over ``symnav.pipeline``.

The modules of this package import click and nothing heavier; SymPy, CasADi, pydantic and rich are
imported by the verb that needs them, so that ``symnav --help`` answers at once.
"""

from __future__ import annotations

import gc

import click

from symnav import __version__
from symnav.cli.demonstration import demo
from symnav.cli.exporting import export
from symnav.cli.generation import build, check, generate
from symnav.cli.measurement import bench
from symnav.cli.project import doctor, list_models, new
from symnav.cli.proof import verify

__all__ = ["main", "run"]


@click.group(
    context_settings={"help_option_names": ["-h", "--help"]},
    epilog="""\b
Examples:
  symnav demo                                 the whole path on recorded GPS data
  symnav new rover                            a specification to edit: rover.toml
  symnav generate rover.toml --out generated
  symnav verify rover.toml

\b
Exit codes:
  0 fine, 2 the user's input, 3 a failed proof, 4 stale, 5 hand-edited, 1 other
""",
)
@click.version_option(__version__, prog_name="symnav", message="%(prog)s %(version)s")
def main() -> None:
    """Turn a navigation state vector into code that is derived, compiled and proven."""


for _verb in (new, generate, build, verify, bench, export, check, list_models, doctor, demo):
    main.add_command(_verb)


def run() -> None:
    """The command line as a process of its own, which has nothing to clean up when it ends.

    At the end Python looks through every object for cycles, for a tenth of the time of a short
    verb. What is left then goes with the process.
    """
    try:
        main(prog_name="symnav")
    finally:
        gc.freeze()
