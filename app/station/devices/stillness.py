"""Whether the arm is held still, from its joints, allowing for the encoders' noise."""

from dataclasses import dataclass

import numpy as np

from app.messages.message import Quantity, Text, message, quantity
from app.metrology.arm.joint_interpolation import shortest_turn
from app.metrology.arm.kinematics import Arm, flange_poses, geometric_jacobian
from app.metrology.transforms import Floats
from app.station.devices.joint_buffer import JointWindow

WINDOW_S = 0.3
TIP_LIMIT_UM = 40.0
TURN_LIMIT_ARCSEC = 60.0
BLOCKS = 6
FEWEST_SAMPLES = 6
# Limit of the distance between block means of pure noise, in standard deviations of one mean: the
# expected range of six is 2.5, and 5 is exceeded less than once in 500.
NOISE_RANGE = 5.0
ARCSEC_PER_RAD = 180 * 3600 / np.pi


@dataclass(frozen=True)
class Stillness:
    """How far the arm moved over a window, and whether that counts as still."""

    still: bool
    moved_um: float
    turned_arcsec: float
    text: Text


UNKNOWN = Stillness(False, float("nan"), float("nan"), message("too-little-arm-data-yet"))


def stillness(arm: Arm, window: JointWindow) -> Stillness:
    """How far the tip moved and the flange (with the sensor) turned.

    The samples of the window are averaged in six blocks, and the largest distance between two
    blocks counts. Encoder noise therefore does not look like motion, and the limit is increased by
    the effect of the arm's stated noise on such means.
    """
    if len(window) < FEWEST_SAMPLES:
        return UNKNOWN
    count = min(BLOCKS, len(window) // 2)
    first = window.q_rad[0]
    blocks = [
        first + shortest_turn(part - first).mean(axis=0)
        for part in np.array_split(window.q_rad, count)
    ]
    poses = flange_poses(arm, np.array(blocks))
    tips = poses[:, :3, :3] @ arm.tip.centre_mm + poses[:, :3, 3]
    moved_um = 1000 * _widest(tips)
    turned_arcsec = _widest_turn(poses[:, :3, :3]) * ARCSEC_PER_RAD
    noise_um, noise_arcsec = _noise(arm, first, len(window) // count)
    still = moved_um <= TIP_LIMIT_UM + noise_um and turned_arcsec <= (
        TURN_LIMIT_ARCSEC + noise_arcsec
    )
    return Stillness(still, moved_um, turned_arcsec, _words(still, moved_um, turned_arcsec, window))


def _words(still: bool, moved_um: float, turned_arcsec: float, window: JointWindow) -> Text:
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


def _noise(arm: Arm, q_rad: Floats, samples_a_block: int) -> tuple[float, float]:
    """The amount by which encoder noise alone moves (µm) and turns (arcsec) the means of blocks."""
    jacobian = geometric_jacobian(arm, q_rad, arm.tip.centre_mm)
    sd = np.sqrt(((jacobian * arm.encoder_sd_rad) ** 2).reshape(2, 3, -1).sum(axis=(1, 2)))
    scale = NOISE_RANGE / np.sqrt(samples_a_block)
    return float(1000 * sd[0] * scale), float(sd[1] * ARCSEC_PER_RAD * scale)
