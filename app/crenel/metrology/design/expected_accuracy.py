"""The accuracy that calibrations of a sensor on a block will have, before either exists.

Contact points and pictures are predicted without noise, and the noise that they would have is
propagated through the same adjustment that calibrates (the Cramér-Rao bound): many simulated
calibrations would scatter by as much. Where the block will stand and how the arm reaches it nobody
knows yet, and errors of the arm's links matter by that: the accuracy is the rms over places.
"""

from collections.abc import Iterator, Sequence
from contextlib import suppress
from dataclasses import dataclass, replace

import numpy as np

from crenel.errors import OperationError
from crenel.metrology.adjustment.block.observations import block_contacts, block_prior
from crenel.metrology.adjustment.block.predicted_view import ObservationNoise, predict_view
from crenel.metrology.adjustment.core.arm_errors import LEVER_MM, arm_motion, link_errors_mm
from crenel.metrology.adjustment.core.information import (
    exact_equations,
    solve_information,
    with_certificate,
)
from crenel.metrology.adjustment.core.linearise import NormalEquations
from crenel.metrology.adjustment.core.observations import AdjustmentProblem
from crenel.metrology.adjustment.core.parameters import AdjustmentState
from crenel.metrology.adjustment.core.uncertainty import point_budget, sensor_jacobian
from crenel.metrology.adjustment.core.variance_components import Scales
from crenel.metrology.arm.kinematics import Arm
from crenel.metrology.calibration.uncertainty_budget import BudgetContribution
from crenel.metrology.design.expected_contacts import contact_flanges, contact_places
from crenel.metrology.design.stripe_sensor import (
    StripeSensor,
    middle_height_mm,
    nominal_camera,
    nominal_plane,
    range_points,
)
from crenel.metrology.design.usual_arm import PLACES, arm_cannot_reach, table_places, take_postures
from crenel.metrology.sensor.camera import Camera, project
from crenel.metrology.sensor.laser_plane import LaserPlane, in_frame
from crenel.metrology.targets.crenellated_block import Crenellated
from crenel.metrology.transforms import Floats, inverse, rigid, rotation_from_vector

BIN_SIZE = 4
"""Points merged into one when a picture is predicted."""
TIP_OFF_MM, TOUCH_MM = 0.02, 0.005
"""Rms error of the arm's tip over its reach, and scatter of a contact."""
BEHIND_MM = 90.0
"""The sensor's camera and laser sit so far below the flange."""
ASIDE_MM = 57.0
"""The sensor sits beside the stylus."""
TILTS_DEG = (
    (0.0, 0.0, 0.0),
    (15.0, 0.0, 20.0),
    (-15.0, 0.0, -20.0),
    (0.0, 15.0, 25.0),
    (0.0, -15.0, -25.0),
    (10.0, 12.0, -10.0),
    (-10.0, 12.0, 10.0),
    (0.0, -8.0, 0.0),
)
"""Rotations of the sensor about X, Y and Z of the block in each pose, as the station advises."""
POSES = len(TILTS_DEG)


@dataclass(frozen=True)
class ExpectedAccuracy:
    """Standard uncertainty of a point of the measuring range, rms over it, by source; k = 1."""

    poses: int
    total_um: float
    rows: tuple[BudgetContribution, ...]


@dataclass(frozen=True)
class ExpectedSession:
    """A session that somebody could take: how the arm stands, without noise."""

    sensor: StripeSensor
    arm: Arm
    block: Crenellated
    T_arm_obj: Floats
    features: tuple[str, ...]
    contact_q_rad: Floats  # (N, n)
    q_rad: Floats  # (P, n)
    scales: Scales

    def with_block(self, block: Crenellated) -> "ExpectedSession":
        """Much the same session with another block, whose middle is where that of this one is.

        The contact points stay where they are, which is near enough to compare blocks.
        """
        up = np.eye(4)
        up[2, 3] = middle_height_mm(self.block) - middle_height_mm(block)
        return replace(self, block=block, T_arm_obj=self.T_arm_obj @ up)


@dataclass(frozen=True)
class Expectation:
    """What the first poses of sessions with one block would tell, each at another place.

    How well the block is known is not part of it.
    """

    poses: int
    equations: tuple[NormalEquations, ...]
    scales: Scales
    by_sensor: Floats  # (G, 3, S) derivatives of points of the measuring range

    def accuracy(self, size_sd_mm: float) -> ExpectedAccuracy:
        """The accuracy with a block whose sizes have a standard uncertainty.

        Returns:
            Standard uncertainty of a point over the sensor's measuring range, flange frame, k = 1,
            rms over the places.

        Raises:
            OperationError: ``adjustment-failed``, where the block does not determine the sensor.
        """
        budgets = [
            point_budget(solve_information(known, self.scales), self.by_sensor)
            for known in self._with_certificate(size_sd_mm)
        ]
        rows = tuple(
            BudgetContribution(same[0].source, _rms([row.value_um for row in same]))
            for same in zip(*(rows for rows, _ in budgets), strict=True)
        )
        return ExpectedAccuracy(self.poses, _rms([total_um for _, total_um in budgets]), rows)

    def _with_certificate(self, size_sd_mm: float) -> Iterator[NormalEquations]:
        for one in self.equations:
            prior = one.linear.problem.prior
            yield with_certificate(one, np.full(len(prior.sd), size_sd_mm))


def _rms(values: Sequence[float]) -> float:
    return float(np.sqrt(np.mean(np.square(values))))


def plan_sessions(
    sensor: StripeSensor, block: Crenellated, arm: Arm, most: int = PLACES
) -> tuple[ExpectedSession, ...]:
    """Sessions with the block on a table, one for each place at which the arm can do it.

    Args:
        sensor, block, arm: with which they are.
        most: after so many, no other place is tried.

    Raises:
        OperationError: ``arm-cannot-reach``, at no place.
    """
    size_mm = link_errors_mm(arm, TIP_OFF_MM)
    scales = Scales(size_mm / LEVER_MM, size_mm, 1.0, TOUCH_MM)
    sessions: list[ExpectedSession] = []
    for T_arm_obj in table_places():
        if len(sessions) == most:
            break
        with suppress(OperationError):
            sessions.append(_plan_at(sensor, block, arm, T_arm_obj, scales))
    if not sessions:
        raise arm_cannot_reach(arm)
    return tuple(sessions)


def _plan_at(
    sensor: StripeSensor, block: Crenellated, arm: Arm, T_arm_obj: Floats, scales: Scales
) -> ExpectedSession:
    features, spots = contact_places(block, arm.tip.radius_mm)
    contact_q = take_postures(arm, contact_flanges(arm, T_arm_obj, block, features, spots))
    q = take_postures(arm, T_arm_obj @ sensor_holds(block) @ inverse(nominal_mounting(sensor)))
    return ExpectedSession(sensor, arm, block, T_arm_obj, tuple(features), contact_q, q, scales)


def nominal_mounting(sensor: StripeSensor) -> Floats:
    """``T_flange_sensor`` (4, 4): the sensor beside the stylus, looking along it."""
    turned = np.diag([1.0, -1.0, -1.0])
    return rigid(turned, np.array([0.0, -ASIDE_MM, BEHIND_MM + sensor.standoff_mm]))


def sensor_holds(block: Crenellated) -> Floats:
    """``T_obj_sensor`` (P, 4, 4) of each pose, the sensor's origin in the middle of the grooves."""
    middle = np.array([0.0, 0.0, middle_height_mm(block)])
    return np.array([rigid(rotation_from_vector(np.radians(turn)), middle) for turn in TILTS_DEG])


def expect(sessions: Sequence[ExpectedSession], poses: int) -> Expectation:
    """What the first poses of sessions would tell.

    Args:
        sessions: of one sensor, arm and block, as from ``plan_sessions``.
        poses: how many of the poses are taken, 1 to ``POSES``.
    """
    equations = tuple(_equations(session, poses) for session in sessions)
    sensor = sessions[0].sensor
    uv = project(nominal_camera(sensor), range_points(sensor))
    by_sensor = sensor_jacobian(equations[0].linear.state, uv)
    return Expectation(poses, equations, sessions[0].scales, by_sensor)


def _equations(session: ExpectedSession, poses: int) -> NormalEquations:
    """The information of everything that would be measured, at the truth."""
    sensor, block, arm = session.sensor, session.block, session.arm
    camera, plane, T_flange_cam = _in_own_frame(sensor)
    moves = arm_motion(arm, session.q_rad[:poses])
    noise = ObservationNoise(axis=sensor.stripe_axis, bin_size=BIN_SIZE)
    T_obj_cam = inverse(session.T_arm_obj) @ moves.T_arm_flange @ T_flange_cam
    views = tuple(predict_view(*in_frame(camera, plane, T), block, noise) for T in T_obj_cam)
    everything = np.ones(len(session.features), dtype=np.bool_)
    problem = AdjustmentProblem(
        tuple(range(poses)),
        views,
        moves,
        block_contacts(arm, block, session.features, session.contact_q_rad, everything),
        block_prior(block),
        sensor.width_px,
        sensor.height_px,
    )
    state = AdjustmentState(
        camera,
        plane,
        T_flange_cam,
        session.T_arm_obj,
        problem.prior.coordinates,
        np.zeros(moves.by_links.shape[2]),
        np.zeros((poses, moves.by_noise.shape[2])),
    )
    return exact_equations(problem, state)


def _in_own_frame(sensor: StripeSensor) -> tuple[Camera, LaserPlane, Floats]:
    """Camera and plane in the camera's own frame, and ``T_flange_cam`` (4, 4)."""
    camera = nominal_camera(sensor)
    T_cam_sensor = rigid(camera.rotation, camera.translation_mm)
    camera, plane = in_frame(camera, nominal_plane(), T_cam_sensor)
    return camera, plane, nominal_mounting(sensor) @ inverse(T_cam_sensor)
