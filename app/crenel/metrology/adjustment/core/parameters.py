"""The unknowns of the adjustment, and how the picture of each pose depends on them."""

from dataclasses import dataclass, replace

import numpy as np

from crenel.metrology.adjustment.core.observations import AdjustmentProblem
from crenel.metrology.sensor.camera import Camera
from crenel.metrology.sensor.laser_plane import LaserPlane, in_frame, tangents
from crenel.metrology.sensor.projection import COUNT
from crenel.metrology.transforms import (
    Floats,
    adjoint_inverse,
    inverse,
    nearest_rotation,
    se3_exp,
    skew,
)

INTRINSIC = ("fx", "fy", "u0", "v0", "k1", "k2", "p1", "p2")
# Indices of the intrinsic parameters and of the pose's twist among ``projection.PARAMETERS``.
_INTRINSIC_AT = np.array([0, 1, 2, 3, 10, 11, 12, 13])
_POSE_AT = slice(4, 10)

CAMERA = slice(0, 8)
LENS = slice(4, 8)
PLANE = slice(8, 11)
MOUNT = slice(11, 17)
PLACE = slice(17, 23)
SENSOR = slice(0, 17)  # camera, plane and mounting: all that a reconstructed point depends on


@dataclass(frozen=True)
class ParameterLayout:
    """Indices of the unknowns: after the first 23, the object, the links, the noise."""

    coordinates: slice
    links: slice
    noise: slice
    noise_per_pose: int
    count: int

    def noise_slice(self, pose: int) -> slice:
        start = self.noise.start + pose * self.noise_per_pose
        return slice(start, start + self.noise_per_pose)


def parameter_layout(problem: AdjustmentProblem) -> ParameterLayout:
    first = PLACE.stop
    after_object = first + len(problem.prior.names)
    after_links = after_object + problem.motion.by_links.shape[2]
    per_pose = problem.motion.by_noise.shape[2]
    end = after_links + per_pose * len(problem.views)
    return ParameterLayout(
        slice(first, after_object),
        slice(after_object, after_links),
        slice(after_links, end),
        per_pose,
        end,
    )


@dataclass(frozen=True)
class AdjustmentState:
    """Values of all unknowns.

    ``camera`` has its own frame as sensor frame (no rotation, no translation), and
    ``plane`` lies in it: the laser's, or without any line the plane across the view at the distance
    of the object, on which points are then judged. ``links`` (6n,) and ``noise`` (P, n) are as in
    ``FlangeMotion``.
    """

    camera: Camera
    plane: LaserPlane
    T_flange_cam: Floats
    T_arm_obj: Floats
    coordinates: Floats
    links: Floats
    noise: Floats

    def apply_step(self, step: Floats, at: ParameterLayout) -> "AdjustmentState":
        """The state after a step of all unknowns: the mounting moves by a right twist, in the
        camera frame; the object by a left twist, in the arm frame."""
        return replace(
            self.apply_sensor_step(step[SENSOR]),
            T_arm_obj=_orthonormalise(se3_exp(step[PLACE]) @ self.T_arm_obj),
            coordinates=self.coordinates + step[at.coordinates],
            links=self.links + step[at.links],
            noise=self.noise + step[at.noise].reshape(self.noise.shape),
        )

    def apply_sensor_step(self, step: Floats) -> "AdjustmentState":
        """The state after a step (17,) of camera, plane and mounting alone."""
        camera = self.camera
        matrix, distortion = camera.matrix.copy(), camera.distortion.copy()
        matrix[0, 0] += step[0]
        matrix[1, 1] += step[1]
        matrix[:2, 2] += step[2:4]
        distortion[:4] += step[LENS]
        return replace(
            self,
            camera=replace(camera, matrix=matrix, distortion=distortion),
            plane=self.plane.apply_step(step[PLANE]),
            T_flange_cam=_orthonormalise(self.T_flange_cam @ se3_exp(step[MOUNT])),
        )


def _orthonormalise(T: Floats) -> Floats:
    T = T.copy()
    T[:3, :3] = nearest_rotation(T[:3, :3])
    return T


@dataclass(frozen=True)
class PoseScene:
    """One pose as its picture sees it: camera and plane in the object frame.

    ``by_unknowns`` (17 + B, U) are the derivatives of the camera's parameters and of the
    coordinates of plane and object by all unknowns.
    """

    camera: Camera
    plane: LaserPlane
    by_unknowns: Floats


def pose_scene(
    state: AdjustmentState, problem: AdjustmentProblem, at: ParameterLayout, pose: int
) -> PoseScene:
    """Camera and plane in the object frame for one pose (Eq. 6-8), with derivatives."""
    moves = problem.motion
    off = moves.by_links[pose] @ state.links + moves.by_noise[pose] @ state.noise[pose]
    T_arm_cam = se3_exp(off) @ moves.T_arm_flange[pose] @ state.T_flange_cam
    T_cam_obj = inverse(T_arm_cam) @ state.T_arm_obj
    camera, plane = in_frame(state.camera, state.plane, inverse(T_cam_obj))

    seen_from_cam = adjoint_inverse(T_arm_cam)
    twist = np.zeros((6, at.count))  # of T_cam_obj, from the left
    twist[:, MOUNT] = -np.eye(6)
    twist[:, PLACE] = seen_from_cam
    twist[:, at.links] = -seen_from_cam @ moves.by_links[pose]
    twist[:, at.noise_slice(pose)] = -seen_from_cam @ moves.by_noise[pose]

    count = len(state.coordinates)
    J = np.zeros((COUNT + 3 + count, at.count))
    J[_INTRINSIC_AT, np.arange(8)] = 1.0
    J[_POSE_AT] = twist
    _plane_rows(J[COUNT : COUNT + 3], state.plane, plane, T_cam_obj, twist)
    J[COUNT + 3 :, at.coordinates] = np.eye(count)
    return PoseScene(camera, plane, J)


def _plane_rows(
    J: Floats, in_cam: LaserPlane, in_obj: LaserPlane, T_cam_obj: Floats, twist: Floats
) -> None:
    """Fills in the derivatives of the plane in the object frame by that in the camera frame and by
    a twist."""
    R, t = T_cam_obj[:3, :3], T_cam_obj[:3, 3]
    n = in_cam.normal
    across = tangents(in_obj.normal) @ R.T  # tangents of the object, in the camera frame
    J[:2] = across @ skew(n) @ twist[:3]  # the normal rotates against the object
    J[:2, PLANE.start : PLANE.start + 2] += across @ tangents(n).T
    J[2] = -(skew(t) @ n @ twist[:3] + n @ twist[3:])
    J[2, PLANE.start : PLANE.start + 2] += -tangents(n) @ t
    J[2, PLANE.start + 2] += 1.0
