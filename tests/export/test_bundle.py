"""A bundle as a whole: its kernels, its manifest, its bytes."""

from __future__ import annotations

import re
from pathlib import Path

import pytest

from symnav import pipeline
from symnav.errors import HandEditedError, InputError

MODELS = [name for name, _ in pipeline.shipped()]


def files(folder: Path) -> dict[str, bytes]:
    return {
        path.relative_to(folder).as_posix(): path.read_bytes()
        for path in sorted(folder.rglob("*"))
        if path.is_file()
    }


@pytest.mark.parametrize("model", MODELS)
def test_kernels_are_those_of_the_extension(model: str, tmp_path: Path) -> None:
    spec = pipeline.load(model)
    package = pipeline.generate(spec, tmp_path / "generated").package
    pipeline.export(spec, tmp_path / "bundle")
    generated, exported = files(package / "c"), files(tmp_path / "bundle")
    kernels = [path for path in exported if path.startswith("src/") and "kernel" in path]
    assert len(kernels) == len(
        {p for p in generated if p.endswith("_kernel.h") and "_f32_" not in p}
    )
    assert all(exported[path] == generated[path] for path in kernels)


def test_single_precision_keeps_what_must_be_double_apart(tmp_path: Path) -> None:
    pipeline.export(pipeline.load("rover"), tmp_path, scalar="float")
    exported = files(tmp_path)
    assert {"src/rover_f32_gps.c", "src/rover_f32_imu.c", "src/rover_range.c"} <= exported.keys()
    assert "src/rover_f32_range.c" not in exported and "src/rover_gps.c" not in exported
    single = [text for path, text in exported.items() if "f32" in path and path.startswith("src/")]
    assert single and not any(b"double" in text for text in single)


def test_writing_twice_changes_nothing(tmp_path: Path) -> None:
    spec = pipeline.load("warpos_gps")
    assert not pipeline.export(spec, tmp_path).unchanged
    before = files(tmp_path)
    again = pipeline.export(spec, tmp_path)
    assert again.unchanged and files(tmp_path) == before
    assert pipeline.check(tmp_path, spec).state == "fresh"


def test_changes_by_hand_are_kept(tmp_path: Path) -> None:
    spec = pipeline.load("warpos_gps")
    pipeline.export(spec, tmp_path)
    source = next((tmp_path / "src").glob("*.c"))
    source.write_text("/* mine */\n")
    with pytest.raises(HandEditedError, match=source.name):
        pipeline.export(spec, tmp_path)
    assert source.read_text() == "/* mine */\n"
    pipeline.export(spec, tmp_path, force=True)
    assert source.read_text() != "/* mine */\n"


def test_another_bundle_is_not_replaced_unasked(tmp_path: Path) -> None:
    """Neither it nor a package; replaced on purpose, nothing of it is left behind."""
    folder = tmp_path / "flight"
    pipeline.export(pipeline.load("warpos_gps"), folder)
    before = files(folder)
    spec = pipeline.load("navtk_specific_force")
    message = "holds the bundle warpos_gps; choose another folder for the bundle navtk_specific"
    with pytest.raises(InputError, match=message):
        pipeline.export(spec, folder)
    assert files(folder) == before
    pipeline.export(spec, folder, force=True)
    assert not list(folder.rglob("*warpos_gps*"))
    package = pipeline.generate(spec, tmp_path).package
    with pytest.raises(InputError, match="holds the package navtk_specific_force; choose another"):
        pipeline.export(spec, package)


def test_folder_of_somebody_else(tmp_path: Path) -> None:
    (tmp_path / "notes.txt").write_text("mine")
    with pytest.raises(InputError, match="not generated"):
        pipeline.export(pipeline.load("warpos_gps"), tmp_path)
    assert files(tmp_path) == {"notes.txt": b"mine"}


def test_entry_points_for_many_epochs_come_when_asked_for(tmp_path: Path) -> None:
    spec = pipeline.load("farrell_tightly_coupled")
    pipeline.export(spec, tmp_path / "one")
    pipeline.export(spec, tmp_path / "many", batches=True)
    one, many = files(tmp_path / "one"), files(tmp_path / "many")
    kernels = [path for path in one if path.endswith("_kernel.h")]
    assert kernels and all(one[path] == many[path] for path in kernels)
    c = {path: text for path, text in one.items() if path.startswith(("src/", "include/"))}
    assert not any(re.search(rb"_(batch|batch_nz|blocks)\(", text) for text in c.values())
    header = many["include/farrell_tightly_coupled/farrell_tightly_coupled.h"]
    assert b"pseudorange_batch_nz(" in header and b"retract_blocks(" in header
