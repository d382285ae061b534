"""From a session's folder to its calibration file."""

import getpass
from collections.abc import Sequence
from dataclasses import asdict, dataclass
from datetime import UTC, datetime
from pathlib import Path
from typing import Literal

import numpy as np

from app.files.atomic import checked_target
from app.files.calibration import (
    BudgetPart,
    CalibrationFile,
    CameraPart,
    Covariance,
    FacePart,
    FindingPart,
    Input,
    LaserPlanePart,
    Residuals,
    SerialNumbers,
    Uncertainty,
    Verdict,
)
from app.files.documents import sha256_of
from app.files.failures import refusals_naming
from app.files.images import read_grey
from app.files.progress import Progress, no_progress
from app.files.session import Pose, Session, read_session
from app.files.software import SOFTWARE
from app.metrology.camera import Camera
from app.metrology.findings import Quality
from app.metrology.one_pose import OnePoseCalibration, OnePoseInputs, calibrate_one_pose

QUALITIES: tuple[Quality, ...] = ("neutral", "good", "attention", "bad")


@dataclass(frozen=True)
class Origin:
    """What a calibration came from, beside its numbers."""

    serial_numbers: SerialNumbers
    stripe_axis: Literal["u", "v"]
    inputs: tuple[Input, ...]
    operator: str


def calibrate_session(
    folder: Path, output: Path, progress: Progress = no_progress
) -> tuple[CalibrationFile, list[str]]:
    """The paper's calibration of a session's first pose, written to ``output``.

    Returns:
        What was written, and what whoever asked for it should know beside it.

    Raises:
        Refusal: the session or the place to write to is not in order, or no
            calibration follows from it; nothing is then written.
    """
    checked_target(output)
    session = read_session(folder)
    checked_target(output, session.files)
    pose = session.poses[0]
    inputs = one_pose_inputs(session, pose)
    with refusals_naming(folder):
        result = calibrate_one_pose(inputs, lambda text, share: progress(share, text))
    sheet = calibration_from(result, origin_of(session, pose, _user()))
    sheet.write(output)
    unused = len(session.poses) - 1
    warnings = (
        [f"pose {pose.number} was used; the other {unused} are not, by the method one-pose"]
        if unused
        else []
    )
    return sheet, warnings


def one_pose_inputs(session: Session, pose: Pose) -> OnePoseInputs:
    """The pictures of a pose read, and what goes with them; ``Refusal`` if damaged."""
    return OnePoseInputs(
        arm=session.arm,
        block=session.block,
        features=session.contacts.features,
        contact_q_rad=session.contacts.q_rad,
        pose_q_rad=pose.q_rad,
        ambient=read_grey(pose.ambient),
        laser=None if pose.laser is None else read_grey(pose.laser),
        stripe_axis=session.sensor.stripe_axis,
        size_px=(session.sensor.width_px, session.sensor.height_px),
    )


def origin_of(session: Session, pose: Pose, operator: str) -> Origin:
    """Serial numbers, and the SHA-256 of every file that the calibration used."""
    folder = session.folder
    return Origin(
        serial_numbers=SerialNumbers(
            arm=session.arm.serial_number,
            object=session.block.serial_number,
            sensor=session.sensor.serial_number,
        ),
        stripe_axis=session.sensor.stripe_axis,
        inputs=tuple(
            Input(file=path.relative_to(folder).as_posix(), sha256=sha256_of(path))
            for path in (*session.tables, *pose.files)
        ),
        operator=operator,
    )


def calibration_from(result: OnePoseCalibration, origin: Origin) -> CalibrationFile:
    """The file of a calibration, made now."""
    plane, budget = result.plane, result.full_budget
    return CalibrationFile.model_validate(
        {
            "camera": _camera_part(result.camera),
            "laser_plane": LaserPlanePart.model_validate(
                {"normal": plane.normal.tolist(), "offset_mm": plane.offset_mm}
            ),
            "probe_matrix": result.T_flange_sensor.tolist(),
            "stripe_axis": origin.stripe_axis,
            "method": "one-pose",
            "created_at": datetime.now(UTC).isoformat(timespec="seconds"),
            "operator": origin.operator,
            "serial_numbers": origin.serial_numbers,
            "T_arm_obj": result.alignment.T_arm_obj.tolist(),
            "verdict": _verdict(result),
            "uncertainty": Uncertainty(
                total_um=budget.total_um,
                budget=tuple(
                    BudgetPart(source=row.source, value_um=row.value_um) for row in budget.rows
                ),
                depth_range_mm=result.depth_range_mm,
            ),
            "residuals": _residuals(result),
            "condition_number": result.faugeras.condition_number,
            "orthogonality_defect": result.faugeras.orthogonality_defect,
            "covariance": Covariance.model_validate(
                {
                    "parameters": budget.names,
                    "matrix": budget.covariance.tolist(),
                    "pivot_mm": budget.pivot_mm.tolist(),
                }
            ),
            "inputs": origin.inputs,
            "software": SOFTWARE,
        }
    )


def _camera_part(camera: Camera) -> CameraPart:
    return CameraPart.model_validate(
        {
            "projection_matrix": camera.projection_matrix.tolist(),
            "matrix": camera.matrix.tolist(),
            "rotation": camera.rotation.tolist(),
            "translation_mm": camera.translation_mm.tolist(),
            "distortion": camera.distortion.tolist(),
            "width_px": camera.width_px,
            "height_px": camera.height_px,
        }
    )


def _residuals(result: OnePoseCalibration) -> Residuals:
    alignment = result.alignment
    corners = zip(result.detection.corners, result.corner_residuals_px.tolist(), strict=True)
    return Residuals.model_validate(
        {
            "reprojection_rms_px": result.reprojection_rms_px,
            "corners_px": {corner.name: residual for corner, residual in corners},
            "laser_plane_rms_um": result.laser.rms_mm * 1e3,
            "stripe_points": int(np.sum(result.laser.used)),
            "contacts_rms_um": alignment.rms_mm * 1e3,
            "contacts_um": (alignment.residuals_mm * 1e3).tolist(),
            "contacts_left_out": np.flatnonzero(alignment.outliers).tolist(),
            "worst": [asdict(point) for point in result.worst],
            "faces": [
                FacePart(
                    face=face.face,
                    points=face.points,
                    rms_um=face.rms_mm * 1e3,
                    form_um=face.form_mm * 1e3,
                )
                for face in alignment.faces
            ],
        }
    )


def _verdict(result: OnePoseCalibration) -> Verdict:
    findings = tuple(
        FindingPart(
            quality=finding.quality, code=finding.code, text=finding.text, remedy=finding.remedy
        )
        for finding in result.findings
    )
    return Verdict(
        quality=worst_of([finding.quality for finding in findings]),
        text=findings[0].text.rstrip("."),
        findings=findings,
    )


def worst_of(qualities: Sequence[Quality]) -> Quality:
    """The worst of some qualities; good where there are none."""
    return max(qualities, key=QUALITIES.index, default="good")


def _user() -> str:
    """Who runs the program, where the system knows."""
    try:
        return getpass.getuser()
    except (KeyError, OSError):
        return ""


def figures_of(sheet: CalibrationFile) -> list[tuple[str, str]]:
    """What an operator wants to know of a new calibration: names and values to print."""
    figures: list[tuple[str, str]] = []
    if sheet.verdict:
        figures.append(("verdict", sheet.verdict.quality))
        for finding in sheet.verdict.findings:
            mark = "" if finding.quality in ("good", "neutral") else f"{finding.quality.upper()}: "
            figures.append(("", f"{mark}{finding.text} {finding.remedy}"))
    if sheet.uncertainty:
        figures += _uncertainty_figures(sheet.uncertainty)
    if sheet.residuals:
        figures += _residual_figures(sheet.residuals)
    k1, k2, p1, p2, k3 = sheet.camera.distortion
    used = [
        f"{name} {value:+.5f}"
        for name, value in (("k1", k1), ("k2", k2), ("p1", p1), ("p2", p2), ("k3", k3))
        if value
    ]
    figures.append(("lens", ", ".join(used) or "no distortion"))
    if sheet.condition_number is not None:
        figures.append(("condition number", f"{sheet.condition_number:.1f} (refused above 50)"))
    for title, row in zip(("probe matrix", "", ""), sheet.probe_matrix, strict=False):
        figures.append((title, "".join(f"{value:12.6f}" for value in row)))
    return figures


def _uncertainty_figures(uncertainty: Uncertainty) -> list[tuple[str, str]]:
    near_mm, far_mm = uncertainty.depth_range_mm
    figures = [("uncertainty of a point", f"{uncertainty.total_um:.1f} µm (k = 1)")]
    figures += [(f"  {row.source}", f"{row.value_um:.1f} µm") for row in uncertainty.budget]
    return [*figures, ("depth range", f"{near_mm:.1f} to {far_mm:.1f} mm from the camera")]


def _residual_figures(residuals: Residuals) -> list[tuple[str, str]]:
    left_out = len(residuals.contacts_left_out)
    contacts = f"{residuals.contacts_rms_um:.1f} µm rms of {len(residuals.contacts_um)}"
    figures = [
        ("edges", f"{residuals.reprojection_rms_px:.3f} px rms"),
        ("corners", f"{len(residuals.corners_px)}, {_rms_px(residuals):.3f} px rms"),
        (
            "laser plane",
            f"{residuals.laser_plane_rms_um:.1f} µm rms of {residuals.stripe_points} points",
        ),
        ("contacts", contacts + (f", {left_out} left out" if left_out else "")),
    ]
    for face in residuals.faces:
        form = f"{face.rms_um:6.1f} µm rms, form {face.form_um:.1f} µm, {face.points} points"
        figures.append((f"  {face.face}", form))
    return figures


def _rms_px(residuals: Residuals) -> float:
    values = np.array(list(residuals.corners_px.values()))
    return float(np.sqrt(np.mean(np.sum(values**2, axis=1)))) if len(values) else 0.0
