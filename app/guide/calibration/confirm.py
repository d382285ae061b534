"""Confirming a step of the guided calibration."""

from app.guide.calibration.flow import HEADINGS
from app.guide.calibration.guide import CalibrationGuide
from app.messages.message import message

CONFIRMATIONS = {
    "confirm_devices": "devices_confirmed",
    "confirm_setup": "setup_confirmed",
    "confirm_touch": "touch_confirmed",
    "confirm_place": "place_confirmed",
    "keep_picture": "capture_kept",
}


def confirm(guide: CalibrationGuide, name: str, key: str | None) -> None:
    """Confirms a step; from the set-up on, the session uses its own datasheet copies."""
    with guide.lock:
        if name == "confirm_setup":
            guide.folder.keep_datasheets(guide.datasheets.library(True), guide.state)
        guide.append(CONFIRMATIONS[name], {}, key)
        guide.station.bus.event("step_done", message("next", title=HEADINGS[guide.state.step]))
