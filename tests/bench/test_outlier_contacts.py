"""A few sets of each thing that is touched: of the bench of outliers among contact points."""

import pytest

from tests.bench.outlier_contacts import TOUCHED, measure


@pytest.mark.slow
@pytest.mark.parametrize("name", TOUCHED)
def test_no_good_point_is_named_and_with_enough_points_every_clear_outlier(name: str) -> None:
    touched = TOUCHED[name]
    shares = measure(name, range(900, 900 + (20 if touched.slow == 1 else 2)))
    assert [share for what, share in shares.items() if "good named" in what] == [0.0, 0.0, 0.0]
    if touched.count >= 15:
        assert [share for what, share in shares.items() if "overlooked" in what] == [0.0, 0.0]
