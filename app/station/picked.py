"""The points of the shown scans that lie in a picked region: all of them where files hold them."""

from collections.abc import Iterator
from dataclasses import dataclass
from pathlib import Path

import numpy as np
from numpy.typing import NDArray

from app.files.cloud_pieces import cloud_pieces
from app.metrology.frames import Floats
from app.metrology.refusal import Refusal
from app.station.painter import Traits
from app.station.picking import FrontSurface, Rectangle, ViewCamera

MOST_FITTED = 300_000
"""Of more points in a region, every second, third, and so on is fitted."""
FRAMES_A_SCAN = 1 << 40
"""Frames of different scans are told apart by this."""


@dataclass(frozen=True)
class ShownCloud:
    """A scan in the picture: what is shown of it, and its file once it is complete."""

    points_mm: Floats
    traits: Traits
    voxel_mm: float
    file: Path | None


@dataclass(frozen=True)
class Picked:
    """Points of a region."""

    points_mm: Floats
    """(N, 3), evenly out of ``count``."""
    frame: NDArray[np.int64]
    """(N,)"""
    count: int
    every: bool
    """Whether files gave all points, or the thinned ones of the picture had to do."""


def pick(camera: ViewCamera, rectangle: Rectangle, clouds: list[ShownCloud]) -> Picked:
    """The points on the surface in front, under a rectangle of the picture.

    Raises:
        Refusal: there are none.
    """
    shown = [cloud.points_mm for cloud in clouds]
    surface = FrontSurface(
        camera,
        rectangle,
        np.concatenate(shown) if shown else np.zeros((0, 3)),
        max((cloud.voxel_mm for cloud in clouds), default=0.0),
    )
    if surface.empty:
        raise Refusal(
            "nothing-picked",
            "There are no points in the rectangle",
            remedy="draw it over a part of the cloud",
        )
    gathered, every = _Gathered(), True
    for number, cloud in enumerate(clouds):
        for points, frame in _points_of(cloud):
            held = surface.holds(points)
            gathered.add(points[held], frame[held] + number * FRAMES_A_SCAN)
        every = every and cloud.file is not None
    points, frame = gathered.all()
    return Picked(points, frame, gathered.count, every)


def _points_of(cloud: ShownCloud) -> Iterator[tuple[Floats, NDArray[np.int64]]]:
    if cloud.file is None:
        # frames are not kept of what is shown; those of one moment stand for one
        moments = np.unique(cloud.traits["taken_s"], return_inverse=True)[1]
        yield cloud.points_mm, moments.astype(np.int64)
        return
    for points, _ in cloud_pieces(cloud.file):
        places = np.column_stack([points["x"], points["y"], points["z"]])
        yield places, points["frame"].astype(np.int64)


class _Gathered:
    """Evenly thinned when it grows too large."""

    def __init__(self) -> None:
        self.count = 0
        self._step = 1
        self._kept = 0
        self._parts: list[tuple[Floats, NDArray[np.int64]]] = []

    def add(self, points: Floats, frame: NDArray[np.int64]) -> None:
        first = -self.count % self._step
        self.count += len(points)
        part = (points[first :: self._step], frame[first :: self._step])
        self._parts.append(part)
        self._kept += len(part[0])
        if self._kept > 2 * MOST_FITTED:
            self._thin(2)

    def all(self) -> tuple[Floats, NDArray[np.int64]]:
        """At most ``MOST_FITTED`` points and their frames."""
        if self._kept > MOST_FITTED:
            self._thin(-(-self._kept // MOST_FITTED))
        points, frame = self._joined()
        return points, frame

    def _joined(self) -> tuple[Floats, NDArray[np.int64]]:
        return (
            np.concatenate([points for points, _ in self._parts]),
            np.concatenate([frame for _, frame in self._parts]),
        )

    def _thin(self, by: int) -> None:
        points, frame = self._joined()
        self._step *= by
        self._parts = [(points[::by], frame[::by])]
        self._kept = len(self._parts[0][0])
