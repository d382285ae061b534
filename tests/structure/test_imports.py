"""The packages import one way only."""

import ast
import sys
from collections import Counter
from collections.abc import Iterator, Sequence
from functools import cache
from pathlib import Path

import pytest

from tests.sources import (
    ALL,
    MODULES,
    PACKAGES,
    PROGRAM,
    READS_TREE,
    ROOT,
    module_of,
    name_of,
    place_of,
    python_files,
    reads_tree,
    text_of,
)

pytestmark = READS_TREE

NUMERICS = {"numpy", "scipy", "cv2"}
OUTSIDE = {"time", "socket", "os", "io", "pathlib", "threading"}
"""Modules by which mathematics would depend on more than its arguments."""
EVERYWHERE = {"crenel.loop_states", "crenel.loops", "crenel.rotations"}
"""The modules that every package may import."""
LEAVES = {
    "crenel.errors",
    "crenel.findings",
    *EVERYWHERE,
    "crenel.progress",
    "crenel.timestamps",
    "crenel.units",
}
"""Modules that every package but ``crenel_hardware`` may import."""
SUBJECTS = ("crenel.gauges", "crenel.parts")
"""Packages of one subject each, whose modules are of several layers."""
LAYER_NAMES = {
    "maths": "crenel.metrology",
    "document": "crenel.formats",
    "exchange": "crenel.formats",
    "evaluate": "crenel.workflows",
    "session": "crenel.guide",
    "guide": "crenel.guide",
    "kinds": "crenel.guide",
    "report": "crenel.report",
    "routes": "crenel.api",
    "command_line": "crenel.cli",
}
"""The layer of a module of a subject, by how its name begins, or else that of its folder."""
MESSAGES = "crenel.messages"
"""The package that every other may import; it imports none of them."""


def in_app(*names: str) -> set[str]:
    return {f"crenel.{name}" for name in names}


DATA = ("formats", "metrology")
BELOW_OPERATIONS = (
    *("archive", "security", "single_sign_on", "supervision", "monitoring"),
    *("guide", "store", "station", "workflows", "formats"),
)
LAYERS: dict[str, set[str]] = {
    MESSAGES: set(),
    "crenel.native": set(),
    "crenel.metrology": in_app("native"),
    "crenel.formats": in_app("metrology", "native"),
    "crenel.workflows": in_app(*DATA),
    "crenel.store": in_app("formats"),
    "crenel.archive": in_app("store", "formats"),
    "crenel.batch": in_app("archive", "workflows", *DATA),
    "crenel.security": in_app("store"),
    "crenel.single_sign_on": in_app("formats"),
    "crenel.station": in_app("workflows", *DATA, "native") | {"crenel_hardware"},
    "crenel.guide": in_app("station", "store", "workflows", *DATA),
    "crenel.monitoring": in_app("station", "formats"),
    "crenel.supervision": in_app("station", "formats"),
    "crenel.report": in_app("workflows", *DATA),
    "crenel.settings": in_app("single_sign_on", "archive", "guide", "supervision", *DATA),
    "crenel.fleet": in_app("archive", "settings", "single_sign_on", "supervision", *DATA),
    "crenel.wire": in_app("guide", "supervision", "workflows", "station", *DATA),
    "crenel.operations": in_app("wire", "settings", *BELOW_OPERATIONS),
    "crenel.api": in_app("operations", "wire", "report", *BELOW_OPERATIONS),
    "crenel_hardware": {"crenel.native"},
}
"""What each package may import apart from itself, ``MESSAGES`` and ``LEAVES``.

``crenel.server`` puts them together, ``crenel.cli`` and ``tests.bench`` stand above it.
"""


@cache
def is_module(name: str) -> bool:
    """Whether a file of the project has this dotted name."""
    return (ROOT / f"{place_of(name)}.py").is_file()


@reads_tree
def imported_modules(nodes: Sequence[ast.AST]) -> frozenset[str]:
    """The modules that a file imports, or imports from; relative ones begin with a point."""
    found: set[str] = set()
    for node in nodes:
        match node:
            case ast.Import():
                found.update(alias.name for alias in node.names)
            case ast.ImportFrom():
                package = "." * node.level + (node.module or "")
                whole = [f"{package}.{alias.name}" for alias in node.names]
                found.update(one if is_module(one) else package for one in whole)
    return frozenset(found)


def imports(*folders: str) -> Iterator[tuple[Path, str]]:
    """Each file below folders of the project with each module that it imports."""
    for path in python_files(*folders):
        yield from ((path, module) for module in imported_modules(path))


def is_within(module: str, package: str) -> bool:
    return module == package or module.startswith(package + ".")


def layer_of(module: str) -> str:
    """The package to whose layer a module of a subject belongs; other modules are their own.

    Raises:
        ValueError: neither the module nor a folder of it names a layer.
    """
    for subject in SUBJECTS:
        if is_within(module, subject):
            for part in reversed(module.removeprefix(subject).split(".")):
                for name, layer in LAYER_NAMES.items():
                    if part == name or part.startswith(f"{name}_"):
                        return layer
            raise ValueError(f"{module} does not say of which layer it is")
    return module


def files_of_layer(package: str) -> list[Path]:
    """The files of a package, and those of its layer in the subjects."""
    subjects = python_files(*map(place_of, SUBJECTS))
    named = [one for one in subjects if one.name != "__init__.py"]
    return [
        *python_files(place_of(package)),
        *(one for one in named if layer_of(module_of(one)) == package),
    ]


@pytest.mark.parametrize("package", LAYERS)
def test_a_package_imports_only_what_is_below_it(package: str) -> None:
    allowed = {package, *LAYERS[package]}
    if package != MESSAGES:
        allowed |= {MESSAGES, *EVERYWHERE} if package == "crenel_hardware" else {MESSAGES, *LEAVES}
    for path in files_of_layer(package):
        for module in imported_modules(path):
            if module.split(".")[0] in MODULES:
                within = any(is_within(layer_of(module), one) for one in allowed)
                assert within, f"{name_of(path)} imports {module}"


@pytest.mark.parametrize("subject", SUBJECTS)
def test_each_module_of_a_subject_says_its_layer(subject: str) -> None:
    modules = [path for path in python_files(place_of(subject)) if path.name != "__init__.py"]
    assert {layer_of(module_of(path)) for path in modules} <= {*LAYERS, "crenel.cli"}
    with pytest.raises(ValueError, match=f"{subject}.other.module does not say"):
        layer_of(f"{subject}.other.module")


def test_the_layer_of_a_module_is_named_by_it_or_by_its_folder() -> None:
    assert layer_of("crenel.gauges.sphere.maths_pattern") == "crenel.metrology"
    assert layer_of("crenel.gauges.guide") == "crenel.guide"
    assert layer_of("crenel.gauges.quick.guide.flow") == "crenel.guide"
    assert layer_of("crenel.gauges.exchange.routes") == "crenel.api"
    assert layer_of("crenel.formats.document") == "crenel.formats.document"


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


Place = tuple[str, str]
"""A package, and in a subject the layer of the modules meant."""


def place_in_layers(module: str) -> Place:
    """Where a module is: in a subject, modules of several layers in one folder are apart."""
    layer = layer_of(module)
    return module.rpartition(".")[0], "" if layer == module else layer


def test_packages_beside_each_other_import_one_way() -> None:
    edges: dict[tuple[Place, Place], str] = {}
    for path, module in imports(*PROGRAM):
        if module.split(".")[0] in PACKAGES and module not in EVERYWHERE:
            own = module_of(path.parent)
            place = (own, "") if path.name == "__init__.py" else place_in_layers(module_of(path))
            is_package = (ROOT / place_of(module)).is_dir()
            target = (module, "") if is_package else place_in_layers(module)
            if target[0] != own:
                edges[place, target] = f"{name_of(path)} imports {module}"
    for (place, target), where in edges.items():
        if not (is_within(place[0], target[0]) or is_within(target[0], place[0])):
            assert (target, place) not in edges, f"{where}; {edges[target, place]}"


def test_no_folder_has_many_modules_and_few_are_small() -> None:
    modules = [path for path in python_files(*PROGRAM) if path.name != "__init__.py"]
    (fullest,) = Counter(path.parent for path in modules).most_common(1)
    assert fullest[1] <= 15, fullest
    small = [path for path in modules if len(text_of(path).splitlines()) < 40]
    assert len(small) <= len(modules) / 25, sorted(small)


def test_the_mathematics_uses_numerical_libraries_only() -> None:
    for path in files_of_layer("crenel.metrology"):
        for module in imported_modules(path):
            top = module.split(".")[0]
            allowed = top == "crenel" or top in NUMERICS or top in sys.stdlib_module_names - OUTSIDE
            assert allowed, f"{name_of(path)} imports {module}"


def test_the_simulator_shares_nothing_with_the_solver() -> None:
    for path, module in imports(PACKAGES["crenel_hardware"]):
        common = any(is_within(module, one) for one in ("crenel.native", MESSAGES, *EVERYWHERE))
        assert common or not is_within(module, "crenel"), f"{name_of(path)} imports {module}"
