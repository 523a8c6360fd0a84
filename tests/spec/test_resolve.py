"""Frames of roles: what bindings decide, in whichever direction rotations are stored."""

from __future__ import annotations

from collections.abc import Mapping

from symnav.equations import library
from symnav.equations.model import Model
from symnav.spec.resolve import Held, complete, resolve

GPS = library()["gnss_position"]
RANGE = library()["pseudorange"]
FORCE = library()["specific_force"]
AXES = {"n": "ned", "e": "ecef"}


def vector(name: str, frame: str | None) -> Held:
    """A vector bound under that name."""
    return Held(f"block {name!r}", frame)


def turn(source: str, target: str) -> Held:
    """A rotation block."""
    return Held("block 'q'", ends=(source, target))


def solved(model: Model, held: Mapping[str, Held]) -> dict[str, str]:
    """Frames of every role, once no problem was found."""
    found = resolve(model, held, AXES)
    assert found.problems == ()
    return complete(model, held, found.frames, AXES)


def faults(model: Model, held: Mapping[str, Held]) -> dict[str, str]:
    """Problems by role."""
    return dict(resolve(model, held, AXES).problems)


def test_a_rotation_serves_in_both_directions() -> None:
    for attitude in (turn("b", "n"), turn("n", "b")):
        frames = solved(GPS, {"position": vector("p", "n"), "attitude": attitude})
        assert (frames["body"], frames["state"]) == ("b", "n")


def test_without_observer_the_observer_is_the_state_frame() -> None:
    frames = solved(GPS, {"position": vector("p", "n")})
    assert frames["observer"] == frames["state"] == "n"


def test_an_observer_leads_elsewhere() -> None:
    held = {"position": vector("p", "n"), "heading": turn("g", "n")}
    assert solved(GPS, held)["observer"] == "g"


def test_unknown_inputs_learn_their_frame() -> None:
    held = {
        "position": vector("p", "n"),
        "attitude": turn("n", "b"),
        "lever_arm": Held("input 'lever_arm'"),
    }
    assert solved(GPS, held)["body"] == "b"


def test_nothing_known_keeps_the_names_of_the_roles() -> None:
    held = {"attitude": Held("input"), "delta_theta": Held("input")}
    assert solved(FORCE, held) == {"body": "body", "nav": "nav"}


def test_without_attitude_body_and_navigation_frame_are_one() -> None:
    frames = solved(FORCE, {"delta_theta": vector("a", "b")})
    assert frames["body"] == frames["nav"] == "b"


def test_a_geodetic_point_brings_its_own_rotation() -> None:
    held = {
        "position": Held("block 'place'", "e", level=("n", "e")),
        "attitude": turn("b", "n"),
        "satellite_position": Held("input"),
    }
    frames = solved(RANGE, held)
    assert (frames["ecef"], frames["nav"], frames["body"]) == ("e", "n", "b")


def test_declared_axes_tell_the_ends_of_a_rotation_apart() -> None:
    for attitude in (turn("u", "n"), turn("n", "u")):
        assert solved(FORCE, {"attitude": attitude})["body"] == "u"


def test_names_tell_the_ends_apart_where_axes_do_not() -> None:
    for attitude in (turn("b", "i"), turn("i", "b")):
        assert solved(FORCE, {"attitude": attitude})["body"] == "b"


def test_an_ambiguous_rotation_is_refused() -> None:
    found = faults(FORCE, {"attitude": turn("u", "v")})
    assert "nothing tells which of the two is the body frame" in found["attitude"]


def test_a_local_position_needs_a_rotation_to_the_earth() -> None:
    found = faults(RANGE, {"position": vector("p", "n")})
    assert "leads to frame 'n' with axes 'ned'" in found["position"]


def test_an_earth_fixed_frame_is_not_rotated_to_the_earth() -> None:
    held = {"satellite_position": vector("s", "f"), "nav_to_ecef": turn("e", "f")}
    assert "earth-fixed already" in faults(RANGE, held)["nav_to_ecef"]


def test_a_misplaced_vector_is_named_with_the_rotation_that_says_so() -> None:
    held = {
        "position": vector("p", "n"),
        "attitude": turn("b", "n"),
        "lever_arm": vector("arm", "n"),
    }
    assert faults(GPS, held) == {
        "lever_arm": "block 'arm' is in frame 'n', but gnss_position needs it in frame 'b' "
        "(attitude maps b -> n)"
    }


def test_vectors_of_one_role_must_agree() -> None:
    held = {"position": vector("p", "n"), "offset": vector("o", "m")}
    assert faults(GPS, held) == {
        "offset": "block 'o' is in frame 'm', but gnss_position needs it in frame 'n' "
        "(that of position)"
    }


def test_a_missing_rotation_is_asked_for() -> None:
    held = {"position": vector("p", "n"), "lever_arm": vector("arm", "b")}
    assert "bind attitude to a rotation between them" in faults(GPS, held)["attitude"]
