"""The observation reader on the recorded file, on written files and on malformed ones."""

from __future__ import annotations

import re
from collections.abc import Callable
from pathlib import Path

import pytest
from hypothesis import given
from hypothesis import strategies as st

from symnav.demo.rinex import ObservationFile, read_observations
from symnav.errors import InputError

HEADER = """\
     3.04           OBSERVATION DATA    M                   RINEX VERSION / TYPE
G    3 C1C L1C S1C                                          SYS / # / OBS TYPES
E    2 C1C L1C                                              SYS / # / OBS TYPES
  2021     3    19    12     0    0.0000000     GPS         TIME OF FIRST OBS
                                                            END OF HEADER
"""
EPOCH = "> 2021 03 19 12 00  0.0000000  0  2\n"
G01 = "G01  23733056.453 6 124718238.44206        36.125\n"
E08 = "E08  22559453.167 7 118550752.90307\n"
GOOD = HEADER + EPOCH + G01 + E08


@pytest.fixture
def read(tmp_path: Path) -> Callable[[str], ObservationFile]:
    """Writes a text to a file and reads it."""

    def read_text(text: str) -> ObservationFile:
        path = tmp_path / "made.21O"
        path.write_text(text, encoding="ascii")
        return read_observations(path)

    return read_text


def test_recorded_file(observations: ObservationFile) -> None:
    """Sixty seconds of the day of year 78 of 2021, with values copied from the text by eye."""
    assert len(observations.epochs) == 60
    assert {epoch.week for epoch in observations.epochs} == {2149}
    friday_noon = 5 * 86400 + 12 * 3600
    assert [e.time_of_week for e in observations.epochs] == [friday_noon + k for k in range(60)]
    assert set(observations.codes) == {"G", "E", "J"}
    assert observations.codes["G"][-2:] == ("L5Q", "S5Q")
    first = observations.epochs[0].observations
    assert len(first) == 23
    assert first["E01"]["C1C"] == 27530612.397
    assert first["E01"]["L1C"] == 144674360.165
    assert first["G17"]["S5Q" if "S5Q" in first["G17"] else "S2L"] == 43.156
    assert "L1W" not in first["G01"]
    assert "C2L" not in first["G19"]
    assert first["G19"]["C2W"] == 20417827.448


def test_blank_and_zero_are_left_out(read: Callable[[str], ObservationFile]) -> None:
    """RINEX marks a missing observation by blanks or by 0.0."""
    text = GOOD.replace("23733056.453 6", "       0.000  ").replace("124718238.442", " " * 13)
    assert dict(read(text).epochs[0].observations["G01"]) == {"S1C": 36.125}


def test_events_between_epochs_are_passed_over(read: Callable[[str], ObservationFile]) -> None:
    """A comment inserted by an event record is not an epoch; a power failure (1) is."""
    event = "> 2021 03 19 12 00  0.5000000  4  1\n" + " " * 60 + "COMMENT\n"
    again = EPOCH.replace("0.0000000  0", "1.0000000  1") + G01 + E08
    times = [epoch.time_of_week for epoch in read(GOOD + event + again).epochs]
    assert times == [475200.0, 475201.0]


def test_records_are_immutable(observations: ObservationFile) -> None:
    """Nobody changes an observation by accident."""
    with pytest.raises(TypeError):
        observations.epochs[0].observations["G01"]["C1C"] = 0.0  # type: ignore[index]


@pytest.mark.parametrize(
    ("line", "old", "new", "expected"),
    [
        (1, "     3.04", "     2.11", "RINEX version 3"),
        (1, "     3.04", "     x.yz", "the format version"),
        (1, "OBSERVATION DATA", "NAVIGATION DATA ", "file type 'O'"),
        (1, "RINEX VERSION / TYPE", "SOMETHING ELSE", "'RINEX VERSION / TYPE'"),
        (2, "G    3", "G    4", "4 observation codes"),
        (2, "G    3", "     3", "a system letter"),
        (3, "E    2", "G    2", "one list of observation codes for system G"),
        (4, "GPS", "GLO", "GPS time"),
        (4, "TIME OF FIRST OBS", "SYS / SCALE FACTOR", "without scale factors"),
        (6, "> 2021", "# 2021", "an epoch line"),
        (6, " 03 19", " 13 19", "a valid date"),
        (6, "12 00", "25 00", "a valid date"),
        (6, "0.0000000", "0.00z0000", "the seconds"),
        (6, "  0  2", "  0  3", "3 records"),
        (6, "  0  2", "  7  2", "an epoch flag"),
        (7, "G01", "g01", "a satellite such as G07"),
        (7, "G01", "R01", "a system with observation codes"),
        (7, "23733056.453", "2373x056.453", "C1C as a number"),
        (7, "23733056.453", "         nan", "C1C as a number"),
        (8, "E08  22559453.167", "G01  22559453.167", "one record of satellite G01"),
        (8, "118550752.90307", "118550752.90307        45.000", "at most 2 observations"),
    ],
)
def test_malformed(
    read: Callable[[str], ObservationFile], line: int, old: str, new: str, expected: str
) -> None:
    """Each mistake is reported with file, line and what was expected."""
    lines = GOOD.splitlines(keepends=True)
    assert old in lines[line - 1]
    lines[line - 1] = lines[line - 1].replace(old, new, 1)
    with pytest.raises(InputError, match=re.escape(expected)) as caught:
        read("".join(lines))
    assert str(caught.value).startswith(f"made.21O:{line}: expected ")


def test_header_without_end(read: Callable[[str], ObservationFile]) -> None:
    """A file cut in its header says so."""
    with pytest.raises(InputError, match="'END OF HEADER'"):
        read(HEADER[: HEADER.index("                      END OF HEADER")])


def test_header_without_codes(read: Callable[[str], ObservationFile]) -> None:
    """Observations cannot be named without the list of codes."""
    lines = [line for line in GOOD.splitlines() if "OBS TYPES" not in line]
    with pytest.raises(InputError, match="'SYS / # / OBS TYPES' in the header"):
        read("\n".join(lines))


def test_changed_codes_are_refused(read: Callable[[str], ObservationFile]) -> None:
    """An event may change the columns; that is refused and not misread."""
    codes = HEADER.splitlines()[1]
    event = f"> 2021 03 19 12 00  0.5000000  4  1\n{codes}\n"
    with pytest.raises(InputError, match="no change of observation codes"):
        read(GOOD + event)


def test_unreadable_files(tmp_path: Path) -> None:
    """A missing, an empty and a compressed file are named."""
    with pytest.raises(InputError, match=r"absent\.21O: cannot be read"):
        read_observations(tmp_path / "absent.21O")
    (tmp_path / "empty.21O").write_text("\n")
    with pytest.raises(InputError, match=r"empty\.21O: .*is empty"):
        read_observations(tmp_path / "empty.21O")
    (tmp_path / "packed.21O").write_bytes(b"\x1f\x8b\x08\x00")
    with pytest.raises(InputError, match="uncompressed"):
        read_observations(tmp_path / "packed.21O")


@given(
    values=st.lists(
        st.none() | st.integers(-9_999_999_999, 99_999_999_999).filter(bool),
        min_size=3,
        max_size=3,
    )
)
def test_written_values_come_back(
    tmp_path_factory: pytest.TempPathFactory, values: list[int | None]
) -> None:
    """Any F14.3 value is read to the last digit, blanks stay blanks, whatever surrounds them."""
    fields = [" " * 16 if v is None else f"{v / 1000:14.3f}17" for v in values]
    path = tmp_path_factory.mktemp("written") / "made.21O"
    path.write_text(HEADER + EPOCH.replace("0  2", "0  1") + ("G01" + "".join(fields)).rstrip())
    (epoch,) = read_observations(path).epochs
    expected = {c: v / 1000 for c, v in zip(("C1C", "L1C", "S1C"), values, strict=True) if v}
    assert dict(epoch.observations["G01"]) == expected
