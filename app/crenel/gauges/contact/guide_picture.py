"""What is drawn and said of a contact test. Pure."""

from crenel.findings import Finding
from crenel.gauges.contact.evaluate import FEATURES, LEAST_BAR_TOUCHES, seat_problem
from crenel.gauges.contact.guide_state import (
    TOUCHES_EACH,
    ContactSoFar,
    ContactState,
    group_of,
    touches_of,
)
from crenel.gauges.contact.maths import PLACEMENTS, SEAT_POINTS, SEATS, SPHERES
from crenel.gauges.guide_view import (
    ArticulationLine,
    ArticulationState,
    ContactPicture,
    PlaceProgress,
    StandardMark,
)
from crenel.gauges.plan.maths_length_places import FAR, NEAR, TWENTY
from crenel.guide.common.view import LiveNumber
from crenel.messages.message import Text, join, message, quantity, signed
from crenel.metrology.transforms import Floats

LIES = {
    (1.0, 0.0, 0.0): "away",
    (0.0, 1.0, 0.0): "across",
    (0.0, 0.0, 1.0): "up",
    (1.0, 0.0, 1.0): "rising-away",
    (0.0, 1.0, 1.0): "rising-left",
    (1.0, 1.0, 1.0): "rising-away-left",
    (1.0, -1.0, 1.0): "rising-away-right",
}
"""How a bar lies, by its direction: away from the arm, left, up."""


def placement_words(number: int) -> Text:
    """How the bar lies in a placement (1 to 20), how far away, and where as seen from the arm.

    Example:
        >>> print(placement_words(1))
        horizontal, across, near, 60° to the right
    """
    bearing_deg, share, direction = TWENTY[number - 1]
    return message(
        "performance-placement",
        lies=LIES[direction],
        at="near" if share == NEAR else "far" if share == FAR else "middle",
        side="left" if bearing_deg > 0 else "right" if bearing_deg < 0 else "ahead",
        bearing=round(abs(bearing_deg)),
    )


def contact_picture(state: ContactState, so_far: ContactSoFar) -> ContactPicture:
    """The places of the present step, and what is measured in each."""
    places_mm = so_far.placements_mm
    if state.step == "seats":
        places_mm = so_far.seats_mm[:, None].repeat(2, axis=1)
    shown = places_mm if state.step in ("seats", "bar") else places_mm[:0]
    lines = contact_lines(state, so_far)
    return ContactPicture(
        reach_mm=so_far.reach.radius_mm,
        shoulder_mm=float(so_far.reach.shoulder_mm[2]),
        places=[_mark(state, number, ends) for number, ends in enumerate(shown, start=1)],
        lines=lines,
    )


def _mark(state: ContactState, number: int, ends_mm: Floats) -> StandardMark:
    ends = [(float(x), float(y), float(z)) for x, y, z in ends_mm]
    return StandardMark(number, _progress_of(state, number), ends)


def _progress_of(state: ContactState, number: int) -> PlaceProgress:
    now = group_of(state.step, len(state.of_step)) + 1
    return "now" if number == now else "done" if number < now else "todo"


def contact_lines(state: ContactState, so_far: ContactSoFar) -> list[ArticulationLine]:
    """The measurements of the sphere, the seats or the placements of the bar."""
    count = {"diameter": SPHERES, "seats": SEATS, "bar": PLACEMENTS}[state.step]
    return [_line(state, so_far, number) for number in range(1, count + 1)]


def _line(state: ContactState, so_far: ContactSoFar, number: int) -> ArticulationLine:
    progress = _progress_of(state, number)
    shown: ArticulationState = progress
    text: Text = ""
    if progress == "done":
        text = _result_text(state.step, so_far, number)
    elif progress == "now":
        each = TOUCHES_EACH[state.step] * (2 if state.step == "bar" else 1)
        text = message("touches", done=len(state.of_step) % each, of=each)
    return ArticulationLine(number, contact_title(state.step, number), shown, text)


def contact_title(step: str, number: int) -> Text:
    """One measurement of a step."""
    return message("performance-contact-title", step=step, number=number)


def _result_text(step: str, so_far: ContactSoFar, number: int) -> Text:
    if step == "diameter":
        if number > len(so_far.diameters_um):
            return ""
        error = signed(so_far.diameters_um[number - 1], "µm", 1)
        return message("performance-diameter-error", error=error)
    if step == "seats":
        seat = so_far.seats[number - 1]
        largest = quantity(seat.articulation.largest_um, "µm", 1)
        return join(
            [
                message("performance-seat-largest", largest=largest),
                message("performance-seat-share", share=round(100 * seat.share)),
            ]
        )
    found = next((one for one in so_far.lengths if one.place == number), None)
    if found is None:
        return ""
    length = quantity(found.measured_mm, "mm", 3)
    return message(
        "performance-scanned-length", length=length, error=signed(found.error_um, "µm", 1)
    )


def contact_instruction(state: ContactState) -> Text:
    """What to touch next."""
    done, of = len(state.of_step), touches_of(state.step)
    if done >= of:
        return message("performance-all-touched")
    number = group_of(state.step, done) + 1
    if state.step == "diameter":
        return message("performance-touch-master", number=number, of=SPHERES)
    if state.step == "seats":
        text = message("performance-touch-seat", count=SEAT_POINTS)
        if done % SEAT_POINTS:
            return text
        place = message("performance-clamp-seat", number=number)
        return join([place, text], " ")
    end = FEATURES["bar"][done // LEAST_BAR_TOUCHES].endswith("1") + 1
    text = message("performance-touch-bar", end=end, touches=LEAST_BAR_TOUCHES)
    if done % (2 * LEAST_BAR_TOUCHES):
        return text
    return join(
        [message("performance-place-bar", number=number, words=placement_words(number)), text], " "
    )


def contact_number(state: ContactState, so_far: ContactSoFar | None) -> LiveNumber | None:
    """The deviation of the placement that was measured last."""
    if so_far is None or state.step != "bar" or not so_far.lengths:
        return None
    last = so_far.lengths[-1]
    title = message("performance-last-error", length=quantity(last.nominal.length_mm, "mm", 1))
    return LiveNumber(title, last.error_um, "µm", 1)


def contact_findings(state: ContactState, so_far: ContactSoFar | None) -> list[Finding]:
    """Seats that do not stand where the standard asks for them."""
    if so_far is None or state.step != "seats" or not so_far.reach.known:
        return []
    findings = []
    for number, seat in enumerate(so_far.seats, start=1):
        if why := seat_problem(number, seat.share):
            findings.append(Finding("attention", why))
    return findings
