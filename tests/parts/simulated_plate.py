"""A plate with a dent, a bump and a step on its top, as truly made, and its drawing."""

from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from tests.parts.meshes import box_corners
from tests.parts.simulated_solid import Bracket

Floats = NDArray[np.float64]


@dataclass(frozen=True)
class Plate(Bracket):
    """A block with a rib, whose top has flat places that are too low or too high.

    A spot is x, y, height, radius of its flat part and width of the slope around it, mm.
    """

    spots: tuple[tuple[float, float, float, float, float], ...] = (
        (30.0, 25.0, -0.05, 4.0, 3.0),
        (90.0, 25.0, 0.15, 4.0, 3.0),
    )
    step: tuple[float, float, float, float, float] = (40.0, 50.0, 60.0, 70.0, 0.06)
    """x and y of two corners, height."""
    rib: tuple[float, float, float, float, float] = (80.0, 52.0, 112.0, 66.0, 12.0)
    """x and y of two corners, height over the top."""

    def relief_mm(self, x: Floats, y: Floats) -> Floats:
        """Height (N,) of the top over its drawing."""
        found = np.zeros(len(x))
        for cx, cy, height, flat, slope in self.spots:
            away = (np.hypot(x - cx, y - cy) - flat) / slope
            found += height * (0.5 + 0.5 * np.cos(np.pi * np.clip(away, 0.0, 1.0)))
        x0, y0, x1, y1, height = self.step
        found += height * ((x > x0) & (x < x1) & (y > y0) & (y < y1))
        return found

    def distance(self, p: Floats) -> Floats:
        """Distances (N,) of points (N, 3), the true ones or less."""
        x, y, z = p.T
        w, h = self.size_mm
        side = np.maximum(np.abs(x - w / 2) - w / 2, np.abs(y - h / 2) - h / 2)
        top = 0.9 * (z - self.top_mm - self.relief_mm(x, y))
        x0, y0, x1, y1, height = self.rib
        wall = np.abs(x - (x0 + x1) / 2) - (x1 - x0) / 2
        wall = np.maximum(wall, np.abs(y - (y0 + y1) / 2) - (y1 - y0) / 2)
        boss = np.maximum(wall, np.maximum(1.0 - z, z - self.top_mm - height))
        return np.asarray(np.minimum(np.maximum(side, np.maximum(-z, top)), boss))

    def corners(self) -> Floats:
        """(T, 3, 3) of its drawing."""
        size = np.array([*self.size_mm, self.top_mm])
        x0, y0, x1, y1, height = self.rib
        boss = np.array([x1 - x0, y1 - y0, height])
        middle = np.array([(x0 + x1) / 2, (y0 + y1) / 2, self.top_mm + height / 2])
        return np.concatenate([box_corners(size, 4) + size / 2, box_corners(boss) + middle])
