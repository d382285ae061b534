"""Which points make a line, and what they scatter by: the C functions beside plain numpy."""

import numpy as np
import pytest

from app.metrology.transforms import Floats
from app.native.arguments import F64, I32, Array, Function, Integer, Real
from app.native.library import CRENEL

keep_long_runs = Function(
    CRENEL,
    "keep_long_runs",
    Array(F64, "n"),
    Array(F64, "n"),
    Array(F64, "n", optional=True),
    Integer(),
    Real(),
    Array(I32, "n", written=True),
    returns=int,
)
speckle_variance = Function(
    CRENEL,
    "speckle_variance",
    *[Array(F64, "n")] * 3,
    Array(F64, 2, "n", written=True),
    Integer(),
    Integer(),
    returns=float,
)


def kept_of(along: Floats, across: Floats, sigma: Floats | None, shortest: int) -> list[int]:
    kept = np.empty(len(along), np.int32)
    found = keep_long_runs(along, across, sigma, shortest, 4.0, kept)
    return [int(i) for i in kept[:found]]


def test_a_run_ends_at_a_gap_or_a_step_and_short_ones_are_left_out() -> None:
    along = np.array([0.0, 1, 2, 5, 9, 10, 11, 12, 13, 14])
    across = np.array([0.0, 1, 2, 3, 3, 3, 3, 8, 8, 8])
    assert kept_of(along, across, None, 4) == [0, 1, 2, 3]
    assert kept_of(along, across, None, 3) == list(range(10))
    assert kept_of(along, across, None, 5) == []
    assert kept_of(along[:0], across[:0], None, 1) == []


def test_a_round_spot_is_no_run() -> None:
    along, across = np.arange(12.0), np.zeros(12)
    assert kept_of(along, across, np.full(12, 1.9), 6) == list(range(12))
    assert kept_of(along, across, np.full(12, 2.1), 6) == []


def speckle(scatter_px: float, known_px: float, lag: int = 6, gap: int = 0) -> float:
    rng = np.random.default_rng(3)
    along = np.arange(1200.0)
    along[600:] += gap
    across = 200 + 20 * np.sin(along / 200) + rng.normal(0, np.hypot(scatter_px, known_px), 1200)
    variance = np.full(1200, known_px**2)
    return float(speckle_variance(along, across, variance, np.empty((2, 1200)), lag, 0))


@pytest.mark.parametrize("variant", CRENEL.variants)
@pytest.mark.parametrize("gap", [0, 7])
def test_speckle_is_what_points_scatter_by_beyond_the_noise(variant: str, gap: int) -> None:
    with CRENEL.using(variant):
        assert np.sqrt(speckle(0.2, 0.05, gap=gap)) == pytest.approx(0.2, rel=0.1)
        assert speckle(0.0, 0.05, gap=gap) < 0.02**2
        assert speckle(0.2, 0.0, gap=gap) == pytest.approx(0.2**2, rel=0.2)
        assert speckle(0.2, 0.05, lag=295) == 0.0


def test_noise_that_neighbours_share_is_excused() -> None:
    rng = np.random.default_rng(4)
    along = np.arange(400.0)
    across = rng.normal(0, 0.1, 400)
    variance = np.full(400, 0.09**2)
    workspace = np.empty((2, 400))
    assert speckle_variance(along, across, variance, workspace, 6, 0) > 0
    assert speckle_variance(along, across, variance, workspace, 6, 20) == 0
