"""The verbs around a project: new, list, doctor."""

from __future__ import annotations

import platform
import sys
from importlib.metadata import version
from pathlib import Path

import click

from symnav import __version__
from symnav.cli.console import Verb, show_columns, write_json
from symnav.errors import BuildError, InputError

_LIBRARIES = ("numpy", "sympy", "casadi", "cffi", "setuptools", "jinja2", "pydantic", "mpmath")


@click.command(
    cls=Verb,
    epilog="""\b
Examples:
  symnav new rover                                writes rover.toml
  symnav new rover --out specs/rover.toml
""",
)
@click.argument("name")
@click.option(
    "--out",
    type=click.Path(path_type=Path, dir_okay=False),
    metavar="FILE",
    help="File to write; NAME.toml unless given.",
)
def new(name: str, out: Path | None, as_json: bool) -> None:
    """Write a commented starter specification.

    NAME becomes the name of the generated package and the prefix of its C symbols.
    """
    from symnav.emit.templates import render
    from symnav.naming import Use, fault

    refused = fault(name, Use.PACKAGE)
    if refused is not None:
        raise InputError(refused)
    file = out if out is not None else Path(f"{name}.toml")
    text = render("starter.toml.j2", name=name)
    try:
        with file.open("x", encoding="utf-8") as stream:
            stream.write(text)
    except FileExistsError as error:
        raise InputError(f"{file} exists already; remove it or name another with --out") from error
    if as_json:
        write_json({"file": file})
    else:
        click.echo(f"wrote {file}; next: symnav generate {file} --out generated")


@click.command(name="list", cls=Verb)
def list_models(as_json: bool) -> None:
    """List the shipped specifications.

    Each name can stand wherever a verb takes SPEC.
    """
    from symnav import pipeline

    models = pipeline.shipped()
    if as_json:
        write_json({"models": [{"name": name, "title": title} for name, title in models]})
    else:
        show_columns(models)


@click.command(cls=Verb)
def doctor(as_json: bool) -> None:
    """Show versions, compiler and folders."""
    facts = _facts()
    if as_json:
        write_json(facts)
    else:
        show_columns([(name, "-" if value is None else value) for name, value in facts.items()])


def _facts() -> dict[str, str | None]:
    from symnav.build import cache_directory
    from symnav.emit.templates import directory

    compiler, advice = _compiler()
    return {
        "symnav": __version__,
        "python": f"{platform.python_version()} ({sys.executable})",
        "platform": platform.platform(),
        **{library: version(library) for library in _LIBRARIES},
        "compiler": compiler,
        **({} if advice is None else {"advice": advice}),
        "templates": str(directory()),
        "cache": str(cache_directory()),
    }


def _compiler() -> tuple[str | None, str | None]:
    """The C compiler, or how to get one; without it, generated packages run on NumPy."""
    from symnav.build import find_compiler

    try:
        found = find_compiler()
    except BuildError as error:
        return None, str(error)
    return f"{' '.join(found.command)} ({found.identity})", None
