"""What of a station is valid, what is due and why, and what to do next. Pure."""

from collections.abc import Sequence
from dataclasses import dataclass
from datetime import datetime
from typing import Literal

from crenel.findings import Finding, Quality
from crenel.formats.settings.toml_table import Limit, TomlTable
from crenel.messages.message import Text, message, quantity, rounded, signed
from crenel.timestamps import parse_moment

CheckName = Literal["calibration", "verification", "performance", "tip", "arm"]
Page = Literal[
    "home",
    "calibrate",
    "verify",
    "performance",
    "scan",
    "part",
    "arm",
    "records",
    "devices",
    "datasheets",
]
State = Literal["valid", "due", "missing", "failed", "unsure"]
SECONDS_A_DAY = 86400.0


class DueLimits(TomlTable):
    """``[due]`` of station.toml: when what is done again."""

    calibration_days: Limit = 30.0
    verification_days: Limit = 7.0
    performance_days: Limit = 365.0
    arm_days: Limit = 30.0
    tip_hours: Limit = 24.0
    temperature_c: Limit = 3.0
    """Change since the calibration: steel grows by 11.5 µm a metre and degree, and an arm's
    tubes and encoders answer to less."""


DUE = DueLimits()


@dataclass(frozen=True)
class CheckResult:
    """Something that was done, and how it ended."""

    at: str
    result: State
    text: Text
    """What it found, in a few words."""


@dataclass(frozen=True)
class ValidityInputs:
    """What the station remembers; None where a thing was never done."""

    calibration: CheckResult | None
    """Due: camera and mounting alone are calibrated."""
    verification: CheckResult | None
    """The newest verification of that calibration."""
    verified_before: bool
    """Whether an earlier calibration was."""
    tip: CheckResult | None
    arm: CheckResult | None
    warmer_c: float | None
    """Now against the calibration's time; None where one of the two is not known."""
    performance: CheckResult | None = None
    """The newest performance test that has a result."""
    has_joints: bool = True
    """False of an arm that reports poses: its joints and its tip are not checked here."""


@dataclass(frozen=True)
class Validity:
    """One line on a thing that must be valid for measuring."""

    id: CheckName
    title: Text
    state: State
    quality: Quality
    text: Text
    """What it is worth, or why it is due, in one sentence."""
    at: str | None
    page: Page
    action: Text
    """What the button that leads there says."""


@dataclass(frozen=True)
class NextAction:
    """The next action to take."""

    label: Text
    page: Page
    text: Text


QUALITY: dict[State, Quality] = {
    "valid": "good",
    "due": "attention",
    "missing": "neutral",
    "failed": "bad",
    "unsure": "attention",
}


def check_validity(
    known: ValidityInputs, now: datetime, limits: DueLimits = DUE
) -> tuple[Validity, ...]:
    """Every line, the calibration first; what is touched or turned only for an arm with joints."""
    lines = (_calibration(known, now, limits), _verification(known, now, limits))
    if not known.has_joints:
        return lines
    tip_days, tip_action = limits.tip_hours / 24, message("check-tip")
    arm_days, arm_action = limits.arm_days, message("check-arm")
    return (
        *lines,
        _performance(known, now, limits),
        _check_age("tip", message("tip"), known.tip, now, tip_days, tip_action),
        _check_age("arm", message("arm"), known.arm, now, arm_days, arm_action),
    )


def _calibration(known: ValidityInputs, now: datetime, limits: DueLimits) -> Validity:
    def line(state: State, text: Text, at: str | None, action: Text) -> Validity:
        quality = "attention" if state == "missing" else QUALITY[state]
        return Validity(
            "calibration", message("calibration"), state, quality, text, at, "calibrate", action
        )

    result = known.calibration
    again = message("calibrate-again")
    if result is None:
        return line("missing", message("there-no-calibration-use-yet"), None, message("calibrate"))
    if result.result == "failed":
        return line("failed", message("cannot-read", text=result.text), result.at or None, again)
    if result.result == "due":
        return line("due", result.text, result.at, message("add-the-laser"))
    age = age_days(result.at, now)
    limit = duration(limits.calibration_days)
    if age > limits.calibration_days:
        text = message("old-after-days-due", ago=duration(age), limit=limit)
        return line("due", text, result.at, again)
    warmer = known.warmer_c
    largest_change = rounded(limits.temperature_c, "°C")
    if warmer is not None and abs(warmer) > limits.temperature_c:
        text = message(
            "than-when-made-beyond-c-due",
            difference=quantity(abs(warmer), "°C", 1),
            how="warmer" if warmer > 0 else "colder",
            limit=largest_change,
        )
        return line("due", text, result.at, again)
    if warmer is None:
        text = message("old-due-after-days", text=result.text, ago=duration(age), limit=limit)
    else:
        text = message(
            "calibration-age-and-temperature",
            text=result.text,
            ago=duration(age),
            limit=limit,
            change=largest_change,
            now=signed(warmer, "°C", 1),
        )
    return line("valid", text, result.at, again)


def _verification(known: ValidityInputs, now: datetime, limits: DueLimits) -> Validity:
    can_scan = known.calibration is not None and known.calibration.result != "due"

    def line(state: State, text: Text, at: str | None, action: Text) -> Validity:
        quality: Quality = QUALITY[state]
        if state == "missing" and can_scan:
            quality = "attention"
        return Validity(
            "verification", message("verification"), state, quality, text, at, "verify", action
        )

    result = known.verification
    if result is None:
        if not can_scan:
            return line("missing", message("comes-after-calibration"), None, message("verify"))
        never = message("calibration-not-verified-yet")
        before = message("last-verification-older-than-calibration")
        return line("missing", before if known.verified_before else never, None, message("verify"))
    state, text = _judge(result, now, limits.verification_days)
    return line(state, text, result.at, message("verify-again"))


def _performance(known: ValidityInputs, now: datetime, limits: DueLimits) -> Validity:
    def line(state: State, text: Text, at: str | None, action: Text) -> Validity:
        title = message("title-performance-test")
        return Validity(
            "performance", title, state, QUALITY[state], text, at, "performance", action
        )

    result = known.performance
    if result is None:
        return line("missing", message("never-tested"), None, message("test-performance"))
    state, text = _judge(result, now, limits.performance_days)
    return line(state, text, result.at, message("test-performance-again"))


def _judge(result: CheckResult, now: datetime, limit_days: float) -> tuple[State, Text]:
    """The state of something that was judged by limits, and why, in one sentence."""
    age = age_days(result.at, now)
    if result.result == "failed":
        text = message("verification-failed-ago", ago=duration(age), text=result.text)
        return "failed", text
    if result.result == "unsure":
        text = message("verification-undecided-ago", ago=duration(age), text=result.text)
        return "unsure", text
    limit = duration(limit_days)
    if age > limit_days:
        return "due", message("old-after-days-due", ago=duration(age), limit=limit)
    return "valid", message("passed-ago-due-after-days", ago=duration(age), limit=limit)


def _check_age(
    name: Literal["tip", "arm"],
    title: Text,
    result: CheckResult | None,
    now: datetime,
    limit_days: float,
    action: Text,
) -> Validity:
    def line(state: State, text: Text, at: str | None) -> Validity:
        return Validity(name, title, state, QUALITY[state], text, at, "arm", action)

    if result is None:
        return line("missing", message("never-checked"), None)
    age = age_days(result.at, now)
    if result.result == "failed":
        text = message("check-ago-failed", ago=duration(age), text=result.text)
        return line("failed", text, result.at)
    if result.result == "unsure":
        text = message("verification-undecided-ago", ago=duration(age), text=result.text)
        return line("unsure", text, result.at)
    if age > limit_days:
        text = message("checked-ago-after-check-due", ago=duration(age), limit=duration(limit_days))
        return line("due", text, result.at)
    text = message("checked-ago", ago=duration(age), text=result.text)
    return line("valid", text, result.at)


def tip_finding(line: Validity) -> Finding:
    """What an operator who begins to touch should know of the tip."""
    if line.state == "valid":
        return Finding("good", message("tip-says", text=line.text))
    never = line.state == "missing"
    text = message("tip-never-checked") if never else message("tip-says", text=line.text)
    return Finding(line.quality, text, message("check-first-page-arm-tip-takes"))


CONTINUE: dict[Page, tuple[Text, Text]] = {
    "calibrate": (message("go-calibrating"), message("calibration-under-way-go-where-stands")),
    "verify": (message("go-verifying"), message("verification-under-way-go-where-stands")),
    "performance": (message("go-testing"), message("performance-test-under-way-go-where-stands")),
    "arm": (message("go-checking-arm"), message("arm-session-under-way-go-where-stands")),
    "part": (message("go-inspecting"), message("inspection-under-way-go-where-stands")),
    "scan": (message("go-scanning"), message("scan-under-way-go-where-stands")),
}
"""What leads back to what is under way, by its page: the button and the sentence."""


def choose_next_action(
    lines: Sequence[Validity], under_way: Page | None, blocked: Text
) -> NextAction:
    """One sentence and one button.

    Args:
        under_way: the page of a guided session or scan that is in progress; None for none.
        blocked: why the calibration does not fit the devices; empty where it does.
    """
    if under_way is not None:
        label, text = CONTINUE[under_way]
        return NextAction(label, under_way, text)
    line = {one.id: one for one in lines}
    calibration, verification = line["calibration"], line["verification"]
    tip, arm = line.get("tip"), line.get("arm")
    if tip is not None and tip.state == "failed":
        return NextAction(message("check-tip-again"), "arm", tip.text)
    if arm is not None and arm.state == "failed":
        return NextAction(message("check-arm-again"), "arm", arm.text)
    if calibration.state == "missing":
        text = message("calibrate-sensor-arm-touch-object-then")
        if tip is None:  # of an arm that reports poses
            text = message("calibrate-sensor-arm-pictures-of-board")
        return NextAction(message("calibrate"), "calibrate", text)
    if calibration.state == "failed":
        return NextAction(message("calibrate-again"), "calibrate", calibration.text)
    if calibration.state == "due":
        text = message("calibration-due", text=calibration.text)
        return NextAction(calibration.action, "calibrate", text)
    if blocked:
        return NextAction(message("calibrate"), "calibrate", blocked)
    if verification.state == "missing":
        text = message("touch-scan-gauge-takes-two-minutes", text=verification.text)
        return NextAction(verification.action, "verify", text)
    if verification.state != "valid":
        return NextAction(verification.action, "verify", verification.text)
    return NextAction(message("scan"), "scan", message("calibration-valid-verified-scan-part"))


def age_days(at: str, now: datetime) -> float:
    """How long ago; never negative."""
    return max((now - parse_moment(at)).total_seconds() / SECONDS_A_DAY, 0.0)


def duration(days: float) -> Text:
    """A length of time in its largest unit: days, hours or minutes."""
    hours, minutes = days * 24, days * 24 * 60
    if days >= 1.5:
        return message("duration-days", count=round(days))
    if hours >= 1.5:
        return message("duration-hours", count=round(hours))
    if minutes >= 0.99:
        return message("duration-minutes", count=round(minutes))
    return message("less-than-minute")
