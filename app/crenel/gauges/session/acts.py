"""What all sessions on a gauge see of the station, and what their commands do and ask alike."""

from collections.abc import Callable, Mapping
from dataclasses import dataclass
from pathlib import Path
from typing import Any

from crenel.errors import OperationError
from crenel.formats.atomic_write import sync_file, sync_folder
from crenel.formats.io_errors import convert_io_errors
from crenel.gauges.judgement.evaluate_measured_data import RECORDING
from crenel.gauges.session.gauge_session import GaugeSession
from crenel.guide.common.journal import error_payload
from crenel.guide.common.rules import SessionLive
from crenel.messages.message import Text, message
from crenel.metrology.arm.kinematics import AnyArm
from crenel.metrology.arm.strained_pose import Strain
from crenel.station.devices.link_state import DeviceState

AnySession = GaugeSession[Any, Any, Any, Any]


@dataclass(frozen=True, eq=False, kw_only=True)
class GaugeLive(SessionLive):
    """The station as every session on a gauge sees it."""

    active_id: str
    """The calibration in use; empty without one."""
    active_name: str
    arm: AnyArm | None
    arm_link: DeviceState
    sensor_link: DeviceState
    still: bool
    strain: Strain | None
    """Why the pose strains the arm."""
    scan_why_not: Text
    scan_points: int


def touch_at(guide: AnySession, stamp_ns: int) -> None:
    """Takes a touch at the press of a button, unless something is at work."""
    if guide.simulation_running or guide.station.jobs.current is None:
        guide.touch(stamp_ns, None)


def void_touch(guide: AnySession, index: object, key: str | None) -> None:
    """Takes a touch back."""
    guide.append("touch_voided", {"index": index}, key)
    guide.keep_touches()


def restore_touch(guide: AnySession, key: str | None) -> None:
    """Puts the touch back that was taken back last."""
    guide.append("touch_restored", {"index": guide.state.undone[-1]}, key)
    guide.keep_touches()


def is_recording(guide: AnySession, name: str) -> bool:
    """Whether the scanner records into a folder of the session; it may have ended without the
    operator's word, as by Stop, a full disk or a killed server."""
    return bool(guide.station.scanner.recording() == guide.folder / name)


def recording_of(guide: AnySession, name: str) -> Path:
    """The recording in a folder of the session, safe on the disk: a killed process may have left it
    in memory alone.

    Raises:
        OperationError: it cannot be read.
    """
    path = guide.folder / name / RECORDING
    with convert_io_errors(path):
        sync_file(path)
        sync_folder(path.parent)
    return path


def keep_measured(
    guide: AnySession,
    name: str,
    number: int,
    kinds: tuple[str, str],
    measure: Callable[[], tuple[Mapping[str, object], Text]],
) -> None:
    """Measures a scan and keeps what it shows, or why it is of no use.

    Args:
        name: of its folder.
        kinds: of the rows of a scan that was measured, and of one that was refused.
        measure: the row's values, and what is said of them.
    """
    measured, refused = kinds
    try:
        values, text = measure()
    except OperationError as error:
        guide.append(refused, {"number": number, "refused": error_payload(error)})
        guide.station.bus.event("refused", error.text, "attention")
    else:
        guide.append(measured, {"number": number, **values})
        guide.station.bus.event("step_done", text, "good")
    scan_id = f"{guide.folder.name}-{name}"
    guide.station.scanner.forget(scan_id)
    guide.station.scene.close_scan(scan_id)


# -- rules: an empty reason means that it is possible ---------------------------------


def touch_reason(live: GaugeLive) -> Text:
    """Why the arm cannot touch anything now."""
    if live.arm_link.state != "connected":
        return message("arm-says", text=live.arm_link.text)
    if live.arm is not None and live.arm.tip is None:
        return message("arm-without-tip-touches-nothing", name=live.arm.name)
    return "" if live.still else message("hold-the-arm-still")


def redo_reason(state: Any, live: GaugeLive, args: object) -> Text:
    """Why no touch can be put back."""
    return "" if state.undone else message("no-touch-taken-back-since-last")
