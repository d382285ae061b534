"""What is valid, what is due, and what to do next."""

from collections.abc import Sequence
from datetime import UTC, datetime

from crenel.errors import OperationError, sentence
from crenel.findings import Finding, Quality
from crenel.formats.results.calibration import NO_PLANE
from crenel.guide.arm.guide import ArmGuide
from crenel.guide.arm.view import ArmCheckSummary
from crenel.guide.calibration.preparation import (
    ConnectedDevices,
    PreparationStep,
    list_preparation,
    next_preparation,
)
from crenel.guide.common.validity import (
    CheckResult,
    DueLimits,
    Page,
    State,
    Validity,
    ValidityInputs,
    age_days,
    check_validity,
    choose_next_action,
    tip_finding,
)
from crenel.messages.limits import beside_limit
from crenel.messages.message import Text, join, message, quantity
from crenel.messages.uncertainty import point_quantity
from crenel.operations.context import Context
from crenel.store.calibrations import CalibrationRecord
from crenel.store.session_records import PerformanceRecord
from crenel.wire.schema import CalibrationSummary, Home

PASSING = ("busy", "arm-lost", "sensor-lost")
"""Reasons why a scan cannot start now that a calibration does not fix."""


RESULTS: dict[str, State] = {"pass": "valid", "fail": "failed", "uncertain": "unsure"}


def build_home(context: Context) -> Home:
    """The current home page."""
    record = context.store.calibrations.active(context.rig.selected)
    summary = calibration_summary(record) if record else None
    findings: list[Finding] = []
    links = [("", context.rig.arm.link())]
    links += [(name, one.link()) for name, one in context.rig.sensors.items()]
    for name, link in links:
        if link.state in ("lost", "off"):
            title = join([link.title, name], " ") if name else link.title
            text = join([title, link.text], ": ")
            findings.append(Finding("bad", text, message("check-connection")))
    if len(context.rig.sensors) > 1:
        findings += _sensor_findings(context)
    known = validity_inputs(context, record)
    lines = check_validity(known, datetime.now(UTC), context.due)
    error = context.scanner.why_not() if record is not None else None
    blocked = "" if error is None or error.code in PASSING else error.text
    trouble = context.scanner.trouble
    reading = context.store.temperatures.newest()
    under_way = _page_under_way(context)
    preparation = _preparation(context, lines) if record is None else ()
    action = choose_next_action(lines, under_way, blocked)
    if preparation and under_way is None:
        action = next_preparation(preparation) or action
    return Home(
        context.station,
        summary,
        trouble is not None and trouble.code == NO_PLANE,
        lines,
        preparation,
        None if reading is None else reading.celsius,
        tuple(findings),
        action,
    )


def _preparation(context: Context, lines: Sequence[Validity]) -> tuple[PreparationStep, ...]:
    """What is there for the first calibration; empty after one that is not in use any more."""
    if context.store.calibrations.newest() is not None:
        return ()
    rig, guide = context.rig, context.guide
    devices = ConnectedDevices(
        rig.arm.link(), rig.sensor.link(), guide.describe_arm(), guide.describe_sensor()
    )
    tip = next((line for line in lines if line.id == "tip"), None)
    return list_preparation(devices, context.datasheets.library(), tip)


def _page_under_way(context: Context) -> Page | None:
    """The page of a guided session or scan that is in progress."""
    running: dict[Page, bool] = {
        "calibrate": context.guide.running,
        "arm": context.arm_guide.running and context.arm_guide.state.step != "result",
        "verify": context.verify_guide.running,
        "performance": context.performance_guide.running,
        "part": context.part_guide.running,
        "scan": context.scanner.recording() is not None,
    }
    return next((page for page, runs in running.items() if runs), None)


def _sensor_findings(context: Context) -> list[Finding]:
    """The calibration of each of several sensors."""
    found = []
    for name in context.rig.sensors:
        record = context.store.calibrations.active(name)
        if record is None:
            text = message("sensor-without-calibration", name=name)
            found.append(Finding("attention", text, message("calibrate-this-sensor")))
            continue
        total = point_quantity(record.figures.total_um)
        text = message("sensor-calibrated", name=name, calibration=record.name, total=total)
        found.append(Finding("good", text))
    return found


def validity_inputs(context: Context, record: CalibrationRecord | None) -> ValidityInputs:
    """The stored facts about everything that must be valid."""
    store, arm_guide = context.store, context.arm_guide
    verified = store.verifications.newest_for(record.id) if record else None
    tip, arm = arm_guide.history.last_tip_check(), arm_guide.history.last_check()
    return ValidityInputs(
        calibration=_calibration(record, context.scanner.trouble),
        verification=None
        if verified is None
        else CheckResult(
            verified.accepted_at, RESULTS[verified.figures.result], verified.figures.text
        ),
        verified_before=store.verifications.newest() is not None,
        tip=None if tip is None else CheckResult(tip.at, _state(tip.verdict), tip.text),
        arm=None if arm is None else CheckResult(arm.at, _state(arm.verdict), _arm_text(arm)),
        performance=_performance(store.performances.newest_judged()),
        warmer_c=None if record is None else store.temperatures.change_since(record.accepted_at),
        has_joints=not (info := context.rig.arm.info) or info.reports == "joints",
    )


def _performance(record: PerformanceRecord | None) -> CheckResult | None:
    if record is None:
        return None
    figures = record.figures
    return CheckResult(record.ended_at, RESULTS[figures.result], figures.text)


def _calibration(
    record: CalibrationRecord | None, trouble: OperationError | None
) -> CheckResult | None:
    at = record.accepted_at if record is not None else ""
    if trouble is not None and trouble.code == NO_PLANE:
        return CheckResult(at, "due", sentence(trouble.what))
    if trouble is not None:
        return CheckResult(at, "failed", trouble.why or trouble.what)
    figures = record.figures if record is not None else None
    if figures is None:
        return None
    total = message("total-k-1", total=point_quantity(figures.total_um))
    return CheckResult(at, "valid", total)


def last_tip_finding(arm_guide: ArmGuide, limits: DueLimits) -> Finding:
    """The result of the last tip check, for a user who is about to probe."""
    tip = arm_guide.history.last_tip_check()
    found = None if tip is None else CheckResult(tip.at, _state(tip.verdict), tip.text)
    known = ValidityInputs(None, None, False, found, None, None)
    lines = check_validity(known, datetime.now(UTC), limits)
    return tip_finding(next(line for line in lines if line.id == "tip"))


def _state(verdict: Quality) -> State:
    """The state of a check: without a limit it is as undecided as one that its uncertainty leaves
    open."""
    if verdict == "good":
        return "valid"
    return "failed" if verdict == "bad" else "unsure"


def _arm_text(check: ArmCheckSummary) -> Text:
    worst_um = max(check.half_range_um)
    if check.limit_um is None:
        return message("arm-check-no-limit", half_range=quantity(worst_um, "µm"))
    half_range, limit = beside_limit(worst_um, check.limit_um, "µm")
    return message("arm-check-with-limit", half_range=half_range, limit=limit)


def calibration_summary(record: CalibrationRecord) -> CalibrationSummary:
    """A calibration as it appears in the list."""
    return CalibrationSummary(
        id=record.id,
        name=record.name,
        accepted_at=record.accepted_at,
        # to the minute
        age_days=round(age_days(record.accepted_at, datetime.now(UTC)), 3),
        total_um=record.figures.total_um,
        verdict=record.figures.verdict,
        active=record.active,
        arm_serial=record.figures.arm_serial,
        sensor_serial=record.figures.sensor_serial,
        object_serial=record.figures.object_serial,
    )
