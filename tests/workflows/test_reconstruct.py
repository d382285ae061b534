"""From a recording to a cloud."""

from collections.abc import Callable, Iterable, Iterator, Mapping, Sequence
from contextlib import contextmanager, nullcontext
from dataclasses import replace
from functools import partial
from pathlib import Path

import numpy as np
import pytest
from foxglove_schemas_protobuf.JointState_pb2 import JointState
from foxglove_schemas_protobuf.JointStates_pb2 import JointStates
from mcap.reader import make_reader
from mcap.writer import Writer
from mcap_protobuf.schema import register_schema

from crenel.errors import OperationError
from crenel.formats.clouds.files import read_cloud
from crenel.formats.recording.ordering.clock_check import ClockReport
from crenel.formats.recording.reader import EXTRACTION
from crenel.formats.recording.stripe_message import STRIPE_SCHEMA, stripe_descriptors
from crenel.formats.recording.topics import JOINTS_TOPIC
from crenel.formats.recording.writer import RecordingWriter
from crenel.messages.catalogue import renderer
from crenel.metrology.arm.kinematics import AnyArm, RobotArm, flange_pose
from crenel.metrology.arm.reported_poses import pose_from_transform
from crenel.metrology.stripe import Stripe
from crenel.metrology.time_delay.course import DelayCourse
from crenel.metrology.transforms import Floats, apply, inverse
from crenel.workflows.estimate_delay import read_plane_pass
from crenel.workflows.reconstruct import Reconstruction, reconstruct_cloud
from crenel.workflows.reconstruct_messages import Stream, clock_warnings
from tests.formats.builders import (
    ARM,
    HEIGHT,
    WIDTH,
    joints_every,
    lit_picture,
    little_calibration,
    little_stripe,
    q_at,
    stripe_points,
)
from tests.refusals import refused_as

NAMES = tuple(joint.name for joint in ARM.joints)
MS = 1_000_000


def record_stripe(
    writer: RecordingWriter, stamp_ns: int, width: int = WIDTH, sensor: str = ""
) -> None:
    writer.stripe(stamp_ns, little_stripe(), width, HEIGHT, sensor)


def record_stripes(writer: RecordingWriter, stamps_ns: Iterable[int]) -> None:
    for stamp_ns in stamps_ns:
        record_stripe(writer, stamp_ns)


def record_image(writer: RecordingWriter, stamp_ns: int) -> None:
    writer.image(stamp_ns, lit_picture(stamp_ns))


@contextmanager
def recording(
    folder: Path,
    names: Sequence[str] | None = NAMES,
    station: Mapping[str, str] | None = None,
    until_ms: int = 0,
) -> Iterator[RecordingWriter]:
    """``scan.mcap``, which begins with the joints every 4 ms, if any are wanted."""
    with RecordingWriter(folder / "scan.mcap", names, station) as writer:
        if until_ms:
            joints_every(writer, 0, until_ms * MS, 4 * MS)
        yield writer


def expected(stamps: list[int]) -> Floats:
    """By the definition of Eq. 9, one frame after the other."""
    points, _ = stripe_points()
    T_flange_sensor = little_calibration().T_flange_sensor
    return np.concatenate(
        [apply(flange_pose(ARM, q_at(stamp)) @ T_flange_sensor, points) for stamp in stamps]
    )


def rebuilt(
    folder: Path, arm: AnyArm = ARM, allow_incomplete: bool = False
) -> tuple[Reconstruction, Floats]:
    path, cloud = folder / "scan.mcap", folder / "cloud.ply"
    result = reconstruct_cloud(
        path, little_calibration(), arm, cloud, allow_incomplete=allow_incomplete
    )
    return result, read_cloud(cloud).points_mm


def rebuilt_as(
    folder: Path,
    stamps_ns: list[int],
    arm: AnyArm = ARM,
    within_mm: float = 1e-8,
    allow_incomplete: bool = False,
) -> Reconstruction:
    """Rebuilds ``scan.mcap``, which gives the points of these frames."""
    result, points = rebuilt(folder, arm, allow_incomplete)
    np.testing.assert_allclose(points, expected(stamps_ns), atol=within_mm)
    return result


def test_stripes_and_joints_become_points(tmp_path: Path) -> None:
    stamps = [int(100 * MS + i * 3.7 * MS) for i in range(150)]
    with recording(tmp_path, until_ms=400) as writer:
        record_stripes(writer, stamps)
        joints_every(writer, 404 * MS, 900 * MS, 4 * MS)
    result = rebuilt_as(tmp_path, stamps)
    assert (result.points, result.frames, result.frames_without_joints) == (150 * 25, 150, 0)
    frame = read_cloud(tmp_path / "cloud.ply").frame
    np.testing.assert_array_equal(frame, np.repeat(np.arange(150), 25))


@pytest.mark.parametrize(
    ("extraction", "words"),
    [
        ('{"smoothing_px": 3.0}', ["smoothed along the laser line by 3 px", "16 px"]),
        ('{"smoothing_px": 0}', []),
        ('{"smoothing_px": "much"}', []),
        ('{"smoothing_px": null}', []),
        ("[]", []),
        ("", []),
    ],
)
def test_the_cost_of_smoothing_is_said(tmp_path: Path, extraction: str, words: list[str]) -> None:
    with recording(tmp_path, station={EXTRACTION: extraction}, until_ms=400) as writer:
        record_stripe(writer, 100 * MS)
    warnings = [str(one) for one in rebuilt(tmp_path)[0].warnings]
    assert len(warnings) == (1 if words else 0)
    assert all(word in warnings[0] for word in words)


@pytest.mark.parametrize(("points", "sharing"), [(25, 10.6), (600, 2.7), (60_000, 1.0)])
def test_delays_count_points_of_shared_noise(tmp_path: Path, points: int, sharing: float) -> None:
    smoothed = {EXTRACTION: '{"smoothing_px": 3.0}'}
    u = np.linspace(0, WIDTH - 1, points)
    stripe = Stripe(u, np.full(points, HEIGHT / 2), np.full(points, 99.0), np.full(points, 0.05))
    with recording(tmp_path, station=smoothed, until_ms=400) as writer:
        writer.stripe(100 * MS, stripe, WIDTH, HEIGHT)
    passed, _ = read_plane_pass(tmp_path / "scan.mcap", little_calibration(), ARM)
    assert passed.number_sharing_noise == pytest.approx(sharing, abs=0.05)


def test_the_order_in_the_file_does_not_matter(tmp_path: Path) -> None:
    stamps = [100 * MS + i * 5 * MS for i in range(100)]
    with recording(tmp_path) as writer:
        record_stripes(writer, stamps)
        joints_every(writer, 0, 900 * MS, 4 * MS)
    rebuilt_as(tmp_path, stamps)


def test_pictures_are_extracted(tmp_path: Path) -> None:
    with recording(tmp_path, until_ms=400) as writer:
        for stamp in (101 * MS, 155 * MS):
            record_image(writer, stamp)
    result, points = rebuilt(tmp_path)
    assert result.frames == 2
    assert result.points > 2 * 40
    plane = little_calibration().T_flange_sensor
    back = apply(inverse(flange_pose(ARM, q_at(101 * MS)) @ plane), points[: len(points) // 2])
    assert np.abs(back[:, 2]).max() < 1e-9
    assert np.sqrt(np.mean((back[:, 1] - 1.5) ** 2)) < 0.1


def test_a_picture_beside_its_stripe_is_not_extracted_again(tmp_path: Path) -> None:
    with recording(tmp_path, until_ms=400) as writer:
        record_stripe(writer, 101 * MS)
        record_image(writer, 101 * MS)
    result, points = rebuilt(tmp_path)
    assert (result.frames, len(points)) == (1, 25)


def test_frames_without_joints_are_counted_and_named(tmp_path: Path) -> None:
    with recording(tmp_path, until_ms=100) as writer:
        joints_every(writer, 300 * MS, 400 * MS, 4 * MS)
        record_stripes(writer, (50 * MS, 150 * MS, 250 * MS, 350 * MS, 450 * MS))
    assert "3 of 5 pictures with a line (60" in (error := refusal_of(tmp_path)).line
    assert "3 of 5 frames excluded" in error.line
    result = rebuilt_as(tmp_path, [50 * MS, 350 * MS], allow_incomplete=True)
    assert (result.frames, result.frames_without_joints) == (2, 3)
    assert result.first_without_joints_s == pytest.approx(0.15)
    assert result.incomplete
    assert "(60.0" in str(result.warnings[0])


@pytest.mark.parametrize(
    ("fault", "at_ms", "refused"),
    [
        ("slip", 10, "scan-incomplete"),
        ("slip", 600, "scan-incomplete"),
        ("slip", 890, "scan-incomplete"),
        ("slip", 960, ""),
        ("silent", 890, "scan-incomplete"),
        ("silent", 960, ""),
        ("numbers", 300, "scan-incomplete"),
        ("delay", 300, ""),
        ("damage", 300, "scan-incomplete"),
        ("damage", 960, ""),
    ],
)
def test_incomplete_scans_are_refused(tmp_path: Path, fault: str, at_ms: int, refused: str) -> None:
    """Whatever the cause, if it lies at ``at_ms`` of 1,000; what remains can be had on demand."""
    bulk = np.random.default_rng(1)
    with recording(tmp_path) as writer:
        for ms in range(0, 1000, 2):
            q = q_at(ms * MS) + (np.radians(20) if fault == "slip" and ms >= at_ms else 0.0)
            if fault == "numbers" and ms >= at_ms:
                q = np.full(6, np.nan)
            if fault != "silent" or ms < at_ms:
                writer.joints(ms * MS, q)
            if 4 <= ms < 996 and not ms % 4:
                record_stripe(writer, ms * MS)
            if fault == "damage" and ms and not ms % 20:  # large, beside a stripe
                writer.image(ms * MS, bulk.integers(0, 255, (99, 999), np.uint8))
    path, cloud = tmp_path / "scan.mcap", tmp_path / "cloud.ply"
    if fault == "damage":
        content = bytearray(path.read_bytes()[:-100])  # by its index, it would pass over pictures
        at = len(content) * at_ms // 1000
        content[at : at + 4096] = bytes(4096)
        path.write_bytes(content)
    rebuild = partial(reconstruct_cloud, path, little_calibration(), ARM, cloud)
    delay = DelayCourse(at_ms * MS if fault == "delay" else 0.0)
    with refused_as(refused) if refused else nullcontext():
        rebuild(delay=delay)
    assert cloud.exists() == (not refused)
    result = rebuild(delay=delay, allow_incomplete=True)
    assert result.incomplete == bool(refused)
    assert result.points > 0


def test_a_lost_joint_reading_is_left_out(tmp_path: Path) -> None:
    with recording(tmp_path, until_ms=100) as writer:
        writer.joints(102 * MS, [np.nan] * 6)
        joints_every(writer, 104 * MS, 200 * MS, 4 * MS)
        record_stripe(writer, 102 * MS)
    result = rebuilt_as(tmp_path, [102 * MS])
    assert result.joint_samples_unusable == 1


def test_readings_that_cannot_be_true_are_left_out_and_reported(tmp_path: Path) -> None:
    """Of recordings from before they were judged as they came."""
    with recording(tmp_path, until_ms=100) as writer:
        writer.joints(102 * MS, q_at(102 * MS) + np.array([6 * np.pi, 0, 0, 0, 0, 0]))
        joints_every(writer, 104 * MS, 200 * MS, 4 * MS)
        record_stripe(writer, 102 * MS)
    result = rebuilt_as(tmp_path, [102 * MS])
    assert len(result.warnings) == 1
    assert "1 implausible arm reading excluded, 0.102 s" in str(result.warnings[0])
    assert "oint J1 reads" in str(result.warnings[0])


def test_joints_go_by_name(tmp_path: Path) -> None:
    with recording(tmp_path, NAMES[::-1]) as writer:
        for stamp in range(0, 100 * MS, 4 * MS):
            writer.joints(stamp, q_at(stamp)[::-1])
        record_stripe(writer, 50 * MS)
    rebuilt_as(tmp_path, [50 * MS])


def test_a_cut_recording_gives_the_points_before_the_cut(tmp_path: Path) -> None:
    stamps = [50 * MS + i * 4 * MS for i in range(200)]
    with RecordingWriter(tmp_path / "whole.mcap", NAMES) as writer:
        for stamp in stamps:
            joints_every(writer, stamp - 2 * MS, stamp - 2 * MS, MS)
            record_stripe(writer, stamp)
            writer.image(stamp, np.random.default_rng(stamp).integers(0, 9, (99, 999), np.uint8))
    whole = (tmp_path / "whole.mcap").read_bytes()
    (tmp_path / "scan.mcap").write_bytes(whole[: len(whole) * 2 // 3])
    result, points = rebuilt(tmp_path)
    assert "is incomplete" in str(result.cut)
    assert result.cut in result.warnings
    assert 60 < result.frames < 199
    np.testing.assert_allclose(points, expected(stamps[: result.frames]), atol=1e-8)


def refusal_of(tmp_path: Path, *serials: str) -> OperationError:
    """Rebuilds ``scan.mcap``, which is refused, and leaves no cloud; ``serials``: of the
    calibration."""
    path, calibration = tmp_path / "scan.mcap", little_calibration(*serials)
    before = sorted(path.name for path in tmp_path.iterdir())
    with pytest.raises(OperationError) as refused:
        reconstruct_cloud(path, calibration, ARM, tmp_path / "c.ply")
    assert sorted(path.name for path in tmp_path.iterdir()) == before
    return refused.value


def test_no_joints_around_any_frame_is_refused(tmp_path: Path) -> None:
    with recording(tmp_path, until_ms=100) as writer:
        record_stripe(writer, 500 * MS)
    assert "no arm readings around the time stamp of any frame" in refusal_of(tmp_path).line


def with_joints(writer: RecordingWriter) -> None:
    joints_every(writer, 0, 100 * MS, 4 * MS)


def with_joints_and_dark_picture(writer: RecordingWriter) -> None:
    with_joints(writer)
    writer.image(50 * MS, np.zeros((HEIGHT, WIDTH), np.uint8))


@pytest.mark.parametrize(
    ("record", "code"),
    [
        (lambda writer: None, "recording-foreign"),
        (with_joints, "recording-without-frames"),
        (lambda writer: record_stripe(writer, 5), "recording-without-joints"),
        (with_joints_and_dark_picture, "recording-without-stripes"),
    ],
)
def test_a_recording_that_lacks_something_is_refused(
    tmp_path: Path, record: Callable[[RecordingWriter], None], code: str
) -> None:
    with recording(tmp_path) as writer:
        record(writer)
    assert refusal_of(tmp_path).code == code


def test_pictures_of_another_size_are_refused(tmp_path: Path) -> None:
    with recording(tmp_path, until_ms=100) as writer:
        record_stripe(writer, 50 * MS, width=WIDTH + 1)
    assert "65 × 48" in refusal_of(tmp_path).line


@pytest.mark.parametrize(
    ("station", "sensor", "arm", "code"),
    [
        ({"sensor_serial": "S-2"}, "S-1", "A-1", "sensor-of-another-serial"),
        ({"arm_serial": "A-2"}, "S-1", "A-1", "arm-of-another-serial"),
        ({}, "S-1", "A-9", "arm-of-another-serial"),
    ],
)
def test_files_that_do_not_belong_together_are_refused(
    tmp_path: Path, station: dict[str, str], sensor: str, arm: str, code: str
) -> None:
    with recording(tmp_path, station=station, until_ms=100) as writer:
        record_stripe(writer, 50 * MS)
    assert refusal_of(tmp_path, sensor, arm).code == code


@pytest.mark.parametrize(
    ("names", "angles", "said"),
    [
        (NAMES[:5], [0.0] * 5, "J6"),
        (("a", "b", "c", "d", "e", "f", "grip"), [0.0] * 7, "7 joints (a, b, c, d, e, f, grip)"),
        (("J1", "J2", "J3", "J4", "J5", "wrist"), [0.0] * 6, "wrist"),
        (NAMES, np.rad2deg(q_at(0)), "degrees, but radians"),
        (NAMES, [0, 0, 0, 3.2, 0, 0], "joint J4"),
    ],
)
def test_joints_of_another_arm_or_unit_are_refused(
    tmp_path: Path, names: tuple[str, ...], angles: list[float], said: str
) -> None:
    with recording(tmp_path, names) as writer:
        writer.joints(0, angles)
        record_stripe(writer, 1)
    assert said in refusal_of(tmp_path).line


def test_holes_and_jumps_of_the_clocks_are_said(tmp_path: Path) -> None:
    with recording(tmp_path, until_ms=200) as writer:
        joints_every(writer, 260 * MS, 500 * MS, 4 * MS)
        for i in range(60):
            if not 20 <= i < 23:
                record_stripe(writer, 20 * MS + i * 8 * MS)
        joints_every(writer, 100 * MS + 1, 140 * MS, 4 * MS)  # the clock was set back
    result, _ = rebuilt(tmp_path, allow_incomplete=True)
    assert (result.frame_holes, result.clock_jumps) == (1, 1)
    assert result.frames_without_joints == 7
    said = " ".join(map(str, result.warnings))
    assert "7 of 57 frames excluded" in said
    assert "0 before the first or after the last sample, 7 in gaps" in said
    assert "about 3 frames are missing in 1 gap, the longest 32 ms, 0.172 s" in said
    assert "the clock of the arm readings jumps once, 0.100 s" in said


def test_a_steady_recording_has_no_warnings(tmp_path: Path) -> None:
    with recording(tmp_path, until_ms=500) as writer:
        for i in range(50):
            record_stripe(writer, 20 * MS + i * 8 * MS + i % 3 * MS)
    result, _ = rebuilt(tmp_path)
    assert result.warnings == ()


@pytest.mark.parametrize("beside", ["image", "other axis", "other writer"])
def test_blocks_of_all_kinds_give_the_same_points(tmp_path: Path, beside: str) -> None:
    """What is not as this program writes it goes through the general decoders."""
    stamps = [100 * MS + i * 5 * MS for i in range(12)]
    with recording(tmp_path, until_ms=400) as writer:
        for k, stamp in enumerate(stamps):
            axis = "v" if beside == "other axis" and k % 2 else "u"
            writer.stripe(stamp, replace(little_stripe(), axis=axis), WIDTH, HEIGHT)
            if beside == "image" and k == 5:
                record_image(writer, stamp)  # of a frame that has its stripe already
    if beside == "other writer":
        rewritten_unpacked(tmp_path / "scan.mcap")
    result = rebuilt_as(tmp_path, stamps)
    assert (result.frames, result.points) == (12, 12 * 25)


def rewritten_unpacked(path: Path) -> None:
    """The same recording without chunks, each number of ``u`` a field of its own."""
    with open(path, "rb") as file:
        messages = list(make_reader(file).iter_messages())
    with open(path, "wb") as file:
        writer = Writer(file, use_chunking=False)
        writer.start()
        ids: dict[str, int] = {}
        for schema, channel, message in messages:
            assert schema is not None
            if channel.topic not in ids:
                known = writer.register_schema(schema.name, schema.encoding, schema.data)
                ids[channel.topic] = writer.register_channel(
                    channel.topic, channel.message_encoding, known
                )
            data = message.data
            if channel.topic == "/sensor/stripe":
                start = data.index(b"\x22\xc8\x01")  # u: 25 doubles
                numbers = data[start + 3 : start + 203]
                single = b"".join(b"\x21" + numbers[i : i + 8] for i in range(0, 200, 8))
                data = data[:start] + single + data[start + 203 :]
            writer.add_message(ids[channel.topic], message.log_time, data, message.log_time)
        writer.finish()


def write_shuffled(path: Path, seed: int, chunk_size: int | None, log_ns: int) -> None:
    """A recording as another program may write it: the messages in any order, joints of a gripper
    between them, and the wall time at which each was logged."""
    with open(path, "rb") as file:
        messages = list(make_reader(file).iter_messages())
    with open(path, "wb") as file:
        writer = Writer(file, chunk_size=chunk_size or 1, use_chunking=chunk_size is not None)
        writer.start()
        ids: dict[str, int] = {}
        for _, channel, _ in messages:
            if channel.topic not in ids:
                kind = JointStates if channel.topic == JOINTS_TOPIC else None
                known = (
                    register_schema(writer, kind)
                    if kind
                    else writer.register_schema(STRIPE_SCHEMA, "protobuf", stripe_descriptors())
                )
                ids[channel.topic] = writer.register_channel(channel.topic, "protobuf", known)
        for i in np.random.default_rng(seed).permutation(len(messages)).tolist():
            _, channel, message = messages[i]
            logged_ns = message.log_time + log_ns
            writer.add_message(ids[channel.topic], logged_ns, message.data, logged_ns)
            if channel.topic == JOINTS_TOPIC and i % 3 == 0:
                grip = JointStates(joints=[JointState(name="grip", position=0.1)])
                data = grip.SerializeToString()
                writer.add_message(ids[channel.topic], logged_ns, data, logged_ns)
        writer.finish()


@pytest.mark.parametrize("seed", range(2))
@pytest.mark.parametrize("chunk_size", [None, 900, 1 << 20])
def test_messages_in_any_order_become_the_same_points(
    tmp_path: Path, seed: int, chunk_size: int | None
) -> None:
    stamps = [int(100 * MS + i * 37 * MS) for i in range(40)]
    names = ("grip", *NAMES[::-1], "tool")
    with recording(tmp_path, names) as writer:
        for stamp in range(0, 1700 * MS, 4 * MS):
            writer.joints(stamp, [0.2, *q_at(stamp)[::-1], 0.3])
        record_stripes(writer, stamps)
    write_shuffled(tmp_path / "scan.mcap", seed, chunk_size, 1_700_000_000 * 1000 * MS)
    result, points = rebuilt(tmp_path)
    assert (result.frames, result.clock_jumps, result.joint_holes) == (40, 0, 0)
    assert [str(one) for one in result.warnings] == [
        "joints that arm.json does not have are left out: grip, tool"
    ]
    found, right = (rows[np.lexsort(rows.round(6).T)] for rows in (points, expected(stamps)))
    np.testing.assert_allclose(found, right, atol=1e-8)


ROBOT = RobotArm("robot", "A-1")


def poses_every(writer: RecordingWriter, first_ns: int, last_ns: int, step_ns: int) -> None:
    for stamp_ns in range(first_ns, last_ns + 1, step_ns):
        writer.reading(stamp_ns, pose_from_transform(flange_pose(ARM, q_at(stamp_ns))))


def test_poses_become_the_same_points_as_joints(tmp_path: Path) -> None:
    stamps = [int(100 * MS + i * 3.7 * MS) for i in range(50)]
    with recording(tmp_path, None) as writer:
        poses_every(writer, 0, 400 * MS, 4 * MS)
        record_stripes(writer, stamps)
    # between its poses, the flange moves along an arc of the joints
    result = rebuilt_as(tmp_path, stamps, ROBOT, 3e-4)
    assert (result.frames, result.frames_without_joints, result.joint_samples) == (50, 0, 101)


def test_a_pose_that_cannot_be_is_left_out_and_reported(tmp_path: Path) -> None:
    with recording(tmp_path, None) as writer:
        poses_every(writer, 0, 100 * MS, 4 * MS)
        writer.reading(102 * MS, [9000.0, 0, 0, 0, 0, 0, 1])
        writer.reading(103 * MS, [np.nan] * 7)
        poses_every(writer, 104 * MS, 200 * MS, 4 * MS)
        record_stripe(writer, 102 * MS)
    result = rebuilt_as(tmp_path, [102 * MS], ROBOT, 3e-4)
    assert result.joint_samples_unusable == 1
    assert any("0.102 s" in str(one) for one in result.warnings)


@pytest.mark.parametrize(
    ("names", "arm", "code"),
    [(None, ARM, "recording-of-poses"), (NAMES, ROBOT, "recording-of-joints")],
)
def test_a_recording_of_another_kind_of_arm_is_refused(
    tmp_path: Path, names: tuple[str, ...] | None, arm: AnyArm, code: str
) -> None:
    with recording(tmp_path, names) as writer:
        (poses_every if names is None else joints_every)(writer, 0, 400 * MS, 4 * MS)
        record_stripe(writer, 102 * MS)
    with refused_as(code):
        rebuilt(tmp_path, arm)


@pytest.mark.parametrize(
    ("stream", "missing", "english", "german"),
    [
        ("joints", 1, "about one arm reading is missing in 1", "es fehlt etwa ein Messwert des"),
        ("joints", 4, "about 4 arm readings are missing in 1", "es fehlen etwa 4 Messwerte des"),
        ("frames", 1, "about one frame is missing in 1", "es fehlt etwa ein Bild an 1"),
        ("frames", 4, "about 4 frames are missing in 1", "es fehlen etwa 4 Bilder an 1"),
    ],
)
def test_what_is_missing_is_said(stream: Stream, missing: int, english: str, german: str) -> None:
    (said,) = clock_warnings(stream, ClockReport(1, missing, 7 * MS, 9 * MS, 0, 0), 0)
    assert english in renderer("en")(said)
    assert german in renderer("de")(said)
