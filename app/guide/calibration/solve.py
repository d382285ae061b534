"""From the session's folder to its calibration file, and what the browser shows of it."""

from collections.abc import Mapping, Sequence
from dataclasses import replace

import numpy as np

from app.errors import OperationError, sentence
from app.findings import Finding
from app.formats.results.calibration import CalibrationFile
from app.formats.results.calibration_builder import board_document, joint_document
from app.formats.session.calibration_session import BlockSession, BoardSession, read_any_session
from app.guide.calibration.comparison import compare
from app.guide.calibration.outcome import CalibrationOutcome, PoseDrawing
from app.guide.calibration.poses.detection import draw_detection, thin_stripe
from app.guide.calibration.session_folder import SessionFolder
from app.guide.calibration.touch.board import FACE
from app.guide.common.journal import StoredCalibration
from app.guide.common.result_view import (
    BudgetLine,
    CalibrationResult,
    Comparison,
    FaceResult,
    MapPoint,
    PlaneKnown,
    PoseRow,
    WorstPointLine,
)
from app.guide.common.view import ImageCorner, TouchedPoint
from app.messages.message import Text, join, message, word
from app.metrology.adjustment.block.calibrate import BlockCalibration, Progress, calibrate_block
from app.metrology.adjustment.board.calibrate import BoardCalibration, calibrate_board
from app.metrology.adjustment.core.uncertainty import UncertaintyMap
from app.metrology.adjustment.results.poses import PoseResult
from app.metrology.calibration import findings as metrology
from app.metrology.calibration.uncertainty_budget import source_text
from app.metrology.limits import Limits
from app.metrology.targets.target import CalibrationTarget
from app.metrology.transforms import apply, inverse
from app.workflows.calibrate import AnyDetection, board_inputs, calibration_origin, joint_inputs

AnyCalibration = BlockCalibration | BoardCalibration


def solve(
    folder: SessionFolder,
    in_use: StoredCalibration | None,
    progress: Progress,
    known: Mapping[int, AnyDetection | OperationError],
    limits: Limits,
    points: Sequence[int],
) -> CalibrationOutcome:
    """Calibrates the session as the command line does, and writes ``calibration.json``.

    Args:
        known: what the pictures of poses show, by number, where they were looked at.
        points: the index of the touched point that each row of the contacts is.

    Raises:
        OperationError: by its reason; a calibration file of an earlier solve is then gone.
    """
    folder.calibration.unlink(missing_ok=True)
    session = read_any_session(folder.path)
    result, document, drawings, touched = _calibrate(session, progress, known, limits, points)
    document.write(folder.calibration)
    return CalibrationOutcome(
        corners=(),
        outline=(),
        stripe=(),
        findings=[Finding(f.quality, f.text, f.remedy, f.pose) for f in result.findings],
        result=replace(
            _result(result, document, compare(result, document, in_use)),
            shown_pose=_worst_fitting(result).number,
            worst=[_worst(point, drawings, points) for point in result.worst],
            good_um=limits.good_um,
            usable_um=limits.usable_um,
        ),
        poses=tuple(drawings.values()),
        points=touched,
    )


def _calibrate(
    session: BlockSession | BoardSession,
    progress: Progress,
    known: Mapping[int, AnyDetection | OperationError],
    limits: Limits,
    points: Sequence[int],
) -> tuple[AnyCalibration, CalibrationFile, dict[int, PoseDrawing], tuple[TouchedPoint, ...]]:
    """The calibration, its file, what its poses are drawn with, and a board's touched points."""

    def looked(share: float, text: Text) -> None:
        progress(text, share)

    origin = calibration_origin(session, session.poses, operator="")
    if isinstance(session, BoardSession):
        of_board = board_inputs(session, limits, looked, known)
        on_board = calibrate_board(of_board, progress)
        drawings = _drawings(on_board, of_board.observations, session.board)
        return on_board, board_document(on_board, origin), drawings, _on_board(on_board, points)
    of_block = joint_inputs(session, limits, looked, known)
    on_block = calibrate_block(of_block, progress)
    drawings = _drawings(on_block, of_block.observations, session.block)
    return on_block, joint_document(on_block, origin), drawings, ()


def _drawings(
    result: AnyCalibration, seen: Sequence[AnyDetection], item: CalibrationTarget
) -> dict[int, PoseDrawing]:
    """Of the poses that were used, by number: corners with what the adjustment left of them."""
    left = {pose.number: pose for pose in result.poses if pose.used}
    return {
        one.number: PoseDrawing(
            one.number,
            _corners(left[one.number]),
            draw_detection(one, item).outline,
            thin_stripe(one.stripe),
            left[one.number].stripe_off_px,
        )
        for one in seen
        if one.number in left
    }


def _corners(pose: PoseResult) -> list[ImageCorner]:
    return [
        ImageCorner(name, u, v, float(np.hypot(du, dv)), (du, dv))
        for (name, u, v), (_, du, dv) in zip(pose.corners_at_px, pose.corners_px, strict=True)
    ]


def _on_board(result: BoardCalibration, points: Sequence[int]) -> tuple[TouchedPoint, ...]:
    """The touched points where the pictures put them on the board."""
    touches, contacts = result.adjustment.problem.contacts, result.contacts
    if touches is None or contacts is None:
        return ()
    at_mm = apply(inverse(result.T_arm_obj), touches.tips_mm) - [0.0, 0.0, touches.radius_mm]
    return tuple(
        TouchedPoint(index, FACE, (float(x), float(y), 0.0), float(um), bool(out))
        for index, (x, y, _), um, out in zip(
            points, at_mm, contacts.residuals_um, contacts.excluded, strict=True
        )
    )


def _worst(
    point: metrology.WorstResidual, drawings: Mapping[int, PoseDrawing], points: Sequence[int]
) -> WorstPointLine:
    """One of the worst points with the place where it is shown."""
    if point.contact is not None:
        index = points[point.contact]
        return WorstPointLine(
            point.kind,
            message("point-2", face=word(point.face), index=index + 1),
            point.value,
            point.unit,
            index,
        )
    at_px = point.at_px
    if at_px is None and point.pose is not None:
        corners = drawings[point.pose].corners
        at_px = next((c.u, c.v) for c in corners if c.name == point.corner)
    return WorstPointLine(point.kind, point.name, point.value, point.unit, None, point.pose, at_px)


def _worst_fitting(result: AnyCalibration) -> PoseResult:
    """The pose whose picture is worth looking at: its edges fit worst."""
    used = [pose for pose in result.poses if pose.used]
    return max(used, key=lambda pose: pose.edges_rms_px)


def _verdict(found: Sequence[metrology.CalibrationFinding]) -> Text:
    """How well a point is known, and what helps; or that something else is graver."""
    known = next(one for one in found if one.code == "uncertainty")
    text = sentence(known.text)
    if found[0].quality != known.quality:
        return join([text, message("but-what-marked-below-needs-attention")], " ")
    return join([text, sentence(known.remedy)], " ") if known.remedy else text


def _result(
    result: AnyCalibration,
    document: CalibrationFile,
    comparison: Comparison | None,
) -> CalibrationResult:
    residuals, known = document.residuals, result.uncertainty
    assert residuals is not None
    return CalibrationResult(
        verdict=result.findings[0].quality,
        verdict_text=_verdict(result.findings),
        reprojection_rms_px=residuals.reprojection_rms_px,
        laser_plane_rms_um=result.stripe_rms_um,
        alignment_rms_um=_contacts_rms_um(result),
        depth_range_mm=result.depth_range_mm,
        probe_matrix=result.T_flange_sensor.tolist(),
        faces=_faces(result),
        budget=[BudgetLine(source_text(row.source), row.value_um) for row in known.rows],
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


def _contacts_rms_um(result: AnyCalibration) -> float | None:
    if isinstance(result, BoardCalibration):
        return result.contacts.rms_um if result.contacts is not None else None
    return 1e3 * result.alignment.rms_mm


def _faces(result: AnyCalibration) -> list[FaceResult]:
    """How the contacts fit each face of a block; a board has only its one."""
    if isinstance(result, BoardCalibration):
        return []
    return [
        FaceResult(face.face, face.points, 1e3 * face.rms_mm, 1e3 * face.form_mm)
        for face in result.alignment.faces
    ]


def _map(over: UncertaintyMap) -> Sequence[MapPoint]:
    """The map as drawn on the laser plane: along the stripe, and in depth."""
    return [
        MapPoint(round(float(u), 1), round(float(v), 1), round(float(value), 3), bool(inside))
        for (u, v), value, inside in zip(over.uv_px, over.u_um, over.calibrated, strict=True)
    ]
