"""Sessions of the simulated arm as the mathematics takes them, and the arm's true errors."""

from collections.abc import Sequence

import numpy as np

from crenel.metrology.arm.identification.observations import ArmObservations, Bar, Seat, Sphere
from crenel.metrology.arm.kinematics import Arm, Joint, Tip, tip_centres
from crenel.metrology.transforms import Floats, apply, rigid_fit
from crenel_hardware.simulator.devices.kinematics import ArmModel, flange_poses
from tests.simulated_arm_sessions import SimulatedArmSession


def nominal_arm(model: ArmModel) -> Arm:
    """The arm as its datasheet has it."""
    joints = (
        Joint(
            f"J{i + 1}",
            link.a_mm,
            link.alpha_rad,
            link.d_mm,
            link.theta_rad,
            link.sign,
            link.limits_rad,
            model.encoder_sd_rad,
        )
        for i, link in enumerate(model.links)
    )
    return Arm("arm", "A-1", tuple(joints), Tip(*model.tip_mm, model.tip_diameter_mm))


def collect_observations(session: SimulatedArmSession) -> ArmObservations:
    """What was touched."""
    seats: dict[str, list[Floats]] = {}
    for name, *q in session.articulation:
        seats.setdefault(str(name), []).append(_radians(q))
    spheres: dict[tuple[str, float], list[Floats]] = {}
    for name, diameter, *q in session.spheres:
        spheres.setdefault((str(name), _number(diameter)), []).append(_radians(q))
    bars: dict[tuple[str, str, float, float], dict[str, list[Floats]]] = {}
    for name, position, length, sd, end, *q in session.bars:
        bar = (str(name), str(position), _number(length), _number(sd))
        bars.setdefault(bar, {}).setdefault(str(end), []).append(_radians(q))
    return ArmObservations(
        tuple(Seat(name, np.array(q)) for name, q in seats.items()),
        tuple(Sphere(name, diameter, np.array(q)) for (name, diameter), q in spheres.items()),
        tuple(
            Bar(*bar, ("A", "B"), (np.array(ends["A"]), np.array(ends["B"])))
            for bar, ends in bars.items()
        ),
    )


def _radians(q: Sequence[object]) -> Floats:
    return np.radians([_number(angle) for angle in q])


def _number(value: object) -> float:
    assert isinstance(value, int | float)
    return float(value)


def fresh_poses(model: ArmModel, count: int = 400, seed: int = 12345) -> Floats:
    """Angles all over the joints' limits that no session has seen."""
    low, high = 0.8 * model.limits_rad.T
    return np.random.default_rng(seed).uniform(low, high, (count, model.joint_count))


def volumetric_error_um(true: ArmModel, arm: Arm) -> float:
    """Rms distance of the tips on fresh poses from where they truly are, base laid best."""
    q = fresh_poses(true)
    T = flange_poses(true, q)
    there = apply(T, np.tile(true.tip_mm, (len(q), 1)))
    here = tip_centres(arm, q)
    off = apply(rigid_fit(there, here), here) - there
    return 1e3 * float(np.sqrt(np.mean(np.sum(off**2, axis=1))))


def length_errors_um(true: ArmModel, arm: Arm) -> float:
    """Rms error of the distances between the tips of successive fresh poses."""
    q = fresh_poses(true)
    T = flange_poses(true, q)
    there = apply(T, np.tile(true.tip_mm, (len(q), 1)))
    here = tip_centres(arm, q)
    lengths = [np.linalg.norm(np.diff(points, axis=0), axis=1) for points in (there, here)]
    return 1e3 * float(np.sqrt(np.mean((lengths[1] - lengths[0]) ** 2)))
