"""The reported poses of a recording, checked."""

from pathlib import Path
from typing import NamedTuple, Protocol

import numpy as np

from crenel.errors import OperationError
from crenel.formats.file_names import display_path
from crenel.formats.recording.joint_samples import JointReader
from crenel.formats.recording.stream import ReadingSamples
from crenel.messages.message import message
from crenel.metrology.arm.kinematics import AnyArm, Arm, RobotArm
from crenel.metrology.arm.pose_plausibility import ImplausiblePose, PosePlausibilityFilter
from crenel.metrology.arm.reading_interpolation import Stamps
from crenel.metrology.arm.reported_poses import POSE_SIZE
from crenel.metrology.transforms import Floats


class FirstImplausible(Protocol):
    """The first reading that was excluded."""

    @property
    def stamp_ns(self) -> int: ...

    @property
    def error(self) -> OperationError:
        """What is wrong with it."""


class ReadingReader(Protocol):
    """Checks each reading with one arm, as a running scan does."""

    unusable: int
    """Readings that were not numbers, and were excluded."""

    @property
    def other_joints(self) -> tuple[str, ...]:
        """Names of joints that the recording has and the arm has not."""

    @property
    def implausible(self) -> int:
        """Impossible readings, which were excluded."""

    @property
    def first_implausible(self) -> FirstImplausible | None: ...

    def readings(self, samples: ReadingSamples) -> tuple[Stamps, Floats]:
        """The time stamps (J,) and readings (J, k) that are plausible."""

    def is_of_arm(self, samples: ReadingSamples) -> bool:
        """Whether they are of this arm, not of what it carries."""

    def last_readings(self) -> tuple[Stamps, Floats]:
        """The last readings, after the end of the recording."""

    def refuse_another_arm(self) -> None:
        """Raises ``OperationError`` if most readings cannot be this arm's."""


def reading_reader(path: Path, arm: AnyArm) -> ReadingReader:
    """The reader of a recording's readings by the kind of the arm."""
    return JointReader(path, arm) if isinstance(arm, Arm) else PoseReader(path, arm)


class _PoseReading(NamedTuple):
    stamp_ns: int
    reading: list[float]


class PoseReader:
    """Checks each pose; meets ``ReadingReader``."""

    def __init__(self, path: Path, arm: RobotArm) -> None:
        self._path = path
        self._arm = arm
        self._judge: PosePlausibilityFilter[_PoseReading] = PosePlausibilityFilter()
        self._judge.keeps_frame = True
        self._first: ImplausiblePose | None = None
        self.unusable = 0

    @property
    def other_joints(self) -> tuple[str, ...]:
        return ()

    @property
    def implausible(self) -> int:
        return self._judge.rejected_count

    @property
    def first_implausible(self) -> ImplausiblePose | None:
        return self._first

    def readings(self, samples: ReadingSamples) -> tuple[Stamps, Floats]:
        """The time stamps (J,) and poses (J, 7) that are plausible.

        Raises:
            OperationError: the recording has joint angles.
        """
        if samples.kind != "pose":
            raise OperationError(
                "recording-of-joints",
                message(
                    "recording-has-joints",
                    path=display_path(self._path),
                    count=samples.readings.shape[1],
                ),
                message("arm-json-is-of-poses", arm=self._arm.serial_number or self._arm.name),
                message("give-arm-json-arm-took-recording"),
            )
        finite = np.isfinite(samples.readings).all(axis=1)
        self.unusable += int((~finite).sum())
        stamps_ns, poses = samples.stamps_ns[finite], samples.readings[finite]
        pairs = zip(stamps_ns.tolist(), poses.tolist(), strict=True)
        good = self._judge.filter([_PoseReading(*pair) for pair in pairs])
        self._first = self._first or self._judge.newest
        return _arrays(good)

    def is_of_arm(self, samples: ReadingSamples) -> bool:
        return True

    def last_readings(self) -> tuple[Stamps, Floats]:
        """The poses that still waited for their judgement."""
        return _arrays(self._judge.release())

    def refuse_another_arm(self) -> None:
        """Poses have no limits by which another robot would show."""


def _arrays(readings: list[_PoseReading]) -> tuple[Stamps, Floats]:
    kept = np.array([one.reading for one in readings]).reshape(len(readings), POSE_SIZE)
    return np.array([one.stamp_ns for one in readings], dtype=np.int64), kept
