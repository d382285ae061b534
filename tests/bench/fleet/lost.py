"""Stations record into a store that is away for a while, and workers rebuild all recordings while
a worker, the scheduler and the store are lost: is every result there, once?"""

import time
from collections.abc import Sequence
from dataclasses import dataclass
from pathlib import Path
from tempfile import TemporaryDirectory

from crenel.messages.message import Text
from crenel.progress import Progress
from tests.bench.fleet.losses import CLOUDS, RebuildRun, rebuild_with_losses
from tests.bench.fleet.recording_stations import (
    PLANT,
    BenchStation,
    Recordings,
    count_archived,
    make_station,
    recording,
)
from tests.bench.fleet.result_count import MadeScan, ResultCount, count_results
from tests.bench.fleet.s3_server import CuttingProxy, S3Server
from tests.bench.station.subprocess_station import stuck_error

SESSION = "sessions/truth"
"""The calibration of every station."""
STORE_LOST_AT = 0.3
"""Share of the recordings that are made by then."""
LOOK_S = 0.5
ARCHIVE_PATIENCE_S = 900.0
FOREVER = float("inf")
COLUMNS: Sequence[Text] = ("measure", "value")


@dataclass(frozen=True)
class LossPlan:
    """What is recorded, and for how long the store is away, each of two times."""

    stations: int = 3
    recordings: int = 200
    """Of all stations together."""
    seconds: float = 5.0
    """Of each recording."""
    away_s: float = 60.0


@dataclass(frozen=True)
class RecordingTimes:
    """How the recordings were made."""

    recordings: int
    made_while_away: int
    """Of these, made while the store was away."""
    record_s: float
    """Until the last one was made."""
    archive_s: float
    """From then on, until the stations had archived all."""


@dataclass(frozen=True)
class LostRun:
    """What became of the recordings."""

    plan: LossPlan
    made: RecordingTimes
    archived: int
    """Recordings whose files in the archive all have the hashes of the station's."""
    count: ResultCount
    refused: dict[str, str]
    """Why, by the recordings' names."""
    tries: int
    """Recordings that were given to the workers; given again, they count again."""
    points: int
    """Of all clouds together."""
    rebuild_s: float


def run(plan: LossPlan, disk: Path, progress: Progress) -> LostRun:
    """Records, archives and rebuilds, and compares what is there in the end.

    Args:
        disk: a folder in which the data folders of the stations are for so long.

    Raises:
        OperationError: a process does not start, fails or does not go on.
    """
    with TemporaryDirectory(prefix="crenel-bench-", dir=disk) as folder, S3Server() as server:
        top = Path(folder)
        proxy = CuttingProxy(server.port, 0)
        proxy.restore(FOREVER)
        try:
            address = f"http://127.0.0.1:{proxy.port}"
            stations = [
                make_station(top, f"room-{number + 1}", address) for number in range(plan.stations)
            ]
            made = _record(stations, plan, proxy, progress)
            archived = sum(count_archived(one) for one in stations)
            (top / "work").mkdir()
            rebuilt = rebuild_with_losses(
                server, proxy, top / "work", PLANT, made.recordings, plan.away_s, progress
            )
            count = _compare(stations, server, top / "work", progress)
        finally:
            proxy.close()
    return _describe_run(plan, made, archived, rebuilt, count)


def _describe_run(
    plan: LossPlan, made: RecordingTimes, archived: int, rebuilt: RebuildRun, count: ResultCount
) -> LostRun:
    printed = rebuilt.printed
    refused, tries = dict(printed["refused"]), int(printed["tries"])
    points = int(printed["points"])
    return LostRun(plan, made, archived, count, refused, tries, points, rebuilt.seconds)


def _record(
    stations: Sequence[BenchStation], plan: LossPlan, proxy: CuttingProxy, progress: Progress
) -> RecordingTimes:
    """Until all recordings are made and archived; the stations run as long."""

    def show() -> None:
        text = f"{made.made} of {plan.recordings} recorded"
        progress(made.made / plan.recordings, text)

    with recording(stations, plan.recordings, plan.seconds) as made:
        began_s = time.monotonic()
        while made.running and made.made < STORE_LOST_AT * plan.recordings:
            show()
            time.sleep(LOOK_S)
        before = made.made
        _lose_store(proxy, plan.away_s, made)
        while_away = made.made - before
        while made.running:
            show()
            time.sleep(LOOK_S)
        record_s = time.monotonic() - began_s
        archived_s = time.monotonic()
        while (archived := sum(one.count_noted() for one in stations)) < made.made:
            if time.monotonic() - archived_s > ARCHIVE_PATIENCE_S:
                raise stuck_error("the stations do not archive all", ARCHIVE_PATIENCE_S)
            progress(archived / made.made, f"{archived} of {made.made} archived")
            time.sleep(LOOK_S)
        return RecordingTimes(made.made, while_away, record_s, time.monotonic() - archived_s)


def _lose_store(proxy: CuttingProxy, away_s: float, made: Recordings) -> None:
    proxy.restore(0)  # no connection goes on, and none is taken
    until_s = time.monotonic() + away_s
    while time.monotonic() < until_s and made.running:
        time.sleep(LOOK_S)
    time.sleep(max(until_s - time.monotonic(), 0.0))
    proxy.restore(FOREVER)


def _compare(
    stations: Sequence[BenchStation], server: S3Server, scratch: Path, progress: Progress
) -> ResultCount:
    scans = [
        MadeScan(one.name, folder, one.data / SESSION) for one in stations for folder in one.scans()
    ]
    return count_results(
        scans,
        server.names(CLOUDS),
        lambda name: server.read(CLOUDS + name),
        scratch,
        lambda done: progress(done / len(scans), f"{done} of {len(scans)} compared"),
    )


def table(found: LostRun) -> list[tuple[str, str]]:
    """One row for each measure."""
    plan, made, count = found.plan, found.made, found.count
    return [
        ("stations", f"{plan.stations}"),
        ("recordings made", f"{made.recordings} of {plan.seconds:g} s"),
        ("of these, while the store was away", f"{made.made_while_away} in {plan.away_s:.0f} s"),
        ("archived, with the station's hashes", f"{found.archived}"),
        ("results", f"{count.results}"),
        ("results doubled or without a recording", f"{count.doubled}"),
        ("results missing", f"{count.missing}"),
        ("clouds unlike the station's recording", f"{count.differing}"),
        ("refused", "; ".join([f"{len(found.refused)}", *found.refused.values()])),
        ("points of a cloud, in the mean", f"{found.points / max(count.results, 1):.0f}"),
        ("recordings given to workers, again included", f"{found.tries}"),
        ("time: recording", f"{made.record_s:.0f} s"),
        ("time: until the archive had all", f"{made.archive_s:.0f} s"),
        ("time: rebuilding", f"{found.rebuild_s:.0f} s"),
    ]
