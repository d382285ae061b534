"""A few sets of each thing that is touched: of the bench of outliers among contact points."""

import pytest

from tests.bench.outlier_contacts import TOUCHED, measure

SLOWEST = "block, 12 points"


@pytest.mark.parametrize(
    "name",
    [
        pytest.param(name, marks=pytest.mark.soak if name == SLOWEST else pytest.mark.slow)
        for name in TOUCHED
    ],
)
def test_no_good_point_is_named_and_with_enough_points_every_clear_outlier(name: str) -> None:
    touched = TOUCHED[name]
    shares = measure(name, range(900, 900 + (20 if touched.slow == 1 else 2)))
    assert [share for what, share in shares.items() if "good named" in what] == [0.0, 0.0, 0.0]
    if touched.count >= 15:
        assert [share for what, share in shares.items() if "overlooked" in what] == [0.0, 0.0]
