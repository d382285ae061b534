"""The speed of the sensor over a surface, and its effect on the points."""

from dataclasses import dataclass

import numpy as np

from crenel.metrology.robust import median
from crenel.metrology.transforms import Floats

BLUR_SPACINGS, BLUR_UNCERTAINTIES = 4.0, 10.0
"""A stripe that blurs over less than this multiple of its point spacing, or of the points' standard
uncertainty, loses no information."""


@dataclass(frozen=True)
class PassSpeed:
    """Motion during one frame."""

    blur_mm: float
    """Distance that a point of the surface moves under the stripe during the exposure."""
    step_mm: float
    """Distance across the stripe from one frame to the next: the spacing along the pass."""
    spacing_mm: float
    """Spacing of adjacent points along the stripe."""

    def limit_mm(self, uncertainty_mm: float) -> float:
        """The blur from which a warning is justified, for points with this uncertainty (k = 1)."""
        return max(BLUR_SPACINGS * self.spacing_mm, BLUR_UNCERTAINTIES * uncertainty_mm)


def pass_speed(
    stripe_mm: Floats,
    T_before: Floats,
    T_after: Floats,
    between_s: float,
    exposure_s: float,
    period_s: float,
) -> PassSpeed | None:
    """Motion of the stripe over the surface during an exposure and between frames.

    Args:
        stripe_mm: (N, 3) points of the frame in order, sensor frame; NaN is ignored.
        T_before, T_after: (4, 4) ``T_arm_sensor``, ``between_s`` apart.
        between_s: time from ``T_before`` to ``T_after``.
        exposure_s: exposure time of the frame.
        period_s: time from the previous frame to this one.

    Returns:
        None if the frame has no two distinct points, or if no time has passed.
    """
    points = stripe_mm[np.isfinite(stripe_mm).all(axis=1)]
    if len(points) < 2 or between_s <= 0:
        return None
    line = points[-1] - points[0]
    length = float(np.linalg.norm(line))
    if length == 0:
        return None
    rate = (T_after - T_before) / between_s
    velocity = points.mean(axis=0) @ rate[:3, :3].T + rate[:3, 3]
    along = T_after[:3, :3] @ (line / length)
    across = velocity - float(velocity @ along) * along
    spacing = median(np.linalg.norm(np.diff(points, axis=0), axis=1))
    return PassSpeed(
        blur_mm=float(np.linalg.norm(velocity)) * exposure_s,
        step_mm=float(np.linalg.norm(across)) * period_s,
        spacing_mm=spacing,
    )
