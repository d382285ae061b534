"""A recording shown again on the live display."""

import threading
import time
from collections.abc import Sequence
from contextlib import closing
from pathlib import Path

import numpy as np
import pytest

from crenel.errors import OperationError
from crenel.formats.clouds.cuts import Cut, cut_mask, write_cuts
from crenel.formats.clouds.points import Points, positions_of
from crenel.formats.recording.writer import RecordingWriter
from crenel.formats.results.calibration import Uncertainty
from crenel.metrology.transforms import Floats
from crenel.operations.calibration_in_use import scan_calibration
from crenel.server.live_replay import Replay
from crenel.server.replayed_calibration import put_in_use
from crenel.station.bus import Bus
from crenel.station.view3d.scene import Scene
from crenel.store.store import Store
from crenel.wire.schema import ReplayState
from crenel_hardware.clock import now_ns
from crenel_hardware.interfaces import Frame, JointSample
from crenel_hardware.replay import ReplayArm
from tests.cli.test_cli import ROOT, process
from tests.datasheets import write_arm
from tests.entering import client
from tests.formats.builders import ARM, HEIGHT, WIDTH, joints_every, little_calibration, q_at
from tests.formats.test_documents import calibration_file
from tests.station.conftest import until
from tests.workflows.test_reconstruct import MS, NAMES, expected, record_image, record_stripe

pytestmark = pytest.mark.device

STAMPS = [100 * MS + i * 10 * MS for i in range(60)]


class Shown:
    def __init__(self) -> None:
        self.points: list[np.ndarray] = []
        self.began_ns = now_ns()
        self.came_ns: list[int] = []

    @property
    def points_shown(self) -> int:
        return sum(len(piece) for piece in self.points)

    def begin(self, cuts: Sequence[Cut]) -> None:
        assert not cuts

    def set_arm_model(self, arm: object) -> None: ...

    def set_sensor(self, *of: object) -> None: ...

    def add_points(self, points: Points) -> None:
        self.points.append(positions_of(points))
        self.came_ns.append(now_ns())


def scan(path: Path, images: bool = False) -> Path:
    with RecordingWriter(path, NAMES) as writer:
        joints_every(writer, 0, 800 * MS, 4 * MS)
        for stamp in STAMPS:
            if images:
                record_image(writer, stamp)
            else:
                record_stripe(writer, stamp)
    return path


class RecordingBus(Bus):
    def __init__(self) -> None:
        super().__init__()
        self.reported: list[ReplayState] = []

    def publish(self, topic: str, value: object) -> None:
        assert topic == "replay"
        assert isinstance(value, ReplayState)
        self.reported.append(value)


def shown(path: Path, speed: float, bus: Bus | None = None) -> tuple[Shown, float]:
    replay, scene = Replay(path, little_calibration(), ARM, speed), Shown()
    began_s = time.monotonic()
    replay.start(scene, bus or Bus())  # type: ignore[arg-type]
    assert replay._thread is not None
    replay._thread.join(300.0)
    assert not replay._thread.is_alive()
    return scene, time.monotonic() - began_s


def test_every_point_is_shown_where_it_was_and_when_it_is_due(tmp_path: Path) -> None:
    scene, seconds = shown(scan(tmp_path / "scan.mcap"), 1.0)
    np.testing.assert_allclose(np.concatenate(scene.points), expected(STAMPS), atol=1e-8)
    assert seconds > 0.65
    assert len(scene.points) >= 10
    assert scene.came_ns[len(scene.came_ns) // 2] - scene.began_ns > 0.3e9


def test_as_fast_as_it_can_be_read(tmp_path: Path) -> None:
    scene, _ = shown(scan(tmp_path / "scan.mcap"), 0.0)
    assert sum(len(piece) for piece in scene.points) == 60 * 25
    assert len(scene.points) == 1


def test_what_was_cut_away_of_the_scan_is_not_replayed(tmp_path: Path) -> None:
    path, places = scan(tmp_path / "scan.mcap"), expected(STAMPS)
    cut = Cut(((1.0, 0.0, 0.0, -float(np.median(places[:, 0]))),), False, 1)
    write_cuts(tmp_path, [cut])
    with closing(Scene()) as scene:
        replay = Replay(path, little_calibration(), ARM, 0.0)
        replay.start(scene, Bus())
        until(lambda: scene.content.points_cut > 0)
        replay.stop()
        left = scene.visible_points("")[0]
        assert 0 < len(left) < len(places)
        assert not cut_mask([cut], left).any()
        scene.cut_scan("", [])
        assert scene.points_shown > len(left)
    (tmp_path / "cuts.json").write_text("{")
    with pytest.raises(OperationError, match=r"cuts\.json"):
        Replay(path, little_calibration(), ARM, 0.0)


def test_progress_is_published_during_the_replay(tmp_path: Path) -> None:
    bus = RecordingBus()
    shown(scan(tmp_path / "scan.mcap"), 0.5, bus)
    first, *_, last = bus.reported
    assert (first.recording, first.speed, first.state) == ("scan.mcap", 0.5, "playing")
    assert (first.played_s, first.points) == (0.0, 0)
    assert first.length_s == pytest.approx(0.8)
    assert len(bus.reported) > 2
    assert [one.points for one in bus.reported] == sorted(one.points for one in bus.reported)
    assert (last.state, last.points, last.text) == ("ended", 60 * 25, "")
    assert last.points_shown == last.points
    assert last.played_s == pytest.approx(0.69)


def test_a_cut_recording_has_no_length_and_is_reported_as_cut(tmp_path: Path) -> None:
    path, bus = tmp_path / "scan.mcap", RecordingBus()
    with RecordingWriter(path, NAMES) as writer:
        joints_every(writer, 0, 400 * MS, 4 * MS)
        for stamp in STAMPS[:20]:
            record_stripe(writer, stamp)
        writer.flush()
        whole = writer.bytes_written
        joints_every(writer, 404 * MS, 800 * MS, 4 * MS)
    path.write_bytes(path.read_bytes()[: whole + 99])
    shown(path, 0.0, bus)
    assert bus.reported[0].length_s is None
    assert bus.reported[-1].state == "ended"
    assert "is incomplete" in str(bus.reported[-1].text)


def test_a_replay_that_fails_says_why(tmp_path: Path) -> None:
    with RecordingWriter(tmp_path / "scan.mcap", NAMES) as writer:
        joints_every(writer, 0, 800 * MS, 4 * MS)
    bus = RecordingBus()
    shown(tmp_path / "scan.mcap", 0.0, bus)
    assert bus.reported[-1].state == "failed"
    assert "no frames" in str(bus.reported[-1].text)


def test_arm_and_pictures_come_again_by_the_same_clock(tmp_path: Path) -> None:
    replay = Replay(scan(tmp_path / "scan.mcap", images=True), little_calibration(), ARM, 4.0)
    arm, sensor = replay.arm(), replay.sensor()
    info = arm.open()
    assert info.serial_number == "A-1"
    assert info.rate_hz == pytest.approx(250)
    assert sensor.open().width_px == WIDTH
    samples: list[JointSample] = []
    frames: list[Frame] = []
    while len(samples) < 201 or len(frames) <= 60:
        samples += [one for one in arm.read(0.01) if isinstance(one, JointSample)]
        while (frame := sensor.read(0.0)) is not None:
            frames.append(frame)
    frames, rest = frames[:60], frames[60:]
    assert [np.array_equal(frame.image, frames[-1].image) for frame in rest] == [True] * len(rest)
    assert frames[0].image.shape == (HEIGHT, WIDTH)
    steps = np.diff([frame.mid_exposure_ns for frame in frames])
    np.testing.assert_allclose(steps, 2.5 * MS, atol=2)
    moving = samples[:201]
    np.testing.assert_allclose(moving[100].joints_rad, q_at(400 * MS), atol=1e-12)
    assert moving[200].stamp_ns - moving[0].stamp_ns == pytest.approx(200 * MS, abs=2)
    assert not any(isinstance(one, JointSample) for one in arm.read(0.01))
    assert len(samples) == 201
    assert arm.is_alive()  # silent at its last: repeated, it would be that of a frozen encoder
    arm.close()
    sensor.close()
    assert arm.read(1.0) == []


def test_as_fast_as_possible_arm_and_pictures_come_to_the_last(tmp_path: Path) -> None:
    replay = Replay(scan(tmp_path / "scan.mcap", images=True), little_calibration(), ARM, 0.0)
    arm, sensor = replay.arm(), replay.sensor()
    arm.open()
    sensor.open()
    samples = [one for _ in range(4) for one in arm.read(0.01) if isinstance(one, JointSample)]
    assert [one.joints_rad for one in samples] == [tuple(q_at(800 * MS))]
    frames = [frame for _ in range(60) if (frame := sensor.read(0.5)) is not None]
    assert len({frame.image.tobytes() for frame in frames}) == 60
    assert all(frame.image.max() > 100 for frame in frames)


def read_until(arm: ReplayArm, last_rad: Floats) -> list[tuple[float, ...]]:
    readings: list[tuple[float, ...]] = []
    while not readings or readings[-1] != tuple(last_rad):
        readings += [one.joints_rad for one in arm.read(0.01) if isinstance(one, JointSample)]
        assert arm.is_alive()
    return readings


def test_as_fast_as_possible_the_arm_does_not_leap(tmp_path: Path) -> None:
    """It would be taken for one whose frame was changed."""
    path = tmp_path / "scan.mcap"
    with RecordingWriter(path, NAMES) as writer:
        joints_every(writer, 0, 1600 * MS, MS)
        record_stripe(writer, 5)
    arm = Replay(path, little_calibration(), ARM, 0.0).arm()
    assert not arm.open().free_running
    assert read_until(arm, q_at(1600 * MS)) == [tuple(q_at(1600 * MS))]
    assert arm.read(0.01) == []
    arm.close()
    assert not arm.is_alive()


def test_an_arm_is_silent_between_readings_that_are_far_apart(tmp_path: Path) -> None:
    with RecordingWriter(tmp_path / "scan.mcap", NAMES) as writer:
        for second in range(3):
            writer.joints(second * 1000 * MS, q_at(second * MS))
            record_stripe(writer, second * 1000 * MS)
    arm = Replay(tmp_path / "scan.mcap", little_calibration(), ARM, 1.0).arm()
    assert not arm.open().free_running
    assert read_until(arm, q_at(MS)) == [tuple(q_at(0)), tuple(q_at(MS))]


def test_what_cannot_be_replayed_is_refused(tmp_path: Path) -> None:
    with RecordingWriter(tmp_path / "scan.mcap", NAMES) as writer:
        record_stripe(writer, 5)
    with pytest.raises(OperationError, match="no arm readings"):
        Replay(tmp_path / "scan.mcap", little_calibration(), ARM, 1.0)


CREATED = "2026-03-04T05:06:07+00:00"


def calibration_of_a_session(path: Path) -> None:
    """With all that a session's calibration states and one of other origin does not."""
    uncertainty = Uncertainty(total_um=21.0, budget=(), depth_range_mm=(60.0, 140.0))
    stated = {"uncertainty": uncertainty, "created_at": CREATED}
    calibration_file().model_copy(update=stated).write(path)


def test_the_calibration_is_in_use(tmp_path: Path) -> None:
    calibration_of_a_session(tmp_path / "mine.json")
    write_arm(tmp_path / "arm.json", ARM)
    (tmp_path / "data").mkdir()
    put_in_use(tmp_path / "data", tmp_path / "mine.json", tmp_path / "arm.json")
    store = Store(tmp_path / "data")
    try:
        record = store.calibrations.active()
        assert record is not None
        assert (record.name, record.accepted_at) == ("mine.json", CREATED)
        assert (record.figures.total_um, record.figures.verdict) == (21.0, "neutral")
        assert record.figures.sensor_serial == "S-1"
        assert scan_calibration(record).depth_range_mm == (60.0, 140.0)
        # the page to calibrate does not go on with it
        assert store.journal.latest_session("calibration") is None
    finally:
        store.close()


def test_a_calibration_without_uncertainty_is_only_shown(tmp_path: Path) -> None:
    calibration_file().write(tmp_path / "mine.json")
    write_arm(tmp_path / "arm.json", ARM)
    put_in_use(tmp_path, tmp_path / "mine.json", tmp_path / "arm.json")
    assert not (tmp_path / "sessions").exists()


def test_the_command_serves_the_display(tmp_path: Path) -> None:
    calibration_of_a_session(tmp_path / "calibration.json")
    write_arm(tmp_path / "arm.json", ARM)
    scan(tmp_path / "scan.mcap")
    options = ("--no-open", "--port", "0")
    with process("replay", tmp_path / "scan.mcap", *options, cwd=ROOT) as replay:
        killer = threading.Timer(300, replay.kill)
        killer.start()
        assert replay.stdout is not None
        address = replay.stdout.readline().split()[3]
        assert replay.stdout.readline().startswith("Ready")
        with client(address) as http:
            home = http.get("/api/home").json()
            assert home["station"]["name"] == "scan.mcap"
            assert home["calibration"]["name"] == "calibration.json"
            assert home["calibration"]["total_um"] == 21.0
        replay.terminate()
        replay.wait()
        killer.cancel()
    assert replay.returncode in (0, 143, -15)
