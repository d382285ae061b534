"""What not knowing the size of the arm's errors adds, against every size worked out in full."""

from dataclasses import replace

import numpy as np
import pytest

from crenel.metrology.adjustment.core.gauss_newton import (
    AdjustmentResult,
    free_covariance,
    solve_adjustment,
)
from crenel.metrology.adjustment.core.linearise import assemble_normal_equations
from crenel.metrology.adjustment.core.link_error_prior import FACTORS
from crenel.metrology.adjustment.core.parameters import SENSOR
from crenel.metrology.adjustment.core.variance_components import Scales, default_scales, size_prior
from tests.bench.metrology.simulated import SetUp, draw_session, draw_setup

POOR = Scales(links_rad=3e-5, links_mm=0.012, noise=1.0, touch_mm=0.004)
SET_UPS = (
    SetUp("one pose", 1, contacts_per_face=5, seed=3),
    SetUp("four poses, a poor arm", 4, joints=7, scales=POOR, seed=4),
)


@pytest.fixture(scope="module", params=SET_UPS, ids=lambda setup: setup.name)
def found(request: pytest.FixtureRequest) -> AdjustmentResult:
    draw = draw_session(draw_setup(request.param), np.random.default_rng(1))
    return solve_adjustment(draw.problem, draw.start)


def in_full(found: AdjustmentResult) -> np.ndarray:
    """The second moment of the steps to the minima of all sizes, each by its likelihood."""
    equations, at = assemble_normal_equations(found.linear, found.weights), found.layout
    links = found.state.links
    steps, logs = [], []
    held = links / found.scales.link_error_sds(len(links) // 6) ** 2
    for turn in FACTORS:
        for shift in FACTORS:
            rad, mm = found.scales.links_rad * turn, found.scales.links_mm * shift
            size = replace(found.scales, links_rad=rad, links_mm=mm)
            sd = size.link_error_sds(len(links) // 6)
            parts, _ = equations.with_scales(size)
            # the gradient at the minimum comes of the change of the size alone
            g = np.zeros(at.count)
            g[at.links] = links / sd**2 - held
            covariance = free_covariance(np.sum(list(parts.values()), axis=0), found.free)
            own = covariance[np.ix_(found.free, found.free)]
            unit = np.sqrt(np.diag(own))
            log = np.linalg.slogdet(own / np.outer(unit, unit))[1] / 2 + np.sum(np.log(unit))
            log += (g @ covariance @ g) / 2 - np.sum((links / sd) ** 2) / 2 - np.sum(np.log(sd))
            steps.append(-covariance @ g)
            logs.append(log + size_prior(size))
    weight = np.exp(np.array(logs) - max(logs))
    off = np.array(steps) * np.sqrt(weight / weight.sum())[:, None]
    return np.asarray(off.T @ off)


def test_the_covariance_grows_by_what_every_size_would_give(found: AdjustmentResult) -> None:
    sd = np.sqrt(np.diag(found.covariance))[found.free]
    both = np.ix_(found.free, found.free)
    expected = in_full(found)[both] / np.outer(sd, sd)
    stated = found.link_size_covariance[both] / np.outer(sd, sd)
    np.testing.assert_allclose(stated, expected, atol=1e-5)
    assert np.diag(expected)[SENSOR].max() > 1e-3


def test_sizes_that_are_known_add_nothing() -> None:
    draw = draw_session(draw_setup(SET_UPS[0]), np.random.default_rng(1))
    known = solve_adjustment(draw.problem, draw.start, SET_UPS[0].scales)
    assert not known.link_size_covariance.any()


def test_before_any_data_the_usual_size_is_likeliest() -> None:
    usual = default_scales(1.0)
    there = size_prior(usual)
    for turn, shift in ((1.3, 1.0), (1.0, 1.3), (0.7, 0.7), (1.3, 1.3)):
        away = replace(usual, links_rad=usual.links_rad * turn, links_mm=usual.links_mm * shift)
        assert size_prior(away) < there
    one = replace(usual, links_rad=usual.links_rad * 4)
    both = replace(one, links_mm=usual.links_mm * 4)
    assert size_prior(one) < size_prior(both)
