"""What a running scan of the sphere covers: from nothing at each scan, until it is judged."""

import numpy as np

from crenel.formats.clouds.points import pack_points
from crenel.gauges.length.guide_sequence import BarPass, BarScan
from crenel.gauges.plan.maths_gate import SphereGate
from crenel.gauges.sphere.guide_places import POLE
from crenel.gauges.sphere.guide_scans import LiveCoverage, SeenPatches
from crenel.gauges.sphere.guide_state import SphereScan, SphereState
from crenel.gauges.sphere.maths_pattern import PatchCoverage, pattern_directions
from crenel.station.scan.points import NewPoints
from tests.present import present

CENTRE = np.array([300.0, 0.0, 100.0])
RADIUS_MM = 12.5
COUNTED = ((30, 3),) * 25


def empty() -> PatchCoverage:
    return PatchCoverage(CENTRE, 2 * RADIUS_MM, POLE, SphereGate())


def points_of(patch: int, frame: int) -> NewPoints:
    """Ten points in the middle of a patch, by its index, seen from straight above it."""
    outward = pattern_directions(POLE)[patch]
    points = np.tile(CENTRE + RADIUS_MM * outward, (10, 1))
    records = pack_points(points, np.ones(10), np.ones(10), frame)
    return NewPoints(records, np.array([frame]), (CENTRE + 200.0 * outward)[None])


def scanning(**changes: object) -> SphereState:
    scan = SphereScan(number=1, at="", position=1, articulation=1, **changes)  # type: ignore[arg-type]
    return SphereState(step="scan", scans=(scan,))


def seen_patches(seen: SeenPatches | None) -> dict[int, tuple[int, int]]:
    assert seen is not None
    return {patch: counts for patch, counts in enumerate(seen.patches) if counts != (0, 0)}


def test_points_and_frames_grow_until_the_scan_is_judged() -> None:
    coverage = LiveCoverage(1, empty())
    watch = coverage.put
    assert seen_patches(coverage.counts(scanning())) == {}
    watch(points_of(3, frame=0))
    assert seen_patches(coverage.counts(scanning())) == {3: (10, 1)}
    watch(points_of(3, frame=1))
    watch(points_of(7, frame=1))
    seen = coverage.counts(scanning(ended=True))  # it waits to be measured
    assert seen_patches(seen) == {3: (20, 2), 7: (10, 1)}
    assert present(seen).points == 30
    assert coverage.counts(scanning(ended=True, patches=COUNTED)) is None
    assert coverage.counts(scanning(ended=True, refused={})) is None
    assert coverage.counts(scanning(ended=True, aside="dropped")) is None


def test_a_scan_begins_without_the_points_of_the_one_before() -> None:
    first, second = LiveCoverage(1, empty()), LiveCoverage(2, empty())
    first.put(points_of(3, frame=0))
    scan = SphereScan(number=2, at="", position=1, articulation=2)
    both = SphereState(step="scan", scans=(*scanning(aside="dropped").scans, scan))
    assert second.counts(scanning()) is None
    assert first.counts(both) is None
    assert seen_patches(second.counts(both)) == {}


def test_without_a_scan_of_a_sphere_nothing_is_shown() -> None:
    coverage = LiveCoverage(1, empty())
    assert coverage.counts(SphereState()) is None
    bar = BarScan(number=1, at="", of=BarPass(1, 1))
    assert coverage.counts(SphereState(step="lengths", scans=(bar,))) is None
