"""Lengths of ball bars by scan, on recordings of synthetic bars."""

from collections.abc import Mapping, Sequence
from itertools import product
from pathlib import Path
from unittest.mock import patch

import numpy as np
import pytest

from crenel.errors import OperationError
from crenel.formats.datasheets.arm import read_any_arm
from crenel.formats.session.calibration_session import contact_readings, write_contacts
from crenel.gauges.exchange.result_tables import result_tables
from crenel.gauges.judgement.document import PerformanceFile, read_performance
from crenel.gauges.kinds import evaluate_performance
from crenel.gauges.plan.document import (
    PLAN,
    TOUCHES,
    LimitPart,
    PerformancePlan,
    length_feature,
    length_scan,
    read_plan,
)
from crenel.gauges.plan.document_length_standard import LengthStandardFile
from crenel.metrology.arm.reported_poses import pose_from_transform
from crenel.metrology.transforms import rigid
from crenel.report.contents.reports import render_report
from tests.bench.metrology import synthetic_bar
from tests.bench.metrology.synthetic_arm import TIP, PoseArm
from tests.bench.metrology.synthetic_bar import NO_FAULTS, write_bar_scan
from tests.bench.metrology.synthetic_sphere import CENTRE, Faults, write_calibration
from tests.cli.test_cli import crenel
from tests.gauges.contact.test_contacts import figures_of
from tests.present import present
from tests.report.test_reports import text_of

pytestmark = pytest.mark.slow

DIAMETER_MM = 20.0
ALONG = np.array([0.8, 0.5, np.sqrt(1 - 0.89)])
LIMITS = (LimitPart(quantity="length-scan", a_um=30.0, k=10.0, b_um=60.0),)


def bar(*lengths_mm: float, **fields: object) -> LengthStandardFile:
    return LengthStandardFile.model_validate(
        {
            "name": "Ball bar",
            "serial_number": "BB-1",
            "sphere_diameter_mm": DIAMETER_MM,
            "lengths": [{"length_mm": mm, "standard_uncertainty_um": 0.5} for mm in lengths_mm],
            **fields,
        }
    )


def spheres_at(*places_mm: float) -> list[np.ndarray]:
    """Centres along the bar."""
    return [CENTRE + (place - places_mm[-1] / 2) * ALONG for place in places_mm]


def bar_test(
    folder: Path,
    standard: LengthStandardFile,
    scans: Mapping[str, Sequence[np.ndarray]],
    faults: Faults = NO_FAULTS,
) -> Path:
    """The folder of a test in which the bar is scanned alone."""
    folder.mkdir()
    PerformancePlan(
        id="t",
        kind="lengths",
        started_at="2026-11-26T10:00:00+00:00",
        length=standard,
        limits=LIMITS,
    ).write(folder / PLAN)
    PoseArm().write(folder / "arm.json")
    write_calibration(folder / "calibration.json")
    for number, (name, centres) in enumerate(scans.items()):
        write_bar_scan(folder / name, centres, DIAMETER_MM, faults=faults, seed=number)
    return folder


def errors_um(result: PerformanceFile) -> dict[float, float]:
    return {one.length_mm: one.error_um for one in result.lengths}


def test_the_lengths_of_a_scanned_bar_are_the_distances_of_its_spheres(tmp_path: Path) -> None:
    # 60 µm longer than it is calibrated
    scans = {length_scan(1, 1): spheres_at(0.0, 40.06, 100.06)}
    folder = bar_test(tmp_path / "t", bar(40.0, 60.0, 100.0), scans)
    result = evaluate_performance(folder)
    assert errors_um(result) == pytest.approx({40.0: 60.0, 60.0: 0.0, 100.0: 60.0}, abs=0.2)
    assert {one.by for one in result.lengths} == {"scan"}
    (figure,) = result.figures
    assert figure.symbol == "E_Uni:ODS.AArm"
    assert (figure.value, figure.decision, figure.data) == (None, "none", ("l1-1",))
    assert "only 3 of 63 lengths were measured" in str(figure.problem)
    assert any("30° from the direction of the bar" in str(note) for note in result.notes)
    assert f"{length_scan(1, 1)}/scan.mcap" in {one.file for one in result.inputs}


def test_noise_scatters_lengths_form_and_temperature_are_their_uncertainty(tmp_path: Path) -> None:
    standard = bar(80.0, sphere_form_um=1.0, expansion_per_c=11.5e-6)
    all_scans = list(product(range(1, 8), range(1, 4)))
    scans = {length_scan(*one): spheres_at(0.0, 80.0) for one in all_scans}
    noisy = Faults(point_sd_mm=0.02, matrix_offset_mm=(0.05, -0.03, 0.02))
    with patch.object(synthetic_bar, "STEP_MM", 2.0):  # a quarter of the usual profiles
        folder = bar_test(tmp_path / "t", standard, scans, noisy)
    assert "E_Uni:ODS.AArm" in crenel("performance", "evaluate", folder).stdout
    result = read_performance(folder)
    assert [(one.place, one.repeat) for one in result.lengths] == all_scans
    # the probe matrix shifts both spheres, seen from the same side, by the same
    assert all(abs(one.error_um) < 4 for one in result.lengths)
    (figure,) = result.figures
    assert abs(present(figure.value)) < 4
    assert (figure.limit, figure.decision) == (38.0, "uncertain")
    assert "the standard has only one length" in str(figure.reason)
    assert result.lengths[0].test_uncertainty_um > 2 * 0.5
    table = next(one for one in result_tables(result) if one.name == "lengths")
    assert [row[0] for row in table.rows] == 21 * ["scan"]
    text = text_of(render_report(folder, ".pdf"))
    assert "21 errors of length by scan over the length" in text


@pytest.mark.parametrize("loose", [True, False])
def test_a_bar_that_gives_way_everywhere_differs_from_scans(tmp_path: Path, loose: bool) -> None:
    centres = spheres_at(0.0, 80.0)
    noisy = Faults(point_sd_mm=0.01)
    folder = bar_test(tmp_path / "t", bar(80.0), {length_scan(1, 1): centres}, noisy)
    random = np.random.default_rng(7)
    around = np.array([[0.0, 0, 1], [1, 0, 0], [0, 1, 0], [-0.6, -0.6, 0.53]])
    reach_mm = (DIAMETER_MM + TIP.diameter_mm) / 2
    features, readings = [], []
    for place, repeat, end in product(range(1, 8), range(1, 4), (0, 1)):
        tips = centres[end] + reach_mm * around / np.linalg.norm(around, axis=1)[:, None]
        tips += (0.2 if loose else 0.004) * random.normal(size=tips.shape)
        features += [length_feature(place, repeat, 1, end)] * len(tips)
        flanges = tips - [TIP.x_mm, TIP.y_mm, TIP.z_mm]
        readings += [pose_from_transform(rigid(np.eye(3), one)) for one in flanges]
    arm = read_any_arm(folder / "arm.json")
    write_contacts(folder / TOUCHES, contact_readings(features, arm, np.array(readings)))
    rocks = [one for one in evaluate_performance(folder).problems if "rocks in place" in str(one)]
    assert len(rocks) == (7 if loose else 0)


def test_a_length_that_a_scan_shows_twice_is_scanned_by_itself(tmp_path: Path) -> None:
    scans = {length_scan(1, 1): spheres_at(0.0, 40.0, 80.0)}
    folder = bar_test(tmp_path / "t", bar(40.0, 80.0), scans)
    twice = evaluate_performance(folder)
    assert twice.figures[0].value is None
    assert "more than one pair" in str(twice.figures[0].problem)
    assert errors_um(twice) == pytest.approx({80.0: 0.0}, abs=0.2)
    alone = folder / length_scan(1, 1, 1)
    write_bar_scan(alone, spheres_at(0.0, 40.05, 80.0)[:2], DIAMETER_MM)
    result = evaluate_performance(folder)
    assert errors_um(result) == pytest.approx({40.0: 50.0, 80.0: 0.0}, abs=0.2)
    assert "only 2 of 42 lengths" in str(result.figures[0].problem)


@pytest.mark.parametrize(
    ("standard", "centres", "said"),
    [
        (bar(70.0), spheres_at(0.0, 40.0), "no two are 70 mm apart"),
        (bar(70.0), spheres_at(0.0), "one sphere instead of two"),
        (bar(40.0, sphere_diameter_mm=None), spheres_at(0.0, 40.0), "only the spheres of a ball"),
    ],
    ids=["another length", "one sphere", "no spheres"],
)
def test_scans_that_do_not_show_a_length_are_named(
    tmp_path: Path, standard: LengthStandardFile, centres: list[np.ndarray], said: str
) -> None:
    folder = bar_test(tmp_path / "t", standard, {length_scan(1, 1): centres})
    (figure,) = evaluate_performance(folder).figures
    assert figure.value is None
    assert said in str(figure.problem)


def test_a_plan_with_scans_has_no_figure_by_scan_without_them(tmp_path: Path) -> None:
    folder = bar_test(tmp_path / "t", bar(40.0), {})
    read_plan(folder).model_copy(update={"by_scan": True}).write(folder / PLAN)
    by_scan = figures_of(evaluate_performance(folder))["length-scan"]
    assert by_scan.value is None
    assert "no length was measured" in str(by_scan.problem)


def test_a_scan_without_a_calibration_is_refused(tmp_path: Path) -> None:
    folder = bar_test(tmp_path / "t", bar(40.0), {length_scan(1, 1): spheres_at(0.0, 40.0)})
    (folder / "calibration.json").unlink()
    with pytest.raises(OperationError, match=r"calibration\.json is missing"):
        evaluate_performance(folder)
