"""The touch step on a chessboard, which need not be touched: how well points fit a plane. Pure."""

from collections.abc import Sequence

import numpy as np

from crenel.findings import Finding
from crenel.guide.calibration.live import TouchReport
from crenel.guide.calibration.state import Contact
from crenel.guide.common.view import FaceProgress, TouchedPoint, Vec3
from crenel.messages.message import message, signed
from crenel.metrology.arm.kinematics import AnyArm, tip_centres, tip_covariances
from crenel.metrology.fitting.touched_shape import agree_on_plane, distances_from_plane_mm
from crenel.metrology.targets.chessboard import Chessboard, pattern_centre

FACE = "board"
"""The one face of a board that is touched."""
TITLE = message("board-printed-side")
WANTED = 6
"""Three fix a plane, the others show whether one of them slipped."""
FEWEST_JUDGED = 4
SLIPPED_MM, SLIPPED_BENDS, SLIPPED_SDS = 0.1, 2.0, 4.0
"""A point has slipped that lies so far off the others, and by more than the board bends."""


def board_report(contacts: Sequence[Contact], arm: AnyArm, board: Chessboard) -> TouchReport:
    """How well the points so far fit a plane; the pictures show where on it they lie."""
    if len(contacts) < FEWEST_JUDGED:
        unjudged = tuple(TouchedPoint(c.index, FACE, None, None, False) for c in contacts)
        return TouchReport(unjudged, None, "", (), ())
    readings = np.array([contact.reading for contact in contacts])
    tips = tip_centres(arm, readings)
    usual_mm = max(SLIPPED_MM, SLIPPED_BENDS * board.flatness_mm) / SLIPPED_SDS
    spread = tip_covariances(arm, readings) + usual_mm**2 * np.eye(3)
    found = agree_on_plane(tips, spread, usual_mm)
    off_mm = distances_from_plane_mm(tips, found.kept)
    points = tuple(
        TouchedPoint(c.index, FACE, None, float(1e3 * mm), not kept)
        for c, mm, kept in zip(contacts, off_mm, found.kept, strict=True)
    )
    report = TouchReport(
        points,
        None,
        "",
        tuple(_outlier_finding(point) for point in points if point.outlier),
        tuple(point.index for point in points if point.outlier),
    )
    return report.with_doubt(contacts[i].index for i in map(int, np.flatnonzero(found.doubtful)))


def board_face(report: TouchReport, board: Chessboard) -> FaceProgress:
    """The board's one face: what was taken, what is welcome, where to touch."""
    return FaceProgress(
        face=FACE,
        title=TITLE,
        taken=len(report.points),
        wanted=WANTED,
        selected=True,
        rms_um=None,
        suggested_mm=suggest_board_places(board),
    )


def suggest_board_places(board: Chessboard) -> list[Vec3]:
    """Places spread over the pattern, ``WANTED`` of them, in the board's frame, mm."""
    (x, y), (half_x, half_y) = pattern_centre(board)[:2].tolist(), (board.extent_mm / 2).tolist()
    return [(x + a * half_x, y + b * half_y, 0.0) for b in (-0.8, 0.8) for a in (-0.8, 0.0, 0.8)]


def _outlier_finding(point: TouchedPoint) -> Finding:
    assert point.residual_um is not None
    return Finding(
        "attention",
        message(
            "point-off-plane-others",
            index=point.index + 1,
            off=signed(point.residual_um, "µm"),
        ),
        message("remove-touch-there-again-rest"),
    )
