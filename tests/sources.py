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
PACKAGES = {"crenel": "app/crenel", "crenel_hardware": "hardware/crenel_hardware"}
"""The folders of the packages that are installed."""
PROGRAM = tuple(PACKAGES.values())
ALL = (*PROGRAM, "tests")
MODULES = (*PACKAGES, "tests")
"""The packages of all Python files but the examples."""

READS_TREE = pytest.mark.xdist_group("tree")
"""For test files that read the whole project: one process runs them all."""

_readings: list[Reading[Any]] = []
_found: dict[Path, dict[Reading[Any], Any]] = {}


@cache
def python_files(*folders: str) -> tuple[Path, ...]:
    """The Python files below folders of the project, in the order of their names.

    Raises:
        ValueError: a folder has none: a test that reads it would check nothing.
    """
    found = {folder: sorted((ROOT / folder).rglob("*.py")) for folder in folders}
    for folder, files in found.items():
        if not files:
            raise ValueError(f"{folder} has no Python files")
    return tuple(path for files in found.values() for path in files)


def name_of(path: Path) -> str:
    """A file as messages name it."""
    return path.relative_to(ROOT).as_posix()


def place_of(module: str) -> str:
    """Where a module is in the project, without its ending."""
    package, point, rest = module.partition(".")
    return PACKAGES.get(package, package) + point.replace(".", "/") + rest.replace(".", "/")


def module_of(path: Path) -> str:
    """The dotted name of a file of the project."""
    name = path.relative_to(ROOT).with_suffix("").as_posix()
    for package, folder in PACKAGES.items():
        if name == folder or name.startswith(f"{folder}/"):
            name = package + name.removeprefix(folder)
    return name.replace("/", ".")


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
