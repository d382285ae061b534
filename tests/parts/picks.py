"""Picks in a simulated scan, as an operator draws rectangles over what the view shows of it."""

from dataclasses import dataclass
from pathlib import Path

import numpy as np
from scipy.spatial.transform import Rotation

from crenel.formats.clouds.frame_readings import READINGS
from crenel.formats.clouds.pieces import StoredCloud
from crenel.formats.clouds.points import positions_of
from crenel.formats.datasheets.arm import read_any_arm
from crenel.formats.results.calibration import read_calibration
from crenel.parts.elements.evaluate_element import MeasuredElement, measure_element
from crenel.parts.elements.evaluate_errors import PickedPoints, ScanFiles, StationFiles
from crenel.parts.maths.shapes import Kind
from crenel.station.view3d.cloud_colouring import ATTRIBUTES
from crenel.station.view3d.selection import Rectangle, ViewCamera, VisibleCloud, select_points
from crenel.workflows.reconstruct import reconstruct_cloud
from tests.parts.draws import Setting
from tests.parts.simulated_inspection import (
    PART_PLACE,
    Floats,
    draw_truth,
    scan_part,
    write_station,
)

FAR_MM, FOV_RAD = 500.0, 0.5


@dataclass(frozen=True)
class Pick:
    """A rectangle about a place of the part, seen from a direction."""

    kind: Kind | None
    centre_mm: tuple[float, float, float]
    """Part frame."""
    size_mm: tuple[float, float]
    """Width and height of the rectangle at this place."""
    tilt_deg: float = 0.0
    """From straight above."""
    turn_deg: float = 0.0

    def camera(self) -> ViewCamera:
        """Where the browser looks from."""
        look = Rotation.from_euler("zx", [self.turn_deg, 180.0 - self.tilt_deg], degrees=True)
        R = PART_PLACE[:3, :3] @ look.as_matrix()
        at = PART_PLACE[:3, :3] @ np.array(self.centre_mm) + PART_PLACE[:3, 3]
        x, y, z, w = Rotation.from_matrix(R).as_quat()
        place = (at - FAR_MM * R[:, 2]) / 1e3
        return ViewCamera((w, x, y, z), tuple(place.tolist()), FOV_RAD, 1.0)

    def rectangle(self) -> Rectangle:
        """What is drawn."""
        whole = 2 * FAR_MM * float(np.tan(FOV_RAD / 2))
        w, h = (size / whole / 2 for size in self.size_mm)
        return Rectangle(0.5 - w, 0.5 - h, 0.5 + w, 0.5 + h)


@dataclass(frozen=True)
class ScannedPart:
    """The folder of a scan, with the files of its station."""

    folder: Path
    shown_mm: Floats

    @property
    def files(self) -> ScanFiles:
        folder = self.folder
        own = StationFiles(folder / "calibration.json", folder / "arm.json")
        return ScanFiles(folder / READINGS, (own,))

    def take(self, pick: Pick) -> tuple[PickedPoints, np.ndarray, Floats]:
        """The points of a pick, which of them are in front, and from where they are seen."""
        shown = VisibleCloud(
            self.shown_mm, np.zeros(len(self.shown_mm), ATTRIBUTES), 0.3, self.folder / "cloud.ply"
        )
        camera = pick.camera()
        found = select_points(camera, pick.rectangle(), [shown])
        points = PickedPoints(
            found.points_mm, found.spread_mm, found.frame, found.scan, {0: self.files}
        )
        return points, found.front, 1e3 * np.array(camera.position_m)

    def measure(self, pick: Pick) -> MeasuredElement:
        """The element of a pick, as the panel measures it."""
        return measure_element(pick.kind, *self.take(pick))


def scan_bracket(folder: Path, setting: Setting, seed: int) -> ScannedPart:
    """A scan of the part by a true station drawn by a seed, and its cloud by the files."""
    truth = draw_truth(setting.station, seed)
    write_station(folder, setting.station)
    scan_part(folder / "scan.mcap", setting.true, truth, setting.planned, seed)
    calibration = read_calibration(folder / "calibration.json")
    arm = read_any_arm(folder / "arm.json")
    cloud = folder / "cloud.ply"
    reconstruct_cloud(folder / "scan.mcap", calibration, arm, cloud)
    return ScannedPart(folder, positions_of(StoredCloud(cloud).sample(60_000)))
