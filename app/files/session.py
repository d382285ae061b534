"""A calibration session: a folder with the contacts and the pictures (FORMATS.md)."""

from collections.abc import Sequence
from dataclasses import dataclass
from pathlib import Path, PurePosixPath

import numpy as np

from app.files.arm import read_arm
from app.files.atomic import write_atomically
from app.files.images import grey_png_size
from app.files.joint_angles import JointAngles, joint_columns
from app.files.objects import read_object
from app.files.sensor import SensorSheet, read_sensor
from app.files.tables import Row, read_table, table_text
from app.metrology.arm import Arm
from app.metrology.crenellated import FACES, Crenellated
from app.metrology.frames import Floats
from app.metrology.refusal import Refusal

ARM, OBJECT, SENSOR = "arm.json", "object.json", "sensor.json"
PROBING, IMAGES, PICTURES = "probing.csv", "images.csv", "images"
LIGHTINGS = ("ambient", "laser", "both")
STILL_DEG = 0.005
"""An arm held still may read this much differently from picture to picture, plus its noise."""


@dataclass(frozen=True)
class Contacts:
    """The contact points, in the order of the file."""

    features: tuple[str, ...]
    q_rad: Floats
    """(N, n) encoder angles."""


@dataclass(frozen=True)
class Pose:
    """The pictures taken with the arm held still."""

    number: int
    q_rad: Floats
    """(n,) encoder angles."""
    ambient: Path
    """With the laser off; or the picture with both lights, where ``laser`` is None."""
    laser: Path | None

    @property
    def files(self) -> tuple[Path, ...]:
        return (self.ambient,) if self.laser is None else (self.ambient, self.laser)


@dataclass(frozen=True)
class Session:
    """A session as read; the pictures stay on disk, for ``images.read_grey``."""

    folder: Path
    arm: Arm
    block: Crenellated
    sensor: SensorSheet
    contacts: Contacts
    poses: tuple[Pose, ...]
    """By ascending number."""

    @property
    def tables(self) -> tuple[Path, ...]:
        """Its files, the pictures apart."""
        return tuple(self.folder / name for name in (ARM, OBJECT, SENSOR, PROBING, IMAGES))

    @property
    def files(self) -> tuple[Path, ...]:
        """Everything that it was read from."""
        return (*self.tables, *(file for pose in self.poses for file in pose.files))


@dataclass(frozen=True)
class ImageRow:
    """One row of ``images.csv``."""

    pose: int
    file: str
    """Relative to the session's folder, with forward slashes."""
    lighting: str
    q_rad: Floats


def read_session(folder: Path) -> Session:
    """Reads and checks a session; raises ``Refusal`` naming file, line, value and remedy."""
    if not folder.is_dir():
        there = "it is a file" if folder.exists() else "there is no such folder"
        raise Refusal("session-missing", str(folder), there, "Name a session's folder")
    arm = read_arm(folder / ARM)
    sensor = read_sensor(folder / SENSOR)
    return Session(
        folder=folder,
        arm=arm,
        block=read_object(folder / OBJECT),
        sensor=sensor,
        contacts=read_contacts(folder / PROBING, arm),
        poses=read_poses(folder / IMAGES, arm, sensor),
    )


def read_contacts(path: Path, arm: Arm) -> Contacts:
    """Reads ``probing.csv``; raises ``Refusal`` naming line and value."""
    table = read_table(path, ("feature",))
    angles = JointAngles(table, arm)
    features: list[str] = []
    q_rad: list[Floats] = []
    for row in table.rows:
        feature = row.text("feature")
        if feature not in FACES:
            raise Refusal(
                "feature-unknown",
                f"{row.place}: feature {feature!r}",
                f"the faces are {', '.join(FACES)}",
                "Correct the name",
            )
        features.append(feature)
        q_rad.append(angles.of(row))
    if not features:
        raise Refusal("no-contacts", f"{path} holds no contact points", "", "Probe the object")
    angles.refuse_radians(q_rad)
    return Contacts(tuple(features), np.array(q_rad))


def read_poses(path: Path, arm: Arm, sensor: SensorSheet) -> tuple[Pose, ...]:
    """Reads ``images.csv`` and the headers of its pictures; raises ``Refusal``."""
    table = read_table(path, ("pose", "file", "lighting"))
    angles = JointAngles(table, arm)
    by_pose: dict[int, list[tuple[Row, ImageRow]]] = {}
    for row in table.rows:
        image = ImageRow(row.count("pose"), row.text("file"), _lighting_of(row), angles.of(row))
        _check_picture(row, path.parent / image.file, sensor)
        by_pose.setdefault(image.pose, []).append((row, image))
    if not by_pose:
        raise Refusal("no-images", f"{path} holds no pictures", "", "Take a picture of the object")
    angles.refuse_radians([image.q_rad for rows in by_pose.values() for _, image in rows])
    return tuple(_pose_of(path.parent, arm, by_pose[number]) for number in sorted(by_pose))


def write_contacts(path: Path, contacts: Contacts) -> None:
    """Writes ``probing.csv`` atomically; reads back to the same angles within 1e-15."""
    count = contacts.q_rad.shape[1]
    rows = (
        (feature, *np.rad2deg(q).tolist())
        for feature, q in zip(contacts.features, contacts.q_rad, strict=True)
    )
    text = table_text(("feature", *joint_columns(count)), rows)
    write_atomically(path, text.encode())


def write_images(path: Path, rows: Sequence[ImageRow]) -> None:
    """Writes ``images.csv`` atomically; at least one row."""
    columns = ("pose", "file", "lighting", *joint_columns(len(rows[0].q_rad)))
    text = table_text(
        columns,
        ((row.pose, row.file, row.lighting, *np.rad2deg(row.q_rad).tolist()) for row in rows),
    )
    write_atomically(path, text.encode())


def _lighting_of(row: Row) -> str:
    lighting = row.text("lighting")
    if lighting not in LIGHTINGS:
        raise Refusal(
            "lighting-unknown",
            f"{row.place}: lighting {lighting!r}",
            f"it is one of {', '.join(LIGHTINGS)}",
            "Correct the name",
        )
    return lighting


def _check_picture(row: Row, path: Path, sensor: SensorSheet) -> None:
    relative = PurePosixPath(row.text("file"))
    if relative.is_absolute() or ".." in relative.parts:
        raise Refusal(
            "image-outside-session",
            f"{row.place}: file {str(relative)!r}",
            "a session's pictures lie inside its folder",
        )
    if not path.is_file():
        raise Refusal(
            "image-missing",
            f"{row.place}: {path}",
            "there is no such file",
            "Restore the picture or delete the row",
        )
    width, height = grey_png_size(path)
    if (width, height) != (sensor.width_px, sensor.height_px):
        raise Refusal(
            "image-size",
            f"{path} has {width} × {height} pixels",
            f"the sensor has {sensor.width_px} × {sensor.height_px}",
            "Give the picture as the camera took it, and the right sensor.json",
        )


def _pose_of(folder: Path, arm: Arm, rows: list[tuple[Row, ImageRow]]) -> Pose:
    first_row, first = rows[0]
    files: dict[str, Path] = {}
    for row, image in rows:
        moved = np.abs(np.rad2deg(image.q_rad - first.q_rad))
        noise = 6 * np.sqrt(2) * np.rad2deg(arm.encoder_sd_rad)
        worst = int(np.argmax(moved - noise))
        if moved[worst] > STILL_DEG + noise[worst]:
            raise Refusal(
                "pose-moved",
                f"{row.place}: q{worst + 1}_deg differs by {moved[worst]:.4f}° from line "
                f"{first_row.line} of the same pose {image.pose}",
                "the pictures of one pose are taken with the arm held still",
                "Give the rows different pose numbers, or take the pictures again",
            )
        if image.lighting in files:
            raise Refusal(
                "image-twice",
                f"{row.place}: a second {image.lighting!r} picture of pose {image.pose}",
                "one is used of each lighting",
                "Delete one of the rows",
            )
        files[image.lighting] = folder / image.file
    q_rad = np.mean([image.q_rad for _, image in rows], axis=0)
    if "ambient" in files and "laser" in files:
        return Pose(first.pose, q_rad, files["ambient"], files["laser"])
    if "both" in files:
        return Pose(first.pose, q_rad, files["both"], None)
    missing = "laser" if "ambient" in files else "ambient"
    raise Refusal(
        "pose-incomplete",
        f"{first_row.place}: pose {first.pose} has no {missing!r} picture",
        "a pose needs one 'ambient' and one 'laser' picture, or one with 'both' lights",
        "Add the picture, or delete the pose",
    )
