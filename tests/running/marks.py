"""The marks that say what a test costs, as they stand in the text of its file.

Reading them there tells a process which files its pool needs without importing the others.
"""

import ast
from collections.abc import Iterable, Iterator
from dataclasses import dataclass
from enum import StrEnum
from functools import cache
from pathlib import Path

import pytest


class Cost(StrEnum):
    """What a test costs; one without a mark is quick."""

    SLOW = "slow"
    DEVICE = "device"
    SOAK = "soak"


class Pool(StrEnum):
    """Workers for tests of one kind."""

    COMPUTING = "computing"
    WAITING = "waiting"


COSTS = frozenset(Cost)


@dataclass(frozen=True)
class FileMarks:
    """The costs that a test file names: those of all its tests, and of some test at least."""

    of_all: frozenset[Cost] = frozenset()
    of_some: frozenset[Cost] = frozenset()


@cache
def read_marks(path: Path) -> FileMarks:
    """The marks of a file, as its text has them; none if pytest must say what is wrong with it."""
    try:
        text = path.read_text("utf-8")
        if not any(f".mark.{cost}" in text for cost in Cost):
            return FileMarks()
        tree = ast.parse(text)
    except (OSError, SyntaxError, ValueError):
        return FileMarks()
    of_all = frozenset(
        mark
        for node in tree.body
        if isinstance(node, ast.Assign)
        and any(isinstance(one, ast.Name) and one.id == "pytestmark" for one in node.targets)
        for mark in _marks(node.value)
    )
    return FileMarks(of_all, frozenset(_marks(tree)))


def _marks(tree: ast.AST) -> Iterator[Cost]:
    for node in ast.walk(tree):
        if isinstance(node, ast.Attribute) and node.attr in COSTS:
            match node.value:
                case ast.Attribute(value=ast.Name(id="pytest"), attr="mark"):
                    yield Cost(node.attr)


def pools_of_file(path: Path) -> frozenset[Pool]:
    """The pools that may have to run tests of a file."""
    marks = read_marks(path)
    if Cost.DEVICE in marks.of_all:
        return frozenset({Pool.WAITING})
    return frozenset(Pool) if Cost.DEVICE in marks.of_some else frozenset({Pool.COMPUTING})


def pool_of_test(item: pytest.Item) -> Pool:
    """The pool that runs a test: what waits for devices waits beside the others that do."""
    return Pool.WAITING if item.get_closest_marker(Cost.DEVICE) else Pool.COMPUTING


def test_files(places: Iterable[Path]) -> Iterator[Path]:
    """The test files that are named, and those in the folders that are named."""
    for place in places:
        if place.is_dir():
            yield from sorted(place.rglob("test_*.py"))
        elif place.is_file():
            yield place
