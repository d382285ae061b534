"""A part as truly made, as a field of distances; rays meet it wherever the field is zero."""

from dataclasses import dataclass, field

import numpy as np
from numpy.typing import NDArray

Floats = NDArray[np.float64]
STEPS = 160
NEAR_MM = 2e-7
FAR_MM = 400.0


@dataclass(frozen=True)
class Bore:
    """A round hole from the top, and its depth."""

    x_mm: float
    y_mm: float
    diameter_mm: float
    depth_mm: float


@dataclass(frozen=True)
class Bracket:
    """A plate with its top at ``top_mm``, with bores, a boss, a ball, a step, a slot, a cone."""

    size_mm: tuple[float, float] = (120.0, 80.0)
    top_mm: float = 20.0
    bores: tuple[Bore, ...] = (Bore(15, 15, 12, 14), Bore(105, 15, 12, 14), Bore(15, 65, 16, 14))
    boss: tuple[float, float, float, float] = (60.0, 55.0, 25.0, 14.0)
    """x, y, diameter, height over the top."""
    ball: tuple[float, float, float, float] = (100.0, 58.0, 32.0, 20.0)
    """x, y, z, diameter."""
    step: tuple[float, float, float, float, float] = (50.0, 3.0, 90.0, 15.0, 5.0)
    """x and y of two corners, height over the top."""
    slot: tuple[float, float, float, float, float] = (60.0, 30.0, 10.0, 40.0, 8.0)
    """x and y of the middle, width, overall length along x, depth."""
    cone: tuple[float, float, float, float] = (30.0, 40.0, 45.0, 8.0)
    """x, y, half angle in degrees, radius at the top: a sink."""
    features: tuple[str, ...] = field(default=())

    def distance(self, p: Floats) -> Floats:
        """Distances (N,) of points (N, 3) from the surface, less than or equal to the true ones
        away from it."""
        x, y, z = p.T
        w, h = self.size_mm
        body = _box(x, y, z, w / 2, h / 2, w, h, 0.0, self.top_mm)
        x0, y0, x1, y1, height = self.step
        step = _box(
            x, y, z, (x0 + x1) / 2, (y0 + y1) / 2, x1 - x0, y1 - y0, 1.0, self.top_mm + height
        )
        bx, by, bd, bh = self.boss
        radial = np.hypot(x - bx, y - by) - bd / 2
        boss = np.maximum(np.maximum(radial, z - self.top_mm - bh), 1.0 - z)
        sx, sy, sz, sd = self.ball
        ball = np.sqrt((x - sx) ** 2 + (y - sy) ** 2 + (z - sz) ** 2) - sd / 2
        solid = np.minimum(np.minimum(body, step), np.minimum(boss, ball))
        for bore in self.bores:
            hole = np.hypot(x - bore.x_mm, y - bore.y_mm) - bore.diameter_mm / 2
            hole = np.maximum(hole, self.top_mm - bore.depth_mm - z)
            solid = np.maximum(solid, -hole)
        lx, ly, width, length, depth = self.slot
        run = (length - width) / 2
        end = np.clip(x - lx, -run, run)
        hole = np.hypot(x - lx - end, y - ly) - width / 2
        solid = np.maximum(solid, -np.maximum(hole, self.top_mm - depth - z))
        cx, cy, angle, radius = self.cone
        c, s = np.cos(np.radians(angle)), np.sin(np.radians(angle))
        sink = (np.hypot(x - cx, y - cy) - radius) * c - (z - self.top_mm) * s
        return np.asarray(np.maximum(solid, -sink))

    def meet(self, origin: Floats, along: Floats, start_mm: Floats | float = 0.0) -> Floats:
        """How far (N,) along rays the surface is first met; NaN where it is not."""
        t = np.zeros(len(along)) + start_mm
        active = np.arange(len(along))
        found = np.full(len(along), np.nan)
        for _ in range(STEPS):
            if not len(active):
                break
            at = origin[active] + t[active, None] * along[active]
            d = self.distance(at)
            t[active] += d
            done = np.abs(d) < NEAR_MM
            found[active[done]] = t[active[done]]
            active = active[~done & (t[active] < FAR_MM)]
        return found


def _box(
    x: Floats,
    y: Floats,
    z: Floats,
    cx: float,
    cy: float,
    w: float,
    h: float,
    low: float,
    top: float,
) -> Floats:
    side = np.maximum(np.abs(x - cx) - w / 2, np.abs(y - cy) - h / 2)
    return np.asarray(np.maximum(side, np.maximum(low - z, z - top)))
