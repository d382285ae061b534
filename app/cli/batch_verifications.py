"""The command line's part for verifications in archives, measured again: ``crenel verify``,
``study`` and ``drift``, which by default asks the catalogue."""

from collections.abc import Mapping, Sequence
from dataclasses import dataclass
from datetime import datetime, timedelta
from pathlib import Path
from typing import TYPE_CHECKING, Annotated, Any

import typer

from app.cli.batch import Tally, do_missing, open_places, output_settings, selection_of
from app.cli.batch_options import ArmFile, BatchOptions, Scheduler, Station, Workers
from app.cli.fleet.catalogue import (
    Since,
    Until,
    format_moment,
    open_catalogue,
    parse_day,
    plain_fields,
)
from app.cli.fleet.questions import Quantity, check_quantity
from app.console import (
    AsJson,
    print_figures,
    print_json,
    print_table,
    progress_bar,
    report_errors,
    warn,
)

if TYPE_CHECKING:
    from app.batch.drift import GaugeDrift, GaugeQuantity
    from app.batch.places import Place
    from app.batch.results import ResultStore
    from app.batch.verifications import VerificationTask
    from app.fleet.questions import AffectedPeriod
    from app.formats.datasheets.gauge import Shape
    from app.metrology.dated_changes import DriftChange

TABLE = "table.csv"
MOST_ROWS = 200
"""Printed; the table in the output has all."""


def measure_places(
    kind: str,
    places: Sequence[str],
    calibrations: Sequence[str],
    arm: Path | None,
    shape: "Shape | None",
    options: BatchOptions,
) -> None:
    """Measures the clouds of all chosen verifications, prints the table and writes it.

    Args:
        kind: ``verify``: with the calibration that was verified; ``study``: with all of the
            station; each with ``calibrations`` instead, if there are any.
    """
    from app.batch.verifications import COLUMNS, table_of, table_text

    done = measure_verifications(kind, places, calibrations, arm, shape, options)
    rows = table_of(done.documents)
    done.results.write_table(TABLE, table_text(rows))
    if options.as_json:
        print_json(
            {
                "made": len(done.tally.done),
                "already_there": done.known,
                "rows": [dict(zip(COLUMNS, row, strict=True)) for row in rows],
                "refused": {name: refusal.error().line for name, refusal in done.tally.refused},
                "output": done.results.settings.place,
            }
        )
    else:
        print_table(f"{len(done.documents)} verifications", COLUMNS, rows[:MOST_ROWS])
        print(f"{len(rows)} rows are in {done.results.settings.place.rstrip('/')}/{TABLE}")
    done.tally.end()


@dataclass(frozen=True)
class MeasuredVerifications:
    """The verifications of some places, measured again."""

    places: "Sequence[Place]"
    documents: "Sequence[tuple[VerificationTask, Mapping[str, Any]]]"
    """Each that was not refused, with the fields of its ``crenel/study`` document."""
    results: "ResultStore"
    known: int
    """That had a result before."""
    tally: Tally


def measure_verifications(
    kind: str,
    places: Sequence[str],
    calibrations: Sequence[str],
    arm: Path | None,
    shape: "Shape | None",
    options: BatchOptions,
) -> MeasuredVerifications:
    """Measures the clouds of all chosen verifications that have no result yet.

    Args:
        kind: as of ``measure_places``, or ``drift``: with the calibration that was verified.
    """
    from app.batch.calibrations import CalibrationFinder, choose_calibration
    from app.batch.results import ResultStore
    from app.batch.verifications import plan_verifications

    if arm is not None and not calibrations:
        raise typer.BadParameter("needs a calibration, too", param_hint="'--arm'")
    found, keys = open_places(places, options.config)
    results = ResultStore(output_settings(options.output, keys, found))
    results.prepare()
    finder = CalibrationFinder(found)
    given = tuple(choose_calibration(one, arm, finder) for one in calibrations)
    with progress_bar("Looking for verifications", not options.as_json) as progress:
        tasks, refused = plan_verifications(
            found,
            selection_of(options.period, options.station, options.taken_with),
            results.settings,
            given or ("all" if kind == "study" else "own"),
            shape,
            progress,
        )
    tally = Tally(refused=refused)
    known = do_missing(
        kind, tasks, results, options.workers, options.scheduler, tally, options.as_json
    )
    refused_names = {name for name, _ in tally.refused}
    documents = [
        (task, read)
        for task in tasks
        if task.name not in refused_names and (read := results.read(task.stem)) is not None
    ]
    return MeasuredVerifications(found, documents, results, known, tally)


MOST_SHOWN = 10
"""Of the verifications without contact points."""


@report_errors
def drift(
    quantity: Quantity,
    places: Annotated[
        list[str] | None,
        typer.Argument(
            metavar="[PLACE]...",
            help="Archives and data folders, whose verifications are measured again. Default: the "
            "results in the catalogue.",
        ),
    ] = None,
    calibration: Annotated[
        str | None,
        typer.Option(
            help="Of places: measure all with this calibration.json, or that of this session. "
            "Default: that which was verified."
        ),
    ] = None,
    arm: ArmFile = None,
    output: Annotated[
        str | None,
        typer.Option(
            "-o", "--output", help="Of places: folder, or address, to which the results go."
        ),
    ] = None,
    station: Station = None,
    since: Since = "",
    until: Until = "",
    workers: Workers = None,
    scheduler: Scheduler = None,
    config: Annotated[
        Path | None,
        typer.Option("--config", help="fleet.toml; of places: station.toml, for its [archive]."),
    ] = None,
    as_json: AsJson = False,
) -> None:
    """Since when a figure changed, with its uncertainty, and which recordings are affected.

    The catalogue has the results as they were found. Of archives and data folders, the clouds of
    all verifications are measured again, also with one calibration for all.
    """
    if places:
        period = _period_text(parse_day(since), parse_day(until))
        options = BatchOptions(
            output or "drift", period, station, None, workers, scheduler, config, as_json
        )
        _show_measured(quantity, places, calibration, arm, options)
        return
    if any(one is not None for one in (calibration, arm, output, workers, scheduler)):
        raise typer.BadParameter("needs archives or data folders, too", param_hint="'PLACE'")
    _show_known(quantity, station or (), parse_day(since), parse_day(until), config, as_json)


def _period_text(since: datetime | None, until: datetime | None) -> str | None:
    """As the other commands' ``--period``, whose last moment belongs to it."""
    if since is None and until is None:
        return None
    last = "" if until is None else (until - timedelta(microseconds=1)).isoformat()
    return f"{'' if since is None else since.isoformat()}..{last}"


def _show_known(
    quantity: str,
    stations: Sequence[str],
    since: datetime | None,
    until: datetime | None,
    config: Path | None,
    as_json: bool,
) -> None:
    """By the results in the catalogue."""
    with open_catalogue(config) as (_, opened), opened.reading() as connection:
        from app.fleet.catalogue.quantities import title_of
        from app.fleet.questions import drift_of, find_affected

        check_quantity(connection, quantity)
        drifts = drift_of(connection, quantity, stations, since, until)
        periods = [one for found in drifts for one in find_affected(connection, found)]
    if as_json:
        print_json({"quantity": quantity, "periods": [plain_fields(one) for one in periods]})
        return
    print(title_of(quantity))
    _print_summary(quantity, [len(found.points) for found in drifts], len(periods))
    units = {found.station: found.points[0].unit for found in drifts}
    for period in periods:
        _print_known(period, units[period.station])


def _print_known(period: "AffectedPeriod", unit: str) -> None:
    lines = {
        doubt: [f"{one.id}  {format_moment(one.at)}  {one.label}" for one in recordings]
        for doubt, recordings in (("", period.recordings), ("perhaps ", period.possible))
    }
    _print_period(period.station, unit, period.change, period.ended, period.calibration_ids, lines)


def _show_measured(
    quantity: str,
    places: Sequence[str],
    calibration: str | None,
    arm: Path | None,
    options: BatchOptions,
) -> None:
    """By verifications that are measured again."""
    from app.batch.drift import figures_of, find_drifts, quantity_of

    chosen = quantity_of(quantity)
    given = () if calibration is None else (calibration,)
    done = measure_verifications("drift", places, given, arm, chosen.shape, options)
    figures, untouched = figures_of(chosen, done.documents)
    with progress_bar("Looking for recordings", not options.as_json) as progress:
        drifts = find_drifts(done.places, figures, progress)
    for name in untouched[:MOST_SHOWN]:
        warn(f"{name}: its gauge was not touched, so that it has no {quantity}")
    if options.as_json:
        print_json(
            {
                "quantity": quantity,
                "made": len(done.tally.done),
                "already_there": done.known,
                "stations": [_fields_of(one) for one in drifts],
                "without_touches": untouched,
                "refused": {name: refusal.error().line for name, refusal in done.tally.refused},
                "output": done.results.settings.place,
            }
        )
    else:
        changes = sum(len(one.affected) for one in drifts)
        _print_summary(quantity, [len(one.figures) for one in drifts], changes)
        for one in drifts:
            _print_measured(one, chosen)
    done.tally.end()


def _fields_of(drift: "GaugeDrift") -> dict[str, object]:
    return {
        "station": drift.station,
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


def _print_measured(drift: "GaugeDrift", quantity: "GaugeQuantity") -> None:
    for one in drift.affected:
        lines = {
            doubt: [f"{scan.id}  {format_moment(scan.started_at)}" for scan in scans]
            for doubt, scans in (("", one.recordings), ("perhaps ", one.possible))
        }
        change, ended = one.period.change, one.period.ended
        _print_period(drift.station, quantity.unit, change, ended, one.calibration_ids, lines)


def _print_summary(quantity: str, counts: Sequence[int], changes: int) -> None:
    print(f"{quantity}: {sum(counts)} values of {len(counts)} stations, {changes} changes.")


def _print_period(
    station: str,
    unit: str,
    change: "DriftChange",
    ended: "DriftChange | None",
    calibration_ids: Sequence[str],
    recordings: dict[str, list[str]],
) -> None:
    """A change, and the recordings behind it by how sure they are affected."""
    expanded = 2 * change.standard_uncertainty
    lasts = "lasts" if ended is None else f"until {format_moment(ended.by)}"
    rows = [
        ("changed between", f"{format_moment(change.after)} and {format_moment(change.by)}"),
        ("95 %", f"{format_moment(change.earliest)} to {format_moment(change.latest)}"),
        ("from", f"{change.before_value:.2f} {unit} to {change.after_value:.2f} {unit}"),
        ("by", f"{change.size:+.2f} ± {expanded:.2f} {unit} (k = 2)"),
        ("ends", lasts),
        ("calibrations", ", ".join(calibration_ids) or "none that explains it"),
        *((f"{doubt}affected recordings", str(len(those))) for doubt, those in recordings.items()),
    ]
    print_figures(station, rows)
    for doubt, those in recordings.items():
        for one in those:
            print(f"{doubt}{station}/scan/{one}")
