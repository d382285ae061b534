"""The scans of a plate in its two orientations: what is asked, shown and measured."""

from collections.abc import Mapping

from crenel.errors import OperationError, sentence
from crenel.findings import Finding
from crenel.gauges.guide_state import PerformanceState
from crenel.gauges.guide_view import ArticulationLine, ArticulationState
from crenel.gauges.judgement.evaluate_measured_data import ScanCloud
from crenel.gauges.plan.document import ORIENTATIONS
from crenel.gauges.plane.evaluate import (
    LEAST_TURN_DEG,
    measure_plate_scan,
    orientations_alike,
    turn_between_deg,
)
from crenel.gauges.session.entries import PlateScan
from crenel.guide.common.arguments import Args
from crenel.guide.common.journal import error_from_payload
from crenel.messages.message import Text, join, message, quantity
from crenel.metrology.transforms import Floats


def orientation_title(number: int) -> Text:
    """How the sensor is held over the plate."""
    return message("performance-orientation", number=number)


def orientation_of(state: PerformanceState, args: Args) -> int:
    """The orientation that a command is about; missing: the next one."""
    wanted = args.get("orientation")
    return wanted if isinstance(wanted, int) else state.orientation


def plate_instruction(state: PerformanceState) -> Text:
    """What to scan now."""
    if state.open_scan is not None:
        return message("performance-pass-over-plate")
    if not state.orientation:
        return message("performance-plate-scanned")
    return message("performance-scan-plate", number=state.orientation)


def plate_lines(state: PerformanceState) -> list[ArticulationLine]:
    """Both orientations, and what their scans have shown."""
    return [_line(state, number) for number in range(1, ORIENTATIONS + 1)]


def _line(state: PerformanceState, number: int) -> ArticulationLine:
    title, last = orientation_title(number), _last_scan(state, number)
    text: Text = ""
    if last is None:
        shown: ArticulationState = "now" if number == state.orientation else "todo"
    elif last.refused is not None:
        shown, text = "refused", error_from_payload(last.refused).reason
    elif last.good:
        shown = "done"
        text = join(
            [
                message("performance-plate-form", form=quantity(last.dispersion_um, "µm", 1)),
                message("performance-plate-width", width=quantity(last.width_mm, "mm")),
            ]
        )
    else:
        shown = "measuring" if last.ended else "scanning"
    return ArticulationLine(number, title, shown, text)


def _last_scan(state: PerformanceState, number: int) -> PlateScan | None:
    found = [one for one in state.plate_scans if one.orientation == number and not one.aside]
    return found[-1] if found else None


def plate_findings(state: PerformanceState) -> list[Finding]:
    """Why the last scan of the present orientation is of no use."""
    last = _last_scan(state, state.orientation)
    if last is None or last.refused is None:
        return []
    error = error_from_payload(last.refused)
    return [Finding("attention", error.reason, sentence(error.remedy))]


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
