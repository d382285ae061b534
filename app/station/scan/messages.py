"""Why a scan cannot start, and what the operator should know while it runs."""

from app.errors import OperationError
from app.findings import Finding, capital
from app.station.devices.rig import Rig
from app.station.scan.pipeline import ScanCalibration, ScanPipeline

# Below these shares nothing is said: a frame now and then does no harm.
REPORT_SHARE = 0.01
BEHIND = 0.5
SOME_FRAMES = 10


def start_error(calibration: ScanCalibration | None, rig: Rig) -> OperationError | None:
    """Why a scan with this calibration cannot start on these devices; None when it can."""
    if calibration is None:
        return OperationError(
            "no-calibration",
            "there is no valid calibration",
            "without one pixels cannot become points",
            "calibrate first",
        )
    return _arm_error(calibration, rig) or _sensor_error(calibration, rig)


def end_reason(trouble: OperationError | None) -> str:
    """Why a scan ended before the operator ended it; empty where it did not."""
    if trouble is None:
        return ""
    if trouble.code == "disk-full":
        return "The disk was full during this scan."
    return f"This scan was cut short: {trouble.why or trouble.what}."


def _arm_error(calibration: ScanCalibration, rig: Rig) -> OperationError | None:
    info = rig.arm.info
    if info is None or not rig.arm.fresh:
        return _device_lost_error("arm", rig.arm.link().text)
    if (doubt := rig.arm.doubt()) is not None:
        return doubt
    if info.joint_count != calibration.arm.joint_count:
        return OperationError(
            "wrong-arm",
            f"the connected arm has {info.joint_count} joints",
            f"the calibration is for one with {calibration.arm.joint_count}",
            "connect that arm, or calibrate with this one",
        )
    return _serial_error("arm", info.serial_number, calibration.arm_serial)


def _sensor_error(calibration: ScanCalibration, rig: Rig) -> OperationError | None:
    info = rig.sensor.info
    if info is None or not rig.sensor.fresh:
        return _device_lost_error("sensor", rig.sensor.link().text)
    size = (info.width_px, info.height_px)
    wanted = (calibration.camera.width_px, calibration.camera.height_px)
    if size != wanted:
        return OperationError(
            "wrong-image-size",
            f"the sensor's image has {size[0]} × {size[1]} pixels",
            f"the calibration is for {wanted[0]} × {wanted[1]}",
            "set the sensor back, or calibrate again",
        )
    return _serial_error("sensor", info.serial_number, calibration.sensor_serial)


def _device_lost_error(device: str, why: str) -> OperationError:
    return OperationError(
        f"{device}-lost", f"the {device} sends nothing", why, "wait until it does"
    )


def _serial_error(device: str, connected: str, calibrated: str) -> OperationError | None:
    """A device that tells no serial number cannot contradict the calibration."""
    if connected == calibrated or not connected or not calibrated:
        return None
    return OperationError(
        f"wrong-{device}",
        f"the connected {device} has the serial number {connected}",
        f"the calibration is for {calibrated}",
        f"connect that {device}, or calibrate with this one",
    )


def scan_findings(pipeline: ScanPipeline, rig: Rig, running: bool) -> tuple[Finding, ...]:
    """What is amiss, the gravest first."""
    found = []
    if pipeline.trouble is not None:
        text = pipeline.trouble.line
        found.append(Finding("bad", f"The scan stopped: {text}", "What was recorded is kept."))
    if running:
        found += _live_findings(pipeline, rig)
    else:
        found += _summary_findings(pipeline)
    return (*found, *_loss_findings(pipeline))


def _live_findings(pipeline: ScanPipeline, rig: Rig) -> list[Finding]:
    found = []
    if not rig.arm.fresh:
        found.append(Finding("bad", rig.arm.link().text, "The scan goes on when it is back."))
    elif (doubt := rig.arm.doubt()) is not None:
        text = f"Pictures are left out: {doubt.what}"
        found.append(Finding("bad", text, f"{capital(doubt.remedy)}."))
    if not rig.sensor.fresh:
        found.append(Finding("bad", rig.sensor.link().text, "The scan goes on when it is back."))
    elif not rig.sensor.laser_on:
        found.append(Finding("attention", "The laser is off", "Switch it on, or stop the scan."))
    elif pipeline.distance_mm is None and pipeline.counts.frames > SOME_FRAMES:
        remedy = "Bring the part into the sensor's range; if it is there, look at the exposure."
        found.append(Finding("neutral", "No line is seen", remedy))
    found += _speed_findings(pipeline)
    if pipeline.backlog > BEHIND:
        share = 100 * pipeline.backlog
        found.append(
            Finding(
                "attention",
                f"The computer is behind: its queue is {share:.0f} % full",
                "Frames are lost when it is full; scan more slowly or close other programs.",
            )
        )
    return found


def _speed_findings(pipeline: ScanPipeline) -> list[Finding]:
    """Too fast, or standing."""
    now = pipeline.speed.now
    if now is None:
        return []
    if now.too_fast:
        text = f"Too fast: {now.blur_mm:.2f} mm of blur; the limit is {now.limit_mm:.2f} mm"
        return [Finding("attention", text, "Go slower, or shorten the exposure.")]
    if now.still:
        text = "Standing still: the same points are taken again and again"
        return [Finding("neutral", text, "Move on; the recording keeps them all.")]
    return []


def _summary_findings(pipeline: ScanPipeline) -> list[Finding]:
    """What is told of a scan once it has ended."""
    counts, found = pipeline.counts, []
    pace = pipeline.speed
    if pace.frames_too_fast > REPORT_SHARE * counts.frames:
        found.append(
            Finding(
                "attention",
                f"{pace.frames_too_fast} of {counts.frames} pictures were taken too fast: up to "
                f"{pace.worst_mm:.2f} mm of blur",
                "Go over these places again, slower.",
            )
        )
    if pipeline.pictures[1]:
        kept, left_out = pipeline.pictures
        found.append(
            Finding(
                "neutral",
                f"{kept} pictures are in the recording, {left_out} were left out",
                "Every stripe is in it; pictures wait for them.",
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
                "attention",
                f"{pipeline.lost_frames} of {arrived} pictures were lost",
                "Check the sensor's cable, or close other programs.",
            )
        )
    kept_back, newest = pipeline.implausible
    if kept_back and newest is not None:
        found.append(
            Finding(
                "attention",
                f"{kept_back} readings of the arm could not be true; the last: {newest.what}",
                f"Nothing was made of them. {capital(newest.remedy)}.",
            )
        )
    if counts.frames_without_joints > REPORT_SHARE * counts.frames:
        found.append(
            Finding(
                "attention",
                f"{counts.frames_without_joints} of {counts.frames} pictures came without "
                "the arm's position",
                "They are in the recording, but gave no points; check the arm's cable.",
            )
        )
    return found
