"""Finds devices that are connected, without opening them.

Finders are entry points of the group ``crenel.finders`` (``crenel_hardware.registry`` has the
built-in ones): functions without arguments that return what they found within about 3 s, and raise
nothing. What keeps a finder from looking, such as a missing library or permission, is a
``DeviceError`` among its results, whose remedy says what to do.
"""

import threading
from collections.abc import Callable, Mapping, Sequence
from concurrent.futures import Future, wait
from dataclasses import dataclass
from importlib.metadata import EntryPoint
from typing import TypeAlias, cast

from crenel.loops import start_worker
from crenel.messages.message import Text, message
from crenel_hardware.errors import DeviceError
from crenel_hardware.registry import FINDERS, DeviceKind, find_entries, package_of

DEADLINE_S = 4.0
"""How long finders may take; they run at the same time."""


@dataclass(frozen=True, slots=True)
class FoundDevice:
    """A device that is connected, or a port at which one may be."""

    kind: DeviceKind
    """The table of station.toml that it is for."""
    driver: str
    """Name for ``driver`` in station.toml."""
    title: Text
    """What a person recognises it by: maker, model, serial number, port."""
    options: Mapping[str, str | int | float | bool]
    """The keys of the table that address it."""


Finding: TypeAlias = FoundDevice | DeviceError
Finder: TypeAlias = Callable[[], Sequence[Finding]]

_lock = threading.Lock()
_running: dict[str, "Future[list[Finding]]"] = {}
"""Finders that have not returned yet, also of earlier searches: none is started twice."""


def find_devices(deadline_s: float = DEADLINE_S) -> list[Finding]:
    """What all finders find, in the order of their names; a device found twice counts once.

    A finder that cannot be loaded, fails, or takes longer than the deadline gives a
    ``DeviceError`` that names it, and the others' results stay.
    """
    entries = [each for _, same in sorted(find_entries(FINDERS).items()) for each in same]
    futures = [(entry, _start(entry)) for entry in entries]
    wait([future for _, future in futures], timeout=deadline_s)
    found: list[Finding] = []
    for entry, future in futures:
        results = future.result() if future.done() else [_lateness(entry)]
        for one in results:
            if one not in found:
                found.append(one)
    return found


def _start(entry: EntryPoint) -> "Future[list[Finding]]":
    """Runs a finder in a thread of its own, or joins an earlier search that still hangs."""
    key = f"{entry.name} = {entry.value}"

    def run(future: "Future[list[Finding]]") -> None:
        try:
            results = list(cast(Finder, entry.load())())
        except Exception as error:
            results = [_failure(entry, error)]
        with _lock:
            del _running[key]
        future.set_result(results)

    with _lock:
        future = _running.get(key)
        if future is None:
            future = _running[key] = Future()
            name = f"find-{entry.name}"
            start_worker(name, run, future)
        return future


def _lateness(entry: EntryPoint) -> DeviceError:
    return DeviceError(
        message("finder-takes-too-long", name=entry.name), message("search-again-for-devices")
    )


def _failure(entry: EntryPoint, error: Exception) -> DeviceError:
    if isinstance(error, DeviceError):
        return error
    return DeviceError(
        message(
            "finder-failed",
            name=entry.name,
            package=package_of(entry),
            kind=type(error).__name__,
            error=error,
        ),
        message("reinstall-update-package"),
    )
