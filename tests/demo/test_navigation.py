"""The navigation reader on the recorded file and on malformed ones."""

from __future__ import annotations

import re
from collections import Counter
from collections.abc import Callable
from pathlib import Path

import pytest

from symnav.demo.rinex import NavigationFile, read_navigation
from symnav.errors import InputError

GOOD = """\
     3.04           N: GNSS NAV DATA    M: Mixed            RINEX VERSION / TYPE
GPSA    .1118D-07   .7451D-08  -.5960D-07  -.5960D-07       IONOSPHERIC CORR
GPSB    .9011D+05   .0000D+00  -.1966D+06  -.6554D+05       IONOSPHERIC CORR
                                                            END OF HEADER
E08 2021 03 19 10 40 00  .603088719072D-02 -.568434188608D-11  .000000000000D+00
      .160000000000D+02 -.385000000000D+02  .351907515503D-08  .101772513154D+00
     -.172480940819D-05  .229118275456D-03  .670552253723D-05  .544061199188D+04
      .470400000000D+06 -.745058059692D-08 -.311318009565D+00 -.186264514923D-08
      .960931523981D+00  .200312500000D+03 -.457069705211D+00 -.565666419420D-08
     -.134648465792D-09  .516000000000D+03  .214900000000D+04  .000000000000D+00
      .312000000000D+01  .000000000000D+00 -.395812094212D-08 -.442378222942D-08
      .471604000000D+06  .000000000000D+00
"""


@pytest.fixture
def read(tmp_path: Path) -> Callable[[str], NavigationFile]:
    """Writes a text to a file and reads it."""

    def read_text(text: str) -> NavigationFile:
        path = tmp_path / "made.21P"
        path.write_text(text, encoding="ascii")
        return read_navigation(path)

    return read_text


def test_recorded_file(navigation: NavigationFile) -> None:
    """234 GPS and Galileo messages; the eight of QZSS are passed over."""
    assert Counter(m.satellite[0] for m in navigation.ephemerides) == {"E": 210, "G": 24}
    assert {m.message for m in navigation.ephemerides if m.satellite[0] == "G"} == {"LNAV"}
    assert navigation.klobuchar is not None
    assert navigation.klobuchar.alpha == (0.1118e-7, 0.7451e-8, -0.5960e-7, -0.5960e-7)
    assert navigation.klobuchar.beta == (90110.0, 0.0, -196600.0, -65540.0)


def test_physical_plausibility(navigation: NavigationFile) -> None:
    """A field read from the wrong place would leave these bounds of the two constellations."""
    for message in navigation.ephemerides:
        radius = {"G": 26_560e3, "E": 29_600e3}[message.satellite[0]]
        assert message.sqrt_a**2 == pytest.approx(radius, rel=2e-3)
        assert 0.0 < message.eccentricity < 0.03
        assert message.inclination == pytest.approx(0.97, abs=0.05)
        assert message.right_ascension_rate == pytest.approx(-6.5e-9, abs=2.5e-9)
        assert message.mean_motion_difference == pytest.approx(4e-9, abs=2e-9)
        assert max(abs(message.cuc), abs(message.cus)) < 2e-5
        assert max(abs(message.cic), abs(message.cis)) < 1e-6
        assert max(abs(message.crc), abs(message.crs)) < 500.0
        assert abs(message.af0) < 0.02
        assert abs(message.group_delay) < 3e-8
        assert abs(message.toe - message.toc) <= 16.0
        assert message.toe_week == message.toc_week == 2149


def test_galileo_fields(read: Callable[[str], NavigationFile]) -> None:
    """Every field of one message, copied from the text above by eye."""
    (message,) = read(GOOD).ephemerides
    assert (message.satellite, message.message, message.health) == ("E08", "INAV", 0)
    assert (message.toc_week, message.toc) == (2149, 470400.0)
    assert (message.toe_week, message.toe) == (2149, 470400.0)
    assert (message.af0, message.af1, message.af2) == (6.03088719072e-3, -5.68434188608e-12, 0.0)
    assert message.crs == -38.5
    assert message.mean_motion_difference == 3.51907515503e-9
    assert message.mean_anomaly == 0.101772513154
    assert (message.cuc, message.cus) == (-1.72480940819e-6, 6.70552253723e-6)
    assert message.eccentricity == 2.29118275456e-4
    assert message.sqrt_a == 5440.61199188
    assert (message.cic, message.cis) == (-7.45058059692e-9, -1.86264514923e-9)
    assert message.right_ascension == -0.311318009565
    assert message.inclination == 0.960931523981
    assert message.crc == 200.3125
    assert message.argument_of_perigee == -0.457069705211
    assert message.right_ascension_rate == -5.65666419420e-9
    assert message.inclination_rate == -1.34648465792e-10
    assert message.group_delay == -4.42378222942e-9
    assert message.age(2149, 470400.0 + 60.0) == 60.0
    assert message.age(2150, 0.0) == 604800.0 - 470400.0


def test_fnav_takes_its_own_group_delay(read: Callable[[str], NavigationFile]) -> None:
    """F/NAV clocks refer to E1/E5a, whose delay stands in the field before."""
    (message,) = read(GOOD.replace(".516000000000D+03", ".258000000000D+03")).ephemerides
    assert (message.message, message.group_delay) == ("FNAV", -3.95812094212e-9)


def test_other_systems_are_passed_over(read: Callable[[str], NavigationFile]) -> None:
    """A GLONASS record has three orbit lines, which is no mistake."""
    body = GOOD.splitlines(keepends=True)
    glonass = "".join(["R05" + body[4][3:], *body[5:8]])
    assert len(read("".join(body[:4]) + glonass + "".join(body[4:])).ephemerides) == 1


def test_no_ionosphere(read: Callable[[str], NavigationFile]) -> None:
    """The coefficients are optional, half of them are not."""
    lines = GOOD.splitlines(keepends=True)
    assert read("".join(lines[:1] + lines[3:])).klobuchar is None
    with pytest.raises(InputError, match="both GPSA and GPSB"):
        read("".join(lines[:2] + lines[3:]))


@pytest.mark.parametrize(
    ("line", "at", "old", "new", "expected"),
    [
        (1, 1, "N: GNSS", "O: GNSS", "file type 'N'"),
        (2, 2, ".1118D-07", ".11x8D-07", "four numbers of GPSA"),
        (5, 5, "E08", "808", "a satellite such as G07"),
        (5, 5, " 10 40 00", " 10 61 00", "a valid date and time"),
        (5, 5, "-.568434188608D-11", " " * 18, "clock coefficient 1"),
        (6, 6, ".101772513154D+00", ".1017725131e4D+00", "field 4 of broadcast orbit line 1"),
        (7, 7, ".544061199188D+04", " " * 17, "field 4 of broadcast orbit line 2"),
        (7, 7, ".544061199188D+04", ".54406119918D+999", "field 4 of broadcast orbit line 2"),
        (10, 5, ".516000000000D+03", ".000000000000D+00", "a Galileo message"),
        (9, 5, "      .960931523981D+00", "E09   .960931523981D", "7 broadcast orbit lines"),
    ],
)
def test_malformed(
    read: Callable[[str], NavigationFile], line: int, at: int, old: str, new: str, expected: str
) -> None:
    """Each mistake is reported with file, line and what was expected."""
    lines = GOOD.splitlines(keepends=True)
    assert old in lines[line - 1]
    lines[line - 1] = lines[line - 1].replace(old, new, 1)
    with pytest.raises(InputError, match=re.escape(expected)) as caught:
        read("".join(lines))
    assert str(caught.value).startswith(f"made.21P:{at}: expected ")


def test_cut_file(read: Callable[[str], NavigationFile]) -> None:
    """A file that ends within a message is not half a message."""
    with pytest.raises(InputError, match="7 broadcast orbit lines; found '5 lines'"):
        read("".join(GOOD.splitlines(keepends=True)[:10]))
