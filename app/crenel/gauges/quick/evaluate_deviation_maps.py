"""The deviations of a gauge's clouds from their fitted shapes, and the one scale of all of them.

Wherever they are drawn, they have the colours of ``crenel.metrology.colormaps.BALANCE``: blue
inside the shape, orange outside.
"""

from collections.abc import Sequence
from pathlib import Path
from typing import Annotated, ClassVar

import numpy as np
from pydantic import Field

from crenel.formats.json_document import Document, DocumentPart, Number, Positive, Vector3
from crenel.gauges.quick.maths.scanned_gauge import GaugeCloud
from crenel.metrology.fitting.deviation_map import deviation_map, find_outliers
from crenel.metrology.fitting.plane_sphere import PlaneFit, SphereFit

MAP = "map.json"
WITHIN = 0.98
"""The scale ends where all but so few of the cells lie within."""
LEAST_UM, MOST_UM = 5.0, 1000.0
ROUND = (1.0, 2.0, 5.0)


class OutlierPart(DocumentPart):
    """A place of the map with points too far off the shape to belong to its noise, by that of
    them which is furthest off."""

    x_mm: Number
    y_mm: Number
    deviation_um: Number
    at_mm: Vector3
    """In the arm frame."""
    frame: int
    points: int
    """Outliers at this place; 0: the highest or lowest point of all is here, and is none."""
    is_end: bool
    """Whether it is the highest or lowest point of all in the gate."""


class MapFile(Document):
    """``map.json``: deviations of a cloud from its fitted shape, as in ``DeviationMap``."""

    FORMAT: ClassVar[str] = "crenel/deviations"

    cell_mm: Positive
    x_mm: Annotated[tuple[Number, ...], Field(default_factory=tuple)]
    y_mm: Annotated[tuple[Number, ...], Field(default_factory=tuple)]
    deviation_um: Annotated[tuple[Number, ...], Field(default_factory=tuple)]
    outliers: tuple[OutlierPart, ...] = ()
    """The outliers among all points in the gate; the furthest first. Empty in older files."""
    outlier_points: int = 0
    """In all, also at places that are not listed."""


def map_record(found: GaugeCloud) -> MapFile:
    """The map of a cloud, with the outliers among all points of its gate."""
    fit = found.shape.fit
    assert isinstance(fit, PlaneFit | SphereFit)
    cells = deviation_map(fit, found.points_mm)
    outliers = find_outliers(
        fit, found.points_mm, found.gate_mm, found.unfiltered.off_mm, cells.cell_mm
    )
    return MapFile(
        cell_mm=cells.cell_mm,
        x_mm=tuple(np.round(cells.x_mm, 3).tolist()),
        y_mm=tuple(np.round(cells.y_mm, 3).tolist()),
        deviation_um=tuple(np.round(cells.deviation_um, 2).tolist()),
        outliers=tuple(
            OutlierPart(
                x_mm=round(x, 3),
                y_mm=round(y, 3),
                deviation_um=round(off, 2),
                at_mm=tuple(np.round(found.gate_mm[i], 4).tolist()),
                frame=int(found.gate_frame[i]),
                points=points,
                is_end=is_end,
            )
            for x, y, off, i, points, is_end in zip(
                outliers.x_mm.tolist(),
                outliers.y_mm.tolist(),
                outliers.deviation_um.tolist(),
                outliers.index.tolist(),
                outliers.points.tolist(),
                outliers.is_end.tolist(),
                strict=True,
            )
        ),
        outlier_points=outliers.all_points,
    )


def scale_end_um(maps: Sequence[MapFile]) -> float:
    """Where the scale ends on both sides, in µm: a round number for the cells of all maps.

    Example:
        >>> scale_end_um([MapFile(cell_mm=1, x_mm=(0,), y_mm=(0,), deviation_um=(-13.0,))])
        20.0
    """
    sizes = np.abs([value for cells in maps for value in cells.deviation_um])
    most = float(np.quantile(sizes, WITHIN)) if len(sizes) else 0.0
    rounds = (first * 10.0**power for power in range(4) for first in ROUND)
    return next(end for end in rounds if end >= LEAST_UM and (end >= most or end >= MOST_UM))


def read_maps(cloud_folders: Sequence[Path]) -> dict[Path, MapFile]:
    """The maps of clouds by their folders, as far as they have one; raises ``OperationError``."""
    return {
        folder: MapFile.read(folder / MAP) for folder in cloud_folders if (folder / MAP).is_file()
    }
