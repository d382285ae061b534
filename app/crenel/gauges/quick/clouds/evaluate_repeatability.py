"""The article's study: clouds of one plane, each reconstructed with each of several calibrations.

Errors of a calibration appear as a plane that turns and shifts from one calibration to the next;
errors of the arm and the scanning, from one cloud to the next.
"""

from collections.abc import Sequence
from dataclasses import dataclass
from pathlib import Path

import numpy as np

from crenel.errors import OperationError
from crenel.formats.atomic_write import write_atomically
from crenel.formats.csv_table import table_text
from crenel.formats.io_errors import prefix_errors
from crenel.formats.results.calibration import Calibration
from crenel.gauges.quick.clouds.document_nominal import read_nominal
from crenel.gauges.quick.maths.errors import (
    ARCSEC_PER_RAD,
    NominalPlane,
    angle_between_rad,
    angle_ranges_arcsec,
    offset_ranges_um,
)
from crenel.messages.message import Text, message, quantity
from crenel.metrology.arm.kinematics import AnyArm
from crenel.metrology.fitting.plane_sphere import PlaneFit, fit_plane
from crenel.metrology.transforms import Floats
from crenel.progress import Progress, no_progress
from crenel.workflows.reconstruct import reconstruct_points

ARTICLE_ARCSEC, ARTICLE_UM = 230.0, 100.0
"""Mean ranges between calibrations in the article, section 4."""
ARTICLE_CLOUDS_ARCSEC, ARTICLE_CLOUDS_UM = 500.0, 110.0
"""Its ranges between clouds of one calibration."""
ONE_PLANE_RAD = np.deg2rad(2.0)
COLUMNS = ("recording", "calibration", "points", "rms_um", "angle_arcsec", "offset_um")


@dataclass(frozen=True)
class StudyPlane:
    """One recording reconstructed with one calibration."""

    recording: str
    calibration: str
    points: int
    rms_um: float
    angle_arcsec: float
    """Between its plane and the nominal, or, if there is none, the mean of all planes."""
    offset_um: float
    """Distance of its plane from that one, along its normal, in the middle of all clouds."""


@dataclass(frozen=True)
class PlaneSpread:
    """The range of the planes of one recording, or of one calibration."""

    of: str
    angle_arcsec: float
    offset_um: float


@dataclass(frozen=True)
class Study:
    """All planes, and their scatter."""

    rows: tuple[StudyPlane, ...]
    between_calibrations: tuple[PlaneSpread, ...]
    """The spread of each recording; empty for one calibration."""
    between_recordings: tuple[PlaneSpread, ...]
    """The spread of each calibration; empty for one recording."""
    warnings: tuple[Text, ...]

    def write_csv(self, path: Path) -> None:
        """The table, with one row per recording and calibration; raises ``OperationError``."""
        rows: list[Sequence[str | float | int]] = [
            (
                row.recording,
                row.calibration,
                row.points,
                *(f"{x:.3f}" for x in (row.rms_um, row.angle_arcsec, row.offset_um)),
            )
            for row in self.rows
        ]
        write_atomically(path, table_text(COLUMNS, rows).encode())


def run_study(
    recordings: Sequence[Path],
    calibrations: Sequence[tuple[Path, Calibration]],
    arm: AnyArm,
    nominal_path: Path | None = None,
    progress: Progress = no_progress,
) -> Study:
    """Reconstructs every recording with every calibration and fits a plane to each cloud.

    Raises:
        OperationError: as ``rebuild``; a cloud determines no plane; the nominal is not a plane;
            there
            is only one cloud.
    """
    if len(recordings) * len(calibrations) < 2:
        raise OperationError(
            "too-few-clouds",
            message("one-recording-one-calibration-give-one"),
            message("study-compares-several"),
            message("give-more-recordings-plane-more-calibrations"),
        )
    nominal = None if nominal_path is None else _read_plane(nominal_path)
    fits: list[list[PlaneFit]] = []
    warnings: list[Text] = []
    total = len(recordings) * len(calibrations)
    for c, (name, calibration) in enumerate(calibrations):
        fits.append([])
        for r, path in enumerate(recordings):
            begun = (c * len(recordings) + r) / total
            progress(begun, f"{path.name} × {name.name}")
            points_mm, rebuilt = reconstruct_points(path, calibration, arm)
            if not c:
                warnings += rebuilt.warnings
            with prefix_errors(path):
                fits[-1].append(fit_plane(points_mm))
    return _compare_planes(recordings, [name for name, _ in calibrations], fits, nominal, warnings)


def _read_plane(path: Path) -> NominalPlane:
    nominal = read_nominal(path)
    if not isinstance(nominal, NominalPlane):
        raise OperationError(
            "nominal-of-another-shape",
            message("file-describes-sphere", path=path),
            message("study-plane"),
            message("give-planes-own-nominal"),
        )
    return nominal


def _compare_planes(
    recordings: Sequence[Path],
    calibrations: Sequence[Path],
    fits: list[list[PlaneFit]],
    nominal: NominalPlane | None,
    warnings: list[Text],
) -> Study:
    normals = np.array([[fit.normal for fit in row] for row in fits])  # (C, R, 3)
    first = normals[0, 0] if nominal is None else nominal.normal
    normals *= np.sign(normals @ first)[..., None]
    centres = np.array([[fit.centre_mm for fit in row] for row in fits])
    middle, mean = centres.mean(axis=(0, 1)), normals.mean(axis=(0, 1))
    normal: Floats = mean / np.linalg.norm(mean) if nominal is None else nominal.normal
    # height of each plane at the middle, along the normal
    heights = np.einsum("crk,crk->cr", normals, centres - middle) / (normals @ normal)
    zero = float(heights.mean()) if nominal is None else nominal.offset_mm - normal @ middle
    turned = max(angle_between_rad(n, normals[0, 0]) for n in normals[0])
    if turned > ONE_PLANE_RAD:
        warnings.append(
            message("recordings-not-of-one-plane", angle=quantity(np.rad2deg(turned), "°", 1))
        )
    rows = [
        StudyPlane(
            str(recording),
            str(calibration),
            int(fits[c][r].used.sum()),
            fits[c][r].rms_mm * 1e3,
            angle_between_rad(normals[c, r], normal) * ARCSEC_PER_RAD,
            float(heights[c, r] - zero) * 1e3,
        )
        for r, recording in enumerate(recordings)
        for c, calibration in enumerate(calibrations)
    ]
    across = normals.swapaxes(0, 1)
    return Study(
        tuple(rows),
        _ranges(recordings, normals, heights) if len(calibrations) > 1 else (),
        _ranges(calibrations, across, heights.T) if len(recordings) > 1 else (),
        tuple(warnings),
    )


def _ranges(names: Sequence[Path], normals: Floats, heights: Floats) -> tuple[PlaneSpread, ...]:
    """Over the first axis, for each element of the second."""
    angles, offsets = angle_ranges_arcsec(normals), offset_ranges_um(heights)
    return tuple(
        PlaneSpread(str(name), float(angle), float(offset))
        for name, angle, offset in zip(names, angles, offsets, strict=True)
    )


def range_rows(done: Study) -> list[tuple[str, ...]]:
    """The mean ranges for printing, in English, next to those of the article."""
    rows: list[tuple[str, ...]] = []
    for title, ranges, arcsec, um in (
        ("between calibrations", done.between_calibrations, ARTICLE_ARCSEC, ARTICLE_UM),
        ("between clouds", done.between_recordings, ARTICLE_CLOUDS_ARCSEC, ARTICLE_CLOUDS_UM),
    ):
        if ranges:
            angle = np.array([one.angle_arcsec for one in ranges])
            offset = np.array([one.offset_um for one in ranges])
            rows.append(
                (
                    title,
                    f"{angle.mean():.1f}″",
                    f"{angle.max():.1f}″",
                    f"{offset.mean():.1f} µm",
                    f"{offset.max():.1f} µm",
                    f"{arcsec:.0f}″, {um:.0f} µm",
                )
            )
    return rows
