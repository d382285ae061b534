"""Performance tests: what noise makes of the figures, and whether planted faults show as stated."""

import tempfile
from collections.abc import Sequence
from dataclasses import dataclass, replace
from pathlib import Path

import numpy as np
from scipy.spatial.transform import Rotation

from crenel.gauges.judgement.document import PerformanceFile
from crenel.gauges.kinds import evaluate_performance
from crenel.gauges.plan.document_symbols import Quantity
from crenel.gauges.sphere.maths_location import estimate_offset, smallest_enclosing_sphere
from crenel.gauges.sphere.maths_pattern import pattern_directions
from crenel.metrology.fitting.reference_sphere import dispersion_mm, least_squares_sphere
from crenel.metrology.transforms import Floats
from crenel.progress import Progress, no_progress
from tests.bench.metrology.claimed_plane_and_contact import plane_and_contact_rows
from tests.bench.metrology.claimed_uncertainty import coverage_rows
from tests.bench.metrology.synthetic_sphere import Faults, SphereSession

COLUMNS = ("figure", "expected", "found", "found / expected")
POLE = np.array([0.0, 0.0, 1.0])
NOISE = Faults(touch_sd_mm=0.003, point_sd_mm=0.008)
OFFSET_MM = 0.05
TILT_DEG = 60.0
CENTRE_SD_MM = 0.005


@dataclass(frozen=True)
class PerformanceRow:
    """One figure beside what it should be, in µm unless its name says otherwise."""

    figure: str
    expected: float
    found: float


def run(draws: int, tests: int = 0, progress: Progress = no_progress) -> list[PerformanceRow]:
    """Every row.

    Args:
        draws: of white noise.
        tests: simulated ones, for the uncertainty of every figure.
    """
    rows = noise_rows(draws)
    progress(0.5, "planted faults")
    with tempfile.TemporaryDirectory() as folder:
        rows += fault_rows(Path(folder))
    progress(0.9, "stated against true")
    rows += uncertainty_rows(min(draws, 1000))
    claimed = [*coverage_rows(tests), *plane_and_contact_rows(tests)] if tests else []
    return [
        *rows,
        *(PerformanceRow(f"{one.figure}, stated / observed", 1.0, one.ratio) for one in claimed),
    ]


def table(rows: Sequence[PerformanceRow]) -> list[tuple[str, str, str, str]]:
    """For the console."""
    return [
        (
            row.figure,
            f"{row.expected:.3f}",
            f"{row.found:.3f}",
            f"{row.found / row.expected:.3f}" if row.expected else "–",
        )
        for row in rows
    ]


def noise_rows(draws: int) -> list[PerformanceRow]:
    """White radial noise of 1 µm: expectations of order statistics and of the fit."""
    random = np.random.default_rng(1)
    directions = pattern_directions(POLE)
    J = np.column_stack([directions, np.ones(25)])
    left = np.eye(25) - J @ np.linalg.inv(J.T @ J) @ J.T
    known = np.ptp(random.normal(size=(draws, 25)), axis=1).mean()
    linear = np.ptp(random.normal(size=(draws, 25)) @ left, axis=1).mean()
    forms, centres = [], []
    for _ in range(draws):
        found = least_squares_sphere(directions * (12.5 + 1e-3 * random.normal(size=(25, 1))))
        forms.append(1e3 * found.form_mm)
        centres.append(1e3 * found.centre_mm)
    sd = np.std(centres, axis=0)
    wide = [dispersion_mm(random.normal(size=20_000)) for _ in range(max(draws // 50, 20))]
    enclosing = [
        smallest_enclosing_sphere(random.normal(size=(5, 3))).diameter_mm for _ in range(draws)
    ]
    cofactor = np.sqrt(np.diag(np.linalg.inv(J.T @ J)))
    return [
        PerformanceRow("range of 25 points about a known centre", 3.931, float(known)),
        PerformanceRow(
            "form of 25 points about the fitted centre", float(linear), float(np.mean(forms))
        ),
        PerformanceRow("dispersion D95 of 20 000 points", 3.915, float(np.mean(wide))),
        PerformanceRow("sphere about five centres, mean", 3.65, float(np.mean(enclosing))),
        PerformanceRow("centre, across the pole", float(cofactor[0]), float(sd[0])),
        PerformanceRow("centre, along the pole", float(cofactor[2]), float(sd[2])),
    ]


def fault_rows(folder: Path) -> list[PerformanceRow]:
    """One-sphere tests with one fault each."""

    def figures(name: str, faults: Faults) -> PerformanceFile:
        return evaluate_performance(SphereSession(folder / name, faults).write())

    rows = []
    for axis, letter in enumerate("xyz"):
        offset = OFFSET_MM * np.eye(3)[axis]
        wrong = replace(NOISE, matrix_offset_mm=(offset[0], offset[1], offset[2]))
        found = figures(f"matrix-{letter}", wrong)
        assert found.offset is not None
        size_um = 1e3 * float(np.linalg.norm(found.offset.offset_mm))
        rows.append(PerformanceRow(f"probe matrix off along {letter}, implied", 50.0, size_um))
    worn = figures("tip", replace(NOISE, tip_excess_mm=-0.02))
    rows.append(
        PerformanceRow("tip worn by 20 µm, P_Size by touch", -20.0, _of(worn, "size-touch"))
    )
    moved = figures("moved", replace(NOISE, moved_mm=(0.1, 0.0, 0.0)))
    assert moved.spheres[0].moved_um is not None
    rows.append(PerformanceRow("sphere moved by 100 µm", 100.0, moved.spheres[0].moved_um))
    clean, spoilt = figures("clean", NOISE), figures("outliers", replace(NOISE, outliers=0.04))
    growth = _of(spoilt, "form-scan") - _of(clean, "form-scan")
    rows.append(PerformanceRow("4 % outliers, growth of P_Form by scan", 0.0, growth))
    return rows


def _of(result: PerformanceFile, quantity: Quantity) -> float:
    value = next(one.value for one in result.figures if one.quantity == quantity)
    assert value is not None, quantity
    return value


def uncertainty_rows(draws: int) -> list[PerformanceRow]:
    """Stated standard uncertainties over the scatter that is observed: 1 is right."""
    random = np.random.default_rng(2)
    R = _articulations()
    offsets = [estimate_offset(CENTRE_SD_MM * random.normal(size=(5, 3)), R) for _ in range(draws)]
    observed = np.array([one.offset_mm for one in offsets]).std(axis=0)
    stated = np.sqrt(np.mean([np.diag(one.covariance) for one in offsets], axis=0))
    return [
        PerformanceRow(f"implied offset along {axis}, stated / observed", 1.0, float(ratio))
        for axis, ratio in zip("xyz", stated / observed, strict=True)
    ]


def _articulations() -> Floats:
    tilts = (("y", 0.0), ("y", TILT_DEG), ("y", -TILT_DEG), ("x", TILT_DEG), ("x", -TILT_DEG))
    turns = [Rotation.from_euler(axis, tilt, degrees=True).as_matrix() for axis, tilt in tilts]
    return np.array(turns)
