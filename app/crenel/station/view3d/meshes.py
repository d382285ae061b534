"""Meshes for the 3D view, computed from numbers: tubes, the block, the sensor's field. Pure."""

from dataclasses import dataclass
from itertools import pairwise

import numpy as np
from numpy.typing import NDArray
from scipy.spatial import ConvexHull, QhullError

from crenel.metrology.arm.kinematics import AnyArm, Arm, Joint
from crenel.metrology.sensor.camera import Camera
from crenel.metrology.sensor.laser_plane import LaserPlane
from crenel.metrology.sensor.triangulation import sensor_points
from crenel.metrology.targets.chessboard import Chessboard
from crenel.metrology.targets.crenellated_block import Crenellated
from crenel.metrology.transforms import Floats

Faces = NDArray[np.uint32]
SIDES = 28
FIELD_SAMPLES = 33
BALL_ROWS = 24
# For a chessboard: thickness of its plate, and height at which the squares are drawn above it.
PLATE_MM, INK_MM = 5.0, 0.05


@dataclass(frozen=True)
class Mesh:
    """Vertices (N, 3) in mm and triangles (M, 3)."""

    vertices_mm: Floats
    faces: Faces


def join_meshes(*meshes: Mesh) -> Mesh:
    """Several meshes as one."""
    offsets = np.cumsum([0] + [len(mesh.vertices_mm) for mesh in meshes[:-1]])
    return Mesh(
        np.concatenate([mesh.vertices_mm for mesh in meshes]),
        np.concatenate(
            [mesh.faces + np.uint32(o) for mesh, o in zip(meshes, offsets, strict=True)]
        ),
    )


def tube(start_mm: Floats, end_mm: Floats, start_radius_mm: float, end_radius_mm: float) -> Mesh:
    """A closed, possibly tapered tube between two points (3,)."""
    start, end = np.asarray(start_mm, dtype=float), np.asarray(end_mm, dtype=float)
    axis = (end - start) / np.linalg.norm(end - start)
    aside = np.cross(axis, np.eye(3)[np.argmin(np.abs(axis))])
    aside /= np.linalg.norm(aside)
    turns = np.linspace(0, 2 * np.pi, SIDES, endpoint=False)
    ring = np.outer(np.cos(turns), aside) + np.outer(np.sin(turns), np.cross(axis, aside))
    # the ends have separate rings, for flat shading
    rings = [start + start_radius_mm * ring, end + end_radius_mm * ring]
    vertices = np.concatenate([*rings, *rings, start[None], end[None]])
    k = np.arange(SIDES)
    after = (k + 1) % SIDES
    first_cap, last_cap = 2 * SIDES + k, 3 * SIDES + k
    hub = np.full(SIDES, 4 * SIDES)
    faces = np.concatenate(
        [
            np.column_stack([k, after, SIDES + k]),
            np.column_stack([after, SIDES + after, SIDES + k]),
            np.column_stack([hub, 2 * SIDES + after, first_cap]),
            np.column_stack([hub + 1, last_cap, 3 * SIDES + after]),
        ]
    )
    return Mesh(vertices, faces.astype(np.uint32))


def box(low_mm: Floats, high_mm: Floats) -> Mesh:
    """A box with its edges along the axes; each face has separate corners."""
    low, high = np.asarray(low_mm, dtype=float), np.asarray(high_mm, dtype=float)
    vertices: list[Floats] = []
    faces: list[list[int]] = []
    for axis in range(3):
        for outward in (0, 1):
            b, c = (axis + 1) % 3, (axis + 2) % 3
            corners = np.empty((4, 3))
            corners[:, axis] = high[axis] if outward else low[axis]
            corners[:, b] = [low[b], high[b], high[b], low[b]]
            corners[:, c] = [low[c], low[c], high[c], high[c]]
            n = 4 * len(vertices)
            quad = [[n, n + 1, n + 2], [n, n + 2, n + 3]]
            vertices.append(corners)
            faces += quad if outward else [triangle[::-1] for triangle in quad]
    return Mesh(np.concatenate(vertices), np.array(faces, dtype=np.uint32))


def flat_mesh(corners_mm: Floats) -> Mesh:
    """A flat convex outline (K, 3), visible from both sides."""
    k = np.arange(1, len(corners_mm) - 1, dtype=np.uint32)
    return Mesh(corners_mm, np.column_stack([np.zeros_like(k), k, k + 1]))


def ball(centre_mm: Floats, radius_mm: float) -> Mesh:
    """A sphere, its poles along z."""
    rows = np.linspace(0.0, np.pi, BALL_ROWS + 1)
    turns = np.linspace(0.0, 2 * np.pi, 2 * BALL_ROWS, endpoint=False)
    row, turn = (grid.ravel() for grid in np.meshgrid(rows, turns, indexing="ij"))
    outward = np.column_stack([np.sin(row) * np.cos(turn), np.sin(row) * np.sin(turn), np.cos(row)])
    k = np.arange(BALL_ROWS * len(turns))
    after = k - k % len(turns) + (k + 1) % len(turns)
    below, below_after = k + len(turns), after + len(turns)
    faces = np.concatenate(
        [np.column_stack([k, below, after]), np.column_stack([after, below, below_after])]
    )
    return Mesh(centre_mm + radius_mm * outward, faces.astype(np.uint32))


def block_mesh(block: Crenellated) -> Mesh:
    """The crenellated object in its own frame: a body and its merlons."""
    x, front, back = block.edges_x_mm, block.front_y_mm, block.back_y_mm
    body = box(np.array([x[0], front, block.base_z_mm]), np.array([x[-1], back, block.floor_z_mm]))
    merlons = [
        box(
            np.array([x[2 * i], front, block.floor_z_mm]),
            np.array([x[2 * i + 1], back, block.crest_z_mm]),
        )
        for i in range(block.merlon_count)
    ]
    return join_meshes(body, *merlons)


def board_meshes(board: Chessboard) -> tuple[Mesh, Mesh]:
    """The chessboard in its own frame: its plate with a rim, and its black squares."""
    square = board.square_mm
    columns, rows = board.inner_corners
    plate = box(
        np.array([-2 * square, -2 * square, -PLATE_MM]),
        np.array([(columns + 1) * square, (rows + 1) * square, 0.0]),
    )
    black = [
        flat_mesh(square * np.array([[i, j, 0], [i + 1, j, 0], [i + 1, j + 1, 0], [i, j + 1, 0.0]]))
        for i in range(-1, columns)
        for j in range(-1, rows)
        if ((i + j) % 2 == 0) == board.first_is_black
    ]
    squares = join_meshes(*black)
    return plate, Mesh(squares.vertices_mm + [0.0, 0.0, INK_MM], squares.faces)


USUAL_REACH_MM = 1200.0
"""The usual reach of an arm that states poses, whose links are unknown."""


def reach_mm(arm: AnyArm) -> float:
    """Length of the arm stretched out."""
    if not isinstance(arm, Arm):
        return USUAL_REACH_MM
    return float(sum(np.hypot(joint.a_mm, joint.d_mm) for joint in arm.joints))


def link_path(joint: Joint) -> Floats:
    """The centre line (3, 3) of a link in its own frame: along the joint axis, then the normal.

    From the previous frame (Eq. 2): ``d`` along its z axis, then ``a`` along x.
    """
    corner = np.array([-joint.a_mm, 0.0, 0.0])
    axis = joint_axis(joint)
    return np.array([corner - joint.d_mm * axis, corner, np.zeros(3)])


def joint_axis(joint: Joint) -> Floats:
    """The joint axis (3,), z of the previous frame, in the link's own frame."""
    return np.array([0.0, np.sin(joint.alpha_rad), np.cos(joint.alpha_rad)])


def link_meshes(joint: Joint, radius_mm: float, end_radius_mm: float) -> tuple[Mesh | None, Mesh]:
    """The tubes of a link (None without length) and the hub of its joint, in the link's frame."""
    path = link_path(joint)
    tubes = [
        tube(a, b, radius_mm, end_radius_mm)
        for a, b in pairwise(path)
        if np.linalg.norm(b - a) > radius_mm
    ]
    half = 1.25 * radius_mm * joint_axis(joint)
    hub = tube(path[0] - half, path[0] + half, 1.3 * radius_mm, 1.3 * radius_mm)
    return (join_meshes(*tubes) if tubes else None), hub


def measuring_field(
    camera: Camera, plane: LaserPlane, depth_range_mm: tuple[float, float]
) -> Floats:
    """Outline (K, 3), in the sensor frame, of the part of the laser plane that the camera sees.

    Within the calibrated distances from the camera; empty if it sees none of it.
    """
    u = np.linspace(0, camera.width_px - 1, FIELD_SAMPLES)
    v = np.linspace(0, camera.height_px - 1, 4 * FIELD_SAMPLES)
    uv = np.stack(np.meshgrid(u, v), axis=-1).reshape(-1, 2)
    points = sensor_points(camera, plane, uv)
    points = points[np.isfinite(points).all(axis=1)]
    depth = np.linalg.norm(points - camera.centre_mm, axis=1)
    points = points[(depth >= depth_range_mm[0]) & (depth <= depth_range_mm[1])]
    if len(points) < 3:
        return np.zeros((0, 3))
    aside = np.cross(plane.normal, np.eye(3)[np.argmin(np.abs(plane.normal))])
    aside /= np.linalg.norm(aside)
    flat = points @ np.column_stack([aside, np.cross(plane.normal, aside)])
    try:
        return np.asarray(points[ConvexHull(flat).vertices])
    except QhullError:
        return np.zeros((0, 3))
