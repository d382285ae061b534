"""What was calibrated, as the file ``calibration.json`` has it."""

from collections.abc import Mapping, Sequence
from dataclasses import asdict, dataclass
from datetime import UTC, datetime
from typing import Literal

import numpy as np

from crenel.formats.json_document import SOFTWARE
from crenel.formats.results.calibration import (
    BudgetPart,
    CalibrationFile,
    CameraPart,
    Covariance,
    FacePart,
    FindingPart,
    Input,
    LaserPlanePart,
    MapPart,
    PlanePart,
    PosePart,
    ResidualsPart,
    ScalesPart,
    SerialNumbers,
    Uncertainty,
    VerdictPart,
)
from crenel.messages.message import Text
from crenel.metrology.adjustment.block.calibrate import BlockCalibration
from crenel.metrology.adjustment.board.calibrate import BoardCalibration
from crenel.metrology.adjustment.core.uncertainty import CalibrationUncertainty, UncertaintyMap
from crenel.metrology.adjustment.results.calibration import AdjustedCalibration
from crenel.metrology.adjustment.results.findings import joint_rms
from crenel.metrology.calibration.findings import CalibrationFinding
from crenel.metrology.calibration.one_pose import OnePoseCalibration
from crenel.metrology.calibration.uncertainty_budget import BudgetContribution
from crenel.metrology.probing.alignment import Alignment
from crenel.metrology.sensor.camera import Camera
from crenel.metrology.sensor.laser_plane import LaserPlane


@dataclass(frozen=True)
class Origin:
    """What a calibration came from, beside its numbers."""

    serial_numbers: SerialNumbers
    stripe_axis: Literal["u", "v"]
    channel: Text
    extraction: str
    """What was set of the line; empty where all was automatic."""
    inputs: tuple[Input, ...]
    operator: str


def one_pose_document(result: OnePoseCalibration, origin: Origin) -> CalibrationFile:
    """The file of a calibration, made now."""
    budget = result.full_budget
    return CalibrationFile.model_validate(
        _common_fields(result, origin)
        | {
            "method": "one-pose",
            "T_arm_obj": result.alignment.T_arm_obj.tolist(),
            "uncertainty": Uncertainty(
                total_um=budget.total_um,
                budget=_budget_parts(budget.rows),
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
        }
    )


def _common_fields(
    result: OnePoseCalibration | AdjustedCalibration, origin: Origin
) -> dict[str, object]:
    """What every calibration file has, made now."""
    return {
        "camera": _camera_part(result.camera),
        "laser_plane": None if result.plane is None else _plane_part(result.plane),
        "probe_matrix": result.T_flange_sensor.tolist(),
        "stripe_axis": origin.stripe_axis,
        "channel": origin.channel,
        "extraction": origin.extraction or None,
        "created_at": datetime.now(UTC).isoformat(timespec="seconds"),
        "operator": origin.operator,
        "serial_numbers": origin.serial_numbers,
        "verdict": verdict_part(result.findings),
        "inputs": origin.inputs,
        "software": SOFTWARE,
    }


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


def _residuals(result: OnePoseCalibration) -> ResidualsPart:
    corners = zip(result.detection.corners, result.corner_residuals_px.tolist(), strict=True)
    return ResidualsPart.model_validate(
        {
            "reprojection_rms_px": result.reprojection_rms_px,
            "corners_px": {corner.name: residual for corner, residual in corners},
            "laser_plane_rms_um": result.laser.rms_mm * 1e3,
            "stripe_points": int(np.sum(result.laser.used)),
            "worst": [asdict(point) for point in result.worst],
            **_contact_residuals(result.alignment),
        }
    )


def verdict_part(found: Sequence[CalibrationFinding]) -> VerdictPart:
    """As bad as the gravest of the findings, which is the first, and in its words."""
    findings = tuple(
        FindingPart(
            quality=finding.quality, code=finding.code, text=finding.text, remedy=finding.remedy
        )
        for finding in found
    )
    return VerdictPart(
        quality=findings[0].quality,
        text=findings[0].text,
        findings=findings,
    )


def _budget_parts(rows: Sequence[BudgetContribution]) -> tuple[BudgetPart, ...]:
    return tuple(BudgetPart(source=row.source, value_um=row.value_um) for row in rows)


def _contact_residuals(alignment: Alignment) -> dict[str, object]:
    """Those fields of the residuals."""
    return {
        "contacts_rms_um": alignment.rms_mm * 1e3,
        "contacts_um": (alignment.residuals_mm * 1e3).tolist(),
        "contacts_left_out": np.flatnonzero(alignment.outliers).tolist(),
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


def joint_document(result: BlockCalibration, origin: Origin) -> CalibrationFile:
    """The file of a calibration over many poses, made now."""
    return _multi_pose_document(result, origin, _contact_residuals(result.alignment))


def board_document(result: BoardCalibration, origin: Origin) -> CalibrationFile:
    """The file of a calibration on a chessboard, made now."""
    contacts = result.contacts
    document = _multi_pose_document(
        result,
        origin,
        {}
        if contacts is None
        else {
            "contacts_rms_um": contacts.rms_um,
            "contacts_um": contacts.residuals_um.tolist(),
            "contacts_left_out": np.flatnonzero(contacts.excluded).tolist(),
        },
    )
    corners = tuple((x, y, z) for x, y, z in result.corners_mm.round(5).tolist())
    return document.model_copy(update={"corners_mm": corners})


def _multi_pose_document(
    result: AdjustedCalibration, origin: Origin, contacts: Mapping[str, object]
) -> CalibrationFile:
    """``contacts`` are those fields of the residuals."""
    scales = result.adjustment.scales
    return CalibrationFile.model_validate(
        _common_fields(result, origin)
        | {
            "method": "joint",
            "T_arm_obj": result.T_arm_obj.tolist(),
            "uncertainty": _uncertainty(result.uncertainty, result.depth_range_mm),
            "residuals": _multi_pose_residuals(result, contacts),
            "poses": tuple(
                PosePart.model_validate(
                    asdict(pose)
                    | {
                        "corners_px": {name: (u, v) for name, u, v in pose.corners_px},
                        "corners_at_px": {name: (u, v) for name, u, v in pose.corners_at_px},
                    }
                )
                for pose in result.poses
            ),
            "scales": ScalesPart(
                links_rad=scales.links_rad,
                links_mm=scales.links_mm,
                reading_factor=scales.noise,
                touch_mm=scales.touch_mm,
            ),
            "covariance": Covariance.model_validate(
                {
                    "parameters": result.uncertainty.names,
                    "matrix": result.uncertainty.covariance.tolist(),
                    "pivot_mm": result.uncertainty.pivot_mm.tolist(),
                    "links": result.uncertainty.links.tolist(),
                }
            ),
        }
    )


def _uncertainty(known: CalibrationUncertainty, depth_range_mm: tuple[float, float]) -> Uncertainty:
    return Uncertainty(
        total_um=known.total_um,
        budget=_budget_parts(known.rows),
        depth_range_mm=depth_range_mm,
        plane=None
        if known.plane is None
        else PlanePart(angle_arcsec=known.plane.angle_arcsec, offset_um=known.plane.offset_um),
        map=None if known.map is None else _map_part(known.map),
    )


def _map_part(over: UncertaintyMap) -> MapPart:
    return MapPart.model_validate(
        {
            "uv_px": over.uv_px.round(2).tolist(),
            "points_mm": over.points_mm.round(4).tolist(),
            "u_um": over.u_um.round(3).tolist(),
            "calibrated": over.calibrated.tolist(),
        }
    )


def _multi_pose_residuals(
    result: AdjustedCalibration, contacts: Mapping[str, object]
) -> ResidualsPart:
    used = [pose for pose in result.poses if pose.used]
    return ResidualsPart.model_validate(
        {
            "reprojection_rms_px": joint_rms(
                (pose.edges_rms_px, pose.edge_points) for pose in used
            ),
            "laser_plane_rms_um": result.stripe_rms_um,
            "stripe_points": sum(pose.stripe_points for pose in used),
            "worst": [asdict(point) for point in result.worst],
            **contacts,
        }
    )


def _plane_part(plane: LaserPlane) -> LaserPlanePart:
    return LaserPlanePart.model_validate(
        {"normal": plane.normal.tolist(), "offset_mm": plane.offset_mm}
    )
