"""Temperatures at the beginning and the end of a test: what they change, when they decide; and
artefacts without a coefficient of expansion, whose sizes are stated, but not decided."""

from pathlib import Path

import numpy as np
import pytest

from crenel.errors import OperationError
from crenel.gauges.judgement.document import PerformanceFile
from crenel.gauges.judgement.evaluate_temperatures import (
    BY_LENGTHS,
    BY_SPHERE,
    unknown_expansion,
    unknown_expansions,
)
from crenel.gauges.kinds import evaluate_performance
from crenel.gauges.plan.document import LimitPart, PerformancePlan, TemperatureLimitsPart
from crenel.gauges.plan.document_gauge import GaugeFile
from crenel.gauges.plan.document_temperatures import END_TEMPERATURES, EndTemperatures
from crenel.gauges.plan.maths_temperature import TemperatureSpan
from tests.bench.metrology.synthetic_sphere import SPHERE
from tests.cli.test_cli import crenel
from tests.gauges.contact.test_contacts import BAR, STEEL, length_groups, planned, write_test
from tests.present import present

pytestmark = pytest.mark.slow

LIMITS = (LimitPart(quantity="length-touch", a_um=500.0),)
EXPANSION, EXPANSION_SD = STEEL.values()


@pytest.fixture
def folder(tmp_path: Path) -> Path:
    """A complete test of lengths, whose limit is kept."""
    return write_test(tmp_path / "t", "lengths", length_groups(1.0), LIMITS)


@pytest.fixture
def steel(folder: Path) -> Path:
    """Of steel lengths, without temperatures."""
    return planned(folder, length=BAR.model_copy(update=STEEL))


def measured(
    folder: Path, artefact_c: tuple[float, float], arm_c: tuple[float, float]
) -> PerformanceFile:
    """The result with these temperatures at the beginning and at the end."""
    planned(folder, artefact_c=artefact_c[0], arm_c=arm_c[0], temperature_sd_c=0.1)
    end = EndTemperatures(artefact_c=artefact_c[1], arm_c=arm_c[1])
    end.write(folder / END_TEMPERATURES)
    return evaluate_performance(folder)


def require_brought(
    cold: PerformanceFile, warm: PerformanceFile, above_c: float, sd_c: float
) -> None:
    """Lengths are brought to 20 °C from so far above it, as is known to a standard deviation."""
    for before, after in zip(cold.lengths, warm.lengths, strict=True):
        length_um = 1e3 * before.length_mm
        shrunk_um = length_um * EXPANSION * above_c
        assert before.error_um - after.error_um == pytest.approx(shrunk_um, rel=1e-3)
        by_temperature, by_coefficient = EXPANSION * sd_c, EXPANSION_SD * above_c
        sds_um = 2 * length_um * np.array([by_temperature, by_coefficient])
        expected_um = np.linalg.norm([before.test_uncertainty_um, *sds_um])
        assert after.test_uncertainty_um == pytest.approx(expected_um, rel=1e-6)


def test_lengths_are_brought_to_20_degrees_by_the_mean_and_its_change_counts(steel: Path) -> None:
    cold = evaluate_performance(steel)
    assert cold.temperatures is None
    assert "temperature was not stated" in str(cold.notes[-1])
    warm = measured(steel, (24.2, 24.8), (23.0, 23.1))
    assert warm.temperatures is not None
    assert warm.temperatures.artefact_c == (24.2, 24.8)
    assert warm.temperatures.arm_c == (23.0, 23.1)
    assert warm.temperatures.steady
    assert "24.2 to 24.8" in str(warm.notes[-1])
    assert END_TEMPERATURES in {one.file for one in warm.inputs}
    require_brought(cold, warm, 4.5, np.sqrt(0.1**2 + 0.6**2 / 12))
    assert warm.figures[0].decision == "pass"


@pytest.mark.parametrize(
    ("artefact_c", "arm_c", "said"),
    [
        ((20.0, 21.2), (20.0, 20.0), "the artefact changed by 1.2 °C during the test, more than"),
        ((20.0, 20.0), (22.0, 20.8), "the arm changed by 1.2 °C during the test, more than 1"),
        ((20.0, 20.0), (25.5, 25.5), "the arm was at 25.5 °C, more than 5 °C from 20"),
        ((14.0, 14.5), (20.0, 20.0), "the artefact was at 14.0 °C, more than 5 °C from 20"),
    ],
)
def test_nothing_is_decided_where_temperatures_were_not_steady(
    steel: Path, artefact_c: tuple[float, float], arm_c: tuple[float, float], said: str
) -> None:
    result = measured(steel, artefact_c, arm_c)
    (problem,) = result.problems
    assert said.removeprefix("the ") in str(problem)
    (figure,) = result.figures
    assert figure.value is not None
    assert figure.decision == "uncertain"
    assert said in str(figure.reason)
    assert result.verdict.result == "uncertain"
    assert present(result.temperatures).steady is False
    assert said.removeprefix("the ") in crenel("performance", "evaluate", steel).stderr


def test_the_limits_are_those_of_the_plan(steel: Path) -> None:
    planned(steel, temperature_limits=TemperatureLimitsPart(change_c=2.0, from_20_c=8.0))
    result = measured(steel, (25.5, 27.4), (27.9, 27.0))
    assert not result.problems
    assert result.figures[0].decision == "pass"
    assert any("changed by 1.9 °C at most (limit 2 °C)" in str(note) for note in result.notes)


def test_a_test_measured_at_its_beginning_alone_is_decided_and_says_so(steel: Path) -> None:
    cold = evaluate_performance(steel)
    result = evaluate_performance(planned(steel, artefact_c=25.0))
    require_brought(cold, result, 5.0, 0.0)
    assert result.figures[0].decision == "pass"
    assert result.temperatures is not None
    assert result.temperatures.steady is None
    assert result.temperatures.artefact_c == (25.0, None)
    assert any("steady is not known" in str(note) for note in result.notes)
    result.write(steel / "performance.json")
    assert PerformanceFile.read(steel / "performance.json") == result


def test_damaged_temperatures_are_refused(steel: Path) -> None:
    (steel / END_TEMPERATURES).write_text('{"format": "crenel/performance-end-temperatures"}')
    with pytest.raises(OperationError, match="version is None"):
        evaluate_performance(steel)


def test_away_from_20_degrees_lengths_are_stated_but_not_decided(folder: Path) -> None:
    cold = evaluate_performance(folder)
    assert cold.figures[0].decision == "pass"
    result = evaluate_performance(planned(folder, artefact_c=22.0))
    (figure,) = result.figures
    assert figure.value == cold.figures[0].value
    assert figure.decision == "uncertain"
    for text in (figure.reason, *result.problems):
        assert "Ball bar was at 22.0 °C" in str(text)
        assert "no coefficient of expansion" in str(text)
        assert "expansion_per_c" in str(text)
        assert "does not expand: 0, and an uncertainty" in str(text)
    assert result.verdict.result == "uncertain"
    assert not any("are brought to 20 °C" in str(note) for note in result.notes)
    assert "no coefficient of expansion" in crenel("performance", "evaluate", folder).stderr


@pytest.mark.parametrize("celsius", [19.8, 20.0, 20.2])
def test_near_20_degrees_an_unknown_expansion_is_neglected(folder: Path, celsius: float) -> None:
    result = evaluate_performance(planned(folder, artefact_c=celsius))
    assert result.figures[0].decision == "pass"
    assert not result.problems
    assert "are not brought to 20 °C" in str(result.notes[-1])


@pytest.mark.parametrize(
    "known", [{"expansion_per_c": 11.5e-6}, {"expansion_sd_per_c": 1e-8}], ids=["steel", "zero"]
)
def test_a_stated_expansion_is_decided_even_zero(folder: Path, known: dict[str, float]) -> None:
    planned(folder, artefact_c=22.0, length=BAR.model_copy(update=known))
    result = evaluate_performance(folder)
    assert result.figures[0].decision == "pass"
    assert not result.problems
    assert "are brought to 20 °C" in str(result.notes[-1])


def test_the_temperature_at_the_end_counts_too(folder: Path) -> None:
    planned(folder, artefact_c=20.1)
    EndTemperatures(artefact_c=19.7).write(folder / END_TEMPERATURES)
    assert "was at 19.7 °C" in str(evaluate_performance(folder).figures[0].reason)


def test_an_unsteady_temperature_is_said_first(folder: Path) -> None:
    result = evaluate_performance(planned(folder, artefact_c=30.0))
    assert "more than 5 °C from 20" in str(result.figures[0].reason)
    assert len(result.problems) == 2


def test_sizes_of_the_sphere_are_not_decided_its_forms_and_locations_are() -> None:
    plan = PerformancePlan(
        id="t", kind="sphere", started_at="2026-11-26T10:00:00+00:00", sphere=SPHERE
    )
    found = unknown_expansions(plan, TemperatureSpan(22.0))
    assert set(found) == set(BY_SPHERE)
    lengths = plan.model_copy(update={"sphere": None, "length": BAR})
    assert set(unknown_expansions(lengths, TemperatureSpan(22.0))) == set(BY_LENGTHS)
    assert not unknown_expansions(plan, TemperatureSpan())


def test_a_gauge_of_the_folder_is_judged_alike() -> None:
    gauge = GaugeFile(shape="sphere", radius_mm=10.0, name="Sphere")
    assert "Sphere was at 21.0 °C" in str(unknown_expansion(gauge, "Sphere", TemperatureSpan(21.0)))
    known = gauge.model_copy(update={"expansion_per_c": 5e-6})
    assert not unknown_expansion(known, "Sphere", TemperatureSpan(21.0))
