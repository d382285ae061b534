"""Docstrings of ``crenel.metrology``: examples run, and sections name what is there."""

import ast
import doctest
import importlib
import re
from collections.abc import Iterator, Sequence

import pytest

from tests.sources import READS_TREE, module_of, python_files, reads_tree, text_of

pytestmark = READS_TREE

SOURCES = {
    module_of(path): path
    for path in python_files("app/crenel/metrology")
    if path.name != "__init__.py"
}
WITH_EXAMPLES = [module for module, path in SOURCES.items() if ">>> " in text_of(path)]
SECTIONS = ("Args", "Returns", "Raises", "Source", "Example")
HEADING = re.compile(r"^([A-Z][a-z]+):$", re.MULTILINE)
ENTRY = re.compile(r"^    (\w[\w, ]*): ", re.MULTILINE)
Documented = tuple[str, set[str], dict[str, str]]
"""A function's name and arguments, and the text of each section of its docstring."""
ERRORS = {"OperationError", "DetectionError", "ValueError", "KeyError"}


@reads_tree
def documented_functions(nodes: Sequence[ast.AST]) -> list[Documented]:
    """The functions whose docstrings have sections."""
    found = []
    for node in nodes:
        if isinstance(node, ast.FunctionDef):
            _, *parts = HEADING.split(ast.get_docstring(node) or "")
            if parts:
                given = (*node.args.posonlyargs, *node.args.args, *node.args.kwonlyargs)
                sections = dict(zip(parts[::2], parts[1::2], strict=True))
                found.append((node.name, {one.arg for one in given}, sections))
    return found


def documented() -> Iterator[Documented]:
    """Each such function of the package, by its whole name."""
    for module, path in SOURCES.items():
        for name, arguments, sections in documented_functions(path):
            yield f"{module}.{name}", arguments, sections


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
    for name, arguments, sections in documented():
        for entry in ENTRY.findall(sections.get("Args", "")):
            assert set(entry.split(", ")) <= arguments, f"{name}: {entry}"


def test_errors_exist() -> None:
    for name, _, sections in documented():
        raised = sections.get("Raises")
        if raised is not None:
            assert set(ENTRY.findall(raised)) <= ERRORS, name
            assert ENTRY.search(raised), name


def test_named_codes_are_raised() -> None:
    """Each code that a docstring names stands in the code of the package."""
    code = "\n".join(map(text_of, SOURCES.values()))
    for name, _, sections in documented():
        for named in re.findall(r"``([a-z]+(?:-[a-z]+)+)``", sections.get("Raises", "")):
            assert f'"{named}"' in code, f"{name}: {named}"
