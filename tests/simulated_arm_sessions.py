"""Sessions that identify an arm's own geometry, with their truth, rendered into a folder.

The tip sits in seats about the volume while the arm swings around it, touches
calibrated spheres from every side, and sits on both ends of ball bars (a plan like
B89.4.22's). The folder is what an operator would bring (docs/formats.md); the arm as truly
built is returned, for those who check.
"""

from collections.abc import Callable, Iterator
from contextlib import suppress
from dataclasses import dataclass
from pathlib import Path
from typing import TypeVar

import numpy as np

from crenel_hardware.simulator.devices.kinematics import (
    ArmModel,
    Floats,
    UnreachableError,
    perturb_arm,
    rotation_about,
    solve_joints,
)
from crenel_hardware.simulator.scene.datasheets import arm_datasheet, write_document, write_table
from crenel_hardware.simulator.scene.random_scenes import random_arm

TRIES = 60
MAX_LEAN_RAD = 1.2
"""The stylus leans at most so far from the way it stands in the middle of a swing."""


@dataclass(frozen=True)
class ArmSessionPlan:
    """What is touched, and how well; everything else follows from the seed."""

    joints: int = 6
    imperfection_um: float = 250.0
    """Rms error of the tip over the arm's reach that its datasheet does not state."""
    seats: int = 8
    points_per_seat: int = 24
    spheres: int = 3
    points_per_sphere: int = 25
    sphere_diameter_mm: float = 25.0
    bar_lengths_mm: tuple[float, ...] = (500.0, 900.0)
    positions_per_bar: int = 6
    points_per_end: int = 5
    touch_sd_mm: float = 0.003
    """Of the tip in a seat, along each axis, and against a sphere."""
    bar_sd_mm: float = 0.002
    """Of a bar's calibrated length against its true one."""
    encoder_noise: bool = True


@dataclass(frozen=True)
class SimulatedArmSession:
    """One arm as truly built, its datasheet, and the rows of its tables."""

    arm: ArmModel
    nominal_arm: ArmModel
    articulation: list[list[object]]
    spheres: list[list[object]]
    bars: list[list[object]]


T = TypeVar("T")


def render_arm_session(
    folder: Path, seed: int, plan: ArmSessionPlan | None = None, arm: ArmModel | None = None
) -> SimulatedArmSession:
    """Writes ``arm.json`` and the tables of an identification; returns what is true.

    Args:
        folder: made where it is missing; files of these names are replaced.
        seed: another number, another arm and other places.
        arm: the arm as its datasheet has it, drawn at random where not given.
    """
    plan = plan or ArmSessionPlan()
    session = draw_arm_session(seed, plan, arm)
    folder.mkdir(parents=True, exist_ok=True)
    write_document(folder / "arm.json", arm_datasheet(session.nominal_arm))
    angles = [f"q{i + 1}_deg" for i in range(session.arm.joint_count)]
    tables = (
        ("articulation.csv", ["set"], session.articulation),
        ("spheres.csv", ["sphere", "diameter_mm"], session.spheres),
        (
            "ballbars.csv",
            ["bar", "position", "length_mm", "standard_uncertainty_mm", "end"],
            session.bars,
        ),
    )
    for name, columns, rows in tables:
        if rows:
            write_table(folder / name, [*columns, *angles], rows)
    return session


def draw_arm_session(
    seed: int, plan: ArmSessionPlan, arm: ArmModel | None = None
) -> SimulatedArmSession:
    """A session for a seed, in memory."""
    rng = np.random.default_rng(seed)
    nominal = arm or random_arm(rng, plan.joints)
    true = perturb_arm(nominal, plan.imperfection_um, rng)
    prober = _ArmProber(true, plan, rng)
    seats = [
        [f"S{k + 1}", *prober.reads(q)]
        for k in range(plan.seats)
        for q in prober.swing_anywhere(plan.points_per_seat)
    ]
    spheres = [
        [f"K{k + 1}", plan.sphere_diameter_mm, *prober.reads(q)]
        for k in range(plan.spheres)
        for q in prober.around_a_sphere_anywhere()
    ]
    return SimulatedArmSession(true, nominal, seats, spheres, list(_bar_rows(prober, plan)))


def _bar_rows(prober: "_ArmProber", plan: ArmSessionPlan) -> Iterator[list[object]]:
    for k, length in enumerate(plan.bar_lengths_mm):
        true_length = length + float(prober.rng.normal(0.0, plan.bar_sd_mm))
        for position in range(plan.positions_per_bar):
            for end, swing in zip("AB", prober.bar_anywhere(true_length), strict=True):
                known = [f"B{k + 1}", position + 1, length, plan.bar_sd_mm, end]
                for q in swing:
                    yield [*known, *prober.reads(q)]


class _ArmProber:
    """Moves the true arm as an operator would, wherever its tip is to be."""

    def __init__(self, arm: ArmModel, plan: ArmSessionPlan, rng: np.random.Generator) -> None:
        self.arm, self.plan, self.rng = arm, plan, rng
        tip = np.linalg.norm(arm.tip_mm)
        self.span = float(tip + sum(np.hypot(link.a_mm, link.d_mm) for link in arm.links[1:]))
        self.shoulder_z = arm.links[0].d_mm

    def reads(self, q_rad: Floats) -> list[float]:
        """What the encoders say, in degrees."""
        sd = self.arm.encoder_sd_rad if self.plan.encoder_noise else 0.0
        return list(np.degrees(q_rad + self.rng.normal(0.0, 1.0, len(q_rad)) * sd))

    def swing_anywhere(self, count: int) -> list[Floats]:
        """The tip in a seat somewhere in the volume, the arm swung about it."""
        return self._until_reached(lambda: self.swing(self.somewhere(), count))

    def around_a_sphere_anywhere(self) -> list[Floats]:
        """Touches all over the upper half of a sphere and a little below its equator."""
        return self._until_reached(lambda: self._around(self.somewhere()))

    def bar_anywhere(self, length_mm: float) -> list[list[Floats]]:
        """The tip in the seats of both ends of a bar, somewhere in the volume."""

        def both() -> list[list[Floats]]:
            middle, along = self.somewhere(), self.rng.normal(size=3)
            half = along / np.linalg.norm(along) * length_mm / 2
            ends = (middle - half, middle + half)
            return [self.swing(end, self.plan.points_per_end) for end in ends]

        return self._until_reached(both)

    def somewhere(self) -> Floats:
        """(3,) a place that the arm reaches comfortably, arm frame."""
        rng = self.rng
        bearing, rise = rng.uniform(-np.pi, np.pi), rng.uniform(-0.5, 0.7)
        distance = self.span * rng.uniform(0.3, 0.85)
        flat = distance * np.cos(rise)
        return np.array(
            [
                flat * np.cos(bearing),
                flat * np.sin(bearing),
                self.shoulder_z + distance * np.sin(rise),
            ]
        )

    def swing(self, centre_mm: Floats, count: int) -> list[Floats]:
        """Joint angles that hold the tip at one place, the stylus leaning every way, half of them
        in another posture, as from the elbow on one side to the other."""
        path: list[Floats] = []
        q = self._posture()
        leaning = self._leaning(centre_mm)
        for k in range(count):
            if 0 < k == count // 2:
                q = self._posture()
            seated = centre_mm + self.rng.normal(0.0, 1.0, 3) * self.plan.touch_sd_mm
            q = self._solve_joints(seated, leaning, q)
            path.append(q)
        return path

    def _around(self, centre_mm: Floats) -> list[Floats]:
        path: list[Floats] = []
        q = self._posture()
        leaning = self._leaning(centre_mm)
        radius = (self.plan.sphere_diameter_mm + self.arm.tip_diameter_mm) / 2
        for k in range(self.plan.points_per_sphere):
            height = 1.0 - 1.25 * (k + 0.5) / self.plan.points_per_sphere
            round_ = 2.399963 * k
            flat = np.sqrt(1 - height**2)
            outward = np.array([flat * np.cos(round_), flat * np.sin(round_), height])
            gap = radius + self.rng.normal(0.0, self.plan.touch_sd_mm)
            q = self._solve_joints(centre_mm + gap * outward, leaning, q)
            path.append(q)
        return path

    def _solve_joints(self, tip_mm: Floats, leaning: Floats, q_rad: Floats) -> Floats:
        """Joint angles (n,) with the tip's centre at a place; the stylus as it comes."""
        for _ in range(TRIES):
            R = leaning @ rotation_about("x", float(self.rng.uniform(-1, 1) * MAX_LEAN_RAD))
            R = R @ rotation_about("y", float(self.rng.uniform(-1, 1) * MAX_LEAN_RAD))
            R = R @ rotation_about("z", float(self.rng.uniform(-np.pi, np.pi)))
            target = R.copy()
            target[:3, 3] = tip_mm - R[:3, :3] @ np.array(self.arm.tip_mm)
            with suppress(UnreachableError):
                return solve_joints(self.arm, target, q_rad, self.rng, attempts=2)
        raise UnreachableError(f"the tip does not reach {np.round(tip_mm, 1).tolist()} mm")

    def _leaning(self, centre_mm: Floats) -> Floats:
        """(4, 4) rotation of a flange that points outward and down at a place."""
        bearing = float(np.arctan2(centre_mm[1], centre_mm[0]))
        return np.asarray(rotation_about("z", bearing) @ rotation_about("y", 2.2))

    def _posture(self) -> Floats:
        limits = self.arm.limits_rad
        return self.rng.uniform(limits[:, 0], limits[:, 1]) * 0.8

    def _until_reached(self, attempt: Callable[[], T]) -> T:
        for _ in range(TRIES):
            with suppress(UnreachableError):
                return attempt()
        raise UnreachableError("the arm reaches none of the places tried")
