"""Threads, processes and files that anybody may have put there are begun in one way each."""

import ast
import re
from collections.abc import Sequence
from pathlib import Path

import pytest

from tests.running.imports import files_of_text, mentions
from tests.sources import PROGRAM, READS_TREE, ROOT, name_of, python_files, reads_tree

pytestmark = READS_TREE

STARTER = ROOT / "app/crenel/loops.py"
STARTING = re.compile(
    r"subprocess\.(run|Popen|call|check_\w+)"
    r"|os\.(system|exec\w+|spawn\w+|posix_spawnp?)"
    r"|asyncio\.create_subprocess_\w+"
)
"""What a ``Process`` of multiprocessing runs is imported by the file that starts it."""
OF_THE_PROGRAM = (
    "app/crenel/native/",
    "app/crenel/messages/",
    "app/crenel/formats/arm_models/nominal_arms.py",
    "app/crenel/report/html.py",
    "app/crenel/gauges/plan/document_symbols.py",
)
"""They read what was installed with them, or wrote it themselves."""
KERNEL = ("app/crenel/monitoring/system_info.py",)


@reads_tree
def names_thread(nodes: Sequence[ast.AST]) -> bool:
    """Whether a file calls ``threading.Thread``, or derives a class from it."""
    makers = [node.func for node in nodes if isinstance(node, ast.Call)]
    makers += [base for node in nodes if isinstance(node, ast.ClassDef) for base in node.bases]
    return any(ast.unparse(one) in ("threading.Thread", "Thread") for one in makers)


def test_threads_are_started_as_loops_and_workers_alone() -> None:
    assert names_thread(STARTER)
    others = [name_of(path) for path in python_files(*PROGRAM) if names_thread(path)]
    assert others == [name_of(STARTER)]


@reads_tree
def starting_lines(nodes: Sequence[ast.AST]) -> list[int]:
    """Where a file starts programs."""
    lines = []
    for node in nodes:
        match node:
            case ast.Call(func=ast.Attribute(value=ast.Name(id=module), attr=name)):
                if STARTING.fullmatch(f"{module}.{name}"):
                    lines.append(node.lineno)
    return lines


def says_what_it_starts(path: Path) -> bool:
    found = mentions(path)
    return found.started is not None or any(
        not file.endswith("__init__.py")
        for text in found.texts
        for file in files_of_text(text, path.parent)
    )


@pytest.mark.parametrize("folder", ["tests", *PROGRAM])
def test_a_file_says_what_it_starts(folder: str) -> None:
    assert not [
        f"{name_of(path)}:{lines[0]} starts a program: name the modules that it runs in "
        "STARTED_MODULES, none for a program of others"
        for path in python_files(folder)
        if (lines := starting_lines(path)) and not says_what_it_starts(path)
    ]


def test_nothing_else_opens_files_to_read() -> None:
    assert not [
        f"{name_of(path)}:{line}"
        for path in python_files("app/crenel")
        if not name_of(path).startswith((*OF_THE_PROGRAM, *KERNEL))
        for line in reading_lines(path)
    ]


@reads_tree
def reading_lines(nodes: Sequence[ast.AST]) -> list[int]:
    """Where a file reads files."""
    lines = []
    for node in nodes:
        if not isinstance(node, ast.Call):
            continue
        match node.func:
            case ast.Attribute(attr="read_text" | "read_bytes"):
                lines.append(node.lineno)
            case ast.Name(id="open"):
                mode = node.args[1] if len(node.args) > 1 else None
                writes = isinstance(mode, ast.Constant) and "x" in str(mode.value)
                if not writes:
                    lines.append(node.lineno)
    return lines
