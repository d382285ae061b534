"""``performance_limits.json``: the limits of the station's sensor by its datasheet, for the next
performance test."""

from pathlib import Path
from typing import ClassVar

from crenel.errors import OperationError
from crenel.formats.json_document import Document
from crenel.gauges.plan.document import LimitPart

STATION_LIMITS = "performance_limits.json"


class StationLimits(Document):
    """Limits as they were entered last."""

    FORMAT: ClassVar[str] = "crenel/performance-limits"

    limits: tuple[LimitPart, ...] = ()


def read_station_limits(data_folder: Path) -> tuple[LimitPart, ...]:
    """The limits of the last test; none before the first, or if they cannot be read."""
    try:
        return StationLimits.read(data_folder / STATION_LIMITS).limits
    except OperationError:
        return ()


def write_station_limits(data_folder: Path, limits: tuple[LimitPart, ...]) -> None:
    """Raises ``OperationError`` if they cannot be written."""
    StationLimits(limits=limits).write(data_folder / STATION_LIMITS)
