"""Files that anybody may have put there are opened in one place, ordinary ones alone."""

import ast
from pathlib import Path

ROOT = Path(__file__).parents[2]
OF_THE_PROGRAM = (
    "app/bench/",
    "app/native/",
    "app/messages/",
    "app/report/html.py",
    "app/formats/performance/symbols.py",
)
"""They read what was installed with them, or wrote it themselves."""
KERNEL = ("app/monitoring/system_info.py",)


def test_nothing_else_opens_files_to_read() -> None:
    found = []
    for path in sorted((ROOT / "app").rglob("*.py")):
        name = path.relative_to(ROOT).as_posix()
        if not name.startswith((*OF_THE_PROGRAM, *KERNEL)):
            found += [f"{name}:{line}" for line in _reading(ast.parse(path.read_text()))]
    assert not found


def _reading(tree: ast.Module) -> list[int]:
    lines = []
    for node in ast.walk(tree):
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
