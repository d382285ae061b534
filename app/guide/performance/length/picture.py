"""What is drawn and said of a length test. Pure."""

from app.errors import sentence
from app.findings import Finding
from app.formats.performance.plan import LimitPart
from app.guide.common.view import LiveNumber
from app.guide.performance.entries import DatasheetLimit
from app.guide.performance.length.so_far import LengthsSoFar
from app.guide.performance.state import PerformanceState
from app.guide.performance.view import (
    LengthErrorMark,
    LengthLimitMark,
    LengthPlaceMark,
    LengthsPicture,
    PlaceProgress,
)
from app.messages.message import Text, message, quantity
from app.metrology.performance.lengths import PLACES, REPEATS
from app.metrology.performance.permissible_error import PermissibleError


def lengths_picture(state: PerformanceState, so_far: LengthsSoFar) -> LengthsPicture:
    """The places, and the errors of length over the length."""
    limit = _permissible(state.limits.get("length-touch"))
    lengths = [one.length_mm for one in so_far.standard.lengths]

    def limit_um(length_mm: float) -> float | None:
        return None if limit is None else limit.at(length_mm)

    return LengthsPicture(
        reach_mm=so_far.reach.radius_mm,
        shoulder_mm=float(so_far.reach.shoulder_mm[2]),
        places=[_place(state, so_far, number) for number in range(1, PLACES + 1)],
        limits=[LengthLimitMark(length, limit_um(length)) for length in lengths],
        errors=[
            LengthErrorMark(
                one.place,
                one.repeat,
                one.nominal.length_mm,
                one.error_um,
                limit_um(one.nominal.length_mm),
            )
            for one in so_far.values
        ],
    )


def _permissible(limit: DatasheetLimit | None) -> PermissibleError | None:
    if limit is None:
        return None
    return LimitPart(quantity="length-touch", a_um=limit.a_um, k=limit.k, b_um=limit.b_um).error


def place_title(number: int) -> Text:
    """How the standard lies in a place."""
    return message("performance-place", number=number)


def _place(state: PerformanceState, so_far: LengthsSoFar, number: int) -> LengthPlaceMark:
    sequence = state.sequence
    of = REPEATS * len(so_far.standard.lengths)
    done = sum(one.place == number for one in so_far.values)
    shown: PlaceProgress = "todo"
    if sequence is not None and done >= of:
        shown = "done"
    elif state.end is not None and state.end.place == number:
        shown = "now"
    ends = [(float(x), float(y), float(z)) for x, y, z in so_far.places_mm[number - 1]]
    return LengthPlaceMark(number, place_title(number), shown, done, of, ends)


def length_instruction(state: PerformanceState, so_far: LengthsSoFar | None) -> Text:
    """What to touch next."""
    end, sequence = state.end, state.sequence
    if end is None or sequence is None or so_far is None:
        return message("performance-lengths-done")
    touches, each = len(state.counted), sequence.touches_each
    size = so_far.standard.lengths[end.length - 1].length_mm
    what = message(
        "performance-touch-length",
        kind="face" if so_far.standard.sphere_diameter_mm is None else "sphere",
        length=quantity(size, "mm", 1),
        repeat=end.repeat,
        of=REPEATS,
        end=end.end + 1,
        touches=each,
    )
    if touches % sequence.of_place == 0:
        return message("performance-set-standard-up", place=place_title(end.place), text=what)
    return what


def last_error(so_far: LengthsSoFar | None) -> LiveNumber | None:
    """The error of the length that was measured last."""
    if so_far is None or not so_far.values:
        return None
    last = so_far.values[-1]
    title = message("performance-last-error", length=quantity(last.nominal.length_mm, "mm", 1))
    return LiveNumber(title, last.error_um, "µm", 1)


def length_findings(so_far: LengthsSoFar | None) -> list[Finding]:
    """What is wrong with how the standard is set up."""
    if so_far is None:
        return []
    remedy = message("performance-fix-standard")
    findings = [Finding("bad", sentence(text), remedy) for text in so_far.rocking]
    if so_far.off_deg is not None:
        text = message("performance-off-direction", angle=quantity(so_far.off_deg, "°"))
        findings.append(Finding("attention", text, message("performance-turn-standard")))
    return findings
