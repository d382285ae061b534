"""How the points taken so far agree with the object. Pure."""

from collections.abc import Sequence
from dataclasses import replace

import numpy as np

from crenel.errors import OperationError
from crenel.findings import Finding
from crenel.guide.calibration.live import TouchReport
from crenel.guide.calibration.state import Contact
from crenel.guide.calibration.touch import block as touching
from crenel.guide.calibration.touch import board as board_touching
from crenel.guide.common.view import FaceProgress
from crenel.messages.message import Text, message, quantity
from crenel.metrology.arm.joint_plausibility import limits_error
from crenel.metrology.arm.kinematics import AnyArm, Arm, tip_centres, tip_of
from crenel.metrology.fitting.touched_shape import (
    CONTACT_SD_MM,
    agree_on_plane,
    distances_from_plane_mm,
)
from crenel.metrology.probing.reachable import farthest_apart_mm, too_far
from crenel.metrology.targets.chessboard import Chessboard
from crenel.metrology.targets.crenellated_block import FACES, on_face
from crenel.metrology.targets.target import CalibrationTarget
from crenel.metrology.transforms import Floats

SAME_PLACE_MM = 0.3
FEWEST_JUDGED = board_touching.FEWEST_JUDGED


def face_names(item: CalibrationTarget) -> tuple[str, ...]:
    """The names of all faces that may be touched."""
    return (board_touching.FACE,) if isinstance(item, Chessboard) else FACES


def where_on_object(face: str) -> Text:
    """Where a point lies: "on the left face", "on the board"."""
    return message("on-board") if face == board_touching.FACE else on_face(face)


def face_in_use(selected: str, item: CalibrationTarget) -> str:
    """The selected face; the only one where the object has no other."""
    faces = face_names(item)
    return selected if selected in faces else faces[0]


def touch_report(
    contacts: Sequence[Contact], arm: AnyArm, item: CalibrationTarget, target_um: float
) -> TouchReport:
    """How well the points so far agree with the object.

    Args:
        target_um: how well the place of a block is wanted, k = 1.
    """
    if isinstance(item, Chessboard):
        report = board_touching.board_report(contacts, arm, item)
    elif isinstance(arm, Arm):
        report = touching.block_report(contacts, arm, item, target_um)
        if report.alignment is None:
            report = _flag_odd_ones(report, contacts, arm)
    else:
        return touching.NO_REPORT
    return _flag_impossible(report, contacts, arm) if isinstance(arm, Arm) else report


def _flag_impossible(report: TouchReport, contacts: Sequence[Contact], arm: Arm) -> TouchReport:
    """Names the points whose joints lie outside their limits: of before this was noticed."""
    impossible, findings = [], []
    for contact in contacts:
        wrong = limits_error(contact.reading, arm)
        if wrong is not None:
            impossible.append(contact.index)
            text = message(
                "point-cannot-true", index=contact.index + 1, what=wrong.what, why=wrong.why
            )
            findings.append(Finding("bad", text, message("remove-touch-there-again")))
    if not impossible:
        return report
    others = [index for index in report.questionable if index not in impossible]
    return replace(
        report, questionable=(*impossible, *others), findings=(*findings, *report.findings)
    )


def _flag_odd_ones(report: TouchReport, contacts: Sequence[Contact], arm: AnyArm) -> TouchReport:
    """Names the points of each face that are off the plane of its others, while the object's place
    is not known yet."""
    odd: list[int] = []
    findings = []
    for face in dict.fromkeys(contact.face for contact in contacts):
        own = [contact for contact in contacts if contact.face == face]
        if len(own) < FEWEST_JUDGED:
            continue
        tips = tip_centres(arm, np.array([contact.reading for contact in own]))
        found = agree_on_plane(tips, np.tile(CONTACT_SD_MM**2 * np.eye(3), (len(own), 1, 1)))
        report = report.with_doubt(own[i].index for i in np.flatnonzero(found.doubtful))
        off_mm = distances_from_plane_mm(tips, found.kept)
        for i in np.flatnonzero(~found.kept):
            odd.append(own[i].index)
            off, where = quantity(abs(off_mm[i]), "mm", 1), where_on_object(face)
            text = message("point-off-others", index=own[i].index + 1, off=off, where=where)
            findings.append(Finding("attention", text, message("remove-touch-there-again")))
    points = tuple(replace(one, outlier=one.outlier or one.index in odd) for one in report.points)
    return replace(
        report,
        points=points,
        findings=(*findings, *report.findings),
        questionable=(*odd, *report.questionable),
    )


def face_progress(
    report: TouchReport, selected: str, item: CalibrationTarget
) -> list[FaceProgress]:
    """Every face of the object: what was taken, what is wanted, where to touch."""
    if isinstance(item, Chessboard):
        return [board_touching.board_face(report, item)]
    return touching.block_faces(report, selected, item)


def same_place(reading: Floats, others: Sequence[Contact], arm: AnyArm) -> int | None:
    """Index of a counted point that lies within ``SAME_PLACE_MM`` of a new one, if any."""
    if not others:
        return None
    tips = tip_centres(arm, np.array([c.reading for c in others] + [tuple(reading)]))
    distances = np.linalg.norm(tips[:-1] - tips[-1], axis=1)
    nearest = int(np.argmin(distances))
    return others[nearest].index if distances[nearest] < SAME_PLACE_MM else None


def refuse_far(
    reading: Floats, face: str, others: Sequence[Contact], arm: AnyArm, item: CalibrationTarget
) -> None:
    """Refuses a new point of a face that is farther from a counted point than the object is long.

    Raises:
        OperationError: it is farther from a counted point than the object is long.
    """
    if not others:
        return
    tips = tip_centres(arm, np.array([c.reading for c in others] + [tuple(reading)]))
    tip_mm = tip_of(arm).diameter_mm
    limits = [farthest_apart_mm(item, face, other.face, tip_mm) for other in others]
    far = too_far(tips[:-1], tips[-1], np.array(limits))
    if far is not None:
        number = others[far.other].index + 1
        raise OperationError(
            "not-on-object",
            message("contact-too-far", apart=quantity(far.apart_mm, "mm"), number=number),
            message("contact-limit", limit=quantity(far.limit_mm, "mm")),
            message("touch-object-or-remove-wrong", number=number),
        )


def next_face(faces: Sequence[FaceProgress], selected: str) -> str:
    """The face to go on with: the selected one until it has its points."""
    here = next(face for face in faces if face.face == selected)
    if here.taken < max(here.wanted, 1):
        return selected
    return next((f.face for f in faces if f.taken < f.wanted), selected)
