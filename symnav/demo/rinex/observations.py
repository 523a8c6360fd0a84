"""RINEX 3.04 observation files (RINEX 3.04 specification, sections 5 and 6, tables A2 and A3)."""

from __future__ import annotations

from collections.abc import Iterator, Mapping, Sequence
from dataclasses import dataclass
from pathlib import Path
from types import MappingProxyType

from symnav.demo.rinex.text import Line, gps_time, read_lines, split_header

_CODES_PER_LINE = 13
_OBSERVATION_WIDTH = 16
_VALUE_WIDTH = 14
_OBSERVED_FLAGS = (0, 1)
_CYCLE_SLIP_FLAG = 6


@dataclass(frozen=True, slots=True)
class Epoch:
    """The observations of one instant.

    Attributes:
        week: GPS week of the receiver's time tag.
        time_of_week: second of that week, in seconds.
        observations: by satellite (``"G07"``) and observation code (``"C1C"``); pseudoranges
            in metres, carrier phases in cycles. Blank and zero entries are left out.
    """

    week: int
    time_of_week: float
    observations: Mapping[str, Mapping[str, float]]


@dataclass(frozen=True, slots=True)
class ObservationFile:
    """What was read from an observation file.

    Attributes:
        codes: the observation codes by system letter, in the order of their columns.
        epochs: the epochs in the order of the file.
    """

    codes: Mapping[str, tuple[str, ...]]
    epochs: tuple[Epoch, ...]


def read_observations(path: Path) -> ObservationFile:
    """Reads a RINEX 3.04 observation file in GPS time.

    Raises:
        InputError: the file is malformed or uses a feature that is not read; the message names
            the line and what was expected there.
    """
    header, body = split_header(read_lines(path), "O")
    for line in header:
        _refuse_unread(line)
    codes = _observation_codes(header)
    return ObservationFile(MappingProxyType(codes), tuple(_epochs(body, codes)))


def _refuse_unread(line: Line) -> None:
    """Refuses header lines that change the meaning of the numbers below them."""
    if line.label == "SYS / SCALE FACTOR":
        line.fail("observations without scale factors", line.label)
    if line.label == "TIME OF FIRST OBS" and line.text[48:51] not in ("GPS", "   "):
        line.fail("epochs in GPS time", line.text[48:51])


def _observation_codes(header: Sequence[Line]) -> dict[str, tuple[str, ...]]:
    """Collects ``SYS / # / OBS TYPES``, which continues on lines with a blank system letter."""
    codes: dict[str, tuple[str, ...]] = {}
    counts: dict[str, tuple[Line, int]] = {}
    system = " "
    for line in header:
        if line.label != "SYS / # / OBS TYPES":
            continue
        if line.text[0] != " ":
            system = line.text[0]
            if system in codes:
                line.fail(f"one list of observation codes for system {system}")
            counts[system] = (line, line.integer(3, 3, "the number of observation codes"))
            codes[system] = ()
        elif system == " ":
            line.fail("a system letter in column 1")
        codes[system] += tuple(line.text[6 : 6 + 4 * _CODES_PER_LINE].split())
    for system, (line, count) in counts.items():
        if len(codes[system]) != count:
            line.fail(f"{count} observation codes", f"{len(codes[system])} codes")
    if not codes:
        header[-1].fail("'SYS / # / OBS TYPES' in the header")
    return codes


def _epochs(body: Sequence[Line], codes: Mapping[str, tuple[str, ...]]) -> Iterator[Epoch]:
    """Walks over the epochs; events and cycle-slip records between them are passed over."""
    index = 0
    while index < len(body):
        head = body[index]
        if not head.text.startswith("> "):
            head.fail("an epoch line starting with '> '")
        flag = head.integer(31, 1, "an epoch flag from 0 to 6")
        count = head.integer(32, 3, "the number of records of the epoch")
        lines = body[index + 1 : index + 1 + count]
        if count < 0 or len(lines) < count:
            head.fail(f"{count} records after the epoch line", f"{len(lines)} before the end")
        if flag in _OBSERVED_FLAGS:
            yield _epoch(head, lines, codes)
        elif flag > _CYCLE_SLIP_FLAG or any(line.label == "SYS / # / OBS TYPES" for line in lines):
            head.fail("an epoch flag from 0 to 6 and no change of observation codes")
        index += 1 + count


def _epoch(head: Line, lines: Sequence[Line], codes: Mapping[str, tuple[str, ...]]) -> Epoch:
    week, time_of_week = gps_time(head, 2, head.real(18, 11, "the seconds of the epoch"))
    observations: dict[str, Mapping[str, float]] = {}
    for line in lines:
        satellite = line.satellite()
        if satellite in observations:
            line.fail(f"one record of satellite {satellite} per epoch")
        if satellite[0] not in codes:
            line.fail(f"a system with observation codes in the header ({', '.join(codes)})")
        observations[satellite] = MappingProxyType(_values(line, codes[satellite[0]]))
    return Epoch(week, time_of_week, MappingProxyType(observations))


def _values(line: Line, codes: Sequence[str]) -> dict[str, float]:
    """Reads F14.3 values, each followed by two one-digit indicators that are not needed here."""
    if line.text[3 + _OBSERVATION_WIDTH * len(codes) :].strip():
        line.fail(f"at most {len(codes)} observations, as the header announces")
    values: dict[str, float] = {}
    for column, code in enumerate(codes):
        start = 3 + _OBSERVATION_WIDTH * column
        value = line.optional_real(start, _VALUE_WIDTH, f"{code} as a number of 14 columns")
        if value:
            values[code] = value
    return values
