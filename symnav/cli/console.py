"""What the verbs share: ``--json``, errors and exit codes, tables and progress."""

from __future__ import annotations

import gc
import json
import math
import sys
from collections.abc import Iterator, Mapping, Sequence
from contextlib import contextmanager
from dataclasses import dataclass
from pathlib import Path
from typing import TYPE_CHECKING, Any

import click

from symnav.errors import SpecError, SymnavError

if TYPE_CHECKING:
    from rich.console import Console
    from rich.progress import Progress, TaskID
    from rich.table import Table

PLAIN_WIDTH = 150
"""Columns of tables that do not go to a terminal."""


class Verb(click.Command):
    """A command with ``--json`` that turns symnav's errors into one message and an exit code."""

    def __init__(self, *args: Any, **kwargs: Any) -> None:
        super().__init__(*args, **kwargs)
        self.params.append(
            click.Option(
                ["--json", "as_json"],
                is_flag=True,
                help="Write one JSON object to standard output.",
            )
        )

    def invoke(self, ctx: click.Context) -> Any:
        """Runs the verb; errors the user can act on end in their exit code."""
        try:
            return super().invoke(ctx)
        except BrokenPipeError:
            raise  # the reader of our output went away, which click ends quietly
        except (SymnavError, OSError) as error:
            code = error.exit_code if isinstance(error, SymnavError) else 1
            click.echo(f"symnav: {_message(error)}", err=True)
            if ctx.params.get("as_json"):
                write_json({"error": _described(error), "exit_code": code})
            ctx.exit(code)


@contextmanager
def without_collector() -> Iterator[None]:
    """Leave unused memory alone while a verb runs that ends before it matters.

    Importing and deriving make hundreds of thousands of objects that stay; looking through them
    for cycles again and again takes a tenth of a short process.
    """
    enabled = gc.isenabled()
    gc.disable()
    try:
        yield
    finally:
        if enabled:
            gc.enable()


def _message(error: SymnavError | OSError) -> str:
    if isinstance(error, OSError) and error.strerror:
        return f"{error.filename}: {error.strerror}" if error.filename else error.strerror
    return str(error)


def _described(error: SymnavError | OSError) -> dict[str, Any]:
    described: dict[str, Any] = {"kind": type(error).__name__, "message": _message(error)}
    if isinstance(error, SpecError):
        described["problems"] = [
            {"path": problem.path, "message": problem.message} for problem in error.problems
        ]
    return described


def changes(folder: Path, paths: Sequence[str]) -> str:
    """How many files were written and how many removed, in words.

    Args:
        folder: what the paths are relative to.
        paths: of what was new, different or removed.
    """
    written = sum((folder / path).is_file() for path in paths)
    removed = len(paths) - written
    words = [f"{written} file{'' if written == 1 else 's'} written"]
    words += [f"{removed} removed"] if removed else []
    return ", ".join(words) if paths else "unchanged"


def write_json(value: Mapping[str, Any]) -> None:
    """Writes one JSON object; numbers that JSON has no word for become strings."""
    click.echo(json.dumps(_plain(value), indent=2, allow_nan=False))


def _plain(value: Any) -> Any:
    if isinstance(value, Mapping):
        return {str(key): _plain(item) for key, item in value.items()}
    if isinstance(value, list | tuple):
        return [_plain(item) for item in value]
    if isinstance(value, Path):
        return str(value)
    if isinstance(value, float) and not math.isfinite(value):
        return str(value)
    return value


def console() -> Console:
    """The console for results: as wide as the terminal, or plain text of a fixed width."""
    from rich.console import Console

    if sys.stdout.isatty():
        return Console()
    return Console(width=PLAIN_WIDTH, color_system=None, highlight=False)


def show_table(table: Table) -> None:
    """Prints a table, with lines only on a terminal."""
    from rich import box

    target = console()
    if not target.is_terminal:
        table.box = box.ASCII2
    target.print(table)


def show_columns(rows: Sequence[Sequence[str]]) -> None:
    """Prints rows of text in aligned columns."""
    widths = [max(len(row[k]) for row in rows) for k in range(len(rows[0]))] if rows else []
    for row in rows:
        cells = [cell.ljust(width) for cell, width in zip(row, widths, strict=True)]
        click.echo("  ".join(cells).rstrip())


@dataclass
class Reporter:
    """Tells a waiting user what is going on; says nothing when nobody watches."""

    bar: Progress | None = None
    task: TaskID | None = None

    def stage(self, message: str) -> None:
        """Names the work that begins."""
        self._show(message, None, None)

    def count(self, label: str, done: int, total: int) -> None:
        """Says how much of a countable piece of work is done."""
        self._show(label, done, total)

    def _show(self, message: str, done: int | None, total: int | None) -> None:
        if self.bar is None:
            return
        if self.task is None:
            self.task = self.bar.add_task(message, total=total)
        self.bar.update(self.task, description=message, completed=done or 0, total=total)


@contextmanager
def progress() -> Iterator[Reporter]:
    """Shows progress on standard error for as long as the block runs, if that is a terminal."""
    if not sys.stderr.isatty():
        yield Reporter()
        return
    from rich.console import Console
    from rich.progress import BarColumn, Progress, SpinnerColumn, TextColumn, TimeElapsedColumn

    columns = (
        SpinnerColumn(),
        TextColumn("{task.description}"),
        BarColumn(bar_width=24),
        TimeElapsedColumn(),
    )
    with Progress(*columns, console=Console(stderr=True), transient=True) as bar:
        yield Reporter(bar)
