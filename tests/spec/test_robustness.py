"""Broken specifications of any kind end in SpecError; what is accepted can be derived."""

from __future__ import annotations

import copy
import random
import tomllib
from collections.abc import Iterator
from pathlib import Path
from typing import Any

import pytest

from symnav.derive import derive
from symnav.equations import library
from symnav.equations.model import Model, Role
from symnav.errors import SpecError
from symnav.spec import from_table

DATA = Path(__file__).parents[1] / "data"
ODD: list[Any] = [
    None, True, 0, -1, float("inf"), float("nan"), "", [], {}, "none", "input", [[]], "a -> b",
    "x" * 5000, 10**400, {"block": "position"}, ["position"],
]  # fmt: skip

Place = tuple[str | int, ...]


def readable(folder: Path) -> Iterator[dict[str, Any]]:
    """Every file of a folder that is TOML at all."""
    for path in sorted(folder.rglob("*.toml")):
        try:
            yield tomllib.loads(path.read_text(encoding="utf-8"))
        except tomllib.TOMLDecodeError:
            continue


SPECS = list(readable(DATA / "valid")) + list(readable(DATA / "malformed"))


def places(value: Any, here: Place = ()) -> Iterator[Place]:
    """Paths to every part of a table."""
    if here:
        yield here
    if isinstance(value, dict):
        for key, part in value.items():
            yield from places(part, (*here, key))
    elif isinstance(value, list):
        for index, part in enumerate(value):
            yield from places(part, (*here, index))


def part(value: Any, place: Place) -> Any:
    """The part at a path."""
    for step in place:
        value = value[step]
    return value


POOL = [*ODD, *(part(spec, place) for spec in SPECS for place in places(spec))]
KEYS = sorted({str(step) for spec in SPECS for place in places(spec) for step in place})


def mutated(spec: dict[str, Any], rng: random.Random) -> dict[str, Any]:
    """The specification with one to three parts removed, replaced or added."""
    spec = copy.deepcopy(spec)
    for _ in range(rng.randint(1, 3)):
        known = list(places(spec))
        if not known:
            break
        *above, last = rng.choice(known)
        container = part(spec, tuple(above))
        change = rng.choice(["remove", "replace", "add"])
        if change == "remove":
            del container[last]
        elif change == "replace":
            container[last] = copy.deepcopy(rng.choice(POOL))
        elif isinstance(container, dict):
            container[rng.choice(KEYS)] = copy.deepcopy(rng.choice(POOL))
        else:
            container.append(copy.deepcopy(rng.choice(container)))
    return spec


@pytest.mark.parametrize("seed", range(4))
def test_no_mutation_escapes_validation(seed: int) -> None:
    rng = random.Random(seed)
    refused = 0
    for _ in range(300):
        spec = mutated(rng.choice(SPECS), rng)
        try:
            from_table(spec, "mutant")
        except SpecError as error:
            refused += 1
            assert all(problem.message for problem in error.problems)
    assert 150 < refused < 300


FRAMES = ["b", "n", "e", "s"]


def block_for(role: Role, name: str, rng: random.Random) -> dict[str, Any]:
    """A declaration that may or may not fit a role."""
    size = role.size if isinstance(role.size, int) else 3
    if role.kind == "rotation":
        source, target = rng.sample(FRAMES, 2)
        kind = rng.choice(["rotation", "heading"])
        return {"name": name, "kind": kind, "maps": f"{source} -> {target}"}
    if role.kind == "geodetic" or (role.kind == "point" and rng.random() < 0.4):
        return {"name": name, "kind": "geodetic", "frame": "e", "error_frame": "n"}
    unit = rng.choice(role.units)
    if role.kind == "scalar":
        bounds = {"range": [1e-3, 1.0]} if role.positive else {}
        return {"name": name, "kind": "scalar", "unit": unit, **bounds}
    frame = {"frame": rng.choice(FRAMES)} if role.frame and rng.random() < 0.9 else {}
    return {"name": name, "kind": "vector", "size": size, "unit": unit, **frame}


def bound_at_random(model: Model, rng: random.Random) -> dict[str, Any]:
    """A specification of one entry whose every quantity is bound in a random way."""
    entry: dict[str, Any] = {"name": "function", "model": model.name}
    axes = rng.choice(["ned", "enu"])
    spec: dict[str, Any] = {
        "name": "random",
        "frame": [{"name": "n", "axes": axes}, {"name": "e", "axes": "ecef"}],
        "state": [],
        "input": [],
        model.section: [entry],
    }
    for option in model.options:
        if rng.random() < 0.3:
            entry[option.name] = rng.choice(option.choices)
    share = min(1.0, 4.0 / sum(role.optional for role in model.roles))
    for role in model.roles:
        if role.optional and rng.random() > share:
            continue
        way = rng.choice(["silent", "none", "input", "state", "declared", "constant"])
        if way == "constant":
            size = role.size if isinstance(role.size, int) else 3
            flat = 0.4 if role.kind == "scalar" else [0.4] * size
            entry[role.name] = [1.0, 0.0, 0.0, 0.0] if role.kind == "rotation" else flat
        elif way in ("state", "declared"):
            section = "state" if way == "state" and role.kind != "geodetic" else "input"
            spec[section].append(block_for(role, f"k_{role.name}", rng))
            entry[role.name] = f"k_{role.name}"
        elif way == "input" or (way == "none" and role.optional):
            entry[role.name] = way
    return spec


@pytest.mark.parametrize("name", [name for name in library() if name != "broadcast_orbit"])
def test_what_is_accepted_can_be_derived(name: str) -> None:
    rng = random.Random(name)
    accepted = 0
    for _ in range(80):
        try:
            spec = from_table(bound_at_random(library()[name], rng))
        except SpecError:
            continue
        accepted += 1
        derivation = derive(spec, spec.entries[0], frozenset())
        assert derivation.outputs[0].name == "value"
    assert accepted >= 5
