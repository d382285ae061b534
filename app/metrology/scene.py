"""Camera, laser plane and block as one set of parameters, and what a picture says of them."""

from collections.abc import Sequence
from dataclasses import dataclass, replace

import numpy as np

from app.metrology.camera import Camera, rays
from app.metrology.corners import Corner, EdgePoints
from app.metrology.crenellated import Crenellated, corners, edges
from app.metrology.frames import Floats
from app.metrology.laser_plane import LaserPlane, LaserPlaneFit, tangents
from app.metrology.projection import COUNT, PARAMETERS, project_with_jacobian, stepped
from app.metrology.stripe import Stripe

# After the camera's parameters come two tilts (rad) and the offset (mm) of the plane.
PLANE = slice(COUNT, COUNT + 3)
BLOCK = slice(COUNT + 3, None)


@dataclass(frozen=True)
class Scene:
    """What is adjusted: the sensor frame is the object frame of the certificate."""

    camera: Camera
    plane: LaserPlane
    block: Crenellated

    @property
    def names(self) -> tuple[str, ...]:
        """One name a parameter, in the order of ``moved`` and of every Jacobian."""
        block = [f"edge_x:{i}" for i in range(len(self.block.edges_x_mm))]
        block += ["front_y", "back_y", "crest_z", "floor_z", "base_z"]
        return (*PARAMETERS, "plane_a", "plane_b", "plane_offset", *block)

    def moved(self, step: Floats) -> "Scene":
        """The scene after adding ``step`` (P,) to its parameters."""
        normal = self.plane.normal + step[PLANE][:2] @ tangents(self.plane.normal)
        length = float(np.linalg.norm(normal))
        offset = (self.plane.offset_mm + step[PLANE][2]) / length
        block = with_coordinates(self.block, coordinates(self.block) + step[BLOCK])
        return Scene(
            stepped(self.camera, step[:COUNT]), LaserPlane(normal / length, float(offset)), block
        )


@dataclass(frozen=True)
class Rows:
    """Observation equations of one kind: residuals (N,) over sigma (N,), by the parameters.

    ``places`` (N, 2) are the pixels they were observed at, ``line`` (N,) numbers the
    straight line that each belongs to (one number for all corners).
    """

    residuals: Floats
    sigma: Floats
    jacobian: Floats  # (N, P): derivative of the residuals
    places: Floats
    line: Floats


def coordinates(block: Crenellated) -> Floats:
    """The certificate's numbers: edges in x, front, back, crest, floor, base."""
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


def _corner_numbers(block: Crenellated) -> dict[str, tuple[int, int, int]]:
    """Which of ``coordinates`` are the x, y, z of each corner."""
    n = len(block.edges_x_mm)
    where = np.arange(n + 5)
    numbered = with_coordinates(block, where.astype(np.float64))
    return {name: (int(at[0]), int(at[1]), int(at[2])) for name, at in corners(numbered).items()}


def _edge_numbers(block: Crenellated) -> dict[str, tuple[Floats, Floats]]:
    """Which of ``coordinates`` are the ends (3,) of each edge."""
    numbered = with_coordinates(block, np.arange(len(block.edges_x_mm) + 5).astype(np.float64))
    return {edge.name: (edge.start_mm, edge.end_mm) for edge in edges(numbered)}


def edge_rows(scene: Scene, measured: Sequence[EdgePoints]) -> Rows:
    """Points on the block's edges: their distances in px from the projected edges."""
    values, names = coordinates(scene.block), _edge_numbers(scene.block)
    rows = []
    for number, edge in enumerate(measured):
        a, b = (ends.astype(np.int64) for ends in names[edge.edge])
        start, along = values[a], values[b] - values[a]
        share = _nearest_share(scene.camera, edge.uv_px, start, along)
        by_block = np.zeros((len(share), 3, len(values)))
        for k in range(3):
            by_block[:, k, a[k]] += 1 - share
            by_block[:, k, b[k]] += share
        points = start + share[:, None] * along
        rows.append(
            _line_rows(scene, number, edge.uv_px, points, along, by_block, None, edge.sigma_px)
        )
    return joined(rows, len(scene.names))


def stripe_rows(scene: Scene, stripe: Stripe, fit: LaserPlaneFit) -> Rows:
    """Stripe points on the two straight lines in which the laser plane meets the levels."""
    values, plane = coordinates(scene.block), scene.plane
    rows = []
    for number, (name, at) in enumerate((("crest", -3), ("floor", -2))):
        chosen = fit.used & (fit.level == name)
        uv, z = stripe.uv_px[chosen], values[at]
        along = np.cross(plane.normal, [0.0, 0.0, 1.0])
        # across the line within the level: how it moves when the plane does
        across = np.array([*plane.normal[:2], 0.0]) / float(plane.normal[:2] @ plane.normal[:2])
        start = across * (plane.offset_mm - plane.normal[2] * z) + [0.0, 0.0, z]
        share = _nearest_share(scene.camera, uv, start, along)
        points = start + share[:, None] * along
        by_block = np.zeros((len(uv), 3, len(values)))
        by_block[:, :, at] = np.array([0.0, 0.0, 1.0]) - plane.normal[2] * across
        by_plane = np.empty((len(uv), 3, 3))
        tilts = points @ tangents(plane.normal).T
        by_plane[:, :, 0] = -tilts[:, :1] * across
        by_plane[:, :, 1] = -tilts[:, 1:] * across
        by_plane[:, :, 2] = across
        sigma = stripe.sigma_px[chosen]
        rows.append(_line_rows(scene, number, uv, points, along, by_block, by_plane, sigma))
        normal_share = _image_normal(scene.camera, points, along) @ stripe.across
        rows[-1] = replace(rows[-1], sigma=sigma * np.abs(normal_share))
    return joined(rows, len(scene.names))


def corner_rows(scene: Scene, measured: Sequence[Corner]) -> Rows:
    """Corners of the block: two rows each, along the axes of their covariance."""
    values, names = coordinates(scene.block), _corner_numbers(scene.block)
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
        np.zeros(2 * len(seen)),
    )


def joined(rows: Sequence[Rows], count: int) -> Rows:
    """Rows one under the other; ``count`` parameters where there are none."""
    if not rows:
        none = np.zeros(0)
        return Rows(none, none, np.zeros((0, count)), np.zeros((0, 2)), none)
    return Rows(
        np.concatenate([row.residuals for row in rows]),
        np.concatenate([row.sigma for row in rows]),
        np.concatenate([row.jacobian for row in rows]),
        np.concatenate([row.places for row in rows]),
        np.concatenate([row.line for row in rows]),
    )


def _nearest_share(camera: Camera, uv_px: Floats, start: Floats, along: Floats) -> Floats:
    """Where (N,) on ``start + share along`` the rays of pixels (N, 2) come nearest to it."""
    origin, rays_along = rays(camera, uv_px)
    normal = np.cross(rays_along, np.cross(rays_along, along))
    return np.asarray(np.sum((origin - start) * normal, axis=1) / (normal @ along))


def _image_normal(camera: Camera, points: Floats, along: Floats) -> Floats:
    """Unit normals (N, 2) in the image of a straight line of direction (3,), at its points."""
    _, _, by_point = project_with_jacobian(camera, points)
    tangent = by_point @ along
    tangent /= np.linalg.norm(tangent, axis=1, keepdims=True)
    return np.column_stack([-tangent[:, 1], tangent[:, 0]])


def _line_rows(
    scene: Scene,
    number: int,
    uv_px: Floats,
    points: Floats,
    along: Floats,
    by_block: Floats,
    by_plane: Floats | None,
    sigma_px: Floats,
) -> Rows:
    """Rows of pixels (N, 2) on one line; derivatives of the points (N, 3, .) on it."""
    uv, J_camera, by_point = project_with_jacobian(scene.camera, points)
    normal = _image_normal(scene.camera, points, along)
    to_normal = np.einsum("ni,nij->nj", normal, by_point)
    J = np.zeros((len(uv), len(scene.names)))
    J[:, :COUNT] = np.einsum("ni,nij->nj", normal, J_camera)
    J[:, BLOCK] = np.einsum("ni,nij->nj", to_normal, by_block)
    if by_plane is not None:
        J[:, PLANE] = np.einsum("ni,nij->nj", to_normal, by_plane)
    residuals = np.sum((uv_px - uv) * normal, axis=1)
    return Rows(residuals, sigma_px, -J, uv_px, np.full(len(uv), float(number)))
