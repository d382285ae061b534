"""The scans of a ball bar: begun, and the lengths that they show."""

from collections.abc import Mapping

from crenel.errors import OperationError
from crenel.gauges.guide import PerformanceGuide
from crenel.gauges.length.evaluate_scans import lengths_in_scan
from crenel.gauges.length.guide_scan_lines import pass_title
from crenel.gauges.length.guide_scan_rules import find_bar_pass
from crenel.gauges.length.guide_state import LengthState
from crenel.gauges.session.entries import BarScan
from crenel.gauges.session.scans import KindScans, record_scan
from crenel.guide.common.arguments import Args
from crenel.messages.message import Text, message


class LengthScans(KindScans[BarScan]):
    """The scans of a ball bar."""

    def begin(self, guide: PerformanceGuide, args: Args, key: str | None) -> None:
        of = find_bar_pass(guide.state_of(LengthState), args)
        assert of is not None
        title = message("performance-bar-scan-name", place=of.place, repeat=of.repeat)
        record_scan(guide, of.name, title)
        payload = {"place": of.place, "repeat": of.repeat, "length": of.length}
        guide.append("scan_begun", payload, key)

    def text(self, guide: PerformanceGuide, scan: BarScan) -> Text:
        return message("performance-measuring-bar-scan", scan=pass_title(scan.of, guide.lengths()))

    def measure(self, guide: PerformanceGuide, scan: BarScan) -> Mapping[str, object]:
        """The lengths of a scan, and those that need a scan of their own, by their numbers."""
        with guide.lock:
            arm, standard = guide.arm(), guide.standard()
        if arm is None or standard is None:
            raise OperationError(
                "datasheets-unreadable", message("sessions-gauge-arm-cannot-read-any")
            )
        numbers = [scan.of.length] if scan.of.length else range(1, len(standard.lengths) + 1)
        cloud = guide.read_cloud(scan, arm)
        found = lengths_in_scan(standard, cloud, guide.plan().gate.gate, numbers)
        apart = bool(
            scan.of.length
        )  # the spheres of a single length are scanned by themselves already
        for one in found:
            if one.measured_mm is None and (apart or not one.is_ambiguous):
                raise OperationError(
                    "length-not-scanned", one.problem, remedy=message("performance-scan-bar-again")
                )
        return {
            "lengths": [
                [one.number, one.measured_mm] for one in found if one.measured_mm is not None
            ],
            "alone": [one.number for one in found if one.measured_mm is None],
        }
