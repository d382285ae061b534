"""Which points of a scan are the plate's: none is left out because it lies off the plane."""

from pathlib import Path

import numpy as np
import pytest

from crenel.formats.datasheets.arm import ArmFile
from crenel.gauges.judgement.evaluate_measured_data import ScanCloud
from crenel.gauges.kinds import evaluate_performance
from crenel.gauges.plan.document import PLAN, PerformancePlan, PlatePart, plane_scan
from crenel.gauges.plan.evaluate_artefacts import list_problems
from crenel.gauges.plane.evaluate import find_on_plate, measure_plate_scan
from crenel.gauges.plane.guide import measure_plate
from crenel.gauges.plane.maths import least_squares_plane
from crenel.metrology.transforms import Floats, rotation_from_vector
from tests.bench.metrology.synthetic_arm import TIP
from tests.refusals import refused_as

PLATE = PlatePart(name="Granite", flatness_um=3.0, flatness_sd_um=0.5)
SHELL_MM = 10.0
SIDE_MM = 100.0


def plate(count: int, noise_mm: float, seed: int = 0) -> Floats:
    """(N, 3) points of a tilted square plate."""
    random = np.random.default_rng(seed)
    flat = np.column_stack(
        [random.uniform(0, SIDE_MM, (count, 2)), noise_mm * random.normal(size=count)]
    )
    return tilt(flat)


def tilt(points: Floats) -> Floats:
    turn = np.radians(30.0)
    R = np.array([[1, 0, 0], [0, np.cos(turn), -np.sin(turn)], [0, np.sin(turn), np.cos(turn)]])
    return np.asarray(points @ R.T + np.array([400.0, -50.0, 120.0]))


def test_outliers_over_the_plate_count() -> None:
    points = plate(20_000, 0.01)
    normal = tilt(np.array([[0.0, 0, 1]])) - tilt(np.zeros((1, 3)))
    off = np.zeros(len(points))
    off[::10] = np.where(np.arange(len(off[::10])) % 2, 8.0, -8.0)
    spoilt = points + off[:, None] * normal
    kept = find_on_plate(spoilt, SHELL_MM)
    assert kept[off != 0].mean() > 0.93
    assert least_squares_plane(spoilt[kept]).dispersion_mm > 7.0


def test_the_table_beside_the_plate_does_not_count() -> None:
    random = np.random.default_rng(2)
    beside = random.uniform(-60, SIDE_MM + 60, (30_000, 2))
    beside = beside[((beside < -1) | (beside > SIDE_MM + 1)).any(axis=1)]
    table = tilt(np.column_stack([beside, np.full(len(beside), -8.0)]))
    points = np.concatenate([plate(60_000, 0.01), table])
    kept = find_on_plate(points, SHELL_MM)
    assert not kept[60_000:].any()
    assert kept[:60_000].mean() > 0.9
    assert least_squares_plane(points[kept]).dispersion_mm == pytest.approx(0.0392, rel=0.05)


def test_what_is_higher_than_the_shell_is_not_the_plate() -> None:
    clamp = tilt(np.column_stack([np.full((500, 2), 50.0), np.linspace(11.0, 30.0, 500)]))
    kept = find_on_plate(np.concatenate([plate(5000, 0.01), clamp]), SHELL_MM)
    assert not kept[5000:].any()


def scanned(points: Floats, turn_deg: float = 0.0) -> ScanCloud:
    turn = rotation_from_vector(np.array([0.0, 0.0, np.radians(turn_deg)]))
    frame = np.zeros(len(points), dtype=np.int64)
    return ScanCloud(points, frame, np.tile([0.0, 0.0, 1.0], (len(points), 1)), turn)


def test_a_scan_that_shows_too_little_of_the_plate_is_refused() -> None:
    points = plate(20_000, 0.01)
    strip = points[points[:, 0] < 440.0]
    for shown, text in ((points[:900], "only 900 points"), (strip, "only 38 mm wide")):
        with refused_as("cloud-too-small", text):
            measure_plate_scan(scanned(shown), SHELL_MM)


def test_the_sensor_is_turned_between_the_orientations() -> None:
    points = plate(20_000, 0.01)
    first = measure_plate(scanned(points), SHELL_MM, None)
    assert first["turn_deg"] is None
    assert first["dispersion_um"] == pytest.approx(39.2, rel=0.05)
    other = scanned(points).R_arm_sensor
    second = measure_plate(scanned(points, 90.0), SHELL_MM, other)
    assert second["turn_deg"] == pytest.approx(90.0)
    with refused_as("orientations-alike"):
        measure_plate(scanned(points, 12.0), SHELL_MM, other)


@pytest.mark.parametrize(("flatness_sd_um", "can_serve"), [(0.5, True), (0.0, False)])
def test_a_plate_without_uncertainty_cannot_serve(flatness_sd_um: float, can_serve: bool) -> None:
    part = PLATE.model_copy(update={"flatness_sd_um": flatness_sd_um})
    problems = [str(one) for one in list_problems(part, "2026-11-27", "")]
    said = ["the certificate of the artefact states no uncertainty"]
    assert problems == ([] if can_serve else said)


def test_nothing_is_stated_of_a_plate_that_was_scanned_once(tmp_path: Path) -> None:
    begun = "2026-11-26T10:00:00+00:00"
    PerformancePlan(id="t", kind="plane", started_at=begun, plate=PLATE).write(tmp_path / PLAN)
    arm = ArmFile(name="Arm", serial_number="A-1", convention="pose", tip=TIP)
    arm.write(tmp_path / "arm.json")
    (tmp_path / plane_scan(1)).mkdir()
    (tmp_path / plane_scan(1) / "scan.mcap").touch()
    (figure,) = evaluate_performance(tmp_path).figures
    assert figure.value is None
    assert "not scanned in 2 orientations" in str(figure.problem)
