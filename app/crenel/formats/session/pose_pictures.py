"""``images.csv``: the pictures of a calibration session, by the poses in which they were taken."""

from collections.abc import Sequence
from dataclasses import dataclass
from pathlib import Path, PurePosixPath, PureWindowsPath

import numpy as np

from crenel.errors import OperationError
from crenel.formats.atomic_write import write_atomically
from crenel.formats.csv_table import TableRow, read_table, table_text
from crenel.formats.datasheets.sensor import SensorDatasheet
from crenel.formats.file_names import display_path
from crenel.formats.images import image_size
from crenel.formats.session.flange_columns import COLUMNS, pose_cells
from crenel.formats.session.pose_columns import ArmReadings, joint_columns
from crenel.messages.message import Text, join, message, quantity
from crenel.metrology.arm.kinematics import AnyArm, Arm
from crenel.metrology.arm.reported_poses import transforms_from_poses
from crenel.metrology.transforms import Floats

LIGHTINGS = ("ambient", "laser", "both")
STILL_DEG = 0.005
"""An arm held still may read this much differently from picture to picture, plus its noise."""
STILL_MM = 0.05
"""The same of a robot, in place, and half a metre from its flange."""


@dataclass(frozen=True)
class Pose:
    """The pictures taken with the arm held still."""

    number: int
    q_rad: Floats
    """(n,) encoder angles; (0,) of a robot."""
    ambient: Path
    """With the laser off; or the picture with both lights, where ``laser`` is None."""
    laser: Path | None
    T_arm_flange: Floats | None = None
    """(4, 4) of a robot that reports its flange's pose."""
    laser_on: bool = True
    """Whether the laser was on in one of them."""

    @property
    def reading(self) -> Floats:
        return self.q_rad if self.T_arm_flange is None else self.T_arm_flange

    @property
    def files(self) -> tuple[Path, ...]:
        return (self.ambient,) if self.laser is None else (self.ambient, self.laser)


@dataclass(frozen=True)
class ImageRow:
    """One row of ``images.csv``."""

    pose: int
    file: str
    """Relative to the session's folder, with forward slashes."""
    lighting: str
    q_rad: Floats
    T_arm_flange: Floats | None = None
    """(4, 4) of a robot, whose ``q_rad`` is (0,)."""


def image_row(pose: int, file: str, lighting: str, arm: AnyArm, reading: Floats) -> ImageRow:
    """The row of a picture by the reading (k,) of the arm."""
    if isinstance(arm, Arm):
        return ImageRow(pose, file, lighting, reading)
    T_arm_flange = transforms_from_poses(reading[None])[0]
    return ImageRow(pose, file, lighting, np.zeros(0), T_arm_flange)


def read_poses(
    path: Path, arm: AnyArm, sensor: SensorDatasheet | None, needs_laser: bool = True
) -> tuple[Pose, ...]:
    """Reads ``images.csv``; raises ``OperationError``.

    Args:
        sensor: all pictures must be there, and their headers agree with it; None if each picture
            is judged by itself when it is read, and only not all may be missing.
        needs_laser: every pose has a picture with the laser on.
    """
    table = read_table(path, ("pose", "file", "lighting"))
    readings = ArmReadings(table, arm)
    by_pose: dict[int, list[tuple[TableRow, ImageRow]]] = {}
    missing: list[OperationError] = []
    for row in table.rows:
        at = readings.read_row(row)
        image = ImageRow(row.count("pose"), row.text("file"), read_lighting(row), *at)
        file = image_file(row)
        if not file.is_file():
            missing.append(_missing_error(row, file))
        if sensor is not None:
            if missing:
                raise missing[0]
            check_size(file, image_size(file), sensor)
        by_pose.setdefault(image.pose, []).append((row, image))
    if missing and len(missing) == len(table.rows):
        raise missing[0]
    if not by_pose:
        raise OperationError(
            "no-images",
            message("file-has-no-pictures", path=display_path(path)),
            "",
            message("take-picture-object"),
        )
    readings.read_rows(table.rows)
    return tuple(_build_pose(arm, by_pose[number], needs_laser) for number in sorted(by_pose))


def write_images(path: Path, rows: Sequence[ImageRow]) -> None:
    """Writes ``images.csv`` atomically; at least one row."""
    own = COLUMNS if rows[0].T_arm_flange is not None else joint_columns(len(rows[0].q_rad))
    text = table_text(
        ("pose", "file", "lighting", *own),
        ((row.pose, row.file, row.lighting, *_cells(row)) for row in rows),
    )
    write_atomically(path, text.encode())


def _cells(row: ImageRow) -> Sequence[float]:
    if row.T_arm_flange is not None:
        return pose_cells(row.T_arm_flange)
    return [float(angle) for angle in np.rad2deg(row.q_rad)]


def read_lighting(row: TableRow) -> str:
    """Which lights were on in the picture of a row; raises ``OperationError``."""
    lighting = row.text("lighting")
    if lighting not in LIGHTINGS:
        raise OperationError(
            "lighting-unknown",
            message("row-lighting", place=row.place, lighting=repr(lighting)),
            message("one-of", names=", ".join(LIGHTINGS)),
            message("correct-name"),
        )
    return lighting


def image_file(row: TableRow) -> Path:
    """The picture of a row; raises ``OperationError`` unless it lies in the table's folder.

    Folders may be separated as Windows does it, in tables that other programs wrote there.
    """
    file = row.text("file")
    relative = PurePosixPath(file.replace("\\", "/"))
    absolute = relative.is_absolute() or PureWindowsPath(file).is_absolute()
    if absolute or ".." in relative.parts:
        raise OperationError(
            "image-outside-session",
            message("row-file", place=row.place, file=repr(str(relative))),
            message("sessions-pictures-lie-inside-folder"),
        )
    return row.path.parent / relative


def _missing_error(row: TableRow, path: Path) -> OperationError:
    return OperationError(
        "image-missing",
        join([row.place, display_path(path)], ": "),
        message("no-such-file"),
        message("restore-picture-delete-row"),
    )


def check_size(path: Path, size_px: tuple[int, int], sensor: SensorDatasheet) -> None:
    """Refuses a picture whose width and height are not the sensor's; raises ``OperationError``."""
    width, height = size_px
    if (width, height) != (sensor.width_px, sensor.height_px):
        raise OperationError(
            "image-size",
            message("image-has-pixels", name=display_path(path), width=width, height=height),
            message("sensor-has-pixels", width=sensor.width_px, height=sensor.height_px),
            message("give-picture-as-taken-and-sensor-json"),
        )


def _build_pose(arm: AnyArm, rows: list[tuple[TableRow, ImageRow]], needs_laser: bool) -> Pose:
    first_row, first = rows[0]
    files: dict[str, Path] = {}
    for row, image in rows:
        moved = _pose_difference(arm, image, first)
        if moved:
            raise OperationError(
                "pose-moved",
                message(
                    "pose-differs-from-line",
                    place=row.place,
                    moved=moved,
                    line=first_row.line,
                    pose=image.pose,
                ),
                message("pictures-of-one-pose-need-still-arm"),
                message("give-rows-different-pose-numbers-take"),
            )
        if image.lighting in files:
            raise OperationError(
                "image-twice",
                message(
                    "second-picture-pose",
                    place=row.place,
                    lighting=repr(image.lighting),
                    pose=image.pose,
                ),
                message("one-used-each-lighting"),
                message("delete-one-rows"),
            )
        files[image.lighting] = image_file(row)
    q_rad = np.mean([image.q_rad for _, image in rows], axis=0)
    if "ambient" in files and "laser" in files:
        return Pose(first.pose, q_rad, files["ambient"], files["laser"], first.T_arm_flange)
    if "both" in files:
        return Pose(first.pose, q_rad, files["both"], None, first.T_arm_flange)
    if "ambient" in files and not needs_laser:
        return Pose(first.pose, q_rad, files["ambient"], None, first.T_arm_flange, laser_on=False)
    why = message("pose-needs-both-lightings")
    if not needs_laser:
        why = message("pose-needs-a-lit-picture")
    missing = "laser" if "ambient" in files else "ambient"
    raise OperationError(
        "pose-incomplete",
        message(
            "pose-has-no-picture", place=first_row.place, pose=first.pose, missing=repr(missing)
        ),
        why,
        message("add-picture-delete-pose"),
    )


def _pose_difference(arm: AnyArm, image: ImageRow, first: ImageRow) -> Text:
    """How an arm stood differently in two pictures of one pose; empty where it did not."""
    if isinstance(arm, Arm):
        moved = np.abs(np.rad2deg(image.q_rad - first.q_rad))
        noise = 6 * np.sqrt(2) * np.rad2deg(arm.encoder_sd_rad)
        worst = int(np.argmax(moved - noise))
        if moved[worst] <= STILL_DEG + noise[worst]:
            return ""
        return message(
            "joint-column-differs", joint=worst + 1, moved=quantity(moved[worst], "°", 4)
        )
    assert image.T_arm_flange is not None
    assert first.T_arm_flange is not None
    apart = image.T_arm_flange - first.T_arm_flange
    moved_mm = float(np.linalg.norm(apart[:3, 3]) + 500 * np.abs(apart[:3, :3]).max())
    if moved_mm <= STILL_MM:
        return ""
    return message("flange-differs", moved=quantity(moved_mm, "mm", 3))
