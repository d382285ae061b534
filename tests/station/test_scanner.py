"""A scan on small devices: what is recorded, what is saved, and what is refused."""

import asyncio
import resource
import shutil
from collections.abc import Iterator
from contextlib import closing
from dataclasses import replace
from pathlib import Path

import numpy as np
import pytest

from crenel.errors import OperationError
from crenel.formats.clouds.files import read_cloud
from crenel.formats.recording.decoders import StripeRecord
from crenel.formats.recording.reader import open_recording
from crenel.metrology.sensor.camera import Camera
from crenel.metrology.sensor.laser_plane import LaserPlane
from crenel.metrology.transforms import rigid, rotation_from_vector
from crenel.station.bus import Bus
from crenel.station.devices import awake_clock
from crenel.station.devices.rig import Rig
from crenel.station.scan import storage as scan_folders
from crenel.station.scan.pipeline import ScanPipeline
from crenel.station.scan.points import ScanCalibration
from crenel.station.scan.recorder import Recorder
from crenel.station.scan.scanner import Scanner
from crenel.station.scan.state import ScanResult, ScanState
from crenel.station.view3d.scene import Scene
from crenel.workflows.reconstruct import reconstruct_cloud
from tests.refusals import refused
from tests.station.conftest import HEIGHT, REST_RAD, WIDTH, Bench, six_axis_arm, until
from tests.station.simulated import check_rebuilt, end_scan, file_calibration

pytestmark = pytest.mark.device


def calibration() -> ScanCalibration:
    matrix = np.array([[400.0, 0, WIDTH / 2], [0, 400.0, HEIGHT / 2], [0, 0, 1]])
    tilt = np.radians(30)
    return ScanCalibration(
        id="c1",
        name="first",
        arm=six_axis_arm(),
        camera=Camera(matrix, np.eye(3), np.zeros(3), WIDTH, HEIGHT),
        plane=LaserPlane(np.array([0, -np.sin(tilt), np.cos(tilt)]), 150 * np.cos(tilt)),
        T_flange_sensor=rigid(
            rotation_from_vector(np.array([0.2, -0.1, 0.3])), np.array([5, 60, 90])
        ),
        stripe_axis="u",
        arm_serial="A-1",
        sensor_serial="S-1",
        depth_range_mm=(120.0, 190.0),
    )


@pytest.fixture(scope="module")
def scene() -> Iterator[Scene]:
    with closing(Scene(point_budget=50_000)) as scene:
        yield scene


@pytest.fixture
def scanner(bus: Bus, rig: Rig, scene: Scene, tmp_path: Path) -> Iterator[Scanner]:
    with closing(Scanner(bus, rig, scene, tmp_path / "scans")) as scanner:
        scanner.set_calibration(calibration())
        yield scanner


def swing(seconds: float) -> np.ndarray:
    return np.asarray(REST_RAD + 0.1 * np.sin(2 * seconds))


def test_a_scan_is_recorded_saved_and_shown(scanner: Scanner, bench: Bench, scene: Scene) -> None:
    """The recording, rebuilt, gives the very points that were saved live."""
    bench.joints_at = swing
    scan_id = scanner.start("bracket")
    assert bench.laser_on
    until(lambda: scanner.state().frames >= 40)
    state = scanner.state()
    assert (state.state, state.scan_id) == ("running", scan_id)
    assert state.rate_points_s > 0
    result = end_scan(scanner)
    assert not bench.laser_on
    assert (result.name, result.calibration_id) == ("bracket", "c1")

    folder = result.folder
    live = read_cloud(folder / "cloud.ply")
    assert len(live.points_mm) == result.points == scanner.state().points
    assert result.points > 40 * 0.9 * WIDTH
    rebuilt = check_rebuilt(folder, file_calibration(calibration()), calibration().arm)
    assert rebuilt.cut == ""
    assert rebuilt.all_frames == result.frames
    until(lambda: scene.points_shown > 1000)


def test_frames_without_the_laser_give_no_points(scanner: Scanner, bench: Bench, rig: Rig) -> None:
    scanner.start("dark")
    until(lambda: scanner.state().frames > 3)
    bench.laser_on = False
    until(lambda: scanner.state().rate_points_s == 0)
    received = rig.sensor.link().received  # what still waits when the laser goes off is taken
    until(lambda: rig.sensor.link().received > received + 20)
    frames = scanner.state().frames
    until(lambda: rig.sensor.link().received > received + 40)
    assert scanner.state().frames == frames
    assert scanner.stop() is not None


def test_a_scan_is_published_to_all_subscribers(scanner: Scanner, bus: Bus) -> None:
    async def scenario() -> tuple[ScanResult, list[ScanState]]:
        loop = asyncio.get_running_loop()
        bus.attach(loop)
        finished: asyncio.Future[ScanResult] = loop.create_future()

        def done(result: ScanResult) -> None:
            loop.call_soon_threadsafe(finished.set_result, result)

        scanner.on_finished = done
        states: list[ScanState] = []
        with bus.subscribe(without={"devices"}) as reader:
            await asyncio.to_thread(scanner.start, "published")
            while not states or states[-1].points == 0:
                state = (await reader.next()).topics.get("scan", scanner.state())
                assert isinstance(state, ScanState)
                states.append(state)
            await asyncio.to_thread(scanner.stop)
            return await asyncio.wait_for(finished, 240), states

    result, states = asyncio.run(scenario())
    assert result.points >= states[-1].points > 0
    assert any(state.state == "running" for state in states)


def test_losing_the_arm_keeps_the_scan_and_counts_frames(scanner: Scanner, bench: Bench) -> None:
    scanner.start("lost arm")
    until(lambda: scanner.state().points > 0)
    bench.arm_plugged = False
    until(lambda: scanner.state().frames_without_joints > 20)
    assert any(finding.quality == "bad" for finding in scanner.state().findings)
    points = scanner.state().points
    bench.arm_plugged = True
    until(lambda: scanner.state().points > points)
    assert end_scan(scanner).frames > 20


def test_a_scan_with_a_jumped_joint_is_incomplete_in_red(scanner: Scanner, bench: Bench) -> None:
    jump = np.zeros(6)
    bench.joints_at = lambda seconds: swing(seconds) + jump
    scanner.start("jump")
    # a busy machine may lack joints at first, and makes up for it
    until(lambda: scanner.state().frames >= 30 and not scanner.state().incomplete)
    jump[0] = 0.5
    until(lambda: scanner.state().incomplete)
    assert "bad" in [one.quality for one in scanner.state().findings]
    result, state = end_scan(scanner), scanner.state()
    assert state.incomplete
    assert result.left_out.is_too_much
    assert result.left_out.frames == state.frames_without_joints
    assert [one.quality for one in state.findings][:2] == ["bad", "attention"]
    calibrated = file_calibration(calibration())
    recording, cloud = result.folder / "scan.mcap", result.folder / "again.ply"
    with refused("scan-incomplete"):
        reconstruct_cloud(recording, calibrated, calibration().arm, cloud)


def test_losing_the_sensor_keeps_scan_and_laser(scanner: Scanner, bench: Bench, rig: Rig) -> None:
    scanner.start("lost sensor")
    until(lambda: scanner.state().points > 0)
    bench.sensor_plugged = False
    until(lambda: not rig.sensor.fresh)
    points = scanner.state().points
    bench.sensor_plugged = True
    until(lambda: scanner.state().points > points)
    assert scanner.stop() is not None
    assert not bench.laser_on


def test_what_forbids_a_scan_is_said(scanner: Scanner, bench: Bench, rig: Rig) -> None:
    cases = {
        "wrong-arm": replace(calibration(), arm_serial="A-2"),
        "wrong-sensor": replace(calibration(), sensor_serial="S-2"),
        "wrong-image-size": replace(
            calibration(), camera=replace(calibration().camera, width_px=640)
        ),
        "no-calibration": None,
    }
    for code, other in cases.items():
        scanner.set_calibration(other)
        with refused(code) as failed:
            scanner.start("no")
        assert scanner.state().state == "blocked"
        assert scanner.state().why_not == failed.value.text
    scanner.set_calibration(calibration())
    bench.arm_plugged = False
    until(lambda: not rig.arm.fresh)
    with pytest.raises(OperationError, match="the arm sends no data"):
        scanner.start("no")
    assert not bench.laser_on


def test_one_scan_at_a_time(scanner: Scanner) -> None:
    scanner.start("one")
    with pytest.raises(OperationError, match="a scan is already running"):
        scanner.start("two")
    assert scanner.stop() is not None
    assert scanner.stop() is None


def test_two_scans_in_one_second_have_folders_of_their_own(scanner: Scanner) -> None:
    ids = set()
    for _ in range(3):
        ids.add(scanner.start(""))
        scanner.stop()
    assert len(ids) == 3


def test_a_scan_without_a_point_is_saved_as_an_empty_cloud(scanner: Scanner, bench: Bench) -> None:
    bench.stripe_row = -100.0
    scanner.start("nothing there")
    until(lambda: scanner.state().frames > 5)
    result = end_scan(scanner)
    assert result.points == 0
    assert (result.folder / "cloud.ply").exists()


def test_a_full_disk_ends_a_scan(scanner: Scanner, rig: Rig, tmp_path: Path, bench: Bench) -> None:
    """A limit on the size of this process's files is as good as a full disk."""
    bench.frame_period_s = 0.003
    soft, hard = resource.getrlimit(resource.RLIMIT_FSIZE)
    resource.setrlimit(resource.RLIMIT_FSIZE, (1_500_000, hard))
    try:
        scan_id = scanner.start("full")
        until(lambda: scanner.state().state not in ("running", "stopping"))
    finally:
        resource.setrlimit(resource.RLIMIT_FSIZE, (soft, hard))
    state = scanner.state()
    assert any("The scan stopped" in str(finding.text) for finding in state.findings)
    assert not bench.laser_on
    folder = tmp_path / "scans" / scan_id
    assert not list(folder.glob("*.part")), "nothing half-written is left"
    assert sum(1 for _ in open_recording(folder / "scan.mcap").records()) > 100
    assert rig.arm.fresh
    scanner.start("after")
    until(lambda: scanner.state().points > 0)
    assert scanner.stop() is not None


def test_too_little_space_refuses_before_anything_moves(
    scanner: Scanner, bench: Bench, monkeypatch: pytest.MonkeyPatch, tmp_path: Path
) -> None:
    monkeypatch.setattr(scan_folders, "START_FREE_BYTES", shutil.disk_usage(tmp_path).total)
    with refused("disk-full"):
        scanner.start("no space")
    assert not bench.laser_on


@pytest.mark.parametrize(
    ("picture", "words"),
    [
        (np.zeros((HEIGHT // 2, WIDTH), np.uint8), "pictures of 320 × 120 pixels"),
        (np.zeros((HEIGHT, WIDTH), np.float32), "grey pictures of 8 to 16 bits"),
        (np.zeros((HEIGHT, WIDTH, 3), np.uint8), "pictures of 3 × 320 × 240"),
    ],
)
def test_odd_pictures_end_the_scan_with_a_reason_and_the_station_lives(
    scanner: Scanner, bench: Bench, rig: Rig, tmp_path: Path, picture: np.ndarray, words: str
) -> None:
    scan_id = scanner.start("odd")
    until(lambda: scanner.state().points > 1000)
    bench.picture = picture
    until(lambda: scanner.state().state == "idle")
    (finding,) = [one for one in scanner.state().findings if one.quality == "bad"]
    assert words in str(finding.text)
    recording = open_recording(tmp_path / "scans" / scan_id / "scan.mcap")
    stripes = [one for one in recording.records() if isinstance(one, StripeRecord)]
    assert recording.cut == ""
    assert {(one.width_px, one.height_px) for one in stripes} == {(WIDTH, HEIGHT)}
    bench.picture = None
    assert rig.sensor.fresh
    scanner.start("again")
    until(lambda: scanner.state().points > 1000)
    assert scanner.stop() is not None


@pytest.mark.parametrize(
    ("owner", "name"),
    [
        *((ScanPipeline, "_take_some"), (ScanPipeline, "_record_next")),
        *((ScanPipeline, "_make_points"), (Recorder, "_write_frames")),
    ],
    ids=lambda one: str(one),
)
@pytest.mark.parametrize("death", [ZeroDivisionError("killed"), SystemExit("killed")])
def test_a_thread_of_a_scan_that_dies_ends_the_scan_with_a_reason(
    scanner: Scanner, monkeypatch: pytest.MonkeyPatch, owner: type, name: str, death: BaseException
) -> None:
    whole, calls = getattr(owner, name), iter(range(1_000_000))

    def die_once(*arguments: object) -> object:
        if next(calls) == 0:
            raise death
        return whole(*arguments)

    monkeypatch.setattr(owner, name, die_once)
    scanner.start("killed")
    until(lambda: scanner.state().state == "idle", 60.0)
    (finding,) = [one for one in scanner.state().findings if one.quality == "bad"]
    assert "killed" in str(finding.text)
    scanner.start("again")
    until(lambda: scanner.state().points > 0)
    assert scanner.stop() is not None


def test_a_scan_says_it_was_suspended(scanner: Scanner, monkeypatch: pytest.MonkeyPatch) -> None:
    scanner.start("interrupted")
    until(lambda: scanner.state().points > 0)
    real_s = awake_clock._since_boot_s
    monkeypatch.setattr(awake_clock, "_since_boot_s", lambda: real_s() + 30.0)
    until(lambda: any("suspended for 30 s" in str(one.text) for one in scanner.state().findings))
    result = end_scan(scanner)
    assert result.suspended_s == pytest.approx(30.0, abs=1.0)
    assert any("suspended for 30 s" in str(one.text) for one in scanner.state().findings)
    scanner.start("whole")
    until(lambda: scanner.state().points > 0)
    assert end_scan(scanner).suspended_s == 0.0


@pytest.mark.parametrize("level", [0, 255])
def test_dark_and_bright_pictures_say_so(scanner: Scanner, bench: Bench, level: int) -> None:
    scanner.start("blind")
    bench.picture = np.full((HEIGHT, WIDTH), level, np.uint8)
    until(lambda: any("No laser line" in str(one.text) for one in scanner.state().findings))
    points = scanner.state().points
    bench.picture = None
    until(lambda: scanner.state().points > points)
    assert scanner.stop() is not None
    assert not any(one.quality == "bad" for one in scanner.state().findings)
