"""The published JSON Schema is current and fits what the examples write."""

from __future__ import annotations

import json
import tomllib
from pathlib import Path

import pytest

from symnav.spec import json_schema
from symnav.spec.schema import SECTIONS, STATE_TABLES

ROOT = Path(__file__).parents[2]
PUBLISHED = ROOT / "docs" / "spec.schema.json"


def test_the_published_schema_is_current() -> None:
    text = json.dumps(json_schema(), indent=2, sort_keys=True) + "\n"
    assert PUBLISHED.read_text(encoding="utf-8") == text


def test_every_section_and_kind_is_described() -> None:
    schema = json_schema()
    assert set(SECTIONS) | {"state", "name", "scalar", "scalars"} <= set(schema["properties"])
    names = {table.__name__ for table in (*SECTIONS.values(), *STATE_TABLES.values())}
    assert names <= set(schema["$defs"])
    bindings = schema["$defs"]["EntryTable"]["additionalProperties"]
    assert {"type": ["string", "number", "boolean"]} in bindings["anyOf"]


@pytest.mark.parametrize("path", sorted((ROOT / "tests/data/valid").glob("*.toml")), ids=str)
def test_the_schema_knows_every_key_of_the_examples(path: Path) -> None:
    schema, text = json_schema(), tomllib.loads(path.read_text(encoding="utf-8"))
    assert set(text) <= set(schema["properties"])
    for row in text["state"]:
        known = schema["$defs"][STATE_TABLES[row["kind"]].__name__]["properties"]
        assert set(row) <= set(known)
