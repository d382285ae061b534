"""From the session's folder to its calibration file, and what the browser shows of it."""

from collections.abc import Mapping, Sequence

import numpy as np

from crenel.errors import OperationError, sentence
from crenel.findings import Finding
from crenel.formats.results.calibration import CalibrationFile, MapPart, PosePart, VerdictPart
from crenel.formats.results.calibration_builder import joint_document
from crenel.formats.results.kept_calibration import KeptCalibration, read_kept_calibration
from crenel.formats.session.calibration_session import BlockSession, BoardSession, read_any_session
from crenel.guide.calibration.comparison import compare
from crenel.guide.calibration.outcome import CalibrationOutcome, PoseDrawing
from crenel.guide.calibration.poses.detection import draw_detection, thin_stripe
from crenel.guide.calibration.session_folder import SessionFolder
from crenel.guide.calibration.touch.board import FACE
from crenel.guide.common.journal import StoredCalibration
from crenel.guide.common.result_view import (
    BudgetLine,
    CalibrationResult,
    Comparison,
    MapPoint,
    PoseRow,
    WorstPointLine,
)
from crenel.guide.common.view import ImageCorner, TouchedPoint
from crenel.messages.message import Text, join, message, word
from crenel.metrology.adjustment.block.calibrate import BlockCalibration, calibrate_block
from crenel.metrology.adjustment.board.calibrate import BoardCalibration
from crenel.metrology.adjustment.results.poses import PoseResult
from crenel.metrology.calibration import findings as metrology
from crenel.metrology.calibration.uncertainty_budget import source_text
from crenel.metrology.limits import Limits
from crenel.metrology.targets.target import CalibrationTarget
from crenel.metrology.transforms import apply, inverse
from crenel.station.jobs import Progress
from crenel.workflows.calibrate import (
    AnyDetection,
    LaserUse,
    board_inputs,
    calibration_origin,
    joint_inputs,
    solve_board,
)

AnyCalibration = BlockCalibration | BoardCalibration


def solve(
    folder: SessionFolder,
    in_use: StoredCalibration | None,
    progress: Progress,
    known: Mapping[int, AnyDetection | OperationError],
    limits: Limits,
    points: Sequence[int],
    laser: LaserUse = "auto",
) -> CalibrationOutcome:
    """Calibrates the session as the command line does, and writes ``calibration.json``.

    Args:
        known: what the pictures of poses show, by number, where they were looked at.
        points: the index of the touched point that each row of the contacts is.
        laser: ``none`` calibrates camera and mounting alone. A folder that keeps those of an
            earlier calibration adds the laser to it.

    Raises:
        OperationError: by its reason; a calibration file of an earlier solve is then gone.
    """
    folder.calibration.unlink(missing_ok=True)
    session = read_any_session(folder.path)
    kept = read_kept_calibration(folder.camera) if folder.camera.exists() else None
    result, document, drawings, touched = _calibrate(
        session, progress, known, limits, points, laser, kept
    )
    document.write(folder.calibration)
    return CalibrationOutcome(
        corners=(),
        outline=(),
        stripe=(),
        findings=[Finding(f.quality, f.text, f.remedy, f.pose) for f in result.findings],
        result=_result(
            document,
            limits,
            [_worst(point, drawings, points) for point in result.worst],
            compare(document, result.uncertainty.volume.uv_px, in_use),
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
    laser: LaserUse,
    kept: KeptCalibration | None,
) -> tuple[AnyCalibration, CalibrationFile, dict[int, PoseDrawing], tuple[TouchedPoint, ...]]:
    """The calibration, its file, what its poses are drawn with, and a board's touched points."""

    def report(share: float, text: Text) -> None:
        progress(text, share)

    origin = calibration_origin(session, session.poses, operator="")
    if isinstance(session, BoardSession):
        of_board = board_inputs(session, limits, report, known, laser)
        on_board, on_board_document = solve_board(of_board, origin, report, kept)
        drawings = _drawings(on_board, of_board.observations, session.board)
        return on_board, on_board_document, drawings, _on_board(on_board, points)
    of_block = joint_inputs(session, limits, report, known)
    on_block = calibrate_block(of_block, report)
    drawings = _drawings(on_block, of_block.observations, session.block)
    return on_block, joint_document(on_block, origin), drawings, ()


def _drawings(
    result: AnyCalibration, seen: Sequence[AnyDetection], item: CalibrationTarget
) -> dict[int, PoseDrawing]:
    """Drawings of the poses that were used, by number: corners with what the adjustment left of
    them."""
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
            message("point-of-face", face=word(point.face), index=index + 1),
            point.value,
            point.unit,
            index,
        )
    at_px = point.at_px
    if at_px is None and point.pose is not None:
        corners = drawings[point.pose].corners
        at_px = next((c.u, c.v) for c in corners if c.name == point.corner)
    return WorstPointLine(point.kind, point.name, point.value, point.unit, None, point.pose, at_px)


def _result(
    document: CalibrationFile,
    limits: Limits,
    worst: Sequence[WorstPointLine],
    comparison: Comparison | None,
) -> CalibrationResult:
    """What is shown of the file."""
    verdict, known, residuals = document.verdict, document.uncertainty, document.residuals
    assert verdict is not None
    assert known is not None
    assert residuals is not None
    return CalibrationResult(
        verdict=verdict.quality,
        verdict_text=_verdict_text(verdict),
        reprojection_rms_px=residuals.reprojection_rms_px,
        laser_plane_rms_um=residuals.laser_plane_rms_um,
        alignment_rms_um=residuals.contacts_rms_um if residuals.contacts_um else None,
        depth_range_mm=known.depth_range_mm,
        probe_matrix=document.probe_matrix,
        faces=residuals.faces,
        budget=[BudgetLine(source_text(row.source), row.value_um) for row in known.budget],
        total_um=known.total_um,
        worst=worst,
        comparison=comparison,
        distortion=document.camera.distortion,
        plane=known.plane,
        map=_map_points(known.map) if known.map else (),
        poses=[_pose_row(pose) for pose in document.poses],
        shown_pose=_worst_fitting(document.poses).number,
        good_um=limits.good_um,
        usable_um=limits.usable_um,
    )


def _verdict_text(verdict: VerdictPart) -> Text:
    """How well a point is known, and what helps; or that something else is graver."""
    known = next(one for one in verdict.findings if one.code == "uncertainty")
    text = sentence(known.text)
    if verdict.quality != known.quality:
        return join([text, message("but-what-marked-below-needs-attention")], " ")
    return join([text, sentence(known.remedy)], " ") if known.remedy else text


def _map_points(over: MapPart) -> Sequence[MapPoint]:
    """The map as drawn on the laser plane: along the stripe, and in depth."""
    return [
        MapPoint(round(u, 1), round(v, 1), u_um, inside)
        for (u, v), u_um, inside in zip(over.uv_px, over.u_um, over.calibrated, strict=True)
    ]


def _pose_row(pose: PosePart) -> PoseRow:
    return PoseRow(
        pose.number,
        pose.used,
        pose.reason,
        pose.edges_rms_px,
        pose.stripe_rms_px if pose.stripe_points else None,
        pose.off_um,
    )


def _worst_fitting(poses: Sequence[PosePart]) -> PosePart:
    """The pose whose picture is worth looking at: its edges fit worst."""
    return max((pose for pose in poses if pose.used), key=lambda pose: pose.edges_rms_px)
