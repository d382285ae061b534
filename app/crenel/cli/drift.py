"""``crenel drift``: since when a figure changed, of the catalogue or of places measured again."""

from collections.abc import Sequence
from datetime import datetime, timedelta
from pathlib import Path
from typing import Annotated

import typer

from crenel.cli.batch_options import ArmFile, BatchOptions, Scheduler, Station, Workers
from crenel.cli.batch_verifications import measure_verifications
from crenel.cli.fleet.catalogue import (
    Since,
    Until,
    check_catalogue_stations,
    open_catalogue,
    parse_day,
    parse_days,
    plain_fields,
)
from crenel.cli.fleet.drift_report import (
    fields_of_history,
    fields_of_measured,
    print_doubted,
    print_known,
    print_measured,
    print_summary,
)
from crenel.cli.fleet.questions import Quantity, check_quantity
from crenel.console import AsJson, print_json, progress_bar, report_errors, warn

MOST_SHOWN = 10
"""How many verifications without contact points are shown."""


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
    right_since: Annotated[
        str,
        typer.Option(
            "--right-since",
            metavar="DAY",
            help="The level from this day on is right, as after an adjustment. Default: the first "
            "level, or another one with more than three quarters of all values.",
        ),
    ] = "",
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
    span = parse_days(since, until)
    if places:
        period = _period_text(*span)
        options = BatchOptions(
            output or "drift", period, station, None, workers, scheduler, config, as_json
        )
        _show_measured(quantity, places, calibration, arm, parse_day(right_since), options)
        return
    if any(one is not None for one in (calibration, arm, output, workers, scheduler)):
        raise typer.BadParameter("needs archives or data folders, too", param_hint="'PLACE'")
    _show_known(quantity, station or (), span, parse_day(right_since), config, as_json)


def _period_text(since: datetime | None, until: datetime | None) -> str | None:
    """As the other commands' ``--period``, whose last moment belongs to it."""
    if since is None and until is None:
        return None
    last = "" if until is None else (until - timedelta(microseconds=1)).isoformat()
    return f"{'' if since is None else since.isoformat()}..{last}"


def _show_known(
    quantity: str,
    stations: Sequence[str],
    span: tuple[datetime | None, datetime | None],
    right_since: datetime | None,
    config: Path | None,
    as_json: bool,
) -> None:
    """By the results in the catalogue."""
    with open_catalogue(config) as (_, opened), opened.reading() as connection:
        from crenel.fleet.catalogue.quantities import title_of
        from crenel.fleet.questions import drift_of, find_affected, find_doubted

        check_quantity(connection, quantity)
        check_catalogue_stations(connection, stations)
        drifts = drift_of(connection, quantity, stations, *span, right_since)
        periods = [one for found in drifts for one in find_affected(connection, found)]
        doubted = [one for found in drifts for one in find_doubted(connection, found)]
    if as_json:
        print_json(
            {
                "quantity": quantity,
                "stations": [fields_of_history(one.station, one.history) for one in drifts],
                "periods": [plain_fields(one) for one in periods],
                "doubted": [plain_fields(one) for one in doubted],
            }
        )
        return
    print(title_of(quantity))
    print_summary(quantity, [len(found.points) for found in drifts], len(periods))
    for found in drifts:
        its = [one for one in periods if one.station == found.station]
        print_known(found, its)
        print_doubted([one for one in doubted if one.station == found.station])


def _show_measured(
    quantity: str,
    places: Sequence[str],
    calibration: str | None,
    arm: Path | None,
    right_since: datetime | None,
    options: BatchOptions,
) -> None:
    """By verifications that are measured again."""
    from crenel.batch.drift import figures_of, find_drifts, quantity_of

    chosen = quantity_of(quantity)
    given = () if calibration is None else (calibration,)
    done = measure_verifications("drift", places, given, arm, chosen.shape, options)
    figures, untouched = figures_of(chosen, done.documents)
    with progress_bar("Looking for recordings", not options.as_json) as progress:
        drifts = find_drifts(done.places, figures, progress, right_since)
    for name in untouched[:MOST_SHOWN]:
        warn(f"{name}: its gauge was not touched, so that it has no {quantity}")
    if options.as_json:
        print_json(
            {
                "quantity": quantity,
                "made": len(done.tally.done),
                "already_there": done.known,
                "stations": [fields_of_measured(one) for one in drifts],
                "without_touches": untouched,
                "refused": {name: refusal.error().line for name, refusal in done.tally.refused},
                "output": done.results.settings.place,
            }
        )
    else:
        changes = sum(len(one.affected) for one in drifts)
        print_summary(quantity, [len(one.figures) for one in drifts], changes)
        for one in drifts:
            print_measured(one, chosen)
    done.tally.end(done.known)
