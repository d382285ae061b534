"""A file that starts processes says what runs in them, which no import shows."""

import ast
import re
from collections.abc import Sequence
from pathlib import Path

import pytest

from tests.running.imports import files_of_text, mentions
from tests.sources import PROGRAM, name_of, python_files, reads_tree

STARTING = re.compile(
    r"subprocess\.(run|Popen|call|check_\w+)"
    r"|os\.(system|exec\w+|spawn\w+|posix_spawnp?)"
    r"|asyncio\.create_subprocess_\w+"
)
"""What a ``Process`` of multiprocessing runs is imported by the file that starts it."""
WITHOUT_MODULES = {
    "app/bench/faults/broker/mosquitto.py": "a broker",
    "app/bench/faults/damage.py": "another user's Python, to see whether it may read this",
    "app/bench/fleet/dask_processes.py": "workers that are sent what they run",
    "app/bench/fleet/s3_server.py": "a server",
    "app/bench/station/camera.py": "a camera",
}
"""Measuring programs that start programs of others."""


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
        if name_of(path) not in WITHOUT_MODULES
    ]


def test_the_files_of_programs_of_others_start_some() -> None:
    starting = {name_of(path) for path in python_files(*PROGRAM) if starting_lines(path)}
    assert starting > WITHOUT_MODULES.keys()
