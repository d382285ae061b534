"""A seat that holds the tip's centre, with the arm articulated about it."""

from collections.abc import Sequence
from contextlib import suppress

import numpy as np

from crenel_hardware.simulator.devices.kinematics import (
    ArmModel,
    Floats,
    UnreachableError,
    rotation_about,
)
from crenel_hardware.simulator.devices.motion import JointPath
from crenel_hardware.simulator.operator.gauge_operator import GaugeOperator
from crenel_hardware.simulator.operator.on_sphere import UP, path_onto_place

WAYS = 10
LEANS_RAD = (0.5, 0.8, 0.3)
"""Leans of the stylus from the vertical, tried in turn."""
BESIDE_RAD = (0.0, 0.3, -0.3, 0.8, -0.8, 1.5, -1.5, 2.3, -2.3)
"""About the vertical, tried in turn where the arm does not get to a way: far out it does not bend
back."""


def path_into_held_seat(
    arm: ArmModel,
    centre_mm: Floats,
    off_mm: float,
    number: int,
    q_rad: Floats,
    rng: np.random.Generator,
) -> JointPath:
    """From above a seat into it, with the stylus from the ``number``-th of ten sides.

    Args:
        centre_mm: (3,) where the seat holds the tip's centre, arm frame.
        off_mm: by how much this contact is off it.

    Raises:
        UnreachableError: the arm cannot do that with any posture tried.
    """
    for beside in BESIDE_RAD:
        for lean in LEANS_RAD:
            side = 2 * np.pi * number / WAYS + beside
            turned = rotation_about("z", side) @ rotation_about("y", lean)
            stylus = turned[:3, :3] @ UP
            with suppress(UnreachableError):
                return path_onto_place(arm, centre_mm, off_mm, UP, stylus, q_rad, rng)
    raise UnreachableError(f"the arm cannot get into the seat at {np.round(centre_mm).tolist()} mm")


class SeatOperator(GaugeOperator):
    """Puts the tip into a seat."""

    def touch_seat(self, centre_mm: Sequence[float], number: int) -> bool:
        """Puts the tip into a seat, with the arm articulated in the ``number``-th way, and presses
        the primary button; False when cancelled.

        Args:
            centre_mm: (3,) where the seat holds the tip's centre, arm frame.

        Raises UnreachableError where the arm cannot get there.
        """
        with self._executor.move("touching the seat"):
            # a seat holds the tip's centre: what a contact is off by is all that is left
            off_mm = self.planner.gap_mm() - self._arm.tip_diameter_mm / 2
            self._tap(
                lambda q: path_into_held_seat(
                    self._arm, np.asarray(centre_mm), off_mm, number, q, self._rng
                )
            )
            return True
        return False
