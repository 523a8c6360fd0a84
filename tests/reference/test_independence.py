"""The references stand alone: what they import, and that they load from any place."""

import ast
import importlib
import importlib.util
import sys
from pathlib import Path

import pytest
from mpmath import mpf

FOLDER = Path(__file__).parent
SOURCES = [
    file
    for file in sorted(FOLDER.glob("*.py"))
    if not file.name.startswith(("test_", "conftest", "__"))
]


@pytest.mark.parametrize("source", SOURCES, ids=lambda file: file.stem)
def test_imports(source: Path) -> None:
    """Only mpmath, the standard library and one another."""
    for node in ast.walk(ast.parse(source.read_text(encoding="utf-8"))):
        if isinstance(node, ast.Import):
            roots = {alias.name.split(".")[0] for alias in node.names}
        elif isinstance(node, ast.ImportFrom) and node.level == 0:
            roots = {str(node.module).split(".")[0]}
        else:
            continue
        assert roots <= sys.stdlib_module_names | {"mpmath"}


def test_loads_as_a_package_of_another_name(monkeypatch: pytest.MonkeyPatch) -> None:
    """A folder of references needs neither its parent nor a search path."""
    name = "references_elsewhere"
    spec = importlib.util.spec_from_file_location(
        name, FOLDER / "__init__.py", submodule_search_locations=[str(FOLDER)]
    )
    assert spec is not None
    assert spec.loader is not None
    package = importlib.util.module_from_spec(spec)
    monkeypatch.setitem(sys.modules, name, package)
    spec.loader.exec_module(package)
    model = importlib.import_module(f"{name}.gnss_position")
    outputs = model.value({"position": {"value": [mpf(1), mpf(2), mpf(3)], "frame": "n"}}, {})
    assert outputs == {"value": [1, 2, 3]}
    for module in [key for key in sys.modules if key.startswith(f"{name}.")]:
        monkeypatch.delitem(sys.modules, module)
