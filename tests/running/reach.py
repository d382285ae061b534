"""Which tests a change can reach; as a command, the files of the soak tests that it reaches.

``python -m tests.running.reach`` prints them. The change is what differs from the newest commit
that is a day older than the last one: nothing slips between two landings of a day. A test is
reached if it imports, starts or names a changed file, itself or by other files.
"""

import re
import subprocess
import sys
from collections.abc import Callable, Iterable
from dataclasses import dataclass
from pathlib import PurePath

from tests.running.imports import known_files, mentions, reached_files
from tests.running.marks import Cost, read_marks
from tests.sources import ALL, ROOT

STARTED_MODULES = ()  # Git
DAY_S = 86_400
FIRST_DAY = "No commit is a day older"
OF_ALL_FILES = ("tests/docs/", "tests/messages/", "tests/structure/")
"""Folders of tests that look at every file there is."""
OF_THE_BROWSER = ("tests/e2e/", "tests/frontend/")
PAGES = ("docs/", "frontend/screenshots/", "LICENSE")
DATA = (".json", ".sql", ".ttf", ".xz")
"""Endings of files that code reads by their names."""
OF_CODE = tuple(f"{folder}/" for folder in ALL)
MESSAGE = re.compile(r"^([a-z][\w-]*) =(.*(?:\n(?![a-z#]).*)*)", re.MULTILINE)


class AllError(Exception):
    """A change can reach any test; the message names the file."""


@dataclass(frozen=True)
class Reach:
    """The test files that a change reaches."""

    tests: tuple[str, ...]
    all_by: str = ""
    """A changed file that can reach any test."""


def all_tests() -> tuple[str, ...]:
    names = (name for name in known_files() if name.startswith("tests/"))
    return tuple(sorted(name for name in names if PurePath(name).name.startswith("test_")))


def reached_tests(changed: Iterable[str], text_before: Callable[[str], str]) -> Reach:
    """What a change reaches, by the names of changed, new and deleted files; ``text_before``: of a
    file before the change, empty if there was none."""
    try:
        first = {file for name in changed for file in first_reached(name, text_before)}
    except AllError as error:
        return Reach(all_tests(), str(error))
    reached = reached_files(first)
    return Reach(tuple(one for one in all_tests() if one in reached or _is_in(one, OF_ALL_FILES)))


def first_reached(name: str, text_before: Callable[[str], str]) -> set[str]:
    """The Python files that a changed file reaches directly. AllError: any."""
    path = PurePath(name)
    if path.name == "conftest.py":
        raise AllError(name)
    if name in known_files():
        return {name}
    if path.suffix == ".py" and _is_in(name, OF_CODE):
        # a deleted module: what used it has changed too, but for the modules of a package
        return _below(f"{path.parent}/") if path.name == "__init__.py" else set()
    if path.suffix == ".md" or _is_in(name, PAGES):
        return _naming(path.name)
    if _is_in(name, ("frontend/src/",)):
        return _below(*OF_THE_BROWSER) | _naming(path.name)
    if path.suffix == ".ftl":
        return _using_messages(name, text_before(name))
    if path.suffix in DATA and _is_in(name, OF_CODE) and (naming := _naming(path.name)):
        return naming
    raise AllError(name)


def _is_in(name: str, folders: Iterable[str]) -> bool:
    return name.startswith(tuple(folders))


def _below(*folders: str) -> set[str]:
    return {one for one in known_files() if _is_in(one, folders)}


def _naming(file: str) -> set[str]:
    return {
        one for one in known_files() if any(file in text for text in mentions(ROOT / one).texts)
    }


def _using_messages(name: str, before: str) -> set[str]:
    """The files that use what has changed in a language file."""
    path = ROOT / name
    old = dict(MESSAGE.findall(before))
    new = dict(MESSAGE.findall(path.read_text("utf-8"))) if path.exists() else {}
    ids = {one for one, text in new.items() if old.get(one) != text}
    using = {one: mentions(ROOT / one).texts & ids for one in known_files()}
    if ids - set().union(*using.values()):
        raise AllError(name)
    return {one for one, used in using.items() if used}


def git(*arguments: str) -> str:
    done = subprocess.run(
        ["git", *arguments], cwd=ROOT, stdout=subprocess.PIPE, text=True, check=True
    )
    return done.stdout


def base_commit(head: str = "HEAD") -> str:
    """The newest commit that is a day older than another; empty if there is none."""
    before_s = int(git("log", "-1", "--format=%ct", head)) - DAY_S
    return git("rev-list", "-1", f"--min-age={before_s}", head).strip()


def changed_files(base: str) -> list[str]:
    """The files that differ from a commit; those too that it does not know, and deleted ones."""
    known = git("diff", "--name-only", "--no-renames", "-z", base)
    new = git("ls-files", "--others", "--exclude-standard", "-z")
    return [name for name in f"{known}{new}".split("\0") if name]


def text_at(base: str) -> Callable[[str], str]:
    """Reads files as they were at a commit."""

    def read(name: str) -> str:
        there = git("ls-tree", "--name-only", base, "--", name)
        return git("show", f"{base}:{name}") if there else ""

    return read


def main() -> None:
    base = base_commit()
    changed = changed_files(base) if base else []
    reach = reached_tests(changed, text_at(base)) if base else Reach(all_tests())
    soak, reached = (
        [name for name in names if Cost.SOAK in read_marks(ROOT / name).of_some]
        for names in (all_tests(), reach.tests)
    )
    since = f"{len(changed)} files changed since {base[:8]}" if base else FIRST_DAY
    because = f", all by {reach.all_by}" if reach.all_by else ""
    print(
        f"{since}; {len(reached)} of {len(soak)} files with soak tests are reached{because}",
        file=sys.stderr,
    )
    sys.stdout.writelines(f"{name}\n" for name in reached)


if __name__ == "__main__":
    main()
