"""The scans of the 3D view in which elements are picked, with what their errors follow from."""

import contextlib
from collections.abc import Callable, Sequence
from dataclasses import dataclass
from pathlib import Path

from crenel.formats.results.scan_record import CLOUD
from crenel.station.view3d.scene import Scene
from crenel.station.view3d.selection import VisibleCloud

Paths = tuple[Path, Path]
"""A calibration, and the arm on which it was made."""


@dataclass(frozen=True)
class ScanOrigin:
    """Where the files are by which a scan was made."""

    calibrations: Sequence[Paths] = ()
    """Of each of its sensors, in the order of their names; empty: not on this station."""
    is_merged: bool = False
    """Whether it is made of other scans."""


SourceOf = Callable[[str], ScanOrigin]
"""By the id of a scan."""


@dataclass(frozen=True)
class PickedScan:
    """A scan in the view."""

    cloud: VisibleCloud
    calibrations: Sequence[Paths]
    is_merged: bool


def visible_scans(scene: Scene, scans_dir: Path, source_of: SourceOf) -> list[PickedScan]:
    """All scans in the view, with the files of those that are complete."""
    found = []
    for name in scene.scans:
        with contextlib.suppress(KeyError):  # removed in the meantime
            points_mm, traits, voxel_mm = scene.visible_points(name)
            file = scans_dir / name / CLOUD
            whole = bool(name) and file.is_file()
            if len(points_mm):
                cuts = scene.cuts.get(name, ())
                cloud = VisibleCloud(points_mm, traits, voxel_mm, file if whole else None, cuts)
                source = source_of(name) if whole else ScanOrigin()
                found.append(PickedScan(cloud, source.calibrations, source.is_merged))
    return found
