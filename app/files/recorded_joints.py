"""The joint angles of a recording, brought into the arm's order and checked."""

from pathlib import Path

import numpy as np

from app.files.joint_angles import STOP_TOLERANCE_DEG
from app.files.recording_stream import JointSamples
from app.metrology.arm import Arm
from app.metrology.frames import Floats
from app.metrology.joint_stamps import Stamps
from app.metrology.refusal import Refusal


class JointReader:
    """Checks each reading against one arm."""

    def __init__(self, path: Path, arm: Arm) -> None:
        self._path = path
        self._arm = arm
        self._names: tuple[str, ...] | None = None
        self._order = list(range(arm.joint_count))
        tolerance = np.deg2rad(STOP_TOLERANCE_DEG)
        self._lowest = np.array([joint.limits_rad[0] for joint in arm.joints]) - tolerance
        self._highest = np.array([joint.limits_rad[1] for joint in arm.joints]) + tolerance
        self.unusable = 0
        """Readings that held something else than numbers, and were left out."""

    def readings(self, samples: JointSamples) -> tuple[Stamps, Floats]:
        """The readings' stamps (J,) and angles (J, n) in the arm's order.

        Readings with an angle missing (NaN) are left out and counted. Joints go by name
        where the recording names them as ``arm.json`` does, else by their order.

        Raises:
            Refusal: another number of joints than the arm's, only some names known,
                or an angle outside the arm's limits.
        """
        if samples.names != self._names:
            self._order = self._order_of(samples.names)
            self._names = samples.names
        q_rad, stamps_ns = samples.q_rad[:, self._order], samples.stamps_ns
        whole = np.isfinite(q_rad).all(axis=1)
        if not whole.all():
            self.unusable += int((~whole).sum())
            q_rad, stamps_ns = q_rad[whole], stamps_ns[whole]
        outside = (q_rad < self._lowest) | (q_rad > self._highest)
        if outside.any():
            row, joint = (int(i) for i in np.argwhere(outside)[0])
            raise self._outside(int(stamps_ns[row]), q_rad[row], joint)
        return stamps_ns, q_rad

    def _order_of(self, names: tuple[str, ...]) -> list[int]:
        own = [joint.name for joint in self._arm.joints]
        if len(names) != len(own):
            raise Refusal(
                "joint-count",
                f"{self._path} holds {len(names)} joints",
                f"the arm {self._arm.serial_number or self._arm.name} has {len(own)}",
                "Give the arm.json of the arm that took this recording",
            )
        if sorted(names) == sorted(own) and len(set(own)) == len(own):
            return [names.index(name) for name in own]
        if set(names) & set(own):
            raise Refusal(
                "joint-names",
                f"{self._path} names its joints {', '.join(names)}",
                f"arm.json names them {', '.join(own)}",
                "Give the arm.json of the arm that took this recording",
            )
        return list(range(len(own)))

    def _outside(self, stamp_ns: int, q_rad: Floats, joint: int) -> Refusal:
        low, high = self._arm.joints[joint].limits_rad
        degrees = np.abs(q_rad).max() > 4 * np.pi
        hint = "; these are degrees where radians are expected" if degrees else ""
        return Refusal(
            "joint-outside-limits",
            f"{self._path} at {stamp_ns} ns: joint {self._arm.joints[joint].name} is at "
            f"{q_rad[joint]:.4f} rad",
            f"it turns from {low:.4f} to {high:.4f} rad{hint}",
            "Record radians" if degrees else "Give the arm.json of the arm that took this",
        )
