"""Rebuilds many copies of a recording by one worker and by two: speed-up, overhead and memory."""

import json
import os
import shutil
import time
from collections.abc import Sequence
from dataclasses import dataclass
from pathlib import Path
from tempfile import TemporaryDirectory

import numpy as np

from crenel.batch.cluster import LocalWorkers
from crenel.batch.places import DATABASE, find_places, settings_for
from crenel.batch.rebuild import plan_rebuild
from crenel.batch.recordings import RECORDING, Selection
from crenel.batch.results import ResultStore
from crenel.batch.runner import Runner
from crenel.batch.task import Outcome, Task
from crenel.formats.datasheets.arm import read_any_arm
from crenel.formats.recording.reader import SCAN_CALIBRATION, SCAN_NAME
from crenel.formats.recording.writer import RecordingWriter
from crenel.messages.message import Text
from crenel.metrology.arm.kinematics import Arm
from crenel.metrology.stripe import Stripe
from crenel.progress import Progress, no_progress
from crenel_hardware.simulator.station import SimulatedStation, SimulationConfig
from tests.bench.faults.served import true_calibration

SECONDS, RATE_HZ = 5, 200
MS = 1_000_000
SESSION = "calibration"
PLACEHOLDER = "scan 000000"
MEMORY = Path("/dev/shm")
WORKERS = (1, 2)
COLUMNS: Sequence[Text] = (
    "data",
    "workers",
    "start, s",
    "recordings/s",
    "speed-up",
    "a recording, ms",
    "overhead, ms",
    "of a minute, %",
    "memory, MB",
)


@dataclass(frozen=True)
class BatchRun:
    """All recordings rebuilt once."""

    data: str
    workers: int
    recordings: int
    recording_mb: float
    plan_ms: float
    """Until a recording is known with its calibration and its hash."""
    start_s: float
    """Until the workers are there."""
    wall_s: float
    busy_s: float
    """All workers together, within their work."""
    memory_mb: float
    """Most of a worker."""
    load: float
    """Of the machine, before this run: processes that want to run."""

    @property
    def work_ms(self) -> float:
        """Of one recording."""
        return 1e3 * self.busy_s / self.recordings

    @property
    def overhead_ms(self) -> float:
        """Of one recording: time that a worker did not work on it."""
        return 1e3 * (self.wall_s * self.workers - self.busy_s) / self.recordings

    @property
    def share_of_a_minute(self) -> float:
        """The overhead, as a share of the work on a recording of a minute."""
        return self.overhead_ms / (self.work_ms * 60 / SECONDS)


def run(recordings: int, disk: Path, progress: Progress) -> list[BatchRun]:
    """Measures in memory, then on the disk, with one worker and with two.

    Args:
        disk: a folder on the disk that is measured.

    Raises:
        OperationError: there is no memory disk, or no space.
    """
    found = []
    places = {"memory": MEMORY, "disk": disk}
    for number, (name, folder) in enumerate(places.items()):
        with TemporaryDirectory(prefix="crenel-bench-", dir=folder) as top:
            data = Path(top) / "station"
            fill_station(data, recordings)
            for turn, workers in enumerate(WORKERS):
                progress((number + turn / 2) / 2, f"{name}, {workers} workers")
                found.append(measure(name, data, Path(top) / f"clouds-{workers}", workers))
    return found


def fill_station(data: Path, recordings: int) -> None:
    """A data folder with one simulated recording, copied under other names."""
    session = data / "sessions" / SESSION
    session.mkdir(parents=True)
    (data / DATABASE).touch()
    with SimulatedStation(SimulationConfig()) as simulation:
        (session / "calibration.json").write_text(json.dumps(true_calibration(simulation)))
        (session / "arm.json").write_text(json.dumps(simulation.datasheets()["arm.json"]))
        size = simulation.config.width_px, simulation.config.height_px
    template = data / "template.mcap"
    _record(template, session / "arm.json", *size)
    content = template.read_bytes()
    template.unlink()
    for number in range(recordings):
        folder = data / "scans" / f"scan-{number:06d}"
        folder.mkdir(parents=True)
        name = PLACEHOLDER[:-6] + f"{number + 1:06d}"
        with open(folder / RECORDING, "wb") as file:
            file.write(content.replace(PLACEHOLDER.encode(), name.encode()))
            file.flush()
            os.fsync(file.fileno())


def measure(name: str, data: Path, output: Path, workers: int) -> BatchRun:
    """Rebuilds everything once, into a new folder that is removed.

    Raises:
        OperationError: a recording was not rebuilt.
    """
    load = os.getloadavg()[0]
    _drop_from_memory(data)
    results = ResultStore(settings_for(str(output)))
    results.prepare()
    began_s = time.perf_counter()
    plan = plan_rebuild(find_places([str(data)]), Selection(), results.settings, ".ply")
    plan_s = time.perf_counter() - began_s
    _drop_from_memory(data)
    outcomes: list[Outcome] = []

    def take(task: Task, outcome: Outcome) -> None:
        if outcome.refusal is not None:
            raise outcome.refusal.error()
        outcomes.append(outcome)

    began_s = time.perf_counter()
    cluster = LocalWorkers(workers)
    try:
        cluster.threads = 1
        cluster.client.wait_for_workers(workers)
        start_s = time.perf_counter() - began_s
        began_s = time.perf_counter()
        Runner(cluster, "bench", take, no_progress).run(plan.tasks)
        wall_s = time.perf_counter() - began_s
    finally:
        cluster.close()
    shutil.rmtree(output)
    count = len(outcomes)
    return BatchRun(
        name,
        workers,
        count,
        plan.tasks[0].size_bytes / 1e6,
        1e3 * plan_s / count,
        start_s,
        wall_s,
        sum(one.seconds for one in outcomes),
        max(one.memory_bytes for one in outcomes) / 1e6,
        load,
    )


def table(runs: Sequence[BatchRun]) -> list[list[str]]:
    """One row for each run."""
    single = {one.data: one.wall_s for one in runs if one.workers == 1}
    return [
        [
            one.data,
            str(one.workers),
            f"{one.start_s:.1f}",
            f"{one.recordings / one.wall_s:.2f}",
            f"{single[one.data] / one.wall_s:.2f}",
            f"{one.work_ms:.0f}",
            f"{one.overhead_ms:.1f}",
            f"{100 * one.share_of_a_minute:.2f}",
            f"{one.memory_mb:.0f}",
        ]
        for one in runs
    ]


def _record(path: Path, arm_file: Path, width_px: int, height_px: int) -> None:
    """Five seconds of a noisy line while the arm moves slowly."""
    arm = read_any_arm(arm_file)
    assert isinstance(arm, Arm)
    rng = np.random.default_rng(0)
    names = [joint.name for joint in arm.joints]
    about = {SCAN_NAME: PLACEHOLDER, SCAN_CALIBRATION: SESSION}
    u = np.arange(width_px, dtype=np.float64)
    step_ns = 1000 * MS // RATE_HZ
    middle_rad = np.array([np.mean(joint.limits_rad) for joint in arm.joints])
    with RecordingWriter(path, names, about) as writer:
        for frame in range(SECONDS * RATE_HZ):
            stamp_ns = frame * step_ns
            writer.joints(stamp_ns, middle_rad + 2e-4 * frame)
            v = 0.5 * height_px + 20 * np.sin(u / 90 + frame / 50) + rng.normal(0, 0.05, width_px)
            stripe = Stripe(u, v, np.full(width_px, 120.0), np.full(width_px, 0.05))
            writer.stripe(stamp_ns, stripe, width_px, height_px)
        writer.joints(SECONDS * RATE_HZ * step_ns, middle_rad)


def _drop_from_memory(data: Path) -> None:
    """So that a disk is read; a disk in memory stays there."""
    for path in data.glob(f"scans/*/{RECORDING}"):
        with open(path, "rb") as file:
            os.posix_fadvise(file.fileno(), 0, 0, os.POSIX_FADV_DONTNEED)
