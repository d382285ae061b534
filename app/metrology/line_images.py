"""How pixels lie across the images of straight lines, with all derivatives: one pass, compiled."""

import numpy as np
from numpy.typing import NDArray

from app.metrology.camera import Camera
from app.metrology.compiled import kernel
from app.metrology.frames import Floats
from app.metrology.projection import COUNT

# Rounds that take the lens's distortion off a pixel, and when they are enough.
_ROUNDS, _ENOUGH = 50, 1e-12


@kernel
def _undistorted(xd: float, yd: float, lens: Floats) -> tuple[float, float]:
    """The direction (x/z, y/z) that the lens bends to (xd, yd)."""
    _, _, _, _, k1, k2, p1, p2, k3 = lens
    x, y = xd, yd
    for _ in range(_ROUNDS):
        r2 = x * x + y * y
        radial = 1 + r2 * (k1 + r2 * (k2 + r2 * k3))
        x_next = (xd - 2 * p1 * x * y - p2 * (r2 + 2 * x * x)) / radial
        y_next = (yd - p1 * (r2 + 2 * y * y) - 2 * p2 * x * y) / radial
        moved = abs(x_next - x) + abs(y_next - y)
        x, y = x_next, y_next
        if moved < _ENOUGH:
            break
    return x, y


@kernel
def _nearest_share(x: float, y: float, pose: Floats, start: Floats, along: Floats) -> float:
    """Where on ``start + share along`` the ray (x, y, 1) of the camera comes nearest to it."""
    # In the camera's frame the ray begins at the origin.
    across, square, down, ahead = 0.0, x * x + y * y + 1.0, 0.0, 0.0
    for k in range(3):
        a = pose[k, 0] * along[0] + pose[k, 1] * along[1] + pose[k, 2] * along[2]
        s = pose[k, 0] * start[0] + pose[k, 1] * start[1] + pose[k, 2] * start[2] + pose[k, 3]
        ray = x if k == 0 else (y if k == 1 else 1.0)
        across += ray * a
        down += ray * s
        ahead += a * s
    along_square = along[0] ** 2 + along[1] ** 2 + along[2] ** 2
    # -s . (r x (r x a)) over a . (r x (r x a))
    return float((square * ahead - across * down) / (across * across - square * along_square))


@kernel
def _across_lines(
    uv: Floats, starts: Floats, alongs: Floats, pose: Floats, lens: Floats, columns: int
) -> tuple[Floats, Floats, Floats, Floats, Floats]:
    fx, fy, cx, cy, k1, k2, p1, p2, k3 = lens
    count = len(uv)
    off, shares = np.empty(count), np.empty(count)
    normals, by_points = np.empty((count, 2)), np.empty((count, 3))
    J = np.zeros((count, columns))
    for i in range(count):
        start, along, row = starts[i], alongs[i], J[i]
        x, y = _undistorted((uv[i, 0] - cx) / fx, (uv[i, 1] - cy) / fy, lens)
        share = _nearest_share(x, y, pose, start, along)
        p, q, r = (
            start[0] + share * along[0],
            start[1] + share * along[1],
            start[2] + share * along[2],
        )
        X = pose[0, 0] * p + pose[0, 1] * q + pose[0, 2] * r + pose[0, 3]
        Y = pose[1, 0] * p + pose[1, 1] * q + pose[1, 2] * r + pose[1, 3]
        Z = pose[2, 0] * p + pose[2, 1] * q + pose[2, 2] * r + pose[2, 3]
        x, y = X / Z, Y / Z
        r2 = x * x + y * y
        radial = 1 + r2 * (k1 + r2 * (k2 + r2 * k3))
        xd = x * radial + 2 * p1 * x * y + p2 * (r2 + 2 * x * x)
        yd = y * radial + p1 * (r2 + 2 * y * y) + 2 * p2 * x * y
        # Of pixels by x and y, and by how a direction along the line moves these.
        slope = 2 * (k1 + r2 * (2 * k2 + 3 * r2 * k3))
        cross = slope * x * y + 2 * p1 * x + 2 * p2 * y
        u_x, u_y = fx * (radial + slope * x * x + 2 * p1 * y + 6 * p2 * x), fx * cross
        v_x, v_y = fy * cross, fy * (radial + slope * y * y + 6 * p1 * y + 2 * p2 * x)
        a = pose[0, 0] * along[0] + pose[0, 1] * along[1] + pose[0, 2] * along[2]
        b = pose[1, 0] * along[0] + pose[1, 1] * along[1] + pose[1, 2] * along[2]
        c = pose[2, 0] * along[0] + pose[2, 1] * along[1] + pose[2, 2] * along[2]
        x_along, y_along = (a - x * c) / Z, (b - y * c) / Z
        tu, tv = u_x * x_along + u_y * y_along, v_x * x_along + v_y * y_along
        length = np.sqrt(tu * tu + tv * tv)
        nu, nv = -tv / length, tu / length
        # Along the normal: by the point in the camera's frame, then by all parameters.
        n_x, n_y = nu * u_x + nv * v_x, nu * u_y + nv * v_y
        n_X, n_Y, n_Z = n_x / Z, n_y / Z, -(n_x * x + n_y * y) / Z
        row[0], row[1], row[2], row[3] = -nu * xd, -nv * yd, -nu, -nv
        row[4], row[5], row[6] = Z * n_Y - Y * n_Z, X * n_Z - Z * n_X, Y * n_X - X * n_Y
        row[7], row[8], row[9] = -n_X, -n_Y, -n_Z
        row[10] = -(nu * fx * x + nv * fy * y) * r2
        row[11] = row[10] * r2
        row[12] = -nu * fx * 2 * x * y - nv * fy * (r2 + 2 * y * y)
        row[13] = -nu * fx * (r2 + 2 * x * x) - nv * fy * 2 * x * y
        for k in range(3):
            by_points[i, k] = -(n_X * pose[0, k] + n_Y * pose[1, k] + n_Z * pose[2, k])
        off[i] = (uv[i, 0] - fx * xd - cx) * nu + (uv[i, 1] - fy * yd - cy) * nv
        normals[i, 0], normals[i, 1], shares[i] = nu, nv, share
    return off, normals, J, by_points, shares


@kernel
def add_ends(
    J: Floats, by_points: Floats, shares: Floats, ends: NDArray[np.int64], first: int
) -> None:
    """Adds to J (N, P) what the coordinates of the lines' ends do to residuals.

    ``ends`` (N, 2, 3) numbers these coordinates, which stand from column ``first`` on; the
    others as ``across_lines`` gives them.
    """
    for i in range(len(J)):
        for k in range(3):
            J[i, first + ends[i, 0, k]] += by_points[i, k] * (1 - shares[i])
            J[i, first + ends[i, 1, k]] += by_points[i, k] * shares[i]


def across_lines(
    camera: Camera, uv_px: Floats, start: Floats, along: Floats, columns: int = COUNT
) -> tuple[Floats, Floats, Floats, Floats, Floats]:
    """How pixels (N, 2) lie across the images of the lines ``start + share along`` (N, 3).

    Each at the share where its ray comes nearest to the line.

    Returns:
        (N,) distances in px, residuals; (N, 2) unit normals of the lines' images; their
        derivatives (N, columns) by the camera's parameters, zero beyond these, and (N, 3) by
        the lines' points; (N,) the shares.
    """
    K = camera.matrix
    pose = np.column_stack([camera.rotation, camera.translation_mm])
    lens = np.array([K[0, 0], K[1, 1], K[0, 2], K[1, 2], *camera.distortion])
    return _across_lines(uv_px, start, along, pose, lens, columns)
