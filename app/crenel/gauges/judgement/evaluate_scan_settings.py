"""By which settings the scans of a test were extracted: they are declared, and the same in all."""

import json
from collections.abc import Mapping

from crenel.errors import OperationError
from crenel.formats.recording.reader import EXTRACTION, SMOOTHING, Recording
from crenel.gauges.judgement.evaluate_measured_data import ASIDE, RECORDING, MeasuredData
from crenel.messages.message import Text, message, rounded

Settings = Mapping[str, object]
"""What was not automatic."""


def read_scan_settings(data: MeasuredData) -> dict[str, Settings]:
    """By the names of the scans, without those that were put aside or cannot be read."""
    found: dict[str, Settings] = {}
    for path in sorted(data.folder.glob(f"*/{RECORDING}")):
        if ASIDE in path.parent.name:
            continue
        try:
            text = Recording(path, path.stat().st_size).station_metadata().get(EXTRACTION, "")
            settings = json.loads(text or "{}")
        except (OperationError, OSError, ValueError):
            continue  # a scan that counts is refused where it is measured
        found[path.parent.name] = settings if isinstance(settings, dict) else {}
    return found


def find_changed_settings(settings: Mapping[str, Settings]) -> list[Text]:
    """Why scans do not belong together; empty if all had the same settings."""
    names = list(settings)
    others = (name for name in names[1:] if settings[name] != settings[names[0]])
    for name in others:
        return [message("performance-scans-set-otherwise", scan=name, other=names[0])]
    return []


def filter_note(settings: Mapping[str, Settings]) -> Text:
    """What the scans were filtered by before they were recorded; empty if by nothing."""
    first = next(iter(settings.values()), {})
    smoothing_px = first.get(SMOOTHING)
    named = [
        name if isinstance(value, dict) else f"{name} = {value}"
        for name, value in first.items()
        if name != SMOOTHING
    ]
    if isinstance(smoothing_px, float | int) and smoothing_px > 0:
        return message(
            "performance-smoothed",
            smoothing=rounded(smoothing_px, "px"),
            others=", ".join(named) or "none",
        )
    return message("performance-extracted-by", names=", ".join(named)) if named else ""
