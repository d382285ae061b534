"""What is acknowledged is on the disk before: the calls of a station's process, traced."""

import time
from collections.abc import Callable, Iterator
from contextlib import contextmanager
from pathlib import Path
from typing import Any, NamedTuple

import pytest

from crenel.errors import OperationError
from tests.bench.faults.calls import compile_library, preload_environment
from tests.bench.faults.served import HALF, HALF_SIZE, prepare
from tests.bench.faults.station import StationProcess

pytestmark = [pytest.mark.timeout(300), pytest.mark.device, pytest.mark.soak]

LOOK_S = 0.01
"""Short, so that hardly more than the first answer which has something is later than it."""

PICTURES = 3
"""Of the calibration."""


class Call(NamedTuple):
    name: str
    file: int
    text: str
    """A path, or the first bytes that were sent or received."""


class Trace:
    """The calls of one process, in their order; times are indices into them."""

    def __init__(self, log: Path, data: Path) -> None:
        self._data = str(data)
        self.calls = []
        for line in log.read_text(errors="replace").split("\n")[:-1]:
            name, file, text = line.split("\t", 2)
            self.calls.append(Call(name, int(file), text))

    def request_index(self, mark: str) -> int:
        at = self._next(0, len(self.calls), "recv", lambda call: f"mark={mark} " in call.text)
        assert at is not None, mark
        return at

    def answer_index(self, mark: str) -> int:
        """When the answer to that request was about to be sent."""
        asked = self.request_index(mark)
        file = self.calls[asked].file
        at = self._next(asked, len(self.calls), "send", lambda call: call.file == file)
        assert at is not None
        assert self.calls[at].text.startswith("HTTP/1.1 2"), self.calls[at]
        return at

    def why_not_stored(self, path: Path, by: int, since: int = 0) -> str:
        """Why a file, written after ``since``, was not on the disk at a time; empty where it was:
        its content, its name, and the names of all folders above it that were made."""
        return self._why_not_synced(str(path), since, by) or self._folders(path, by)

    def _why_not_synced(self, name: str, since: int, by: int) -> str:
        """Whether a file's content and its name were."""
        wrong = ""
        renames = self._all(since, by, ("rename",), name)
        if not renames:
            wrong = self._content(name, since, by)
            made = self._next(0, by, "make", lambda call: call.text == name)
            if not wrong and made is not None:
                wrong = self._why_not_named(name, made, by)
        for renamed in renames:  # the last may be on its way to the disk for what comes next
            wrong = self._content(self.calls[renamed - 1].text, 0, renamed)
            wrong = wrong or self._why_not_named(name, renamed, by)
            if not wrong:
                break
        return wrong

    def why_not_moved(self, folder: Path, by: int) -> str:
        """Why a folder that got its name once it was whole was not kept; empty where it was."""
        renamed = self._next(0, by, "rename", lambda call: call.text == str(folder))
        if renamed is None:
            return f"{folder} was not there"
        part = Path(self.calls[renamed - 1].text)
        for path in sorted(folder.rglob("*")):
            name = str(part / path.relative_to(folder))
            named = (k for k, call in enumerate(self.calls) if call.text == name)
            made = next(k for k in named if self.calls[k].name != "from")
            wrong = self._why_not_named(name, made, renamed)
            if path.is_file():
                wrong = self._why_not_synced(name, 0, renamed)
            if wrong:
                return wrong
        return self._why_not_named(str(folder), renamed, by)

    def why_no_row(self, since: int, by: int) -> str:
        """Why no row of the database was kept in between; empty where one was."""
        return self._content(f"{self._data}/station.db-wal", since, by, any_write=True)

    def _content(self, name: str, since: int, by: int, any_write: bool = False) -> str:
        """Whether the last of what was written, or anything, was synced."""
        writes = self._all(since, by, ("write", "make"), name)
        if not writes:
            return f"{name} was not written"
        begin = writes[0] if any_write else writes[-1]
        synced = self._next(begin, by, "sync", lambda call: call.text == name)
        return "" if synced is not None else f"{name} was not synced"

    def _why_not_named(self, name: str, since: int, by: int) -> str:
        """Whether the folder of a new name was synced."""
        folder = str(Path(name).parent)
        synced = self._next(since, by, "sync", lambda call: call.text == folder)
        return "" if synced is not None else f"{folder} was not synced after {name} was made"

    def _folders(self, path: Path, by: int) -> str:
        for folder in map(str, path.parents):
            if len(folder) <= len(self._data):
                break
            for k in self._all(0, by, ("make", "rename"), folder):
                if wrong := self._why_not_named(folder, k, by):
                    return wrong
        return ""

    def _all(self, since: int, by: int, names: tuple[str, ...], text: str) -> list[int]:
        calls = enumerate(self.calls[since:by], since)
        return [k for k, call in calls if call.name in names and call.text == text]

    def _next(self, since: int, by: int, name: str, fits: Callable[[Call], bool]) -> int | None:
        calls = enumerate(self.calls[since:by], since)
        return next((k for k, call in calls if call.name == name and fits(call)), None)


@pytest.fixture(scope="module")
def library(tmp_path_factory: pytest.TempPathFactory) -> Path:
    try:
        return compile_library(tmp_path_factory.mktemp("library"))
    except OperationError as refusal:
        pytest.skip(refusal.line)


class Traced:
    """A station whose requests are marked in the log of its calls."""

    def __init__(self, station: StationProcess, log: Path, data: Path) -> None:
        self.station, self._log, self.data = station, log, data
        self._marks = 0

    def ask(self, method: str, path: str, **body: object) -> tuple[str, Any]:
        """The mark of a request that was granted, and what was answered."""
        self._marks += 1
        mark = str(self._marks)
        answer = self.station.http.request(method, f"{path}?mark={mark}", json=body or None)
        answer.raise_for_status()
        return mark, answer.json() if answer.content else None

    def until(self, path: str, enough: Callable[[Any], object]) -> str:
        """The mark of the first request whose answer is enough."""
        marks = []

        def asked() -> bool:
            mark, found = self.ask("GET", path)
            marks.append(mark)
            return bool(enough(found))

        self.station.wait(asked)
        return marks[-1]

    def accept(self, guide: str, rev: int) -> str:
        body = {"name": "accept", "args": {}, "rev": rev, "key": "accepted"}
        return self.ask("POST", f"/api/{guide}/command", **body)[0]

    def trace(self) -> Trace:
        return Trace(self._log, self.data)


@contextmanager
def traced(library: Path, data: Path) -> Iterator[Traced]:
    log = data.with_name("calls.txt")
    environment = preload_environment(data, library, LOG=log)
    with StationProcess(data, environment, options=HALF_SIZE) as station:
        yield Traced(station.enter(), log, data)


def test_points_pictures_and_an_acceptance(library: Path, tmp_path: Path) -> None:
    """Each is looked for in the answers; the first that has it acknowledges it."""
    data = tmp_path / "data"
    reported: dict[tuple[str, int], str] = {}
    with traced(library, data) as bench:
        station = bench.station
        station.post("/api/flow/start").raise_for_status()
        station.wait(lambda: station.ask("flow", "confirm_devices"))
        while True:
            mark, view = bench.ask("GET", "/api/flow")
            if view["step"] in ("touch", "capture"):
                reported.setdefault((view["step"], view["progress"]["done"]), mark)
            elif view["step"] == "review" and view["busy"] is None:
                break
            if view["step"] == "solve" and view["progress"]["done"] >= PICTURES:
                station.ask("flow", "solve")
            elif view["busy"] is None:
                station.ask("flow", "run_simulation")
            time.sleep(LOOK_S)
        accepted = bench.accept("flow", view["rev"])
    (session,) = (data / "sessions").iterdir()
    trace, marks = bench.trace(), [*reported.values()]
    assert {step for step, done in reported if done} == {"touch", "capture"}
    for n, ((step, done), mark) in enumerate(reported.items()):
        if done:
            by = trace.answer_index(mark)
            assert trace.why_no_row(trace.request_index(marks[n - 1]), by) == ""
            names = ("probing.csv",) if step == "touch" else picture_names(session, done)
            for name in names:
                since = trace.request_index(marks[max(n - 2, 0)])
                assert trace.why_not_stored(session / name, by, since) == "", (step, done)
    assert_accepted(trace, accepted, session)


def picture_names(session: Path, number: int) -> list[str]:
    """Of a picture, without and with the laser, and the table of all."""
    pictures = (session / "images").glob(f"capture-{number}-*.png")
    return [*(f"images/{path.name}" for path in pictures), "images.csv"]


def test_scans_and_backups(library: Path, tmp_path: Path) -> None:
    data = tmp_path / "data"
    prepare(data, HALF)
    with traced(library, data) as bench:
        station = bench.station
        station.begin_scan("Bracket")
        station.wait(lambda: station.get("/api/scan")["frames"] > 20)
        began, _ = bench.ask("POST", "/api/scan/stop")
        ended = bench.until("/api/scan", lambda scan: scan["state"] == "idle")
        listed = bench.until("/api/scans", len)
        bench.ask("POST", "/api/backup")
        copied = bench.until("/api/health", lambda view: view["backup"]["last"])
    trace = bench.trace()
    by = min(trace.answer_index(ended), trace.answer_index(listed))
    assert trace.why_no_row(trace.request_index(began), by) == ""
    (scan,) = (data / "scans").iterdir()
    assert_written(trace, scan, by)
    (copy,) = (data / "backups").iterdir()
    assert trace.why_not_moved(copy, trace.answer_index(copied)) == ""


def test_clouds_and_acceptance_of_a_verification(library: Path, tmp_path: Path) -> None:
    data = tmp_path / "data"
    prepare(data, HALF)
    reported: dict[int, str] = {}
    with traced(library, data) as bench:
        station = bench.station
        station.post("/api/verify/start").raise_for_status()
        station.wait(lambda: station.ask("verify", "choose_gauge", id="plate"))
        while True:
            mark, view = bench.ask("GET", "/api/verify")
            clouds = view["picture"].get("clouds", []) if view["step"] == "scan" else []
            reported.setdefault(sum(cloud["state"] == "good" for cloud in clouds), mark)
            if view["step"] == "review" and view["busy"] is None:
                break
            if view["busy"] is None:
                station.ask("verify", "run_simulation", all=True)
            time.sleep(LOOK_S)
        accepted = bench.accept("verify", view["rev"])
    trace, marks = bench.trace(), [*reported.values()]
    (session,) = (data / "verifications").iterdir()
    recordings = sorted(session.rglob("*.mcap"))
    for (number, mark), before in zip([*reported.items()][1:], marks, strict=False):
        by = trace.answer_index(mark)
        assert trace.why_no_row(trace.request_index(before), by) == ""
        assert trace.why_not_stored(recordings[number - 1], by) == ""
    assert_accepted(trace, accepted, session)


def assert_accepted(trace: Trace, mark: str, session: Path) -> None:
    by = trace.answer_index(mark)
    assert trace.why_no_row(trace.request_index(mark), by) == ""
    assert_written(trace, session, by)


def assert_written(trace: Trace, folder: Path, by: int) -> None:
    files = [path for path in folder.rglob("*") if path.is_file()]
    assert files
    for path in files:
        assert trace.why_not_stored(path, by) == "", path
