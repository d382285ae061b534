"""Calibrates a session folder, as ``crenel calibrate`` does.

The simulator plays the operator. It writes a session folder (docs/formats.md) with images, joint
angles and contact points. It also returns the truth, which only the last lines here read.
"""

import tempfile
from pathlib import Path

import numpy as np

from crenel import calibrate_session, calibration_from_document, sensor_points
from crenel_hardware.simulator.session import SessionPlan, render_session


def main(folder: Path) -> None:
    session = folder / "session"
    truth = render_session(session, seed=1, plan=SessionPlan(poses=4, width_px=640, height_px=512))
    print("session:", ", ".join(sorted(path.name for path in session.iterdir())))

    # The document is what calibration.json holds: result, uncertainty, residuals, verdict.
    document, warnings = calibrate_session(session, folder / "calibration.json")
    for warning in warnings:
        print("warning:", warning)
    assert document.verdict is not None
    assert document.uncertainty is not None
    print(f"poses used: {sum(pose.used for pose in document.poses)} of {len(document.poses)}")
    print(f"verdict: {document.verdict.quality}")
    for finding in document.verdict.findings:
        print(f"  {finding.quality}: {finding.code}")
    print(f"standard uncertainty of a point: {document.uncertainty.total_um:.1f} µm (k = 1)")
    for part in document.uncertainty.budget:
        print(f"  {part.source}: {part.value_um:.1f} µm")

    # Pixels of the stripe become points on the laser plane, then points in the flange frame.
    calibration = calibration_from_document(document)
    in_sensor = sensor_points(calibration.camera, calibration.plane, np.array(truth["pixels"]))
    rotation, origin_mm = np.split(calibration.T_flange_sensor[:3], [3], axis=1)
    in_flange = in_sensor @ rotation.T + origin_mm.T
    true_mm = np.array(truth["points_flange_frame_mm"], dtype=np.float64)
    error_mm = np.linalg.norm(in_flange - true_mm, axis=1)
    print(f"true error of a point: {1e3 * np.sqrt(np.mean(error_mm**2)):.1f} µm rms")


if __name__ == "__main__":
    with tempfile.TemporaryDirectory() as temporary:
        main(Path(temporary))
