"""Temperatures at the beginning and the end of a test: what they change, when they decide."""

from pathlib import Path

import numpy as np
import pytest

from app.errors import OperationError
from app.formats.performance.end_temperatures import END_TEMPERATURES, EndTemperatures
from app.formats.performance.plan import LimitPart, TemperatureLimitsPart
from app.formats.performance.results import PerformanceFile
from app.workflows.performance.evaluate import evaluate_performance
from tests.cli.test_cli import crenel
from tests.present import present
from tests.workflows.performance.test_contacts import BAR, STEEL, length_groups, planned, write_test

pytestmark = pytest.mark.slow

LIMITS = (LimitPart(quantity="length-touch", a_um=500.0),)
EXPANSION, EXPANSION_SD = STEEL.values()


@pytest.fixture
def folder(tmp_path: Path) -> Path:
    """A test of steel lengths, without temperatures."""
    folder = write_test(tmp_path / "t", "lengths", length_groups(1.0), LIMITS)
    return planned(folder, length=BAR.model_copy(update=STEEL))


def measured(
    folder: Path, artefact_c: tuple[float, float], arm_c: tuple[float, float]
) -> PerformanceFile:
    """The result with these temperatures at the beginning and at the end."""
    planned(folder, artefact_c=artefact_c[0], arm_c=arm_c[0], temperature_sd_c=0.1)
    end = EndTemperatures(artefact_c=artefact_c[1], arm_c=arm_c[1])
    end.write(folder / END_TEMPERATURES)
    return evaluate_performance(folder)


def test_lengths_are_brought_to_20_degrees_by_the_mean_and_its_change_counts(folder: Path) -> None:
    cold = evaluate_performance(folder)
    assert cold.temperatures is None
    warm = measured(folder, (24.2, 24.8), (23.0, 23.1))
    assert warm.temperatures is not None
    assert warm.temperatures.artefact_c == (24.2, 24.8)
    assert warm.temperatures.arm_c == (23.0, 23.1)
    assert warm.temperatures.steady
    assert "24.2 to 24.8" in str(warm.notes[-1])
    assert END_TEMPERATURES in {one.file for one in warm.inputs}
    for before, after in zip(cold.lengths, warm.lengths, strict=True):
        length_um = 1e3 * before.length_mm
        shrunk_um = length_um * EXPANSION * 4.5
        assert before.error_um - after.error_um == pytest.approx(shrunk_um, rel=1e-3)
        by_temperature = length_um * EXPANSION * np.sqrt(0.1**2 + 0.6**2 / 12)
        by_coefficient = length_um * EXPANSION_SD * 4.5
        parts = [before.test_uncertainty_um, 2 * by_temperature, 2 * by_coefficient]
        expected = np.linalg.norm(parts)
        assert after.test_uncertainty_um == pytest.approx(expected, rel=1e-6)
    assert warm.figures[0].decision == "pass"


@pytest.mark.parametrize(
    ("artefact_c", "arm_c", "said"),
    [
        ((20.0, 21.2), (20.0, 20.0), "the artefact changed by 1.2 °C during the test, more than"),
        ((20.0, 20.0), (22.0, 20.8), "the arm changed by 1.2 °C during the test, more than 1.0"),
        ((20.0, 20.0), (25.5, 25.5), "the arm was at 25.5 °C, more than 5.0 °C from 20"),
        ((14.0, 14.5), (20.0, 20.0), "the artefact was at 14.0 °C, more than 5.0 °C from 20"),
    ],
)
def test_nothing_is_decided_where_temperatures_were_not_steady(
    folder: Path, artefact_c: tuple[float, float], arm_c: tuple[float, float], said: str
) -> None:
    result = measured(folder, artefact_c, arm_c)
    (problem,) = result.problems
    assert said.removeprefix("the ") in str(problem)
    (figure,) = result.figures
    assert figure.value is not None
    assert figure.decision == "uncertain"
    assert said in str(figure.reason)
    assert result.verdict.result == "uncertain"
    assert present(result.temperatures).steady is False
    assert said.removeprefix("the ") in crenel("performance", "evaluate", folder).stderr


def test_the_limits_are_those_of_the_plan(folder: Path) -> None:
    planned(folder, temperature_limits=TemperatureLimitsPart(change_c=2.0, from_20_c=8.0))
    result = measured(folder, (25.5, 27.4), (27.9, 27.0))
    assert not result.problems
    assert result.figures[0].decision == "pass"
    assert any("changed by 1.9 °C at most (limit 2.0 °C)" in str(note) for note in result.notes)


def test_a_test_measured_at_its_beginning_alone_is_decided_and_says_so(folder: Path) -> None:
    planned(folder, artefact_c=22.0)
    result = evaluate_performance(folder)
    assert result.figures[0].decision == "pass"
    assert result.temperatures is not None
    assert result.temperatures.steady is None
    assert result.temperatures.artefact_c == (22.0, None)
    assert any("steady is not known" in str(note) for note in result.notes)
    result.write(folder / "performance.json")
    assert PerformanceFile.read(folder / "performance.json") == result


def test_damaged_temperatures_are_refused(folder: Path) -> None:
    (folder / END_TEMPERATURES).write_text('{"format": "crenel/performance-end-temperatures"}')
    with pytest.raises(OperationError, match="version is None"):
        evaluate_performance(folder)
