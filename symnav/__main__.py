"""Runs the command line: ``python -m symnav``."""

from symnav.cli import main

main(prog_name="symnav")
