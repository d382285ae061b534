"""Ray casting: where a ray first meets a thing. Compiled; called for millions of rays.

Rays of one bundle share an origin (the camera's centre, the laser's emitter), so
origin and turn into every thing's own frame are worked out once (``bundle``). A hit is
``(t, thing, face, normal in the thing's frame, point in the thing's frame)``;
thing is -1 where the ray meets nothing.

Faces of blocks and boxes: 0 crest (top), 1 floor, 2 front (-Y), 3 back, 4 left (-X),
5 right, 6 bottom; 8 times the merlon's or groove's number is added, so that two
faces that only look alike have different numbers. Of a chessboard 0 is what is white of
its top, and 8 what is black.
"""

import numpy as np
from numpy.typing import NDArray

from hardware.compiled import kernel
from hardware.twin.kinematics import Floats

Ints = NDArray[np.int64]
Hit = tuple[float, int, int, float, float, float, float, float, float]

FAR = 1e30


@kernel
def _slab(
    rows: Floats, k: int, ox: float, oy: float, oz: float, dx: float, dy: float, dz: float
) -> tuple[float, float, int, int]:
    """Where a ray enters and leaves a cuboid (rows[k, 8:14]), and through which face."""
    enter, leave, enter_face, leave_face = -1e30, 1e30, -1, -1
    for axis in range(3):
        o = ox if axis == 0 else (oy if axis == 1 else oz)
        d = dx if axis == 0 else (dy if axis == 1 else dz)
        low_face = 4 if axis == 0 else (2 if axis == 1 else 6)
        high_face = 5 if axis == 0 else (3 if axis == 1 else 0)
        low, high = rows[k, 8 + axis], rows[k, 11 + axis]
        if abs(d) < 1e-300:
            if o < low or o > high:
                return 1.0, 0.0, -1, -1
            continue
        inverse = 1.0 / d
        ta, tb = (low - o) * inverse, (high - o) * inverse
        fa, fb = low_face, high_face
        if ta > tb:
            ta, tb, fa, fb = tb, ta, fb, fa
        if ta > enter:
            enter, enter_face = ta, fa
        if tb < leave:
            leave, leave_face = tb, fb
    return enter, leave, enter_face, leave_face


@kernel
def _hit_comb(
    rows: Floats, k: int, ox: float, oy: float, oz: float, dx: float, dy: float, dz: float
) -> tuple[float, int]:
    """First face of the block on a ray that starts outside of its hull."""
    enter, leave, face, _ = _slab(rows, k, ox, oy, oz, dx, dy, dz)
    if enter > leave or enter <= 0.0:
        return 1e30, -1
    floor, n = rows[k, 14], int(rows[k, 15])
    x, z = ox + enter * dx, oz + enter * dz
    if face == 4:
        return enter, 4
    if face == 5:
        return enter, 5 + 8 * (n // 2 - 1)
    if z <= floor or face == 6:
        return enter, face
    gap = 0
    while gap < n and rows[k, 16 + gap] < x:
        gap += 1
    if gap % 2 == 1 or gap == 0 or gap == n:
        return enter, face if face != 0 else 8 * (gap // 2)
    left, right, groove = rows[k, 16 + gap - 1], rows[k, 16 + gap], gap // 2 - 1
    t_side = 1e30
    side = -1
    if dx < 0.0:
        t_side, side = (left - ox) / dx, 5 + 8 * groove
    elif dx > 0.0:
        t_side, side = (right - ox) / dx, 4 + 8 * (groove + 1)
    t_floor = (floor - oz) / dz if dz < 0.0 else 1e30
    t = min(t_side, t_floor)
    if t > leave:
        return 1e30, -1
    return (t_floor, 1 + 8 * groove) if t_floor <= t_side else (t_side, side)


@kernel
def _shell_height(rows: Floats, k: int, x: float, y: float) -> float:
    w = 1.0 - (x / rows[k, 16]) ** 2 - (y / rows[k, 17]) ** 2
    if w <= 0.0:
        return float(rows[k, 18] * w)
    fan = x / (y + 1.3 * rows[k, 17])
    return float(rows[k, 18] * w + rows[k, 19] * w * w * np.cos(rows[k, 20] * fan))


@kernel
def _hit_shell(
    rows: Floats, k: int, ox: float, oy: float, oz: float, dx: float, dy: float, dz: float
) -> float:
    """First crossing of the relief, to a nanometre, for a ray from above.

    From a paraboloid that covers it, steps that cannot pass the surface, for its slope
    is bounded; then secants.
    """
    enter, leave, _, _ = _slab(rows, k, ox, oy, oz, dx, dy, dz)
    if enter > leave or leave <= 0.0:
        return 1e30
    ex, ey, top = rows[k, 16] ** -2, rows[k, 17] ** -2, rows[k, 18] + rows[k, 19]
    qa = top * (dx * dx * ex + dy * dy * ey)
    qb = 0.5 * dz + top * (ox * dx * ex + oy * dy * ey)
    root = qb * qb - qa * (top * (ox * ox * ex + oy * oy * ey) + oz - top)
    if root < 0.0:
        return 1e30
    cover = (-qb - np.sqrt(root)) / qa if qa > 1e-18 else enter
    closing = abs(dz) + rows[k, 21] * np.sqrt(dx * dx + dy * dy)
    t = max(enter, cover, 0.0)
    while t <= leave:
        gap = oz + t * dz - _shell_height(rows, k, ox + t * dx, oy + t * dy)
        if gap < 0.1:
            before = t - 1e-3 / closing
            gap_before = oz + before * dz
            gap_before -= _shell_height(rows, k, ox + before * dx, oy + before * dy)
            for _ in range(20):
                if abs(gap) < 1e-9 or gap == gap_before:
                    break
                ahead = t - gap * (t - before) / (gap - gap_before)
                before, gap_before, t = t, gap, ahead
                gap = oz + t * dz - _shell_height(rows, k, ox + t * dx, oy + t * dy)
            if abs(gap) < 1e-6:
                return t
            t = max(t, before) + 1e-2 / closing
        else:
            t += gap / closing
    return 1e30


@kernel
def _hit_ball(
    rows: Floats, k: int, ox: float, oy: float, oz: float, dx: float, dy: float, dz: float
) -> float:
    a = dx * dx + dy * dy + dz * dz
    b = ox * dx + oy * dy + oz * dz
    c = ox * ox + oy * oy + oz * oz - rows[k, 3] * rows[k, 3]
    root = b * b - a * c
    if root < 0.0:
        return 1e30
    t = (-b - np.sqrt(root)) / a
    return t if t > 0.0 else 1e30


@kernel
def _square(rows: Floats, k: int, x: float, y: float) -> int:
    """The face of a chessboard's top at a place: 8 on a black square, else 0."""
    i, j = int(np.floor(x / rows[k, 18])), int(np.floor(y / rows[k, 19]))
    printed = i >= -1 and i < rows[k, 16] and j >= -1 and j < rows[k, 17]
    return 8 if printed and (i + j) % 2 == 0 else 0


@kernel
def albedo(kind: int, rows: Floats, k: int, face: int) -> float:
    """How bright a face is; a chessboard's squares are so by the laser's light as well."""
    return float(rows[k, 4] * rows[k, 20]) if kind == 4 and face == 8 else float(rows[k, 4])


@kernel
def _normal(
    kind: int, rows: Floats, k: int, face: int, x: float, y: float
) -> tuple[float, float, float]:
    """Outward normal of a plane face, or of the relief over (x, y)."""
    if kind == 3:
        h = 1e-4
        gx = (_shell_height(rows, k, x + h, y) - _shell_height(rows, k, x - h, y)) / (2.0 * h)
        gy = (_shell_height(rows, k, x, y + h) - _shell_height(rows, k, x, y - h)) / (2.0 * h)
        length = np.sqrt(1.0 + gx * gx + gy * gy)
        return -gx / length, -gy / length, 1.0 / length
    f = face % 8
    if f == 2:
        return 0.0, -1.0, 0.0
    if f == 3:
        return 0.0, 1.0, 0.0
    if f == 4:
        return -1.0, 0.0, 0.0
    if f == 5:
        return 1.0, 0.0, 0.0
    return 0.0, 0.0, (-1.0 if f == 6 else 1.0)


def bundle(into: Floats, rows: Floats, origin: Floats) -> Floats:
    """(K, 16): all that ``trace`` needs to know of the rays from one origin.

    Args:
        into: (K, 4, 4) from the rays' frame into each thing's.
        rows: (K, 64) of the things.
        origin: (3,) where the rays start, in their frame.

    Returns:
        Per thing its turn (0-8), the origin in its frame (9-11), its bounding
        sphere's centre from the origin in the rays' frame (12-14), and that
        centre's distance squared less the radius squared (15).
    """
    found = np.empty((len(rows), 16))
    for k, T in enumerate(into):
        start = T[:3, :3] @ origin + T[:3, 3]
        centre = T[:3, :3].T @ (rows[k, :3] - start)
        found[k, :9], found[k, 9:12], found[k, 12:15] = T[:3, :3].ravel(), start, centre
        found[k, 15] = centre @ centre - rows[k, 3] ** 2
    return found


@kernel
def trace(kinds: Ints, rows: Floats, rays: Floats, dx: float, dy: float, dz: float) -> Hit:
    """The first hit of a ray along (dx, dy, dz) from the origin of its ``bundle``."""
    best, thing, face = 1e30, -1, -1
    dd = dx * dx + dy * dy + dz * dz
    for k in range(kinds.shape[0]):
        along = rays[k, 12] * dx + rays[k, 13] * dy + rays[k, 14] * dz
        if rays[k, 15] * dd > along * along:
            continue
        ox, oy, oz = rays[k, 9], rays[k, 10], rays[k, 11]
        lx = rays[k, 0] * dx + rays[k, 1] * dy + rays[k, 2] * dz
        ly = rays[k, 3] * dx + rays[k, 4] * dy + rays[k, 5] * dz
        lz = rays[k, 6] * dx + rays[k, 7] * dy + rays[k, 8] * dz
        t, f = 1e30, 0
        if kinds[k] == 0:
            t, f = _hit_comb(rows, k, ox, oy, oz, lx, ly, lz)
        elif kinds[k] == 1:
            enter, leave, f, _ = _slab(rows, k, ox, oy, oz, lx, ly, lz)
            t = enter if (enter <= leave and enter > 0.0) else 1e30
        elif kinds[k] == 2:
            t = _hit_ball(rows, k, ox, oy, oz, lx, ly, lz)
        elif kinds[k] == 4:
            enter, leave, f, _ = _slab(rows, k, ox, oy, oz, lx, ly, lz)
            if enter <= leave and enter > 0.0:
                t = enter
                f = _square(rows, k, ox + t * lx, oy + t * ly) if f == 0 else f
        else:
            t = _hit_shell(rows, k, ox, oy, oz, lx, ly, lz)
        if t < best:
            best, thing, face = t, k, f
    if thing < 0:
        return best, -1, -1, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0
    k = thing
    x = rays[k, 9] + best * (rays[k, 0] * dx + rays[k, 1] * dy + rays[k, 2] * dz)
    y = rays[k, 10] + best * (rays[k, 3] * dx + rays[k, 4] * dy + rays[k, 5] * dz)
    z = rays[k, 11] + best * (rays[k, 6] * dx + rays[k, 7] * dy + rays[k, 8] * dz)
    if kinds[k] == 2:
        r = rows[k, 3]
        return best, k, 0, x / r, y / r, z / r, x, y, z
    nx, ny, nz = _normal(kinds[k], rows, k, face, x, y)
    return best, k, face, nx, ny, nz, x, y, z
