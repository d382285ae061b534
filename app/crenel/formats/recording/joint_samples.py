"""The joint angles of a recording, in the arm's order and checked."""

from pathlib import Path
from typing import NamedTuple

import numpy as np

from crenel.errors import OperationError
from crenel.formats.file_names import display_path
from crenel.formats.recording.stream import ReadingSamples
from crenel.messages.message import message, quantity
from crenel.metrology.arm.joint_plausibility import ImplausibleReading, PlausibilityFilter
from crenel.metrology.arm.kinematics import Arm
from crenel.metrology.arm.reading_interpolation import Stamps
from crenel.metrology.transforms import Floats

RATE_HZ = 1000.0
"""Uncertainty with which the readings of a recording are judged; their stamps contain more."""
FEW_OUTSIDE = 1000
"""Readings outside the arm's limits may come from an encoder fault; if they are the majority of
this many, it is a different arm."""


class _JointReading(NamedTuple):
    stamp_ns: int
    joints_rad: list[float]


class JointReader:
    """Checks each reading with one arm, as a running scan does."""

    def __init__(self, path: Path, arm: Arm) -> None:
        self._path = path
        self._arm = arm
        self._names: tuple[str, ...] | None = None
        self._order: list[int] | None = None
        """Where the arm's joints are among those of the recording; None: these are others."""
        self._others: dict[str, None] = {}
        self._first_others: tuple[str, ...] = ()
        self._judge: PlausibilityFilter[_JointReading] = PlausibilityFilter(
            arm.joint_count, RATE_HZ, arm
        )
        self._read = 0
        self.unusable = 0
        """Readings that were not numbers, and were excluded."""

    @property
    def other_joints(self) -> tuple[str, ...]:
        """Names of joints that the recording has and the arm has not, such as a gripper's."""
        return tuple(self._others) if self._read else ()

    @property
    def implausible(self) -> int:
        """Impossible readings, which were excluded."""
        return self._judge.rejected_count

    @property
    def first_implausible(self) -> ImplausibleReading | None:
        return self._judge.first

    def readings(self, samples: ReadingSamples) -> tuple[Stamps, Floats]:
        """The time stamps (J,) and angles (J, n) of the readings in the arm's order.

        Readings with a missing angle (NaN), and impossible readings, are excluded and counted. The
        last ones may be returned by the next call, or by ``last_readings``. Joints are assigned by
        name if the recording names them as ``arm.json`` does, and others are left out; otherwise
        by order.

        Raises:
            OperationError: only some of the arm's joints are there, or most angles are outside the
                arm's limits.
        """
        if samples.kind != "joints":
            raise OperationError(
                "recording-of-poses",
                message("recording-has-poses", path=display_path(self._path)),
                message("arm-json-has-joints", arm=self._arm.serial_number or self._arm.name),
                message("give-arm-json-arm-took-recording"),
            )
        if not self.is_of_arm(samples):
            return self._arrays([])
        q_rad, stamps_ns = samples.readings[:, self._order], samples.stamps_ns
        whole = np.isfinite(q_rad).all(axis=1)
        if not whole.all():
            self.unusable += int((~whole).sum())
            q_rad, stamps_ns = q_rad[whole], stamps_ns[whole]
        self._read += len(stamps_ns)
        pairs = zip(stamps_ns.tolist(), q_rad.tolist(), strict=True)
        good = self._judge.filter([_JointReading(*pair) for pair in pairs])
        if self._judge.outside > FEW_OUTSIDE:
            self.refuse_another_arm()
        return self._arrays(good)

    def is_of_arm(self, samples: ReadingSamples) -> bool:
        """Whether they are of this arm's joints; raises ``OperationError`` for some of them."""
        if samples.names != self._names:
            self._order = self._joint_order(samples.names)
            self._names = samples.names
        return self._order is not None

    def last_readings(self) -> tuple[Stamps, Floats]:
        """The last readings, after the end of the recording.

        Raises:
            OperationError: all readings were of other joints.
        """
        if not self._read and self._first_others:
            raise self._other_joints_error(self._first_others)
        return self._arrays(self._judge.flush())

    def refuse_another_arm(self) -> None:
        """Raises ``OperationError`` if most readings are outside the arm's limits."""
        first = self._judge.first
        if first is None or 2 * self._judge.outside <= self._read:
            return
        low, high = (quantity(limit, "rad", 4) for limit in first.limits_rad)
        degrees = abs(first.reading_rad) > 4 * np.pi
        raise OperationError(
            "joint-outside-limits",
            message(
                "joint-at-stamp",
                path=display_path(self._path),
                stamp_ns=first.stamp_ns,
                joint=first.joint,
                reading=quantity(first.reading_rad, "rad", 4),
            ),
            message("joint-range-in-radians", low=low, high=high)
            if degrees
            else message("joint-range", low=low, high=high),
            message("record-radians") if degrees else message("give-arm-json-arm-took"),
        )

    def _arrays(self, good: list[_JointReading]) -> tuple[Stamps, Floats]:
        stamps_ns = np.array([one.stamp_ns for one in good], dtype=np.int64)
        q_rad = np.array([one.joints_rad for one in good], dtype=np.float64)
        return stamps_ns, q_rad.reshape(len(good), self._arm.joint_count)

    def _joint_order(self, names: tuple[str, ...]) -> list[int] | None:
        own = [joint.name for joint in self._arm.joints]
        known = [name for name in own if name in names]
        if len(known) == len(set(own)) == len(own):
            self._others |= dict.fromkeys(name for name in names if name not in own)
            return [names.index(name) for name in own]
        if known:
            raise OperationError(
                "joint-names",
                message(
                    "recording-names-joints", path=display_path(self._path), names=", ".join(names)
                ),
                message(
                    "arm-joints-not-among-them",
                    names=", ".join(name for name in own if name not in names),
                ),
                message("name-joints-as-recording"),
            )
        if len(names) == len(own) and not self._others:
            return list(range(len(own)))
        self._first_others = self._first_others or names
        self._others |= dict.fromkeys(names)
        return None

    def _other_joints_error(self, names: tuple[str, ...]) -> OperationError:
        return OperationError(
            "joint-count",
            message(
                "recording-has-joints-named",
                path=display_path(self._path),
                count=len(names),
                names=", ".join(names),
            ),
            message(
                "arm-has-joint-number",
                arm=self._arm.serial_number or self._arm.name,
                count=self._arm.joint_count,
            ),
            message("name-joints-as-recording"),
        )
