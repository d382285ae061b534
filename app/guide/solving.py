"""From the session's folder to its calibration file, and what the browser shows of it."""

from collections.abc import Mapping, Sequence
from dataclasses import replace

import numpy as np

from app.files.calibrate import joint_inputs, origin_of
from app.files.calibration import CalibrationFile, calibration_in
from app.files.calibration_sheet import joint_sheet
from app.files.session import read_session
from app.guide.journal import Calibration
from app.guide.live import Chosen
from app.guide.outcome import Outcome, PoseDrawing
from app.guide.session_folder import SessionFolder
from app.guide.touching import sentence
from app.guide.view import (
    BudgetRow,
    CalibrationResult,
    Comparison,
    FaceResult,
    ImageCorner,
    MapPoint,
    MovedPoint,
    PlaneKnown,
    PoseRow,
    WorstPoint,
)
from app.metrology import findings as metrology
from app.metrology.adjustment.block_start import SeenPose
from app.metrology.adjustment.joint import (
    JointCalibration,
    JointInputs,
    Progress,
    calibrate_joint,
    see_pose,
)
from app.metrology.adjustment.pose_results import PoseResult
from app.metrology.adjustment.uncertainty import UncertaintyMap
from app.metrology.detection.evidence import DetectionRefusal
from app.metrology.findings import Limits
from app.metrology.frames import Floats, apply
from app.metrology.reconstruct import sensor_points
from app.metrology.refusal import Refusal
from app.metrology.stripe import Stripe, extract_stripe
from app.station.capture import Capture
from app.station.findings import Finding
from app.station.object_watch import outline, seen_corners
from app.station.picture_words import picture_words, refused

SHOWN_STRIPE_POINTS = 300


def look_at(taken: Capture, chosen: Chosen, number: int) -> tuple[Outcome, SeenPose | Refusal]:
    """What a fresh capture shows, so that a useless picture is told of at once."""
    assert chosen.block is not None
    assert chosen.sensor is not None
    ambient = taken.ambient.image
    laser = None if taken.laser is None else taken.laser.image
    findings = [_told(finding) for finding in picture_words(ambient)]
    stripe = extract_stripe(ambient if laser is None else laser, chosen.sensor.stripe_axis)
    if len(stripe.u) == 0:
        findings.append(
            Finding(
                "bad",
                "No laser stripe is in the picture.",
                "Check the laser and the exposure, then take a new picture.",
            )
        )
    try:
        seen = see_pose(number, chosen.block, ambient, laser, chosen.sensor.stripe_axis)
    except Refusal as refusal:
        return _unusable(refusal, stripe, findings), refusal
    corners = [
        ImageCorner(corner.name, corner.u, corner.v, corner.residual_px)
        for corner in seen_corners(seen.detection, chosen.block)
    ]
    outcome = Outcome(
        corners, outline(seen.detection, chosen.block), _shown(stripe), findings, None
    )
    return outcome, seen


def _told(finding: Finding) -> Finding:
    return Finding(finding.quality, sentence(finding.text), sentence(finding.remedy))


def _unusable(refusal: Refusal, stripe: Stripe, findings: Sequence[Finding]) -> Outcome:
    """A picture that was declined: which of exposure, focus, framing, object or lighting is at
    fault, and what shows it."""
    told = _told(refused(refusal))
    if not isinstance(refusal, DetectionRefusal):
        first = Finding("bad", told.text, told.remedy)
        return Outcome((), (), _shown(stripe), [first, *findings], None)
    named = f"{refusal.fault.capitalize()} is at fault. {told.text}"
    # the picture's own words say the same again
    others = [] if refusal.fault in ("exposure", "focus") else findings
    return Outcome(
        corners=(),
        outline=(),
        stripe=_shown(stripe),
        findings=[Finding("bad", named, told.remedy), *others],
        result=None,
        marks=refusal.marks,
        fault=refusal.fault,
    )


def solve(
    folder: SessionFolder,
    in_use: Calibration | None,
    progress: Progress,
    known: Mapping[int, SeenPose | Refusal],
    limits: Limits,
    points: Sequence[int],
) -> Outcome:
    """Calibrates the session as the command line does, and writes ``calibration.json``.

    Args:
        known: what the pictures of poses show, by number, where they were looked at.
        points: the index of the touched point that each row of the contacts is.

    Raises:
        Refusal: by its reason; a calibration file of an earlier solve is then gone.
    """
    folder.calibration.unlink(missing_ok=True)
    session = read_session(folder.path)
    inputs = joint_inputs(session, limits, lambda share, text: progress(text, share), known)
    result = calibrate_joint(inputs, progress)
    sheet = joint_sheet(result, origin_of(session, session.poses, operator=""))
    sheet.write(folder.calibration)
    drawings = _drawings(result, inputs)
    return Outcome(
        corners=(),
        outline=(),
        stripe=(),
        findings=[Finding(f.quality, f.text, f.remedy, f.pose) for f in result.findings],
        result=replace(
            _result(result, sheet, compare(result, sheet, in_use)),
            shown_pose=_worst_fitting(result).number,
            worst=[_worst(point, drawings, points) for point in result.worst],
            good_um=limits.good_um,
            usable_um=limits.usable_um,
        ),
        poses=tuple(drawings.values()),
    )


def _drawings(result: JointCalibration, inputs: JointInputs) -> dict[int, PoseDrawing]:
    """Of the poses that were used, by number: corners with what the adjustment left of them."""
    left = {pose.number: pose for pose in result.poses if pose.used}
    return {
        seen.number: PoseDrawing(
            seen.number,
            [
                ImageCorner(corner.name, corner.u, corner.v, float(np.hypot(du, dv)), (du, dv))
                for corner, (_, du, dv) in zip(
                    seen.detection.corners, left[seen.number].corners_px, strict=True
                )
            ],
            outline(seen.detection, inputs.block),
            _shown(seen.stripe),
            left[seen.number].stripe_off_px,
        )
        for seen in inputs.seen
        if seen.number in left
    }


def _worst(
    point: metrology.WorstPoint, drawings: Mapping[int, PoseDrawing], points: Sequence[int]
) -> WorstPoint:
    """One of the worst points with the place where it is shown."""
    if point.contact is not None:
        index = points[point.contact]
        face = point.name.split()[0]
        return WorstPoint(point.kind, f"{face}, point {index + 1}", point.value, point.unit, index)
    at_px = point.at_px
    if at_px is None and point.pose is not None:
        corners = drawings[point.pose].corners
        at_px = next((c.u, c.v) for c in corners if point.name.endswith(f" {c.name}"))
    return WorstPoint(point.kind, point.name, point.value, point.unit, None, point.pose, at_px)


def _worst_fitting(result: JointCalibration) -> PoseResult:
    """The pose whose picture is worth looking at: its edges fit worst."""
    used = [pose for pose in result.poses if pose.used]
    return max(used, key=lambda pose: pose.edges_rms_px)


def _shown(stripe: Stripe) -> list[tuple[float, float]]:
    """The stripe thinned for drawing."""
    step = max(1, -(-len(stripe.u) // SHOWN_STRIPE_POINTS))
    return [
        (round(float(u), 2), round(float(v), 2))
        for u, v in zip(stripe.u[::step], stripe.v[::step], strict=True)
    ]


def _verdict(found: Sequence[metrology.Finding]) -> str:
    """How well a point is known, and what helps; or that something else is graver."""
    known = next(one for one in found if one.code == "uncertainty")
    if found[0].quality != known.quality:
        return f"{sentence(known.text)} But what is marked below needs attention."
    return f"{sentence(known.text)} {sentence(known.remedy)}".strip()


def _result(
    result: JointCalibration,
    sheet: CalibrationFile,
    comparison: Comparison | None,
) -> CalibrationResult:
    residuals, known = sheet.residuals, result.known
    assert residuals is not None
    return CalibrationResult(
        verdict=result.findings[0].quality,
        verdict_text=_verdict(result.findings),
        reprojection_rms_px=residuals.reprojection_rms_px,
        laser_plane_rms_um=result.stripe_rms_um,
        alignment_rms_um=1e3 * result.alignment.rms_mm,
        depth_range_mm=result.depth_range_mm,
        probe_matrix=result.T_flange_sensor.tolist(),
        faces=[
            FaceResult(face.face, face.points, 1e3 * face.rms_mm, 1e3 * face.form_mm)
            for face in result.alignment.faces
        ],
        budget=[BudgetRow(row.source, row.value_um) for row in known.rows],
        total_um=known.total_um,
        plane=PlaneKnown(known.plane.angle_arcsec, known.plane.offset_um),
        map=_map(known.map),
        poses=[
            PoseRow(
                pose.number,
                pose.used,
                pose.reason,
                pose.edges_rms_px,
                pose.stripe_rms_px if pose.stripe_points else None,
                pose.off_um,
            )
            for pose in result.poses
        ],
        worst=(),
        comparison=comparison,
        distortion=result.camera.distortion.tolist(),
    )


def _map(over: UncertaintyMap) -> Sequence[MapPoint]:
    """The map as drawn on the laser plane: along the stripe, and in depth."""
    return [
        MapPoint(round(float(u), 1), round(float(v), 1), round(float(value), 3), bool(inside))
        for (u, v), value, inside in zip(over.uv_px, over.u_um, over.calibrated, strict=True)
    ]


def compare(
    result: JointCalibration,
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
    old = calibration_in(before)

    def moved_um(uv_px: Floats) -> Floats:
        points = apply(result.T_flange_sensor, sensor_points(result.camera, result.plane, uv_px))
        others = apply(old.T_flange_sensor, sensor_points(old.camera, old.plane, uv_px))
        return np.asarray(1e3 * np.linalg.norm(points - others, axis=1))

    in_volume = moved_um(result.known.volume.uv_px)
    if not np.all(np.isfinite(in_volume)):
        return None
    over = result.known.map
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
