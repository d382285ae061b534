"""The touch step on a block: where to touch it, and how well the points agree. Pure."""

from collections.abc import Sequence

import numpy as np

from crenel.errors import OperationError, sentence
from crenel.findings import Finding
from crenel.guide.calibration.live import TouchReport
from crenel.guide.calibration.state import Contact
from crenel.guide.common.view import FaceProgress, TouchedPoint, Vec3
from crenel.messages.message import message, quantity, signed, word
from crenel.metrology.adjustment.planning.next_touches import next_touches
from crenel.metrology.arm.kinematics import Arm
from crenel.metrology.probing.alignment import Alignment, align_by_arm, other_face
from crenel.metrology.probing.contacts import missing_contacts, off_face_mask
from crenel.metrology.targets.crenellated_block import FACES, Crenellated, on_face
from crenel.metrology.transforms import Floats

WANTED = 9
"""Points on each of three faces. Three fix a plane without showing anything of its
quality; the uncertainty falls with the root of the number, and 27 points with
25 µm of arm noise bring the object's position to about 20 µm."""
WRONG_FACE_MM = 1.0
EDGE_MARGIN_MM = 1.0
TITLES = {
    "crest": message("crests-top"),
    "floor": message("floors-grooves"),
    "front": message("front-face"),
    "back": message("back-face"),
    "left": message("left-end"),
    "right": message("right-end"),
}


NO_REPORT = TouchReport((), None, "", (), ())
"""The report of an arm that states poses: a block is not touched with it."""


def block_report(
    contacts: Sequence[Contact], arm: Arm, block: Crenellated, target_um: float
) -> TouchReport:
    """Aligns the block with the points so far, as soon as that is possible.

    ``target_um`` is how well the object's place is wanted, k = 1.
    """
    faces = [contact.face for contact in contacts]
    missing = missing_contacts(faces)
    unplaced = tuple(TouchedPoint(c.index, c.face, None, None, False) for c in contacts)
    if missing:
        return TouchReport(unplaced, None, missing, (), ())
    q_rad = np.array([contact.reading for contact in contacts])
    try:
        alignment = align_by_arm(arm, block, faces, q_rad)
    except OperationError as error:
        remedy = sentence(error.remedy)
        finding = Finding("bad", error.reason, remedy)
        return TouchReport(unplaced, None, remedy, (finding,), ())
    points = tuple(
        TouchedPoint(c.index, c.face, _vec(at), float(r) * 1e3, bool(outlier))
        for c, at, r, outlier in zip(
            contacts,
            alignment.points_obj_mm,
            alignment.residuals_mm,
            alignment.outliers,
            strict=True,
        )
    )
    outliers = tuple(point.index for point in points if point.outlier)
    findings = tuple(
        _outlier_finding(point, i, alignment, block)
        for i, point in enumerate(points)
        if point.outlier
    )
    advice = next_touches(alignment, faces, block, target_um) if alignment.sigma_mm > 0 else None
    report = TouchReport(points, alignment, "", findings, outliers, advice, target_um)
    return report.with_doubt(
        contacts[i].index for i in map(int, np.flatnonzero(alignment.doubtful))
    )


def _outlier_finding(
    point: TouchedPoint, contact: int, alignment: Alignment, block: Crenellated
) -> Finding:
    assert point.residual_um is not None
    number, face = point.index + 1, word(point.face)
    off_mm = abs(point.residual_um) / 1e3
    at_mm = alignment.points_obj_mm[contact]
    if off_mm < WRONG_FACE_MM and off_face_mask([point.face], at_mm[None], block)[0]:
        text = message("point-beside-face", index=number, face=face)
        return Finding("bad", text, message("remove-then-touch-face-marked-drawing"))
    if off_mm >= WRONG_FACE_MM:
        off = quantity(off_mm, "mm", 1)
        other = other_face(alignment, contact, point.face, block)
        text = (
            message(
                "point-lies-on-other-face", index=number, face=face, off=off, where=on_face(other)
            )
            if other
            else message("point-misses-face", index=number, face=face, off=off)
        )
        return Finding("bad", text, message("remove-then-touch-face-marked-drawing"))
    return Finding(
        "attention",
        message(
            "point-off-face",
            index=number,
            off=signed(point.residual_um, "µm"),
            face=face,
            rms=quantity(alignment.rms_mm * 1000.0, "µm"),
        ),
        message("remove-touch-there-again-rest-clear"),
    )


def block_faces(report: TouchReport, selected: str, block: Crenellated) -> list[FaceProgress]:
    """Every face of the block: what was taken, what is wanted, where to touch."""
    taken = {face: sum(p.face == face for p in report.points) for face in FACES}
    wanted = points_wanted(taken)
    return [
        FaceProgress(
            face=face,
            title=TITLES[face],
            taken=taken[face],
            wanted=wanted[face],
            selected=face == selected,
            rms_um=report.face_rms_um(face),
            suggested_mm=suggest_places(block, face),
        )
        for face in FACES
    ]


def points_wanted(taken: dict[str, int]) -> dict[str, int]:
    """Points wanted on each face: the crests, and of front/back and left/right the better."""
    wanted = dict.fromkeys(FACES, 0)
    wanted["crest"] = WANTED
    wanted["back" if taken["back"] > taken["front"] else "front"] = WANTED
    wanted["left" if taken["left"] > taken["right"] else "right"] = WANTED
    return wanted


def suggest_places(block: Crenellated, face: str) -> list[Vec3]:
    """``WANTED`` places on a face, spread as widely as its edges allow, object frame, mm."""
    x, front, back = block.edges_x_mm, block.front_y_mm, block.back_y_mm
    if face in ("crest", "floor"):
        first = 0 if face == "crest" else 1
        tops = [(x[i], x[i + 1]) for i in range(first, len(x) - 1, 2)]
        z = block.crest_z_mm if face == "crest" else block.floor_z_mm
        return _on_strips(tops, (front, back), z)
    if face in ("front", "back"):
        y = front if face == "front" else back
        solid = _between(block.base_z_mm, block.floor_z_mm, 2)
        low = [(u, y, z) for z in solid for u in _between(x[0], x[-1], 3)]
        tall = _between(block.floor_z_mm, block.crest_z_mm, 3)[1]
        merlons = [(x[2 * i] + x[2 * i + 1]) / 2 for i in _even_indices(block.merlon_count, 3)]
        return low + [(u, y, tall) for u in merlons]
    u = x[0] if face == "left" else x[-1]
    heights = _between(block.base_z_mm, block.crest_z_mm, 3)
    return [(u, v, z) for z in heights for v in _between(front, back, 3)]


def _on_strips(
    strips: Sequence[tuple[float, float]], y_range: tuple[float, float], z: float
) -> list[Vec3]:
    """Three lines of three places, on as many strips as there are: never all in one line."""
    a_strip = -(-3 // len(strips))
    lines = [u for low, high in strips for u in _between(low, high, a_strip)]
    chosen = [lines[i] for i in _even_indices(len(lines), 3)]
    return [(u, v, z) for u in chosen for v in _between(*y_range, 3)]


def _even_indices(count: int, wanted: int) -> list[int]:
    """Up to ``wanted`` indices below ``count``, evenly over the range, ends included."""
    return sorted({round(i) for i in np.linspace(0, count - 1, min(count, wanted))})


def _between(low: float, high: float, count: int) -> list[float]:
    """Values spread between two edges, clear of both."""
    margin = max(EDGE_MARGIN_MM, 0.15 * (high - low))
    margin = min(margin, 0.4 * (high - low))
    if count == 1:
        return [(low + high) / 2]
    return [float(v) for v in np.linspace(low + margin, high - margin, count)]


def _vec(point: Floats) -> Vec3:
    return float(point[0]), float(point[1]), float(point[2])
