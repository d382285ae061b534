"""Observations of the chessboard for the adjustment: its corners, and the laser line on its
surface."""

from dataclasses import dataclass, replace

import numpy as np
from numpy.typing import NDArray

from crenel.metrology.adjustment.board.surface import (
    around_pattern,
    bend_slice,
    corners_at,
    evaluate_surface,
    surface_height_mm,
)
from crenel.metrology.adjustment.core.robust_weights import (
    RobustWeights,
    bin_neighbours,
    unit_weights,
)
from crenel.metrology.calibration.observation_model import BLOCK, PLANE, Rows
from crenel.metrology.chessboard.board_detection import BoardDetection
from crenel.metrology.robust import median
from crenel.metrology.sensor.camera import Camera, rays
from crenel.metrology.sensor.laser_plane import LaserPlane, tangents
from crenel.metrology.sensor.projection import COUNT, project_with_jacobian
from crenel.metrology.stripe import Stripe, empty_stripe
from crenel.metrology.targets.chessboard import Chessboard, corner_grid
from crenel.metrology.transforms import Floats

# Points of a line are used if they are closer to it, across the laser plane, than this, and than
# this multiple of the usual distance.
OFF_PLANE_MM, OFF_PLANE_TIMES = 0.3, 5.0
# Iterations along a ray to the bent surface; each adds two digits.
BENT_ROUNDS = 3


@dataclass(frozen=True)
class BoardView:
    """The board in the picture of one pose; ``used`` (N,) marks the stripe points in use.

    ``scatter_px`` is the scatter of corners over all pictures: in addition to the noise, blur and
    print differ from corner to corner. ``line_off_mm`` and ``line_off_rad`` are the standard
    deviations of the offset and rotation of the line as a whole from the laser plane: the board
    bends, and the laser may have moved, by more than the points of one line show.
    """

    board: Chessboard
    detection: BoardDetection
    stripe: Stripe
    used: NDArray[np.bool_]
    scatter_px: float = 0.0
    line_off_mm: float = 0.0
    line_off_rad: float = 0.0

    def rows(self, camera: Camera, plane: LaserPlane, coordinates: Floats) -> tuple[Rows, Rows]:
        return (
            self.corner_rows(camera, coordinates),
            self._stripe_rows(camera, plane, coordinates),
        )

    def reclassify_stripe(
        self, camera: Camera, plane: LaserPlane, coordinates: Floats
    ) -> "BoardView":
        points = intersect_surface(self.board, camera, coordinates, self.stripe.uv_px)
        near = around_pattern(self.board, points)
        off = np.full(len(points), np.inf)
        off[near] = points[near] @ plane.normal - plane.offset_mm
        if near.any():
            off -= median(off[near])  # of the line as a whole, which may be off
        usual = median(np.abs(off[near])) if near.any() else 0.0
        return replace(self, used=np.abs(off) < max(OFF_PLANE_MM, OFF_PLANE_TIMES * usual))

    def bin_points(
        self, rows: tuple[Rows, Rows], judged: tuple[RobustWeights, RobustWeights]
    ) -> tuple["BoardView", tuple[RobustWeights, RobustWeights]]:
        used = np.flatnonzero(self.used)
        own = self.stripe.sigma_px[used]
        few = bin_neighbours(rows[1].places, own, rows[1].line, judged[1])
        u, v = few.uv_px.T
        intensity = self.stripe.intensity[used][few.first]
        stripe = Stripe(u, v, intensity, few.sigma_px, self.stripe.axis)
        view = replace(self, stripe=stripe, used=np.ones(len(u), dtype=np.bool_))
        return view, (judged[0], unit_weights(len(u)))

    def stripe_px(self) -> Floats:
        return np.asarray(self.stripe.uv_px[self.used])

    def without_line(self) -> "BoardView":
        return replace(
            self, stripe=empty_stripe(self.stripe.axis), used=np.zeros(0, dtype=np.bool_)
        )

    def _bend_columns(self) -> slice:
        own = bend_slice(self.board)
        return slice(BLOCK.start + own.start, BLOCK.start + own.stop)

    def corner_rows(self, camera: Camera, coordinates: Floats) -> Rows:
        """Observation equations of the corners: two per corner, along the axes of its
        covariance."""
        board, seen = self.board, self.detection
        count = len(corner_grid(board))
        at = corners_at(board, coordinates)[seen.number]
        uv, by_camera, by_point = project_with_jacobian(camera, at)
        variances, axes = np.linalg.eigh(seen.covariance_px2)
        along = axes.mT
        by_camera, by_point = -along @ by_camera, -along @ by_point
        J = np.zeros((len(at), 2, BLOCK.start + len(coordinates)))
        J[:, :, :COUNT] = by_camera
        bent = evaluate_surface(board, coordinates, at[:, :2])
        own = by_point[:, :, :2] + by_point[:, :, 2:] * bent.slope[:, None, :]  # by x and y
        share = (corner_grid(board) / (np.array(board.inner_corners) - 1))[seen.number]
        J[:, :, BLOCK.start : BLOCK.start + 2] = own * share[:, None, :]
        bends = self._bend_columns()
        J[:, :, bends] = by_point[:, :, 2:] * bent.by_bend[:, None, :]
        prints = bends.stop + seen.number
        every = np.arange(len(at))
        J[every, :, prints] = own[:, :, 0]
        J[every, :, prints + count] = own[:, :, 1]
        J[every, :, prints + 2 * count] = by_point[:, :, 2]
        return Rows(
            np.einsum("nki,ni->nk", along, seen.uv_px - uv).ravel(),
            np.sqrt(np.maximum(variances, self.scatter_px**2)).ravel(),
            J.reshape(-1, J.shape[2]),
            np.repeat(seen.uv_px, 2, axis=0),
            np.zeros(2 * len(at), dtype=np.int64),
        )

    def _stripe_rows(self, camera: Camera, plane: LaserPlane, coordinates: Floats) -> Rows:
        """Stripe points on the curve in which the laser's plane meets the surface.

        At each point, the surface is approximated by its tangent plane and the curve by a line.
        """
        uv, sigma = self.stripe.uv_px[self.used], self.stripe.sigma_px[self.used]
        on = intersect_surface(self.board, camera, coordinates, uv)
        bent = evaluate_surface(self.board, coordinates, on[:, :2])
        upright = np.column_stack([-bent.slope, np.ones(len(on))])
        upright /= np.linalg.norm(upright, axis=1, keepdims=True)
        n = plane.normal
        tilt = upright @ n
        sine2 = np.maximum(1 - tilt**2, 1e-12)[:, None]
        across = (n - tilt[:, None] * upright) / sine2  # of the line, for the plane's offset
        start = on + (plane.offset_mm - on @ n)[:, None] * across
        lifted = (upright - tilt[:, None] * n) / sine2 * upright[:, 2:]  # for the surface's height
        seen, by_camera, by_point = project_with_jacobian(camera, start)
        tangent = np.einsum("nij,nj->ni", by_point, np.cross(n, upright))
        tangent /= np.linalg.norm(tangent, axis=1, keepdims=True)
        normal = np.column_stack([-tangent[:, 1], tangent[:, 0]])
        J = np.zeros((len(uv), BLOCK.start + len(coordinates)))
        J[:, :COUNT] = np.einsum("ni,nip->np", normal, by_camera)
        to_normal = np.einsum("ni,nip->np", normal, by_point)
        by_offset = np.sum(to_normal * across, axis=1)
        J[:, PLANE.start : PLANE.start + 2] = -(start @ tangents(n).T) * by_offset[:, None]
        J[:, PLANE.start + 2] = by_offset
        by_height = np.sum(to_normal * lifted, axis=1)
        bends = self._bend_columns()
        J[:, bends] = by_height[:, None] * bent.by_bend
        residuals = np.sum((uv - seen) * normal, axis=1)
        return Rows(
            residuals,
            sigma * np.abs(normal @ self.stripe.across),
            -J,
            uv,
            np.zeros(len(uv), dtype=np.int64),
            shared=self._common_errors(on, by_offset),
        )

    def _common_errors(self, on_mm: Floats, px_per_mm: Floats) -> Floats | None:
        """(N, 2) derivatives of the points by the line's own offset and rotation, in standard
        deviations."""
        if not len(on_mm) or not self.line_off_mm:
            return None
        away = on_mm - on_mm.mean(axis=0)
        along = away @ np.linalg.svd(away, full_matrices=False)[2][0]
        ways = [np.full(len(on_mm), self.line_off_mm), along * self.line_off_rad]
        return np.asarray(px_per_mm[:, None] * np.column_stack(ways))


def intersect_surface(
    board: Chessboard, camera: Camera, coordinates: Floats, uv_px: Floats
) -> Floats:
    """Intersections (N, 3) of the rays of pixels (N, 2) with the bent surface, in the board
    frame."""
    origin, along = rays(camera, uv_px)
    height = np.zeros(len(uv_px))
    points = np.zeros((len(uv_px), 3))
    for _ in range(BENT_ROUNDS):
        points = origin + ((height - origin[2]) / along[:, 2])[:, None] * along
        near = np.clip(points[:, :2], -board.size_mm, 2 * board.size_mm)
        height = surface_height_mm(board, coordinates, near)
    return np.asarray(points)
