"""Fixtures of the demonstration's tests: the recorded data and the independent models."""

from __future__ import annotations

from pathlib import Path

import pytest

import symnav.demo
from symnav.demo.models import GeneratedModels
from symnav.demo.results import DemoResult
from symnav.demo.rinex import (
    NavigationFile,
    ObservationFile,
    read_navigation,
    read_observations,
)
from symnav.demo.run import run
from tests.demo.book_models import BookOrbit, BookRange


@pytest.fixture(scope="session")
def data_folder() -> Path:
    """Where the recorded files are."""
    return Path(symnav.demo.__file__).parent / "data"


@pytest.fixture(scope="session")
def observations(data_folder: Path) -> ObservationFile:
    """The recorded observations."""
    return read_observations(data_folder / "SEPT078M1.21O")


@pytest.fixture(scope="session")
def navigation(data_folder: Path) -> NavigationFile:
    """The broadcast messages."""
    return read_navigation(data_folder / "SEPT078M.21P")


@pytest.fixture(scope="session")
def book() -> GeneratedModels:
    """The models of the interface document in place of generated ones."""
    return GeneratedModels(BookOrbit(), BookRange(), BookRange(sagnac=False))


@pytest.fixture(scope="session")
def result(book: GeneratedModels) -> DemoResult:
    """The whole demonstration, run once."""
    return run(book)
