"""Elements picked in scans: figures with their uncertainty, proposals, dimensions between them."""

import json
from pathlib import Path

import numpy as np
import pytest

from crenel.parts.elements.evaluate_element import join_elements, why_only_scatter
from crenel.parts.elements.maths_figures import element_figures
from crenel.parts.elements.maths_relations import relation_figures
from crenel.parts.maths.shapes import Kind
from tests.parts.draws import first_setting
from tests.parts.element_draws import bracket_picks, measure_draw, pulls_of
from tests.parts.picks import Pick, ScannedPart, scan_bracket
from tests.present import present

pytestmark = pytest.mark.slow

DRAWS = 6
LIKELY: list[tuple[Pick, Kind]] = [
    (Pick(None, (15, 15, 15), (14, 14)), "cylinder"),
    (Pick(None, (100, 58, 36), (18, 18)), "sphere"),
    (Pick(None, (70, 9, 25), (30, 8)), "plane"),
    (Pick(None, (30, 40, 17), (15, 15)), "cone"),
]


@pytest.fixture(scope="module")
def part(tmp_path_factory: pytest.TempPathFactory) -> ScannedPart:
    return scan_bracket(tmp_path_factory.mktemp("scan"), first_setting(), 3)


def test_what_is_claimed_holds_over_many_stations() -> None:
    """Pooled over all figures; few draws share their errors, so that the bounds are wide."""
    draws = [measure_draw(first_setting(), 200 + seed) for seed in range(DRAWS)]
    ratios = np.array([ratio for _, ratio, _, _ in pulls_of(draws)])
    pooled = 1 / np.sqrt(np.mean(1 / ratios**2))
    assert 0.65 < pooled < 1.6
    assert ratios.min() > 0.35
    bores = [draw["bore1"][1] for draw in draws]
    assert all(0.004 < one.standard_uncertainty < 0.03 for one in bores)


def test_the_likeliest_shape_is_proposed(part: ScannedPart) -> None:
    for pick, kind in LIKELY:
        assert part.measure(pick).shape.kind == kind


def test_a_step_is_known_better_than_its_planes(part: ScannedPart) -> None:
    """Errors that both planes share cancel in their distance."""
    picks = bracket_picks(first_setting().nominal)
    step, top = part.measure(picks["step"]), part.measure(picks["top"])
    distance, angle = relation_figures(present(join_elements([step, top])))
    assert (distance.name, angle.name) == ("planes-distance", "planes-angle")
    plane = element_figures(present(step.knowledge))[0]
    assert distance.standard_uncertainty < plane.standard_uncertainty / 4
    shares = np.array([share for _, share in distance.shares])
    assert np.sum(shares**2) == pytest.approx(distance.standard_uncertainty**2)


def test_without_readings_or_covariance_there_is_scatter_with_its_reason(
    part: ScannedPart, tmp_path: Path
) -> None:
    pick = bracket_picks(first_setting().nominal)["ball"]
    whole = part.measure(pick)
    assert whole.why_scatter == ""
    document = json.loads((part.folder / "calibration.json").read_text())
    readings = part.folder / "readings.ply"
    kept = readings.read_bytes(), json.dumps(document)
    try:
        del document["covariance"]
        (part.folder / "calibration.json").write_text(json.dumps(document))
        assert "no covariance" in str(part.measure(pick).why_scatter)
        document = json.loads(kept[1])
        document["laser_plane"]["offset_mm"] += 0.01
        (part.folder / "calibration.json").write_text(json.dumps(document))
        assert "not made with the calibration" in str(part.measure(pick).why_scatter)
        (part.folder / "calibration.json").write_text(kept[1])
        readings.unlink()
        bare = part.measure(pick)
        assert "no readings of the arm" in str(bare.why_scatter)
    finally:
        readings.write_bytes(kept[0])
        (part.folder / "calibration.json").write_text(kept[1])
    by_scatter, full = (element_figures(present(one.knowledge))[0] for one in (bare, whole))
    assert by_scatter.standard_uncertainty < full.standard_uncertainty
    assert by_scatter.value == pytest.approx(full.value, abs=0.001)
    together = [bare, whole]
    assert why_only_scatter(together) == bare.why_scatter
    assert set(present(join_elements(together)).parts) == {"scatter"}
