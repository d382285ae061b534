"""The scans of a ball bar in the guided length test, without a station: when one is due, what it
confirms, what counts, and what earlier journals mean."""

from collections.abc import Mapping

import pytest

from app.formats.performance.plan import LimitPart, length_scan
from app.guide.common.guided_session import NO_PROVENANCE
from app.guide.performance.commands import button_command
from app.guide.performance.entries import BarPass
from app.guide.performance.length.picture import lengths_picture
from app.guide.performance.length.scan_rules import bar_pass_reason, find_bar_pass
from app.guide.performance.length.sequence import LengthEnd
from app.guide.performance.length.so_far import measure_so_far
from app.guide.performance.plan import build_plan, quantities_of, why_no_scans
from app.guide.performance.state import PerformanceState
from app.metrology.decision import SIMPLE
from tests.guide.builders import Row
from tests.guide.performance_sessions import ROBOT, ball_bar, started, state_after

BAR = ball_bar(100.0, 200.0)
LIMITS = {"length-touch": {"a_um": 40.0}, "length-scan": {"a_um": 60.0, "k": 10.0, "b_um": 75.0}}
START = started("lengths", limits=LIMITS)
BY_SCAN: Row = ("by_scan_set", {"by_scan": True})
CONFIRMED: Row = ("step_confirmed", {"lengths": 2, "touches_each": 1, "by_scan": True})
BEGIN = (START, BY_SCAN, CONFIRMED)


def touched(place: int) -> list[Row]:
    """All touches of a place: two lengths, three times."""
    return [
        ("touched", {"feature": LengthEnd(place, repeat, length, end).feature, "place": 0,
                     "reading": [100.0 * length * end, 0.0, 0.0, 0.0, 0.0, 0.0, 1.0]})
        for repeat in (1, 2, 3) for length in (1, 2) for end in (0, 1)
    ]  # fmt: skip


def scanned(
    number: int,
    of: BarPass,
    lengths: Mapping[int, float] = {1: 100.0, 2: 200.0},
    alone: tuple[int, ...] = (),
) -> list[Row]:
    """A scan that was begun, ended and accepted."""
    return [
        begun(of),
        ("scan_ended", {"number": number}),
        ("scan_measured", {"number": number, "lengths": list(lengths.items()), "alone": alone}),
    ]


def begun(of: BarPass) -> Row:
    return ("scan_begun", {"place": of.place, "repeat": of.repeat, "length": of.length, "at": ""})


def place_done(place: int, first: int) -> list[Row]:
    """A place with its touches and its scans, the first of which has a number."""
    rows = touched(place)
    for repeat in (1, 2, 3):
        rows += scanned(first + repeat - 1, BarPass(place, repeat))
    return rows


def test_each_place_takes_three_scans_after_its_touches() -> None:
    before = state_after(*BEGIN, *touched(1)[:-1])
    assert (before.due, before.end) == (None, LengthEnd(1, 3, 2, 1))
    assert "Touch all lengths" in str(bar_pass_reason(before, {}))
    state = state_after(*BEGIN, *touched(1))
    assert (state.due, state.end, state.feature) == (BarPass(1, 1), None, "")
    assert state.in_scan
    state = state_after(*BEGIN, *touched(1), *scanned(1, BarPass(1, 1)))
    assert state.due == BarPass(1, 2)
    state = state_after(*BEGIN, *place_done(1, 1))
    assert (state.due, state.end) == (None, LengthEnd(2, 1, 1, 0))
    rows = [row for place in range(1, 8) for row in place_done(place, 3 * place - 2)]
    done = state_after(*BEGIN, *rows)
    assert (done.due, done.end, done.place) == (None, None, 0)
    assert [scan.name for scan in done.scans] == [
        length_scan(place, repeat) for place in range(1, 8) for repeat in (1, 2, 3)
    ]


def test_a_scan_confirms_the_touches_before_it() -> None:
    state = state_after(*BEGIN, *touched(1))
    assert state.confirmed == 10  # the last length can still be taken back
    undone = state_after(*BEGIN, *touched(1), ("touch_voided", {"index": 11}))
    assert (undone.due, undone.end) == (None, LengthEnd(1, 3, 2, 1))
    assert state_after(*BEGIN, *touched(1), begun(BarPass(1, 1))).confirmed == 12


def test_a_scan_that_was_dropped_or_refused_is_due_again() -> None:
    rows = (*BEGIN, *touched(1), *scanned(1, BarPass(1, 1)), begun(BarPass(1, 2)))
    assert state_after(*rows).open_scan is not None
    dropped = state_after(*rows, ("scan_dropped", {"number": 2}))
    assert (dropped.open_scan, dropped.due) == (None, BarPass(1, 2))
    refusal = {"code": "x", "reason": "no sphere", "remedy": ""}
    refused = state_after(
        *rows, ("scan_ended", {"number": 2}), ("scan_refused", {"number": 2, "refused": refusal})
    )
    assert refused.due == BarPass(1, 2)
    assert [scan.good for scan in refused.bar_scans] == [True, False]


def test_an_accepted_scan_is_repeated_only_until_the_bar_was_touched_elsewhere() -> None:
    rows = (*BEGIN, *place_done(1, 1))
    state = state_after(*rows)
    assert find_bar_pass(state, {}) is None
    assert find_bar_pass(state, {"repeat": 2}) == BarPass(1, 2)
    again = state_after(*rows, begun(BarPass(1, 2)))
    assert (again.due, again.bar_scans[1].aside) == (BarPass(1, 2), "repeated")
    moved = state_after(*rows, touched(2)[0], ("touch_voided", {"index": 12}))
    assert find_bar_pass(moved, {"repeat": 2}) is None
    assert "in another place" in str(bar_pass_reason(moved, {"repeat": 2}))


def test_a_length_that_the_bar_has_twice_takes_a_scan_of_its_own() -> None:
    whole = scanned(1, BarPass(1, 1), {2: 200.01}, alone=(1,))
    rows = [*BEGIN, *touched(1), *whole]
    assert state_after(*rows).due == BarPass(1, 1, 1)
    state = state_after(*rows, *scanned(2, BarPass(1, 1, 1), {1: 100.02}))
    assert state.due == BarPass(1, 2)
    so_far = measure_so_far(state, BAR, ROBOT)
    errors = {one.nominal.length_mm: one.error_um for one in so_far.scanned}
    assert errors == pytest.approx({100.0: 20.0, 200.0: 10.0})
    lines = lengths_picture(state, so_far).scans
    assert [(one.number, one.length, one.state) for one in lines] == [
        (1, 0, "done"), (1, 1, "done"), (2, 0, "now"), (3, 0, "todo"),
    ]  # fmt: skip
    assert "200.010 mm" in str(lines[0].text)
    assert "+20.0 µm" in str(lines[1].text)


def test_the_picture_has_the_errors_by_scan_with_their_own_limit() -> None:
    rows = (*BEGIN, *touched(1), *scanned(1, BarPass(1, 1), {1: 100.08, 2: 200.0}))
    state = state_after(*rows)
    picture = lengths_picture(state, measure_so_far(state, BAR, ROBOT))
    assert picture.scanned is not None
    assert [(one.length_mm, one.limit_um) for one in picture.scanned.limits] == [
        (100.0, 70.0), (200.0, 75.0),
    ]  # fmt: skip
    assert picture.scanned.errors[0].error_um == pytest.approx(80.0)
    assert {one.limit_um for one in picture.touched.errors} == {40.0}
    place = picture.places[0]
    assert (place.state, place.done, place.scanned, place.scans) == ("now", 6, 1, 3)


def test_the_plan_says_whether_it_is_scanned() -> None:
    state = state_after(*BEGIN)
    plan = build_plan(state, BAR, NO_PROVENANCE, SIMPLE)
    assert plan.by_scan
    assert {one.quantity for one in plan.limits} == {"length-touch", "length-scan"}
    gauge = BAR.model_copy(update={"kind": "step-gauge", "sphere_diameter_mm": None})
    assert "ball bar" in str(why_no_scans(state, gauge))
    assert quantities_of(state, gauge) == ("length-touch",)
    plan = build_plan(state, gauge, NO_PROVENANCE, SIMPLE)
    assert not plan.by_scan
    assert plan.limits == (LimitPart(quantity="length-touch", a_um=40.0),)


def test_a_journal_without_the_choice_is_by_touch() -> None:
    confirmed: Row = ("step_confirmed", {"lengths": 2, "touches_each": 1})
    state = state_after(START, confirmed, *touched(1))
    assert (state.by_scan, state.due) == (False, None)
    assert state.end == LengthEnd(2, 1, 1, 0)
    assert "by touch alone" in str(bar_pass_reason(state, {}))
    assert lengths_picture(state, measure_so_far(state, BAR, ROBOT)).scanned is None


def test_the_button_begins_and_ends_the_scans_of_a_place() -> None:
    class Guide:
        def __init__(self, state: PerformanceState) -> None:
            self.state = state

    due, open_ = (state_after(*BEGIN, *touched(1), *rows) for rows in ((), (begun(BarPass(1, 1)),)))
    assert button_command(Guide(due), "primary") == "begin_scan"  # type: ignore[arg-type]
    assert button_command(Guide(open_), "primary") == "finish_scan"  # type: ignore[arg-type]
    touching = state_after(*BEGIN)
    assert button_command(Guide(touching), "primary") == "touch"  # type: ignore[arg-type]
