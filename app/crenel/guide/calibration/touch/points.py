"""Taking contact points: by click, by the arm's buttons, by the simulated operator."""

from crenel.errors import OperationError
from crenel.findings import Quality
from crenel.guide.calibration.guide import CalibrationGuide
from crenel.guide.calibration.touch.report import (
    SAME_PLACE_MM,
    face_in_use,
    face_progress,
    next_face,
    refuse_far,
    same_place,
    where_on_object,
)
from crenel.messages.message import message, quantity, signed


def take_point(guide: CalibrationGuide, source: str, until_ns: int | None, key: str | None) -> None:
    """Adds the point that the tip touches now, or touched at ``until_ns``.

    Raises:
        OperationError: the arm is lost or moves, the point was taken already, or it lies where the
            object cannot be.
    """
    with guide.lock:
        state = guide.state
        chosen = guide.datasheets.selection(state)
        arm = chosen.arm
        if arm is None or chosen.object is None:
            raise OperationError("no-arm-model", message("arm-chosen-cannot-read-any-more"))
        side = guide.station.rig.arm
        mean = side.average(until_ns=until_ns)
        side.refuse_scan_end(mean.reading)
        face = face_in_use(state.face, chosen.object)
        same = same_place(mean.reading, state.counted, arm)
        if same is not None:
            raise OperationError(
                "same-place",
                message("point-again", point=same + 1),
                message("tip-lies-within-mm", distance=quantity(SAME_PLACE_MM, "mm", 1)),
                message("move-tip-another-place"),
            )
        refuse_far(mean.reading, face, state.counted, arm, chosen.object)
        guide.append(
            "point_taken",
            {
                "face": face,
                "reading": mean.reading.tolist(),
                "scatter": mean.scatter.tolist(),
                "samples": mean.samples,
                "source": source,
            },
            key,
        )
        guide.folder.keep_contacts(guide.state.counted)
        _report_point(guide)
        _go_on(guide)


def undo(guide: CalibrationGuide, key: str | None) -> None:
    """Takes the last counted point back, and returns to its face."""
    with guide.lock:
        last = guide.state.counted[-1]
        void_point(guide, last.index, key)
        if last.face != guide.state.face:
            guide.append("face_selected", {"face": last.face})


def redo(guide: CalibrationGuide, key: str | None) -> None:
    """Puts the point back that was taken back last, and returns to its face."""
    with guide.lock:
        index = guide.state.undone[-1]
        guide.append("point_restored", {"index": index}, key)
        guide.folder.keep_contacts(guide.state.counted)
        guide.station.bus.event("point_restored", message("point-back", index=index + 1))
        face = guide.state.contacts[index].face
        if face != guide.state.face:
            guide.append("face_selected", {"face": face})


def void_point(guide: CalibrationGuide, index: int, key: str | None) -> None:
    """Takes one point out; it stays in the journal."""
    with guide.lock:
        guide.append("point_voided", {"index": index}, key)
        guide.folder.keep_contacts(guide.state.counted)
        guide.station.bus.event("point_voided", message("point-removed", index=index + 1))


def _go_on(guide: CalibrationGuide) -> None:
    """Turns to the next face when this point completed its face."""
    state, item = guide.state, guide.datasheets.selection(guide.state).object
    report = guide.datasheets.touch(state)
    if report is None or item is None:
        return
    faces = face_progress(report, face_in_use(state.face, item), item)
    here = next(face for face in faces if face.selected)
    goal = next_face(faces, here.face)
    if here.taken == here.wanted and goal != here.face:
        guide.append("face_selected", {"face": goal})


def _report_point(guide: CalibrationGuide) -> None:
    """Reports the residual of the new point, for an operator who looks at the arm."""
    point, report = guide.state.counted[-1], guide.datasheets.touch(guide.state)
    number, where = point.index + 1, where_on_object(point.face)
    quality: Quality = "neutral"  # nothing shows yet that it lies there
    judged = next((p for p in report.points if p.index == point.index), None) if report else None
    if report is not None and point.index in report.doubts:
        text, quality = report.doubts[point.index], "attention"
    elif judged is None or judged.residual_um is None:
        text = message("point-taken-for", index=number, where=where)
        if report is not None and point.index in report.questionable:
            finding = report.findings[report.questionable.index(point.index)]
            text, quality = finding.text, "attention"
    else:
        off = signed(judged.residual_um, "µm")
        text = message("point-taken-off", index=number, where=where, off=off)
        quality = "attention" if judged.outlier else "good"
    guide.station.bus.event("point_taken", text, quality)
