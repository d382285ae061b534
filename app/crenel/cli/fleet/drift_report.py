"""What ``crenel drift`` prints: the level that is taken as right, periods, recordings, and what the
values are too few for."""

from collections.abc import Mapping, Sequence
from typing import TYPE_CHECKING

from crenel.cli.choice import count_words
from crenel.cli.fleet.catalogue import format_moment, plain_fields
from crenel.console import print_figures

if TYPE_CHECKING:
    from crenel.batch.drift import GaugeDrift, GaugeQuantity
    from crenel.fleet.catalogue.entry import CatalogueEntry
    from crenel.fleet.questions import AffectedPeriod, DoubtedRecordings, StationDrift
    from crenel.metrology.dated_changes import ChangedPeriod
    from crenel.metrology.figure_history import FigureHistory, OwnErrorSpread, RightLevel

REASONS = {
    "first": "the first level",
    "most": "that of most values",
    "chosen": "chosen by --right-since",
}


def fields_of_history(station: str, history: "FigureHistory") -> dict[str, object]:
    """The levels of a station, and what is known about them; the periods stand beside."""
    fields = plain_fields(history)
    del fields["periods"]
    return {"station": station, **fields}


def fields_of_measured(drift: "GaugeDrift") -> dict[str, object]:
    """A figure of one station that was measured again."""
    return {
        **fields_of_history(drift.station, drift.history),
        "figures": [plain_fields(one) for one in drift.figures],
        "periods": [
            {
                **plain_fields(one.period),
                "calibration_ids": one.calibration_ids,
                "recordings": [scan.id for scan in one.recordings],
                "possible": [scan.id for scan in one.possible],
            }
            for one in drift.affected
        ],
    }


def print_summary(quantity: str, counts: Sequence[int], periods: int) -> None:
    """How many values were looked at, and what they can show."""
    from crenel.metrology.change_points import LEAST_VALUES

    values, stations = count_words(sum(counts), "value"), count_words(len(counts), "station")
    changes = count_words(periods, "change")
    print(
        f"{quantity}: {values} of {stations}, {changes}. A period is found if it has "
        f"{LEAST_VALUES} values or more."
    )


def print_known(drift: "StationDrift", periods: "Sequence[AffectedPeriod]") -> None:
    """A figure in the catalogue."""
    unit = drift.points[0].unit
    _print_history(drift.station, drift.history, unit)
    for one in periods:
        lines = {
            doubt: [_describe_scan(scan) for scan in recordings]
            for doubt, recordings in (("", one.recordings), ("perhaps ", one.possible))
        }
        _print_period(drift.station, unit, one, one.calibration_ids, lines)


def print_doubted(doubted: "Sequence[DoubtedRecordings]") -> None:
    """What would be affected if calibrations that are perhaps wrong are wrong."""
    for one in doubted:
        count = count_words(len(one.recordings), "recording")
        print(f"{one.station}: if {one.calibration_id} is wrong, {count} would be affected:")
        for scan in one.recordings:
            print(f"  {one.station}/scan/{_describe_scan(scan)}")


def _describe_scan(scan: "CatalogueEntry") -> str:
    return f"{scan.id}  {format_moment(scan.at)}  {scan.label}"


def print_measured(drift: "GaugeDrift", quantity: "GaugeQuantity") -> None:
    """A figure that was measured again."""
    _print_history(drift.station, drift.history, quantity.unit)
    for one in drift.affected:
        lines = {
            doubt: [f"{scan.id}  {format_moment(scan.started_at)}" for scan in scans]
            for doubt, scans in (("", one.recordings), ("perhaps ", one.possible))
        }
        _print_period(drift.station, quantity.unit, one.period, one.calibration_ids, lines)


def _print_history(station: str, history: "FigureHistory", unit: str) -> None:
    """What holds for all periods of a station; nothing if there is nothing to tell."""
    from crenel.metrology.change_points import LEAST_VALUES

    rows = []
    if history.periods and history.right is not None:
        total = sum(one.values for one in history.levels)
        rows.append(("taken as right", _describe_right(history.right, total, unit)))
    if history.periods and history.spread.calibrations > 1:
        rows.append(("spread of calibrations", _describe_spread(history.spread, unit)))
    rows += [
        (
            "perhaps wrong",
            f"{one.calibration_id}, by {one.size:+.2f} {unit}, tests from "
            f"{format_moment(one.since)} to {format_moment(one.until)}: far from the other "
            "calibrations, but not surely",
        )
        for one in history.spread.doubtful
    ]
    rows += [
        (
            "stands out",
            f"{format_moment(one.at)}  {one.value:.2f} {unit}  {one.calibration_id}".rstrip()
            + ("" if number else f"  (fewer than {LEAST_VALUES} together: too few for a period)"),
        )
        for number, one in enumerate(history.standing_out)
    ]
    if rows:
        print_figures(station, rows)


def _describe_right(right: "RightLevel", total: int, unit: str) -> str:
    return (
        f"{right.value:.2f} {unit}, since {format_moment(right.since)}, {right.values} of {total} "
        f"values: {REASONS[right.because]}; --right-since DAY takes another"
    )


def _describe_spread(spread: "OwnErrorSpread", unit: str) -> str:
    if spread.standard_deviation is None:
        return (
            f"not known, by {spread.calibrations} calibrations with so few tests: a change may be "
            "an ordinary error of a calibration"
        )
    return f"{spread.standard_deviation:.2f} {unit} (k = 1), by {spread.calibrations} calibrations"


def _print_period(
    station: str,
    unit: str,
    period: "AffectedPeriod | ChangedPeriod",
    calibration_ids: Sequence[str],
    recordings: Mapping[str, Sequence[str]],
) -> None:
    """A period, and the recordings in it by how sure they are affected."""
    change, ended, first = period.change, period.ended, period.levels[0]
    expanded = 2 * period.standard_uncertainty
    if change is None:
        rows = [("differed from", f"the first value, {format_moment(first.since)}")]
    else:
        rows = [
            ("changed between", f"{format_moment(change.after)} and {format_moment(change.by)}"),
            ("95 %", f"{format_moment(change.earliest)} to {format_moment(change.latest)}"),
        ]
    rows += [
        ("from", f"{period.right_value:.2f} {unit} to {first.value:.2f} {unit}"),
        *(
            ("then", f"{one.value:.2f} {unit}, since {format_moment(one.since)}")
            for one in period.levels[1:]
        ),
        ("by", f"{period.size:+.2f} ± {expanded:.2f} {unit} (k = 2)"),
        ("ends", "lasts" if ended is None else f"until {format_moment(ended.by)}"),
        ("calibrations", ", ".join(calibration_ids) or "none that explains it"),
        *((f"{doubt}affected recordings", str(len(those))) for doubt, those in recordings.items()),
    ]
    print_figures(station, rows)
    for doubt, those in recordings.items():
        for one in those:
            print(f"{doubt}{station}/scan/{one}")
