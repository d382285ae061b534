"""What a scan of a ball bar shows: the lengths of its place, or why it is of no use."""

from collections.abc import Mapping

from crenel.errors import OperationError
from crenel.gauges.guide import PerformanceGuide
from crenel.gauges.length.evaluate_scans import lengths_in_scan
from crenel.gauges.session.entries import BarScan
from crenel.messages.message import message


def measure_bar_scan(guide: PerformanceGuide, scan: BarScan) -> Mapping[str, object]:
    """The lengths of a scan, and those that need a scan of their own, by their numbers.

    Raises:
        OperationError: the scan cannot be rebuilt, or does not show a length.
    """
    with guide.lock:
        arm, standard = guide.arm(), guide.standard()
    if arm is None or standard is None:
        raise OperationError("datasheets-unreadable", message("sessions-gauge-arm-cannot-read-any"))
    numbers = [scan.of.length] if scan.of.length else range(1, len(standard.lengths) + 1)
    cloud = guide.read_cloud(scan, arm)
    found = lengths_in_scan(standard, cloud, guide.plan().gate.gate, numbers)
    apart = bool(scan.of.length)  # the spheres of a single length are scanned by themselves already
    for one in found:
        if one.measured_mm is None and (apart or not one.is_ambiguous):
            raise OperationError(
                "length-not-scanned", one.problem, remedy=message("performance-scan-bar-again")
            )
    return {
        "lengths": [[one.number, one.measured_mm] for one in found if one.measured_mm is not None],
        "alone": [one.number for one in found if one.measured_mm is None],
    }
