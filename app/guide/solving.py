"""From the session's folder to its calibration file, and what the browser shows of it."""

import numpy as np

from app.files.calibrate import one_pose_inputs, origin_of
from app.files.calibration import CalibrationFile, Verdict, calibration_in
from app.files.calibration_sheet import one_pose_sheet, worst_of
from app.files.session import read_session
from app.guide.journal import Calibration
from app.guide.live import Chosen
from app.guide.outcome import Outcome
from app.guide.session_folder import SessionFolder
from app.guide.view import (
    BudgetRow,
    CalibrationResult,
    Comparison,
    FaceResult,
    ImageCorner,
    WorstPoint,
)
from app.metrology.budget import volume_pixels
from app.metrology.crenellated import Crenellated
from app.metrology.detection.corners import detect_object
from app.metrology.frames import apply
from app.metrology.one_pose import OnePoseCalibration, Progress, calibrate_one_pose
from app.metrology.reconstruct import sensor_points
from app.metrology.refusal import Refusal
from app.metrology.stripe import Stripe, extract_stripe
from app.station.capture import Capture
from app.station.findings import Finding
from app.station.object_watch import outline, seen_corners
from app.station.picture_words import picture_words, refused

SHOWN_STRIPE_POINTS = 400


def look_at(taken: Capture, chosen: Chosen) -> Outcome:
    """What a fresh capture shows, so that a useless picture is told of at once."""
    assert chosen.block is not None
    assert chosen.sensor is not None
    ambient = taken.ambient.image
    lit = ambient if taken.laser is None else taken.laser.image
    findings = picture_words(ambient)
    stripe = extract_stripe(lit, chosen.sensor.stripe_axis)
    if len(stripe.u) == 0:
        findings.append(
            Finding(
                "bad",
                "No laser stripe is in the picture.",
                "Check the laser and the exposure, then take a new picture.",
            )
        )
    try:
        found = detect_object(ambient, chosen.block, stripe if taken.laser is None else None)
    except Refusal as refusal:
        told = refused(refusal)
        findings.insert(0, Finding("bad", told.text, told.remedy))
        return Outcome((), (), _shown(stripe), findings, None)
    corners = [
        ImageCorner(corner.name, corner.u, corner.v, corner.residual_px)
        for corner in seen_corners(found, chosen.block)
    ]
    return Outcome(corners, outline(found, chosen.block), _shown(stripe), findings, None)


def solve(folder: SessionFolder, in_use: Calibration | None, progress: Progress) -> Outcome:
    """Calibrates the session as the command line does, and writes ``calibration.json``.

    Raises:
        Refusal: by its reason; a calibration file of an earlier solve is then gone.
    """
    folder.calibration.unlink(missing_ok=True)
    session = read_session(folder.path)
    pose = session.poses[0]
    inputs = one_pose_inputs(session, pose)
    result = calibrate_one_pose(inputs, progress)
    sheet = one_pose_sheet(result, origin_of(session, (pose,), operator=""))
    sheet.write(folder.calibration)
    corners = [
        ImageCorner(corner.name, corner.u, corner.v, float(np.hypot(*residual)))
        for corner, residual in zip(
            result.detection.corners, result.corner_residuals_px, strict=True
        )
    ]
    return Outcome(
        corners=corners,
        outline=outline(result.detection, session.block),
        stripe=_shown(result.stripe),
        findings=[Finding(f.quality, f.text, f.remedy) for f in result.findings],
        result=_result(result, sheet, compare(result, session.block, sheet, in_use)),
    )


def _shown(stripe: Stripe) -> list[tuple[float, float]]:
    """The stripe thinned for drawing."""
    step = max(1, -(-len(stripe.u) // SHOWN_STRIPE_POINTS))
    return [
        (round(float(u), 2), round(float(v), 2))
        for u, v in zip(stripe.u[::step], stripe.v[::step], strict=True)
    ]


def _result(
    result: OnePoseCalibration, sheet: CalibrationFile, comparison: Comparison | None
) -> CalibrationResult:
    verdict = sheet.verdict or Verdict(quality=worst_of([]), text="")
    text = verdict.text
    return CalibrationResult(
        verdict=verdict.quality,
        verdict_text=f"{text[:1].upper()}{text[1:]}.",
        reprojection_rms_px=result.reprojection_rms_px,
        laser_plane_rms_um=1e3 * result.laser.rms_mm,
        alignment_rms_um=1e3 * result.alignment.rms_mm,
        depth_range_mm=result.depth_range_mm,
        probe_matrix=result.T_flange_sensor.tolist(),
        faces=[
            FaceResult(face.face, face.points, 1e3 * face.rms_mm, 1e3 * face.form_mm)
            for face in result.alignment.faces
        ],
        budget=[BudgetRow(row.source, row.value_um) for row in result.budget],
        total_um=result.total_um,
        worst=[WorstPoint(p.kind, p.name, p.value, p.unit) for p in result.worst],
        comparison=comparison,
        condition_number=result.faugeras.condition_number,
        distortion=result.camera.distortion.tolist(),
    )


def compare(
    result: OnePoseCalibration,
    block: Crenellated,
    sheet: CalibrationFile,
    in_use: Calibration | None,
) -> Comparison | None:
    """How far points of the measuring volume move against the calibration in use.

    None where there is none for the same arm and sensor. The sensor frames of two
    calibrations differ, so the same pixels are compared in the flange frame.
    """
    if in_use is None:
        return None
    try:
        before = CalibrationFile.read(in_use.file)
    except Refusal:
        return None
    was, now = before.serial_numbers, sheet.serial_numbers
    if (was.arm, was.sensor) != (now.arm, now.sensor):
        return None
    uv = volume_pixels(result.camera, result.plane, block)
    old = calibration_in(before)
    points = apply(result.T_flange_sensor, sensor_points(result.camera, result.plane, uv))
    others = apply(old.T_flange_sensor, sensor_points(old.camera, old.plane, uv))
    shift_um = 1e3 * np.linalg.norm(points - others, axis=1)
    if not np.all(np.isfinite(shift_um)):
        return None
    rms_um = float(np.sqrt(np.mean(shift_um**2)))
    return Comparison(in_use.name, float(shift_um.max()), rms_um)
