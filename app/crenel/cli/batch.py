"""The command line's part for many recordings: ``crenel rebuild``, and what its like share."""

import os
import sys
from collections.abc import Iterator, Sequence
from contextlib import contextmanager
from dataclasses import dataclass, field
from enum import StrEnum
from pathlib import Path
from typing import TYPE_CHECKING, Annotated

import typer

from crenel.cli.batch_options import (
    ArmFile,
    Config,
    EachCalibration,
    Label,
    Output,
    PeriodOption,
    Places,
    Record,
    Scheduler,
    Station,
    TakenWith,
    Workers,
)
from crenel.cli.choice import check_found, check_stations, count_scans, count_words
from crenel.cli.scan import paths_by_sensor
from crenel.console import AsJson, fail_if_left_out, print_json, progress_bar, report_errors, warn
from crenel.messages.message import Text

if TYPE_CHECKING:
    from crenel.archive.archive_settings import ArchiveSettings
    from crenel.batch.calibrations import BySensor
    from crenel.batch.cluster import Cluster
    from crenel.batch.patience import Patience
    from crenel.batch.places import Place
    from crenel.batch.recordings import Selection
    from crenel.batch.results import ResultStore
    from crenel.batch.task import Outcome, Refusal, Task

MOST_SHOWN = 10
"""How many refusals are shown."""


class CloudFormat(StrEnum):
    """The formats of rebuilt clouds."""

    PLY = "ply"
    PCD = "pcd"
    E57 = "e57"
    XYZ = "xyz"
    LAS = "las"
    LAZ = "laz"
    COPC = "copc"


@dataclass
class Tally:
    """What became of the tasks."""

    done: list["tuple[Task, Outcome]"] = field(default_factory=list)
    refused: list["tuple[str, Refusal]"] = field(default_factory=list)
    tries: int = 0
    """How often one was given to a scheduler."""

    def take(self, task: "Task", outcome: "Outcome") -> None:
        """Called with each that has ended."""
        if outcome.refusal is None:
            self.done.append((task, outcome))
        else:
            self.refused.append((task.name, outcome.refusal))

    def end(self, known: int) -> None:
        """Names what was refused on stderr, and ends with a status that says so, if anything was.

        Args:
            known: how many tasks had a result before.
        """
        for name, refusal in self.refused[:MOST_SHOWN]:
            warn(f"{name}: {refusal.error().line}")
        count = len(self.refused)
        were = f"{count_words(count, 'recording')} {'was' if count == 1 else 'were'} refused"
        of = count + len(self.done) + known
        fail_if_left_out(count, of, f"{were}, and none is left.", f"{were}; all others are there.")


@report_errors
def rebuild(
    places: Places = None,
    output: Output = "clouds",
    cloud_format: Annotated[
        CloudFormat, typer.Option("--format", help="Of the clouds.")
    ] = CloudFormat.PLY,
    period: PeriodOption = None,
    station: Station = None,
    taken_with: TakenWith = None,
    record: Record = None,
    label: Label = None,
    calibration: EachCalibration = None,
    arm: ArmFile = None,
    workers: Workers = None,
    scheduler: Scheduler = None,
    config: Config = None,
    as_json: AsJson = False,
) -> None:
    """Rebuild the clouds of many recordings, on all cores or on a cluster of Dask.

    What is in the output already is not made again: start it again after any interruption.
    """
    from crenel.batch.patience import Patience
    from crenel.batch.rebuild import plan_rebuild
    from crenel.batch.results import ResultStore
    from crenel.formats.clouds.files import COPC

    patience = Patience(say)
    found, keys = open_places(places, config, patience)
    results = ResultStore(output_settings(output, keys, found), patience)
    results.prepare()
    selection = selection_of(found, period, station, taken_with, record, label)
    with progress_bar("Looking for recordings", not as_json) as progress:
        plan = plan_rebuild(
            found,
            selection,
            results.settings,
            COPC if cloud_format is CloudFormat.COPC else f".{cloud_format.value}",
            choose_calibrations(calibration, arm, found, patience),
            progress,
            patience,
        )
        check_found(selection, found, plan.found, patience, progress)
    tally = Tally(refused=plan.refused)
    known = do_missing("rebuild", plan.tasks, results, workers, scheduler, tally, as_json)
    points = sum(int(outcome.result.get("points", 0)) for _, outcome in tally.done)
    if not plan.found:
        say(f"No recording is chosen; the places have {count_words(count_scans(found), 'scan')}.")
    if as_json:
        print_json(
            {
                "made": len(tally.done),
                "tries": tally.tries,
                "already_there": known,
                "of_other_devices": plan.left_out,
                "refused": {name: refusal.error().line for name, refusal in tally.refused},
                "points": points,
                "output": results.settings.place,
            }
        )
    else:
        others = f", {plan.left_out} of other devices left out" if plan.left_out else ""
        print(
            f"{count_words(len(tally.done), 'cloud')} with {points} points made, "
            f"{known} {'was' if known == 1 else 'were'} there already{others}. "
            f"They are in {results.settings.place}."
        )
    tally.end(known)


def do_missing(
    kind: str,
    tasks: "Sequence[Task]",
    results: "ResultStore",
    workers: int | None,
    scheduler: str | None,
    tally: Tally,
    as_json: bool,
) -> int:
    """Does the tasks without a result.

    Returns:
        The number of those that had one.

    Raises:
        OperationError: none of the others can be done now.
    """
    from crenel.batch.results import SHORT_KEY
    from crenel.batch.runner import Runner

    wanted = {task.key[:SHORT_KEY]: task for task in tasks}
    there = results.whole_keys(wanted.keys())
    missing = {key: task for key, task in wanted.items() if key not in there}
    ended = not missing
    try:
        if missing:
            with open_cluster(len(missing), workers, scheduler) as cluster:
                if not as_json:
                    say(f"Dask's dashboard: {cluster.client.dashboard_link}")
                with progress_bar(count_words(len(missing), "recording"), not as_json) as progress:
                    runner = Runner(cluster, kind, tally.take, progress, say)
                    runner.run(list(missing.values()))
                    tally.tries = runner.tries
        ended = True
    finally:
        if missing and (ended or scheduler is None):  # others' workers may still be writing
            results.remove_parts(missing.keys())
    return len(tasks) - len(missing)


@contextmanager
def open_cluster(most: int, workers: int | None, scheduler: str | None) -> "Iterator[Cluster]":
    """Workers of this machine, or those of a scheduler.

    Args:
        most: processes that have something to do.
    """
    from crenel.batch.cluster import LocalWorkers, RemoteScheduler

    if workers is not None and scheduler is not None:
        raise typer.BadParameter(
            "give only one of the two", param_hint="'--workers', '--scheduler'"
        )
    cluster: Cluster
    if scheduler is not None:
        cluster = RemoteScheduler(scheduler)
    else:
        cluster = LocalWorkers(max(min(workers or os.cpu_count() or 1, most), 1))
    try:
        yield cluster
    finally:
        cluster.close()


def open_places(
    given: Sequence[str] | None, config: Path | None, patience: "Patience"
) -> "tuple[list[Place], ArchiveSettings | None]":
    """The places of the command line, by default the archive of ``station.toml``, and the settings
    whose endpoint and keys are used for all."""
    from crenel.batch.places import find_places
    from crenel.errors import OperationError
    from crenel.messages.message import message
    from crenel.settings.station_toml import DEFAULT_FILE, read_settings

    if not given and config is None and not Path(DEFAULT_FILE).exists():
        raise OperationError(
            "no-place", message("batch-none-named"), remedy=message("batch-name-a-place")
        )
    keys = read_settings(config).archive if config is not None or not given else None
    if not given and keys is None:
        raise OperationError(
            "no-archive", message("archive-not-set"), remedy=message("archive-write-table")
        )
    return find_places(given or [keys.url if keys is not None else ""], keys, patience), keys


def output_settings(
    output: str, keys: "ArchiveSettings | None", places: "Sequence[Place]"
) -> "ArchiveSettings":
    """Where results go; refuses a place within an archive or a data folder."""
    from crenel.batch.places import settings_for
    from crenel.batch.results import check_results_apart

    made = settings_for(output, keys)
    check_results_apart(made, [place.settings for place in places])
    return made


def selection_of(
    places: "Sequence[Place]",
    period: str | None,
    stations: Sequence[str] | None,
    taken_with: Sequence[str] | None,
    records: Sequence[str] | None = None,
    labels: Sequence[str] | None = None,
) -> "Selection":
    """The choice among the records; ends the command for a station that no place is of."""
    from crenel.batch.period import ALWAYS, parse_period
    from crenel.batch.recordings import Selection

    check_stations(stations or (), [place.station for place in places], "in these places")
    return Selection(
        parse_period(period) if period is not None else ALWAYS,
        frozenset(stations or ()),
        frozenset(taken_with or ()),
        frozenset(records or ()),
        frozenset(labels or ()),
    )


def choose_calibrations(
    given: Sequence[str] | None, arm: Path | None, places: "Sequence[Place]", patience: "Patience"
) -> "BySensor | None":
    """The calibrations of the command line by their sensors; None: those of each recording."""
    from crenel.batch.calibrations import CalibrationFinder, choose_calibration

    if not given:
        if arm is not None:
            raise typer.BadParameter("needs --calibration, too", param_hint="'--arm'")
        return None
    finder = CalibrationFinder(places, patience)
    named = paths_by_sensor(given)
    return {name: choose_calibration(str(path), arm, finder) for name, path in named.items()}


def say(text: Text) -> None:
    """A line for the operator, while the work goes on."""
    print("crenel:", str(text), file=sys.stderr)
