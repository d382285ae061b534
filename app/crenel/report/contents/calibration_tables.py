"""The tables of a calibration's report: poses, contact points and parameters."""

from crenel.findings import capital
from crenel.formats.results.calibration import CalibrationFile, LaserPlanePart, PosePart
from crenel.formats.session.calibration_session import (
    BlockSession,
    BoardSession,
)
from crenel.messages.message import Text, join, message, quantity, signed, word
from crenel.metrology.targets.crenellated_block import FACES
from crenel.report.content import (
    Facts,
    ReportTable,
    Section,
    TextBlock,
)

FACE_WORDS = (*FACES, "board")
Row = tuple[Text, ...]


def table_section(document: CalibrationFile, session: BlockSession | BoardSession) -> Section[Text]:
    tables: list[ReportTable[Text]] = []
    if document.poses:
        rows: list[Row] = [
            (
                str(pose.number),
                _pose_outcome(pose),
                *(_pose_figures(pose) if pose.used else ("–",) * 5),
            )
            for pose in document.poses
        ]
        fitted = message("corners-px") if isinstance(session, BoardSession) else message("edges-px")
        columns = (
            message("pose"),
            "",
            fitted,
            message("points"),
            message("stripe-px"),
            message("points"),
            message("object-off-m"),
        )
        tables.append(ReportTable(columns, rows, (7, 36, 11, 9, 11, 9, 17), 2))
    if document.residuals is not None and document.residuals.faces:
        faces: list[Row] = [
            (
                capital(word(face.face) if face.face in FACE_WORDS else face.face),
                str(face.points),
                quantity(face.rms_um, "", 1),
                quantity(face.form_um, "", 1),
            )
            for face in document.residuals.faces
        ]
        heads = (
            message("face"),
            message("contact-points-label"),
            "rms, µm",
            message("form-max-min-m"),
        )
        tables.append(ReportTable(heads, faces, (30, 20, 20, 30)))
    touched = document.residuals is not None and len(document.residuals.contacts_um) > 0
    return Section(message("poses-touches") if touched else message("poses-heading"), tables)


def _pose_outcome(pose: PosePart) -> Text:
    if not pose.used:
        return message("excluded-because-within-sentence", reason=pose.reason)
    return message("used-but-within-sentence", reason=pose.reason) if pose.reason else word("used")


def _pose_figures(pose: PosePart) -> Row:
    return (
        quantity(pose.edges_rms_px, "", 3),
        str(pose.edge_points),
        quantity(pose.stripe_rms_px, "", 3) if pose.stripe_points else "–",
        str(pose.stripe_points),
        quantity(pose.off_um, "", 1),
    )


def _plane_equation(plane: LaserPlanePart) -> Text:
    x, y, z = (signed(value, "", 6) for value in plane.normal)
    return message("plane-equation", x=x, y=y, z=z, offset=quantity(plane.offset_mm, "mm", 4))


def parameter_section(document: CalibrationFile) -> Section[Text]:
    camera, plane = document.camera, document.laser_plane
    (fx, _, u0), (_, fy, v0), _ = camera.matrix
    lens = [
        message("named-value", name=name, value=signed(value, "", 6))
        for name, value in zip(("k1", "k2", "p1", "p2", "k3"), camera.distortion, strict=True)
        if value
    ]
    facts: list[tuple[Text, Text]] = [
        (
            message("focal-length"),
            message("focal-lengths", u=quantity(fx, "", 2), v=quantity(fy, "px", 2)),
        ),
        (
            message("principal-point"),
            message("principal-point-at", u=quantity(u0, "", 2), v=quantity(v0, "px", 2)),
        ),
        (message("distortion"), join(lens, "  ") if lens else message("none-significant")),
        (
            message("laser-plane"),
            message("none-yet") if plane is None else _plane_equation(plane),
        ),
    ]
    rows = [tuple(quantity(value, "", 7) for value in row) for row in document.probe_matrix]
    probe = ReportTable[Text](("x", "y", "z", message("origin-mm")), rows, (1, 1, 1, 1), 0)
    explanation = TextBlock(message("probe-matrix-sensors-frame-arms-last"))
    return Section(message("parameters"), [Facts(facts), TextBlock(""), explanation, probe])
