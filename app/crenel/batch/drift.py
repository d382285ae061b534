"""``crenel drift`` over archives: figures of all verifications, measured again, and their changes.

With one calibration for all, a change is one of sensor, mount, arm or gauge: the calibrations that
a station used one after the other no longer appear in it.
"""

from collections.abc import Iterable, Mapping, Sequence
from dataclasses import dataclass
from datetime import datetime
from typing import Any

from crenel.batch.period import EARLIEST, LATEST, Period
from crenel.batch.places import Place
from crenel.batch.recordings import ScanRecording, Selection, find_recordings
from crenel.batch.verifications import VerificationTask
from crenel.errors import OperationError
from crenel.gauges.plan.document_gauge import Shape
from crenel.messages.message import message
from crenel.metrology.dated_changes import ChangedPeriod
from crenel.metrology.figure_history import FigureHistory, find_history
from crenel.progress import Progress, no_progress
from crenel.timestamps import parse_moment


@dataclass(frozen=True)
class GaugeQuantity:
    """A figure of a gauge, as the catalogue names it too."""

    name: str
    field: str
    """The field of a row of a ``crenel/study`` document."""
    unit: str
    shape: Shape | None
    """That has it; None: each."""
    needs_touches: bool
    """It is a difference from where the probe found the gauge."""


QUANTITIES = (
    GaugeQuantity("gauge-rms", "rms_um", "µm", None, False),
    GaugeQuantity("gauge-angle", "angle_arcsec", "″", "plane", True),
    GaugeQuantity("gauge-z-error", "z_error_um", "µm", "plane", True),
    GaugeQuantity("gauge-radius-error", "radius_error_um", "µm", "sphere", False),
    GaugeQuantity("gauge-centre-error", "centre_error_um", "µm", "sphere", True),
)


@dataclass(frozen=True)
class DatedFigure:
    """The worst of a verification's clouds, with its sign."""

    at: datetime
    value: float
    verification: str
    calibration_id: str
    """With which it was measured again."""


@dataclass(frozen=True)
class AffectedScans:
    """What was scanned while a figure differed from the level that is taken as right."""

    period: ChangedPeriod
    calibration_ids: tuple[str, ...]
    """Calibrations that explain it, see ``ChangedPeriod``; empty: none does."""
    recordings: tuple[ScanRecording, ...]
    """Surely affected."""
    possible: tuple[ScanRecording, ...]
    """Within the uncertainty of the beginning or the end."""


@dataclass(frozen=True)
class GaugeDrift:
    """A figure of one station over time."""

    station: str
    figures: tuple[DatedFigure, ...]
    history: FigureHistory
    affected: tuple[AffectedScans, ...]


def quantity_of(name: str) -> GaugeQuantity:
    """A figure by its name; raises ``OperationError`` if it cannot be measured again."""
    for one in QUANTITIES:
        if one.name == name:
            return one
    raise OperationError(
        "no-quantity",
        message("batch-no-quantity", quantity=name),
        remedy=message("batch-choose-quantity", names=", ".join(one.name for one in QUANTITIES)),
    )


def figures_of(
    quantity: GaugeQuantity, studies: Iterable[tuple[VerificationTask, Mapping[str, Any]]]
) -> tuple[dict[str, list[DatedFigure]], list[str]]:
    """The figure of each verification, by station and in the order of time.

    Args:
        studies: the fields of ``crenel/study`` documents, each of one calibration.

    Returns:
        The figures; and the names of the verifications whose gauge was not touched, if it has to
        be.
    """
    found: dict[str, list[DatedFigure]] = {}
    untouched: list[str] = []
    for task, study in studies:
        if quantity.needs_touches and not study["against_probe"]:
            untouched.append(task.name)
            continue
        values = [row.get(quantity.field) for row in study["rows"]]
        values = [value for value in values if value is not None]
        if not values:
            continue
        figure = DatedFigure(
            parse_moment(task.taken_at),
            float(max(values, key=abs)),
            task.record.id,
            str(study["calibration_ids"][0]),
        )
        found.setdefault(task.record.place.station, []).append(figure)
    for figures in found.values():
        figures.sort(key=lambda one: (one.at, one.verification))
    return found, untouched


def find_drifts(
    places: Sequence[Place],
    figures: Mapping[str, Sequence[DatedFigure]],
    progress: Progress = no_progress,
    right_since: datetime | None = None,
) -> list[GaugeDrift]:
    """The changes of each station's figures, and the scans that they affect.

    Args:
        right_since: as of ``find_history``.

    Raises:
        OperationError: a place cannot be read.
    """
    found = []
    for station, its in sorted(figures.items()):
        history = find_history(
            [one.at for one in its],
            [one.value for one in its],
            [one.calibration_id for one in its],
            right_since,
        )
        affected = tuple(
            _find_affected(places, station, its, one, progress) for one in history.periods
        )
        found.append(GaugeDrift(station, tuple(its), history, affected))
    return found


def _find_affected(
    places: Sequence[Place],
    station: str,
    figures: Sequence[DatedFigure],
    period: ChangedPeriod,
    progress: Progress,
) -> AffectedScans:
    stations = frozenset({station})
    if ids := period.explaining_calibrations((one.at, one.calibration_id) for one in figures):
        chosen = Selection(stations=stations, taken_with=frozenset(ids))
        return AffectedScans(period, ids, tuple(find_recordings(places, chosen, progress)), ())
    within = Period(period.since or EARLIEST, period.until or LATEST)
    scans = tuple(find_recordings(places, Selection(within, stations), progress))
    sure = tuple(one for one in scans if period.surely_contains(one.started_at))
    rest = tuple(one for one in scans if not period.surely_contains(one.started_at))
    return AffectedScans(period, (), sure, rest)
