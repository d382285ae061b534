"""What the commands of all sessions on a gauge do and ask alike."""

from typing import Any

from crenel.gauges.session.gauge_session import GaugeLive, GaugeSession
from crenel.messages.message import Text, message

AnySession = GaugeSession[Any, Any, Any, Any]


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
