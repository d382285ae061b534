"""Lengths, the contact tests of B89.4.22, and the plane, on touches with planted faults."""

from pathlib import Path

import numpy as np
import pytest
from scipy.spatial.transform import Rotation

from crenel.formats.datasheets.arm import ArmFile
from crenel.formats.session.calibration_session import ContactReadings, write_contacts
from crenel.gauges.contact.evaluate import bar_feature, diameter_feature, seat_feature
from crenel.gauges.judgement.document import PerformanceFigure, PerformanceFile
from crenel.gauges.kinds import evaluate_performance
from crenel.gauges.plan.document import (
    PLAN,
    TOUCHES,
    Kind,
    LimitPart,
    PerformancePlan,
    length_feature,
    read_plan,
)
from crenel.gauges.plan.document_length_standard import LengthPart, LengthStandardFile
from crenel.gauges.plan.document_symbols import Quantity
from crenel.gauges.sphere.maths_pattern import RIM_DEG, pattern_directions
from crenel.metrology.transforms import rigid
from tests.bench.metrology.synthetic_arm import TIP
from tests.bench.metrology.synthetic_sphere import SPHERE
from tests.cli.test_cli import crenel

pytestmark = pytest.mark.slow

BAR = LengthStandardFile(
    name="Ball bar",
    serial_number="BB-1",
    sphere_diameter_mm=20.0,
    lengths=tuple(
        LengthPart(length_mm=length, standard_uncertainty_um=0.5)
        for length in (100.0, 200.0, 400.0, 600.0, 800.0)
    ),
)
STEEL = {"expansion_per_c": 11.5e-6, "expansion_sd_per_c": 1e-6}
PATTERN = pattern_directions(np.array([0.0, 0.0, 1.0]), RIM_DEG)
Groups = list[tuple[str, np.ndarray]]

FIVE = [0, 17, 19, 21, 23]
"""Of the pattern: the pole, and four around the rim."""


def write_test(folder: Path, kind: Kind, groups: Groups, limits: tuple[LimitPart, ...]) -> Path:
    """Touches whose tip centres are those of the groups, whatever the wrist."""
    folder.mkdir()
    PerformancePlan(
        id="t",
        kind=kind,
        started_at="2026-11-26T10:00:00+00:00",
        edition="2016" if kind == "lengths" else "B89.4.22",
        sphere=None if kind == "lengths" else SPHERE,
        length=BAR,
        limits=limits,
    ).write(folder / PLAN)
    ArmFile(name="Arm", serial_number="A-1", convention="pose", tip=TIP).write(folder / "arm.json")
    features, poses = [], []
    turns = iter(Rotation.random(sum(len(tips) for _, tips in groups), random_state=4).as_matrix())
    for name, tips in groups:
        for tip in tips:
            R = next(turns)
            features.append(name)
            poses.append(rigid(R, tip - R @ np.array([TIP.x_mm, TIP.y_mm, TIP.z_mm])))
    readings = ContactReadings(tuple(features), np.zeros((len(poses), 0)), np.array(poses))
    write_contacts(folder / TOUCHES, readings)
    return folder


def planned(folder: Path, **changes: object) -> Path:
    """The folder, with other fields in its plan."""
    plan = read_plan(folder).model_copy(update=changes)
    (folder / PLAN).unlink()
    plan.write(folder / PLAN)
    return folder


def on_sphere(centre: np.ndarray, diameter: float, which: list[int] | slice) -> np.ndarray:
    return np.asarray(centre + PATTERN[which] * (diameter + TIP.diameter_mm) / 2)


def length_groups(scale: float, places: range = range(1, 8)) -> Groups:
    groups: Groups = []
    random = np.random.default_rng(2)
    for place in places:
        middle, direction = np.array([500.0, 0, 300]), Rotation.random(random_state=place)
        along = direction.as_matrix()[:, 0]
        for repeat in range(1, 4):
            for number, part in enumerate(BAR.lengths, 1):
                half = 0.5 * (scale * part.length_mm + 0.002 * random.normal()) * along
                for end, centre in ((0, middle - half), (1, middle + half)):
                    name = length_feature(place, repeat, number, end)
                    groups.append((name, on_sphere(centre, 20.0, FIVE)))
    return groups


def scattered(groups: Groups, loose: str, sd_mm: float, random: np.random.Generator) -> Groups:
    """Touches with noise: of groups whose names begin so, and much less of all others."""
    return [
        (name, tips + (sd_mm if name.startswith(loose) else 0.004) * random.normal(size=tips.shape))
        for name, tips in groups
    ]


def figures_of(result: PerformanceFile) -> dict[Quantity, PerformanceFigure]:
    return {one.quantity: one for one in result.figures}


def test_a_scale_error_shows_in_the_lengths(tmp_path: Path) -> None:
    limits = (LimitPart(quantity="length-touch", a_um=20.0, k=20.0, b_um=100.0),)
    folder = write_test(tmp_path / "t", "lengths", length_groups(1.0001), limits)
    result = evaluate_performance(folder)
    assert len(result.lengths) == 105
    (figure,) = result.figures
    assert figure.value == pytest.approx(80, abs=10)
    assert figure.limit == pytest.approx(60)
    assert figure.decision == "fail"
    for one in result.lengths:
        assert one.error_um == pytest.approx(0.1 * one.length_mm, abs=10)
    good = write_test(tmp_path / "g", "lengths", length_groups(1.0), limits)
    assert evaluate_performance(good).figures[0].decision == "pass"


def test_no_length_is_stated_of_a_standard_that_rocks(tmp_path: Path) -> None:
    random = np.random.default_rng(5)
    shaken = [
        (name, tips + (0.1 * random.normal(size=3) if name.startswith("l4-") else 0.0))
        for name, tips in length_groups(1.0)
    ]
    folder = write_test(tmp_path / "t", "lengths", shaken, ())
    result = evaluate_performance(folder)
    (problem,) = result.problems
    assert "rocks in place 4" in str(problem)
    assert result.figures[0].value is None
    assert len(result.lengths) == 105
    assert "rocks in place 4" in crenel("performance", "evaluate", folder).stdout


def test_lengths_in_some_places_are_what_there_is(tmp_path: Path) -> None:
    folder = write_test(tmp_path / "t", "lengths", length_groups(1.0, range(1, 3)), ())
    some = evaluate_performance(folder)
    assert len(some.lengths) == 30
    assert (some.figures[0].value, some.verdict.result) == (None, "uncertain")
    assert "only 30 of 105 lengths were measured" in str(some.figures[0].problem)
    (folder / TOUCHES).unlink()
    assert evaluate_performance(folder).figures[0].value is None


def test_a_bar_that_gives_way_at_each_touch_rocks(tmp_path: Path) -> None:
    """Its touches scatter with its repeats: only other places show it."""
    random, groups = np.random.default_rng(5), length_groups(1.0)
    loose = scattered(groups, "l3-", 0.1, random)
    folder = write_test(tmp_path / "loose", "lengths", loose, ())
    result = evaluate_performance(folder)
    (figure,) = result.figures
    assert figure.value is None
    assert len(result.problems) == 1
    assert "rocks in place 3: touches of its spheres scatter by" in str(result.problems[0])
    still = scattered(groups, "none", 0.1, random)
    steady = evaluate_performance(write_test(tmp_path / "steady", "lengths", still, ()))
    assert not steady.problems


def contact_groups(wobble_mm: float) -> Groups:
    random = np.random.default_rng(3)
    centre = np.array([600.0, 50.0, 200.0])
    groups: Groups = [
        (diameter_feature(i + 1), on_sphere(centre, 25.01, slice(0, 25, 2))) for i in range(3)
    ]
    for seat in range(1, 4):
        tips = np.array([200.0 * seat, 0, 100]) + wobble_mm * random.normal(size=(12, 3))
        groups.append((seat_feature(seat), tips))
    for placement in range(1, 21):
        along = Rotation.random(random_state=placement).as_matrix()[:, 0]
        for end, sign in ((0, -0.5), (1, 0.5)):
            at = centre + sign * (400.0 + 0.03) * along
            groups.append((bar_feature(placement, end), on_sphere(at, 20.0, FIVE)))
    return groups


def test_the_contact_tests_state_their_figures(tmp_path: Path) -> None:
    folder = write_test(tmp_path / "t", "contact", contact_groups(0.02), ())
    found = figures_of(evaluate_performance(folder))
    assert found["effective-diameter"].value == pytest.approx(10, abs=0.1)
    assert found["effective-diameter"].values == pytest.approx([10, 10, 10], abs=0.1)
    largest, two_s = found["articulation-largest"], found["articulation-two-s"]
    assert len(largest.values) == 3
    assert two_s.value == pytest.approx(2 * np.sqrt(3) * 20, rel=0.35)
    assert found["volumetric-largest"].value == pytest.approx(30, abs=0.2)
    assert found["volumetric-two-rms"].value == pytest.approx(60, abs=0.4)
    assert found["volumetric-two-rms"].symbol == "Volumetric, 2 RMS"


def test_missing_seats_and_placements_are_named(tmp_path: Path) -> None:
    groups = [group for group in contact_groups(0.02) if group[0] not in ("s3", "b20-1")]
    result = evaluate_performance(write_test(tmp_path / "t", "contact", groups, ()))
    found = figures_of(result)
    assert "3 seats" in str(found["articulation-largest"].problem)
    assert "19 of 20" in str(found["volumetric-largest"].problem)
    # the test was stopped: what was measured before is not stated either
    assert "3 seats" in str(found["effective-diameter"].problem)
    assert {one.value for one in found.values()} == {None}
    seats, bar = map(str, result.problems)
    assert "3 seats" in seats
    assert "19 of 20" in bar


def test_the_command_prints_every_symbol(tmp_path: Path) -> None:
    folder = write_test(tmp_path / "t", "lengths", length_groups(1.0), ())
    shown = crenel("performance", "evaluate", folder)
    assert shown.exit_code == 0, shown.output
    assert "E_Uni:Tact.AArm" in shown.stdout
    assert "no conformity" in shown.stdout
    assert (folder / "performance.json").is_file()
