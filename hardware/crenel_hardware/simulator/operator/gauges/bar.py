"""The ball bar that the simulated operator sets up about the arm's reach, touches and scans; it is
rendered while it is scanned."""

from collections.abc import Sequence
from contextlib import suppress
from dataclasses import replace
from functools import cached_property
from itertools import product

import numpy as np

from crenel_hardware.simulator.devices.kinematics import (
    ArmModel,
    Floats,
    UnreachableError,
    rotation_about,
    translation,
)
from crenel_hardware.simulator.devices.motion import JointPath
from crenel_hardware.simulator.operator.gauge_operator import GaugeOperator
from crenel_hardware.simulator.operator.on_sphere import LEANS, UP, path_onto_place, unit_vector
from crenel_hardware.simulator.operator.swinging import BAR_MM, SPHERE_MM
from crenel_hardware.simulator.scene.datasheets import GAUGE_SD_MM, NO_EXPANSION, JsonObject
from crenel_hardware.simulator.scene.world import Box, GaugeSphere, SceneObject, SimulatedScene

ROD_SHARE = 0.35
"""Half the width of the rod between the spheres, as a share of their radius."""
INTO_SHARE = 0.9
"""The rod begins so far from the middle of a sphere, as a share of its radius."""
TOUCHES = 4
DIRECTIONS = 400
LOWEST = -0.1
"""Over a sphere's middle, as a share of its radius, that is touched."""
ROD_DEG = 40.0
"""Touches keep this far from the rod."""
TURNS_RAD = (0.0, 0.3, -0.3)
"""About the vertical, tried in turn where the arm does not get to a place."""
STYLI = (0.7, 2.0, 0.2)
"""How much of the stylus' direction is up; the rest is out of the sphere."""
GOLDEN_RAD = np.pi * (3.0 - np.sqrt(5.0))


def ball_bar_datasheet() -> JsonObject:
    """The file of a length standard as the ball bar's certificate has it."""
    return {
        "format": "crenel/length-standard",
        "version": 1,
        "kind": "ball-bar",
        "name": "Simulated ball bar",
        "serial_number": "TWIN-L2",
        "certificate": "simulated",
        "sphere_diameter_mm": SPHERE_MM,
        "sphere_form_um": 1.0,
        **NO_EXPANSION,
        "lengths": [{"length_mm": BAR_MM, "standard_uncertainty_um": 1e3 * GAUGE_SD_MM}],
    }


def bar_ends(middle_mm: Floats, along: Floats, length_mm: float) -> Floats:
    """(2, 3) the spheres' centres of a bar about its middle along a direction (3,)."""
    direction = along / np.linalg.norm(along)
    return np.asarray(middle_mm + np.array([[-0.5], [0.5]]) * length_mm * direction)


def with_bar(scene: SimulatedScene, ends_mm: Floats, diameter_mm: float) -> SimulatedScene:
    """A scene in which a bar is set up, by its spheres' centres (2, 3), arm frame."""
    radius_mm = diameter_mm / 2
    turn = _frame_along(ends_mm[1] - ends_mm[0])
    poses = [turn.copy() for _ in ends_mm]
    for T, centre in zip(poses, ends_mm, strict=True):
        T[:3, 3] = centre
    half, start = ROD_SHARE * radius_mm, INTO_SHARE * radius_mm
    rod_mm = float(np.linalg.norm(ends_mm[1] - ends_mm[0])) - start
    ball = GaugeSphere(radius_mm)
    things = (
        SceneObject("bar sphere 1", ball, poses[0], 0.85),
        SceneObject("bar sphere 2", ball, poses[1], 0.85),
        SceneObject("bar rod", Box((-half, -half, start), (half, half, rod_mm)), poses[0], 0.3),
    )
    return replace(scene, objects=(*scene.objects, *things))


def _frame_along(direction: Floats) -> Floats:
    """A pose (4, 4) at the origin whose z axis has a direction (3,)."""
    z = direction / np.linalg.norm(direction)
    x = np.cross([0.0, 0.0, 1.0] if abs(z[2]) < 0.9 else [1.0, 0.0, 0.0], z)
    x /= np.linalg.norm(x)
    T = np.eye(4)
    T[:3, :3] = np.column_stack([x, np.cross(z, x), z])
    return T


def touch_directions(rod: Floats) -> Floats:
    """(4, 3) unit directions from the middle of a sphere to its touches: all around its upper
    half, away from the rod, which leaves it in a direction (3,)."""
    z = np.linspace(1.0, LOWEST, DIRECTIONS)
    turn, flat = GOLDEN_RAD * np.arange(DIRECTIONS), np.sqrt(1.0 - z**2)
    around = np.column_stack([flat * np.cos(turn), flat * np.sin(turn), z])
    free = around[around @ (rod / np.linalg.norm(rod)) < np.cos(np.radians(ROD_DEG))]
    chosen = [free[0]]
    while len(chosen) < TOUCHES:  # each as far from those before as can be
        nearest = np.min(np.linalg.norm(free[:, None] - np.array(chosen), axis=2), axis=1)
        chosen.append(free[int(np.argmax(nearest))])
    return np.array(chosen)


def path_onto_bar(
    arm: ArmModel,
    ends_mm: Floats,
    end: int,
    touch: int,
    gap_mm: float,
    q_rad: Floats,
    rng: np.random.Generator,
) -> JointPath:
    """From outside a sphere of the bar straight onto one of its four places, or one beside it.

    Args:
        ends_mm: (2, 3) the spheres' centres, arm frame.
        gap_mm: of the ball and the tip together, with the error of this contact.

    Raises:
        UnreachableError: the arm cannot do that with any posture tried.
    """
    place = touch_directions(ends_mm[1 - end] - ends_mm[end])[touch % TOUCHES]
    for turn, up in product(TURNS_RAD, STYLI):
        outward = rotation_about("z", turn)[:3, :3] @ place
        with suppress(UnreachableError):
            stylus = outward + up * UP
            return path_onto_place(arm, ends_mm[end], gap_mm, outward, stylus, q_rad, rng)
    raise UnreachableError("the arm cannot touch the sphere of the bar there")


def view_directions(centre_mm: Floats, along: Floats) -> list[Floats]:
    """Unit directions (3,) across a bar from which a sphere is seen, the handiest first.

    Args:
        centre_mm: (3,) of the sphere, arm frame.
        along: (3,) the bar's direction.
    """
    direction = along / np.linalg.norm(along)
    to_arm = -np.array([centre_mm[0], centre_mm[1], 0.0])
    to_arm /= max(float(np.linalg.norm(to_arm)), 1.0)
    found = []
    for up, towards in LEANS:
        view = up * UP + towards * to_arm
        view = view - (view @ direction) * direction
        if np.linalg.norm(view) > 0.2:
            found.append(view / np.linalg.norm(view))
    return found


class BarOperator(GaugeOperator):
    """Touches and scans the ball bar."""

    @property
    def bar_mm(self) -> float:
        """The ball bar's length."""
        return BAR_MM

    @cached_property
    def _true_bar_mm(self) -> float:
        off = np.random.default_rng([self._seed, 1]).normal(0.0, GAUGE_SD_MM)
        return BAR_MM + float(off)

    def touch_bar(
        self, middle_mm: Sequence[float], along: Sequence[float], end: int, touch: int
    ) -> bool:
        """Touches the sphere at an end (0 or 1) of the ball bar at one of four places, from
        0, and presses the primary button; False when cancelled.

        Args:
            middle_mm: (3,) of the bar where it is set up, arm frame.
            along: (3,) its direction, arm frame.

        Raises UnreachableError where the arm cannot get there.
        """
        ends = bar_ends(np.asarray(middle_mm), np.asarray(along), self._true_bar_mm)
        with self._executor.move("touching the ball bar"):
            gap_mm = SPHERE_MM / 2 + self.planner.gap_mm()
            self._tap(lambda q: path_onto_bar(self._arm, ends, end, touch, gap_mm, q, self._rng))
            return True
        return False

    def scan_bar(
        self, middle_mm: Sequence[float], along: Sequence[float], slowness: float = 1.0
    ) -> bool:
        """Passes the sensor over both spheres of the ball bar, which is set up as of ``touch_bar``;
        False when cancelled.

        Args:
            slowness: by how much slower than usual.

        Raises UnreachableError where the arm cannot hold the sensor over a sphere.
        """
        direction = unit_vector(along)
        ends = bar_ends(np.asarray(middle_mm), direction, self._true_bar_mm)
        with self._executor.move("scanning the ball bar"):
            self._show(with_bar(self._scene, ends, SPHERE_MM))
            try:
                for begin, centre in zip((0.0, 0.5), ends, strict=True):
                    T, views = translation(*centre.tolist()), view_directions(centre, direction)
                    self._pass_over(T, SPHERE_MM / 2, views, slowness, (begin, begin + 0.5))
            finally:
                self._show(self._scene)
            return True
        return False
