"""What to touch or scan next in a one-sphere test. Pure."""

from crenel.gauges.guide_state import PerformanceState
from crenel.messages.message import Text, message


def sphere_instruction(state: PerformanceState) -> Text:
    """The instruction for the steps between the choice of the sphere and the temperatures."""
    if state.step == "pattern":
        if state.of_step:
            return message("performance-touch-pattern")
        if state.position > 1:
            return message("performance-move-sphere")
        return message("performance-touch-top-first")
    if state.step == "location":
        return message("performance-touch-location", number=state.articulation)
    if state.step == "end":
        return message("performance-do-end")
    if state.open_scan is not None:
        return message("performance-pass-slowly")
    if not state.articulation:
        return message("performance-all-scanned")
    return message("performance-hold-sensor", number=state.articulation)
