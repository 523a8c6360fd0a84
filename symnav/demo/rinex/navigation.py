"""RINEX 3.04 navigation files: GPS LNAV and Galileo messages (specification, tables A5 to A8)."""

from __future__ import annotations

from collections.abc import Callable, Sequence
from dataclasses import dataclass
from pathlib import Path
from typing import Literal, TypeAlias

from symnav.demo.rinex.text import Line, gps_time, read_lines, records, split_header, time_between

Message: TypeAlias = Literal["LNAV", "INAV", "FNAV"]

_FIELD_WIDTH = 19
_ORBIT_LINES = 7
_SYSTEMS = ("G", "E")
_GALILEO_INAV_BITS = 0b101
_GALILEO_FNAV_BIT = 0b010

# Where each quantity stands: (broadcast orbit line, field), as in tables A6 and A8.
_TOE = (3, 0)
_WEEK = (5, 2)
_HEALTH = (6, 1)
_GPS_TGD = (6, 2)
_GALILEO_DATA_SOURCES = (5, 1)
_GALILEO_BGD_E5A = (6, 2)
_GALILEO_BGD_E5B = (6, 3)


@dataclass(frozen=True, slots=True)
class KlobucharCoefficients:
    """The eight ionospheric coefficients of the GPS message (IS-GPS-200, 20.3.3.5.1.7).

    Attributes:
        alpha: amplitude polynomial in s, s/semicircle, s/semicircle^2, s/semicircle^3.
        beta: period polynomial in the same units.
    """

    alpha: tuple[float, float, float, float]
    beta: tuple[float, float, float, float]


@dataclass(frozen=True, slots=True)
class Ephemeris:
    """One broadcast message of a GPS or Galileo satellite, in SI units and radians.

    The fields from ``toc`` on carry the names of the arguments of the broadcast-orbit model.

    Attributes:
        satellite: for instance ``"G07"``.
        message: ``"LNAV"`` (GPS), ``"INAV"`` or ``"FNAV"`` (Galileo).
        toc_week: GPS week of the clock reference time.
        toe_week: GPS week of the orbit reference time.
        health: the health word; 0 is a healthy satellite.
        group_delay: what a single-frequency L1 or E1 user of this message subtracts from the
            satellite clock: TGD, BGD E1/E5b for INAV, BGD E1/E5a for FNAV, in seconds.
    """

    satellite: str
    message: Message
    toc_week: int
    toe_week: int
    health: int
    toc: float
    toe: float
    sqrt_a: float
    eccentricity: float
    mean_anomaly: float
    mean_motion_difference: float
    inclination: float
    inclination_rate: float
    right_ascension: float
    right_ascension_rate: float
    argument_of_perigee: float
    cuc: float
    cus: float
    crc: float
    crs: float
    cic: float
    cis: float
    af0: float
    af1: float
    af2: float
    group_delay: float

    def age(self, week: int, time_of_week: float) -> float:
        """Returns the seconds from the orbit reference time to a GPS time."""
        return time_between(week, time_of_week, self.toe_week, self.toe)


@dataclass(frozen=True, slots=True)
class NavigationFile:
    """What was read from a navigation file.

    Attributes:
        ephemerides: GPS and Galileo messages in the order of the file; others are passed over.
        klobuchar: the GPS ionospheric coefficients, None when the header has none.
    """

    ephemerides: tuple[Ephemeris, ...]
    klobuchar: KlobucharCoefficients | None


def read_navigation(path: Path) -> NavigationFile:
    """Reads the GPS and Galileo messages of a RINEX 3.04 navigation file.

    Raises:
        InputError: the file is malformed; the message names the line and what was expected.
    """
    header, body = split_header(read_lines(path), "N")
    known = (record for record in records(body) if record[0].satellite()[0] in _SYSTEMS)
    return NavigationFile(tuple(_ephemeris(record) for record in known), _klobuchar(header))


def _klobuchar(header: Sequence[Line]) -> KlobucharCoefficients | None:
    found: dict[str, tuple[float, float, float, float]] = {}
    for line in header:
        name = line.text[:4]
        if line.label == "IONOSPHERIC CORR" and name in ("GPSA", "GPSB"):
            a, b, c, d = (line.real(5 + 12 * k, 12, f"four numbers of {name}") for k in range(4))
            found[name] = (a, b, c, d)
    if len(found) == 1:
        header[-1].fail("both GPSA and GPSB, or neither, in the header", next(iter(found)))
    return KlobucharCoefficients(found["GPSA"], found["GPSB"]) if found else None


def _ephemeris(record: Sequence[Line]) -> Ephemeris:
    """Turns eight lines into a message; every number it needs must be there."""
    head = record[0]
    if len(record) != _ORBIT_LINES + 1:
        head.fail(f"{_ORBIT_LINES} broadcast orbit lines", f"{len(record) - 1} lines")

    def field(line: int, column: int) -> float:
        what = f"a number in field {column + 1} of broadcast orbit line {line}"
        return record[line].real(4 + _FIELD_WIDTH * column, _FIELD_WIDTH, what)

    def clock(column: int) -> float:
        return head.real(23 + _FIELD_WIDTH * column, _FIELD_WIDTH, f"clock coefficient {column}")

    toc_week, toc = gps_time(head, 4, float(head.integer(20, 3, "the seconds of the clock epoch")))
    message, delay = _message_and_group_delay(head, field)
    return Ephemeris(
        satellite=head.satellite(),
        message=message,
        toc_week=toc_week,
        toe_week=int(field(*_WEEK)),
        health=int(field(*_HEALTH)),
        toc=toc,
        toe=field(*_TOE),
        sqrt_a=field(2, 3),
        eccentricity=field(2, 1),
        mean_anomaly=field(1, 3),
        mean_motion_difference=field(1, 2),
        inclination=field(4, 0),
        inclination_rate=field(5, 0),
        right_ascension=field(3, 2),
        right_ascension_rate=field(4, 3),
        argument_of_perigee=field(4, 2),
        cuc=field(2, 0),
        cus=field(2, 2),
        crc=field(4, 1),
        crs=field(1, 1),
        cic=field(3, 1),
        cis=field(3, 3),
        af0=clock(0),
        af1=clock(1),
        af2=clock(2),
        group_delay=delay,
    )


def _message_and_group_delay(
    head: Line, field: Callable[[int, int], float]
) -> tuple[Message, float]:
    """Tells the message type and picks the group delay that belongs to its clock."""
    if head.text.startswith("G"):
        return "LNAV", field(*_GPS_TGD)
    sources = int(field(*_GALILEO_DATA_SOURCES))
    if sources & _GALILEO_INAV_BITS:
        return "INAV", field(*_GALILEO_BGD_E5B)
    if sources & _GALILEO_FNAV_BIT:
        return "FNAV", field(*_GALILEO_BGD_E5A)
    head.fail("a Galileo message whose data sources name I/NAV or F/NAV", str(sources))
