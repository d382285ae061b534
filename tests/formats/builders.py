"""Small sessions, recordings and calibrations that the tests make and then spoil."""

import json
from collections.abc import Callable
from pathlib import Path
from typing import Any

import cv2
import numpy as np

from crenel.formats.images import GreyImage
from crenel.formats.recording.writer import RecordingWriter
from crenel.formats.results.calibration import Calibration, SerialNumbers
from crenel.metrology.arm.kinematics import Arm, Joint, Tip
from crenel.metrology.arm.link_error import LinkError
from crenel.metrology.sensor.camera import Camera, project
from crenel.metrology.sensor.laser_plane import LaserPlane
from crenel.metrology.stripe import Stripe
from crenel.metrology.targets.crenellated_block import Crenellated
from crenel.metrology.transforms import Floats

WIDTH, HEIGHT = 64, 48

ARM = Arm(
    name="little arm",
    serial_number="A-1",
    joints=tuple(
        Joint(
            name=f"J{i + 1}",
            a_mm=30.0 * (-1) ** i,
            alpha_rad=np.pi / 2 * (-1) ** i if i < 5 else 0.0,
            d_mm=d_mm,
            theta_rad=0.1 * i,
            sign=-1 if i == 2 else 1,
            limits_rad=(-3.0, 3.0),
            encoder_sd_rad=1e-5,
            error=LinkError(0.01, -0.02, 0.03, 1e-4, -2e-4, 3e-4) if i == 3 else LinkError(),
        )
        for i, d_mm in enumerate((300.0, 0.0, 500.0, 0.0, 450.0, 80.0))
    ),
    tip=Tip(0.0, -12.0, 165.0, 6.0),
)
BLOCK = Crenellated(
    name="little block",
    serial_number="B-1",
    edges_x_mm=(-22.0, -14.0, -7.0, -2.0, 5.0, 10.0),
    front_y_mm=-12.0,
    back_y_mm=12.0,
    crest_z_mm=15.0,
    floor_z_mm=0.0,
    base_z_mm=-12.0,
    standard_uncertainty_mm=0.002,
)
SENSOR = {
    "format": "crenel/sensor",
    "version": 1,
    "name": "little sensor",
    "serial_number": "S-1",
    "width_px": WIDTH,
    "height_px": HEIGHT,
    "stripe_axis": "u",
}
POSE_DEG = (-51.5, 26.25, -84.5, 129.0, 26.0, -79.75)


def write_session(folder: Path) -> Path:
    """A well-formed session of three contacts and one pose, with black pictures."""
    from tests.datasheets import write_arm, write_object

    (folder / "images").mkdir(parents=True)
    write_arm(folder / "arm.json", ARM)
    write_object(folder / "object.json", BLOCK)
    (folder / "sensor.json").write_text(json.dumps(SENSOR))
    header = ",".join(f"q{i + 1}_deg" for i in range(6))
    pose = ",".join(str(angle) for angle in POSE_DEG)
    (folder / "probing.csv").write_text(
        f"feature,{header}\n" + "".join(f"{face},{pose}\n" for face in ("crest", "front", "left"))
    )
    (folder / "images.csv").write_text(
        f"pose,file,lighting,{header}\n0,images/a.png,ambient,{pose}\n0,images/l.png,laser,{pose}\n"
    )
    for name in ("a", "l"):
        cv2.imwrite(str(folder / f"images/{name}.png"), np.zeros((HEIGHT, WIDTH), np.uint8))
    return folder


def edit_json(path: Path, change: Callable[[dict[str, Any]], object]) -> None:
    fields = json.loads(path.read_text())
    change(fields)
    path.write_text(json.dumps(fields))


def edit_text(path: Path, old: str, new: str) -> None:
    text = path.read_text()
    assert old in text
    path.write_text(text.replace(old, new, 1))


def little_calibration(sensor_serial: str = "S-1", arm_serial: str = "A-1") -> Calibration:
    """A pinhole camera 100 mm in front of the laser plane z = 0 of the sensor frame."""
    tilt = np.deg2rad(30)
    rotation = np.array(
        [[1, 0, 0], [0, np.cos(tilt), -np.sin(tilt)], [0, np.sin(tilt), np.cos(tilt)]]
    )
    return Calibration(
        camera=Camera(
            matrix=np.array([[200.0, 0, WIDTH / 2], [0, 200.0, HEIGHT / 2], [0, 0, 1]]),
            rotation=rotation,
            translation_mm=np.array([0.0, 0.0, 100.0]),
            width_px=WIDTH,
            height_px=HEIGHT,
        ),
        plane=LaserPlane(np.array([0.0, 0.0, 1.0]), 0.0),
        T_flange_sensor=np.array([[0, 0, 1, 10], [1, 0, 0, 20], [0, 1, 0, 30], [0, 0, 0, 1.0]]),
        stripe_axis="u",
        serial_numbers=SerialNumbers(arm=arm_serial, sensor=sensor_serial),
    )


def stripe_points() -> tuple[Floats, Floats]:
    """Points (N, 3) on the laser plane along x, and the pixels (N, 2) where they are seen."""
    points = np.column_stack([np.linspace(-12, 12, 25), np.full(25, 1.5), np.zeros(25)])
    return points, project(little_calibration().camera, points)


def little_stripe() -> Stripe:
    """What is extracted of ``stripe_points``."""
    _, uv = stripe_points()
    return Stripe(uv[:, 0], uv[:, 1], np.full(len(uv), 99.0), np.full(len(uv), 0.05))


def lit_picture(seed: int) -> GreyImage:
    """The stripe of ``stripe_points``, with noise."""
    _, uv = stripe_points()
    v = np.interp(np.arange(WIDTH), uv[:, 0], uv[:, 1])
    rows = np.arange(HEIGHT)[:, None]
    grey = 8 + 200 * np.exp(-((rows - v) ** 2) / (2 * 1.5**2))
    noise = np.random.default_rng(seed).normal(0, 1, grey.shape)
    return np.asarray(np.clip(np.rint(grey + noise), 0, 255), np.uint8)


def q_at(stamp_ns: int) -> Floats:
    """The angles while all joints move evenly."""
    return np.asarray(np.deg2rad(POSE_DEG) + 1e-10 * stamp_ns * np.arange(1, 7))


def joints_every(writer: RecordingWriter, first_ns: int, last_ns: int, step_ns: int) -> None:
    for stamp_ns in range(first_ns, last_ns + 1, step_ns):
        writer.joints(stamp_ns, q_at(stamp_ns))
