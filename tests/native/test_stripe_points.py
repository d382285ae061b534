"""C functions beside plain numpy: which points make a line; and calls with wrong arguments."""

from typing import Any

import numpy as np
import pytest

from crenel.metrology.transforms import Floats
from crenel.native.arguments import F64, I32, I64, ArgumentError, Array, Function, Integer, Real
from crenel.native.library import CRENEL

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
frame_points = Function(
    CRENEL,
    "frame_points",
    Array(F64, "n"),
    Array(F64, "n"),
    Array(F64, "n", optional=True),
    Array(I64, "frames"),
    Array(F64, "frames", 4, 4),
    Array(F64, 32),
    Array(F64, "n", 3, written=True),
    Array(F64, "n", written=True, optional=True),
    returns=int,
)
POINTS, SPREAD = 6, 7


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


def arguments(n: int = 4) -> list[Any]:
    """Of a camera at the origin that sees a plane at z = 10 mm."""
    u, unit = np.linspace(-0.4, 0.5, n), np.eye(3).ravel()
    normal, distance_mm, across = [0, 0, 1], 10, [0, 1]
    constants = np.array([*unit, *np.zeros(5), *unit, *np.zeros(3), *normal, distance_mm, *across])
    seen = [u, -u, np.full(n, 0.5), np.array([n]), np.eye(4)[None], constants]
    return [*seen, np.zeros((n, 3)), np.zeros(n)]


def test_sizes_are_passed_and_results_written() -> None:
    given = arguments()
    assert frame_points(*given) == 4
    u = given[0]
    assert isinstance(u, np.ndarray)
    np.testing.assert_allclose(given[POINTS], 10 * np.column_stack([u, -u, np.ones(4)]))
    assert given[SPREAD] == pytest.approx(np.full(4, 1e3 * 10 * 0.5))


def test_optional_arrays_may_be_missing() -> None:
    given = arguments()
    given[2] = given[SPREAD] = None
    assert frame_points(*given) == 4


def frozen(n: int) -> np.ndarray:
    array = np.zeros(n)
    array.flags.writeable = False
    return array


@pytest.mark.parametrize(
    ("at", "wrong", "said"),
    [
        (0, np.zeros(4, np.float32), "float64 is needed, not float32"),
        (POINTS, np.zeros(12), "2 axes are needed, not 1"),
        (POINTS, np.zeros((4, 2)), "shape"),
        (POINTS, np.zeros((3, 4)).T, "C-contiguous"),
        (1, np.zeros(5), "shape"),
        (1, [0.0] * 4, "an array is needed, not list"),
        (1, None, "an array is needed, not NoneType"),
        (SPREAD, frozen(4), "writable"),
    ],
)
def test_an_array_that_is_not_as_declared_is_refused(at: int, wrong: object, said: str) -> None:
    given = arguments()
    given[at] = wrong
    with pytest.raises(ArgumentError, match=f"Argument {at + 1} of frame_points: .*{said}"):
        frame_points(*given)


def test_the_number_of_arguments_counts() -> None:
    with pytest.raises(ArgumentError, match="takes 8 arguments"):
        frame_points(*arguments()[:-1])


def test_every_variant_of_this_processor_gives_the_same() -> None:
    assert CRENEL.variants[0] == "v1"
    found = {}
    for variant in CRENEL.variants:
        with CRENEL.using(variant):
            assert CRENEL.variant == variant
            given = arguments(100)
            frame_points(*given)
            found[variant] = given[SPREAD]
    for one in found.values():
        np.testing.assert_allclose(one, found["v1"], rtol=1e-14)
