"""The rooms import one way only."""

import ast
from collections.abc import Iterator
from pathlib import Path

import pytest

ROOT = Path(__file__).resolve().parents[2]

NUMERICS = {"numpy", "scipy", "cv2"}
ROOMS_ALLOWED = {
    # how C code is built, loaded and called: beneath all that has loops
    "app.native": {"app.native"},
    "app.metrology": {"app.metrology", "app.native"},
    "app.files": {"app.files", "app.metrology", "app.native"},
    # it measures all of them, up to the whole station
    "app.bench": {
        "app.bench",
        "app.demonstration",
        "app.main",
        "app.serving",
        "app.start",
        "app.console",
        "app.store",
        "app.api",
        "app.station",
        "app.metrology",
        "app.native",
        "app.files",
        "hardware",
    },
    "app.station": {"app.station", "app.metrology", "app.native", "app.files", "hardware"},
    "app.guide": {"app.guide", "app.station", "app.files", "app.metrology"},
    "app.store": {"app.store", "app.files", "app.metrology"},
    "app.supervise": {"app.supervise", "app.station", "app.files", "app.metrology"},
    "app.strings": {"app.strings"},
    "app.report": {"app.report", "app.strings", "app.files", "app.metrology"},
    "app.api": {
        "app.report",
        "app.strings",
        "app.api",
        "app.store",
        "app.supervise",
        "app.guide",
        "app.station",
        "app.files",
        "app.metrology",
        "hardware",
    },
    "hardware": {"hardware", "app.native"},
}


def imported_modules(path: Path) -> Iterator[str]:
    for node in ast.walk(ast.parse(path.read_text())):
        if isinstance(node, ast.Import):
            yield from (alias.name for alias in node.names)
        elif isinstance(node, ast.ImportFrom):
            assert node.level == 0, f"{path}: relative import"
            assert node.module is not None
            yield node.module


def is_within(module: str, room: str) -> bool:
    return module == room or module.startswith(room + ".")


@pytest.mark.parametrize("room", ROOMS_ALLOWED)
def test_a_room_imports_only_what_it_may(room: str) -> None:
    files = sorted((ROOT / room.replace(".", "/")).rglob("*.py"))
    assert files
    for path in files:
        for module in imported_modules(path):
            if module.split(".")[0] in {"app", "hardware", "tests"}:
                assert any(is_within(module, allowed) for allowed in ROOMS_ALLOWED[room]), (
                    f"{path.relative_to(ROOT)} imports {module}"
                )


def test_the_mathematics_uses_numerical_libraries_only() -> None:
    import sys

    for path in sorted((ROOT / "app/metrology").rglob("*.py")):
        for module in imported_modules(path):
            top = module.split(".")[0]
            assert top == "app" or top in NUMERICS or top in sys.stdlib_module_names, (
                f"{path.name} imports {module}"
            )
            assert top not in {"time", "socket", "os", "io", "pathlib", "threading"}, (
                f"{path.name} imports {module}"
            )


def test_the_twin_shares_nothing_with_the_solver() -> None:
    for path in sorted((ROOT / "hardware").rglob("*.py")):
        for module in imported_modules(path):
            shared = is_within(module, "app") and not is_within(module, "app.native")
            assert not shared, f"{path.relative_to(ROOT)} imports {module}"
