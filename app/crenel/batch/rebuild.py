"""``crenel rebuild``: the clouds of many recordings, with today's calibration or any other."""

import hashlib
from collections.abc import Mapping, Sequence
from dataclasses import dataclass
from typing import Any

from crenel.archive.archive_settings import ArchiveSettings
from crenel.archive.store_errors import is_of_whole_place
from crenel.batch.calibrations import BySensor, CalibrationFinder, GivenCalibrations
from crenel.batch.patience import Patience
from crenel.batch.places import Dependency, Place
from crenel.batch.recordings import RECORDING, ScanRecording, Selection, find_recordings
from crenel.batch.results import RebuiltCloud, ResultStore, describe_files, stem_of
from crenel.batch.task import Desk, Refusal
from crenel.errors import OperationError
from crenel.formats.json_document import SOFTWARE
from crenel.messages.message import Text, message
from crenel.progress import Progress, no_progress
from crenel.workflows.reconstruct import reconstruct_cloud


@dataclass(frozen=True)
class RebuildTask:
    """The cloud of one recording."""

    key: str
    recording: ScanRecording
    digest: str
    """SHA-256 of the recording."""
    calibrations: BySensor
    output: ArchiveSettings
    suffix: str
    """The suffix of the cloud's format, as ``.ply``."""

    @property
    def name(self) -> str:
        return f"{self.recording.station}/{self.recording.id}"

    @property
    def size_bytes(self) -> int:
        return self.recording.file.bytes

    @property
    def stem(self) -> str:
        """The name of the result without its suffix."""
        return stem_of(self.recording.station, self.recording.id, self.key)

    @property
    def depends_on(self) -> Sequence[Dependency]:
        return (self.recording.file.place.dependency, Dependency(self.output))

    def perform(self, desk: Desk) -> Mapping[str, Any]:
        results = ResultStore(self.output)
        if (known := results.read(self.stem)) is not None:
            return known
        read = {sensor: files.read(desk.folder) for sensor, files in self.calibrations.items()}
        _, arm = next(iter(read.values()))
        sensors = {sensor: calibration for sensor, (calibration, _) in read.items()}
        path = desk.find_recording(self.recording.file, RECORDING)
        cloud = self.stem + self.suffix
        with results.file(cloud, desk) as target:
            made = reconstruct_cloud(path, sensors, arm, target, desk.report, threads=desk.threads)
            cloud_bytes = target.stat().st_size
        document = RebuiltCloud(
            key=self.key,
            station=self.recording.station,
            record=self.recording.id,
            started_at=self.recording.started_at.isoformat(),
            recording_sha256=self.digest,
            calibrations=describe_files(self.calibrations),
            software=SOFTWARE,
            cloud=cloud,
            cloud_bytes=cloud_bytes,
            points=made.points,
            frames=made.frames,
            frames_without_stripe=made.frames_without_stripe,
            frames_without_joints=made.frames_without_joints,
            seconds=made.seconds,
            warnings=(*made.warnings, *_arm_warnings(self.calibrations)),
        )
        return results.write(self.stem, document)


@dataclass(frozen=True)
class RebuildPlan:
    """What is to be done."""

    tasks: list[RebuildTask]
    refused: list[tuple[str, Refusal]]
    """Recordings that cannot be rebuilt, by name."""
    left_out: int
    """Recordings of another arm or sensor than the given calibration's."""
    found: list[ScanRecording]
    """All that are chosen, whatever becomes of them."""


def plan_rebuild(
    places: Sequence[Place],
    selection: Selection,
    output: ArchiveSettings,
    suffix: str,
    given: BySensor | None = None,
    progress: Progress = no_progress,
    patience: Patience | None = None,
) -> RebuildPlan:
    """The recordings that are chosen, each with the calibrations for it.

    Args:
        output: where the clouds go.
        given: calibrations for all; None: those with which each recording was taken.
        patience: with which it is waited for stores that cannot be reached.

    Raises:
        OperationError: a place cannot be read, or a given calibration is damaged.
    """
    finder = CalibrationFinder(places, patience)
    tasks: list[RebuildTask] = []
    refused: list[tuple[str, Refusal]] = []
    found: list[ScanRecording] = []
    left_out = 0
    checked = GivenCalibrations(given) if given is not None else None
    for recording in find_recordings(places, selection, progress, patience):
        found.append(recording)
        if checked is not None and not checked.belong_to(recording):
            left_out += 1
            continue
        name = f"{recording.station}/{recording.id}"
        try:
            calibrations = given if given is not None else finder.of_recording(recording)
            tasks.append(task_of(recording, calibrations, output, suffix))
        except OperationError as error:
            if is_of_whole_place(error):
                raise
            refused.append((name, Refusal.of(error)))
    return RebuildPlan(tasks, refused, left_out, found)


def task_of(
    recording: ScanRecording, calibrations: BySensor, output: ArchiveSettings, suffix: str
) -> RebuildTask:
    """The task of a recording with these calibrations.

    Raises:
        OperationError: the recording cannot be read.
    """
    digest = recording.file.digest()
    key = key_of("rebuild", digest, calibrations, suffix)
    return RebuildTask(key, recording, digest, calibrations, output, suffix)


def key_of(kind: str, digest: str, calibrations: BySensor, *more: str) -> str:
    """The key of a result: of recording, calibrations, arm, software version and what else
    determines it."""
    used = [f"{sensor} {files.digest}" for sensor, files in sorted(calibrations.items())]
    lines = [kind, SOFTWARE.version, digest, *used, *more]
    return hashlib.sha256("\n".join(lines).encode()).hexdigest()


def _arm_warnings(calibrations: BySensor) -> list[Text]:
    """That the sensors were calibrated with different arms: the first one's is used for all."""
    if len({files.arm_sha256 for files in calibrations.values()}) < 2:
        return []
    return [message("batch-first-arm-for-all", sensor=next(iter(calibrations)))]
