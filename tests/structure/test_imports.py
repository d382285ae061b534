"""The packages import one way only."""

import ast
import sys
from collections import Counter
from collections.abc import Iterator, Sequence
from pathlib import Path

import pytest

from tests.sources import ALL, PROGRAM, READS_TREE, ROOT, name_of, python_files, reads_tree, text_of

pytestmark = READS_TREE

NUMERICS = {"numpy", "scipy", "cv2"}
OUTSIDE = {"time", "socket", "os", "io", "pathlib", "threading"}
"""Modules by which mathematics would depend on more than its arguments."""
EVERYWHERE = {"app.loop_states", "app.loops", "app.rotations"}
"""The modules that every package may import."""
LEAVES = {"app.errors", "app.findings", *EVERYWHERE, "app.progress", "app.timestamps", "app.units"}
"""Modules that every package but ``hardware`` may import."""
MESSAGES = "app.messages"
"""The package that every other may import; it imports none of them."""


def in_app(*names: str) -> set[str]:
    return {f"app.{name}" for name in names}


DATA = ("formats", "metrology")
BELOW_OPERATIONS = (
    *("archive", "security", "single_sign_on", "supervision", "monitoring"),
    *("guide", "store", "station", "workflows", "formats"),
)
LAYERS: dict[str, set[str]] = {
    MESSAGES: set(),
    "app.native": set(),
    "app.metrology": in_app("native"),
    "app.formats": in_app("metrology", "native"),
    "app.workflows": in_app(*DATA),
    "app.store": in_app("formats"),
    "app.archive": in_app("store", "formats"),
    "app.batch": in_app("archive", "workflows", *DATA),
    "app.security": in_app("store"),
    "app.single_sign_on": in_app("formats"),
    "app.station": in_app("workflows", *DATA, "native") | {"hardware"},
    "app.guide": in_app("station", "workflows", *DATA),
    "app.monitoring": in_app("station", "formats"),
    "app.supervision": in_app("station", "formats"),
    "app.report": in_app("workflows", *DATA),
    "app.settings": in_app("single_sign_on", "archive", "guide", "supervision", *DATA),
    "app.fleet": in_app("archive", "settings", "single_sign_on", "supervision", *DATA),
    "app.wire": in_app("guide", "supervision", "workflows", "station", *DATA),
    "app.operations": in_app("wire", "settings", *BELOW_OPERATIONS),
    "app.api": in_app("operations", "wire", "report", *BELOW_OPERATIONS),
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


def imports(*folders: str) -> Iterator[tuple[Path, str]]:
    """Each file below folders of the project with each module that it imports."""
    for path in python_files(*folders):
        yield from ((path, module) for module in imported_modules(path))


def is_within(module: str, package: str) -> bool:
    return module == package or module.startswith(package + ".")


@pytest.mark.parametrize("package", LAYERS)
def test_a_package_imports_only_what_is_below_it(package: str) -> None:
    folder = package.replace(".", "/")
    assert python_files(folder)
    allowed = {package, *LAYERS[package]}
    if package != MESSAGES:
        allowed |= {MESSAGES, *EVERYWHERE} if package == "hardware" else {MESSAGES, *LEAVES}
    for path, module in imports(folder):
        if module.split(".")[0] in {"app", "hardware", "tests"}:
            within = any(is_within(module, one) for one in allowed)
            assert within, f"{name_of(path)} imports {module}"


def test_imports_are_absolute() -> None:
    relative = [(name_of(path), module) for path, module in imports(*ALL) if module[:1] == "."]
    assert not relative


def test_the_layers_have_an_order() -> None:
    below = {package: set(allowed) for package, allowed in LAYERS.items()}
    while below:
        lowest = [package for package, others in below.items() if not others & set(below)]
        assert lowest, sorted(below)
        for package in lowest:
            del below[package]


def test_packages_beside_each_other_import_one_way() -> None:
    edges: dict[tuple[str, str], str] = {}
    for path, module in imports(*PROGRAM):
        package = ".".join(path.relative_to(ROOT).parent.parts)
        if module.split(".")[0] in PROGRAM:
            is_package = (ROOT / module.replace(".", "/")).is_dir()
            target = module if is_package else module.rpartition(".")[0]
            if target != package and module not in EVERYWHERE:
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
    for path, module in imports("app/metrology"):
        top = module.split(".")[0]
        allowed = top == "app" or top in NUMERICS or top in sys.stdlib_module_names - OUTSIDE
        assert allowed, f"{path.name} imports {module}"


def test_the_simulator_shares_nothing_with_the_solver() -> None:
    for path, module in imports("hardware"):
        common = any(is_within(module, one) for one in ("app.native", MESSAGES, *EVERYWHERE))
        assert common or not is_within(module, "app"), f"{name_of(path)} imports {module}"
