"""The manifest: the same bytes for the same files, and what a check finds."""

from __future__ import annotations

import hashlib
import json
from pathlib import Path

import pytest

import symnav
from symnav import errors
from symnav.emit import manifest

TEXT = {"a.py": "a = 1\n", "c/src/a.c": "int a;\n"}
SPEC = "5" * 64
ORIGIN = manifest.Origin("package a", SPEC, ("double",))
BOTH = manifest.Origin("package a", SPEC, ("double", "float"))


@pytest.fixture
def package(tmp_path: Path) -> Path:
    """A package with a manifest."""
    for path, text in {**TEXT, **manifest.emit(ORIGIN, TEXT)}.items():
        (tmp_path / path).parent.mkdir(parents=True, exist_ok=True)
        (tmp_path / path).write_text(text)
    return tmp_path


def test_content() -> None:
    """Digests, generator, scalar types; no clock, no path, no order of arrival."""
    (text,) = manifest.emit(BOTH, TEXT).values()
    assert json.loads(text) == {
        "generator": f"symnav {symnav.__version__}",
        "holds": "package a",
        "specification": SPEC,
        "scalars": ["double", "float"],
        "files": {path: hashlib.sha256(own.encode()).hexdigest() for path, own in TEXT.items()},
    }
    turned = dict(reversed(TEXT.items()))
    assert manifest.emit(BOTH, turned)["manifest.json"] == text


def test_fresh(package: Path) -> None:
    """Nothing changed, with and without a specification to compare."""
    for digest in (None, SPEC):
        assert manifest.check(package, digest) == manifest.CheckReport(manifest.State.FRESH, (), ())
    assert manifest.listed(package) == ("a.py", "c/src/a.c", "manifest.json")


def test_what_building_leaves_does_not_count(package: Path) -> None:
    """Extensions, records, caches and hidden files."""
    for path in (
        "_build.json", "_build.log", "_a_0123.cpython-311-x86_64-linux-gnu.so", "_a_0123.pyd",
        "__pycache__/a.cpython-311.pyc", ".mypy_cache/x",
    ):  # fmt: skip
        (package / path).parent.mkdir(exist_ok=True)
        (package / path).write_text("x")
    assert manifest.check(package, SPEC).state == "fresh"


@pytest.mark.parametrize(
    ("path", "content", "what"),
    [
        ("a.py", "a = 2\n", "changed"),
        ("a.py", "a = 1\r\n", "changed"),
        ("c/src/a.c", None, "removed"),
        ("c/src/b.c", "int b;\n", "added"),
    ],
)
def test_hand_edited(package: Path, path: str, content: str | None, what: str) -> None:
    """Changed, removed and added files are named, whatever the specification says."""
    if content is None:
        (package / path).unlink()
    else:
        (package / path).write_bytes(content.encode())
    for digest in (None, SPEC, "6" * 64):
        report = manifest.check(package, digest)
        assert report.state == "hand-edited"
        assert report.files == (path,)
        assert report.reasons == (f"{path} was {what}",)


def test_stale(package: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    """Another specification or another generator."""
    report = manifest.check(package, "6" * 64)
    assert (report.state, report.files) == ("stale", ())
    assert "specification changed" in report.reasons[0]
    monkeypatch.setattr("symnav.emit.manifest._GENERATOR", "symnav 999")
    report = manifest.check(package, None)
    assert report.state == "stale"
    assert "this is symnav 999" in report.reasons[0]


def test_not_a_package(tmp_path: Path) -> None:
    """A missing or damaged manifest is told as such."""
    assert manifest.listed(tmp_path) == ()
    with pytest.raises(errors.InputError, match=r"holds no manifest\.json"):
        manifest.check(tmp_path, None)
    for text in ("{", "{}", '{"generator": "x", "specification": "y", "files": 3}'):
        (tmp_path / "manifest.json").write_text(text)
        with pytest.raises(errors.InputError, match=r"cannot be read; .* symnav generate --force"):
            manifest.check(tmp_path, None)
        assert manifest.listed(tmp_path) == ()
