"""All that a station answers and reports, read once; what of it is a fault of the program."""

import re
import time
from collections.abc import Mapping
from contextlib import suppress
from dataclasses import dataclass, field
from urllib.parse import quote

import httpx
from websockets.exceptions import WebSocketException

from tests.bench.faults.furnished import NOTIFIED, SETTINGS
from tests.bench.faults.station import StationProcess, View

PARAMETER = re.compile(r"{(\w+)}")
OK, FAULT_STATUS, NOT_STORED_STATUS = 200, 500, 507
LIVE_S = 1.0
MOST_READ = 16 << 20
"""Bytes of an answer."""
TRACE = "Traceback (most recent call last)"
REQUESTS: tuple[tuple[str, Mapping[str, object]], ...] = (
    ("/api/temperature", {"celsius": 20.5}),
    ("/api/settings", SETTINGS),
    ("/api/settings/delay/find", {}),
    ("/api/notifications", NOTIFIED),
    ("/api/flow/start", {}),
    ("/api/arm/start", {"purpose": "check"}),
    ("/api/verify/start", {}),
    ("/api/performance/start", {}),
    ("/api/scan/start", {"name": "Afterwards"}),
    ("/api/scan/simulation", {"on": True}),
    ("/api/scan/stop", {}),
    ("/api/backup", {}),
    ("/api/stop", {}),
)
"""What is asked of a station besides looking, in this order."""

CHECK_ROUTES = ("/api/health", "/api/home", "/api/scans", "/api/flow")


@dataclass
class StationResponses:
    """What a station answered."""

    faults: list[str] = field(default_factory=list)
    """Answers that no request may have, in words."""
    texts: dict[str, str] = field(default_factory=dict)
    """Of each route that answered with JSON."""

    def note(self, asked: str, answer: httpx.Response, content: bytes) -> None:
        if answer.status_code >= FAULT_STATUS and answer.status_code != NOT_STORED_STATUS:
            self.faults.append(f"{asked}: {answer.status_code}")
        if "json" in answer.headers.get("content-type", ""):
            self.texts[asked] = content.decode("utf-8", "replace")

    def mentions(self, words: str) -> bool:
        """Whether something that people are shown has these words, a regular expression."""
        return any(re.search(words, text, re.IGNORECASE) for text in self.texts.values())


def query_station(
    station: StationProcess, ids: Mapping[str, list[str]], acts: bool = True
) -> StationResponses:
    """Asks for everything.

    Args:
        ids: what a parameter of a route is filled with, besides an id that nothing has.
        acts: also begins sessions, a scan and a backup.
    """
    look = StationResponses()
    for path in _paths(station, ids):
        _ask(look, station, "GET", path)
    look.faults += _live_faults(station)
    for path, body in REQUESTS if acts else ():
        if path.endswith("/start"):  # else it is refused because another activity has the arm
            ended = station.free_arm()
            if ended is not None:
                look.note("POST /api/activity/end", ended, ended.content)
        _ask(look, station, "POST", path, body)
    if acts:
        station.wait(lambda: _has_no_job(station.http.get("/api/health")))
        for path in CHECK_ROUTES:
            _ask(look, station, "GET", path)
    logged = station.http.get("/api/logs")
    look.note("GET /api/logs", logged, logged.content)
    if logged.status_code == OK:
        look.faults += [describe_fault(line) for line in logged.json() if line["level"] == "error"]
    if TRACE in station.console_text:
        look.faults.append("a trace on the console")
    return look


def _has_no_job(health: httpx.Response) -> bool:
    """Whether the requested backup has ended, or Health cannot report it."""
    return health.status_code != OK or '"share":null' in health.text


def describe_fault(line: View) -> str:
    """A line of the log with an error, and the end of its trace."""
    last = (line["trace"].strip().splitlines() or [""])[-1]
    return f"logged: {line['text'][:120]} {last[:120]}"


def _ask(
    look: StationResponses,
    station: StationProcess,
    method: str,
    path: str,
    body: Mapping[str, object] | None = None,
) -> None:
    try:
        with station.http.stream(method, path, json=body) as answer:
            look.note(f"{method} {path}", answer, _read(answer))
    except httpx.TransportError as error:
        look.faults.append(f"{method} {path}: {type(error).__name__}")


def _read(answer: httpx.Response) -> bytes:
    """The beginning of what was answered: a damaged cloud may have terabytes."""
    content = bytearray()
    for part in answer.iter_bytes():
        content += part
        if len(content) >= MOST_READ:
            break
    return bytes(content)


def _paths(station: StationProcess, ids: Mapping[str, list[str]]) -> list[str]:
    """Every address that can be asked for, its parameters filled."""
    routes: View = station.get("/api/openapi.json")["paths"]
    return [
        filled
        for route, methods in sorted(routes.items())
        if "get" in methods and not route.startswith(("/viewer", "/{"))
        for filled in _fill_route(route, ids)
    ]


def _fill_route(route: str, ids: Mapping[str, list[str]]) -> list[str]:
    filled = [route]
    for name in PARAMETER.findall(route):
        values = [*ids.get(name, []), "none"]
        mark = f"{{{name}}}"
        filled = [path.replace(mark, quote(value)) for path in filled for value in values]
    return filled


def _live_faults(station: StationProcess) -> list[str]:
    """Whether a browser's live connection receives messages, and lives."""
    received = 0
    try:
        with station.live() as live:
            deadline_s = time.monotonic() + LIVE_S
            while (left_s := deadline_s - time.monotonic()) > 0:
                with suppress(TimeoutError):
                    live.recv(left_s)
                    received += 1
    except (WebSocketException, OSError) as error:
        return [f"the live connection ended: {error}"]
    return [] if received else ["the live connection sent nothing"]
