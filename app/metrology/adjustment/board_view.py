"""The chessboard as the adjustment sees it: its corners, and the laser's line on its sheet."""

from dataclasses import dataclass, replace

import numpy as np
from numpy.typing import NDArray

from app.metrology.adjustment.sheet import BEND, corners_at, surface
from app.metrology.adjustment.weighing import Judgement
from app.metrology.camera import Camera, rays
from app.metrology.chessboard.board import Chessboard, grid
from app.metrology.chessboard.corners import BoardDetection
from app.metrology.frames import Floats
from app.metrology.laser_plane import LaserPlane, tangents
from app.metrology.projection import COUNT, project_with_jacobian
from app.metrology.scene import BLOCK, PLANE, Rows
from app.metrology.stripe import Stripe

# The line is used on the pattern and this many squares around its outermost corners, where
# there must be paper (one square) or is likely to be; and where it is no further off the
# laser's plane than this, and than so many times the usual.
AROUND_SQUARES = 4.0
OFF_PLANE_MM, OFF_PLANE_TIMES = 0.3, 5.0
# Rounds of walking along a ray to the bent sheet: each gains two digits.
BENT_ROUNDS = 4


@dataclass(frozen=True)
class BoardView:
    """The board in the picture of one pose; ``used`` (N,) marks the stripe's points in use."""

    board: Chessboard
    detection: BoardDetection
    stripe: Stripe
    used: NDArray[np.bool_]

    def rows(self, camera: Camera, plane: LaserPlane, coordinates: Floats) -> tuple[Rows, Rows]:
        return (
            self._corner_rows(camera, coordinates),
            self._stripe_rows(camera, plane, coordinates),
        )

    def sorted_anew(self, camera: Camera, plane: LaserPlane, coordinates: Floats) -> "BoardView":
        points = on_sheet(self.board, camera, coordinates, self.stripe.uv_px)
        near = around_pattern(self.board, points, AROUND_SQUARES)
        off = np.full(len(points), np.inf)
        off[near] = points[near] @ plane.normal - plane.offset_mm
        usual = float(np.median(np.abs(off[near]))) if near.any() else 0.0
        return replace(self, used=np.abs(off) < max(OFF_PLANE_MM, OFF_PLANE_TIMES * usual))

    def merged(
        self, rows: tuple[Rows, Rows], judged: tuple[Judgement, Judgement]
    ) -> tuple["BoardView", tuple[Judgement, Judgement]]:
        return self, judged

    def stripe_px(self) -> Floats:
        return np.asarray(self.stripe.uv_px[self.used])

    def _corner_rows(self, camera: Camera, coordinates: Floats) -> Rows:
        """Two rows a corner, along the axes of its covariance."""
        board, seen = self.board, self.detection
        count = len(grid(board))
        at = corners_at(board, coordinates)[seen.number]
        uv, by_camera, by_point = project_with_jacobian(camera, at)
        J = np.zeros((len(at), 2, BLOCK.start + len(coordinates)))
        J[:, :, :COUNT] = by_camera
        bent = surface(board, coordinates, at[:, :2])
        own = by_point[:, :, :2] + by_point[:, :, 2:] * bent.slope[:, None, :]  # by x and y
        share = (grid(board) / (np.array(board.inner_corners) - 1))[seen.number]
        J[:, :, BLOCK.start : BLOCK.start + 2] = own * share[:, None, :]
        bends = slice(BLOCK.start + BEND.start, BLOCK.start + BEND.stop)
        J[:, :, bends] = by_point[:, :, 2:] * bent.by_bend[:, None, :]
        prints = bends.stop + seen.number
        every = np.arange(len(at))
        J[every, :, prints] = own[:, :, 0]
        J[every, :, prints + count] = own[:, :, 1]
        variances, axes = np.linalg.eigh(seen.covariance_px2)
        residuals = np.einsum("nik,ni->nk", axes, seen.uv_px - uv)
        turned = np.einsum("nik,nip->nkp", axes, J)
        return Rows(
            residuals.ravel(),
            np.sqrt(variances).ravel(),
            -turned.reshape(-1, J.shape[2]),
            np.repeat(seen.uv_px, 2, axis=0),
            np.zeros(2 * len(at), dtype=np.int64),
        )

    def _stripe_rows(self, camera: Camera, plane: LaserPlane, coordinates: Floats) -> Rows:
        """Stripe points on the curve in which the laser's plane meets the sheet.

        At each point the sheet is taken as its tangent plane, the curve as a straight line.
        """
        uv, sigma = self.stripe.uv_px[self.used], self.stripe.sigma_px[self.used]
        on = on_sheet(self.board, camera, coordinates, uv)
        bent = surface(self.board, coordinates, on[:, :2])
        upright = np.column_stack([-bent.slope, np.ones(len(on))])
        upright /= np.linalg.norm(upright, axis=1, keepdims=True)
        n = plane.normal
        tilt = upright @ n
        sine2 = np.maximum(1 - tilt**2, 1e-12)[:, None]
        across = (n - tilt[:, None] * upright) / sine2  # of the line, for the plane's offset
        start = on + (plane.offset_mm - on @ n)[:, None] * across
        lifted = (upright - tilt[:, None] * n) / sine2 * upright[:, 2:]  # for the sheet's height
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
        bends = slice(BLOCK.start + BEND.start, BLOCK.start + BEND.stop)
        J[:, bends] = by_height[:, None] * bent.by_bend
        residuals = np.sum((uv - seen) * normal, axis=1)
        return Rows(
            residuals,
            sigma * np.abs(normal @ self.stripe.across),
            -J,
            uv,
            np.zeros(len(uv), dtype=np.int64),
        )


def on_sheet(board: Chessboard, camera: Camera, coordinates: Floats, uv_px: Floats) -> Floats:
    """Where the rays of pixels (N, 2) meet the bent sheet: (N, 3) in the board's frame."""
    origin, along = rays(camera, uv_px)
    height = np.zeros(len(uv_px))
    points = np.zeros((len(uv_px), 3))
    for _ in range(BENT_ROUNDS):
        points = origin + ((height - origin[2]) / along[:, 2])[:, None] * along
        near = np.clip(points[:, :2], -board.size_mm, 2 * board.size_mm)
        height = surface(board, coordinates, near).height_mm
    return np.asarray(points)


def around_pattern(board: Chessboard, points_mm: Floats, squares: float) -> NDArray[np.bool_]:
    """Which points (N, 3) lie within so many squares of the outermost inner corners."""
    beyond = np.maximum(-points_mm[:, :2], points_mm[:, :2] - board.extent_mm)
    return np.asarray((beyond < squares * board.square_mm).all(axis=1))
