"""What is due and why, and the one thing to do next."""

from dataclasses import replace
from datetime import UTC, datetime, timedelta
from typing import Any

import pytest

from crenel.guide.common.validity import (
    DUE,
    CheckResult,
    NextAction,
    Page,
    State,
    Validity,
    ValidityInputs,
    check_validity,
    choose_next_action,
    duration,
    tip_finding,
)

NOW = datetime(2026, 11, 21, 12, 0, tzinfo=UTC)


def done(days: float, result: State = "valid", text: str = "Every limit is kept.") -> CheckResult:
    at = (NOW - timedelta(days=days)).isoformat().replace("+00:00", "Z")
    return CheckResult(at, result, text)


NOTHING = ValidityInputs(None, None, False, None, None, None)
CALIBRATED = done(2, text="8 µm (k = 1)")
ALL = ValidityInputs(CALIBRATED, done(1), True, done(0.1), done(3), 0.4, done(200))


def lines(known: ValidityInputs) -> dict[str, Validity]:
    return {line.id: line for line in check_validity(known, NOW)}


def after(known: ValidityInputs, under_way: Page | None = None, blocked: str = "") -> NextAction:
    return choose_next_action(check_validity(known, NOW), under_way, blocked)


def test_where_all_is_in_order_the_next_step_is_to_scan() -> None:
    assert {line.state for line in check_validity(ALL, NOW)} == {"valid"}
    assert after(ALL).page == "scan"
    assert "2 days old" in str(lines(ALL)["calibration"].text)
    assert "+0.4 °C" in str(lines(ALL)["calibration"].text)
    assert "−0.8 °C" in str(lines(replace(ALL, warmer_c=-0.8))["calibration"].text)


@pytest.mark.parametrize("page", ["calibrate", "verify", "performance", "arm", "scan"])
def test_what_is_in_progress_comes_before_all_else(page: Page) -> None:
    led = after(ALL, under_way=page)
    assert led.page == page
    assert "in progress" in str(led.text)


def test_after_camera_and_mounting_alone_comes_the_laser_and_then_the_verification() -> None:
    known = replace(NOTHING, calibration=done(0.1, "due", "It has no laser plane yet."))
    led = after(known)
    assert (str(led.label), led.page) == ("Add the laser", "calibrate")
    assert "no laser plane" in str(led.text)
    verification = lines(known)["verification"]
    assert (verification.quality, str(verification.text)) == (
        "neutral",
        "Calibrate before verifying.",
    )


def test_a_newcomer_is_led_from_calibrating_over_verifying_to_scanning() -> None:
    assert after(NOTHING).page == "calibrate"
    assert str(after(NOTHING, under_way="calibrate").label) == "Continue calibration"
    calibrated = replace(NOTHING, calibration=done(0))
    assert after(calibrated).page == "verify"
    assert lines(calibrated)["verification"].quality == "attention"
    assert str(after(calibrated, under_way="verify").label) == "Continue verification"
    assert after(replace(calibrated, verification=done(0))).page == "scan"


@pytest.mark.parametrize(
    ("change", "page", "said"),
    [
        ({"calibration": done(31)}, "calibrate", "31 days old"),
        ({"warmer_c": 3.4}, "calibrate", "3.4 °C higher"),
        ({"warmer_c": -5.0}, "calibrate", "5.0 °C lower"),
        ({"verification": None}, "verify", "older than this calibration"),
        ({"verification": done(8)}, "verify", "8 days old"),
        ({"verification": done(1, "failed", "Not every limit is kept.")}, "verify", "failed"),
        ({"verification": done(1, "unsure", "Not known.")}, "verify", "was undecided"),
        ({"tip": done(0.1, "failed", "The tip is worn.")}, "arm", "worn"),
        ({"arm": done(1, "failed", "400 µm, limit 250 µm.")}, "arm", "400 µm"),
    ],
)
def test_what_is_amiss_is_named_and_led_to(change: dict[str, Any], page: str, said: str) -> None:
    found = after(replace(ALL, **change))
    assert found.page == page
    assert said in str(found.text)
    assert found.label


@pytest.mark.parametrize("check", ["verification", "performance", "tip", "arm"])
@pytest.mark.parametrize(
    ("result", "quality", "said"),
    [("valid", "good", ""), ("failed", "bad", "failed"), ("unsure", "attention", "undecided")],
)
def test_every_check_has_one_word_for_a_result(
    check: str, result: State, quality: str, said: str
) -> None:
    known = done(0.1, result)
    inputs = {
        "verification": replace(ALL, verification=known),
        "performance": replace(ALL, performance=known),
        "tip": replace(ALL, tip=known),
        "arm": replace(ALL, arm=known),
    }
    line = lines(inputs[check])[check]
    assert (line.state, line.quality) == (result, quality)
    assert said in str(line.text)


def test_a_check_that_is_due_is_said_but_holds_up_nothing() -> None:
    known = replace(ALL, tip=done(2), arm=None)
    assert lines(known)["tip"].state == "due"
    assert lines(known)["arm"].state == "missing"
    assert after(known).page == "scan"


@pytest.mark.parametrize(
    ("test", "state", "said"),
    [
        (None, "missing", "never been tested"),
        (done(364), "valid", "due after 365 days"),
        (done(366), "due", "366 days old"),
        (done(9, "failed", "P_Form is beyond its limit."), "failed", "P_Form is beyond"),
        (done(9, "unsure", "Not known."), "unsure", "undecided"),
    ],
)
def test_a_due_test_holds_up_nothing(test: CheckResult | None, state: State, said: str) -> None:
    known = replace(ALL, performance=test)
    line = lines(known)["performance"]
    assert (line.state, line.page) == (state, "performance")
    assert said in str(line.text)
    assert after(known).page == "scan"
    yearly = DUE.model_copy(update={"performance_days": 30.0})
    strict = {one.id: one for one in check_validity(known, NOW, yearly)}["performance"]
    assert strict.state == ("due" if state == "valid" else state)


def test_other_devices_than_calibrated_come_before_verifying() -> None:
    found = after(replace(ALL, verification=None), blocked="The connected arm is another.")
    assert (found.page, str(found.text)) == ("calibrate", "The connected arm is another.")


def test_limits_are_the_stations_own() -> None:
    strict = DUE.model_copy(update={"verification_days": 0.5})
    found = {line.id: line for line in check_validity(ALL, NOW, strict)}
    assert found["verification"].state == "due"


@pytest.mark.parametrize(
    ("days", "said"),
    [(0.0, "less than a minute"), (1 / 24 / 60, "1 minute"), (0.1, "2 hours"), (1.4, "34 hours"),
     (2.0, "2 days")],
)  # fmt: skip
def test_an_age_is_said_as_people_do(days: float, said: str) -> None:
    assert str(duration(days)) == said


def test_the_state_of_the_tip_is_shown_before_touching() -> None:
    worn = lines(replace(ALL, tip=done(0.1, "failed", "The tip is worn.")))["tip"]
    assert tip_finding(lines(ALL)["tip"]).quality == "good"
    assert (tip_finding(worn).quality, "worn" in str(tip_finding(worn).text)) == ("bad", True)
    never = tip_finding(lines(NOTHING)["tip"])
    assert (never.quality, str(never.text)) == ("neutral", "The tip has never been checked.")
    assert never.remedy


def test_a_robot_has_no_tip_and_no_joints_to_check() -> None:
    lines = check_validity(replace(ALL, has_joints=False), NOW)
    assert [line.id for line in lines] == ["calibration", "verification"]
    assert choose_next_action(lines, None, "").page == "scan"
    first = choose_next_action(check_validity(replace(NOTHING, has_joints=False), NOW), None, "")
    assert "pictures of a chessboard" in str(first.text)
