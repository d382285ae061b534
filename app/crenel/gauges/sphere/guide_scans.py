"""What a one-sphere test knows at any moment, and its scans: begun, and measured by patches."""

import threading
from dataclasses import dataclass

import numpy as np

from crenel.errors import OperationError
from crenel.gauges.guide import PerformanceGuide
from crenel.gauges.plan.document import sphere_scan
from crenel.gauges.plan.maths_gate import gate_sphere
from crenel.gauges.session.changes import Payload
from crenel.gauges.sphere.evaluate_scans import LEAST_FRAMES, LEAST_PATCHES, LEAST_POINTS
from crenel.gauges.sphere.guide_places import (
    POLE,
    PartPlaces,
    Places,
    flat_pattern,
    live_places,
    off_articulation_deg,
    places_of,
    sphere_centre_of,
)
from crenel.gauges.sphere.guide_state import SphereScan, SphereState
from crenel.gauges.sphere.maths_pattern import PatchCoverage, pattern_directions, scan_patches
from crenel.guide.common.arguments import Args
from crenel.messages.message import message
from crenel.metrology.transforms import Floats
from crenel.station.scan.points import NewPoints

MOST_POINTS = 500_000
"""Some seconds of a quick sensor, 20 MB."""


class WaitingPoints:
    """Whoever makes points never waits; whoever wants them takes all that have come since."""

    def __init__(self, most_points: int = MOST_POINTS) -> None:
        """``most_points``: while as many wait, further ones are left out."""
        self._most_points = most_points
        self._handing_over = threading.Lock()
        self._waiting: list[NewPoints] = []
        self._count = 0

    def put(self, new: NewPoints) -> None:
        """Adds points, unless too many wait."""
        with self._handing_over:
            if self._count < self._most_points:
                self._waiting.append(new)
                self._count += len(new.records)

    def take(self) -> list[NewPoints]:
        """All that wait, in their order."""
        with self._handing_over:
            waiting, self._waiting, self._count = self._waiting, [], 0
        return waiting


@dataclass(frozen=True)
class SeenPatches:
    """What a scan of the sphere has seen so far, about the centre that the touches gave."""

    points: int
    """The points of the sphere within the gate."""
    patches: tuple[tuple[int, int], ...]
    """Points and frames of each of the 25."""


class LiveCoverage:
    """The coverage of the sphere by a scan. Points are counted when the counts are asked for, so
    that the scan never waits; its evaluation counts again.

    Args:
        number: of the scan.
        coverage: without any points.
    """

    def __init__(self, number: int, coverage: PatchCoverage) -> None:
        self._number, self._coverage, self._waiting = number, coverage, WaitingPoints()
        self.put = self._waiting.put

    def counts(self, state: SphereState) -> SeenPatches | None:
        """By the scan while it is under way or waits to be measured; None at other times."""
        scan = state.scans[-1] if state.scans else None
        if not isinstance(scan, SphereScan) or scan.number != self._number or scan.judged:
            return None
        for new in self._waiting.take():
            self._coverage.add(new.points_mm, new.views, new.records["frame"])
        counts = zip(self._coverage.points.tolist(), self._coverage.frames.tolist(), strict=True)
        return SeenPatches(self._coverage.points_inside, tuple(counts))


@dataclass(frozen=True, eq=False)
class SphereKnown:
    """What is known of a one-sphere test."""

    places: Places | None
    pattern_flat_deg: Floats
    """(25, 2) of the patches, as ``Places.flat_deg``."""
    off_deg: float | None
    """Angle of stylus or camera from the direction of the present articulation; None of none."""
    seen: SeenPatches | None
    """By the scan that is under way or waits to be measured; None without one, or if the sphere's
    centre is not known."""


def sphere_known(guide: PerformanceGuide) -> SphereKnown:
    """What is known of the test of a session."""
    state, centre, part = guide.state_of(SphereState), sphere_centre_mm(guide), part_places(guide)
    tip = guide.station.rig.arm.tip_mm() if centre is not None else None
    tip_mm = None if tip is None else np.array(tip)
    follower = guide.follower
    return SphereKnown(
        None if part is None else live_places(state, part, centre, tip_mm),
        flat_pattern(centre),
        _off_deg(guide),
        follower.counts(state) if isinstance(follower, LiveCoverage) else None,
    )


def sphere_centre_mm(guide: PerformanceGuide) -> Floats | None:
    """(3,) of the sphere at this position, by the touches of its pattern; None before the first."""
    state, gauge, arm = guide.state_of(SphereState), guide.gauge(), guide.arm()
    if arm is None or gauge is None:
        return None
    return guide.once(lambda: sphere_centre_of(state, arm, gauge))


def part_places(guide: PerformanceGuide) -> PartPlaces | None:
    """The places of the part of the test that is touched now; None if there is none."""
    return places_of(guide.state_of(SphereState), sphere_centre_mm(guide))


def _off_deg(guide: PerformanceGuide) -> float | None:
    """How far stylus or camera is from the direction of the present articulation."""
    newest, arm, centre = guide.station.rig.arm.latest(), guide.arm(), sphere_centre_mm(guide)
    if newest is None or arm is None or centre is None:
        return None
    state, reading = guide.state_of(SphereState), np.array(newest.reading)
    return off_articulation_deg(state, arm, reading, centre, guide.calibration_in_use())


def begin_sphere_scan(guide: PerformanceGuide, args: Args, key: str | None) -> None:
    """Starts the scan of the articulation that a command names, or of the next one."""
    wanted = args.get("articulation")
    articulation = wanted if isinstance(wanted, int) else guide.state_of(SphereState).articulation
    name = sphere_scan(guide.state.position, articulation)
    title = message("performance-scan-name", articulation=articulation)
    number = len(guide.state.scans) + 1
    coverage = _empty_coverage(guide)
    follower = None if coverage is None else LiveCoverage(number, coverage)
    guide.follower = follower
    guide.record_scan(name, title, None if follower is None else follower.put)
    guide.append("scan_begun", {"articulation": articulation}, key)


def measure_sphere_scan(guide: PerformanceGuide, scan: SphereScan) -> Payload:
    """Points of the sphere in a scan, and points and frames of each patch.

    Raises:
        OperationError: it cannot be rebuilt, or shows too little.
    """
    with guide.lock:
        arm, gauge, centre = guide.arm(), guide.gauge(), sphere_centre_mm(guide)
    if arm is None or gauge is None or gauge.radius_mm is None or centre is None:
        raise OperationError("datasheets-unreadable", message("sessions-gauge-arm-cannot-read-any"))
    cloud = guide.read_cloud(scan, arm)
    gate = guide.plan().gate.gate
    found = gate_sphere(cloud.points_mm, cloud.views, 2 * gauge.radius_mm, POLE, centre, gate)
    patches = scan_patches(
        cloud.points_mm[found.inside],
        cloud.frame[found.inside],
        found.centre_mm,
        pattern_directions(POLE),
    )
    covered = (patches.points >= LEAST_POINTS) & (patches.frames >= LEAST_FRAMES)
    if covered.sum() < LEAST_PATCHES:
        raise OperationError(
            "cloud-too-small",
            message("performance-scan-too-small", count=int(covered.sum())),
            remedy=message("performance-scan-again"),
        )
    counts = zip(patches.points.tolist(), patches.frames.tolist(), strict=True)
    patched = [list(count) for count in counts]
    return {"points": int(found.inside.sum()), "patches": patched}


def _empty_coverage(guide: PerformanceGuide) -> PatchCoverage | None:
    """About the touched sphere; None if its centre is not known."""
    gauge, centre = guide.gauge(), sphere_centre_mm(guide)
    if gauge is None or gauge.radius_mm is None or centre is None:
        return None
    return PatchCoverage(centre, 2 * gauge.radius_mm, POLE, guide.plan().gate.gate)
