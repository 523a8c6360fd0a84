"""What generation writes, and what it leaves alone."""

from __future__ import annotations

import hashlib
import json
from pathlib import Path

import pytest

from symnav import pipeline
from symnav.errors import HandEditedError, InputError
from symnav.spec import loads
from symnav.spec.records import Spec


@pytest.fixture(scope="module")
def spec() -> Spec:
    return pipeline.load("reference_relative")


def contents(folder: Path) -> dict[str, bytes]:
    return {str(p.relative_to(folder)): p.read_bytes() for p in folder.rglob("*") if p.is_file()}


def test_a_second_generation_writes_nothing(spec: Spec, tmp_path: Path) -> None:
    first = pipeline.generate(spec, tmp_path)
    assert first.written and not first.unchanged
    before = contents(tmp_path)
    again = pipeline.generate(spec, tmp_path)
    assert again.unchanged and again.written == ()
    assert contents(tmp_path) == before


def test_changes_by_hand_are_kept(spec: Spec, tmp_path: Path) -> None:
    package = pipeline.generate(spec, tmp_path).package
    edited = package / "numpy.py"
    edited.write_text(edited.read_text() + "# mine\n")
    before = contents(tmp_path)
    with pytest.raises(HandEditedError, match=r"numpy\.py was changed"):
        pipeline.generate(spec, tmp_path)
    assert contents(tmp_path) == before
    assert pipeline.generate(spec, tmp_path, force=True).written == ("numpy.py",)
    assert pipeline.check(package, spec).state == "fresh"


def test_a_folder_of_somebody_else_is_left_alone(spec: Spec, tmp_path: Path) -> None:
    own = tmp_path / spec.name / "notes.txt"
    own.parent.mkdir()
    own.write_text("mine")
    with pytest.raises(InputError, match="not generated"):
        pipeline.generate(spec, tmp_path)
    assert list(own.parent.iterdir()) == [own]


def test_a_manifest_cannot_name_files_elsewhere(spec: Spec, tmp_path: Path) -> None:
    package = pipeline.generate(spec, tmp_path).package
    outside = tmp_path / "precious.txt"
    outside.write_text("keep")
    manifest = json.loads((package / "manifest.json").read_text())
    manifest["files"]["../precious.txt"] = "0" * 64
    (package / "manifest.json").write_text(json.dumps(manifest))
    with pytest.raises(InputError, match=r"manifest\.json cannot be read"):
        pipeline.generate(spec, tmp_path)
    pipeline.generate(spec, tmp_path, force=True)
    assert outside.read_text() == "keep"


@pytest.mark.parametrize("damaged", ["", "{", "[]", "\x00"])
def test_force_repairs_a_damaged_manifest(damaged: str, spec: Spec, tmp_path: Path) -> None:
    """Every other way says that force is the way out."""
    package = pipeline.generate(spec, tmp_path).package
    (package / "manifest.json").write_text(damaged)
    for refused in (lambda: pipeline.generate(spec, tmp_path), lambda: pipeline.check(package)):
        with pytest.raises(InputError, match="symnav generate --force"):
            refused()
    assert pipeline.generate(spec, tmp_path, force=True).written == ("manifest.json",)
    assert pipeline.check(package, spec).state == "fresh"


def test_files_no_longer_generated_are_removed(spec: Spec, tmp_path: Path) -> None:
    package = pipeline.generate(spec, tmp_path).package
    text = (package / "manifest.json").read_text()
    old = package / "c" / "src" / "old.c"
    old.write_text("/* of an earlier generation */\n")
    manifest = json.loads(text)
    manifest["files"]["c/src/old.c"] = digest_of(old)
    (package / "manifest.json").write_text(json.dumps(manifest))
    assert "c/src/old.c" in pipeline.generate(spec, tmp_path).written
    assert not old.exists()


def digest_of(path: Path) -> str:
    return hashlib.sha256(path.read_bytes()).hexdigest()


def test_importing_something_else_says_so(tmp_path: Path) -> None:
    with pytest.raises(InputError, match="not a generated package"):
        pipeline.import_package(tmp_path)


STATELESS = {
    "orbit": "[[measurement]]\nname = 'orbit'\nmodel = 'broadcast_orbit'\n",
    "square": "[[input]]\nname = 'u'\nkind = 'scalar'\nunit = '1'\nrange = [-3, 3]\n"
    "[[measurement]]\nname = 'square'\nequation = ['u*u']\njacobians = ['u']\n",
    "items": "[[input]]\nname = 'u'\nkind = 'scalar'\nunit = '1'\nrange = [-3, 3]\nitem = true\n"
    "[[measurement]]\nname = 'square'\nequation = ['u*u']\njacobians = ['u']\n"
    "difference = 'single'\n",
}


@pytest.mark.parametrize("text", STATELESS.values(), ids=STATELESS)
def test_a_specification_without_a_state(text: str, tmp_path: Path) -> None:
    """Its functions are generated, built and proven; there is nothing to retract."""
    spec = loads(f"name = 'alone'\n{text}")
    sheet = pipeline.verify(spec, samples=20, out=tmp_path)
    assert sheet.passed, sheet
    package = pipeline.import_package(tmp_path / "alone")
    assert not {"State", "retract", "local"} & set(package.__all__)
    assert "retract" not in "".join(contents(tmp_path / "alone" / "c"))
