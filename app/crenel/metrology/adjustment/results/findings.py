"""What an adjustment shows about its poses and pictures, in words, on whichever target."""

from collections.abc import Iterable, Sequence

import numpy as np

from crenel.errors import sentence
from crenel.messages.message import message, quantity
from crenel.metrology.calibration.findings import CalibrationFinding
from crenel.metrology.detection.image_quality import ImageFinding
from crenel.metrology.transforms import Floats, inverse, vector_from_rotation

# Poses with smaller turns between them determine little more than one does.
ALIKE_DEG = 8.0


def alike_findings(T_arm_flange: Floats) -> list[CalibrationFinding]:
    """Where the sensor was hardly turned between the poses (P, 4, 4)."""
    turns = [
        float(np.linalg.norm(vector_from_rotation((inverse(a) @ b)[:3, :3])))
        for i, a in enumerate(T_arm_flange)
        for b in T_arm_flange[i + 1 :]
    ]
    turn_deg = float(np.degrees(max(turns, default=0.0)))
    if turn_deg >= ALIKE_DEG:
        return []
    text = message(
        "sensor-turned-most-between-poses-wanted",
        turn=quantity(turn_deg, "°", 1),
        alike_deg=quantity(ALIKE_DEG, "°"),
    )
    remedy = message("take-poses-tilted-left-right-front")
    return [CalibrationFinding("attention", "poses-alike", text, remedy)]


def picture_findings(
    poses: Iterable[tuple[int, Sequence[ImageFinding]]],
) -> list[CalibrationFinding]:
    """What the poses' pictures suffer from, each kind once, by the first pose that shows it."""
    first: dict[str, CalibrationFinding] = {}
    for number, suffered in poses:
        for one in suffered:
            text = message("pose-for-reason", number=number, reason=one.text)
            finding = CalibrationFinding("attention", one.code, text, sentence(one.remedy), number)
            first.setdefault(one.code, finding)
    return list(first.values())


def joint_rms(parts: Iterable[tuple[float, int]]) -> float:
    """The rms of all points together, by the rms and the number of points of each part; 0 for
    none."""
    rms, count = np.array([*parts, (0.0, 0)]).T
    return float(np.sqrt(np.sum(rms**2 * count) / max(count.sum(), 1.0)))
