"""Camera, laser plane and block as one set of parameters, and their observation equations."""

from collections.abc import Sequence
from dataclasses import dataclass, replace
from functools import cache

import numpy as np
from numpy.typing import NDArray

from crenel.metrology.detection.detect_block import Corner, EdgePoints
from crenel.metrology.sensor.camera import Camera
from crenel.metrology.sensor.laser_plane import LaserPlane, tangents
from crenel.metrology.sensor.line_projection import across_lines, add_ends
from crenel.metrology.sensor.projection import COUNT, PARAMETERS, project_with_jacobian, step_camera
from crenel.metrology.stripe import Stripe
from crenel.metrology.targets.crenellated_block import Crenellated, corners, edges
from crenel.metrology.transforms import Floats

# The camera's parameters are followed by two tilts (rad) and the offset (mm) of the plane.
PLANE = slice(COUNT, COUNT + 3)
BLOCK = slice(COUNT + 3, None)
# Error that the points of an edge share and that noise does not show: shading beside the edge, a
# chamfer or burr, and the pixel grid if the edge runs along it.
SHARED_EDGE_PX = 0.015


@dataclass(frozen=True)
class SceneModel:
    """The unknowns of the adjustment; the sensor frame is the object frame of the certificate."""

    camera: Camera
    plane: LaserPlane
    block: Crenellated

    @property
    def names(self) -> tuple[str, ...]:
        """One name per parameter, in the order of ``moved`` and of every Jacobian."""
        block = [f"edge_x:{i}" for i in range(len(self.block.edges_x_mm))]
        block += ["front_y", "back_y", "crest_z", "floor_z", "base_z"]
        return (*PARAMETERS, "plane_a", "plane_b", "plane_offset", *block)

    def apply_step(self, step: Floats) -> "SceneModel":
        """The scene after adding ``step`` (P,) to its parameters."""
        block = with_coordinates(self.block, coordinates(self.block) + step[BLOCK])
        return SceneModel(
            step_camera(self.camera, step[:COUNT]), self.plane.apply_step(step[PLANE]), block
        )


@dataclass(frozen=True)
class Rows:
    """Observation equations of one kind: residuals (N,) over sigma (N,), by the parameters.

    ``places`` (N, 2) are the observed pixels, ``line`` (N,) the number of the straight line to
    which each belongs (one number for all corners); ``shared_px`` is the standard deviation of an
    error that all points of one line share, and ``shared`` (N, S) the derivatives of points by S
    more such errors, each with standard deviation 1.
    """

    residuals: Floats
    sigma: Floats
    jacobian: Floats  # (N, P): derivative of the residuals
    places: Floats
    line: NDArray[np.int64]
    shared_px: float = 0.0
    shared: Floats | None = None


def coordinates(block: Crenellated) -> Floats:
    """The coordinates of the certificate: edges in x, front, back, crest, floor, base."""
    return np.array(
        [
            *block.edges_x_mm,
            block.front_y_mm,
            block.back_y_mm,
            block.crest_z_mm,
            block.floor_z_mm,
            block.base_z_mm,
        ]
    )


def with_coordinates(block: Crenellated, values: Floats) -> Crenellated:
    front, back, crest, floor, base = (float(value) for value in values[-5:])
    return replace(
        block,
        edges_x_mm=tuple(float(value) for value in values[:-5]),
        front_y_mm=front,
        back_y_mm=back,
        crest_z_mm=crest,
        floor_z_mm=floor,
        base_z_mm=base,
    )


@cache
def _corner_numbers(count: int) -> dict[str, tuple[int, int, int]]:
    """Indices, among ``count`` ``coordinates``, of the x, y, z of each corner."""
    at = corners(_number_coordinates(count))
    return {name: (int(x), int(y), int(z)) for name, (x, y, z) in at.items()}


@cache
def _edge_numbers(count: int) -> dict[str, NDArray[np.int64]]:
    """Indices, among ``count`` ``coordinates``, of the ends (2, 3) of each edge."""
    return {
        edge.name: np.array([edge.start_mm, edge.end_mm]).astype(np.int64)
        for edge in edges(_number_coordinates(count))
    }


def _number_coordinates(count: int) -> Crenellated:
    """A block in which each coordinate is its own index."""
    *x, front, back, crest, floor, base = (float(number) for number in range(count))
    return Crenellated("", "", tuple(x), front, back, crest, floor, base, 0.0)


def edge_rows(scene: SceneModel, measured: Sequence[EdgePoints]) -> Rows:
    """Points on the block's edges: their distances in px from the projected edges."""
    values = coordinates(scene.block)
    names = _edge_numbers(len(values))
    line = np.repeat(np.arange(len(measured)), [len(edge.uv_px) for edge in measured])
    ends = np.array([names[edge.edge] for edge in measured])[line]  # (N, 2, 3)
    uv = np.concatenate([edge.uv_px for edge in measured])
    start = values[ends[:, 0]]
    along = values[ends[:, 1]] - start
    residuals, _, J, by_points, share = across_lines(
        scene.camera, uv, start, along, BLOCK.start + len(values)
    )
    add_ends(J, by_points, share, ends, BLOCK.start)
    sigma = np.concatenate([edge.sigma_px for edge in measured])
    return Rows(residuals, sigma, J, uv, line, SHARED_EDGE_PX)


def stripe_rows(scene: SceneModel, stripe: Stripe, level: NDArray[np.str_]) -> Rows:
    """Stripe points on the two straight lines in which the laser plane intersects the levels.

    ``level`` (N,) is ``crest``, ``floor``, or empty for points that do not count.
    """
    plane = scene.plane
    used = level != ""
    uv, sigma = stripe.uv_px[used], stripe.sigma_px[used]
    line = (level[used] == "floor").astype(np.int64)
    z = np.array([scene.block.crest_z_mm, scene.block.floor_z_mm])[line]
    # across the line within its level: motion of the line with the plane
    across = np.array([*plane.normal[:2], 0.0]) / float(plane.normal[:2] @ plane.normal[:2])
    along = np.full((len(uv), 3), [plane.normal[1], -plane.normal[0], 0.0])
    start = (plane.offset_mm - plane.normal[2] * z)[:, None] * across
    start[:, 2] = z
    count = BLOCK.start + len(scene.block.edges_x_mm) + 5
    residuals, normal, J, by_points, share = across_lines(scene.camera, uv, start, along, count)
    tilts = (start + share[:, None] * along) @ tangents(plane.normal).T
    by_offset = by_points @ across
    J[:, PLANE.start : PLANE.start + 2] = -tilts * by_offset[:, None]
    J[:, PLANE.start + 2] = by_offset
    level = np.array([count - 3, count - 2])[line]
    J[np.arange(len(uv)), level] += by_points[:, 2] - plane.normal[2] * by_offset
    return Rows(residuals, sigma * np.abs(normal @ stripe.across), J, uv, line)


def corner_rows(scene: SceneModel, measured: Sequence[Corner]) -> Rows:
    """Corners of the block: two rows each, along the axes of their covariance."""
    values = coordinates(scene.block)
    names = _corner_numbers(len(values))
    where = np.array([names[corner.name] for corner in measured])
    uv, J_camera, by_point = project_with_jacobian(scene.camera, values[where])
    seen = np.array([[corner.u, corner.v] for corner in measured])
    variance, axes = np.linalg.eigh(np.array([corner.covariance_px2 for corner in measured]))
    J = np.zeros((len(seen), 2, len(scene.names)))
    J[:, :, :COUNT] = J_camera
    for k in range(3):
        J[np.arange(len(seen)), :, BLOCK.start + where[:, k]] += by_point[:, :, k]
    turned = np.swapaxes(axes, 1, 2)
    residuals = np.einsum("nij,nj->ni", turned, seen - uv)
    return Rows(
        residuals.ravel(),
        np.sqrt(variance).ravel(),
        -(turned @ J).reshape(2 * len(seen), -1),
        np.repeat(seen, 2, axis=0),
        np.zeros(2 * len(seen), dtype=np.int64),
    )


def empty_rows(scene: SceneModel) -> Rows:
    """The equations if nothing of a kind was observed."""
    none = np.zeros(0)
    return Rows(
        none, none, np.zeros((0, len(scene.names))), np.zeros((0, 2)), none.astype(np.int64)
    )
