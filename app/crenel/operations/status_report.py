"""The report of the station: for its own kiosk screens, and over MQTT for other stations."""

import time
from dataclasses import replace

from crenel.errors import sentence
from crenel.findings import Quality
from crenel.guide.common.validity import Validity
from crenel.guide.common.view import SessionView
from crenel.messages.message import Text, join, message
from crenel.operations.context import Context
from crenel.station.devices.link_state import DeviceState
from crenel.supervision.message_data import LONGEST_TEXT, payload_text
from crenel.supervision.messages import (
    MOST_ALARMS,
    ActivityReport,
    Alarm,
    CalibrationReport,
    DeviceReport,
    StationReport,
    VerificationReport,
)
from crenel.timestamps import utc_now
from crenel.wire.schema import CalibrationSummary, Home


def build_report(context: Context) -> StationReport:
    """The current state of this station."""
    watch, home = context.monitoring, context.bus.latest("home")
    devices = context.rig.devices()
    holder = context.lease.control.holder
    known = home if isinstance(home, Home) else None
    return StationReport(
        station=watch.station,
        instance=watch.instance,
        name=context.station.name,
        version=context.station.version,
        simulated=context.station.simulated,
        address=watch.settings.address,
        at=utc_now(),
        up_s=round(time.monotonic() - watch.started_s, 1),
        devices=(_device("arm", devices.arm), *_cameras(context)),
        laser_on=devices.laser.state == "on",
        laser=devices.laser.state,
        activity=_activity(context),
        calibration=_calibration(known, context.due.calibration_days),
        verification=_verification(known, context),
        alarms=_alarms(context, known),
        temperature_c=_celsius(context, known),
        # readers of earlier versions know no unknown: nothing can be written
        disk_free_gb=round(devices.disk_free_gb or 0.0, 1),
        control=holder.name[:80] if holder else None,
    )


def _cameras(context: Context) -> tuple[DeviceReport, ...]:
    """The only camera, or each with its name.

    The text begins with the name, too: readers of earlier versions know no other place for it.
    """
    found = []
    for name, sensor in context.rig.sensors.items():
        state = sensor.link()
        if not name:
            found.append(_device("camera", state))
            continue
        text = join([name, state.text], ": ")
        found.append(_device("camera", replace(state, text=text), sensor.label or name))
    return tuple(found)


def _device(name: str, state: DeviceState, sensor: str = "") -> DeviceReport:
    return DeviceReport.model_validate(
        {
            "name": name,
            "sensor": sensor[:80],
            # readers of earlier versions know no device that is absent; its text says so
            "state": "connecting" if state.state == "absent" else state.state,
            **payload_text(text=state.text),
            "age_s": None if state.age_s is None else round(max(state.age_s, 0.0), 3),
            "rate_hz": None if state.rate_hz is None else round(state.rate_hz, 1),
            "received": state.received,
            "lost": state.lost,
            "corrupt": state.corrupt,
            "quality": state.quality,
            "lost_lately": state.lately.lost + state.lately.corrupt,
            "received_lately": state.lately.received,
            "stamps": state.stamps,
        }
    )


def _activity(context: Context) -> ActivityReport:
    """The current activity: a scan before a guided session before a job."""
    scan = context.scanner.state()
    numbers = {
        "points": scan.points,
        "rate_points_s": round(scan.rate_points_s),
        "lost_frames": scan.lost_frames,
    }

    def activity(
        kind: str, title: Text, step: int = 0, steps: int = 0, progress: Text = ""
    ) -> ActivityReport:
        texts = payload_text(title=title, progress=progress)
        return ActivityReport.model_validate(
            {"kind": kind, "step": step, "steps": steps, **texts, **numbers}
        )

    if scan.state in ("running", "stopping"):
        return activity(
            "scanning", message("scanning") if scan.state == "running" else message("writing-scan")
        )
    for topic, kind in (
        ("flow", "calibrating"),
        ("verify", "verifying"),
        ("performance", "verifying"),
        ("parts", "verifying"),
        ("arm", "checking_arm"),
    ):
        view = context.bus.latest(topic)
        if isinstance(view, SessionView) and view.running:
            step = next((i for i, one in enumerate(view.steps, 1) if one.id == view.step), 0)
            progress = view.progress.text if view.progress else ""
            if view.busy is not None:
                progress = view.busy.text
            return activity(kind, view.title, step, len(view.steps), progress)
    job = context.jobs.current
    if job is not None:
        return activity("working", job.title, progress=job.text)
    return activity("idle", message("nothing-runs"))


def _celsius(context: Context, home: Home | None) -> float | None:
    """The reading of the thermometer, or a recently entered temperature."""
    if context.monitoring.temperature.there:
        return context.monitoring.temperature.now.celsius
    return home.temperature_c if home else None


def _line(home: Home | None, name: str) -> Validity | None:
    """One of the lines of Home."""
    return next((line for line in home.checks if line.id == name), None) if home else None


def _verification(home: Home | None, context: Context) -> VerificationReport | None:
    """The newest verification of the calibration in use."""
    calibration, line = home.calibration if home else None, _line(home, "verification")
    record = context.store.verifications.newest_for(calibration.id) if calibration else None
    if record is None or line is None:
        return None
    return VerificationReport.model_validate(
        {
            "title": record.figures.gauge[:LONGEST_TEXT],
            "at": record.accepted_at,
            "quality": line.quality,
            **payload_text(text=record.figures.text),
        }
    )


def _calibration(home: Home | None, due_days: float) -> CalibrationReport | None:
    summary: CalibrationSummary | None = home.calibration if home else None
    line = _line(home, "calibration")
    if summary is None or line is None:
        return None
    return CalibrationReport(
        name=summary.name[:LONGEST_TEXT],
        accepted_at=summary.accepted_at,
        age_days=summary.age_days,
        total_um=round(summary.total_um, 3),
        quality=summary.verdict,
        due=line.state == "due",
        due_in_days=round(due_days - summary.age_days, 2),
    )


def _alarms(context: Context, home: Home | None) -> tuple[Alarm, ...]:
    """The present problems, the worst first; each sentence once."""
    alarms: dict[Text, tuple[Quality, Text]] = {}
    for finding in home.findings if home else ():
        if finding.quality in ("bad", "attention"):
            alarms[finding.text] = (finding.quality, finding.remedy)
    for line in home.checks if home else ():
        if line.quality in ("bad", "attention"):
            text = join([line.title, line.text], ": ")
            alarms[text] = (line.quality, sentence(line.action))
    scan = context.scanner.state()
    if scan.state == "running":
        for finding in scan.findings:
            if finding.quality in ("bad", "attention"):
                alarms.setdefault(finding.text, (finding.quality, finding.remedy))
    health = context.monitoring.health
    for item in health.items if health else ():
        # Home reports a lost device, and a missing backup is not an alarm
        is_grave = item.quality == "bad" and not item.id.startswith("device-")
        # the sign of a device shows its losses, too
        if is_grave or (item.quality == "attention" and item.id.startswith("losses-")):
            text = join([item.title, item.what], ": ")
            alarms.setdefault(text, (item.quality, item.remedy))
    ordered = sorted(alarms.items(), key=lambda pair: pair[1][0] != "bad")
    return tuple(
        Alarm.model_validate({"quality": quality, **payload_text(text=text, remedy=remedy)})
        for text, (quality, remedy) in ordered[:MOST_ALARMS]
    )
