"""C functions are called with what they declare, or not at all."""

import numpy as np
import pytest

from app.native.arguments import F64, ArgumentError, Array, Function, Real
from app.native.product import CRENEL

spread = Function(
    CRENEL,
    "spread",
    Array(F64, "n", 3),
    Array(F64, "n"),
    Array(F64, 3),
    Array(F64, 3),
    Real(),
    Array(F64, 3),
    Real(),
    Array(F64, "n", written=True),
)


def arguments(n: int = 4) -> list[object]:
    axis = np.array([0.0, 0.0, 1.0])
    points = np.arange(3.0 * n).reshape(n, 3)
    return [points, np.full(n, 0.5), axis, np.zeros(3), 0.0, axis, 1.0, np.zeros(n)]


def test_sizes_are_passed_and_results_written() -> None:
    given = arguments()
    spread(*given)
    points = given[0]
    assert isinstance(points, np.ndarray)
    assert given[-1] == pytest.approx(1e3 * np.abs(points[:, 2] + 1.0) * 0.5)


def frozen(n: int) -> np.ndarray:
    array = np.zeros(n)
    array.flags.writeable = False
    return array


@pytest.mark.parametrize(
    ("at", "wrong", "said"),
    [
        (0, np.zeros((4, 3), np.float32), "float64 is needed, not float32"),
        (0, np.zeros(12), "2 axes are needed, not 1"),
        (0, np.zeros((4, 2)), "shape"),
        (0, np.zeros((3, 4)).T, "C-contiguous"),
        (1, np.zeros(5), "shape"),
        (1, [0.0] * 4, "an array is needed, not list"),
        (1, None, "an array is needed, not NoneType"),
        (7, frozen(4), "writable"),
    ],
)
def test_an_array_that_is_not_as_declared_is_refused(at: int, wrong: object, said: str) -> None:
    given = arguments()
    given[at] = wrong
    with pytest.raises(ArgumentError, match=f"Argument {at + 1} of spread: .*{said}"):
        spread(*given)


def test_the_number_of_arguments_counts() -> None:
    with pytest.raises(ArgumentError, match="takes 8 arguments"):
        spread(*arguments()[:-1])


def test_every_variant_of_this_processor_gives_the_same() -> None:
    assert CRENEL.variants[0] == "v1"
    found = {}
    for variant in CRENEL.variants:
        with CRENEL.using(variant):
            assert CRENEL.variant == variant
            given = arguments(100)
            spread(*given)
            found[variant] = given[-1]
    for one in found.values():
        np.testing.assert_allclose(one, found["v1"], rtol=1e-14)
