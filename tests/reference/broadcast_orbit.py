"""Satellite position, velocity and clock from a Keplerian ephemeris (GPS LNAV, Galileo).

IS-GPS-200 table 20-IV and the Galileo OS SIS ICD section 5.1.1. Kepler's equation is solved by
bisection and then Newton; the orbit plane is placed in space by two rotations; velocity and clock
rate are derivatives of position and clock at high precision rather than the formulas of either
document.
"""

from fractions import Fraction

from mpmath import mp, mpf

from .algebra import (
    Options,
    Outputs,
    Quantities,
    Vector,
    about,
    derivative,
    exact,
    multiply,
    sandwich,
)
from .earth import ROTATION_RATE

GRAVITATION = {"gps": Fraction("3.986005e14"), "galileo": Fraction("3.986004418e14")}
RELATIVITY = {"gps": Fraction("-4.442807633e-10"), "galileo": Fraction("-4.442807309e-10")}
"""The constant F = -2 sqrt(GM) / c^2, as the two documents print it."""
WEEK = 604800


def element(q: Quantities, name: str) -> mpf:
    """Give a broadcast element, zero where it is not bound."""
    return q[name]["value"][0] if name in q else mpf(0)


def gravitation(options: Options) -> mpf:
    """Give the gravitational constant that the satellite system prescribes."""
    return exact(GRAVITATION[options.get("system", "gps")])


def since(time: mpf, epoch: mpf) -> mpf:
    """Give the time since an epoch of the week, across the change of week to the nearer side."""
    elapsed = time - epoch
    if elapsed > WEEK / 2:
        return elapsed - WEEK
    if elapsed < -WEEK / 2:
        return elapsed + WEEK
    return elapsed


def eccentric_anomaly(mean: mpf, eccentricity: mpf) -> mpf:
    """Solve E - e sin E = M."""
    low, high = mean - eccentricity, mean + eccentricity
    while high - low > mpf(10) ** -6:
        middle = (low + high) / 2
        if middle - eccentricity * mp.sin(middle) < mean:
            low = middle
        else:
            high = middle
    anomaly = (low + high) / 2
    # From 1e-6 every step doubles the digits, so the count leaves steps to spare.
    for _ in range(3 + int(mp.log(mp.dps, 2))):
        error = anomaly - eccentricity * mp.sin(anomaly) - mean
        anomaly -= error / (1 - eccentricity * mp.cos(anomaly))
    return anomaly


def anomaly_at(q: Quantities, options: Options, time: mpf) -> mpf:
    """Give the eccentric anomaly at a time of week."""
    axis = element(q, "sqrt_a") ** 2
    motion = mp.sqrt(gravitation(options) / axis**3) + element(q, "mean_motion_difference")
    mean = element(q, "mean_anomaly") + motion * since(time, element(q, "toe"))
    return eccentric_anomaly(mean, element(q, "eccentricity"))


def position_at(q: Quantities, options: Options, time: mpf) -> Vector:
    """Give the Earth-fixed position at a time of week, in the Earth-fixed axes of that time."""
    e, elapsed = element(q, "eccentricity"), since(time, element(q, "toe"))
    anomaly = anomaly_at(q, options, time)
    true = 2 * mp.atan2(mp.sqrt(1 + e) * mp.sin(anomaly / 2), mp.sqrt(1 - e) * mp.cos(anomaly / 2))
    latitude = true + element(q, "argument_of_perigee")

    def corrected(base: mpf, sine: str, cosine: str) -> mpf:
        twice = 2 * latitude
        return base + element(q, sine) * mp.sin(twice) + element(q, cosine) * mp.cos(twice)

    argument = corrected(latitude, "cus", "cuc")
    axis = element(q, "sqrt_a") ** 2
    radius = corrected(axis * (1 - e * mp.cos(anomaly)), "crs", "crc")
    drift = element(q, "inclination_rate") * elapsed
    inclination = corrected(element(q, "inclination") + drift, "cis", "cic")
    rotation = exact(ROTATION_RATE)
    node = (
        element(q, "right_ascension")
        + element(q, "right_ascension_rate") * elapsed
        - rotation * (elapsed + element(q, "toe"))
    )
    plane = multiply(about("z", node), about("x", inclination))
    return sandwich(multiply(plane, about("z", argument)), [radius, mpf(0), mpf(0)])


def clock_at(q: Quantities, options: Options, time: mpf) -> mpf:
    """Give the satellite clock's offset (s): polynomial, relativity, group delay."""
    elapsed = since(time, element(q, "toc"))
    polynomial = mp.polyval([element(q, f"af{k}") for k in (2, 1, 0)], elapsed)
    factor = exact(RELATIVITY[options.get("system", "gps")])
    anomaly = anomaly_at(q, options, time)
    relativity = factor * element(q, "eccentricity") * element(q, "sqrt_a") * mp.sin(anomaly)
    return polynomial + relativity - element(q, "group_delay")


def value(q: Quantities, options: Options) -> Outputs:
    """Give position (m), velocity (m/s, Earth-fixed), clock (s) and clock rate (s/s)."""
    time = q["time"]["value"][0]
    velocity = derivative(lambda t: position_at(q, options, t[0]), [time])
    clock_rate = derivative(lambda t: [clock_at(q, options, t[0])], [time])
    return {
        "position": position_at(q, options, time),
        "velocity": [row[0] for row in velocity],
        "clock": [clock_at(q, options, time)],
        "clock_rate": clock_rate[0],
    }
