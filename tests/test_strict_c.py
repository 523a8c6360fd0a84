"""The C of every shipped model compiles without a warning, in double and in single precision."""

from __future__ import annotations

import shutil
import subprocess
from dataclasses import replace
from pathlib import Path

import pytest

from symnav import ir, pipeline
from symnav.emit import c
from symnav.lower import casadi
from symnav.lower.module import module, through
from symnav.lower.passes.inline import inline
from symnav.lower.passes.reciprocals import share_reciprocals

STRICT = (
    "-std=c99", "-O2", "-Wall", "-Wextra", "-Wpedantic", "-Wconversion", "-Wdouble-promotion",
    "-Wstrict-prototypes", "-Wmissing-prototypes", "-Werror",
)  # fmt: skip
MODELS = [name for name, _ in pipeline.shipped()]


@pytest.mark.skipif(shutil.which("gcc") is None, reason="needs gcc")
@pytest.mark.parametrize("scalar", list(ir.Scalar))
@pytest.mark.parametrize("model", MODELS)
def test_no_warning(model: str, scalar: ir.Scalar, tmp_path: Path) -> None:
    spec = pipeline.load(model)
    # Whatever may be single precision is emitted in it, asked for or not.
    entries = [
        e if e.model.always_double else replace(e, scalars=("double", "float"))
        for e in spec.entries
    ]
    spec = replace(spec, entries=tuple(entries))
    derived = pipeline.derive(spec)
    lowered = [casadi.lower(spec, d) for d in (*derived.layout, *derived.entries)]
    files = c.emit(module(spec, through(lowered, share_reciprocals, inline), scalar))
    for path, text in files.items():
        target = tmp_path / path
        target.parent.mkdir(parents=True, exist_ok=True)
        target.write_text(text)
    sources = [str(tmp_path / path) for path in files if path.endswith(".c")]
    assert sources
    for source in sources:
        command = ["gcc", *STRICT, f"-I{tmp_path / 'c/include'}", "-c", source, "-o", "/dev/null"]
        result = subprocess.run(command, capture_output=True, text=True, check=False)
        assert result.returncode == 0, result.stderr
