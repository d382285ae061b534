"""The report of a calibration, from the folder of its session alone."""

from pathlib import Path

import numpy as np

from crenel.errors import sentence
from crenel.formats.datasheets.sensor import SensorDatasheet
from crenel.formats.datasheets.target import read_certificate
from crenel.formats.results.acceptance import Acceptance, read_acceptance
from crenel.formats.results.calibration import CALIBRATION, CalibrationFile, PosePart
from crenel.formats.results.decision_rule import FORMER_POINT_RULE, RulePart, describe_rule
from crenel.formats.session.calibration_session import (
    OBJECT,
    BlockSession,
    BoardSession,
    read_any_session,
)
from crenel.messages.message import Message, Text, join, message, quantity, rounded, word
from crenel.metrology.arm.kinematics import Arm, RobotArm, tip_centres
from crenel.metrology.targets.chessboard import Chessboard
from crenel.metrology.targets.crenellated_block import Crenellated
from crenel.metrology.transforms import Floats
from crenel.report.content import (
    Facts,
    Findings,
    Pictures,
    Quality,
    Report,
    ReportFinding,
    ReportTable,
    Section,
    TextBlock,
    Verdict,
    signatures,
)
from crenel.report.contents.calibration_tables import Row, parameter_section, table_section
from crenel.report.contents.residual_figures import FitBasis, image_figure, object_figure
from crenel.report.contents.uncertainty_figures import budget_figure, volume_figure
from crenel.report.figure import Figure
from crenel.report.formatting import (
    UNKNOWN,
    ball_diameter,
    device_name,
    format_moment,
    in_both_units,
    limit_beside,
    micrometres,
    millimetres,
    simulation_notes,
    software_name,
    temperature,
)
from crenel.report.provenance import inputs_section
from crenel.workflows.calibrate import session_channel

DISPLAYED_POSES = 6
WORDS: dict[Quality, Message] = {
    "good": message("good"),
    "attention": message("usable-attention"),
    "bad": message("do-not-use"),
    "neutral": message("not-judged"),
}
METHODS: dict[str, Message] = {
    "joint": message("joint-adjustment-all-poses"),
    "one-pose": message("one-pose-faugeras-contact-alignment"),
}


def calibration_report(folder: Path) -> Report[Text]:
    """The report of the ``calibration.json`` in the folder of a session.

    Raises:
        OperationError: there is none, or a required file is missing or damaged.
    """
    document = CalibrationFile.read(folder / CALIBRATION)
    session = read_any_session(folder)
    accepted = read_acceptance(folder)
    verdict = document.verdict
    quality = verdict.quality if verdict else "neutral"
    text = verdict.text if verdict else message("file-carries-no-verdict")
    sections = [
        _subject_section(document, session, accepted),
        _results(document, session, accepted),
        signatures(_operator(document, accepted)),
        _findings(document),
        *_pictures(document, session, accepted),
        table_section(document, session),
        parameter_section(document),
        inputs_section(
            folder, document.inputs, CALIBRATION, accepted.calibration_sha256 if accepted else None
        ),
    ]
    return Report(
        title=message("calibration-report"),
        number=folder.resolve().name,
        station=(accepted.station if accepted else "")
        or message("laser-stripe-sensor-measuring-arm"),
        date=format_moment(accepted.accepted_at if accepted else document.created_at),
        verdict=Verdict(quality, WORDS[quality], sentence(text)),
        sections=[section for section in sections if section.blocks],
        notes=_notes(accepted),
    )


def _notes(accepted: Acceptance | None) -> list[Text]:
    if accepted is None:
        return [message("calibration-not-accepted-at-station")]
    return simulation_notes(accepted.simulated)


def _operator(document: CalibrationFile, accepted: Acceptance | None) -> str:
    return (accepted.operator if accepted else "") or document.operator or ""


def _subject_section(
    document: CalibrationFile, session: BlockSession | BoardSession, accepted: Acceptance | None
) -> Section[Text]:
    target = session.board if isinstance(session, BoardSession) else session.block
    rows: list[tuple[Text, Text]] = [
        (message("operator"), _operator(document, accepted) or UNKNOWN),
        (message("calibrated"), format_moment(document.created_at)),
        (message("accepted"), format_moment(accepted.accepted_at) if accepted else word("no")),
        (message("temperature"), temperature(accepted.temperature_c if accepted else None)),
        (message("method"), METHODS.get(document.method or "", document.method or UNKNOWN)),
        (
            message("software"),
            software_name(document.software.version) if document.software else UNKNOWN,
        ),
        (message("arm"), _arm_name(session.arm)),
        (message("sensor-heading"), _sensor_name(session.sensor, document.channel)),
        (message("object"), device_name(target.name, target.serial_number)),
        (message("certificate"), read_certificate(session.folder / OBJECT) or UNKNOWN),
        (message("coordinates"), _coordinates(target)),
    ]
    return Section(message("what-calibrated"), [Facts(rows)])


def _arm_name(arm: Arm | RobotArm) -> Text:
    name = device_name(arm.name, arm.serial_number)
    if not arm.tip:
        return name
    return join([name, message("with-tip", diameter=ball_diameter(2 * arm.tip.radius_mm))])


def _sensor_name(sensor: SensorDatasheet, channel: Text | None) -> Text:
    items: list[Text] = [
        device_name(sensor.name, sensor.serial_number),
        f"{sensor.width_px} × {sensor.height_px} px",
    ]
    if sensor.laser_wavelength_nm:
        wavelength = rounded(sensor.laser_wavelength_nm, "nm")
        items.append(message("laser-wavelength", wavelength=wavelength))
    if channel is not None:
        items.append(message("measured-channel", channel=channel))
    return join(items)


def _coordinates(target: Crenellated | Chessboard) -> Text:
    known = message("known-k-1", known=micrometres(1e3 * target.standard_uncertainty_mm))
    if isinstance(target, Chessboard):
        columns, rows = target.inner_corners
        return message(
            "inner-corners-mm-apart",
            columns=columns,
            rows=rows,
            square=rounded(target.square_mm, "mm"),
            known=known,
        )
    return known


def _results(
    document: CalibrationFile, session: BlockSession | BoardSession, accepted: Acceptance | None
) -> Section[Text]:
    rows = [*_uncertainty_rows(document, accepted), *_residual_rows(document, session)]
    columns = (message("result"), message("value"), message("mm"), "k", message("limit-k-1"))
    table = ReportTable[Text](columns, rows, (46, 14, 18, 5, 25))
    return Section(message("results"), [table, *_rule(document, accepted)])


def _uncertainty_rows(document: CalibrationFile, accepted: Acceptance | None) -> list[Row]:
    known = document.uncertainty
    if known is None:
        return []
    total = known.total_um
    compared = () if accepted is None else (accepted.good_um, accepted.usable_um)
    rows: list[Row] = [
        (
            message("point-standard-uncertainty"),
            *in_both_units(total, compared),
            "1",
            _limits(accepted, total),
        ),
        (message("point-expanded-uncertainty"), *in_both_units(2 * total), "2", ""),
    ]
    if known.plane is not None:
        angle, offset = quantity(known.plane.angle_arcsec, "″"), known.plane.offset_um
        rows += [
            (message("plane-swept-straight-across-angle"), angle, "", "1", ""),
            (message("same-offset"), *in_both_units(offset), "1", ""),
        ]
    near, far = known.depth_range_mm
    depths = message("from-to", low=quantity(near, "", 1), high=quantity(far, "mm", 1))
    rows.append((message("calibrated-distance-camera"), "", depths, "", ""))
    return rows


def _residual_rows(document: CalibrationFile, session: BlockSession | BoardSession) -> list[Row]:
    residuals = document.residuals
    if residuals is None:
        return []
    board = isinstance(session, BoardSession)
    fitted = message("corners-rms") if board else message("edges-corners-rms")
    rows: list[Row] = [
        (fitted, quantity(residuals.reprojection_rms_px, "px", 3), "", "", ""),
    ]
    if residuals.laser_plane_rms_um is not None:
        stripe = message("stripe-about-laser-plane-rms-points", points=residuals.stripe_points)
        rows.append((stripe, *in_both_units(residuals.laser_plane_rms_um), "", ""))
    if residuals.contacts_um:
        count, outliers = len(residuals.contacts_um), len(residuals.contacts_left_out)
        title = (
            message("contacts-rms-outliers", count=count, outliers=outliers)
            if outliers
            else message("contacts-rms", count=count)
        )
        rows.append((title, *in_both_units(residuals.contacts_rms_um), "", ""))
    return rows


def _limits(accepted: Acceptance | None, total_um: float) -> Text:
    if accepted is None or accepted.good_um is None or accepted.usable_um is None:
        return UNKNOWN
    good, usable = (
        limit_beside(total_um, one, "µm") for one in (accepted.good_um, accepted.usable_um)
    )
    return message("good-m-usable-m", good=good, usable=usable)


def _rule(document: CalibrationFile, accepted: Acceptance | None) -> list[TextBlock[Text]]:
    texts: list[Text] = [message("decision-rule-limits-set-standard-uncertainty")]
    if document.uncertainty is not None:
        rule = FORMER_POINT_RULE if accepted is None else accepted.rule
        texts.append(_point_rule(rule, document.uncertainty.total_um))
    texts.append(message("calibration-acceptance-test-no-characteristic-iso"))
    if accepted is not None and accepted.compared is not None:
        moved = accepted.compared
        texts.append(
            message(
                "against-use-before-points-measuring-volume",
                name=moved.name,
                rms=micrometres(moved.rms_um),
                rms_mm=millimetres(moved.rms_um),
                largest=micrometres(moved.max_um),
                largest_mm=millimetres(moved.max_um),
            )
        )
    return [TextBlock(text) for text in texts]


def _point_rule(rule: RulePart, point_um: float) -> Text:
    """What the rule means for a feature that is given by one scanned point."""
    guard_um = rule.guard_factor * point_um
    if guard_um == 0:
        meant = message("point-judged-without-guard")
    else:
        meant = message(
            "point-judged-with-guard",
            guard=micrometres(guard_um),
            guard_mm=millimetres(guard_um),
            bearer=rule.bearer,
        )
    return join([describe_rule(rule), meant], " ")


def _findings(document: CalibrationFile) -> Section[Text]:
    findings = document.verdict.findings if document.verdict else ()
    rows = [ReportFinding(one.quality, one.text, one.remedy) for one in findings]
    return Section(message("findings"), [Findings(rows)] if rows else [], together=False)


def _pictures(
    document: CalibrationFile, session: BlockSession | BoardSession, accepted: Acceptance | None
) -> list[Section[Text]]:
    camera = document.camera.model()
    sections: list[Section[Text]] = []
    if isinstance(session, BlockSession):
        sections.append(
            Section(message("residuals-object"), [Pictures([_contact_figure(document, session)])])
        )
    by_number = {pose.number: pose for pose in session.poses}
    images = [
        image_figure(
            by_number[part.number], session_channel(session), part, camera, _fit_basis(session)
        )
        for part in _worst_poses(document)
        if part.number in by_number
    ]
    if images:
        used = sum(part.used for part in document.poses)
        title = (
            message("residuals-image-worst-poses", count=len(images), used=used)
            if len(images) < used
            else message("residuals-image")
        )
        sections.append(Section(title, [Pictures(images, 3)], together=False))
    if document.uncertainty is not None:
        plane, over = document.laser_plane, None
        if plane is not None:
            over = volume_figure(document.uncertainty, camera, plane.model())
        if over is not None:
            sections.append(
                Section(message("uncertainty-over-measuring-volume"), [Pictures([over])])
            )
        limits = (accepted.good_um, accepted.usable_um) if accepted else (None, None)
        bars = budget_figure(document.uncertainty, *limits)
        sections.append(Section(message("error-budget"), [Pictures([bars])]))
    return sections


def _fit_basis(session: BlockSession | BoardSession) -> FitBasis:
    """The features of the object to which the poses were fitted; a board has no measured edges."""
    return "corners" if isinstance(session, BoardSession) else "edges"


def _worst_poses(document: CalibrationFile) -> list[PosePart]:
    """The poses with the largest edge residuals, in order of capture."""
    drawn = [pose for pose in document.poses if pose.used and pose.corners_at_px]
    worst = sorted(drawn, key=lambda pose: -pose.edges_rms_px)[:DISPLAYED_POSES]
    return sorted(worst, key=lambda pose: pose.number)


def _contact_figure(document: CalibrationFile, session: BlockSession) -> tuple[Figure[Text], Text]:
    residuals_um = document.residuals.contacts_um if document.residuals is not None else ()
    outliers = document.residuals.contacts_left_out if document.residuals is not None else ()
    count = min(len(residuals_um), len(session.contacts.features))
    return object_figure(
        session.block,
        session.contacts.features[:count],
        _contact_points(document, session.arm, session)[:count],
        residuals_um[:count],
        outliers,
    )


def _contact_points(document: CalibrationFile, arm: Arm, session: BlockSession) -> Floats:
    """(N, 3) tip centres in the object frame."""
    assert document.T_arm_obj is not None
    T = np.array(document.T_arm_obj)
    return np.asarray((tip_centres(arm, session.contacts.q_rad) - T[:3, 3]) @ T[:3, :3])
