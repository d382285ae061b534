"""Recordings of several sensors: each frame by its own sensor's calibration."""

import json
from dataclasses import replace
from pathlib import Path

import numpy as np
import pytest
import typer

from crenel.cli.scan import paths_by_sensor
from crenel.errors import OperationError
from crenel.formats.clouds.files import read_cloud
from crenel.formats.recording.decoders import ImageRecord, StripeRecord
from crenel.formats.recording.reader import open_recording
from crenel.formats.recording.topics import sensor_key
from crenel.formats.recording.writer import RecordingWriter
from crenel.formats.results.calibration import Calibration, SerialNumbers
from crenel.metrology.arm.kinematics import flange_pose
from crenel.metrology.transforms import Floats, apply, rigid, rotation_from_vector
from crenel.workflows.estimate_delay import read_plane_pass
from crenel.workflows.reconstruct import reconstruct_cloud
from crenel.workflows.sensor_calibrations import SensorCalibrations
from tests.formats.builders import (
    ARM,
    HEIGHT,
    WIDTH,
    joints_every,
    little_calibration,
    q_at,
    stripe_points,
)
from tests.refusals import refused_as
from tests.workflows.test_reconstruct import MS, NAMES, record_stripe

DELAYS_MS = {"left": 0, "right": 5}
ORDER = ("left", "right", "right", "left") * 25
"""Whose frames follow one another."""


def calibration(name: str) -> Calibration:
    """Two sensors that sit at different places of the flange."""
    first = little_calibration()
    turned = rigid(rotation_from_vector(np.array([0.0, 0.0, 0.6])), np.array([30.0, -5.0, 8.0]))
    T = first.T_flange_sensor if name == "left" else first.T_flange_sensor @ turned
    serials = SerialNumbers(arm="", sensor=f"S-{name}", object="")
    return replace(first, T_flange_sensor=T, serial_numbers=serials)


CALIBRATIONS = {name: calibration(name) for name in ("left", "right")}
EXCHANGED = (CALIBRATIONS["right"], CALIBRATIONS["left"])


def stamps_ns() -> list[int]:
    """In pairs at the same moment, as two cameras may expose."""
    return [100 * MS + (i // 2) * 7 * MS for i in range(len(ORDER))]


@pytest.fixture
def recording(tmp_path: Path) -> Path:
    path = tmp_path / "scan.mcap"
    station = {sensor_key("sensor_serial", name): f"S-{name}" for name in CALIBRATIONS}
    station |= {sensor_key("arm_delay_ns", key): str(ms * MS) for key, ms in DELAYS_MS.items()}
    with RecordingWriter(path, NAMES, station, ("left", "right")) as writer:
        joints_every(writer, 0, 300 * MS, 4 * MS)
        for stamp_ns, name in zip(stamps_ns(), ORDER, strict=True):
            record_stripe(writer, stamp_ns, sensor=name)
        writer.image(stamps_ns()[0], np.zeros((HEIGHT, WIDTH), np.uint8), "left")
        joints_every(writer, 304 * MS, 900 * MS, 4 * MS)
    return path


def expected(names: tuple[str, ...] = ("left", "right")) -> Floats:
    """By the definition of Eq. 9, one frame after the other."""
    points, _ = stripe_points()
    found = []
    for stamp_ns, name in zip(stamps_ns(), ORDER, strict=True):
        if name in names:
            T_arm_flange = flange_pose(ARM, q_at(stamp_ns + DELAYS_MS[name] * MS))
            found.append(apply(T_arm_flange @ CALIBRATIONS[name].T_flange_sensor, points))
    return np.concatenate(found)


def test_each_frame_is_rebuilt_by_its_sensors_calibration(recording: Path, tmp_path: Path) -> None:
    result = reconstruct_cloud(recording, CALIBRATIONS, ARM, tmp_path / "cloud.ply")
    cloud = read_cloud(tmp_path / "cloud.ply")
    assert (result.frames, result.clock_jumps, result.warnings) == (len(ORDER), 0, ())
    np.testing.assert_allclose(cloud.points_mm, expected(), atol=2e-3)


def test_the_recording_says_whose_each_stripe_is(recording: Path) -> None:
    opened = open_recording(recording)
    records = list(opened.records())
    assert tuple(one.sensor for one in records if isinstance(one, StripeRecord)) == ORDER
    assert [one.sensor for one in records if isinstance(one, ImageRecord)] == ["left"]
    assert opened.sensors == ("left", "right")
    assert (opened.serial_of("right"), opened.delay_of("right").delay_ns) == ("S-right", 5 * MS)
    topics = {"/sensor/left/stripe", "/sensor/right/stripe", "/sensor/left/image", "/arm/joints"}
    assert topics <= opened.topics


def test_one_sensor_alone_is_rebuilt_and_the_other_named(recording: Path, tmp_path: Path) -> None:
    only = {"right": CALIBRATIONS["right"]}
    result = reconstruct_cloud(recording, only, ARM, tmp_path / "cloud.ply")
    np.testing.assert_allclose(
        read_cloud(tmp_path / "cloud.ply").points_mm, expected(("right",)), atol=2e-3
    )
    (warning,) = map(str, result.warnings)
    assert warning.startswith("50 frames of the sensor left left out")


@pytest.mark.parametrize(
    ("given", "code", "words"),
    [
        (CALIBRATIONS["left"], "recording-of-several-sensors", "left, right"),
        ({**CALIBRATIONS, "top": calibration("left")}, "sensor-not-recorded", "top"),
        (dict(zip(CALIBRATIONS, EXCHANGED, strict=True)), "sensor-of-another-serial", "S-left"),
    ],
    ids=["without names", "unknown name", "exchanged"],
)
def test_calibrations_that_do_not_fit_the_recording_are_refused(
    recording: Path, tmp_path: Path, given: SensorCalibrations, code: str, words: str
) -> None:
    with refused_as(code, words):
        reconstruct_cloud(recording, given, ARM, tmp_path / "cloud.ply")
    assert not (tmp_path / "cloud.ply").exists()


def test_a_name_for_the_only_sensor_of_a_recording_is_refused(tmp_path: Path) -> None:
    path = tmp_path / "scan.mcap"
    with RecordingWriter(path, NAMES) as writer:
        joints_every(writer, 0, 300 * MS, 4 * MS)
        record_stripe(writer, 100 * MS)
    with pytest.raises(OperationError, match="one sensor"):
        reconstruct_cloud(path, CALIBRATIONS, ARM, tmp_path / "cloud.ply")


def test_a_pass_is_read_of_the_named_sensor(recording: Path) -> None:
    passed, _ = read_plane_pass(recording, CALIBRATIONS["right"], ARM, sensor="right")
    assert len(passed.stamps_ns) == ORDER.count("right")


def test_files_are_named_by_their_sensors(tmp_path: Path) -> None:
    assert paths_by_sensor(["a.json"]) == {"": Path("a.json")}
    named = paths_by_sensor(["left=a.json", "right=b=c.json"])
    assert named == {"left": Path("a.json"), "right": Path("b=c.json")}
    odd = tmp_path / "left=a.json"
    odd.write_text(json.dumps({}))
    assert paths_by_sensor([str(odd)]) == {"": odd}
    for given in (["a.json", "b.json"], ["left=a.json", "b.json"], ["left=a", "left=b"]):
        with pytest.raises(typer.BadParameter):
            paths_by_sensor(given)
