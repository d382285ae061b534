"""A few sessions of the bench of robot poses, by corners alone."""

import pytest

from tests.bench.robot_poses import measure


@pytest.mark.slow
def test_good_poses_that_are_tilted_otherwise_stay_and_clear_outliers_go() -> None:
    shares = measure((1000, 1005, 1007))
    assert [share for what, share in shares.items() if "good" in what] == [0.0, 0.0, 0.0]
    assert shares["bad: clear found"] == shares["wild: found"] == 100.0
