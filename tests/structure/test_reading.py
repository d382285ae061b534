"""Files that anybody may have put there are opened in one place, ordinary ones alone."""

import ast
from collections.abc import Sequence

from tests.sources import name_of, python_files, reads_tree

OF_THE_PROGRAM = (
    "app/bench/",
    "app/native/",
    "app/messages/",
    "app/formats/arm_models/nominal_arms.py",
    "app/report/html.py",
    "app/formats/performance/symbols.py",
)
"""They read what was installed with them, or wrote it themselves."""
KERNEL = ("app/monitoring/system_info.py",)


def test_nothing_else_opens_files_to_read() -> None:
    assert not [
        f"{name_of(path)}:{line}"
        for path in python_files("app")
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
