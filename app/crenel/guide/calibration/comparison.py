"""How far scanned points move between two calibrations."""

import numpy as np

from crenel.errors import OperationError
from crenel.formats.results.calibration import (
    CalibrationFile,
    calibration_from_document,
    read_calibration,
)
from crenel.guide.common.journal import StoredCalibration
from crenel.guide.common.result_view import Comparison, MovedPoint
from crenel.metrology.sensor.triangulation import sensor_points
from crenel.metrology.transforms import Floats, apply


def compare(
    document: CalibrationFile, volume_px: Floats, in_use: StoredCalibration | None
) -> Comparison | None:
    """How far points of the measuring volume move against the calibration in use.

    None where there is none for the same arm and sensor. The sensor frames of two
    calibrations differ, so the same pixels are compared in the flange frame.

    Args:
        volume_px: (G, 2) pixels of the measuring volume.
    """
    over = document.uncertainty.map if document.uncertainty else None
    if in_use is None or over is None:
        return None
    try:
        old = read_calibration(in_use.file)
    except OperationError:
        return None
    new = calibration_from_document(document)
    was, now = old.serial_numbers, new.serial_numbers
    if (was.arm, was.sensor) != (now.arm, now.sensor):
        return None

    def moved_um(uv_px: Floats) -> Floats:
        points, others = (
            apply(one.T_flange_sensor, sensor_points(one.camera, one.plane, uv_px))
            for one in (new, old)
        )
        return np.asarray(1e3 * np.linalg.norm(points - others, axis=1))

    in_volume = moved_um(volume_px)
    if not np.all(np.isfinite(in_volume)):
        return None
    on_map = moved_um(np.array(over.uv_px))
    moved = [
        MovedPoint(round(u, 1), round(v, 1), round(float(um), 3))
        for (u, v), um in zip(over.uv_px, on_map, strict=True)
        if np.isfinite(um)
    ]
    # The map is drawn beside the figure: none of its points within the depths says more.
    drawn = on_map[np.array(over.calibrated) & np.isfinite(on_map)]
    rms_um = float(np.sqrt(np.mean(in_volume**2)))
    most_um = float(max(in_volume.max(), drawn.max(initial=0.0)))
    return Comparison(in_use.name, most_um, rms_um, moved)
