"""The scans of a plate: begun, and measured."""

from collections.abc import Mapping

from crenel.errors import OperationError
from crenel.gauges.guide import PerformanceGuide
from crenel.gauges.judgement.evaluate_measured_data import ScanCloud
from crenel.gauges.plan.document import plane_scan
from crenel.gauges.plane.evaluate import (
    LEAST_TURN_DEG,
    measure_plate_scan,
    orientations_alike,
    turn_between_deg,
)
from crenel.gauges.plane.guide_state import PlaneState
from crenel.gauges.session.entries import PlateScan
from crenel.gauges.session.scans import KindScans, record_scan
from crenel.guide.common.arguments import Args
from crenel.messages.message import Text, message
from crenel.metrology.transforms import Floats


class PlaneScans(KindScans[PlateScan]):
    """The scans of a plate."""

    def begin(self, guide: PerformanceGuide, args: Args, key: str | None) -> None:
        """The first scan of the test freezes its plan."""
        wanted = args.get("orientation")
        orientation = wanted if isinstance(wanted, int) else guide.state.orientation
        if not guide.state.frozen:
            guide.freeze()
        title = message("performance-plate-scan-name", number=orientation)
        record_scan(guide, plane_scan(orientation), title)
        guide.append("scan_begun", {"orientation": orientation}, key)

    def text(self, guide: PerformanceGuide, scan: PlateScan) -> Text:
        return message("performance-measuring-plate-scan", number=scan.orientation)

    def measure(self, guide: PerformanceGuide, scan: PlateScan) -> Mapping[str, object]:
        """What it shows, beside the good scan of the other orientation."""
        with guide.lock:
            arm, scans = guide.arm(), guide.state_of(PlaneState).plate_scans
        if arm is None:
            raise OperationError(
                "datasheets-unreadable", message("sessions-gauge-arm-cannot-read-any")
            )
        others = [one for one in scans if one.good and one.orientation != scan.orientation]
        other = guide.read_cloud(others[-1], arm).R_arm_sensor if others else None
        return measure_plate(guide.read_cloud(scan, arm), guide.plan().gate.shell_mm, other)


def measure_plate(cloud: ScanCloud, shell_mm: float, other: Floats | None) -> Mapping[str, object]:
    """What a scan of the plate shows, as its row has it.

    Args:
        other: (3, 3) orientation of the sensor in the scan of the other orientation; None before
            there is one.

    Raises:
        OperationError: it shows too little of the plate, or the sensor was held as in the other.
    """
    found = measure_plate_scan(cloud, shell_mm)
    turn_deg = None if other is None else turn_between_deg(other, found.R_arm_sensor)
    if turn_deg is not None and turn_deg < LEAST_TURN_DEG:
        raise OperationError(
            "orientations-alike",
            orientations_alike(turn_deg),
            remedy=message("performance-turn-sensor"),
        )
    return {
        "points": len(found.points_mm),
        "width_mm": found.width_mm,
        "dispersion_um": found.dispersion_um,
        "turn_deg": turn_deg,
    }
