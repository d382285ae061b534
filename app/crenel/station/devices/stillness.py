"""Whether the arm is held still, from its readings, allowing for their noise."""

import math
from dataclasses import dataclass

import numpy as np

from crenel.messages.message import Quantity, Text, message, quantity
from crenel.metrology.arm.kinematics import (
    AnyArm,
    Arm,
    RobotArm,
    flange_poses,
    geometric_jacobian,
)
from crenel.metrology.arm.reading_interpolation import mean_reading
from crenel.metrology.arm.strained_pose import Strain, strain_of
from crenel.metrology.transforms import Floats
from crenel.station.devices.reading_buffer import ReadingWindow

WINDOW_S = 0.3
TIP_LIMIT_UM = 40.0
TURN_LIMIT_ARCSEC = 60.0
BLOCKS = 6
FEWEST_SAMPLES = 6
# Limit of the distance between block means of pure noise, in standard deviations of one mean: the
# expected range of six is 2.5, and 5 is exceeded less than once in 500.
NOISE_RANGE = 5.0
# The median length of a vector of three independent components of standard deviation 1.
MEDIAN_OF_NORM = 1.538
ARCSEC_PER_RAD = 180 * 3600 / np.pi


@dataclass(frozen=True)
class Stillness:
    """How far the arm moved over a window, and whether that counts as still."""

    still: bool
    moved_um: float
    turned_arcsec: float
    text: Text
    strain: Strain | None = None
    """Why the pose strains the arm."""


UNKNOWN = Stillness(False, float("nan"), float("nan"), message("too-little-arm-data-yet"))


def stillness(arm: AnyArm, window: ReadingWindow) -> Stillness:
    """How far the tip moved and the flange (with the sensor) turned.

    The samples of the window are averaged in six blocks, and the largest distance between two
    blocks counts. Noise therefore does not look like motion, and the limit is increased by its
    effect on such means: of the encoders as stated, or of a robot's poses as seen between
    adjacent samples. A robot without a tip is judged at its flange.
    """
    if len(window) < FEWEST_SAMPLES:
        return UNKNOWN
    count = min(BLOCKS, len(window) // 2)
    blocks = [mean_reading(window.kind, part) for part in np.array_split(window.readings, count)]
    poses = flange_poses(arm, np.array(blocks))
    moved_um = 1000 * _widest(_reference_points(arm, poses))
    turned_arcsec = _widest_turn(poses[:, :3, :3]) * ARCSEC_PER_RAD
    noise_um, noise_arcsec = _noise(arm, window, len(window) // count)
    still = moved_um <= TIP_LIMIT_UM + noise_um and turned_arcsec <= (
        TURN_LIMIT_ARCSEC + noise_arcsec
    )
    strain = strain_of(arm, window.readings[-1]) if isinstance(arm, Arm) else None
    text = _words(still, moved_um, turned_arcsec, window)
    return Stillness(still, moved_um, turned_arcsec, text, strain)


def _reference_points(arm: AnyArm, poses: Floats) -> Floats:
    """(N, 3) mm by flange poses (N, 4, 4): centres of the tip, or origins of the flange."""
    point_mm = np.zeros(3) if arm.tip is None else arm.tip.centre_mm
    return np.asarray(poses[:, :3, :3] @ point_mm + poses[:, :3, 3])


def _words(still: bool, moved_um: float, turned_arcsec: float, window: ReadingWindow) -> Text:
    if still:
        return message("still")
    seconds = (window.stamps_ns[-1] - window.stamps_ns[0]) / 1e9
    return message(
        "moved-turned",
        moved=_motion_um(moved_um),
        turned=_motion_arcsec(turned_arcsec),
        duration=quantity(seconds, "s", 1),
    )


def _motion_um(moved_um: float) -> Quantity:
    """With few digits: while the operator moves the arm, they change too fast to be read."""
    return quantity(moved_um, "µm") if moved_um < 1000 else quantity(moved_um / 1000, "mm", 1)


def _motion_arcsec(turned_arcsec: float) -> Quantity:
    if turned_arcsec < 3600:
        return quantity(turned_arcsec, "″")
    return quantity(turned_arcsec / 3600, "°", 1)


def _widest(points: Floats) -> float:
    apart = np.linalg.norm(points[:, None] - points[None], axis=2)
    return float(apart.max())


def _widest_turn(rotations: Floats) -> float:
    """The largest angle, rad, between two of (N, 3, 3) rotations (chord, exact when small)."""
    apart = np.linalg.norm(rotations[:, None] - rotations[None], axis=(2, 3))
    return float(2 * np.arcsin(np.minimum(apart.max() / np.sqrt(8.0), 1.0)))


def _noise(arm: AnyArm, window: ReadingWindow, samples_a_block: int) -> tuple[float, float]:
    """The amount by which noise alone moves (µm) and turns (arcsec) the means of blocks."""
    sd_mm, sd_rad = (
        _pose_noise(arm, window)
        if isinstance(arm, RobotArm)
        else _joint_noise(arm, window.readings[0])
    )
    scale = NOISE_RANGE / math.sqrt(samples_a_block)
    return 1000 * sd_mm * scale, sd_rad * ARCSEC_PER_RAD * scale


def _joint_noise(arm: Arm, q_rad: Floats) -> tuple[float, float]:
    """Standard deviations of tip (mm) and orientation (rad) by the encoders' stated noise."""
    jacobian = geometric_jacobian(arm, q_rad, arm.tip.centre_mm)
    sd = np.sqrt(((jacobian * arm.encoder_sd_rad) ** 2).reshape(2, 3, -1).sum(axis=(1, 2)))
    return float(sd[0]), float(sd[1])


def _pose_noise(arm: RobotArm, window: ReadingWindow) -> tuple[float, float]:
    """Standard deviations of the judged point (mm) and orientation (rad) of one pose.

    By the median second difference of adjacent samples, in which even motion does not appear; its
    variance is six times that of one sample.
    """
    poses = flange_poses(arm, window.readings)
    points = _reference_points(arm, poses)
    steps_mm = np.linalg.norm(np.diff(points, 2, axis=0), axis=1) / np.sqrt(6.0)
    turns = poses[:-1, :3, :3].transpose(0, 2, 1) @ poses[1:, :3, :3]
    steps_rad = np.linalg.norm(np.diff(turns, axis=0), axis=(1, 2)) / np.sqrt(12.0)
    to_vector = np.sqrt(3.0) / MEDIAN_OF_NORM
    return float(np.median(steps_mm) * to_vector), float(np.median(steps_rad) * to_vector)
