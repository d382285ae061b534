"""What the 3D view shows, and what not."""

from dataclasses import dataclass

from app.station.view3d.cloud_colouring import Weakness


@dataclass(frozen=True)
class SceneContent:
    """Of all viewers."""

    arm_shown: bool
    weak_shown: bool
    """Whether weak points have colours of their own."""
    weak_points: dict[Weakness, int]
    """How many there are, the gravest last."""
    points_cut: int
    """Points that would be shown if they were not cut away."""
    floor_mm: float
    """Height of the table, or of the lowest point below it, in the arm frame."""
