"""What a person cut away of a scan in the 3D view: of its display and of saved clouds.

The recording and ``cloud.ply`` stay whole; the cuts are in ``cuts.json`` beside them.
"""

from collections.abc import Iterator, Sequence
from dataclasses import dataclass
from pathlib import Path
from typing import ClassVar

import numpy as np
from numpy.typing import NDArray

from crenel.formats.clouds.files import cloud_writer
from crenel.formats.clouds.pieces import StoredCloud, read_cloud_pieces
from crenel.formats.clouds.points import Points, positions_of
from crenel.formats.json_document import Document, DocumentPart, Row4
from crenel.metrology.transforms import Floats

FILE = "cuts.json"
Planes = tuple[tuple[float, float, float, float], ...]
"""Rows ``a b c d`` in the arm frame, mm: a point is inside where ``a x + b y + c z + d`` is zero or
more for each."""


@dataclass(frozen=True)
class Cut:
    """A part of space that is bounded by planes, or all but that part."""

    planes: Planes
    outside: bool
    """What lies outside is cut away."""
    made_ns: int
    """Time of the cut; the cuts of several scans by one act have the same."""

    def holds(self, points_mm: Floats) -> NDArray[np.bool_]:
        """Mask of the points (N, 3) that are cut away."""
        planes = np.array(self.planes)
        inside = (points_mm @ planes[:, :3].T + planes[:, 3] >= 0).all(axis=1)
        return np.asarray(~inside if self.outside else inside)


def cut_mask(cuts: Sequence[Cut], points_mm: Floats) -> NDArray[np.bool_]:
    """Mask of the points (N, 3) that any of the cuts holds."""
    found = np.zeros(len(points_mm), dtype=bool)
    for cut in cuts:
        found |= cut.holds(points_mm)
    return found


class _CutPart(DocumentPart):
    planes: tuple[Row4, ...]
    outside: bool
    made_ns: int


class CutsFile(Document):
    """The cuts of a scan."""

    FORMAT: ClassVar[str] = "crenel/cuts"

    cuts: tuple[_CutPart, ...]


def read_cuts(folder: Path) -> tuple[Cut, ...]:
    """The cuts of the scan in a folder; none where it has no file of them.

    Raises:
        OperationError: the file is damaged.
    """
    if not (folder / FILE).is_file():
        return ()
    found = CutsFile.read(folder / FILE).cuts
    return tuple(Cut(cut.planes, cut.outside, cut.made_ns) for cut in found)


def write_cuts(folder: Path, cuts: Sequence[Cut]) -> None:
    """Writes the cuts of the scan in a folder."""
    parts = tuple(
        _CutPart(planes=cut.planes, outside=cut.outside, made_ns=cut.made_ns) for cut in cuts
    )
    CutsFile(cuts=parts).write(folder / FILE)


def read_kept_pieces(cloud: Path) -> Iterator[tuple[Points, float]]:
    """Points of the ``cloud.ply`` of a scan as ``read_cloud_pieces`` gives them, without what was
    cut away.

    Raises:
        OperationError: cloud or cuts are missing, truncated, or not as the station writes them.
    """
    cuts = read_cuts(cloud.parent)
    for points, share in read_cloud_pieces(cloud):
        yield _without(cuts, points), share


def sample_kept(cloud: Path, most: int) -> Points:
    """At most so many points of the ``cloud.ply`` of a scan, evenly from all, without what was cut
    away.

    Raises:
        OperationError: as ``read_kept_pieces``.
    """
    return _without(read_cuts(cloud.parent), StoredCloud(cloud).sample(most))


def copy_cloud(cloud: Path, target: Path) -> None:
    """Copies the ``cloud.ply`` of a scan to another format, without what was cut away.

    Args:
        target: in the format by its name.

    Raises:
        OperationError: as ``read_kept_pieces``, or ``target`` cannot be written.
    """
    with cloud_writer(target) as writer:
        for points, _ in read_kept_pieces(cloud):
            writer.append(points)


def _without(cuts: Sequence[Cut], points: Points) -> Points:
    return points[~cut_mask(cuts, positions_of(points))] if cuts else points
