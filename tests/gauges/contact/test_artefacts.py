"""The contact test on spheres and bars that cannot serve, or are not at 20 °C."""

from collections.abc import Mapping
from pathlib import Path

import numpy as np
import pytest

from crenel.errors import OperationError
from crenel.gauges.judgement.document import PerformanceFile
from crenel.gauges.kinds import evaluate_performance
from crenel.gauges.plan.document import LimitPart
from crenel.gauges.plan.document_length_standard import LengthPart
from crenel.gauges.plan.document_symbols import Quantity
from tests.bench.metrology.synthetic_sphere import SPHERE
from tests.cli.test_cli import crenel
from tests.gauges.contact.test_contacts import (
    BAR,
    STEEL,
    contact_groups,
    figures_of,
    length_groups,
    planned,
    scattered,
    write_test,
)

pytestmark = pytest.mark.slow

BY_SPHERE: tuple[Quantity, ...] = ("effective-diameter",)
BY_SEATS: tuple[Quantity, ...] = ("articulation-largest", "articulation-two-s")
BY_BAR: tuple[Quantity, ...] = ("volumetric-largest", "volumetric-two-rms")
LIMITS = tuple(LimitPart(quantity=one, a_um=500.0) for one in (*BY_SPHERE, *BY_SEATS, *BY_BAR))
Changes = Mapping[str, object]


def known_length(length_mm: float, sd_um: float = 0.5) -> LengthPart:
    return LengthPart(length_mm=length_mm, standard_uncertainty_um=sd_um)


SHORT = (*BAR.lengths, known_length(19.0))


@pytest.fixture
def folder(tmp_path: Path) -> Path:
    """A complete contact test, whose limits are kept."""
    return write_test(tmp_path / "t", "contact", contact_groups(0.02), LIMITS)


def evaluated(
    folder: Path,
    sphere: Changes | None = None,
    bar: Changes | None = None,
    without: str = "",
    **plan: object,
) -> PerformanceFile:
    """The result with these fields of sphere, bar and plan, and without an artefact."""
    changes = {
        "sphere": SPHERE.model_copy(update=sphere or {}),
        "length": BAR.model_copy(update=bar or {}),
        **plan,
    }
    if without:
        changes[without] = None
    return evaluate_performance(planned(folder, **changes))


def test_artefacts_that_can_serve_decide_every_figure(folder: Path) -> None:
    result = evaluated(folder)
    assert [one.decision for one in result.figures] == ["pass"] * 5
    assert not result.problems


@pytest.mark.parametrize(
    ("artefact", "changes", "said"),
    [
        ("bar", {"valid_until": "2020-01-31"}, "valid until 2020-01-31"),
        ("bar", {"valid_until": "soon"}, "soon"),
        ("bar", {"lengths": (known_length(400.0, 0.0),)}, "states no uncertainty"),
        ("bar", {"lengths": SHORT}, "less than the diameter of the spheres"),
        ("sphere", {"valid_until": "2020-01-31"}, "valid until 2020-01-31"),
        ("sphere", {"diameter_sd_um": 0.0}, "states no uncertainty"),
    ],
)
def test_an_artefact_that_cannot_serve_states_no_figures(
    folder: Path, artefact: str, changes: Changes, said: str
) -> None:
    is_bar = artefact == "bar"
    result = evaluated(folder, bar=changes) if is_bar else evaluated(folder, sphere=changes)
    of_artefact = BY_BAR if is_bar else BY_SPHERE
    for one, figure in figures_of(result).items():
        if one not in of_artefact:
            assert figure.decision == "pass"
            continue
        assert figure.value is None
        assert figure.values == ()
        assert figure.data
        assert said in str(figure.problem)
    (problem,) = result.problems
    assert said in str(problem)
    assert str(problem).startswith("Ball bar: ") or not is_bar
    assert result.verdict.result == "uncertain"
    assert said in crenel("performance", "evaluate", folder).stderr


def test_a_plan_with_one_artefact_states_the_figures_of_it(folder: Path) -> None:
    without_bar = figures_of(evaluated(folder, without="length"))
    assert without_bar["effective-diameter"].decision == "pass"
    for one in BY_BAR:
        assert "names no ball bar" in str(without_bar[one].problem)
    without_sphere = figures_of(evaluated(folder, without="sphere"))
    assert "names no master sphere" in str(without_sphere["effective-diameter"].problem)
    assert without_sphere["volumetric-largest"].decision == "pass"


def test_figures_of_an_artefact_that_was_left_out_are_not_stated(tmp_path: Path) -> None:
    groups = contact_groups(0.02)
    for without, prefix, by, word in (
        ("sphere", "d", BY_SPHERE, "effective diameter"),
        ("length", "b", BY_BAR, "volumetric lengths"),
    ):
        left = [one for one in groups if one[0][0] != prefix]
        result = evaluated(write_test(tmp_path / without, "contact", left, LIMITS), without=without)
        assert not set(by) & set(figures_of(result))
        assert all(one.decision == "pass" for one in result.figures)
        notes = " ".join(map(str, result.notes))
        assert f"{word} was left out" in notes or f"{word} were left out" in notes
        # a limit was meant to be judged
        assert notes.count("has a limit for") == len(by)


def test_diameter_and_lengths_are_brought_to_20_degrees(folder: Path) -> None:
    cold = evaluated(folder, sphere=STEEL, bar=STEEL)
    assert "temperature was not stated" in str(cold.notes[-1])
    warm = evaluated(folder, sphere=STEEL, bar=STEEL, artefact_c=24.0, temperature_sd_c=0.5)
    assert "brought to 20 °C" in str(warm.notes[-1])
    before, after = figures_of(cold), figures_of(warm)
    sizes_mm: dict[Quantity, float] = {"effective-diameter": 25.0, "volumetric-largest": 400.0}

    def expected_um(of: Quantity, size_mm: float, times: float = 1.0) -> float:
        size_um, stated_um = 1e3 * size_mm, before[of].test_uncertainty
        assert stated_um is not None
        by_heat = np.array([size_um * 11.5e-6 * 0.5, size_um * 1e-6 * 4.0])
        return float(np.hypot(stated_um, 2 * times * np.linalg.norm(by_heat)))

    for quantity, size_mm in sizes_mm.items():
        warm_um, cold_um = after[quantity].values, np.array(before[quantity].values, dtype=float)
        shrunk_um = 1e3 * size_mm * 11.5e-6 * 4.0
        assert warm_um == pytest.approx(cold_um - shrunk_um, abs=0.01)
        known_um = expected_um(quantity, size_mm)
        assert after[quantity].test_uncertainty == pytest.approx(known_um, rel=1e-6)
    assert after["volumetric-two-rms"].value == pytest.approx(60 - 2 * shrunk_um, abs=0.5) or (
        after["volumetric-two-rms"].value == pytest.approx(2 * shrunk_um - 60, abs=0.5)
    )
    # twice the RMS changes by twice what the bar is off in every placement
    assert after["volumetric-two-rms"].test_uncertainty == pytest.approx(
        expected_um("volumetric-two-rms", 400.0, times=2.0), rel=1e-3
    )


@pytest.mark.parametrize(
    ("changes", "said"),
    [
        ({"sphere_diameter_mm": None}, "sphere_diameter_mm"),
        ({"kind": "step-gauge"}, "names no ball bar"),
    ],
)
def test_a_bar_without_spheres_states_no_volume(folder: Path, changes: Changes, said: str) -> None:
    found = figures_of(evaluated(folder, bar=changes))
    for one in BY_BAR:
        assert found[one].value is None
        assert said in str(found[one].problem)
    assert found["effective-diameter"].decision == "pass"


@pytest.mark.parametrize(("certified_mm", "is_other"), [(401.9, False), (402.2, True)])
def test_a_length_that_is_none_of_the_certificate_is_that_of_another_bar(
    folder: Path, certified_mm: float, is_other: bool
) -> None:
    lengths = (known_length(600.0), known_length(certified_mm))
    found = figures_of(evaluated(folder, bar={"lengths": lengths}))
    for one in BY_BAR:
        assert (found[one].value is None) == is_other
    if is_other:
        assert "length of 400.0 mm" in str(found["volumetric-largest"].problem)
        assert "certificate is 402.2 mm" in str(found["volumetric-largest"].problem)


@pytest.mark.parametrize(("diameter_mm", "is_other"), [(26.9, False), (27.2, True)])
def test_a_diameter_that_is_far_off_the_certificate_is_that_of_another_sphere(
    folder: Path, diameter_mm: float, is_other: bool
) -> None:
    result = evaluated(folder, sphere={"diameter_mm": diameter_mm})
    figure = figures_of(result)["effective-diameter"]
    assert (figure.value is None) == is_other
    assert ("2.2 mm off the certificate" in str(figure.problem)) == is_other


def test_touches_in_one_place_state_no_diameter(tmp_path: Path) -> None:
    groups = contact_groups(0.02)
    groups[0] = (groups[0][0], np.tile(groups[0][1][:1], (9, 1)))
    result = evaluated(write_test(tmp_path / "t", "contact", groups, LIMITS))
    found = figures_of(result)
    assert "too small a part of a sphere" in str(found["effective-diameter"].problem)
    assert found["volumetric-largest"].decision == "pass"


@pytest.mark.parametrize("kind", ["lengths", "plane", "sphere"])
def test_a_plan_without_its_artefact_is_refused(folder: Path, kind: str) -> None:
    planned(folder, sphere=None, length=None, kind=kind)
    with pytest.raises(OperationError, match="the plan names no"):
        evaluate_performance(folder)


def test_without_limits_the_result_says_so(tmp_path: Path) -> None:
    result = evaluated(write_test(tmp_path / "t", "contact", contact_groups(0.02), ()))
    assert result.verdict.result == "uncertain"
    assert "No limit is entered" in str(result.verdict.text)


def test_five_lengths_are_asked_of_the_test_of_lengths_alone(folder: Path, tmp_path: Path) -> None:
    one_length = {"lengths": BAR.lengths[2:3]}
    contact = evaluated(folder, bar=one_length)
    said = (*contact.notes, *contact.problems)
    assert not any("five" in str(text) for text in said)
    assert figures_of(contact)["volumetric-largest"].decision == "pass"
    groups = [one for one in length_groups(1.0) if one[0].split("-")[2] == "1"]
    lengths = write_test(tmp_path / "l", "lengths", groups, ())
    result = evaluated(lengths, bar={"lengths": BAR.lengths[:1]}, without="sphere")
    assert any("five" in str(text) for text in result.problems)


def test_a_figure_whose_artefact_has_no_coefficient_is_not_decided(folder: Path) -> None:
    result = evaluated(folder, sphere=STEEL, artefact_c=20.0 + 0.3)
    found = figures_of(result)
    for one in BY_BAR:
        assert found[one].value is not None
        assert found[one].decision == "uncertain"
        assert "Ball bar was at 20.3 °C" in str(found[one].reason)
        assert "expansion_sd_per_c" in str(found[one].reason)
    for one in (*BY_SPHERE, *BY_SEATS):
        assert found[one].decision == "pass"
    (problem,) = result.problems
    assert "no coefficient of expansion" in str(problem)
    both = evaluated(folder, artefact_c=20.3)
    assert figures_of(both)["effective-diameter"].decision == "uncertain"
    assert len(both.problems) == 2
    assert "are not brought to 20 °C" in str(both.notes[-1])


@pytest.mark.parametrize(
    ("loose", "said", "missing"),
    [
        ("b5-", "the bar rocks in placement 5", BY_BAR),
        ("b", "the bar rocks in placement", BY_BAR),
        ("d", "the sphere rocks in measurement", BY_SPHERE),
        ("s2", "Seat 2 is loose", BY_SEATS),
        ("", "", ()),
    ],
)
def test_artefacts_that_give_way_state_no_figures(
    tmp_path: Path, loose: str, said: str, missing: tuple[Quantity, ...]
) -> None:
    groups = scattered(contact_groups(0.02), loose or "none", 0.3, np.random.default_rng(5))
    result = evaluate_performance(write_test(tmp_path / "t", "contact", groups, LIMITS))
    found = figures_of(result)
    assert {one for one, figure in found.items() if figure.value is None} == set(missing)
    assert bool(result.problems) == bool(said)
    assert all(said in str(one) for one in result.problems)
