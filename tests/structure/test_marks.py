"""A test that starts a process, a station or a browser has the mark ``device``."""

import re
from collections import defaultdict
from collections.abc import Iterator
from functools import cache
from pathlib import PurePath

from tests.running.imports import known_files
from tests.running.marks import Cost, read_marks
from tests.running.reach import all_tests
from tests.sources import READS_TREE, ROOT, place_of
from tests.structure.definitions import definitions

pytestmark = READS_TREE

Place = tuple[str, str]
"""A file and a name in it."""

STARTING = {
    "a process": re.compile(
        r"subprocess\.(run|Popen|call|check_\w+)|os\.fork|asyncio\.create_subprocess_\w+"
        r"|multiprocessing\.(get_context|Process)|concurrent\.futures\.ProcessPoolExecutor"
    ),
    "a station": re.compile(
        r"crenel_hardware\.simulator\.station\.SimulatedStation\.(__enter__|start)"
        r"|crenel\.server\.listener\.make_server"
    ),
    "a server": re.compile(r"socket\.create_server|(socketserver|http\.server)\.\w"),
    "a browser": re.compile(r"playwright\.sync_api\.sync_playwright"),
}
"""Names of what starts something, however far below a test."""
LOOKED_INTO = "tests/"
"""Files whose functions are followed; of others, the names above count."""
BRIEF = {
    "tests/bench/test_figures.py": "no command: what they printed is there",
    "tests/structure/test_docker.py": "a linter that takes a moment",
    "tests/structure/test_text.py": "Git, for a list of files",
    "tests/structure/test_reach.py": "Git, in a small repository",
}


def defining_place(whole_name: str, file: str) -> Place | None:
    """The file and the name in it of what a file calls by a whole name."""
    first = whole_name.partition(".")[0]
    if first in definitions(ROOT / file):
        return file, first
    parts = whole_name.split(".")
    for count in range(len(parts) - 1, 0, -1):
        module = place_of(".".join(parts[:count]))
        for candidate in (f"{module}.py", f"{module}/__init__.py"):
            if candidate in known_files():
                return candidate, parts[count]
    return None


def fixture_places(name: str, file: str) -> list[Place]:
    """Where a fixture of a test file may be defined, the nearest first."""
    folders = PurePath(file).parents
    files = [file, *(f"{folder}/conftest.py" for folder in folders)]
    return [
        (one, name) for one in files if one in known_files() and name in definitions(ROOT / one)
    ]


def used_places(place: Place) -> set[Place]:
    """Where that is defined which a function, class or constant uses itself."""
    file, name = place
    found = definitions(ROOT / file)[name]
    used = {defining_place(one, file) for one in found.used}
    used |= {nearest for one in found.fixtures for nearest in fixture_places(one, file)[:1]}
    return {one for one in used if one is not None}


@cache
def starting() -> dict[Place, set[str]]:
    """What each function, class and constant starts, itself or by others, if anything."""
    users: dict[Place, set[Place]] = defaultdict(set)
    started: dict[Place, set[str]] = {}
    for file in known_files():
        if file.startswith(LOOKED_INTO):
            for name, found in definitions(ROOT / file).items():
                for used in used_places((file, name)):
                    users[used].add((file, name))
                for what, pattern in STARTING.items():
                    if any(map(pattern.match, found.used)):
                        started.setdefault((file, name), set()).add(what)
    waiting = list(started)
    while waiting:
        place = waiting.pop()
        for user in users[place]:
            known = started.setdefault(user, set())
            if not started[place] <= known:
                known |= started[place]
                waiting.append(user)
    return started


def unmarked(file: str) -> Iterator[str]:
    """The tests of a file that start something and do not say so."""
    if Cost.DEVICE in read_marks(ROOT / file).of_all:
        return
    of_all = starting().get((file, "pytestmark"), set())
    for name, found in definitions(ROOT / file).items():
        if name.lower().startswith("test") and Cost.DEVICE not in found.marks:
            for started in sorted(of_all | starting().get((file, name), set())):
                yield f"{file}:{found.line} {name} starts {started}: mark it device"


def test_what_starts_something_is_marked() -> None:
    assert not [one for file in all_tests() if file not in BRIEF for one in unmarked(file)]


def test_what_is_brief_starts_something() -> None:
    assert not [file for file in BRIEF if not any(unmarked(file))]


def test_what_starts_is_seen_through_fixtures_and_other_files() -> None:
    def of_fixture(folder: str, name: str) -> set[str]:
        return starting().get((f"tests/{folder}/conftest.py", name), set())

    assert of_fixture("api", "at_setup") == {"a station"}
    assert of_fixture("e2e", "browser") == {"a browser"}
    assert of_fixture("e2e", "demo") == {"a process"}
    assert of_fixture("fleet", "catalogue") == {"a process"}
    assert of_fixture("supervision", "broker") == {"a process"}
    assert not of_fixture("archive", "store")
    assert not of_fixture("guide", "arm")
