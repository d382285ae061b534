"""Threads are started in one way, so that none dies unnoticed."""

import ast
from collections.abc import Sequence

from tests.sources import PROGRAM, ROOT, name_of, python_files, reads_tree

STARTER = ROOT / "app/loops.py"
MEASUREMENTS = ROOT / "app/bench"
"""They drive a station from outside, and end with it."""


@reads_tree
def names_thread(nodes: Sequence[ast.AST]) -> bool:
    """Whether a file calls ``threading.Thread``, or derives a class from it."""
    makers = [node.func for node in nodes if isinstance(node, ast.Call)]
    makers += [base for node in nodes if isinstance(node, ast.ClassDef) for base in node.bases]
    return any(ast.unparse(one) in ("threading.Thread", "Thread") for one in makers)


def test_threads_are_started_as_loops_and_workers_alone() -> None:
    assert names_thread(STARTER)
    others = [name_of(path) for path in python_files(*PROGRAM) if names_thread(path)]
    allowed = {name_of(STARTER), *map(name_of, MEASUREMENTS.rglob("*.py"))}
    assert not set(others) - allowed
