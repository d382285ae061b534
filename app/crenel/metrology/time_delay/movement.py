"""Whether the sensor moved in a pass at all, by the arm and by the pictures."""

import numpy as np

from crenel.errors import OperationError
from crenel.messages.message import message, quantity
from crenel.metrology.time_delay.plane_pass import PlanePass
from crenel.metrology.transforms import Floats

SAMPLE_NS, SAMPLES = 20_000_000, 10
"""Poses are looked at so often, and averaged over so many, so that noise is no movement."""
LEAST_TRAVEL_MM = 0.5


def check_movement(passed: PlanePass, around_ns: int) -> None:
    """Refuses a pass in which the arm stood still.

    Args:
        passed: frames with points.
        around_ns: time before the first frame and after the last one in which the arm may have
            moved.

    Raises:
        OperationError: ``sensor-at-rest``, or ``arm-at-rest`` if the line moved in the pictures.
    """
    first, last = int(passed.stamps_ns[0]) - around_ns, int(passed.stamps_ns[-1]) + around_ns
    T = passed.poses_at(np.arange(first, last, SAMPLE_NS, dtype=np.int64))
    T = T[np.isfinite(T).all(axis=(1, 2))]
    if len(T) < SAMPLES:
        return
    travel_mm = _travel_mm(T[:, :3, :3] @ passed.points_mm.mean(axis=0) + T[:, :3, 3])
    if travel_mm >= LEAST_TRAVEL_MM:
        return
    counts = np.diff(passed.first)[:, None]
    in_picture_mm = _travel_mm(np.add.reduceat(passed.points_mm, passed.first[:-1]) / counts)
    if in_picture_mm >= LEAST_TRAVEL_MM:
        raise OperationError(
            "arm-at-rest",
            message("pass-does-not-tell-delay"),
            message("line-moved-arm-did-not", line=quantity(in_picture_mm, "mm", 1)),
            message("see-that-arm-sends-its-positions"),
        )
    raise OperationError(
        "sensor-at-rest",
        message("pass-does-not-tell-delay"),
        message("sensor-did-not-move"),
        message("move-sensor-nearer-away-again-several"),
    )


def _travel_mm(places_mm: Floats) -> float:
    """How far places (N, 3) are apart, of means over some of them."""
    begins = np.arange(0, len(places_mm), SAMPLES)
    counts = np.diff(np.append(begins, len(places_mm)))[:, None]
    means = np.add.reduceat(places_mm, begins) / counts
    return float(np.linalg.norm(np.ptp(means, axis=0)))
