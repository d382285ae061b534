"""The report on a calibration, from its session's folder alone."""

from pathlib import Path

import numpy as np

from app.formats.datasheets.target import read_certificate
from app.formats.results.acceptance import Acceptance, read_acceptance
from app.formats.results.calibration import CalibrationFile, PosePart
from app.formats.session.calibration_session import (
    OBJECT,
    BlockSession,
    BoardSession,
    read_any_session,
)
from app.metrology.arm.kinematics import Arm, tip_centres
from app.metrology.sensor.laser_plane import LaserPlane
from app.metrology.targets.chessboard import Chessboard
from app.metrology.transforms import Floats
from app.report.content import (
    Facts,
    Findings,
    Pictures,
    Report,
    ReportFinding,
    ReportTable,
    Section,
    TextBlock,
    Verdict,
    signatures,
)
from app.report.contents import calibration_figures as figures
from app.report.figure import Figure
from app.report.formatting import (
    UNKNOWN,
    device_name,
    format_moment,
    micrometres,
    millimetres,
    simulation_notes,
    temperature,
)
from app.report.provenance import inputs_section

CALIBRATION = "calibration.json"
DISPLAYED_POSES = 6
WORDS = {
    "good": "Good",
    "attention": "Usable, with attention",
    "bad": "Not to be used",
    "neutral": "Not judged",
}
METHODS = {
    "joint": "joint adjustment of all poses",
    "one-pose": "one pose (Faugeras, contact alignment)",
}
# One-sided, 95 %: the guard band that ISO 14253-1 takes by default, in standard uncertainties.
GUARD = 1.65


def calibration_report(folder: Path) -> Report:
    """The report on the ``calibration.json`` of a session's folder.

    Raises:
        Refusal: there is none, or a file that it needs is missing or damaged.
    """
    sheet = CalibrationFile.read(folder / CALIBRATION)
    session = read_any_session(folder)
    accepted = read_acceptance(folder)
    verdict = sheet.verdict
    quality = verdict.quality if verdict else "neutral"
    text = verdict.text if verdict else "The file carries no verdict."
    sections = [
        _subject_section(sheet, session, accepted),
        _results(sheet, session, accepted),
        signatures(_operator(sheet, accepted)),
        _findings(sheet),
        *_pictures(sheet, session, accepted),
        _tables(sheet, session),
        _parameters(sheet),
        inputs_section(
            folder, sheet.inputs, CALIBRATION, accepted.calibration_sha256 if accepted else None
        ),
    ]
    return Report(
        title="Calibration report",
        number=folder.resolve().name,
        station=(accepted.station if accepted else "") or "Laser stripe sensor on a measuring arm",
        date=format_moment(accepted.accepted_at if accepted else sheet.created_at),
        verdict=Verdict(quality, WORDS[quality], f"{text[:1].upper()}{text[1:]}."),
        sections=[section for section in sections if section.blocks],
        notes=_notes(accepted),
    )


def _notes(accepted: Acceptance | None) -> list[str]:
    if accepted is None:
        return ["This calibration was not accepted at a station."]
    return simulation_notes(accepted.simulated)


def _operator(sheet: CalibrationFile, accepted: Acceptance | None) -> str:
    return (accepted.operator if accepted else "") or sheet.operator or ""


def _subject_section(
    sheet: CalibrationFile, session: BlockSession | BoardSession, accepted: Acceptance | None
) -> Section:
    sensor, arm = session.sensor, session.arm
    target = session.board if isinstance(session, BoardSession) else session.block
    laser = f", laser {sensor.laser_wavelength_nm:g} nm" if sensor.laser_wavelength_nm else ""
    size = f"{sensor.width_px} × {sensor.height_px} px"
    tip = f", tip Ø {2 * arm.tip.radius_mm:.4g} mm" if arm.tip else ""
    rows = [
        ("Operator", _operator(sheet, accepted) or UNKNOWN),
        ("Calibrated", format_moment(sheet.created_at)),
        ("Accepted", format_moment(accepted.accepted_at) if accepted else "no"),
        ("Temperature", temperature(accepted.temperature_c if accepted else None)),
        ("Method", METHODS.get(sheet.method or "", sheet.method or UNKNOWN)),
        ("Software", f"Crenel {sheet.software.version}" if sheet.software else UNKNOWN),
        ("Arm", device_name(arm.name, arm.serial_number) + tip),
        ("Sensor", f"{device_name(sensor.name, sensor.serial_number)}, {size}{laser}"),
        ("Object", device_name(target.name, target.serial_number)),
        ("Its certificate", read_certificate(session.folder / OBJECT) or UNKNOWN),
        ("Its coordinates", _coordinates(target)),
    ]
    return Section("What was calibrated", [Facts(rows)])


def _coordinates(target: object) -> str:
    unsure = 1e3 * float(getattr(target, "standard_uncertainty_mm", 0.0))
    text = f"known to {unsure:.1f} µm (k = 1)"
    if isinstance(target, Chessboard):
        columns, rows = target.inner_corners
        return f"{columns} × {rows} inner corners, {target.square_mm:g} mm apart, {text}"
    return text


def _results(
    sheet: CalibrationFile, session: BlockSession | BoardSession, accepted: Acceptance | None
) -> Section:
    known, left = sheet.uncertainty, sheet.residuals
    rows: list[tuple[str, str, str, str, str]] = []
    if known is not None:
        total = known.total_um
        limits = _limits(accepted)
        point = "Scanned point, rms over the measuring volume"
        rows += [
            (f"{point}: standard uncertainty", *_um(total), "1", limits),
            (f"{point}: expanded uncertainty", *_um(2 * total), "2", ""),
        ]
        if known.plane is not None:
            rows += [
                (
                    "Plane swept straight across: angle",
                    f"{known.plane.angle_arcsec:.0f}″",
                    "",
                    "1",
                    "",
                ),
                ("The same: offset", *_um(known.plane.offset_um), "1", ""),
            ]
        near, far = known.depth_range_mm
        rows.append(
            ("Calibrated distance from the camera", "", f"{near:.1f} to {far:.1f} mm", "", "")
        )
    if left is not None:
        board = isinstance(session, BoardSession)
        fitted = "Corners, rms" if board else "Edges and corners, rms"
        stripe = f"Stripe about the laser plane, rms of {left.stripe_points} points"
        rows += [
            (fitted, f"{left.reprojection_rms_px:.3f} px", "", "", ""),
            (stripe, *_um(left.laser_plane_rms_um), "", ""),
        ]
        if left.contacts_um:
            out = len(left.contacts_left_out)
            count = f"{len(left.contacts_um)} touches" + (f", {out} left out" if out else "")
            rows.append((f"Contacts, rms of {count}", *_um(left.contacts_rms_um), "", ""))
    columns = ("Result", "Value", "In mm", "k", "Limit, k = 1")
    table = ReportTable(columns, rows, (46, 14, 18, 5, 25))
    return Section("Results", [table, *_rule(sheet, accepted)])


def _um(value_um: float) -> tuple[str, str]:
    return micrometres(value_um), millimetres(value_um)


def _limits(accepted: Acceptance | None) -> str:
    if accepted is None or accepted.good_um is None or accepted.usable_um is None:
        return "not stated"
    return f"good ≤ {accepted.good_um:g} µm, usable ≤ {accepted.usable_um:g} µm"


def _rule(sheet: CalibrationFile, accepted: Acceptance | None) -> list[TextBlock]:
    texts = [
        "Decision rule: the limits are set on the standard uncertainty itself and compared with it "
        "directly, without a guard band."
    ]
    if sheet.uncertainty is not None:
        guard = GUARD * sheet.uncertainty.total_um
        texts.append(
            "For a feature given by a single scanned point, ISO 14253-1 with its default of 95 % "
            f"proves conformance where the point stays {micrometres(guard)} ({millimetres(guard)}, "
            "1.65 standard uncertainties) inside its tolerance; nonconformance, that far outside."
        )
    texts.append(
        "This is a calibration, not an acceptance test: no characteristic of ISO 10360-8 or "
        "ISO 10360-12 is claimed. A verification on gauges tests the scanner."
    )
    if accepted is not None and accepted.compared is not None:
        moved = accepted.compared
        texts.append(
            f"Against {moved.name}, in use before: points of the measuring volume moved by "
            f"{micrometres(moved.rms_um)} ({millimetres(moved.rms_um)}) rms, "
            f"{micrometres(moved.max_um)} ({millimetres(moved.max_um)}) at most."
        )
    return [TextBlock(text) for text in texts]


def _findings(sheet: CalibrationFile) -> Section:
    found = sheet.verdict.findings if sheet.verdict else ()
    rows = [ReportFinding(f.quality, f.text, f.remedy) for f in found]
    return Section("Findings", [Findings(rows)] if rows else [], together=False)


def _pictures(
    sheet: CalibrationFile, session: BlockSession | BoardSession, accepted: Acceptance | None
) -> list[Section]:
    camera, plane = sheet.camera.model(), laser_plane(sheet)
    sections: list[Section] = []
    if isinstance(session, BlockSession):
        sections.append(
            Section("Residuals on the object", [Pictures([_contact_figure(sheet, session)])])
        )
    of_poses = _worst_poses(sheet)
    by_number = {pose.number: pose for pose in session.poses}
    images: list[tuple[Figure, str]] = [
        figures.image_figure(by_number[part.number], part, camera, _fit_basis(session))
        for part in of_poses
        if part.number in by_number
    ]
    if images:
        used = sum(part.used for part in sheet.poses)
        few = f" (the {len(images)} of {used} poses that fit worst)" if len(images) < used else ""
        title = f"Residuals on the image{few}"
        sections.append(Section(title, [Pictures(images, 3)], together=False))
    if sheet.uncertainty is not None:
        over = figures.volume_figure(sheet.uncertainty, camera, plane)
        if over is not None:
            sections.append(Section("Uncertainty over the measuring volume", [Pictures([over])]))
        limits = (accepted.good_um, accepted.usable_um) if accepted else (None, None)
        bars = figures.budget_figure(sheet.uncertainty, *limits)
        sections.append(Section("Error budget", [Pictures([bars])]))
    return sections


def _fit_basis(session: BlockSession | BoardSession) -> str:
    """What of the object the poses were fitted to; a board has no edges that were measured."""
    return "Corners" if isinstance(session, BoardSession) else "Edges"


def laser_plane(sheet: CalibrationFile) -> LaserPlane:
    """The laser's plane in the sensor frame."""
    return LaserPlane(np.array(sheet.laser_plane.normal), sheet.laser_plane.offset_mm)


def _worst_poses(sheet: CalibrationFile) -> list[PosePart]:
    """Those whose edges fit worst, in the order in which they were taken."""
    drawn = [pose for pose in sheet.poses if pose.used and pose.corners_at_px]
    worst = sorted(drawn, key=lambda pose: -pose.edges_rms_px)[:DISPLAYED_POSES]
    return sorted(worst, key=lambda pose: pose.number)


def _contact_figure(sheet: CalibrationFile, session: BlockSession) -> tuple[Figure, str]:
    left = sheet.residuals
    residuals = left.contacts_um if left is not None else ()
    out = left.contacts_left_out if left is not None else ()
    count = min(len(residuals), len(session.contacts.features))
    return figures.object_figure(
        session.block,
        session.contacts.features[:count],
        _contact_points(sheet, session.arm, session)[:count],
        residuals[:count],
        out,
    )


def _contact_points(sheet: CalibrationFile, arm: Arm, session: BlockSession) -> Floats:
    """(N, 3) the tip's centres in the object's frame."""
    assert sheet.T_arm_obj is not None
    T = np.array(sheet.T_arm_obj)
    return np.asarray((tip_centres(arm, session.contacts.q_rad) - T[:3, 3]) @ T[:3, :3])


def _tables(sheet: CalibrationFile, session: BlockSession | BoardSession) -> Section:
    tables: list[ReportTable] = []
    if sheet.poses:
        rows = [
            (
                str(pose.number),
                _pose_outcome(pose),
                *(_pose_figures(pose) if pose.used else ("–",) * 5),
            )
            for pose in sheet.poses
        ]
        fitted = "Corners, px" if isinstance(session, BoardSession) else "Edges, px"
        columns = ("Pose", "", fitted, "Points", "Stripe, px", "Points", "Object off, µm")
        tables.append(ReportTable(columns, rows, (7, 36, 11, 9, 11, 9, 17), 2))
    if sheet.residuals is not None and sheet.residuals.faces:
        faces = [
            (face.face, str(face.points), f"{face.rms_um:.1f}", f"{face.form_um:.1f}")
            for face in sheet.residuals.faces
        ]
        heads = ("Face", "Touches", "rms, µm", "Form (max − min), µm")
        tables.append(ReportTable(heads, faces, (30, 20, 20, 30)))
    touched = sheet.residuals is not None and len(sheet.residuals.contacts_um) > 0
    return Section("Poses and touches" if touched else "Poses", tables)


def _pose_outcome(pose: PosePart) -> str:
    if not pose.used:
        return f"left out: {pose.reason}"
    return f"used, but {pose.reason}" if pose.reason else "used"


def _pose_figures(pose: PosePart) -> tuple[str, ...]:
    return (
        f"{pose.edges_rms_px:.3f}",
        str(pose.edge_points),
        f"{pose.stripe_rms_px:.3f}" if pose.stripe_points else "–",
        str(pose.stripe_points),
        f"{pose.off_um:.1f}",
    )


def _parameters(sheet: CalibrationFile) -> Section:
    camera = sheet.camera
    matrix = np.array(camera.matrix)
    lens = "  ".join(
        f"{name} {value:+.6f}"
        for name, value in zip(("k1", "k2", "p1", "p2", "k3"), camera.distortion, strict=True)
        if value
    )
    normal = ", ".join(f"{value:+.6f}" for value in sheet.laser_plane.normal)
    facts = [
        ("Focal length", f"{matrix[0, 0]:.2f} × {matrix[1, 1]:.2f} px"),
        ("Principal point", f"{matrix[0, 2]:.2f}, {matrix[1, 2]:.2f} px"),
        ("Distortion", lens or "none was significant"),
        ("Laser plane", f"({normal}) · x = {sheet.laser_plane.offset_mm:.4f} mm"),
    ]
    rows = [tuple(f"{value:.7f}" for value in row) for row in sheet.probe_matrix]
    probe = ReportTable(("x", "y", "z", "Origin, mm"), rows, (1, 1, 1, 1), 0)
    words = TextBlock("Probe matrix: the sensor's frame in that of the arm's last joint.")
    return Section("Parameters", [Facts(facts), TextBlock(""), words, probe])
