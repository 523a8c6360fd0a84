"""Working precision of the tests of the core."""

from collections.abc import Iterator

import pytest
from mpmath import mp


@pytest.fixture(autouse=True)
def many_digits() -> Iterator[None]:
    """Nine digits more than a double has, so that comparisons see only what is compared."""
    with mp.workdps(25):
        yield
