"""The scans of a ball bar in its present place: which one a command means, and what is said of
them. Pure."""

from collections.abc import Sequence

from crenel.errors import sentence
from crenel.findings import Finding
from crenel.gauges.guide_view import ArticulationState, BarScanLine
from crenel.gauges.length.guide_sequence import BarPass, BarScan, last_scan, passes_of
from crenel.gauges.length.guide_so_far import LengthsSoFar
from crenel.gauges.length.guide_state import LengthState
from crenel.gauges.plan.maths_lengths import REPEATS
from crenel.guide.common.arguments import Args
from crenel.guide.common.journal import error_from_payload
from crenel.messages.message import Text, join, message, quantity, signed


def whole_scans(state: LengthState) -> Sequence[BarScan]:
    """The scans of the whole bar."""
    return [scan for scan in state.bar_scans if not scan.of.length]


def pass_title(of: BarPass, so_far: LengthsSoFar | None) -> Text:
    """A scan by its repeat, and of a single length by that."""
    if not of.length or so_far is None:
        return message("performance-bar-scan", repeat=of.repeat)
    size = quantity(so_far.standard.lengths[of.length - 1].length_mm, "mm", 1)
    return message("performance-bar-scan-of-length", repeat=of.repeat, length=size)


def scan_lines(state: LengthState, so_far: LengthsSoFar) -> list[BarScanLine]:
    """The scans of the present place; none before its touches are complete."""
    if not state.whole_place:
        return []
    return [_line(state, so_far, of) for of in passes_of(state.whole_place, state.bar_scans)]


def _line(state: LengthState, so_far: LengthsSoFar, of: BarPass) -> BarScanLine:
    title, last = pass_title(of, so_far), last_scan(of, state.bar_scans)
    repeatable = False
    text: Text = ""
    if last is None:
        shown: ArticulationState = "now" if of == state.due else "todo"
    elif last.refused is not None:
        shown, text = "refused", error_from_payload(last.refused).reason
    elif last.good:
        shown, text = "done", _lengths_text(so_far, last)
        repeatable = not of.length and is_bar_in_place(state)
    else:
        shown = "measuring" if last.ended else "scanning"
    return BarScanLine(of.repeat, title, shown, text, of.place, of.length, repeatable)


def _lengths_text(so_far: LengthsSoFar, scan: BarScan) -> Text:
    """Each length that a scan shows with its error."""
    of = scan.of
    values = [one for one in so_far.scanned if (one.place, one.repeat) == (of.place, of.repeat)]
    numbers = {number for number, _ in scan.lengths_mm}
    sizes = {so_far.standard.lengths[number - 1].length_mm for number in numbers}
    return join(
        [
            message(
                "performance-scanned-length",
                length=quantity(one.measured_mm, "mm", 3),
                error=signed(one.error_um, "µm", 1),
            )
            for one in values
            if one.nominal.length_mm in sizes
        ]
    )


def scan_instruction(state: LengthState, due: BarPass, so_far: LengthsSoFar | None) -> Text:
    """What to scan now."""
    if state.open_scan is not None:
        return message("performance-pass-over-spheres")
    if due.length and so_far is not None:
        size = quantity(so_far.standard.lengths[due.length - 1].length_mm, "mm", 1)
        return message("performance-scan-length-alone", length=size)
    return message("performance-scan-bar", repeat=due.repeat, of=REPEATS)


def bar_scan_findings(state: LengthState) -> list[Finding]:
    """Why the last scan of the present place is of no use."""
    last = None if state.due is None else last_scan(state.due, state.bar_scans)
    if last is None or last.refused is None:
        return []
    error = error_from_payload(last.refused)
    return [Finding("attention", error.reason, sentence(error.remedy))]


def bar_pass_reason(state: LengthState, args: Args) -> Text:
    """Why there is no scan that a command could mean."""
    if find_bar_pass(state, args) is not None:
        return ""
    if state.sequence is None or not state.sequence.by_scan:
        return message("performance-by-touch-alone")
    if state.whole_place and not is_bar_in_place(state):
        return message("performance-bar-was-moved")
    return message("performance-touch-bar-first")


def find_bar_pass(state: LengthState, args: Args) -> BarPass | None:
    """The scan of a ball bar that a command means: the next one, or the one to ``repeat`` in the
    present place; None if there is none."""
    repeat = args.get("repeat")
    if not isinstance(repeat, int):
        return state.due
    wanted = BarPass(state.whole_place, repeat)
    known = any(scan.good and scan.of == wanted for scan in state.bar_scans)
    again = known and is_bar_in_place(state)
    return wanted if again or wanted == state.due else None


def is_bar_in_place(state: LengthState) -> bool:
    """Whether the bar was not touched in another place since its present one was complete."""
    place = state.whole_place
    return bool(place) and state.touches[-1].feature.startswith(f"l{place}-")
