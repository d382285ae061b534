"""Which scan of a ball bar a command means, and why none is possible now. Pure.

An empty reason means that one is possible.
"""

from crenel.gauges.length.guide_state import LengthState
from crenel.gauges.session.entries import BarPass
from crenel.guide.common.arguments import Args
from crenel.messages.message import Text, message


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
