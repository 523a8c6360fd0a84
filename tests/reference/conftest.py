"""Working precision of the tests of the references."""

from collections.abc import Iterator

import pytest
from mpmath import mp


@pytest.fixture(autouse=True)
def fifty_digits() -> Iterator[None]:
    """Work with fifty digits."""
    with mp.workdps(50):
        yield
