"""The house rules: who may import whom, how long a file may be, what must not exist."""

from __future__ import annotations

import ast
from collections.abc import Iterator
from pathlib import Path

import pytest

import symnav

PACKAGE = Path(symnav.__file__).parent
TEMPLATES = PACKAGE.parent / "templates"
TESTS = Path(__file__).parent
LONGEST = 450

ROOMS = (
    "errors", "units", "naming", "figures", "single", "graph", "quantities", "frames", "blocks",
    "layout", "equations", "spec", "binding", "elimination", "derive", "trigonometry", "ir",
    "lower", "emit", "build", "verify", "export", "pipeline", "bench", "report", "demo", "cli",
)  # fmt: skip
"""From the foundations up; a module imports only from its own room and the ones before it."""

DOOR = "__main__"
"""``python -m symnav``: stands outside and may open any room."""


def modules() -> list[Path]:
    """Every module of the package."""
    return sorted(PACKAGE.rglob("*.py"))


def name_of(path: Path) -> str:
    """Its dotted name below symnav: ``emit.c.target``; empty for symnav itself."""
    parts = path.relative_to(PACKAGE).with_suffix("").parts
    return ".".join(parts[:-1] if parts[-1] == "__init__" else parts)


def imports(path: Path) -> Iterator[str]:
    """The dotted names a module imports, wherever in the file and for whatever purpose."""
    for node in ast.walk(ast.parse(path.read_text(encoding="utf-8"))):
        if isinstance(node, ast.Import):
            yield from (alias.name for alias in node.names)
        elif isinstance(node, ast.ImportFrom):
            assert node.level == 0, f"{path}: relative import"
            yield from (f"{node.module}.{alias.name}" for alias in node.names)


def room(dotted: str) -> str:
    """The room of a name below symnav."""
    return dotted.partition(".")[0]


def rooms_entered(path: Path) -> set[str]:
    """The rooms a module imports from; names of symnav itself are open to all."""
    inside = (name.removeprefix("symnav.") for name in imports(path) if name.startswith("symnav."))
    return {room(name) for name in inside if room(name) in ROOMS}


def modules_entered(path: Path, names: set[str]) -> set[str]:
    """The modules of the package a module imports, faces of folders left out."""
    inside = {name.removeprefix("symnav.") for name in imports(path) if name.startswith("symnav.")}
    found = {dotted if dotted in names else dotted.rpartition(".")[0] for dotted in inside}
    faces = {name for name in names if (PACKAGE / name.replace(".", "/")).is_dir()}
    return (found & names) - faces - {name_of(path)}


def libraries(path: Path) -> set[str]:
    """The top-level packages a module imports."""
    return {name.partition(".")[0] for name in imports(path)}


def in_room(*names: str) -> list[Path]:
    """The modules of some rooms."""
    return [path for path in modules() if room(name_of(path)) in names]


def test_every_module_has_a_room() -> None:
    """Nothing stands outside the list."""
    outside = {room(name_of(path)) for path in modules()} - set(ROOMS) - {"", DOOR}
    assert outside == set()


@pytest.mark.parametrize("path", modules(), ids=name_of)
def test_imports_go_one_way(path: Path) -> None:
    """A module imports only from its own room and those above it in the list."""
    own = room(name_of(path))
    if own == DOOR:
        return
    allowed = set(ROOMS[: ROOMS.index(own) + 1]) if own else set()
    assert rooms_entered(path) <= allowed


def test_imports_have_no_circle() -> None:
    """Inside a room as well, something can be read first."""
    names = {name_of(path) for path in modules()}
    waiting = {name_of(path): modules_entered(path, names) for path in modules()}
    while ready := {name for name, needed in waiting.items() if not needed & waiting.keys()}:
        waiting = {name: needed for name, needed in waiting.items() if name not in ready}
    assert waiting == {}


def test_only_lowering_imports_casadi() -> None:
    """CasADi stays behind one door: the files of ``lower`` that are named after it."""
    users = {name_of(path) for path in modules() if "casadi" in libraries(path)}
    assert {name for name in users if not name.startswith("lower.casadi")} == set()
    assert users


def test_emission_knows_no_algebra() -> None:
    """Emitters read the intermediate representation and nothing else."""
    emitters = in_room("emit")
    assert emitters
    for path in emitters:
        assert libraries(path) & {"sympy", "casadi"} == set(), name_of(path)


def test_verification_does_not_see_emission() -> None:
    """A proof that shared code with what it proves would prove less."""
    for path in in_room("verify"):
        assert "emit" not in rooms_entered(path), name_of(path)


def test_demonstration_runs_what_is_handed_to_it() -> None:
    """Only its wiring reaches into the pipeline."""
    for path in in_room("demo"):
        entered = rooms_entered(path) - {"demo", "errors"}
        assert not entered or name_of(path) == "demo.wiring", (name_of(path), entered)


def test_command_line_starts_light() -> None:
    """At module level the command line imports click, the standard library and its own room."""
    heavy = {"sympy", "casadi", "numpy", "pydantic", "rich", "jinja2", "cffi"}
    for path in in_room("cli"):
        body = ast.parse(path.read_text(encoding="utf-8")).body
        names = [a.name for node in body if isinstance(node, ast.Import) for a in node.names]
        names += [str(node.module) for node in body if isinstance(node, ast.ImportFrom)]
        assert {name.partition(".")[0] for name in names} & heavy == set(), name_of(path)
        rooms = {room(n.removeprefix("symnav.")) for n in names if n.startswith("symnav.")}
        assert rooms <= {"cli", "errors"}, name_of(path)


def test_rules_see_a_breach(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    """The tests above would notice: imports inside functions and type-checking blocks count."""
    (tmp_path / "layout.py").write_text(
        "from typing import TYPE_CHECKING\n"
        "if TYPE_CHECKING:\n    from symnav.spec import records\n"
        "def f():\n    import casadi\n    from symnav import pipeline\n"
    )
    monkeypatch.setattr("tests.test_house.PACKAGE", tmp_path)
    breach = tmp_path / "layout.py"
    assert rooms_entered(breach) == {"spec", "pipeline"}
    assert "casadi" in libraries(breach)
    with pytest.raises(AssertionError):
        test_imports_go_one_way(breach)
    with pytest.raises(AssertionError):
        test_only_lowering_imports_casadi()


def sources() -> list[Path]:
    """Every file that people edit: the package, the templates and the tests."""
    templates = (path for path in TEMPLATES.rglob("*") if path.is_file())
    found = [*modules(), *templates, *TESTS.rglob("*.py")]
    return sorted(path for path in found if "__pycache__" not in path.parts)


def test_files_stay_short() -> None:
    """A file is read in one sitting."""
    lengths = {path: len(path.read_text(encoding="utf-8").splitlines()) for path in sources()}
    assert {str(path): n for path, n in lengths.items() if n > LONGEST} == {}


def test_no_drawer_for_leftovers() -> None:
    """What a module is for is in its name."""
    names = {"utils", "util", "helpers", "misc", "common"}
    assert [path for path in sources() if path.stem in names] == []
