"""Stations killed with SIGKILL in every state; what they have afterwards."""

import json
import random
from collections.abc import Iterator
from concurrent.futures import ThreadPoolExecutor
from dataclasses import dataclass
from pathlib import Path
from typing import Any

from crenel.errors import OperationError
from crenel.formats.recording.ordering.ordered_blocks import read_blocks
from crenel.formats.recording.reader import open_recording
from crenel.messages.message import Message, Text, text_from_json
from crenel.operations.recovery import KILLED
from crenel.progress import Progress, no_progress
from tests.bench.faults.row import FaultRow
from tests.bench.faults.served import HALF, HALF_SIZE, prepare
from tests.bench.faults.station import StationProcess, View

SCANS = 20
LONGEST_S = 3.0
LOST_S = 0.5
"""So much of a scan may be lost at most."""
SETTLED = ("what-recorded-kept", "no-points-can-made")
"""Notes of a scan whose cloud is made or cannot be made."""
KillPoint = tuple[str, int]
KILL_POINTS: dict[str, tuple[KillPoint, ...]] = {
    "flow": (
        *(("devices", 0), ("setup", 0), ("touch", 0), ("touch", 1), ("touch", 5), ("touch", 12)),
        *(("touch", 20), ("touch", 26), ("place", 0), ("capture", 0), ("solve", 0), ("review", 0)),
    ),
    "verify": (
        *(("gauge", 0), ("touch", 0), ("touch", 2), ("touch", 5)),
        *(("scan", 0), ("scan", 1), ("scan", 2), ("review", 0)),
    ),
    "performance": (
        *(("artefact", 0), ("pattern", 0), ("pattern", 1), ("pattern", 12), ("location", 0)),
        *(("location", 7), ("scan", 0), ("scan", 1), ("scan", 3), ("end", 0), ("end", 2)),
        *(("temperatures", 0), ("review", 0), ("review", 1)),
    ),
    "lengths": (
        *(("artefact", 0), ("lengths", 0), ("lengths", 1), ("lengths", 4), ("lengths", 13)),
        *(("lengths", 20), ("temperatures", 0), ("review", 0), ("review", 1)),
    ),
    "scanned-lengths": (
        *(("artefact", 0), ("lengths", 1), ("lengths", 3), ("lengths", 4), ("lengths", 5)),
        ("lengths", 7),
    ),
    "plane": (
        *(("artefact", 0), *(("plate", count) for count in (0, 1, 2, 3, 5))),
        *(("temperatures", 0), ("review", 1)),
    ),
    "contact": (
        *(("artefact", 0), ("diameter", 0), ("diameter", 4), ("diameter", 9), ("diameter", 13)),
        *(("seats", 0), ("seats", 10), ("seats", 14)),
        *(("bar", count) for count in (0, 3, 12, 50, 90, 130)),
        *(("temperatures", 0), ("review", 1)),
    ),
    "parts": (
        *(("setup", 0), ("align", 0), ("align", 4), ("align", 15)),
        *(("measure", 0), ("measure", 1), ("measure", 30), ("measure", 90)),
        *(("review", 0), ("review", 1)),
    ),
}
"""The steps in which it is killed, and after how many points, pictures, clouds or results; a scan
of a plate counts as it begins, as it ends, and as it is measured."""
NAMES = {
    "flow": "kill -9 in a calibration",
    "verify": "kill -9 in a verification",
    "performance": "kill -9 in a performance test",
    "lengths": "kill -9 in a test of lengths",
    "scanned-lengths": "kill -9 in a test of lengths by scan",
    "plane": "kill -9 in a plane test",
    "contact": "kill -9 in a contact test",
    "parts": "kill -9 in an inspection",
}
SHORT_GAUGE = "short"
GAUGES = {"verify": "plate", "lengths": SHORT_GAUGE, "scanned-lengths": "ball-bar"}
"""Of the guides that do not take the one offered first."""
TESTS = {"lengths": "lengths", "scanned-lengths": "lengths", "plane": "plane", "contact": "contact"}
"""Kinds of performance test by the guide, but for the one-sphere test."""
STAGES = {
    "begun": ("scanning", "measuring", "done", "refused"),
    "ended": ("measuring", "done", "refused"),
    "measured": ("done",),
}
"""Of a plate's scan, each by the states that are shown in it and after it. One that was cut short
may be refused."""
ROUTES = dict.fromkeys(TESTS, "performance")
"""Of the guides whose address is not their name."""


def kill_scans(
    data: Path,
    kills: int = SCANS,
    seed: int = 0,
    progress: Progress = no_progress,
    start: type[StationProcess] = StationProcess,
    most_lost_s: float = LOST_S,
) -> FaultRow:
    """Kills at any moment of scans; each is listed, with its cloud, at the next start.

    Args:
        data: a folder for the station's own, which is made.
        most_lost_s: of the end of a scan; on a machine that holds the station up, more is lost.
        start: how a station's process is started.
    """
    prepare(data)
    row, rng = FaultRow("kill -9 in a scan"), random.Random(seed)
    killed: _RunningScan | None = None
    losses_s = []
    for number in range(kills + 1):
        progress(number / (kills + 1), f"kill {number} of {kills} in scans")
        with start(data) as station:
            station.enter()
            if killed is not None:
                losses_s.append(_settle(station, killed, data, row, most_lost_s))
            if number < kills:
                name = f"Scan {number + 1}"
                station.begin_scan(name)
                killed = _kill(station, name, rng.uniform(0.1, LONGEST_S))
    row.notes.insert(0, f"at most {max(losses_s):.2f} s of one")
    return row


@dataclass(frozen=True)
class _RunningScan:
    """A scan that ran when its station was killed, and what was shown of it just before."""

    name: str
    at_ns: int
    """On the monotonic clock, as the recording's stamps."""
    seconds: float
    frames: int

    def loss_s(self, frames: int, joints_ns: int) -> float:
        """How much is lost, where so many frames are left, and joints until then."""
        frames_s = self.seconds * (self.frames - frames) / max(self.frames, 1)
        return max(frames_s, 1e-9 * (self.at_ns - joints_ns), 0.0)


def _kill(station: StationProcess, name: str, seconds: float) -> _RunningScan:
    """Kills a station once its scan has run for so long."""

    def live() -> View | None:
        scan: View = station.get("/api/scan")
        return scan if scan["seconds"] > seconds else None

    last = station.wait(live)
    return _RunningScan(name, station.kill(), last["seconds"], last["frames"])


def _settle(
    station: StationProcess, killed: _RunningScan, data: Path, row: FaultRow, most_lost_s: float
) -> float:
    """Counts what became of a killed scan; how much of it is lost, in s."""

    def found() -> Any:
        listed = [scan for scan in station.get("/api/scans") if scan["name"] == killed.name]
        return listed[0] if listed else None

    first = found()
    row.note_stop(station.stop_s())
    if first is None:
        lost = killed.seconds > most_lost_s
        row.count_try(True, lost, f"{killed.name} is not listed" if lost else "")
        return killed.seconds
    try:
        scan = station.wait(lambda: _with_cloud(found()))
    except OperationError as refusal:
        row.count_try(False, True, f"{killed.name}: {refusal.line}")
        return killed.seconds
    folder = data / "scans" / scan["id"]
    lost_s = killed.loss_s(scan["frames"], last_joints_ns(folder / "scan.mcap"))
    note = text_from_json(scan["note"])
    complete = (folder / "cloud.ply").is_file() and _is_interrupted_by_kill(note)
    row.count_try(complete, lost_s > most_lost_s, "" if complete else f"{killed.name}: {note!s}")
    return lost_s


def _with_cloud(scan: View | None) -> View | None:
    """The scan once its cloud is made, or is known not to be possible."""
    note = text_from_json(scan["note"]) if scan else ""
    return scan if isinstance(note, Message) and note.message_id in SETTLED else None


def _is_interrupted_by_kill(note: Text) -> bool:
    return isinstance(note, Message) and note.values.get("interrupted") == KILLED


def last_joints_ns(recording: Path) -> int:
    """The stamp of the last joints that a recording holds; 0 for none."""
    last_ns = 0
    with ThreadPoolExecutor(1) as pool:
        for block in read_blocks(open_recording(recording), pool, 1):
            last_ns = max([last_ns, *(int(read.stamps_ns[-1]) for read in block.readings)])
    return last_ns


def kill_guides(
    data: Path,
    flow: str,
    places: tuple[KillPoint, ...] | None = None,
    progress: Progress = no_progress,
    start: type[StationProcess] = StationProcess,
) -> FaultRow:
    """Kills in every step of a guide; nothing that was shown is lost.

    Args:
        data: a folder for the station's own, which is made.
        flow: ``flow`` for a calibration, ``verify`` for a verification, ``performance`` for the
            one-sphere test, ``lengths`` for that of a step gauge with a single length,
            ``scanned-lengths`` for the first places of a ball bar by touch and by scan, ``plane``
            and ``contact`` for these tests, ``parts`` for the inspection of the example part.
        places: where, instead of in ``KILL_POINTS``.
        start: how a station's process is started.
    """
    row, before = FaultRow(NAMES[flow]), None
    if flow != "flow":
        prepare(data, HALF)
    if flow == "lengths":
        _add_short_gauge(data)
    route = ROUTES.get(flow, flow)
    places = places or KILL_POINTS[flow]
    for number, place in enumerate([*places, None]):
        progress(number / len(places), f"{flow}: {place[0] if place else 'the end'}")
        # what is kept does not depend on the pictures' size
        with start(data, options=HALF_SIZE) as station:
            station.enter()
            if before is None:
                _begin(station, flow)
            else:
                wrong = "; ".join(differences(before, station.get(f"/api/{route}")))
                row.count_try(not wrong, bool(wrong), wrong)
                row.note_stop(station.stop_s())
            if place is not None:
                before = _advance(station, route, place)
                station.kill()
    return row


def _add_short_gauge(data: Path) -> None:
    """A step gauge of a single length, whose test takes 42 touches."""
    gauge = json.loads((data / "gauges" / "step-gauge.json").read_text())
    short = {**gauge, "lengths": gauge["lengths"][-1:]}
    (data / "gauges" / f"{SHORT_GAUGE}.json").write_text(json.dumps(short))


def _begin(station: StationProcess, flow: str) -> None:
    route = ROUTES.get(flow, flow)
    kind = {"test": TESTS[flow]} if flow in TESTS else {}
    station.begin_session(route, **kind)
    if flow in GAUGES:
        station.wait(lambda: station.ask(route, "choose_gauge", id=GAUGES[flow]))
    if flow == "scanned-lengths":
        station.wait(lambda: station.ask(route, "set_by_scan", by_scan=True))


def _advance(station: StationProcess, flow: str, place: KillPoint) -> View:
    """Until so much is done in a step: setup by command, the rest by the simulated operator."""
    step, count = place
    if step == "setup" and flow == "flow":
        station.wait(lambda: station.ask(flow, "confirm_devices"))

    def there() -> View | None:
        """The view once reached; else restarts a simulated operator that rests after a refusal."""
        view: View = station.get(f"/api/{flow}")
        if _has_reached(view, step, count):
            return view
        if view["busy"] is None and (flow, step) != ("flow", "setup"):
            station.ask(flow, "run_simulation", all=True)
        return None

    return dict(station.wait(there))


def _list_items(view: View) -> set[Any]:
    """What an operator has done in this step, as the page shows it."""
    if "dimensions" in view:
        return _list_inspected_items(view)
    picture, step = view["picture"], view["step"]
    if "articulations" in picture:
        return _list_performance_items(view)
    if step == "touch":
        return {
            (point.get("face"), point["index"])
            for point in picture.get("points") or picture.get("touches") or []
        }
    return {c["number"] for c in picture.get("clouds", []) if c["state"] == "good"}


def _list_performance_items(view: View) -> set[Any]:
    """The same of a performance test: places of a step, lengths, scans, or the result."""
    picture, step = view["picture"], view["step"]
    if step == "review":
        return {"result"} if picture["result"] else set()
    if step == "scan":
        return {one["number"] for one in picture["articulations"] if one["state"] == "done"}
    if step == "plate":
        return {
            (one["number"], stage)
            for one in picture["articulations"]
            for stage, states in STAGES.items()
            if one["state"] in states
        }
    # the places of the first are those of one articulation, the others have none
    if step in ("location", "diameter", "seats", "bar"):
        return set(range(view["progress"]["done"]))
    if step == "lengths":
        lengths = picture["lengths"] or {"touched": None, "scanned": None}
        return {
            (way, one["place"], one["repeat"], one["length_mm"])
            for way in ("touched", "scanned")
            for one in (lengths[way] or {"errors": []})["errors"]
        }
    return {place["number"] for place in picture["places"] if place["state"] == "done"}


def _list_inspected_items(view: View) -> set[Any]:
    """The same of an inspection: the touches of the step's features, or the result."""
    if view["step"] == "review":
        return {"result"} if view["result"] else set()
    return {
        (feature["id"], number)
        for feature in view["features"]
        for number in range(feature["touches"])
        if feature["is_datum"] == (view["step"] == "align")
    }


def _has_reached(view: View, step: str, count: int) -> bool:
    order = [each["id"] for each in view["steps"]]
    return (order.index(view["step"]), len(_list_items(view))) >= (order.index(step), count)


def differences(before: View, after: View) -> Iterator[str]:
    """What was shown before a kill and is not afterwards, in words."""
    if (before["session_id"], True) != (after["session_id"], after["running"]):
        yield f"{before['step']}: the session is not resumed"
        return
    order = [step["id"] for step in after["steps"]]
    # the simulated operator may have ended the step between the last look and the kill
    if order.index(after["step"]) - order.index(before["step"]) not in (0, 1):
        yield f"{before['step']}: resumed at {after['step']}"
    elif after["step"] == before["step"] and not _list_items(before) <= _list_items(after):
        yield f"{before['step']}: {len(_list_items(before) - _list_items(after))} are missing"
    elif after["rev"] < before["rev"]:
        yield f"{before['step']}: rows of the journal are missing"
