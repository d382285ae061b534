"""What of a station is valid, what is due and why, and what to do next. Pure."""

from collections.abc import Sequence
from dataclasses import dataclass
from datetime import datetime
from typing import Literal

from app.findings import Finding, Quality, format_signed
from app.timestamps import parse_moment

CheckName = Literal["calibration", "verification", "tip", "arm"]
Page = Literal["home", "calibrate", "verify", "scan", "arm", "records"]
State = Literal["valid", "due", "missing", "failed", "unsure"]
SECONDS_A_DAY = 86400.0


@dataclass(frozen=True)
class DueLimits:
    """When what is done again."""

    calibration_days: float = 30.0
    verification_days: float = 7.0
    arm_days: float = 30.0
    tip_hours: float = 24.0
    temperature_c: float = 3.0
    """Change since the calibration: steel grows by 11.5 µm a metre and degree, and an arm's
    tubes and encoders answer to less."""


DUE = DueLimits()


@dataclass(frozen=True)
class CheckResult:
    """Something that was done, and how it ended."""

    at: str
    result: State
    text: str
    """What it found, in a few words."""


@dataclass(frozen=True)
class ValidityInputs:
    """What the station remembers; None where a thing was never done."""

    calibration: CheckResult | None
    verification: CheckResult | None
    """Of that calibration, the newest."""
    verified_before: bool
    """Whether an earlier calibration was."""
    tip: CheckResult | None
    arm: CheckResult | None
    warmer_c: float | None
    """Now against the calibration's time; None where one of the two is not known."""


@dataclass(frozen=True)
class Validity:
    """One thing that must be in order to measure, in one line."""

    id: CheckName
    title: str
    state: State
    quality: Quality
    text: str
    """What it is worth, or why it is due, in one sentence."""
    at: str | None
    page: Page
    action: str
    """What the button that leads there says."""


@dataclass(frozen=True)
class NextAction:
    """What to do next."""

    label: str
    page: Page
    text: str


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
    """Every line, the calibration first."""
    return (
        _calibration(known, now, limits),
        _verification(known, now, limits),
        _check_age("tip", "Tip", known.tip, now, limits.tip_hours / 24, "Check the tip"),
        _check_age("arm", "Arm", known.arm, now, limits.arm_days, "Check the arm"),
    )


def _calibration(known: ValidityInputs, now: datetime, limits: DueLimits) -> Validity:
    def line(state: State, text: str, at: str | None, action: str) -> Validity:
        quality = "attention" if state == "missing" else QUALITY[state]
        return Validity("calibration", "Calibration", state, quality, text, at, "calibrate", action)

    found = known.calibration
    if found is None:
        return line("missing", "There is no calibration in use yet.", None, "Calibrate")
    if found.result == "failed":
        text = f"It cannot be read: {found.text}"
        return line("failed", text, found.at or None, "Calibrate again")
    old = age_days(found.at, now)
    if old > limits.calibration_days:
        text = f"It is {ago(old)} old; after {limits.calibration_days:g} days it is due."
        return line("due", text, found.at, "Calibrate again")
    warmer = known.warmer_c
    if warmer is not None and abs(warmer) > limits.temperature_c:
        how = "warmer" if warmer > 0 else "colder"
        text = (
            f"It is {abs(warmer):.1f} °C {how} than when it was made; "
            f"beyond {limits.temperature_c:g} °C it is due."
        )
        return line("due", text, found.at, "Calibrate again")
    text = f"{found.text}, {ago(old)} old; due after {limits.calibration_days:g} days."
    if warmer is not None:
        text = (
            f"{text[:-1]}, or beyond {limits.temperature_c:g} °C "
            f"(now {format_signed(warmer, 1)} °C)."
        )
    return line("valid", text, found.at, "Calibrate again")


def _verification(known: ValidityInputs, now: datetime, limits: DueLimits) -> Validity:
    def line(state: State, text: str, at: str | None, action: str) -> Validity:
        quality: Quality = QUALITY[state]
        if state == "missing" and known.calibration is not None:
            quality = "attention"
        return Validity("verification", "Verification", state, quality, text, at, "verify", action)

    found = known.verification
    if found is None:
        if known.calibration is None:
            return line("missing", "It comes after the calibration.", None, "Verify")
        text = "This calibration was not verified yet."
        if known.verified_before:
            text = "The last verification is older than this calibration."
        return line("missing", text, None, "Verify")
    old = age_days(found.at, now)
    if found.result in ("failed", "unsure"):
        words = "It failed" if found.result == "failed" else "It was not decided"
        text = f"{words} {ago(old)} ago: {found.text[:1].lower()}{found.text[1:]}"
        return line(found.result, text, found.at, "Verify again")
    if old > limits.verification_days:
        text = f"It is {ago(old)} old; after {limits.verification_days:g} days it is due."
        return line("due", text, found.at, "Verify again")
    text = f"Passed {ago(old)} ago; due after {limits.verification_days:g} days."
    return line("valid", text, found.at, "Verify again")


def _check_age(
    name: Literal["tip", "arm"],
    title: str,
    found: CheckResult | None,
    now: datetime,
    limit_days: float,
    action: str,
) -> Validity:
    def line(state: State, text: str, at: str | None) -> Validity:
        return Validity(name, title, state, QUALITY[state], text, at, "arm", action)

    if found is None:
        return line("missing", "It was never checked.", None)
    old = age_days(found.at, now)
    if found.result == "failed":
        return line("failed", f"The check {ago(old)} ago failed: {found.text}", found.at)
    if old > limit_days:
        text = f"Checked {ago(old)} ago; after {ago(limit_days)} a check is due."
        return line("due", text, found.at)
    return line("valid", f"Checked {ago(old)} ago: {found.text}", found.at)


def tip_finding(line: Validity) -> Finding:
    """What whoever begins to touch should know of the tip."""
    if line.state == "valid":
        return Finding("good", f"The tip: {line.text[:1].lower()}{line.text[1:]}")
    remedy = "Check it first, on the page of arm and tip; it takes a minute."
    words = {"missing": "The tip was never checked.", "failed": f"The tip: {line.text}"}
    text = words.get(line.state, f"The tip: {line.text[:1].lower()}{line.text[1:]}")
    return Finding(line.quality, text, remedy)


def choose_next_action(
    lines: Sequence[Validity], calibrating: bool, verifying: bool, blocked: str
) -> NextAction:
    """One sentence and one button.

    Args:
        blocked: why the calibration does not fit the devices; empty where it does.
    """
    line = {one.id: one for one in lines}
    calibration, verification = line["calibration"], line["verification"]
    if calibrating:
        text = "A calibration is under way. Go on where it stands."
        return NextAction("Go on calibrating", "calibrate", text)
    if verifying:
        text = "A verification is under way. Go on where it stands."
        return NextAction("Go on verifying", "verify", text)
    for name in ("tip", "arm"):
        if line[name].state == "failed":
            return NextAction(f"{line[name].action} again", "arm", line[name].text)
    if calibration.state == "missing":
        text = "Calibrate the sensor on the arm: touch the object, then take a few pictures."
        return NextAction("Calibrate", "calibrate", text)
    if calibration.state == "failed":
        return NextAction("Calibrate again", "calibrate", calibration.text)
    if calibration.state == "due":
        return NextAction(
            "Calibrate again", "calibrate", f"The calibration is due. {calibration.text}"
        )
    if blocked:
        return NextAction("Calibrate", "calibrate", blocked)
    if verification.state != "valid":
        text = verification.text
        if verification.state == "missing":
            text = f"{text} Touch and scan a gauge: it takes two minutes."
        return NextAction(verification.action, "verify", text)
    return NextAction("Scan", "scan", "The calibration is valid and verified. Scan the part.")


def age_days(at: str, now: datetime) -> float:
    """How long ago; never negative."""
    return max((now - parse_moment(at)).total_seconds() / SECONDS_A_DAY, 0.0)


def ago(days: float) -> str:
    """A length of time as it is said."""
    minutes = days * 24 * 60
    for count, word in ((days, "day"), (days * 24, "hour"), (minutes, "minute")):
        if count >= 1.5 or (word == "minute" and count >= 0.99):
            whole = round(count)
            return f"{whole} {word}{'' if whole == 1 else 's'}"
    return "less than a minute"
