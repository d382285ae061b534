"""``calibration.json``: what a calibration found, from what, and how good it is."""

import math
from dataclasses import dataclass
from functools import cached_property
from pathlib import Path
from typing import ClassVar, Literal, Self

import numpy as np
from pydantic import Field, model_validator

from crenel.errors import OperationError
from crenel.formats.io_errors import prefix_errors
from crenel.formats.json_document import (
    Document,
    DocumentPart,
    Matrix3,
    Matrix4,
    Matrix34,
    NotNegative,
    Number,
    Software,
    Vector3,
    require_covariance,
)
from crenel.messages.message import Text, message
from crenel.metrology.calibration.findings import Quality
from crenel.metrology.sensor.camera import Camera, project, rays
from crenel.metrology.sensor.laser_plane import LaserPlane
from crenel.metrology.sensor.line_range import find_line_bounds
from crenel.metrology.stripe import LineBounds
from crenel.metrology.transforms import Floats

CALIBRATION = "calibration.json"
RIGID_TOLERANCE = 1e-6
LENS_TOLERANCE_PX = 0.01
NO_PLANE = "no-laser-plane"
"""Code of the refusal of what needs the laser plane, where there is none yet."""
AGREEMENT = 1e-6
"""Relative: how well ``projection_matrix`` equals ``matrix [rotation | translation_mm]``."""


class CameraPart(DocumentPart):
    projection_matrix: Matrix34
    matrix: Matrix3
    rotation: Matrix3
    translation_mm: Vector3
    distortion: tuple[Number, Number, Number, Number, Number]
    width_px: int = Field(gt=0, le=65536)
    height_px: int = Field(gt=0, le=65536)

    @model_validator(mode="after")
    def _agrees_with_itself(self) -> Self:
        _require_rotation(np.array(self.rotation), "rotation")
        product = np.array(self.matrix) @ np.column_stack([self.rotation, self.translation_mm])
        # a projection matrix means the same at any scale
        given = np.array(self.projection_matrix)
        length = float(np.linalg.norm(given[2, :3]))
        if length == 0 or not np.allclose(
            given / length, product, rtol=AGREEMENT, atol=AGREEMENT * float(np.abs(product).max())
        ):
            raise ValueError(message("projection-matrix-is-not-product"))
        if not _is_lens_invertible(self.model()):
            raise ValueError(message("distortion-not-invertible"))
        return self

    def model(self) -> Camera:
        return Camera(
            matrix=np.array(self.matrix),
            rotation=np.array(self.rotation),
            translation_mm=np.array(self.translation_mm),
            width_px=self.width_px,
            height_px=self.height_px,
            distortion=np.array(self.distortion),
        )


class LaserPlanePart(DocumentPart):
    normal: Vector3
    offset_mm: Number

    @model_validator(mode="after")
    def _normal_is_unit(self) -> Self:
        if abs(math.hypot(*self.normal) - 1) > RIGID_TOLERANCE:
            raise ValueError(message("normal-must-have-unit-length"))
        return self

    def model(self) -> LaserPlane:
        return LaserPlane(np.array(self.normal), self.offset_mm)


class SerialNumbers(DocumentPart):
    """Empty where unknown."""

    arm: str = ""
    object: str = ""
    sensor: str = ""


class FacePart(DocumentPart):
    face: str
    points: int
    rms_um: NotNegative
    form_um: NotNegative


class WorstPart(DocumentPart):
    kind: Literal["contact", "corner", "stripe"]
    name: Text
    value: NotNegative
    unit: str


class ResidualsPart(DocumentPart):
    """What the measurements left over."""

    reprojection_rms_px: NotNegative
    corners_px: dict[str, tuple[Number, Number]] = Field(default_factory=dict)
    """Found minus computed (u, v) of each corner of the one pose."""
    laser_plane_rms_um: NotNegative | None = None
    """None without a laser plane."""
    stripe_points: int = 0
    contacts_rms_um: NotNegative = 0.0
    contacts_um: tuple[Number, ...] = ()
    """Distance of each contact from its face, in the order of ``probing.csv``."""
    contacts_left_out: tuple[int, ...] = ()
    """Index of each contact that was named an outlier."""
    faces: tuple[FacePart, ...] = ()
    worst: tuple[WorstPart, ...] = ()
    """The few that fit worst of each kind."""


class BudgetPart(DocumentPart):
    source: str
    value_um: NotNegative


class MapPart(DocumentPart):
    """Over the picture, wherever its rays meet the laser plane at a usable depth."""

    uv_px: tuple[tuple[Number, Number], ...]
    points_mm: tuple[Vector3, ...]
    """In the sensor frame."""
    u_um: tuple[NotNegative, ...]
    calibrated: tuple[bool, ...]
    """Within the depths that the stripe covered; elsewhere it is extrapolated."""


class PlanePart(DocumentPart):
    """The errors of a plane that faces the sensor in the middle of its volume, swept straight
    across."""

    angle_arcsec: NotNegative
    """About the direction of the sweep."""
    offset_um: NotNegative


class Uncertainty(DocumentPart):
    """Standard uncertainties in the flange frame."""

    k: Literal[1] = 1
    """The coverage factor of every figure here."""
    total_um: NotNegative
    """The uncertainty of a reconstructed point, rms over the measuring volume."""
    budget: tuple[BudgetPart, ...]
    depth_range_mm: tuple[Number, Number]
    """Nearest and furthest distance from the camera's centre that the object covered."""
    plane: PlanePart | None = None
    map: MapPart | None = None


class PosePart(DocumentPart):
    """What became of one pose; without residuals where it was left out."""

    number: int
    used: bool
    reason: Text = ""
    edges_rms_px: NotNegative = 0.0
    edge_points: int = 0
    stripe_rms_px: NotNegative = 0.0
    stripe_points: int = 0
    off_um: NotNegative = 0.0
    """How far the arm's noise had to move the object for the pose to agree."""
    corners_px: dict[str, tuple[Number, Number]] = Field(default_factory=dict)
    """Found minus computed (u, v) of each corner."""
    corners_at_px: dict[str, tuple[Number, Number]] = Field(default_factory=dict)
    """Where each was found."""
    stripe_off_px: tuple[Vector3, ...] = ()
    """u, v of some of the stripe's points, and how far each lies off the adjusted line."""


class ScalesPart(DocumentPart):
    """Standard deviations estimated from the data themselves."""

    links_rad: NotNegative
    links_mm: NotNegative
    reading_factor: NotNegative
    """On the noise of the arm's readings by its datasheet."""
    touch_mm: NotNegative


class FindingPart(DocumentPart):
    quality: Quality
    code: str
    text: Text
    remedy: Text = ""


class VerdictPart(DocumentPart):
    """What is to be said of the calibration: as bad as the gravest of its findings, and in the
    words of the first, which is the gravest; of a good one, how well a point is known."""

    quality: Quality
    text: Text
    findings: tuple[FindingPart, ...] = ()


class Covariance(DocumentPart):
    """The covariance of camera, laser plane, probe matrix and the arm's links together; of files
    from one pose, and of those written before, without the links."""

    parameters: tuple[str, ...]
    matrix: tuple[tuple[Number, ...], ...]
    pivot_mm: Vector3
    """In the flange frame; the probe matrix' six are a left perturbation (rad, mm) about it."""
    links: tuple[Number, ...] = ()
    """(6n,) the estimated errors of the links, each a twist (rad, mm) behind its link, in its
    frame. Points are reconstructed without them."""

    @model_validator(mode="after")
    def _fits_its_parameters(self) -> Self:
        require_covariance(self.matrix, len(self.parameters))
        named = sum(name.startswith("link") for name in self.parameters)
        if len(self.links) != named:
            raise ValueError(message("links-one-for-each-parameter", count=named))
        return self


class Input(DocumentPart):
    file: str
    sha256: str


class CalibrationFile(Document):
    """The file; all but ``camera`` and ``probe_matrix`` may be missing in files of other origin."""

    FORMAT: ClassVar[str] = "crenel/calibration"

    camera: CameraPart
    laser_plane: LaserPlanePart | None = None
    """None where camera and mounting alone were calibrated."""
    probe_matrix: Matrix4
    stripe_axis: Literal["u", "v"] = "u"
    channel: Text | None = None
    """What of the pictures was measured: grey, or what of a colour camera's."""
    extraction: str | None = None
    """What was set of the line, as JSON like that of recordings; None where all was automatic."""
    method: str | None = None
    created_at: str | None = None
    operator: str | None = None
    serial_numbers: SerialNumbers = SerialNumbers()
    T_arm_obj: Matrix4 | None = None
    camera_from: Input | None = None
    """The calibration whose camera and mounting were kept, to which the laser plane was added."""
    corners_mm: tuple[Vector3, ...] = ()
    """Where a chessboard's inner corners truly lie, row after row, in its own frame."""
    verdict: VerdictPart | None = None
    uncertainty: Uncertainty | None = None
    residuals: ResidualsPart | None = None
    poses: tuple[PosePart, ...] = ()
    scales: ScalesPart | None = None
    condition_number: NotNegative | None = None
    orthogonality_defect: NotNegative | None = None
    covariance: Covariance | None = None
    inputs: tuple[Input, ...] = ()
    software: Software | None = None

    @model_validator(mode="after")
    def _transforms_are_rigid(self) -> Self:
        for name in ("probe_matrix", "T_arm_obj"):
            rows = getattr(self, name)
            if rows is None:
                continue
            T = np.array(rows)
            if not np.array_equal(T[3], [0, 0, 0, 1]):
                raise ValueError(message("last-row-must-0-0-0", name=name))
            _require_rotation(T[:3, :3], name)
        return self


@dataclass(frozen=True)
class Calibration:
    """What it takes to reconstruct points."""

    camera: Camera
    plane: LaserPlane
    T_flange_sensor: Floats
    """(4, 4), the probe matrix."""
    stripe_axis: Literal["u", "v"]
    serial_numbers: SerialNumbers
    depth_range_mm: tuple[float, float] | None = None
    """Nearest and furthest calibrated distance; None where the file does not say it."""

    @cached_property
    def line_bounds(self) -> LineBounds | None:
        """Where in its pictures the line can be; None where that is anywhere."""
        return self.find_line_bounds(self.stripe_axis)

    def find_line_bounds(self, axis: str) -> LineBounds | None:
        """The same of lines along another axis."""
        if self.depth_range_mm is None:
            return None
        return find_line_bounds(self.camera, self.plane, self.depth_range_mm, axis)


def read_calibration(path: Path) -> Calibration:
    """Reads what reconstruction needs.

    Raises:
        OperationError: names the file and the field; ``no-laser-plane``.
    """
    document = CalibrationFile.read(path)
    with prefix_errors(path):
        return calibration_from_document(document)


def calibration_from_document(document: CalibrationFile) -> Calibration:
    """What reconstruction needs of a calibration.

    Raises:
        OperationError: ``no-laser-plane``, if camera and mounting alone were calibrated.
    """
    if document.laser_plane is None:
        raise OperationError(
            NO_PLANE,
            message("calibration-has-no-laser-plane"),
            "",
            message("add-the-laser-to-camera-and-mounting"),
        )
    return Calibration(
        camera=document.camera.model(),
        plane=document.laser_plane.model(),
        T_flange_sensor=np.array(document.probe_matrix),
        stripe_axis=document.stripe_axis,
        serial_numbers=document.serial_numbers,
        depth_range_mm=document.uncertainty.depth_range_mm if document.uncertainty else None,
    )


def _require_rotation(R: Floats, name: str) -> None:
    unlike = float(np.abs(R @ R.T - np.eye(3)).max())
    if unlike > RIGID_TOLERANCE or np.linalg.det(R) < 0:
        raise ValueError(message("matrix-is-no-rotation", name=name, difference=f"{unlike:.2g}"))


def _is_lens_invertible(camera: Camera) -> bool:
    """False for a distortion that folds the picture over, as no lens does."""
    u, v = (np.linspace(0, size - 1, 9) for size in (camera.width_px, camera.height_px))
    uv_px = np.column_stack([axis.ravel() for axis in np.meshgrid(u, v)])
    with np.errstate(all="ignore"):
        origin, along = rays(camera, uv_px)
        off_px = np.abs(project(camera, origin + along) - uv_px)
    return bool((off_px < LENS_TOLERANCE_PX).all())
