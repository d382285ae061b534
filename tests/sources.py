"""The project's Python files for tests that read them: a process parses each file once."""

import ast
from collections.abc import Callable, Sequence
from functools import cache
from pathlib import Path
from typing import Any, TypeVar

import pytest

T = TypeVar("T")
Reading = Callable[[Sequence[ast.AST]], T]

ROOT = Path(__file__).resolve().parents[1]
PROGRAM = ("app", "hardware")
"""The folders of what is installed."""
ALL = (*PROGRAM, "tests")

READS_TREE = pytest.mark.xdist_group("tree")
"""For test files that read the whole project: one process runs them all."""

_readings: list[Reading[Any]] = []
_found: dict[Path, dict[Reading[Any], Any]] = {}


@cache
def python_files(*folders: str) -> tuple[Path, ...]:
    """The Python files below folders of the project, in the order of their names."""
    return tuple(path for folder in folders for path in sorted((ROOT / folder).rglob("*.py")))


def name_of(path: Path) -> str:
    """A file as messages name it."""
    return path.relative_to(ROOT).as_posix()


@cache
def text_of(path: Path) -> str:
    """The text of a file, which does not change while tests run."""
    return path.read_text("utf-8")


def reads_tree(reading: Reading[T]) -> Callable[[Path], T]:
    """Makes a function of a file from one of its nodes: the module first, then all below it.

    The first that asks for a file has every such function read it, and only what they found is
    kept: the trees of all files would take 350 MB.
    """
    _readings.append(reading)

    def read(path: Path) -> T:
        found = _found.setdefault(path, {})
        if reading not in found:
            nodes = list(ast.walk(ast.parse(text_of(path), str(path))))
            found.update((one, one(nodes)) for one in _readings)
        known: T = found[reading]
        return known

    return read
