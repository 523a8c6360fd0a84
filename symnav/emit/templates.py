"""The one loader of templates.

Templates are named like the files they make and hold no logic beyond loops and macros. In an
installed package they stand in ``symnav/templates``; in a checkout, beside the package.
"""

from __future__ import annotations

from functools import cache
from importlib.resources import files
from pathlib import Path

import jinja2

from symnav.emit.caching import CompiledTemplates


@cache
def _environment() -> jinja2.Environment:
    """The environment every template is rendered in; an undefined name is an error."""
    return jinja2.Environment(
        loader=jinja2.FileSystemLoader(directory()),
        bytecode_cache=CompiledTemplates(),
        undefined=jinja2.StrictUndefined,
        trim_blocks=True,
        lstrip_blocks=True,
        keep_trailing_newline=True,
        autoescape=False,
    )


@cache
def directory() -> Path:
    """Where the templates are."""
    installed = Path(str(files("symnav") / "templates"))
    return installed if installed.is_dir() else Path(__file__).resolve().parents[2] / "templates"


def plain(template: str) -> str:
    """A file that depends on nothing, as it is: most files of a package, which need no reading."""
    return (directory() / template).read_text(encoding="utf-8")


def render(template: str, **context: object) -> str:
    """Render one template.

    Args:
        template: its path below ``templates/``, such as ``c/kernel.h.j2``.
        **context: every name the template mentions.

    Returns:
        The rendered text.
    """
    return _environment().get_template(template).render(**context)
