"""What each Python file of the project imports, starts as a process, or names in a text.

A process is seen where its command names a module, as after ``-m``, imports one, as after ``-c``,
or is ``crenel`` beside the interpreter. Where it is another, a constant of the file lists the
modules that run in it: ``STARTED_MODULES = ("docs.examples",)``, where a folder stands for all of
its files, and nothing for a program of others.
"""

import ast
import re
from collections.abc import Iterable, Iterator, Sequence
from dataclasses import dataclass
from functools import cache
from pathlib import Path, PurePath

from tests.sources import ALL, MODULES, ROOT, module_of, name_of, place_of, python_files, reads_tree

FOLDERS = (*ALL, "docs/examples")
STARTED = "STARTED_MODULES"
SERVING, PUBLIC = "app/crenel/__init__.py", "crenel.public"
"""A file that imports what it serves when one of the names is asked for, and where they are."""
COMMAND, RUN_BY_COMMAND = "crenel", "crenel.cli.main"
MODULE = re.compile(rf"\b(?:{'|'.join(MODULES)})(?:\.\w+)+")
FROM = re.compile(r"\bfrom ([\w.]+) import \(?\s*(\w+(?:,\s+\w+)*)")
FILE = re.compile(r"\w[\w/]*\.py")


@dataclass(frozen=True)
class Mentions:
    """What a file mentions by names that can be files of the project."""

    imported: frozenset[str]
    """Modules, and what is imported from them, which may be modules too."""
    started: frozenset[str] | None
    """Modules that it runs in processes as far as it says so; None: it says nothing."""
    texts: frozenset[str]
    """Its strings without its docstrings."""


@reads_tree
def mentions(nodes: Sequence[ast.AST]) -> Mentions:
    imported: set[str] = set()
    started: frozenset[str] | None = None
    docstrings = {id(node.value) for node in nodes if isinstance(node, ast.Expr)}
    texts = set()
    for node in nodes:
        match node:
            case ast.Import():
                imported.update(one.name for one in node.names)
            case ast.ImportFrom(module=str(module)):
                imported.add(module)
                imported.update(f"{module}.{one.name}" for one in node.names)
            case ast.Assign(targets=[ast.Name(id=name)]) if name == STARTED:
                started = (started or frozenset()) | set(ast.literal_eval(node.value))
            case ast.Call(func=ast.Attribute(attr="with_name"), args=[ast.Constant(value=called)]):
                if called == COMMAND:
                    started = (started or frozenset()) | {RUN_BY_COMMAND}
            case ast.Constant(value=str(text)) if id(node) not in docstrings:
                texts.add(text)
    return Mentions(frozenset(imported), started, frozenset(texts))


@cache
def known_files() -> frozenset[str]:
    """The names of the Python files that are looked at."""
    return frozenset(name_of(path) for path in python_files(*FOLDERS))


@cache
def files_of_module(module: str) -> frozenset[str]:
    """The files that an import runs: the module's, and those of the packages that it is in. Of a
    dotted name, as much is taken as is a module."""
    parts = module.split(".")
    places = (place_of(".".join(parts[:count])) for count in range(1, len(parts) + 1))
    ways = (file for place in places for file in (f"{place}.py", f"{place}/__init__.py"))
    return known_files().intersection(ways)


def files_of_start(module: str) -> frozenset[str]:
    """The files that a process runs by an entry of ``STARTED_MODULES``. ValueError: it names
    none."""
    place = place_of(module)
    below = {name for name in known_files() if name.startswith(f"{place}/")}
    if not below and f"{place}.py" not in known_files():
        raise ValueError(f"there is no module {module}")
    return files_of_module(module) | below


def used_files(path: Path) -> frozenset[str]:
    """The files that a file imports, starts or names, and those that pytest imports before it."""
    found, name = mentions(path), name_of(path)
    modules = {module_of(path), *found.imported}
    if name == SERVING:
        modules = {one for one in modules if not one.startswith(PUBLIC)}
    elif any(one.startswith("crenel.") and files_of_module(one) == {SERVING} for one in modules):
        modules.add(PUBLIC)
    used = {file for module in modules for file in files_of_module(module)}
    used |= {file for module in found.started or () for file in files_of_start(module)}
    used |= {file for text in found.texts for file in files_of_text(text, path.parent)}
    if path.name.startswith("test_"):
        used |= {f"{folder}/conftest.py" for folder in PurePath(name).parents} & known_files()
    return frozenset(used - {name})


def files_of_text(text: str, folder: Path) -> Iterator[str]:
    """The files that a text names: modules, those that a program imports, and files by their place
    in the project or beside the text."""
    if "." in text:
        for module in MODULE.findall(text):
            yield from files_of_module(module)
        if FILE.fullmatch(text):
            yield from {text, name_of(folder / text)} & known_files()
    for module, names in FROM.findall(text):
        for one in re.findall(r"\w+", names):
            yield from files_of_module(f"{module}.{one}")


@cache
def users() -> dict[str, frozenset[str]]:
    """The files that use each file directly."""
    found: dict[str, set[str]] = {name: set() for name in known_files()}
    for name in known_files():
        for used in used_files(ROOT / name):
            found[used].add(name)
    return {name: frozenset(those) for name, those in found.items()}


def reached_files(changed: Iterable[str]) -> set[str]:
    """Some files, and those that use them directly or by others."""
    reached = set(changed)
    new = set(reached)
    while new:
        new = set().union(*(users().get(name, frozenset()) for name in new)) - reached
        reached |= new
    return reached
