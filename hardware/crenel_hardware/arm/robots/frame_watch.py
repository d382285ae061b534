"""Notices that a controller refers its poses to another tool or base frame.

Some controllers do not say which ones are active. Where they also send the joints, a change shows
while the robot stands still: the pose leaps, and no joint has moved.
"""

from math import asin, degrees, hypot, sqrt

from crenel.messages.message import message, quantity
from crenel.rotations import Quaternion, Vector
from crenel_hardware.errors import DeviceError

_LONGEST_STEP_NS = 20_000_000
"""From one reading to the next. In this time, a robot on a track sets off by less than a leap."""
_STILL_RAD, _STILL_MM = 2e-4, 0.1
"""Sum of the joints' steps, and step of the pose, of a robot at rest."""
_LEAP_MM, _LEAP_RAD = 1.0, 0.01

Place = tuple[Vector, Quaternion]


class FrameWatch:
    """Compares each pose with the one before.

    Args:
        address: of the controller, for messages.
    """

    def __init__(self, address: str) -> None:
        self._address = address
        self._last: tuple[int, tuple[float, ...], Place] | None = None
        self._rests = False

    def require_same_frames(
        self, device_ns: int, joints_rad: tuple[float, ...], place: Place
    ) -> None:
        """Raises ``DeviceError`` if the pose leaps while the joints stand still.

        Args:
            device_ns: on the controller's clock.
            joints_rad: empty if they are not sent; then nothing is known.
            place: position in mm and orientation, as sent.
        """
        last, self._last = self._last, (device_ns, joints_rad, place)
        rested, self._rests = self._rests, False
        if last is None or not joints_rad or len(last[1]) != len(joints_rad):
            return
        turned_rad = sum(abs(a - b) for a, b in zip(joints_rad, last[1], strict=True))
        is_next = 0 < device_ns - last[0] <= _LONGEST_STEP_NS
        if not (is_next and turned_rad <= _STILL_RAD):  # nor if they are no numbers
            return
        step_mm, step_rad = _step(last[2], place)
        self._rests = step_mm < _STILL_MM
        if rested and (step_mm > _LEAP_MM or step_rad > _LEAP_RAD):
            raise DeviceError(
                message(
                    "robot-frames-changed",
                    address=self._address,
                    step=quantity(step_mm, "mm", 1),
                    turn=quantity(degrees(step_rad), "°", 1),
                ),
                message("robot-select-former-frames"),
            )


def _step(before: Place, after: Place) -> tuple[float, float]:
    """Distance in mm, and angle in rad, up to half a turn."""
    distance_mm = hypot(*(b - a for a, b in zip(before[0], after[0], strict=True)))
    cosine = sum(a * b for a, b in zip(before[1], after[1], strict=True))
    return distance_mm, 2 * asin(min(1.0, sqrt(max(0.0, 1 - cosine * cosine))))
