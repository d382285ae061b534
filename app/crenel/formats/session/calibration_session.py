"""A calibration session: a folder with contacts and pictures (docs/formats.md)."""

from collections.abc import Sequence
from dataclasses import dataclass
from pathlib import Path

import numpy as np

from crenel.errors import OperationError
from crenel.formats.atomic_write import write_atomically
from crenel.formats.csv_table import read_table, table_text
from crenel.formats.datasheets.arm import read_any_arm, read_arm
from crenel.formats.datasheets.sensor import SensorDatasheet, read_sensor
from crenel.formats.datasheets.target import read_block, read_object
from crenel.formats.file_names import display_path
from crenel.formats.session.flange_columns import COLUMNS, pose_cells
from crenel.formats.session.pose_columns import ArmReadings, joint_columns
from crenel.formats.session.pose_pictures import Pose, read_poses
from crenel.formats.settings.line_settings import LINE, LineSettings, read_session_line
from crenel.messages.message import message
from crenel.metrology.arm.kinematics import AnyArm, Arm
from crenel.metrology.arm.reported_poses import pose_from_transform, transforms_from_poses
from crenel.metrology.targets.chessboard import Chessboard
from crenel.metrology.targets.crenellated_block import FACES, Crenellated
from crenel.metrology.transforms import Floats
from crenel.timestamps import is_moment, parse_moment

ARM, OBJECT, SENSOR = "arm.json", "object.json", "sensor.json"
PROBING, IMAGES, PICTURES = "probing.csv", "images.csv", "images"
TOUCHED_AT = "touched_at"
"""Optional column: when a contact point was taken, ISO 8601."""
BOARD_FEATURES = ("board",)
"""The face of a chessboard: its plane."""


@dataclass(frozen=True)
class ContactReadings:
    """The contact points, in the order of the file."""

    features: tuple[str, ...]
    q_rad: Floats
    """(N, n) encoder angles; (N, 0) of a robot."""
    T_arm_flange: Floats | None = None
    """(N, 4, 4) of a robot that reports its flange's poses."""

    @property
    def readings(self) -> Floats:
        return self.q_rad if self.T_arm_flange is None else self.T_arm_flange

    @property
    def arm_readings(self) -> Floats:
        """(N, k) as the arm reports them: encoder angles, or poses (N, 7)."""
        if self.T_arm_flange is None:
            return self.q_rad
        return np.array([pose_from_transform(T) for T in self.T_arm_flange])


def contact_readings(features: Sequence[str], arm: AnyArm, readings: Floats) -> ContactReadings:
    """The contact points by the readings (N, k) of the arm."""
    if isinstance(arm, Arm):
        return ContactReadings(tuple(features), readings)
    none = np.zeros((len(readings), 0))
    return ContactReadings(tuple(features), none, transforms_from_poses(readings))


@dataclass(frozen=True)
class _Session:
    """A session as read; the pictures stay on disk, for ``images.read_grey``."""

    folder: Path
    sensor: SensorDatasheet
    contacts: ContactReadings | None
    poses: tuple[Pose, ...]
    """By ascending number."""
    line: LineSettings
    """What is set of the laser's line."""

    @property
    def tables(self) -> tuple[Path, ...]:
        """Its files, the pictures apart."""
        names = (ARM, OBJECT, SENSOR, *((PROBING,) if self.contacts else ()), IMAGES)
        line = (LINE,) if (self.folder / LINE).exists() else ()
        return tuple(self.folder / name for name in (*names, *line))

    @property
    def files(self) -> tuple[Path, ...]:
        """Everything that it was read from."""
        return (*self.tables, *(file for pose in self.poses for file in pose.files))


@dataclass(frozen=True)
class BlockSession(_Session):
    """A session on a block, touched by an arm with joints."""

    contacts: ContactReadings
    arm: Arm
    block: Crenellated


@dataclass(frozen=True)
class BoardSession(_Session):
    """A session on a flat chessboard, of an arm with joints or of a robot."""

    arm: AnyArm
    board: Chessboard


def read_session(folder: Path) -> BlockSession:
    """Reads and checks a session on a block, touched by an arm with joints.

    Raises:
        OperationError: names file, line, value and remedy.
    """
    check_folder(folder)
    arm = read_arm(folder / ARM)
    sensor = read_sensor(folder / SENSOR)
    return BlockSession(
        folder=folder,
        arm=arm,
        block=read_block(folder / OBJECT),
        sensor=sensor,
        contacts=read_contacts(folder / PROBING, arm),
        poses=read_poses(folder / IMAGES, arm, sensor),
        line=read_session_line(folder),
    )


def read_any_session(folder: Path) -> BlockSession | BoardSession:
    """Reads and checks a session on a block or on a chessboard; ``OperationError`` as above.

    Touching a chessboard is optional, and so are its poses' laser pictures; each of its pictures
    is judged by itself when it is read.
    """
    check_folder(folder)
    item = read_object(folder / OBJECT)
    if not isinstance(item, Chessboard):
        return read_session(folder)
    arm = read_any_arm(folder / ARM)
    sensor = read_sensor(folder / SENSOR)
    touched = (folder / PROBING).exists()
    return BoardSession(
        folder=folder,
        arm=arm,
        board=item,
        sensor=sensor,
        contacts=read_contacts(folder / PROBING, arm, BOARD_FEATURES) if touched else None,
        poses=read_poses(folder / IMAGES, arm, sensor=None, needs_laser=False),
        line=read_session_line(folder),
    )


def check_folder(folder: Path) -> None:
    """Raises ``OperationError`` unless it is one."""
    if not folder.is_dir():
        there = message("it-is-a-file") if folder.exists() else message("there-no-such-folder")
        raise OperationError(
            "session-missing", display_path(folder), there, message("name-sessions-folder")
        )


def read_contacts(path: Path, arm: AnyArm, faces: Sequence[str] | None = FACES) -> ContactReadings:
    """Reads ``probing.csv``; raises ``OperationError`` naming line and value.

    Args:
        faces: what ``feature`` may name; None: anything.
    """
    table = read_table(path, ("feature",))
    readings = ArmReadings(table, arm)
    features: list[str] = []
    for row in table.rows:
        feature = row.text("feature")
        if faces is not None and feature not in faces:
            raise OperationError(
                "feature-unknown",
                message("row-feature", place=row.place, feature=repr(feature)),
                message("faces-are", names=", ".join(faces)),
                message("correct-name"),
            )
        features.append(feature)
    if not features:
        raise OperationError(
            "no-contacts",
            message("file-has-no-contact-points", path=display_path(path)),
            "",
            message("probe-object"),
        )
    return ContactReadings(tuple(features), *readings.read_rows(table.rows))


def write_contacts(path: Path, contacts: ContactReadings, touched_at: Sequence[str] = ()) -> None:
    """Writes ``probing.csv`` atomically; reads back to the same angles within 1e-15.

    Args:
        touched_at: when each was taken, ISO 8601; empty if that is not known.
    """
    columns = joint_columns(contacts.q_rad.shape[1])
    readings = [np.rad2deg(q).tolist() for q in contacts.q_rad]
    if contacts.T_arm_flange is not None:
        columns = COLUMNS
        readings = [pose_cells(T) for T in contacts.T_arm_flange]
    head, rows = ["feature", *columns], list(zip(contacts.features, readings, strict=True))
    cells = [(feature, *reading) for feature, reading in rows]
    if touched_at:
        head.append(TOUCHED_AT)
        cells = [(*row, at) for row, at in zip(cells, touched_at, strict=True)]
    write_atomically(path, table_text(head, cells).encode())


def last_touched_at(path: Path) -> str:
    """When the last contact point of a table was taken, ISO 8601; empty if that is not known.

    Raises:
        OperationError: the table cannot be read.
    """
    moments = [row.cells.get(TOUCHED_AT, "") for row in read_table(path, ("feature",)).rows]
    return max(filter(is_moment, moments), key=parse_moment, default="")
