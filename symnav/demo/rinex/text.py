"""Fixed-column text with line numbers, and the header that both RINEX file types share."""

from __future__ import annotations

import datetime
import math
import re
from collections.abc import Iterator, Sequence
from dataclasses import dataclass
from pathlib import Path
from typing import NoReturn

from symnav.demo.constants import SECONDS_PER_WEEK
from symnav.errors import InputError

# Fortran writes the exponent with a D; Python's own float() would also take underscores and "nan".
_REAL = re.compile(r"[+-]?(?:\d+\.?\d*|\.\d+)(?:[EeDd][+-]?\d+)?")
_INTEGER = re.compile(r"[+-]?\d+")
_SATELLITE = re.compile(r"[A-Z][ 0-9][0-9]")
_LABEL_COLUMN = 60
_GPS_EPOCH = datetime.date(1980, 1, 6)


@dataclass(frozen=True, slots=True)
class Line:
    """One line of a file, knowing where it stands.

    Attributes:
        source: the file's name, for messages.
        number: the line's number, from 1.
        text: the line without its end.
    """

    source: str
    number: int
    text: str

    def fail(self, expected: str, found: str | None = None) -> NoReturn:
        """Raises an error that names the file, this line and what was expected."""
        shown = self.text.strip() if found is None else found.strip()
        raise InputError(f"{self.source}:{self.number}: expected {expected}; found {shown!r}")

    @property
    def label(self) -> str:
        """The header label in columns 61 to 80."""
        return self.text[_LABEL_COLUMN:].strip()

    def real(self, start: int, width: int, expected: str) -> float:
        """Reads the real number in ``width`` columns from ``start`` (counted from 0)."""
        value = self.optional_real(start, width, expected)
        return self.fail(expected, "") if value is None else value

    def optional_real(self, start: int, width: int, expected: str) -> float | None:
        """Reads a real number, or None where the columns are blank."""
        field = self.text[start : start + width].strip()
        if not field:
            return None
        if _REAL.fullmatch(field) is None:
            self.fail(expected, field)
        value = float(field.upper().replace("D", "E"))
        return value if math.isfinite(value) else self.fail(expected, field)

    def integer(self, start: int, width: int, expected: str) -> int:
        """Reads the integer in ``width`` columns from ``start`` (counted from 0)."""
        field = self.text[start : start + width].strip()
        return int(field) if _INTEGER.fullmatch(field) else self.fail(expected, field)

    def satellite(self) -> str:
        """Reads the satellite in the first three columns, for instance ``G07``."""
        field = self.text[:3]
        if _SATELLITE.fullmatch(field) is None:
            self.fail("a satellite such as G07 in columns 1 to 3", field)
        return field.replace(" ", "0")


def read_lines(path: Path) -> tuple[Line, ...]:
    """Reads a text file into numbered lines.

    Raises:
        InputError: the file cannot be read, is not text or is empty.
    """
    try:
        text = path.read_text(encoding="ascii")
    except OSError as error:
        raise InputError(f"{path.name}: cannot be read ({error.strerror})") from error
    except UnicodeDecodeError as error:
        raise InputError(
            f"{path.name}: expected an uncompressed RINEX 3.04 text file; "
            f"found a byte outside ASCII at offset {error.start}"
        ) from error
    numbered = enumerate(text.rstrip().splitlines(), start=1)
    lines = tuple(Line(path.name, number, line) for number, line in numbered)
    if not lines:
        raise InputError(f"{path.name}: expected a RINEX 3.04 file; the file is empty")
    return lines


def split_header(lines: Sequence[Line], file_type: str) -> tuple[Sequence[Line], Sequence[Line]]:
    """Checks version and type of a file and separates its header from its body.

    Args:
        lines: all lines of the file.
        file_type: ``"O"`` for observations, ``"N"`` for navigation messages.
    """
    first = lines[0]
    if first.label != "RINEX VERSION / TYPE":
        first.fail("'RINEX VERSION / TYPE' in columns 61 to 80", first.label)
    version = first.real(0, 9, "the format version")
    if not 3.0 <= version < 4.0:
        first.fail("RINEX version 3", str(version))
    if first.text[20:21] != file_type:
        first.fail(f"file type {file_type!r} in column 21", first.text[20:21])
    for index, line in enumerate(lines):
        if line.label == "END OF HEADER":
            return lines[1:index], lines[index + 1 :]
    lines[-1].fail("'END OF HEADER' before the end of the file")


def records(body: Sequence[Line]) -> Iterator[Sequence[Line]]:
    """Splits a body into records: a line that starts in column 1 and the indented ones after it."""
    start = 0
    for index, line in enumerate(body):
        if index > start and not line.text.startswith(" "):
            yield body[start:index]
            start = index
    if start < len(body):
        yield body[start:]


def gps_time(line: Line, start: int, seconds: float) -> tuple[int, float]:
    """Reads year to minute (I4 and four I2 with a blank before each) as GPS week and second.

    Args:
        line: the line that holds the date.
        start: column of the year, counted from 0.
        seconds: the seconds of the minute, read by the caller.
    """
    year = line.integer(start, 4, "a year")
    month, day, hour, minute = (
        line.integer(start + 4 + 3 * k, 3, f"{what} of the epoch")
        for k, what in enumerate(("the month", "the day", "the hour", "the minute"))
    )
    in_range = 0 <= hour < 24 and 0 <= minute < 60 and 0.0 <= seconds < 60.0
    try:
        days = (datetime.date(year, month, day) - _GPS_EPOCH).days
    except ValueError:
        in_range = False
    if not in_range:
        line.fail("a valid date and time")
    week, day_of_week = divmod(days, 7)
    return week, day_of_week * 86_400.0 + hour * 3_600.0 + minute * 60.0 + seconds


def time_between(week: int, second: float, origin_week: int, origin_second: float) -> float:
    """Returns the seconds from an origin to a time, both given as GPS week and second of week."""
    return (week - origin_week) * SECONDS_PER_WEEK + (second - origin_second)
