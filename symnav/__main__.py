"""Runs the command line: ``python -m symnav``."""

from symnav.cli import run

run()
