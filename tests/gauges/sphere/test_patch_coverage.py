"""The counts that grow while a scan runs are those of its whole cloud."""

import numpy as np
import pytest
from numpy.typing import NDArray

from crenel.gauges.plan.maths_gate import SphereGate, within_gate
from crenel.gauges.sphere.maths_pattern import PatchCoverage, pattern_directions, scan_patches
from crenel.metrology.transforms import Floats
from tests.metrology.numerics import unit

CENTRE = np.array([120.0, -340.0, 80.0])
DIAMETER_MM = 25.0
POLE = np.array([0.1, 0.0, 1.0])
GATE = SphereGate(shell_mm=3.0)
Cloud = tuple[Floats, Floats, NDArray[np.int64]]


@pytest.fixture(scope="module")
def cloud() -> Cloud:
    """Points all around the sphere and beside it, their views, and the frames that they are of."""
    rng = np.random.default_rng(3)
    outward = unit(rng.normal(size=(40_000, 3)))
    distance = DIAMETER_MM / 2 + rng.normal(0.0, 2.0, len(outward))
    points = CENTRE + outward * distance[:, None]
    views = unit(CENTRE + np.array([60.0, 30.0, 200.0]) - points)
    return points, views, np.arange(len(points)) // 250


def test_the_counts_are_those_of_the_whole_cloud(cloud: Cloud) -> None:
    points, views, frame = cloud
    coverage = PatchCoverage(CENTRE, DIAMETER_MM, POLE, GATE)
    sums = []
    for part in np.array_split(np.arange(len(points)), 117):  # also within a frame
        coverage.add(points[part], views[part], frame[part])
        sums.append(coverage.points.sum())
    inside = within_gate(points, views, DIAMETER_MM, POLE, CENTRE, GATE)
    whole = scan_patches(points[inside], frame[inside], CENTRE, pattern_directions(POLE))
    assert coverage.points_inside == inside.sum()
    assert 0 < inside.sum() < len(points)
    assert coverage.points.tolist() == whole.points.tolist()
    assert coverage.frames.tolist() == whole.frames.tolist()
    assert 0 < (whole.points > 0).sum() < 25  # the camera does not see all of the sphere
    assert sums[0] < sums[58] < sums[-1]


def test_what_is_beside_the_sphere_covers_nothing(cloud: Cloud) -> None:
    points, views, frame = cloud
    coverage = PatchCoverage(CENTRE + [0.0, 0.0, 400.0], DIAMETER_MM, POLE, GATE)
    coverage.add(points, views, frame)
    coverage.add(points[:0], views[:0], frame[:0])
    assert not coverage.points.any()
    assert not coverage.frames.any()
