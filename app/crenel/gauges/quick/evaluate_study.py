"""The article's test on the clouds of a verification: each rebuilt with every calibration.

Errors of a calibration appear from one calibration to the next, those of arm and scanning from one
cloud to the next (Figs. 7-11).
"""

from collections.abc import Sequence
from dataclasses import dataclass
from pathlib import Path
from typing import Annotated, ClassVar

import numpy as np
from pydantic import Field

from crenel.errors import OperationError
from crenel.formats.datasheets.arm import read_any_arm
from crenel.formats.file_names import display_path
from crenel.formats.json_document import Document, DocumentPart, NotNegative, Number
from crenel.formats.results.calibration import read_calibration
from crenel.formats.session.calibration_session import ARM, read_contacts
from crenel.gauges.plan.document_gauge import GaugeFile, Shape, read_gauge
from crenel.gauges.quick.document import CONTACTS, GAUGE, FigureName, read_verification
from crenel.gauges.quick.evaluate import cloud_errors
from crenel.gauges.quick.evaluate_budgets import cloud_budgets, steepness_of
from crenel.gauges.quick.evaluate_gauge import GaugeFit, measure_recording
from crenel.gauges.quick.evaluate_value_uncertainty import gauge_test_uncertainty
from crenel.gauges.quick.maths.errors import NominalPlane, NominalSphere
from crenel.gauges.quick.maths.figure_budget import combine_budget
from crenel.gauges.quick.maths.probed_gauge import (
    ProbedGauge,
    ProbedPlane,
    ProbedSphere,
    fit_probed_plane,
    fit_probed_sphere,
)
from crenel.messages.message import Text, join, message, replace_name
from crenel.metrology.arm.kinematics import AnyArm
from crenel.metrology.fitting.touched_shape import refuse_doubt
from crenel.progress import Progress, no_progress

STUDY_CALIBRATION = "calibration.json"
FIGURES: dict[str, FigureName] = {
    "rms_um": "rms",
    "angle_arcsec": "angle",
    "z_error_um": "z_error",
    "radius_error_um": "radius_error",
    "centre_error_um": "centre_error",
}
"""The figures of a row, in the order of its columns."""


@dataclass(frozen=True)
class AcceptedCalibration:
    """An accepted calibration; its folder also contains the arm on which it was made."""

    id: str
    name: str
    folder: Path


class StudyRow(DocumentPart):
    """One cloud with one calibration; for a plane, angle and Z; for a sphere, radius and centre."""

    cloud: int
    """Index among the study's clouds; ``calibration``: among its calibrations."""
    calibration: int
    rms_um: NotNegative
    angle_arcsec: NotNegative | None = None
    z_error_um: Number | None = None
    """Along Z (Eq. 11-12); for a steep plane, along its normal."""
    radius_error_um: Number | None = None
    centre_error_um: NotNegative | None = None
    expanded_uncertainty: Annotated[dict[str, NotNegative], Field(default_factory=dict)]
    """The expanded uncertainty of each figure (k = 2), by the name of its field; empty in older
    studies."""


class StudyRange(DocumentPart):
    """Range of a figure over the clouds of a calibration, or over the calibrations of a cloud."""

    of: int
    first: NotNegative
    """The range of the angle, or of the radius error."""
    second: NotNegative
    """The range of Z, or of the centre error."""


class StudyFile(Document):
    """``study.json``"""

    FORMAT: ClassVar[str] = "crenel/study"

    shape: Shape
    against_probe: bool
    """Otherwise relative to the mean of all, if the gauge was not touched."""
    clouds: tuple[str, ...]
    calibrations: tuple[str, ...]
    """Names, in the order of the ids."""
    calibration_ids: tuple[str, ...]
    rows: tuple[StudyRow, ...]
    between_clouds: tuple[StudyRange, ...] = ()
    """The ranges of each calibration (Figs. 9-10). 9-10)."""
    between_calibrations: tuple[StudyRange, ...] = ()
    """The ranges of each cloud."""
    left_out: Annotated[tuple[Text, ...], Field(default_factory=tuple)]
    """Calibrations that do not belong to these recordings, one sentence each."""


def study_verification(
    folder: Path, sources: Sequence[AcceptedCalibration], progress: Progress = no_progress
) -> StudyFile:
    """Rebuilds every cloud of a verification with every calibration.

    Raises:
        OperationError: the verification cannot be read, or none of the calibrations belongs to it.
    """
    record, gauge = read_verification(folder), read_gauge(folder / GAUGE)
    fits: list[list[GaugeFit]] = []
    used: list[tuple[AcceptedCalibration, AnyArm]] = []
    left_out: list[Text] = []
    total = max(len(sources) * len(record.clouds), 1)
    for c, source in enumerate(sources):
        try:
            arm = read_any_arm(source.folder / ARM)
            calibration = read_calibration(source.folder / STUDY_CALIBRATION)
            row = []
            for r, cloud in enumerate(record.clouds):
                progress((c * len(record.clouds) + r) / total, f"{cloud.name}, {source.name}")
                row.append(measure_recording(folder / cloud.recording, calibration, arm, gauge).fit)
        except OperationError as refusal:
            reason = _without_folders(refusal, folder, source.folder)
            left_out.append(message("study-left-out", name=source.name, reason=reason))
            continue
        used.append((source, arm))
        fits.append(row)
    if not used:
        raise OperationError(
            "no-calibration-fits",
            message("none-calibrations-belongs-these-recordings"),
            join(left_out, " "),
        )
    touched = [_fit_contacts(folder, arm, gauge) for _, arm in used]
    probe = all(one is not None for one in touched)
    references = touched if probe else [_mean_gauge(fits, gauge)] * len(used)
    rows = tuple(
        _row(r, c, fit, gauge, references[c])
        for c, row in enumerate(fits)
        for r, fit in enumerate(row)
    )
    count = len(record.clouds)
    return StudyFile(
        shape=gauge.shape,
        against_probe=probe,
        clouds=tuple(cloud.name for cloud in record.clouds),
        calibrations=tuple(source.name for source, _ in used),
        calibration_ids=tuple(source.id for source, _ in used),
        rows=rows,
        between_clouds=_ranges(rows, "calibration", len(used)) if count > 1 else (),
        between_calibrations=_ranges(rows, "cloud", count) if len(used) > 1 else (),
        left_out=tuple(left_out),
    )


def _without_folders(refusal: OperationError, *folders: Path) -> Text:
    """What was refused and why, with file names as they are within these folders."""
    text = join([refusal.what, refusal.why], ": ") if refusal.why else refusal.what
    for folder in folders:
        text = replace_name(text, f"{display_path(folder)}/", "")
    return text


def _fit_contacts(folder: Path, arm: AnyArm, gauge: GaugeFile) -> ProbedGauge | None:
    """With this arm, which may be known better than at the time of probing."""
    if not (folder / CONTACTS).is_file():
        return None
    readings = read_contacts(folder / CONTACTS, arm, ("gauge",)).arm_readings
    if gauge.radius_mm is None:
        found: ProbedGauge = fit_probed_plane(arm, readings)
    else:
        found = fit_probed_sphere(arm, readings, gauge.radius_mm)
    refuse_doubt(found.doubtful)
    return found


def _mean_gauge(fits: Sequence[Sequence[GaugeFit]], gauge: GaugeFile) -> ProbedGauge:
    """The mean of the clouds, in place of the contact points."""
    every = [fit for row in fits for fit in row]
    centre = np.mean([fit.centre_mm for fit in every], axis=0)
    nothing = np.zeros(0)
    if gauge.radius_mm is not None:
        nominal = NominalSphere(centre, gauge.radius_mm)
        return ProbedSphere(nominal, nothing, np.zeros((3, 3)), gauge.radius_mm, 0.0, nothing > 0)
    normals = np.array([fit.plane.normal for fit in every])
    normals *= np.sign(normals @ normals[0])[:, None]
    normal = normals.mean(axis=0)
    normal /= np.linalg.norm(normal)
    return ProbedPlane(NominalPlane(centre, normal), nothing, np.zeros((3, 3)), nothing > 0)


def _row(
    cloud: int, calibration: int, fit: GaugeFit, gauge: GaugeFile, touched: ProbedGauge | None
) -> StudyRow:
    errors = cloud_errors(fit, gauge, touched)
    is_steep = errors.z_error_um is None
    z = errors.offset_error_um if is_steep else errors.z_error_um
    widths_mm = (fit.width_mm,) if fit.width_mm else ()
    test = gauge_test_uncertainty(gauge, widths_mm, steepness_of(touched))
    budgets = cloud_budgets(fit, test, touched)
    names: dict[str, FigureName] = {**FIGURES, "z_error_um": "offset" if is_steep else "z_error"}
    return StudyRow(
        cloud=cloud,
        calibration=calibration,
        rms_um=fit.rms_um,
        angle_arcsec=errors.angle_arcsec,
        z_error_um=z,
        radius_error_um=errors.radius_error_um,
        centre_error_um=errors.centre_error_um,
        expanded_uncertainty={
            field: combine_budget(budgets[name]) for field, name in names.items() if name in budgets
        },
    )


def _ranges(rows: Sequence[StudyRow], of: str, count: int) -> tuple[StudyRange, ...]:
    found = []
    for index in range(count):
        some = [row for row in rows if getattr(row, of) == index]
        first = [
            (r.angle_arcsec if r.angle_arcsec is not None else r.radius_error_um) or 0.0
            for r in some
        ]
        second = [
            (r.z_error_um if r.z_error_um is not None else r.centre_error_um) or 0.0 for r in some
        ]
        found.append(
            StudyRange(of=index, first=max(first) - min(first), second=max(second) - min(second))
        )
    return tuple(found)
