"""Reconstructs and measures one recording of a gauge: one cloud of a verification."""

from dataclasses import dataclass
from pathlib import Path

import numpy as np

from crenel.formats.clouds.points import Points, positions_of
from crenel.formats.json_document import DocumentPart, NotNegative, Number, Positive, Vector3
from crenel.formats.results.calibration import Calibration
from crenel.gauges.plan.document_gauge import GaugeFile, Shape
from crenel.gauges.quick.document import FiltersPart
from crenel.gauges.quick.evaluate_deviation_maps import MapFile, map_record
from crenel.gauges.quick.maths.gauge_gate import CONE_DEG, GATE_MM
from crenel.gauges.quick.maths.scanned_gauge import (
    SAME_PLACE_MM,
    GaugeCloud,
    fit_gauge_plane,
    fit_gauge_sphere,
)
from crenel.messages.message import Text
from crenel.metrology.arm.kinematics import AnyArm
from crenel.metrology.fitting.plane_sphere import FILTER_SIGMAS, PlaneFit, SphereFit
from crenel.metrology.transforms import Floats
from crenel.workflows.reconstruct import Reconstruction, reconstruct_into


class GaugeFit(DocumentPart):
    """The shape fitted to a cloud, as stored in the journal."""

    points: int
    used: int
    frames: int
    rms_um: NotNegative
    form_um: NotNegative
    in_gate: int | None = None
    """Points within the geometric gate; None, like the following, in older journals."""
    form_all_um: NotNegative | None = None
    range_all_um: NotNegative | None = None
    rms_sd_um: NotNegative = 0.0
    """Standard uncertainty of the rms by the scatter of the points, k = 1; 0, like the next three,
    in older journals."""
    form_sd_um: NotNegative = 0.0
    form_all_sd_um: NotNegative = 0.0
    range_all_sd_um: NotNegative = 0.0
    width_mm: NotNegative | None = None
    """The width of a plane's cloud in its narrower direction."""
    centre_mm: Vector3
    normal: Vector3 | None = None
    offset_mm: Number | None = None
    radius_mm: Positive | None = None
    covariance: tuple[tuple[Number, ...], ...] = ()
    """k = 1, mm and rad; for a plane, the shift and two tilts; for a sphere, centre and radius.
    Empty with too few frames."""
    warnings: tuple[Text, ...] = ()

    @property
    def plane(self) -> PlaneFit:
        """The plane of a cloud, without its points."""
        assert self.normal is not None
        assert self.offset_mm is not None
        return PlaneFit(
            np.array(self.normal),
            self.offset_mm,
            np.array(self.centre_mm),
            self.rms_um / 1e3,
            self.form_um / 1e3,
            np.zeros(0, dtype=np.bool_),
        )

    def sd(self, index: slice) -> float:
        """Standard uncertainty in the worst direction of some parameters, k = 1; from the scatter
        of single points if the covariance is unknown."""
        if not self.covariance:
            return self.rms_um / 1e3
        part = np.array(self.covariance)[index, index]
        return float(np.sqrt(max(float(np.linalg.eigvalsh(part)[-1]), 0.0)))


@dataclass(frozen=True)
class GaugeMeasurement:
    """One cloud: its fit, and its map."""

    fit: GaugeFit
    map: MapFile


def filters_of(shape: Shape) -> FiltersPart:
    """What chooses the points of a gauge's figures."""
    return FiltersPart(
        sigmas=FILTER_SIGMAS,
        same_place_mm=SAME_PLACE_MM,
        gate_mm=GATE_MM,
        gate_deg=CONE_DEG if shape == "sphere" else None,
    )


def measure_recording(
    recording: Path, calibration: Calibration, arm: AnyArm, gauge: GaugeFile
) -> GaugeMeasurement:
    """Reconstructs the points of a recording and fits the shape of the gauge to them.

    Raises:
        OperationError: as ``rebuild``; or the cloud does not show the gauge, or too little of it.
    """
    kept: list[Points] = []
    sensor_mm: list[Floats] = []
    rebuilt = reconstruct_into(
        recording,
        calibration,
        arm,
        lambda points, _: kept.append(points),
        take_frames=lambda first, sensor, poses, _: sensor_mm.append(poses[:, :3, 3]),
    )
    points = np.concatenate(kept)
    xyz: Floats = positions_of(points)
    frame = points["frame"].astype(np.int64)
    if gauge.shape == "plane":
        found = fit_gauge_plane(xyz, frame, np.nanmean(np.concatenate(sensor_mm), axis=0))
    else:
        assert gauge.radius_mm is not None
        found = fit_gauge_sphere(xyz, frame, gauge.radius_mm)
    return GaugeMeasurement(_fit_record(found, rebuilt), map_record(found))


def _fit_record(found: GaugeCloud, rebuilt: Reconstruction) -> GaugeFit:
    fit = found.shape.fit
    covariance = found.shape.covariance
    values: dict[str, object] = {
        "points": found.points,
        "used": found.used,
        "frames": rebuilt.frames,
        "rms_um": fit.rms_mm * 1e3,
        "form_um": found.form_mm * 1e3,
        "in_gate": found.unfiltered.points,
        "form_all_um": found.unfiltered.dispersion_mm * 1e3,
        "range_all_um": found.unfiltered.range_mm * 1e3,
        "rms_sd_um": found.rms_sd_mm * 1e3,
        "form_sd_um": found.form_sd_mm * 1e3,
        "form_all_sd_um": found.unfiltered.dispersion_sd_mm * 1e3,
        "range_all_sd_um": found.unfiltered.range_sd_mm * 1e3,
        "width_mm": found.width_mm,
        "covariance": () if covariance is None else covariance.tolist(),
        "warnings": rebuilt.warnings,
    }
    if isinstance(fit, PlaneFit):
        values |= {
            "centre_mm": fit.centre_mm.tolist(),
            "normal": fit.normal.tolist(),
            "offset_mm": fit.offset_mm,
        }
    elif isinstance(fit, SphereFit):
        values |= {"centre_mm": fit.centre_mm.tolist(), "radius_mm": fit.radius_mm}
    return GaugeFit.model_validate(values)
