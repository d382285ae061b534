"""The guided length test without a station: its order, its touches, its scans, what is named."""

from collections.abc import Mapping
from dataclasses import replace

import numpy as np
import pytest

from crenel.gauges.guide_commands import button_command
from crenel.gauges.guide_plan import build_plan, choose_lengths, quantities_of, why_no_scans
from crenel.gauges.length.evaluate import length_features
from crenel.gauges.length.guide_picture import lengths_picture
from crenel.gauges.length.guide_scan_lines import bar_pass_reason, find_bar_pass
from crenel.gauges.length.guide_sequence import BarPass, LengthEnd, LengthSequence
from crenel.gauges.length.guide_so_far import check_touch, measure_so_far, touches_on_end
from crenel.gauges.length.guide_state import LengthState
from crenel.gauges.plan.document import LimitPart, length_scan
from crenel.gauges.plan.document_length_standard import LengthPart
from crenel.gauges.session.entries import DatasheetLimit
from crenel.gauges.sphere.maths_pattern import pattern_directions
from crenel.guide.common.guided_session import NO_PROVENANCE
from crenel.metrology.decision import SIMPLE
from tests.gauges.session.sessions import ROBOT, ball_bar, reading, started, state_after, touched
from tests.guide.builders import Row
from tests.refusals import refused_as

BAR = ball_bar(300.0)
AROUND = pattern_directions(np.array([0.0, 0.0, 1.0]))[[0, 13, 15, 17]]
TWO_LENGTHS = ball_bar(100.0, 200.0)
LIMITS = {"length-touch": {"a_um": 40.0}, "length-scan": {"a_um": 60.0, "k": 10.0, "b_um": 75.0}}
START = started("lengths", limits=LIMITS)
BY_SCAN: Row = ("by_scan_set", {"by_scan": True})
CONFIRMED: Row = ("step_confirmed", {"lengths": 2, "touches_each": 1, "by_scan": True})
BEGIN = (START, BY_SCAN, CONFIRMED)


def begun(lengths: int, touches_each: int) -> LengthState:
    limits = {"length-touch": {"a_um": 40.0, "k": 10.0, "b_um": None}, "form-touch": 20.0}
    confirmed = ("step_confirmed", {"lengths": lengths, "touches_each": touches_each})
    return state_after(LengthState, started("lengths", limits=limits), confirmed)


def test_the_order_has_every_end_that_the_evaluation_knows() -> None:
    five = BAR.model_copy(update={"lengths": BAR.lengths * 5})
    plan = build_plan(begun(5, 1), five, NO_PROVENANCE, SIMPLE)
    sequence = LengthSequence(5, 4)
    ends = [sequence.end_at(touch) for touch in range(sequence.touches)]
    assert sequence.measurements == 105
    assert list(dict.fromkeys(end.feature for end in ends if end)) == length_features(plan)
    assert all(ends.count(end) == 4 for end in set(ends))
    assert sequence.end_at(sequence.touches) is None


def test_the_plan_has_the_standard_and_the_limits_of_lengths_alone() -> None:
    state = begun(1, 4)
    assert state.limits["form-touch"] == DatasheetLimit(20.0)
    plan = build_plan(state, BAR, NO_PROVENANCE, SIMPLE)
    assert (plan.kind, plan.sphere, plan.length) == ("lengths", None, BAR)
    assert plan.limits == (LimitPart(quantity="length-touch", a_um=40.0, k=10.0),)


def test_five_lengths_are_spread_over_those_of_the_standard() -> None:
    parts = [LengthPart(length_mm=20.0 * n, standard_uncertainty_um=1.0) for n in range(1, 42)]
    chosen = choose_lengths(BAR.model_copy(update={"lengths": tuple(parts[::-1])}))
    assert [one.length_mm for one in chosen.lengths] == [20, 220, 420, 620, 820]
    assert choose_lengths(BAR) == BAR


def test_the_first_touch_of_the_next_length_confirms_the_one_before() -> None:
    state = begun(2, 1)
    for at in (0.0, 100.0):
        state = touched(state, reading(np.array([at, 0.0, 0.0])))
    assert state.confirmed == 0
    assert state.end == LengthEnd(1, 1, 2, 0)
    state = touched(state, reading(np.zeros(3)))
    assert state.confirmed == 2
    undone = state_after(LengthState, ("touch_voided", {"index": 2}), before=state)
    assert (len(undone.counted), undone.confirmed) == (2, 2)  # the length stays confirmed
    assert undone.feature == state.touches[2].feature


def test_a_ball_bar_takes_four_touches_all_around_each_sphere() -> None:
    state = begun(1, touches_on_end(BAR))
    centres = (np.array([400.0, 0.0, 200.0]), np.array([400.0, 300.05, 200.0]))
    for centre in centres:
        for n, outward in enumerate(AROUND):
            tip = centre + 12.0 * outward
            assert check_touch(state, BAR, ROBOT, reading(tip)) == n
            state = touched(state, reading(tip))
            if len(state.counted) % 4 > 0:
                with refused_as("same-place"):
                    check_touch(state, BAR, ROBOT, reading(tip + 1.0))
    (value,) = measure_so_far(state, BAR, ROBOT).values
    assert value.error_um == pytest.approx(50, abs=0.01)


def test_another_sphere_than_that_of_the_length_is_refused() -> None:
    state = begun(1, 4)
    for outward in AROUND:
        state = touched(state, reading(12.0 * outward))
    with refused_as("another-length"):
        check_touch(state, BAR, ROBOT, reading(np.array([0.0, 400.0, 0.0])))
    check_touch(state, BAR, ROBOT, reading(np.array([0.0, 300.0, 12.0])))


def test_a_standard_far_off_the_drawn_direction_is_named() -> None:
    gauge = BAR.model_copy(update={"sphere_diameter_mm": None, "kind": "step-gauge"})
    state = replace(begun(1, 1), gauge="gauge")
    first, last = measure_so_far(state, gauge, ROBOT).places_mm[0]
    first_touched = touched(state, reading(first))
    along = (last - first) / np.linalg.norm(last - first)
    lying = touched(first_touched, reading(first + 300.0 * along))
    assert measure_so_far(lying, gauge, ROBOT).off_deg is None
    across = np.cross(along, [0.0, 0.0, 1.0])
    turned = touched(first_touched, reading(first + 300.0 * across))
    assert measure_so_far(turned, gauge, ROBOT).off_deg == pytest.approx(90)


def touches_of(place: int) -> list[Row]:
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
        scan_begun(of),
        ("scan_ended", {"number": number}),
        ("scan_measured", {"number": number, "lengths": list(lengths.items()), "alone": alone}),
    ]


def scan_begun(of: BarPass) -> Row:
    return ("scan_begun", {"place": of.place, "repeat": of.repeat, "length": of.length, "at": ""})


def place_done(place: int, first: int) -> list[Row]:
    """A place with its touches and its scans, the first of which has a number."""
    rows = touches_of(place)
    for repeat in (1, 2, 3):
        rows += scanned(first + repeat - 1, BarPass(place, repeat))
    return rows


def test_each_place_takes_three_scans_after_its_touches() -> None:
    before = state_after(LengthState, *BEGIN, *touches_of(1)[:-1])
    assert (before.due, before.end) == (None, LengthEnd(1, 3, 2, 1))
    assert "Touch all lengths" in str(bar_pass_reason(before, {}))
    state = state_after(LengthState, *BEGIN, *touches_of(1))
    assert (state.due, state.end, state.feature) == (BarPass(1, 1), None, "")
    assert state.in_scan
    state = state_after(LengthState, *BEGIN, *touches_of(1), *scanned(1, BarPass(1, 1)))
    assert state.due == BarPass(1, 2)
    state = state_after(LengthState, *BEGIN, *place_done(1, 1))
    assert (state.due, state.end) == (None, LengthEnd(2, 1, 1, 0))
    rows = [row for place in range(1, 8) for row in place_done(place, 3 * place - 2)]
    done = state_after(LengthState, *BEGIN, *rows)
    assert (done.due, done.end, done.place) == (None, None, 0)
    assert [scan.name for scan in done.scans] == [
        length_scan(place, repeat) for place in range(1, 8) for repeat in (1, 2, 3)
    ]


def test_a_scan_confirms_the_touches_before_it() -> None:
    state = state_after(LengthState, *BEGIN, *touches_of(1))
    assert state.confirmed == 10  # the last length can still be taken back
    undone = state_after(LengthState, *BEGIN, *touches_of(1), ("touch_voided", {"index": 11}))
    assert (undone.due, undone.end) == (None, LengthEnd(1, 3, 2, 1))
    assert (
        state_after(LengthState, *BEGIN, *touches_of(1), scan_begun(BarPass(1, 1))).confirmed == 12
    )


def test_a_scan_that_was_dropped_or_refused_is_due_again() -> None:
    rows = (*BEGIN, *touches_of(1), *scanned(1, BarPass(1, 1)), scan_begun(BarPass(1, 2)))
    assert state_after(LengthState, *rows).open_scan is not None
    dropped = state_after(LengthState, *rows, ("scan_dropped", {"number": 2}))
    assert (dropped.open_scan, dropped.due) == (None, BarPass(1, 2))
    refusal = {"code": "x", "reason": "no sphere", "remedy": ""}
    refused = state_after(
        LengthState,
        *rows,
        ("scan_ended", {"number": 2}),
        ("scan_refused", {"number": 2, "refused": refusal}),
    )
    assert refused.due == BarPass(1, 2)
    assert [scan.good for scan in refused.bar_scans] == [True, False]


def test_an_accepted_scan_is_repeated_only_until_the_bar_was_touched_elsewhere() -> None:
    rows = (*BEGIN, *place_done(1, 1))
    state = state_after(LengthState, *rows)
    assert find_bar_pass(state, {}) is None
    assert find_bar_pass(state, {"repeat": 2}) == BarPass(1, 2)
    again = state_after(LengthState, *rows, scan_begun(BarPass(1, 2)))
    assert (again.due, again.bar_scans[1].aside) == (BarPass(1, 2), "repeated")
    moved = state_after(LengthState, *rows, touches_of(2)[0], ("touch_voided", {"index": 12}))
    assert find_bar_pass(moved, {"repeat": 2}) is None
    assert "in another place" in str(bar_pass_reason(moved, {"repeat": 2}))


def test_a_length_that_the_bar_has_twice_takes_a_scan_of_its_own() -> None:
    whole = scanned(1, BarPass(1, 1), {2: 200.01}, alone=(1,))
    rows = [*BEGIN, *touches_of(1), *whole]
    assert state_after(LengthState, *rows).due == BarPass(1, 1, 1)
    state = state_after(LengthState, *rows, *scanned(2, BarPass(1, 1, 1), {1: 100.02}))
    assert state.due == BarPass(1, 2)
    so_far = measure_so_far(state, TWO_LENGTHS, ROBOT)
    errors = {one.nominal.length_mm: one.error_um for one in so_far.scanned}
    assert errors == pytest.approx({100.0: 20.0, 200.0: 10.0})
    lines = lengths_picture(state, so_far).scans
    assert [(one.number, one.length, one.state) for one in lines] == [
        (1, 0, "done"), (1, 1, "done"), (2, 0, "now"), (3, 0, "todo"),
    ]  # fmt: skip
    assert "200.010 mm" in str(lines[0].text)
    assert "+20.0 µm" in str(lines[1].text)


def test_the_picture_has_the_errors_by_scan_with_their_own_limit() -> None:
    rows = (*BEGIN, *touches_of(1), *scanned(1, BarPass(1, 1), {1: 100.08, 2: 200.0}))
    state = state_after(LengthState, *rows)
    picture = lengths_picture(state, measure_so_far(state, TWO_LENGTHS, ROBOT))
    assert picture.scanned is not None
    assert [(one.length_mm, one.limit_um) for one in picture.scanned.limits] == [
        (100.0, 70.0), (200.0, 75.0),
    ]  # fmt: skip
    assert picture.scanned.errors[0].error_um == pytest.approx(80.0)
    assert {one.limit_um for one in picture.touched.errors} == {40.0}
    place = picture.places[0]
    assert (place.state, place.done, place.scanned, place.scans) == ("now", 6, 1, 3)


def test_the_plan_says_whether_it_is_scanned() -> None:
    state = state_after(LengthState, *BEGIN)
    plan = build_plan(state, TWO_LENGTHS, NO_PROVENANCE, SIMPLE)
    assert plan.by_scan
    assert {one.quantity for one in plan.limits} == {"length-touch", "length-scan"}
    gauge = TWO_LENGTHS.model_copy(update={"kind": "step-gauge", "sphere_diameter_mm": None})
    assert "ball bar" in str(why_no_scans(state, gauge))
    assert quantities_of(state, gauge) == ("length-touch",)
    plan = build_plan(state, gauge, NO_PROVENANCE, SIMPLE)
    assert not plan.by_scan
    assert plan.limits == (LimitPart(quantity="length-touch", a_um=40.0),)


def test_a_journal_without_the_choice_is_by_touch() -> None:
    confirmed: Row = ("step_confirmed", {"lengths": 2, "touches_each": 1})
    state = state_after(LengthState, START, confirmed, *touches_of(1))
    assert (state.by_scan, state.due) == (False, None)
    assert state.end == LengthEnd(2, 1, 1, 0)
    assert "by touch alone" in str(bar_pass_reason(state, {}))
    assert lengths_picture(state, measure_so_far(state, TWO_LENGTHS, ROBOT)).scanned is None


def test_the_button_begins_and_ends_the_scans_of_a_place() -> None:
    class Guide:
        def __init__(self, state: LengthState) -> None:
            self.state = state

    due, open_ = (
        state_after(LengthState, *BEGIN, *touches_of(1), *rows)
        for rows in ((), (scan_begun(BarPass(1, 1)),))
    )
    assert button_command(Guide(due), "primary") == "begin_scan"  # type: ignore[arg-type]
    assert button_command(Guide(open_), "primary") == "finish_scan"  # type: ignore[arg-type]
    touching = state_after(LengthState, *BEGIN)
    assert button_command(Guide(touching), "primary") == "touch"  # type: ignore[arg-type]
