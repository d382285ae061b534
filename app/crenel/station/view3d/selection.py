"""The points on the front surface under a rectangle drawn over the 3D view. Pure."""

from collections.abc import Iterator
from dataclasses import dataclass
from pathlib import Path

import numpy as np
from numpy.typing import NDArray
from scipy.spatial.transform import Rotation

from crenel.errors import OperationError
from crenel.formats.clouds.cuts import Cut, Planes, cut_mask
from crenel.formats.clouds.pieces import read_cloud_pieces
from crenel.formats.clouds.points import positions_of
from crenel.messages.message import message
from crenel.metrology.transforms import Floats
from crenel.station.view3d.cloud_colouring import PointAttributes
from crenel.station.view3d.nodes import M_PER_MM

# The front surface is determined in squares of the rectangle with about this many points each.
POINTS_A_CELL = 16
MOST_CELLS = 48
# A point belongs to it up to this many square widths behind: a slope of four in one.
DEEP_CELLS = 6.0
DEEP_VOXELS = 6.0
# This share of the points of a square may be noise in front of the surface.
FLYING = 0.1
NEARER_NEIGHBOURS = 3


@dataclass(frozen=True)
class ViewCamera:
    """The viewpoint of a browser: x to the right, y down, z ahead."""

    wxyz: tuple[float, float, float, float]
    """From the camera frame to the arm frame."""
    position_m: tuple[float, float, float]
    fov_rad: float
    """From the top of the picture to its bottom."""
    aspect: float
    """Width over height."""

    def direction(self) -> Floats:
        """Ahead, in the arm frame (3,)."""
        return np.asarray(self.rotation_arm_cam()[:, 2])

    def rotation_arm_cam(self) -> Floats:
        """From the camera frame to the arm frame (3, 3)."""
        w, x, y, z = self.wxyz
        return np.asarray(Rotation.from_quat([x, y, z, w]).as_matrix())

    def project(self, points_mm: Floats) -> Floats:
        """For points (N, 3) of the arm frame: position in the picture (0 to 1 from the left and
        from the top) and distance ahead in mm; NaN for points that are not ahead."""
        seen: Floats = (points_mm - np.array(self.position_m) / M_PER_MM) @ self.rotation_arm_cam()
        depth = np.where(seen[:, 2] > 0, seen[:, 2], np.nan)
        half = np.tan(self.fov_rad / 2)
        seen[:, 0] = 0.5 + 0.5 * seen[:, 0] / (depth * half * self.aspect)
        seen[:, 1] = 0.5 + 0.5 * seen[:, 1] / (depth * half)
        seen[:, 2] = depth
        return seen


@dataclass(frozen=True)
class Rectangle:
    """Shares of the picture, 0 to 1 from its left and from its top."""

    left: float
    top: float
    right: float
    bottom: float


def frustum_planes(camera: ViewCamera, rectangle: Rectangle) -> Planes:
    """Bounds of the part of space that is seen in a rectangle, at any distance."""
    down = np.tan(camera.fov_rad / 2)
    right = down * camera.aspect
    at = rectangle
    inward = np.array(
        [
            [1.0, 0.0, (1 - 2 * at.left) * right],
            [-1.0, 0.0, (2 * at.right - 1) * right],
            [0.0, 1.0, (1 - 2 * at.top) * down],
            [0.0, -1.0, (2 * at.bottom - 1) * down],
            [0.0, 0.0, 1.0],
        ]
    )
    normals = inward @ camera.rotation_arm_cam().T
    normals /= np.linalg.norm(normals, axis=1)[:, None]
    offsets = -normals @ (np.array(camera.position_m) / M_PER_MM)
    return tuple((*normal, d) for normal, d in zip(normals.tolist(), offsets.tolist(), strict=True))


class FrontSurface:
    """The part of a cloud that is visible in a rectangle, without what is behind it."""

    def __init__(
        self, camera: ViewCamera, rectangle: Rectangle, shown_mm: Floats, voxel_mm: float
    ) -> None:
        """From the shown points (N, 3), which are thinned by cubes of ``voxel_mm``."""
        self._camera, self._rectangle = camera, rectangle
        seen = camera.project(shown_mm)
        seen = seen[self._within(seen)]
        self.empty = not len(seen)
        if self.empty:
            return
        width, height = self._size_mm(float(np.median(seen[:, 2])))
        side = np.sqrt(width * height * POINTS_A_CELL / len(seen))
        self._across = int(np.clip(width / side, 1, MOST_CELLS))
        self._down = int(np.clip(height / side, 1, MOST_CELLS))
        self._deep_mm = DEEP_VOXELS * voxel_mm + DEEP_CELLS * max(
            width / self._across, height / self._down
        )
        self._front_mm = self._front(seen)

    def holds(self, points_mm: Floats) -> NDArray[np.bool_]:
        """Mask of the points (N, 3) on it."""
        seen = self._camera.project(points_mm)
        found = self._within(seen)
        if self.empty:
            return found
        front = self._front_mm[self._cells(seen[found])]
        found[found] = np.abs(seen[found][:, 2] - front) <= self._deep_mm
        return found

    def _within(self, seen: Floats) -> NDArray[np.bool_]:
        at = self._rectangle
        x, y = seen[:, 0], seen[:, 1]
        return np.asarray((x >= at.left) & (x <= at.right) & (y >= at.top) & (y <= at.bottom))

    def _size_mm(self, depth_mm: float) -> tuple[float, float]:
        """Width and height of the rectangle at a distance."""
        at, whole = self._rectangle, 2 * depth_mm * float(np.tan(self._camera.fov_rad / 2))
        return (
            max(at.right - at.left, 1e-6) * whole * self._camera.aspect,
            max(at.bottom - at.top, 1e-6) * whole,
        )

    def _cells(self, seen: Floats) -> NDArray[np.int64]:
        at = self._rectangle
        column = (seen[:, 0] - at.left) / max(at.right - at.left, 1e-6) * self._across
        row = (seen[:, 1] - at.top) / max(at.bottom - at.top, 1e-6) * self._down
        column = np.minimum(column.astype(np.int64), self._across - 1)
        row = np.minimum(row.astype(np.int64), self._down - 1)
        return np.asarray(row * self._across + column)

    def _front(self, seen: Floats) -> Floats:
        """Distance of the surface in each cell; NaN if there is none."""
        cells = self._cells(seen)
        order = np.lexsort((seen[:, 2], cells))
        count = np.bincount(cells, minlength=self._across * self._down)
        first = np.cumsum(count) - count
        front = np.full(len(count), np.nan)
        some = count > 0
        front[some] = seen[order, 2][(first + FLYING * count).astype(np.int64)[some]]
        return self._without_gaps(front.reshape(self._down, self._across)).ravel()

    def _without_gaps(self, front: Floats) -> Floats:
        """Excludes cells with a random gap in front, by their neighbours."""
        wide = np.pad(front, 1, constant_values=np.nan)
        down, across = front.shape
        nearer = np.zeros(front.shape, dtype=np.int64)
        for i in range(3):
            for j in range(3):
                neighbour = wide[i : i + down, j : j + across]
                nearer += neighbour < front - self._deep_mm
        return np.where(nearer >= NEARER_NEIGHBOURS, np.nan, front)


MOST_FITTED = 120_000
"""If a region has more points, every second, third, and so on is fitted."""
PICKED = np.dtype(
    [
        ("x", "<f8"),
        ("y", "<f8"),
        ("z", "<f8"),
        ("uncertainty_um", "<f4"),
        ("frame", "<i8"),
        ("scan", "<i4"),
        ("front", "?"),
    ]
)


@dataclass(frozen=True)
class VisibleCloud:
    """A scan in the view: its shown points, and its file when it is complete."""

    points_mm: Floats
    traits: PointAttributes
    voxel_mm: float
    file: Path | None
    cuts: tuple[Cut, ...] = ()
    """What the file has beyond the points that are shown."""


@dataclass(frozen=True)
class SelectedPoints:
    """Points under a rectangle."""

    points_mm: Floats
    """(N, 3), evenly selected from ``count``."""
    frame: NDArray[np.int64]
    """(N,) in its scan."""
    count: int
    every: bool
    """Whether all points came from files, or some from the thinned cloud in the view."""
    spread_mm: Floats
    """(N,) standard uncertainty by the fit of the stripe."""
    scan: NDArray[np.int64]
    """(N,) number of the cloud."""
    front: NDArray[np.bool_]
    """(N,) whether it is on the surface in front."""


def select_points(
    camera: ViewCamera, rectangle: Rectangle, clouds: list[VisibleCloud]
) -> SelectedPoints:
    """The points under a rectangle of the picture, at any distance.

    Raises:
        OperationError: there are none.
    """
    shown = [cloud.points_mm for cloud in clouds]
    surface = FrontSurface(
        camera,
        rectangle,
        np.concatenate(shown) if shown else np.zeros((0, 3)),
        max((cloud.voxel_mm for cloud in clouds), default=0.0),
    )
    if surface.empty:
        raise OperationError(
            "nothing-picked",
            message("there-no-points-rectangle"),
            remedy=message("draw-over-part-cloud"),
        )
    planes = np.array(frustum_planes(camera, rectangle))
    gathered, every = _PointSample(), True
    for number, cloud in enumerate(clouds):
        for rows in _read_points(cloud):
            places = positions_of(rows)
            within = np.ones(len(rows), dtype=bool)
            for plane in planes:
                within[within] = places[within] @ plane[:3] + plane[3] >= 0
            kept, places = rows[within], places[within]
            uncut = ~cut_mask(cloud.cuts, places)
            kept, places = kept[uncut], places[uncut]
            kept["scan"], kept["front"] = number, surface.holds(places)
            gathered.add(kept)
        every = every and cloud.file is not None
    rows = gathered.all()
    return SelectedPoints(
        positions_of(rows),
        rows["frame"],
        gathered.count,
        every,
        rows["uncertainty_um"].astype(np.float64) / 1e3,
        rows["scan"].astype(np.int64),
        rows["front"],
    )


def _read_points(cloud: VisibleCloud) -> Iterator[NDArray[np.void]]:
    if cloud.file is None:
        # the frame of shown points is not stored; points of one moment count as one frame
        moments = np.unique(cloud.traits["taken_s"], return_inverse=True)[1]
        yield _pack_rows(cloud.points_mm, np.zeros(len(moments)), moments)
        return
    for points, _ in read_cloud_pieces(cloud.file):
        yield _pack_rows(positions_of(points), points["uncertainty_um"], points["frame"])


def _pack_rows(
    points_mm: Floats, uncertainty_um: NDArray[np.floating], frame: NDArray[np.integer]
) -> NDArray[np.void]:
    rows = np.zeros(len(points_mm), PICKED)
    for axis, name in enumerate("xyz"):
        rows[name] = points_mm[:, axis]
    rows["uncertainty_um"], rows["frame"] = uncertainty_um, frame
    return rows


class _PointSample:
    """Thinned evenly if it grows too large."""

    def __init__(self) -> None:
        self.count = 0
        self._step = 1
        self._stored = 0
        self._parts: list[NDArray[np.void]] = []

    def add(self, rows: NDArray[np.void]) -> None:
        first = -self.count % self._step
        self.count += len(rows)
        self._parts.append(rows[first :: self._step])
        self._stored += len(self._parts[-1])
        if self._stored > 2 * MOST_FITTED:
            self._thin(2)

    def all(self) -> NDArray[np.void]:
        """At most ``MOST_FITTED`` rows."""
        if self._stored > MOST_FITTED:
            self._thin(-(-self._stored // MOST_FITTED))
        return np.concatenate(self._parts)

    def _thin(self, by: int) -> None:
        self._step *= by
        self._parts = [np.concatenate(self._parts)[::by]]
        self._stored = len(self._parts[0])
