"""The client's own checks: types, linter and formatter, unit tests of its logic."""

import json
from pathlib import Path
from typing import Any

import pytest
from fluent.syntax import FluentParser
from fluent.syntax.ast import Message as Entry
from fluent.syntax.ast import VariableReference
from fluent.syntax.visitor import Visitor

from crenel.messages.catalogue import renderer
from crenel.messages.language_file import languages, read_sources
from crenel.messages.message import Message, Value, message, quantity, signed, text_to_json
from tests.frontend.node import run_node, run_tool

pytestmark = pytest.mark.device


def test_types() -> None:
    run_node("scripts/generate.mjs")
    run_tool("typescript/bin/tsc", "--noEmit")


def test_linter_and_formatter() -> None:
    run_tool("@biomejs/biome/bin/biome", "check", ".")


def test_units() -> None:
    run_node("scripts/generate.mjs")
    run_tool("vitest/vitest.mjs", "run")


FILLINGS: tuple[Value, ...] = (
    1,
    5,
    quantity(-12.345, "mm", 2),
    signed(0.5, "°", 1),
    "R2-D2",
    message("sentence", text="a part."),
)
"""Each fills all the places of a text in turn."""


def test_browser_and_station_put_messages_into_the_same_words(tmp_path: Path) -> None:
    files = {}
    for language in languages():
        render = renderer(language)
        source = "".join(read_sources(language).values())
        cases: list[dict[str, Any]] = []
        for text_id, places in places_by_id(source).items():
            for filling in FILLINGS if places else FILLINGS[:1]:
                text = Message(text_id, dict.fromkeys(places, filling))
                cases.append({"text": text_to_json(text), "words": render(text)})
        files[language] = {"source": source, "cases": cases}
    path = tmp_path / "renderings.json"
    path.write_text(json.dumps(files), encoding="utf-8")
    env = {"CRENEL_RENDERINGS": str(path)}
    output = run_tool("vitest/vitest.mjs", "run", "src/messages/parity.test.ts", env=env)
    assert "1 passed" in output


class PlaceFinder(Visitor):
    """The names of the places in a text."""

    def __init__(self) -> None:
        self.names: set[str] = set()

    def visit_VariableReference(self, node: VariableReference) -> None:  # noqa: N802
        self.names.add(node.id.name)


def places_by_id(source: str) -> dict[str, list[str]]:
    """The ids of a language file, each with the names of its places."""
    found = {}
    for entry in FluentParser().parse(source).body:
        if isinstance(entry, Entry):
            finder = PlaceFinder()
            finder.visit(entry)
            found[entry.id.name] = sorted(finder.names)
    return found
