"""How far scanned points move between two calibrations."""

import numpy as np

from app.errors import OperationError
from app.formats.results.calibration import CalibrationFile, calibration_from_document
from app.guide.common.journal import StoredCalibration
from app.guide.common.result_view import Comparison, MovedPoint
from app.metrology.adjustment.block.calibrate import BlockCalibration
from app.metrology.adjustment.board.calibrate import BoardCalibration
from app.metrology.sensor.triangulation import sensor_points
from app.metrology.transforms import Floats, apply


def compare(
    result: BlockCalibration | BoardCalibration,
    document: CalibrationFile,
    in_use: StoredCalibration | None,
) -> Comparison | None:
    """How far points of the measuring volume move against the calibration in use.

    None where there is none for the same arm and sensor. The sensor frames of two
    calibrations differ, so the same pixels are compared in the flange frame.
    """
    if in_use is None:
        return None
    try:
        before = CalibrationFile.read(in_use.file)
    except OperationError:
        return None
    was, now = before.serial_numbers, document.serial_numbers
    if (was.arm, was.sensor) != (now.arm, now.sensor):
        return None
    old = calibration_from_document(before)

    def moved_um(uv_px: Floats) -> Floats:
        points = apply(result.T_flange_sensor, sensor_points(result.camera, result.plane, uv_px))
        others = apply(old.T_flange_sensor, sensor_points(old.camera, old.plane, uv_px))
        return np.asarray(1e3 * np.linalg.norm(points - others, axis=1))

    in_volume = moved_um(result.uncertainty.volume.uv_px)
    if not np.all(np.isfinite(in_volume)):
        return None
    over = result.uncertainty.map
    on_map = moved_um(over.uv_px)
    moved = [
        MovedPoint(round(float(u), 1), round(float(v), 1), round(float(um), 3))
        for (u, v), um in zip(over.uv_px, on_map, strict=True)
        if np.isfinite(um)
    ]
    # The map is drawn beside the figure: none of its points within the depths says more.
    drawn = on_map[over.calibrated & np.isfinite(on_map)]
    rms_um = float(np.sqrt(np.mean(in_volume**2)))
    most_um = float(max(in_volume.max(), drawn.max(initial=0.0)))
    return Comparison(in_use.name, most_um, rms_um, moved)
