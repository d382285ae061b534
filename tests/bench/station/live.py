"""The live station under load: a swift simulated sensor, the recording on, viewers watching.

The station runs as it does for an operator, in a process of its own; the viewers read the
3D view's socket through the station's server, each in its own process.
"""

import contextlib
import tempfile
import time
from collections.abc import Iterator
from dataclasses import dataclass
from multiprocessing.connection import Connection
from pathlib import Path

import httpx
import numpy as np

from crenel.formats.recording.decoders import StripeRecord
from crenel.formats.recording.reader import open_recording
from crenel.metrology.arm.kinematics import Arm, Joint, Tip
from crenel.metrology.sensor.camera import Camera
from crenel.metrology.sensor.laser_plane import LaserPlane
from crenel.operations.context import Context
from crenel.progress import Progress, no_progress
from crenel.station.scan.points import ScanCalibration
from crenel_hardware.simulator.devices.fast_simulator import (
    JOINTS,
    REACH_MM,
    SENSOR_MM,
    FastArm,
    FastSensor,
    FastStationConfig,
    SweepClock,
    draw_stripe_images,
)
from tests.bench.station.subprocess_station import (
    GUEST,
    MB,
    PATIENCE_S,
    memory_mb,
    run_in_process,
    serve_in_thread,
    sign_in,
    stuck_error,
)
from tests.bench.station.viewer_client import watch_view

FOCAL_PX = 4400.0
SETTLING_S = 60.0
"""What the memory grows by is measured from then on, or from a quarter of a shorter run."""


@dataclass(frozen=True)
class LiveBench:
    """What the station did with it. Ages are from mid-exposure to a viewer's socket."""

    seconds: float
    frames_due: int
    frames_recorded: int
    frames_lost: int
    frames_without_joints: int
    points: int
    points_displayed: int
    age_median_s: float
    age_95_s: float
    cores: float
    """Processor time of the station by the clock."""
    settled_mb: float
    """Memory after the first minute, and at the end."""
    last_mb: float
    join_s: float
    """From a second viewer's connection until it has all that is shown."""
    recording_mb_s: float


COLUMNS = ("measure", "value")


def table(found: LiveBench) -> list[tuple[str, str]]:
    rate = found.points / found.seconds / 1e6
    return [
        ("points a second", f"{rate:.2f} million over {found.seconds:.0f} s"),
        (
            "frames due, recorded, lost",
            f"{found.frames_due}, {found.frames_recorded}, {found.frames_lost}",
        ),
        ("frames without joints", f"{found.frames_without_joints}"),
        (
            "age of new points at the viewer",
            f"{found.age_median_s:.2f} s median, {found.age_95_s:.2f} s 95th percentile",
        ),
        (
            "memory after the first minute, at the end",
            f"{found.settled_mb:.0f}, {found.last_mb:.0f} MB",
        ),
        (
            "a second viewer has the whole picture",
            f"{found.join_s:.1f} s, {found.points_displayed} points shown",
        ),
        ("processor", f"{found.cores:.2f} cores"),
        ("recording", f"{found.recording_mb_s:.1f} MB/s"),
    ]


def run(pace: FastStationConfig, seconds: float, progress: Progress = no_progress) -> LiveBench:
    """Scans for so long; a refusal or an HTTP error where the station does not."""
    with (
        tempfile.TemporaryDirectory(prefix="crenel-bench-") as folder,
        _run_station(Path(folder), pace) as station,
        httpx.Client(
            base_url=station.address, headers=station.sign_in_header, timeout=30.0
        ) as http,
    ):
        return _scan(station, http, Path(folder), pace, seconds, progress)


@dataclass(frozen=True)
class _LiveStation:
    port: int
    pid: int
    start_ns: int
    sign_in_header: dict[str, str]
    """The header that its browsers send."""

    @property
    def address(self) -> str:
        return f"http://127.0.0.1:{self.port}"

    @property
    def viewer(self) -> str:
        return f"ws://127.0.0.1:{self.port}/viewer/"

    @property
    def memory_mb(self) -> float:
        return memory_mb(self.pid)

    @property
    def processor_s(self) -> float:
        with contextlib.suppress(OSError):
            words = Path(f"/proc/{self.pid}/stat").read_text().rsplit(")", 1)[1].split()
            return (int(words[11]) + int(words[12])) / 100
        return float("nan")


def _scan(
    station: _LiveStation,
    http: httpx.Client,
    folder: Path,
    pace: FastStationConfig,
    seconds: float,
    progress: Progress,
) -> LiveBench:
    with watch_view(
        station.viewer, station.sign_in_header, station.start_ns, pace.turn_rad_s
    ) as watched:
        http.post("/api/scan/start", json={"name": "Bench"}).raise_for_status()
        began_s, busy_s = time.monotonic(), station.processor_s
        settled_mb = float("nan")
        while (gone_s := time.monotonic() - began_s) < seconds:
            time.sleep(0.2)
            if np.isnan(settled_mb) and gone_s > min(SETTLING_S, seconds / 4):
                settled_mb = station.memory_mb
            progress(gone_s / seconds, f"{gone_s:.0f} of {seconds:.0f} s")
        cores = (station.processor_s - busy_s) / gone_s
        last_mb = station.memory_mb
        joined_s = _join(station, pace)
        http.post("/api/stop").raise_for_status()
        scan = wait_for_stop(http)
        seen = watched()
    recording = next((folder / "scans").glob("*/scan.mcap"))
    recorded = sum(
        isinstance(record, StripeRecord) for record in open_recording(recording).records()
    )
    return LiveBench(
        seconds=scan["seconds"],
        frames_due=round(scan["seconds"] * pace.profiles_hz),
        frames_recorded=recorded,
        frames_lost=int(scan["lost_frames"]),
        frames_without_joints=int(scan["frames_without_joints"]),
        points=int(scan["points"]),
        points_displayed=int(scan["points_shown"]),
        age_median_s=float(np.median(seen.ages_s)),
        age_95_s=float(np.percentile(seen.ages_s, 95)),
        cores=cores,
        settled_mb=settled_mb,
        last_mb=last_mb,
        join_s=joined_s,
        recording_mb_s=recording.stat().st_size / MB / scan["seconds"],
    )


def _join(station: _LiveStation, pace: FastStationConfig) -> float:
    """How long a second viewer waits for what the first one sees."""
    with watch_view(
        station.viewer, station.sign_in_header, station.start_ns, pace.turn_rad_s, until_whole=True
    ) as watched:
        return watched().complete_s


def wait_for_stop(http: httpx.Client) -> dict[str, float]:
    """The scan's state once it has ended."""
    deadline_s = time.monotonic() + PATIENCE_S
    while (scan := http.get("/api/scan").json())["state"] in ("running", "stopping"):
        if time.monotonic() > deadline_s:
            raise stuck_error("the scan does not end")
        time.sleep(0.1)
    return dict(scan)


@contextlib.contextmanager
def _run_station(data: Path, pace: FastStationConfig) -> Iterator[_LiveStation]:
    """A station on the swift devices, serving in a process of its own."""
    with run_in_process(_serve, data, pace) as (pipe, pid):
        port, start_ns, signed_in = pipe.recv()
        yield _LiveStation(port, pid, start_ns, signed_in)


def _serve(pipe: Connection, data: Path, pace: FastStationConfig) -> None:
    """In the station's process: until something comes through the pipe."""
    with scanning(data, pace) as (station, port, clock):
        pipe.send((port, clock.start_ns, sign_in(station, port)))
        pipe.recv()


@contextlib.contextmanager
def scanning(data: Path, pace: FastStationConfig) -> Iterator[tuple[Context, int, SweepClock]]:
    """As ``serving``, and ready to scan: devices there, calibrated."""
    with serving(data, pace) as (station, port, clock):
        while not station.rig.sensor.fresh:
            time.sleep(0.05)
        calibration = fast_station_calibration(pace)
        station.rig.arm.set_model(calibration.arm)
        station.scanner.set_calibration(calibration)
        yield station, port, clock


@contextlib.contextmanager
def serving(data: Path, pace: FastStationConfig) -> Iterator[tuple[Context, int, SweepClock]]:
    """A station on the swift devices that serves from a thread; its port, and their clock."""
    from crenel.server.station_parts import StationParts

    pool, clock = draw_stripe_images(pace), SweepClock()
    parts = StationParts(
        "Bench",
        data,
        lambda: FastArm(pace, clock),
        lambda: FastSensor(pace, clock, pool),
        guest=GUEST,
    )
    with serve_in_thread(parts) as (station, port):
        yield station, port, clock


def fast_station_calibration(pace: FastStationConfig) -> ScanCalibration:
    """Of the swift station: what it was drawn with."""
    joints = [Joint(f"J{i + 1}", 0.0, 0.0, 0.0, 0.0) for i in range(JOINTS)]
    joints[0] = Joint("J1", REACH_MM, 0.0, 0.0, 0.0)
    at = np.array(SENSOR_MM)
    forward = -at / np.linalg.norm(at)
    across = np.array([1.0, 0.0, 0.0])
    rotation = np.array([across, np.cross(forward, across), forward])
    matrix = np.array(
        [[FOCAL_PX, 0, pace.width_px / 2], [0, FOCAL_PX, pace.height_px / 2], [0, 0, 1.0]]
    )
    return ScanCalibration(
        id="bench",
        name="Bench",
        arm=Arm("Swift arm", "SWIFT-A", tuple(joints), Tip(0.0, 0.0, 50.0, 3.0)),
        camera=Camera(matrix, rotation, -rotation @ at, pace.width_px, pace.height_px),
        plane=LaserPlane(np.array([0.0, 1.0, 0.0]), 0.0),
        T_flange_sensor=np.eye(4),
        stripe_axis="u",
        arm_serial="SWIFT-A",
        sensor_serial="SWIFT-S",
        depth_range_mm=(190.0, 260.0),
    )
