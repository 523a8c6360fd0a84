"""Fixtures of the whole test suite: golden files and generated packages."""

from __future__ import annotations

import difflib
import hashlib
from collections.abc import Callable
from pathlib import Path
from types import ModuleType

import pytest

GOLDEN = Path(__file__).parent / "golden"


def pytest_addoption(parser: pytest.Parser) -> None:
    """Adds the option that accepts new golden files."""
    parser.addoption(
        "--update-golden",
        action="store_true",
        help="write tests/golden/ from what the tests produce, for review with git diff",
    )


class Golden:
    """Compares a text with the file that belongs to the running test."""

    def __init__(self, file: Path, update: bool) -> None:
        self.file = file
        self.update = update

    def __call__(self, text: str) -> None:
        """Fails with a diff when the text is not what the golden file says."""
        if self.update:
            self.file.parent.mkdir(parents=True, exist_ok=True)
            self.file.write_text(text, encoding="utf-8")
            return
        if not self.file.is_file():
            pytest.fail(f"{self.file} is missing; run pytest --update-golden and review it", False)
        expected = self.file.read_text(encoding="utf-8")
        if text != expected:
            difference = "\n".join(
                difflib.unified_diff(
                    expected.splitlines(), text.splitlines(), "golden", "now", lineterm=""
                )
            )
            pytest.fail(
                f"differs from {self.file}; run pytest --update-golden if the change is meant\n"
                f"{difference}",
                False,
            )


@pytest.fixture
def golden(request: pytest.FixtureRequest) -> Golden:
    """The golden file ``tests/golden/<test file>/<test name>.txt`` of the running test."""
    test_file = Path(request.node.path).stem
    name = "".join(c if c.isalnum() or c in "._-" else "-" for c in request.node.name)
    return Golden(GOLDEN / test_file / f"{name}.txt", request.config.getoption("--update-golden"))


@pytest.fixture(scope="session")
def generated(tmp_path_factory: pytest.TempPathFactory) -> Callable[[str | Path], ModuleType]:
    """Generates, builds and imports a specification, once per session.

    The argument is the name of a shipped model, a file, or the text of a specification (it holds
    a line break).
    """
    imported: dict[str, ModuleType] = {}

    def make(spec: str | Path) -> ModuleType:
        key = str(spec)
        if key not in imported:
            imported[key] = _imported(spec, tmp_path_factory.mktemp("generated"))
        return imported[key]

    return make


def _imported(spec: str | Path, folder: Path) -> ModuleType:
    from symnav import pipeline

    if "\n" in str(spec):
        text = str(spec)
        spec = folder / f"{hashlib.sha256(text.encode()).hexdigest()[:12]}.toml"
        spec.write_text(text, encoding="utf-8")
    made = pipeline.generate(pipeline.load(spec), folder)
    pipeline.build(made.package)
    return pipeline.import_package(made.package)
