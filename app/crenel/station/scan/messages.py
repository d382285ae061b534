"""Why a scan cannot start, and what the operator should know while it runs."""

from collections.abc import Mapping
from typing import Literal

from crenel.errors import OperationError, sentence
from crenel.findings import Finding, Quality
from crenel.formats.recording.completeness import MOST_LEFT_OUT
from crenel.messages.limits import beside_limit
from crenel.messages.message import Text, join, message, quantity
from crenel.metrology.arm.kinematics import Arm
from crenel.metrology.sensor.line_thinning import LINES_AT_A_PLACE
from crenel.station.devices.reading_buffer import reading_size
from crenel.station.devices.rig import Rig
from crenel.station.devices.sensor_device import StationSensor
from crenel.station.scan.pipeline import ScanPipeline
from crenel.station.scan.points import ScanCalibration

# Below these shares there is no finding: a frame now and then does no harm.
REPORT_SHARE = 0.01
BAD: Quality = "bad"
ATTENTION: Quality = "attention"
BEHIND = 0.5
SOME_FRAMES = 10


def start_error(
    calibrations: Mapping[str, ScanCalibration | None], rig: Rig
) -> OperationError | None:
    """Why a scan with these calibrations cannot start on these devices; None when it can.

    ``calibrations``: of each sensor by its name.
    """
    for name, calibration in calibrations.items():
        error = _start_error(calibration, rig, rig.sensors[name])
        if error is not None:
            what = join([name, error.what], ": ") if name else error.what
            return OperationError(error.code, what, error.why, error.remedy)
    return None


def _start_error(
    calibration: ScanCalibration | None, rig: Rig, sensor: StationSensor
) -> OperationError | None:
    if calibration is None:
        return OperationError(
            "no-calibration",
            message("there-no-valid-calibration"),
            message("without-one-pixels-cannot-become-points"),
            message("calibrate-first-within-sentence"),
        )
    return _arm_error(calibration, rig) or _sensor_error(calibration, sensor)


def suspension_text(suspended_s: float) -> Text:
    """That a scan has a gap in which the program was suspended."""
    return message("scan-was-suspended-nothing-recorded", duration=quantity(suspended_s, "s"))


def end_reason(trouble: OperationError | None) -> Text:
    """Why a scan ended before the operator ended it; empty where it did not."""
    if trouble is None:
        return ""
    if trouble.code == "disk-full":
        return message("disk-full-during-scan")
    return message("scan-cut-short", reason=trouble.why or trouble.what)


def _arm_error(calibration: ScanCalibration, rig: Rig) -> OperationError | None:
    info = rig.arm.info
    if info is None or not rig.arm.fresh:
        return _device_lost_error("arm", rig.arm.link().text)
    if (doubt := rig.arm.doubt()) is not None:
        return doubt
    arm = calibration.arm
    if info.reports != arm.reading_kind or reading_size(info) != arm.reading_size:
        return OperationError(
            "wrong-arm",
            message("connected-arm-has-joints", joints=info.joint_count)
            if info.reports == "joints"
            else message("connected-arm-reports-poses"),
            message("calibration-is-for-joints", joints=arm.joint_count)
            if isinstance(arm, Arm)
            else message("calibration-is-for-poses"),
            message("connect-arm-calibrate-one"),
        )
    return _serial_error("arm", info.serial_number, calibration.arm_serial)


def _sensor_error(calibration: ScanCalibration, sensor: StationSensor) -> OperationError | None:
    info = sensor.info
    if info is None or not sensor.fresh:
        return _device_lost_error("sensor", sensor.link().text)
    size = (info.width_px, info.height_px)
    wanted = (calibration.camera.width_px, calibration.camera.height_px)
    if size != wanted:
        return OperationError(
            "wrong-image-size",
            message("sensors-image-has-pixels", width=size[0], height=size[1]),
            message("calibration-is-for-pixels", width=wanted[0], height=wanted[1]),
            message("set-sensor-back-calibrate-again"),
        )
    return _serial_error("sensor", info.serial_number, calibration.sensor_serial)


_Device = Literal["arm", "sensor"]


def _device_lost_error(device: _Device, why: Text) -> OperationError:
    return OperationError(
        f"{device}-lost", message("sends-nothing", device=device), why, message("wait-until-does")
    )


def _serial_error(device: _Device, connected: str, calibrated: str) -> OperationError | None:
    """A device without a serial number cannot contradict the calibration."""
    if connected == calibrated or not connected or not calibrated:
        return None
    return OperationError(
        f"wrong-{device}",
        message("connected-has-serial-number", device=device, serial_number=connected),
        message("calibration-is-for-serial-number", serial_number=calibrated),
        message("connect-calibrate-one", device=device),
    )


def scan_findings(
    pipeline: ScanPipeline,
    rig: Rig,
    running: bool,
    suspended_s: float,
    stopped_because: Text = "",
) -> tuple[Finding, ...]:
    """What is amiss, the gravest first.

    Args:
        suspended_s: for how long the program was suspended during the scan.
        stopped_because: why the station stopped the scan by itself.
    """
    found: list[Finding] = []
    if stopped_because:
        found.append(Finding("bad", stopped_because, message("recorded-data-kept")))
    if pipeline.trouble is not None:
        text = message("scan-stopped", error=pipeline.trouble.text)
        found.append(Finding("bad", text, message("recorded-data-kept")))
    if suspended_s > 0:
        found.append(Finding("attention", suspension_text(suspended_s), message("scan-gap-again")))
    if running:
        found += _live_findings(pipeline, rig)
    else:
        found += _summary_findings(pipeline)
    found += _loss_findings(pipeline)
    return tuple(sorted(found, key=lambda one: one.quality != BAD))


def _live_findings(pipeline: ScanPipeline, rig: Rig) -> list[Finding]:
    found = []
    if not rig.arm.fresh:
        found.append(Finding("bad", rig.arm.link().text, message("scan-goes-when-back")))
    elif (doubt := rig.arm.doubt()) is not None:
        text = message("pictures-left-out", what=doubt.what)
        found.append(Finding("bad", text, sentence(doubt.remedy)))
    sensors = _sensor_findings(rig)
    found += sensors
    if not sensors and pipeline.distance is None and pipeline.counts.frames > SOME_FRAMES:
        remedy = message("bring-part-into-sensors-range-if")
        found.append(Finding("neutral", message("no-laser-line-visible"), remedy))
    found += [*_speed_findings(pipeline), *_still_findings(pipeline)]
    if pipeline.backlog > BEHIND:
        share = 100 * pipeline.backlog
        found.append(
            Finding(
                "attention",
                message("computer-cannot-keep-up", share=quantity(share, "%")),
                message("frames-lost-when-full-scan-more"),
            )
        )
    return found


def _sensor_findings(rig: Rig) -> list[Finding]:
    """Lost sensors, and lasers that are off."""
    found = []
    for name, sensor in rig.sensors.items():
        if not sensor.fresh:
            text, remedy, quality = sensor.link().text, message("scan-goes-when-back"), BAD
        elif sensor.laser.state == "off":
            text, remedy, quality = (
                message("the-laser-is-off"),
                message("switch-stop-scan"),
                ATTENTION,
            )
        else:
            continue
        found.append(Finding(quality, join([name, text], ": ") if name else text, remedy))
    return found


def _speed_findings(pipeline: ScanPipeline) -> list[Finding]:
    """Too fast."""
    now = pipeline.speed.now
    if now is None:
        return []
    if now.too_fast:
        blur, limit = beside_limit(now.blur_mm, now.limit_mm, "mm", 2)
        text = message("too-fast-blur-limit", blur=blur, limit=limit)
        return [Finding("attention", text, message("go-slower-shorten-exposure"))]
    return []


def _still_findings(pipeline: ScanPipeline) -> list[Finding]:
    """That the line stands still and gives no more points."""
    if not pipeline.is_still:
        return []
    text = message("line-stands-still", count=pipeline.frames_still, most=LINES_AT_A_PLACE)
    return [Finding("attention", text, message("move-sensor-or-stop-scan"))]


def _summary_findings(pipeline: ScanPipeline) -> list[Finding]:
    """Findings about a scan once it has ended."""
    counts, found = pipeline.counts, []
    pace = pipeline.speed
    if pace.frames_too_fast > REPORT_SHARE * counts.frames:
        found.append(
            Finding(
                "attention",
                message(
                    "pictures-were-taken-too-fast-up",
                    count=pace.frames_too_fast,
                    total=counts.frames,
                    worst=quantity(pace.worst_mm, "mm", 2),
                ),
                message("go-over-these-places-again-slower"),
            )
        )
    if pipeline.frames_still > REPORT_SHARE * counts.frames:
        found.append(
            Finding(
                "neutral",
                message(
                    "still-lines-left-out",
                    count=pipeline.frames_still,
                    frames=counts.frames,
                    most=LINES_AT_A_PLACE,
                ),
                message("recording-keeps-still-lines"),
            )
        )
    if pipeline.pictures[1]:
        kept, left_out = pipeline.pictures
        found.append(
            Finding(
                "neutral",
                message("pictures-recording-were-left-out", kept=kept, left_out=left_out),
                message("every-stripe-pictures-wait-them"),
            )
        )
    return found


def _loss_findings(pipeline: ScanPipeline) -> list[Finding]:
    counts = pipeline.counts
    arrived = counts.frames + pipeline.lost_frames
    found = []
    if pipeline.lost_frames > REPORT_SHARE * arrived:
        found.append(
            Finding(
                BAD if pipeline.lost_frames > MOST_LEFT_OUT * arrived else ATTENTION,
                message("pictures-were-lost", count=pipeline.lost_frames, total=arrived),
                message("check-sensors-cable-close-other-programs"),
            )
        )
    rejected, newest = pipeline.implausible
    if rejected and newest is not None:
        found.append(
            Finding(
                "attention",
                message("readings-arm-could-true-last", count=rejected, what=newest.what),
                message("nothing-made-them", remedy=newest.remedy),
            )
        )
    left_out = counts.left_out
    if left_out.is_too_much:
        text = sentence(left_out.text)
        found.append(Finding("bad", text, message("scan-incomplete-again")))
    elif left_out.frames > REPORT_SHARE * left_out.of:
        text = message(
            "pictures-came-without-arms-position", count=left_out.frames, total=left_out.of
        )
        remedy = message("they-recording-but-gave-no-points")
        found.append(Finding("attention", text, remedy))
    return found
