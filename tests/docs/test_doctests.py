"""Docstrings of ``app.metrology``: examples run, and sections name what is there."""

import ast
import doctest
import importlib
import re
from collections.abc import Iterator
from pathlib import Path

import pytest

ROOT = Path(__file__).parents[2]
SOURCES = {
    ".".join(path.relative_to(ROOT).with_suffix("").parts): path.read_text("utf-8")
    for path in sorted((ROOT / "app/metrology").rglob("*.py"))
    if path.name != "__init__.py"
}
WITH_EXAMPLES = [module for module, text in SOURCES.items() if ">>> " in text]
SECTIONS = ("Args", "Returns", "Raises", "Source", "Example")
HEADING = re.compile(r"^([A-Z][a-z]+):$", re.MULTILINE)
ENTRY = re.compile(r"^    (\w[\w, ]*): ", re.MULTILINE)
ERRORS = {"OperationError", "DetectionError", "ValueError", "KeyError"}


def documented() -> Iterator[tuple[str, ast.FunctionDef, dict[str, str]]]:
    """Functions whose docstring has sections, with the text of each section."""
    for module, text in SOURCES.items():
        for node in ast.walk(ast.parse(text)):
            if isinstance(node, ast.FunctionDef):
                _, *parts = HEADING.split(ast.get_docstring(node) or "")
                if parts:
                    yield (
                        f"{module}.{node.name}",
                        node,
                        dict(zip(parts[::2], parts[1::2], strict=True)),
                    )


@pytest.mark.parametrize("module", WITH_EXAMPLES)
def test_examples_run(module: str) -> None:
    found = doctest.testmod(importlib.import_module(module))
    assert found.attempted
    assert not found.failed


def test_examples_are_found() -> None:
    assert len(WITH_EXAMPLES) >= 15


def test_sections_have_one_order() -> None:
    names = []
    for name, _, sections in documented():
        assert list(sections) == [one for one in SECTIONS if one in sections], name
        names.append(name)
    assert len(names) >= 100


def test_arguments_are_those_of_the_function() -> None:
    for name, function, sections in documented():
        given = {
            arg.arg
            for arg in (*function.args.posonlyargs, *function.args.args, *function.args.kwonlyargs)
        }
        for entry in ENTRY.findall(sections.get("Args", "")):
            assert set(entry.split(", ")) <= given, f"{name}: {entry}"


def test_errors_exist() -> None:
    for name, _, sections in documented():
        raised = sections.get("Raises")
        if raised is not None:
            assert set(ENTRY.findall(raised)) <= ERRORS, name
            assert ENTRY.search(raised), name


def test_named_codes_are_raised() -> None:
    """Each code that a docstring names stands in the code of the package."""
    code = "\n".join(SOURCES.values())
    for name, _, sections in documented():
        for named in re.findall(r"``([a-z]+(?:-[a-z]+)+)``", sections.get("Raises", "")):
            assert f'"{named}"' in code, f"{name}: {named}"
