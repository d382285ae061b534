"""C functions are called with what they declare, or not at all."""

from typing import Any

import numpy as np
import pytest

from app.native.arguments import F64, I64, ArgumentError, Array, Function
from app.native.library import CRENEL

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
