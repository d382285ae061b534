"""Searches for devices in a thread of its own; what was found last stays until the next search."""

import threading
from dataclasses import dataclass

from crenel.loops import start_worker
from crenel.messages.message import Text
from crenel_hardware.discovery import FoundDevice, find_devices


@dataclass(frozen=True)
class SearchProblem:
    """What kept a search from looking, and what to do about it."""

    text: Text
    remedy: Text


@dataclass(frozen=True)
class DevicesFound:
    """The last search."""

    devices: tuple[FoundDevice, ...] = ()
    problems: tuple[SearchProblem, ...] = ()
    done: bool = False
    """False before the first search has ended."""


class DeviceSearch:
    """One search at a time."""

    def __init__(self) -> None:
        self._lock = threading.Lock()
        self._running = False
        self._result = DevicesFound()

    @property
    def running(self) -> bool:
        return self._running

    @property
    def result(self) -> DevicesFound:
        return self._result

    def start(self) -> None:
        """Begins a search; while one runs, nothing happens."""
        with self._lock:
            if self._running:
                return
            self._running = True
        start_worker("device-search", self._run)

    def _run(self) -> None:
        try:
            found = find_devices()
            self._result = DevicesFound(
                tuple(one for one in found if isinstance(one, FoundDevice)),
                tuple(
                    SearchProblem(one.what, one.remedy)
                    for one in found
                    if not isinstance(one, FoundDevice)
                ),
                done=True,
            )
        finally:
            self._running = False
