"""No test leaves anything to the next: the test that left a thread, a process, a socket or a
temporary file is the one that fails."""

import gc
import os
import tempfile
import threading
import time
from collections.abc import Generator
from dataclasses import dataclass, fields
from pathlib import Path

import pytest

GRACE_S = 60.0
"""What ends by itself after a test, such as a connection whose peer has gone, has so long."""
LOOK_S = 0.02
STANDING = ("multiprocessing.forkserver", "multiprocessing.resource_tracker")
"""Processes of Python's own that begin with the first one that needs them, and end with us; those
that they start count as ours."""
THEIR_FILES = "pymp-"
LASTING_THREAD = "awake"
"""The clock of a program with devices, which begins with the first one and ends with us."""


@dataclass(frozen=True)
class Held:
    """What this process holds that can outlive a test, each by what a person can find it by."""

    threads: frozenset[threading.Thread]
    processes: frozenset[str]
    sockets: frozenset[str]
    files: frozenset[str]

    def without(self, other: "Held") -> "Held":
        return Held(*(getattr(self, one.name) - getattr(other, one.name) for one in fields(self)))

    def with_(self, other: "Held") -> "Held":
        return Held(*(getattr(self, one.name) | getattr(other, one.name) for one in fields(self)))

    def __bool__(self) -> bool:
        return any(getattr(self, one.name) for one in fields(self))

    def __str__(self) -> str:
        return ", ".join(
            f"{one.name}: {sorted(str(each) for each in getattr(self, one.name))}"
            for one in fields(self)
            if getattr(self, one.name)
        )


def look(temporary: Path) -> Held:
    """What is held now; on systems without /proc, threads and files only."""
    return Held(
        frozenset(one for one in threading.enumerate() if one.name != LASTING_THREAD),
        frozenset(_processes()),
        frozenset(_sockets()),
        frozenset(one for one in os.listdir(temporary) if not one.startswith(THEIR_FILES)),
    )


def _processes(of: str = "self") -> list[str]:
    found = []
    for task in Path(f"/proc/{of}/task").glob("*/children"):
        try:
            for number in task.read_text().split():
                command = Path(f"/proc/{number}/cmdline").read_bytes().replace(b"\0", b" ")
                text = command.decode(errors="replace")
                # one that is forked has the command of the process that forked it
                is_standing = of == "self" and any(one in text for one in STANDING)
                found += _processes(number) if is_standing else [f"{number} {text[:120]}"]
        except OSError:
            continue
    return found


def _sockets() -> list[str]:
    """Without the one by which GLib follows the network as long as the process lives."""
    found = []
    netlink = Path("/proc/net/netlink")
    lines = netlink.read_text("utf-8").splitlines() if netlink.exists() else []
    lasting = {line.split()[-1] for line in lines}
    for name in os.listdir("/proc/self/fd") if Path("/proc/self/fd").is_dir() else ():
        try:
            target = os.readlink(f"/proc/self/fd/{name}")
        except OSError:
            continue
        if target.startswith("socket:") and target[8:-1] not in lasting:
            found.append(target)
    return found


class LeakCheck:
    """Looks after each test, and with the last one that uses it after what a module shares."""

    def __init__(self) -> None:
        self.shared: set[str] = set()
        """Fixtures of modules that hold something now."""
        self.temporary = Path(tempfile.gettempdir())
        self.known: Held | None = None
        """What this process held before its tests, and what its session holds; None: not yet."""

    def begin(self, temporary: Path) -> None:
        """Has this process, and those that it starts, put temporary files into a folder."""
        temporary.mkdir()
        self.temporary = temporary
        os.environ["TMPDIR"] = tempfile.tempdir = str(temporary)
        self.known = look(temporary)

    @pytest.hookimpl(wrapper=True)
    def pytest_fixture_setup(
        self, fixturedef: pytest.FixtureDef[object]
    ) -> Generator[None, object, object]:
        if fixturedef.scope == "function" or self.known is None:
            return (yield)
        before = look(self.temporary)
        try:
            return (yield)
        finally:
            added = look(self.temporary).without(before)
            if added and fixturedef.scope in ("session", "package"):
                self.known = self.known.with_(added)
            elif added:
                self.shared.add(_name(fixturedef))

    def pytest_fixture_post_finalizer(self, fixturedef: pytest.FixtureDef[object]) -> None:
        self.shared.discard(_name(fixturedef))

    @pytest.hookimpl(wrapper=True, trylast=True)
    def pytest_runtest_teardown(self, item: pytest.Item) -> Generator[None, None, None]:
        yield
        if self.shared or self.known is None:
            return
        if look(self.temporary).without(self.known) and (left := self._left_after(self.known)):
            self.known = self.known.with_(left)
            pytest.fail(f"{item.nodeid} leaves {left}", pytrace=False)

    def _left_after(self, known: Held) -> Held:
        end = time.monotonic() + GRACE_S
        gc.collect()
        while (left := look(self.temporary).without(known)) and time.monotonic() < end:
            time.sleep(LOOK_S)
        return left


def _name(fixture: pytest.FixtureDef[object]) -> str:
    return f"{fixture.baseid}::{fixture.argname}"
