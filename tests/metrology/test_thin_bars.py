"""Ball bars on thin data: a true bar is never accused, a wrong one is named where it can be."""

from collections.abc import Iterator
from dataclasses import replace
from itertools import islice

import numpy as np
import pytest

from crenel.errors import OperationError
from crenel.metrology.arm.identification.identify import identify
from crenel.metrology.arm.identification.observations import ArmObservations, Bar
from crenel.metrology.arm.identification.parameters import parameter_names, parameter_values
from crenel.metrology.arm.kinematics import Arm, tip_centres
from crenel.metrology.transforms import Floats
from tests.running.usual import usual
from tests.simulated_robots import Tracker, built, measure, postures, reach, robot, swing

pytestmark = pytest.mark.slow


def bent(q_rad: Floats, rng: np.random.Generator) -> Floats:
    """Angles that the joints truly take: gears and bearings are no part of the model."""
    size, phase = rng.normal(0, 3e-4, q_rad.shape[1]), rng.uniform(0, 6, q_rad.shape[1])
    return np.asarray(q_rad + size * np.sin(2 * q_rad + phase))


def single_bars(true: Arm, count: int, rng: np.random.Generator) -> tuple[Bar, ...]:
    """Bars of which each end is touched once, each with a certificate true to 0.02 mm."""
    q = postures(true, 2 * count, rng)
    places = tip_centres(true, bent(q, np.random.default_rng(0)))
    lengths = np.linalg.norm(places[::2] - places[1::2], axis=1) + rng.normal(0, 0.02, count)
    ends = zip(lengths.tolist(), q[::2], q[1::2], strict=True)
    return tuple(
        Bar(f"b{i}", "1", length_mm, 0.02, ("A", "B"), (a[None], b[None]))
        for i, (length_mm, a, b) in enumerate(ends)
    )


def what_is_said(arm: Arm, observations: ArmObservations) -> list[str]:
    """The warnings, or the refusal."""
    try:
        return [str(text) for text in identify(arm, observations).warnings]
    except OperationError as refusal:
        return [str(refusal.what)]


@pytest.mark.parametrize(
    ("axes", "count"), usual([(7, 35), (6, 60), (6, 35), (7, 60)], 1, pytest.mark.soak)
)
def test_true_bars_are_not_accused(axes: int, count: int) -> None:
    rng = np.random.default_rng(axes + count)
    arm = robot(axes)
    result = identify(arm, ArmObservations(bars=single_bars(built(arm, rng), count, rng)))
    assert not any("bar b" in str(text) or "bars b" in str(text) for text in result.warnings)
    before, after = parameter_values(arm), parameter_values(result.arm)
    moved = {one.name for one in result.changes}
    changed = {parameter_names(arm)[i] for i in np.flatnonzero(after != before)}
    assert changed == moved
    assert moved.isdisjoint(one.name for one in result.fixed)


@pytest.mark.parametrize("seed", usual(range(3), 1, pytest.mark.soak))
def test_true_seats_are_not_accused(seed: int) -> None:
    rng = np.random.default_rng(seed)
    arm = robot(6)
    true = built(arm, rng)
    seats = tuple(swing(true, f"S{i}", rng, 10) for i in range(4))
    true_q = [2 * seat.q_rad - bent(seat.q_rad, np.random.default_rng(0)) for seat in seats]
    seats = tuple(replace(seat, q_rad=q) for seat, q in zip(seats, true_q, strict=True))
    said = what_is_said(arm, ArmObservations(seats, bars=single_bars(true, 12, rng)))
    assert not any("seat s" in text.lower() or "bar b" in text for text in said)


def test_a_wrong_bar_is_named_by_a_tracker_beside_it() -> None:
    rng = np.random.default_rng(5)
    arm = robot(6)
    true = built(arm, rng)
    found = measure(true, postures(arm, 40, rng), Tracker.somewhere(rng), rng)
    bars = tuple(_bar(true, f"b{i}", 200.0 + 80.0 * i, rng) for i in range(3))
    wrong = (bars[0], replace(bars[1], length_mm=bars[1].length_mm + 1.5), bars[2])
    good = identify(arm, ArmObservations(bars=bars, coordinates=(found,)))
    assert not any("bar b" in str(text) for text in good.warnings)
    said = what_is_said(arm, ArmObservations(bars=wrong, coordinates=(found,)))
    assert any("bar b1" in text for text in said)


def _bar(true: Arm, name: str, length_mm: float, rng: np.random.Generator) -> Bar:
    """A bar in one position, both ends touched three times."""
    for _ in range(100):
        a, along = tip_centres(true, postures(true, 1, rng))[0], rng.normal(size=3)
        b = a + along / np.linalg.norm(along) * length_mm
        taken = [
            np.array(list(islice(_reaching(true, end, postures(true, 15, rng)), 3)))
            for end in (a, b)
        ]
        if all(len(end) == 3 for end in taken):
            return Bar(name, "1", length_mm, 0.02, ("A", "B"), (taken[0], taken[1]))
    raise AssertionError("no place for the bar")


def _reaching(true: Arm, place_mm: Floats, starts_rad: Floats) -> Iterator[Floats]:
    """Postures with the tip at a place, one from each start from which it is reached."""
    return (q for start in starts_rad if (q := reach(true, place_mm, start)) is not None)
