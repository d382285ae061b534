"""What is drawn and said of a length test. Pure."""

from collections.abc import Sequence

from crenel.errors import sentence
from crenel.findings import Finding
from crenel.gauges.guide_view import (
    LengthErrorMark,
    LengthErrorsPicture,
    LengthLimitMark,
    LengthPlaceMark,
    LengthsPicture,
    PlaceProgress,
)
from crenel.gauges.length.guide_scan_lines import scan_instruction, scan_lines, whole_scans
from crenel.gauges.length.guide_sequence import LengthSequence
from crenel.gauges.length.guide_so_far import LengthsSoFar
from crenel.gauges.length.guide_state import LengthState
from crenel.gauges.plan.maths_lengths import PLACES, REPEATS, MeasuredLength, PermissibleError
from crenel.gauges.session.entries import DatasheetLimit
from crenel.guide.common.view import LiveNumber, StepProgress
from crenel.messages.message import Text, message, quantity


def lengths_picture(state: LengthState, so_far: LengthsSoFar) -> LengthsPicture:
    """The places, and the errors of length over the length."""
    by_scan = state.sequence is not None and state.sequence.by_scan
    return LengthsPicture(
        reach_mm=so_far.reach.radius_mm,
        shoulder_mm=float(so_far.reach.shoulder_mm[2]),
        places=[_place(state, so_far, number) for number in range(1, PLACES + 1)],
        touched=_errors(so_far, so_far.values, state.limits.get("length-touch")),
        scanned=_errors(so_far, so_far.scanned, state.limits.get("length-scan"))
        if by_scan
        else None,
        scans=scan_lines(state, so_far) if by_scan else [],
    )


def _errors(
    so_far: LengthsSoFar, values: Sequence[MeasuredLength], entered: DatasheetLimit | None
) -> LengthErrorsPicture:
    limit = _permissible(entered)

    def limit_um(length_mm: float) -> float | None:
        return None if limit is None else limit.at(length_mm)

    lengths = [one.length_mm for one in so_far.standard.lengths]
    return LengthErrorsPicture(
        limits=[LengthLimitMark(length, limit_um(length)) for length in lengths],
        errors=[
            LengthErrorMark(
                one.place,
                one.repeat,
                one.nominal.length_mm,
                one.error_um,
                limit_um(one.nominal.length_mm),
            )
            for one in values
        ],
    )


def _permissible(limit: DatasheetLimit | None) -> PermissibleError | None:
    return None if limit is None else PermissibleError(limit.a_um, limit.k, limit.b_um)


def place_title(number: int) -> Text:
    """How the standard lies in a place."""
    return message("performance-place", number=number)


def _place(state: LengthState, so_far: LengthsSoFar, number: int) -> LengthPlaceMark:
    sequence = state.sequence
    of = REPEATS * len(so_far.standard.lengths)
    done = sum(one.place == number for one in so_far.values)
    scans = REPEATS if sequence is not None and sequence.by_scan else 0
    scanned = sum(scan.good and scan.of.place == number for scan in whole_scans(state))
    shown: PlaceProgress = "todo"
    if state.place == number:
        shown = "now"
    elif sequence is not None and done >= of:
        shown = "done"
    ends = [(float(x), float(y), float(z)) for x, y, z in so_far.places_mm[number - 1]]
    return LengthPlaceMark(number, shown, ends, place_title(number), done, of, scanned, scans)


def length_instruction(state: LengthState, so_far: LengthsSoFar | None) -> Text:
    """What to touch or scan next."""
    if state.due is not None:
        return scan_instruction(state, state.due, so_far)
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


def length_progress(state: LengthState, sequence: LengthSequence) -> StepProgress:
    """How many lengths are touched, and how many scans of the whole bar are done."""
    done, of = len(state.of_step) // sequence.of_measurement, sequence.measurements
    if not sequence.by_scan:
        return StepProgress(done, of, message("performance-lengths-measured", done=done, of=of))
    scanned, scans = sum(scan.good for scan in whole_scans(state)), sequence.scans
    text = message("performance-lengths-and-scans", done=done, of=of, scanned=scanned, scans=scans)
    return StepProgress(done + scanned, of + scans, text)


def last_error(so_far: LengthsSoFar | None) -> LiveNumber | None:
    """The error of the length that was measured last."""
    if so_far is None or not so_far.values:
        return None
    last = so_far.values[-1]
    if so_far.scanned and so_far.scanned[-1].place == last.place:  # scans follow the touches
        last = so_far.scanned[-1]
    title = message("performance-last-error", length=quantity(last.nominal.length_mm, "mm", 1))
    return LiveNumber(title, last.error_um, "µm", 1)


def length_findings(so_far: LengthsSoFar | None) -> list[Finding]:
    """What is wrong with how the standard is set up."""
    if so_far is None:
        return []
    remedy = message("performance-nothing-decided-standard-rocks")
    findings = [Finding("bad", sentence(text), remedy) for text in so_far.rocking]
    if so_far.off_deg is not None:
        text = message("performance-off-direction", angle=quantity(so_far.off_deg, "°"))
        findings.append(Finding("attention", text, message("performance-turn-standard")))
    return findings
