"""The scans of a one-sphere test: begun, and measured by patches."""

from collections.abc import Mapping

from crenel.errors import OperationError
from crenel.gauges.guide import PerformanceGuide
from crenel.gauges.plan.document import sphere_scan
from crenel.gauges.plan.maths_gate import gate_sphere
from crenel.gauges.session.entries import SphereScan
from crenel.gauges.session.scans import KindScans, record_scan
from crenel.gauges.sphere.evaluate_scans import LEAST_FRAMES, LEAST_PATCHES, LEAST_POINTS
from crenel.gauges.sphere.guide_places import POLE
from crenel.gauges.sphere.maths_pattern import PatchCoverage, pattern_directions, scan_patches
from crenel.guide.common.arguments import Args
from crenel.messages.message import Text, message


class SphereScans(KindScans[SphereScan]):
    """The scans of a one-sphere test."""

    def begin(self, guide: PerformanceGuide, args: Args, key: str | None) -> None:
        wanted = args.get("articulation")
        articulation = wanted if isinstance(wanted, int) else guide.state.articulation
        name = sphere_scan(guide.state.position, articulation)
        title = message("performance-scan-name", articulation=articulation)
        number = len(guide.state.scans) + 1
        record_scan(guide, name, title, guide.coverage.begin(number, _empty_coverage(guide)))
        guide.append("scan_begun", {"articulation": articulation}, key)

    def text(self, guide: PerformanceGuide, scan: SphereScan) -> Text:
        return message("performance-measuring-scan", articulation=scan.articulation)

    def measure(self, guide: PerformanceGuide, scan: SphereScan) -> Mapping[str, object]:
        """Points of the sphere in a scan, and points and frames of each patch."""
        with guide.lock:
            arm, gauge, centre = guide.arm(), guide.gauge(), guide.centre_mm()
        if arm is None or gauge is None or gauge.radius_mm is None or centre is None:
            raise OperationError(
                "datasheets-unreadable", message("sessions-gauge-arm-cannot-read-any")
            )
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
    gauge, centre = guide.gauge(), guide.centre_mm()
    if gauge is None or gauge.radius_mm is None or centre is None:
        return None
    return PatchCoverage(centre, 2 * gauge.radius_mm, POLE, guide.plan().gate.gate)
