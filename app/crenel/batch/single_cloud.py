"""One cloud on demand: the recording of a scan, looked up where its station keeps its records, and
rebuilt with the calibration that it was taken with or with another one."""

from collections.abc import Callable, Mapping, Sequence
from dataclasses import dataclass
from pathlib import Path
from typing import Any

from crenel.archive.archive_settings import ArchiveSettings
from crenel.batch.calibrations import (
    BySensor,
    CalibrationFiles,
    CalibrationFinder,
    sensors_of,
)
from crenel.batch.cluster import OwnWorker, RemoteScheduler
from crenel.batch.places import Place
from crenel.batch.rebuild import RebuildTask, task_of
from crenel.batch.recordings import ScanRecording, Selection, find_recordings
from crenel.batch.results import ResultStore
from crenel.batch.runner import Runner
from crenel.batch.task import Outcome, Task
from crenel.errors import OperationError
from crenel.formats.atomic_write import ensure_folder
from crenel.formats.io_errors import convert_io_errors
from crenel.messages.message import Text, message

GIVE_UP_S = 60.0
"""Somebody waits for the cloud: a store or a scheduler that does not answer is given up sooner."""


@dataclass(frozen=True)
class CloudOrder:
    """A cloud that is wanted; it can be pickled."""

    places: tuple[Place, ...]
    """The places of the station's archive, the nearest first."""
    scan_id: str
    calibration_ids: tuple[str, ...]
    """Each for its sensor; of all others, the one that the recording was taken with."""
    output: ArchiveSettings
    suffix: str
    """The suffix of the cloud's format, as ``.copc.laz``."""
    scratch: Path
    """For temporary files, of a worker of this process."""
    scheduler: str | None = None
    """The address of Dask's scheduler; None: a worker of this process does the work."""


def make_cloud(
    order: CloudOrder, watch: Callable[[float], None], say: Callable[[Text], None]
) -> Mapping[str, Any]:
    """Makes a cloud, unless it is there.

    Args:
        watch: called with the share that is done.
        say: called with what the person who waits should know meanwhile.

    Returns:
        The fields of its ``RebuiltCloud``.

    Raises:
        OperationError: it cannot be made.
    """
    results = ResultStore(order.output)
    results.prepare()
    task = plan_cloud(order)
    if (known := results.read(task.stem)) is not None:
        return known
    with convert_io_errors(order.scratch):
        ensure_folder(order.scratch)
    ended: list[Outcome] = []

    def take(task: Task, outcome: Outcome) -> None:
        ended.append(outcome)

    cluster = (
        OwnWorker(order.scratch)
        if order.scheduler is None
        else RemoteScheduler(order.scheduler, give_up_s=GIVE_UP_S)
    )
    try:
        Runner(
            cluster,
            "rebuild",
            take,
            say=say,
            watch=lambda key, share: watch(share) if key == task.key else None,
            give_up_s=GIVE_UP_S,
        ).run([task])
    finally:
        cluster.close()
    (outcome,) = ended
    if outcome.refusal is not None:
        raise outcome.refusal.error()
    return outcome.result


def plan_cloud(order: CloudOrder) -> RebuildTask:
    """The task of a cloud.

    Raises:
        OperationError: the recording or the calibration is not there or cannot be read, or they are
            of different devices.
    """
    recording = _find_recording(order.places, order.scan_id)
    calibrations = _find_calibrations(order, recording)
    return task_of(recording, calibrations, order.output, order.suffix)


def _find_recording(places: Sequence[Place], scan_id: str) -> ScanRecording:
    """The recording of a scan in the first place that has it; another one that cannot be read does
    no harm then."""
    failures = []
    for place in places:
        try:
            found = next(find_recordings([place], Selection(records=frozenset({scan_id}))), None)
            if found is not None:
                return found
            _check_place(place)
        except OperationError as error:
            failures.append(error)
    if failures:
        raise failures[-1]
    raise OperationError("no-recording", message("batch-no-recording", id=scan_id))


def _check_place(place: Place) -> None:
    """Raises ``OperationError`` if a place without a record is no place at all."""
    found = place.dependency
    if place.store().size(found.marker) is None:
        raise OperationError(
            "archive-missing",
            message("archive-missing", place=found.settings.place),
            message("batch-no-marker", name=found.marker),
        )


def _find_calibrations(order: CloudOrder, recording: ScanRecording) -> BySensor:
    finder = CalibrationFinder(order.places)
    if set(order.calibration_ids) <= set(recording.calibration_ids.values()):
        return finder.of_recording(recording)
    given: dict[str, CalibrationFiles] = {}
    for calibration_id in order.calibration_ids:
        chosen = finder.find(calibration_id, recording.file.place)
        if chosen is None:
            raise OperationError(
                "no-calibration", message("batch-no-calibration", id=calibration_id)
            )
        sensors = sensors_of(chosen, recording)
        if not sensors:
            raise OperationError(
                "other-device", message("batch-other-device", id=chosen.id, scan=recording.id)
            )
        if earlier := [given[one].id for one in sensors if one in given]:
            what = message("batch-same-sensor", id=chosen.id, other=earlier[0])
            raise OperationError("same-sensor", what)
        given |= dict.fromkeys(sensors, chosen)
    found = finder.of_recording(recording, given)
    if len({files.arm_sha256 for files in found.values()}) > 1:
        raise OperationError(
            "different-arms",
            message("batch-different-arms"),
            remedy=message("batch-choose-of-same-arm"),
        )
    return found
