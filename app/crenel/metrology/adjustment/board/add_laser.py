"""The laser plane added to a camera and mounting that were calibrated before."""

from dataclasses import replace

import numpy as np

from crenel.errors import OperationError
from crenel.messages.message import message, quantity
from crenel.metrology.adjustment.board.calibrate import BoardCalibration, calibrate_board
from crenel.metrology.adjustment.board.problem import BoardInputs
from crenel.metrology.adjustment.core.kept_sensor import KeptSensor
from crenel.metrology.adjustment.results.findings import joint_rms
from crenel.metrology.calibration.findings import CalibrationFinding, sort_by_severity
from crenel.progress import Progress, no_progress

# The kept camera no longer fits if it leaves more than this, and this multiple of what a camera
# of the same pictures leaves; or if the arm would have to be this many times less exact.
FITS_PX, FITS_TIMES = 0.3, 3.0


def add_laser(
    inputs: BoardInputs, kept: KeptSensor, progress: Progress = no_progress
) -> BoardCalibration:
    """The laser plane from pictures with its line, seen by a camera and mounting that are kept.

    Args:
        inputs: as for ``calibrate_board``; the board may lie elsewhere than before.
        kept: camera, mounting and their covariance, which the uncertainty of points includes.

    Returns:
        The calibration in the sensor frame of the kept one.

    Raises:
        OperationError: as ``calibrate_board``; ``laser-was-off``, if no picture was taken with the
            laser; ``camera-changed``, if the kept camera does not fit the pictures.
    """
    if not inputs.with_laser:
        raise OperationError(
            "laser-was-off",
            message("no-picture-was-taken-with-the-laser"),
            "",
            message("add-the-laser-to-camera-and-mounting"),
        )
    result = calibrate_board(inputs, progress, kept)
    rms_px = joint_rms((pose.edges_rms_px, pose.edge_points) for pose in result.poses if pose.used)
    own_px = float(np.sqrt(np.mean(np.square(result.free_scatter_px))))
    times, changed = result.adjustment.scales.noise, None
    if rms_px > max(FITS_PX, FITS_TIMES * own_px):
        rms, own = quantity(rms_px, "px", 2), quantity(own_px, "px", 2)
        changed = message("kept-camera-does-not-fit", rms=rms, own=own)
    elif times > FITS_TIMES:
        changed = message("kept-camera-does-not-fit-the-arm", times=quantity(times, "", 1))
    if changed is not None:
        raise OperationError(
            "camera-changed",
            changed,
            message("focus-zoom-or-lens-changed-since"),
            message("calibrate-camera-and-laser-together"),
        )
    finding = CalibrationFinding("neutral", "camera-kept", message("camera-and-mounting-are-kept"))
    return replace(result, findings=sort_by_severity([*result.findings, finding]))
