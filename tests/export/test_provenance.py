"""Where a bundle comes from can be shown: digests, bill of materials, specification, same bytes."""

from __future__ import annotations

import hashlib
import json
import re
import sys
from pathlib import Path
from typing import Any

import pytest

from symnav import pipeline
from symnav.export.documents import provenance
from symnav.spec.builder import build, frame, measurement, vector
from tests.export.bundles import ALL, OUTER, QUICK, bundle_of, cases, files, run

FLOAT = tuple(case for case in ALL if case[1] == "float")


def bill_of(folder: Path) -> Any:
    return json.loads((folder / provenance.BILL).read_text())


@pytest.mark.parametrize(("model", "scalar"), cases((*QUICK, OUTER)))
def test_manifest_lists_every_file_and_the_specification(model: str, scalar: str) -> None:
    folder = bundle_of(model, scalar)
    manifest = json.loads((folder / "manifest.json").read_text())
    found = files(folder)
    del found["manifest.json"]
    digests = {path: hashlib.sha256(content).hexdigest() for path, content in found.items()}
    assert manifest["files"] == digests
    assert manifest["specification"] == digests["spec.json"]
    kind, _, guards = scalar.partition(" ")
    chosen = {"tolerance": None, "batches": False, "guards": guards or None}
    assert manifest["options"] == {"scalar": kind, **chosen}
    for path, content in found.items():
        if path.endswith((".c", ".h")) and path.startswith(("src/", "include/")):
            assert manifest["specification"][:16].encode() in content, path


@pytest.mark.parametrize(("model", "scalar"), cases())
def test_bill_of_materials_is_valid_spdx(model: str, scalar: str) -> None:
    parsing = pytest.importorskip("spdx_tools.spdx.parser.parse_anything")
    validation = pytest.importorskip("spdx_tools.spdx.validation.document_validator")
    document = parsing.parse_file(str(bundle_of(model, scalar) / provenance.BILL))
    assert validation.validate_full_spdx_document(document) == []
    assert document.creation_info.spdx_version == "SPDX-2.3"


@pytest.mark.parametrize(("model", "scalar"), cases())
def test_bill_of_materials_is_true(model: str, scalar: str) -> None:
    folder = bundle_of(model, scalar)
    bill, found = bill_of(folder), files(folder)
    for path in ("manifest.json", provenance.BILL):
        del found[path]
    listed = {one["fileName"].removeprefix("./"): one for one in bill["files"]}
    assert listed.keys() == found.keys()
    for path, content in found.items():
        sums = {each["algorithm"]: each["checksumValue"] for each in listed[path]["checksums"]}
        assert sums["SHA1"] == hashlib.sha1(content).hexdigest()
        assert sums["SHA256"] == hashlib.sha256(content).hexdigest()
    sorted_sums = sorted(hashlib.sha1(content).hexdigest() for content in found.values())
    code = hashlib.sha1("".join(sorted_sums).encode()).hexdigest()
    package = bill["packages"][0]
    assert package["packageVerificationCode"]["packageVerificationCodeValue"] == code
    identifiers = [one["SPDXID"] for one in bill["files"]]
    assert len(set(identifiers)) == len(identifiers)


def test_a_changed_file_changes_the_bill() -> None:
    folder = bundle_of(*QUICK[0])
    text = {path: content.decode() for path, content in files(folder).items()}
    before = provenance.verification_code(text)
    assert provenance.verification_code({**text, "README.md": "mine"}) != before


@pytest.mark.parametrize(("model", "scalar"), cases(QUICK[1:], FLOAT))
def test_its_own_specification_makes_it_again(model: str, scalar: str, tmp_path: Path) -> None:
    folder = bundle_of(model, scalar)
    text = (folder / "README.md").read_text()
    (command,) = re.findall(r"`symnav (export spec.toml [^`]*)`", text)
    words = command.replace("DIR", str(tmp_path / "again")).split()
    run([sys.executable, "-m", "symnav", *words], folder)
    assert files(tmp_path / "again") == files(folder)
    told = run([sys.executable, "-m", "symnav", "check", ".", "spec.toml"], folder)
    assert "fresh" in told


def test_an_equation_in_python_is_said_to_have_no_file(tmp_path: Path) -> None:
    spec = build(
        "handmade",
        frame("n", "ned"),
        vector("position", 3, "m", frame="n"),
        measurement("z", equation=lambda q: q.position),
    )
    pipeline.export(spec, tmp_path)
    assert not (tmp_path / "spec.toml").exists()
    assert "written in Python" in (tmp_path / "README.md").read_text()
    assert b"spec.toml" not in (tmp_path / provenance.BILL).read_bytes()
    assert (tmp_path / "spec.json").read_text() == spec.text


@pytest.mark.parametrize(("model", "scalar"), cases(QUICK[:1], QUICK))
def test_bytes_do_not_depend_on_hashes_or_folders(model: str, scalar: str, tmp_path: Path) -> None:
    expected = files(bundle_of(model, scalar))
    for seed in ("0", "1", "2"):
        folder = tmp_path / f"elsewhere {seed}"
        words = [sys.executable, "-m", "symnav", "export", model, "--scalar", scalar, "--to"]
        run([*words, folder], tmp_path, {"PYTHONHASHSEED": seed, "SOURCE_DATE_EPOCH": seed})
        assert files(folder) == expected


@pytest.mark.parametrize(("model", "scalar"), cases())
def test_no_date_no_path_no_template(model: str, scalar: str) -> None:
    for path, content in files(bundle_of(model, scalar)).items():
        text = content.decode()
        assert not re.search(r"(?:19[89]\d|20\d\d)-\d\d-\d\d|\b\d\d:\d\d:\d\d\b(?!Z)", text), path
        assert not re.search(r"/(?:home|tmp|root|usr/lib|work)\b", text), path
        assert not re.search(r"\{%|%\}|\{\{-?\s*[a-z_]|None\b|Traceback", text), path
        assert text.endswith("\n") and not text.endswith("\n\n"), path
        assert not any(line != line.rstrip() for line in text.splitlines()), path


def test_licence_says_whose_the_output_is() -> None:
    text = (bundle_of(*QUICK[0]) / "LICENSE").read_text()
    assert "The output is yours" in text and "SPDX-License-Identifier: 0BSD" in text
    package = bill_of(bundle_of(*QUICK[0]))["packages"][0]
    assert package["licenseDeclared"] == "0BSD"
