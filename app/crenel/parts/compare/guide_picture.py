"""A map in the 3D view: its cells as coloured squares on the part, and what a ray meets."""

from dataclasses import dataclass
from functools import cached_property

import numpy as np

from crenel.metrology.transforms import Floats, apply, inverse
from crenel.parts.compare.document_comparison import PartComparison
from crenel.parts.compare.guide_view import Help, MapLegend, MapMode, PlaceOnMap
from crenel.parts.compare.maths_map_colours import OUT, UNSCANNED, colour_map, light_up
from crenel.parts.compare.maths_squares import first_hit_mm, group_cells, square_corners
from crenel.station.view3d.nodes import ColouredSurface
from crenel.station.view3d.selection import ViewCamera

MOST_SQUARES = 150_000
"""That are drawn; of more cells, several become one square, with the colour of the gravest."""
NEAR_CELLS = 1.2
"""A place belongs to a cell that is nearer than this multiple of its edge."""
MM_PER_M = 1000.0
DECISIONS = ("in", "out", "undecided")
HELP: dict[str, Help] = {
    "points": "more-passes",
    "encoders": "other-postures",
    "calibration": "calibrate",
    "arm": "identify-arm",
    "tip": "identify-arm",
    "alignment": "scan-more",
    "cad": "finer-facets",
}
"""What makes each share of the uncertainty less."""


@dataclass(frozen=True)
class MapPicture:
    """A map, prepared for the view."""

    made: PartComparison

    @property
    def pose(self) -> Floats:
        """(4, 4) ``T_arm_part``."""
        return np.array(self.made.document.T_arm_part)

    @cached_property
    def _at_mm(self) -> Floats:
        return self.made.at_mm

    def paint(self, mode: MapMode) -> tuple[ColouredSurface, MapLegend]:
        """The part and its cells, each with the colour of a mode; and what the colours mean."""
        document, rows = self.made.document, self.made.rows
        u = rows["uncertainty_um"].astype(np.float64)
        deviation = rows["deviation_um"].astype(np.float64)
        limits = (1e3 * document.lower_mm, 1e3 * document.upper_mm)
        found = colour_map(mode, deviation, u, rows["decision"], limits)
        groups = group_cells(
            self._at_mm, self.made.normals, self._grave(mode), document.cell_mm, MOST_SQUARES
        )
        some, vertices = groups.first, self.made.vertices_mm
        corners = square_corners(
            self._at_mm[some],
            self.made.normals[some],
            groups.edge_mm,
            vertices.min(axis=0),
            vertices.max(axis=0),
        )
        halves = np.concatenate([corners[:, [0, 1, 2]], corners[:, [0, 2, 3]]])
        index = np.concatenate([found.index[some], found.other[some]])
        part = vertices[self.made.triangles]
        bare = np.tile(np.array(UNSCANNED, np.uint8), (len(part), 1))
        triangles = np.concatenate([part, halves])
        colours = np.concatenate([bare, np.array(found.colours, np.uint8)[index]])
        lit = light_up(triangles, colours, self.pose[:3, :3])
        legend = MapLegend(mode, found.low_um, found.high_um, found.stops, groups.edge_mm)
        return ColouredSurface(triangles, lit), legend

    def find(self, camera: ViewCamera, x: float, y: float) -> PlaceOnMap:
        """What is seen at a place of the picture, given as shares of its width and height."""
        half = np.tan(camera.fov_rad / 2)
        ahead = np.array([(2 * x - 1) * half * camera.aspect, (2 * y - 1) * half, 1.0])
        ahead = camera.rotation_arm_cam() @ ahead / np.linalg.norm(ahead)
        T = inverse(self.pose)
        origin = apply(T, MM_PER_M * np.array([camera.position_m]))[0]
        ahead = T[:3, :3] @ ahead
        far = first_hit_mm(origin, ahead, self.made.vertices_mm, self.made.triangles)
        if not np.isfinite(far):
            return PlaceOnMap("nothing")
        hit = origin + far * ahead
        off = np.linalg.norm(self._at_mm - hit, axis=1)
        off[self.made.normals @ ahead > 0] = np.inf
        nearest = int(np.argmin(off))
        if off[nearest] > NEAR_CELLS * self.made.document.cell_mm:
            return PlaceOnMap("not-scanned", float(hit[0]), float(hit[1]), float(hit[2]))
        return self._place(nearest)

    def _place(self, cell: int) -> PlaceOnMap:
        row = self.made.rows[cell]
        u = float(row["uncertainty_um"])
        variances = {name: float(one[cell]) for name, one in self.made.variances_um2.items()}
        budget = {name: float(np.sign(one) * np.sqrt(abs(one))) for name, one in variances.items()}
        largest = max(budget, key=lambda name: budget[name], default="")
        x, y, z = (float(row[axis]) for axis in "xyz")
        return PlaceOnMap(
            "cell",
            x,
            y,
            z,
            float(row["deviation_um"]),
            u if np.isfinite(u) else None,
            float(self.made.scatter_um[cell]),
            DECISIONS[int(row["decision"])],  # type: ignore[arg-type]
            int(row["points"]),
            int(row["frames"]),
            float(self.made.chord_um[cell]),
            budget,
            HELP.get(largest),
        )

    def _grave(self, mode: MapMode) -> Floats:
        """(C,) which of several cells a square shows."""
        rows = self.made.rows
        off = np.abs(rows["deviation_um"].astype(np.float64))
        if mode == "uncertainty":
            return np.nan_to_num(rows["uncertainty_um"].astype(np.float64))
        if mode == "significance":
            worst = np.select([rows["decision"] == OUT, rows["decision"] == 2], [2.0, 1.0], 0.0)
            return np.asarray(worst + off / (1 + off))
        return off
