"""Decisions against limits and zones, and the narrowest zone about points."""

from itertools import combinations

import numpy as np
import pytest

from crenel.metrology.decision import GUARDED_95, SIMPLE, decide
from crenel.metrology.transforms import Floats
from crenel.parts.maths.excess_scatter import RunScatter
from crenel.parts.maths.form import minimax_step, narrowest_zone
from crenel.parts.maths.limits import decide_between, length_by_chance, probability_within
from crenel.parts.maths.shapes import Shape


@pytest.mark.parametrize("value", [-12.0, -9.5, -5.0, 0.0, 8.2, 9.9, 10.4, 11.7])
def test_two_limits_are_judged_as_everywhere(value: float) -> None:
    assert decide_between(value, -10.0, 10.0, 1.0, GUARDED_95) == decide(value, 10.0, 1.0)
    assert decide_between(value, -10.0, 10.0, 1.0, SIMPLE) == decide(value, 10.0, 1.0, SIMPLE)


def test_one_limit_leaves_the_other_side_open() -> None:
    assert decide_between(-1e6, None, 1.0, 0.5, GUARDED_95) == "pass"
    assert decide_between(1e6, 1.0, None, 0.5, GUARDED_95) == "pass"
    assert decide_between(1.4, None, 1.0, 0.5, GUARDED_95) == "uncertain"
    assert decide_between(0.0, None, None, 1.0, GUARDED_95) == "none"


@pytest.mark.parametrize("size", [1, 2, 3])
@pytest.mark.parametrize("radius", [0.5, 2.0, 8.0])
def test_the_probability_within_a_zone_is_that_of_draws(size: int, radius: float) -> None:
    rng = np.random.default_rng(size)
    G = rng.normal(size=(size, size))
    centre, covariance = rng.normal(size=size), G @ G.T
    drawn = centre + rng.normal(size=(400_000, size)) @ G.T
    share = float(np.mean(np.linalg.norm(drawn, axis=1) <= radius))
    assert probability_within(radius, centre, covariance) == pytest.approx(share, abs=4e-3)
    expected = float(np.mean(np.linalg.norm(drawn - centre, axis=1)))
    assert length_by_chance(covariance) == pytest.approx(expected, rel=0.05)


def exhaustive_width(points: Floats) -> float:
    """The least width of a slab about points: its faces hold three and one, or two and two."""
    normals = [
        np.cross(points[b] - points[a], points[c] - points[a])
        for a, b, c in combinations(range(len(points)), 3)
    ]
    edges = np.array([points[b] - points[a] for a, b in combinations(range(len(points)), 2)])
    normals += [np.cross(edges[k], edges[k + 1 :]) for k in range(len(edges) - 1)]
    N = np.concatenate([np.atleast_2d(one) for one in normals])
    length = np.linalg.norm(N, axis=1)
    N = N[length > 1e-9] / length[length > 1e-9, None]
    return float(min(np.ptp(points @ part.T, axis=0).min() for part in np.array_split(N, 50)))


def test_flatness_is_that_of_an_exhaustive_search() -> None:
    rng = np.random.default_rng(6)
    points = np.column_stack([rng.uniform(-20, 20, (24, 2)), rng.normal(0, 0.02, 24)])
    start = Shape("plane", np.eye(4), np.zeros(0))
    assert narrowest_zone(start, points)[1] == pytest.approx(exhaustive_width(points), abs=1e-9)


def test_a_step_makes_the_largest_deviation_least() -> None:
    """Many points, of which a few matter; no small change of the step does better."""
    rng = np.random.default_rng(7)
    J, off = rng.normal(size=(5000, 4)), rng.normal(size=5000)
    step, height = minimax_step(J, off)
    assert np.abs(off + J @ step).max() == pytest.approx(height, rel=1e-6)
    for change in 1e-3 * rng.normal(size=(50, 4)):
        assert np.abs(off + J @ (step + change)).max() > height


def drawn_runs(rng: np.random.Generator, form_mm: float) -> tuple[RunScatter, Floats]:
    """Runs whose pulls come from shared errors and noise, and from form."""
    runs, m, P = 12, 3, 6
    normal = np.array([np.diag(rng.uniform(5, 15, m)) for _ in range(runs)])
    by_shared = rng.normal(size=(runs, m, P))
    noise = np.array([0.3 * np.eye(m) for _ in range(runs)])
    before = by_shared @ rng.normal(size=P) + rng.normal(size=(runs, m)) * np.sqrt(0.3)
    before += form_mm * rng.normal(size=(runs, m))
    whole = np.linalg.solve(normal.sum(axis=0), before.sum(axis=0))
    return RunScatter(before - normal @ whole, by_shared, noise, normal), np.eye(P)


def test_known_errors_are_no_form_and_form_is_found() -> None:
    rng = np.random.default_rng(8)
    quiet = sum(
        bool(runs.excess(shared).any())
        for runs, shared in (drawn_runs(rng, 0.0) for _ in range(200))
    )
    assert quiet <= 8
    for _ in range(20):
        runs, shared = drawn_runs(rng, 20.0)
        assert np.trace(runs.excess(shared)) > 0
