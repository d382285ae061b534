"""Artefacts without a coefficient of expansion: their sizes are stated, but not decided."""

from pathlib import Path

import pytest

from app.bench.metrology.synthetic_sphere import SPHERE
from app.formats.datasheets.gauge import GaugeFile
from app.formats.performance.end_temperatures import END_TEMPERATURES, EndTemperatures
from app.formats.performance.plan import LimitPart, PerformancePlan
from app.metrology.performance.temperature import TemperatureSpan
from app.workflows.performance.checks.temperatures import (
    BY_LENGTHS,
    BY_SPHERE,
    unknown_expansion,
    unknown_expansions,
)
from app.workflows.performance.evaluate import evaluate_performance
from tests.cli.test_cli import crenel
from tests.workflows.performance.test_contacts import BAR, length_groups, planned, write_test

pytestmark = pytest.mark.slow

LIMITS = (LimitPart(quantity="length-touch", a_um=500.0),)


@pytest.fixture
def folder(tmp_path: Path) -> Path:
    """A complete test of lengths, whose limit is kept."""
    return write_test(tmp_path / "t", "lengths", length_groups(1.0), LIMITS)


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
def test_a_stated_expansion_is_decided_also_a_true_zero(
    folder: Path, known: dict[str, float]
) -> None:
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
    assert "more than 5.0 °C from 20" in str(result.figures[0].reason)
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
