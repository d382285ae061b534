"""The packages import one way only."""

import ast
import sys
from collections import Counter
from collections.abc import Sequence

import pytest

from tests.sources import ALL, PROGRAM, ROOT, name_of, python_files, reads_tree, text_of

NUMERICS = {"numpy", "scipy", "cv2"}
LEAVES = {"app.errors", "app.findings", "app.progress", "app.timestamps"}
"""Modules that every package but ``hardware`` may import."""
MESSAGES = "app.messages"
"""The package that every other may import; it imports none of them."""
LAYERS: dict[str, set[str]] = {
    MESSAGES: set(),
    "app.native": set(),
    "app.metrology": {"app.native"},
    "app.formats": {"app.metrology", "app.native"},
    "app.workflows": {"app.formats", "app.metrology"},
    "app.store": {"app.formats"},
    "app.archive": {"app.store", "app.formats"},
    "app.batch": {"app.archive", "app.workflows", "app.formats", "app.metrology"},
    "app.security": {"app.store"},
    "app.single_sign_on": {"app.formats"},
    "app.station": {"app.workflows", "app.formats", "app.metrology", "app.native", "hardware"},
    "app.guide": {"app.station", "app.workflows", "app.formats", "app.metrology"},
    "app.monitoring": {"app.station", "app.formats"},
    "app.supervision": {"app.station", "app.formats"},
    "app.report": {"app.workflows", "app.formats", "app.metrology"},
    "app.settings": {
        "app.single_sign_on",
        "app.archive",
        "app.guide",
        "app.supervision",
        "app.formats",
        "app.metrology",
    },
    "app.fleet": {
        "app.archive",
        "app.settings",
        "app.single_sign_on",
        "app.supervision",
        "app.formats",
        "app.metrology",
    },
    "app.wire": {
        "app.guide",
        "app.supervision",
        "app.workflows",
        "app.station",
        "app.formats",
        "app.metrology",
    },
    "app.operations": {
        "app.wire",
        "app.settings",
        "app.archive",
        "app.security",
        "app.single_sign_on",
        "app.supervision",
        "app.monitoring",
        "app.guide",
        "app.store",
        "app.station",
        "app.workflows",
        "app.formats",
    },
    "app.api": {
        "app.archive",
        "app.operations",
        "app.wire",
        "app.report",
        "app.security",
        "app.single_sign_on",
        "app.supervision",
        "app.monitoring",
        "app.guide",
        "app.store",
        "app.station",
        "app.workflows",
        "app.formats",
    },
    "hardware": {"app.native"},
}
"""What each package may import apart from itself, ``MESSAGES`` and ``LEAVES``.

``app.server`` puts them together, ``app.cli`` and ``app.bench`` stand above it.
"""


@reads_tree
def imported_modules(nodes: Sequence[ast.AST]) -> frozenset[str]:
    """The modules that a file imports, or imports from; relative ones begin with a point."""
    found: set[str] = set()
    for node in nodes:
        match node:
            case ast.Import():
                found.update(alias.name for alias in node.names)
            case ast.ImportFrom():
                found.add("." * node.level + (node.module or ""))
    return frozenset(found)


def is_within(module: str, package: str) -> bool:
    return module == package or module.startswith(package + ".")


@pytest.mark.parametrize("package", LAYERS)
def test_a_package_imports_only_what_is_below_it(package: str) -> None:
    files = python_files(package.replace(".", "/"))
    assert files
    allowed = {package, *LAYERS[package]}
    if package != MESSAGES:
        allowed |= {MESSAGES} if package == "hardware" else {MESSAGES, *LEAVES}
    for path in files:
        for module in imported_modules(path):
            if module.split(".")[0] in {"app", "hardware", "tests"}:
                assert any(is_within(module, one) for one in allowed), (
                    f"{name_of(path)} imports {module}"
                )


def test_imports_are_absolute() -> None:
    assert not [
        f"{name_of(path)} imports {module}"
        for path in python_files(*ALL)
        for module in imported_modules(path)
        if module.startswith(".")
    ]


def test_the_layers_have_an_order() -> None:
    below = {package: set(allowed) for package, allowed in LAYERS.items()}
    while below:
        lowest = [package for package, others in below.items() if not others & set(below)]
        assert lowest, sorted(below)
        for package in lowest:
            del below[package]


def test_packages_beside_each_other_import_one_way() -> None:
    edges: dict[tuple[str, str], str] = {}
    for path in python_files(*PROGRAM):
        package = ".".join(path.relative_to(ROOT).parent.parts)
        for module in imported_modules(path):
            if module.split(".")[0] in PROGRAM:
                is_package = (ROOT / module.replace(".", "/")).is_dir()
                target = module if is_package else module.rpartition(".")[0]
                if target != package:
                    edges[package, target] = f"{name_of(path)} imports {module}"
    for (package, target), where in edges.items():
        if not (is_within(package, target) or is_within(target, package)):
            assert (target, package) not in edges, f"{where}; {edges[target, package]}"


def test_no_folder_has_many_modules_and_few_are_small() -> None:
    modules = [path for path in python_files(*PROGRAM) if path.name != "__init__.py"]
    (fullest,) = Counter(path.parent for path in modules).most_common(1)
    assert fullest[1] <= 15, fullest
    small = [path for path in modules if len(text_of(path).splitlines()) < 40]
    assert len(small) <= len(modules) / 25, sorted(small)


def test_the_mathematics_uses_numerical_libraries_only() -> None:
    for path in python_files("app/metrology"):
        for module in imported_modules(path):
            top = module.split(".")[0]
            assert top == "app" or top in NUMERICS or top in sys.stdlib_module_names, (
                f"{path.name} imports {module}"
            )
            assert top not in {"time", "socket", "os", "io", "pathlib", "threading"}, (
                f"{path.name} imports {module}"
            )


def test_the_simulator_shares_nothing_with_the_solver() -> None:
    for path in python_files("hardware"):
        for module in imported_modules(path):
            common = is_within(module, "app.native") or is_within(module, MESSAGES)
            assert common or not is_within(module, "app"), f"{name_of(path)} imports {module}"
