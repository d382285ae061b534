"""Benches of a fleet: the catalogue, and the rebuilding of many recordings."""

from functools import partial
from pathlib import Path
from typing import Annotated

import typer

from crenel.console import AsJson, report_errors
from tests.bench.commands.group import Shown, bench, measure


@bench.command()
@report_errors
def catalogue(
    rows: Annotated[int, typer.Option(min=10_000, help="Rows of all tables.")] = 1_000_000,
    stations: Annotated[int, typer.Option(min=10, help="Number of invented stations.")] = 100,
    database: Annotated[
        str, typer.Option(help="Address of an empty catalogue; by default a file of SQLite.")
    ] = "",
    as_json: AsJson = False,
) -> None:
    """Store invented records of many stations in a catalogue, and measure its questions."""
    from crenel.fleet.catalogue.libraries import check_libraries

    check_libraries()
    from tests.bench.fleet.catalogue import COLUMNS, run, table

    shown = Shown("Storing", f"The catalogue of {stations} stations")
    measure(shown, as_json, partial(run, rows, stations, database), COLUMNS, table)


@bench.command()
@report_errors
def batch(
    recordings: Annotated[int, typer.Option(min=2, help="Of all stations together.")] = 200,
    disk: Annotated[
        Path, typer.Option(help="Folder on the disk that is measured.", file_okay=False)
    ] = Path(),
    lost: Annotated[
        bool,
        typer.Option(
            "--lost",
            help="Instead, let stations record into an S3-compatible store (package moto), and "
            "rebuild while a worker, the scheduler and the store are lost.",
        ),
    ] = False,
    stations: Annotated[int, typer.Option(min=1, max=50, help="With --lost.")] = 3,
    seconds: Annotated[
        float, typer.Option(min=0.1, help="With --lost, of each recording; otherwise 5.")
    ] = 5.0,
    away: Annotated[
        float, typer.Option(min=0.0, metavar="S", help="With --lost: the store is away so long.")
    ] = 60.0,
    as_json: AsJson = False,
) -> None:
    """Rebuild copies of a simulated recording by one and two workers, in memory and on a disk."""
    if lost:
        _batch_lost(recordings, disk, stations, seconds, away, as_json)
        return
    from tests.bench.fleet.batch import COLUMNS, run, table

    shown = Shown("Rebuilding", "Many recordings of 5 s", "runs")
    measure(shown, as_json, partial(run, recordings, disk), COLUMNS, table)


@bench.command()
@report_errors
def drift(
    repeats: Annotated[int, typer.Option(min=10, help="Simulated stations of each case.")] = 1000,
    series: Annotated[
        bool, typer.Option("--series", help="Instead, look for changes where there are none.")
    ] = False,
    limits: Annotated[
        bool,
        typer.Option("--limits", help="Instead, compare limits by which a calibration is wrong."),
    ] = False,
    as_json: AsJson = False,
) -> None:
    """Look how often drift accuses healthy recordings, and finds wrong calibrations."""
    from tests.bench.fleet import drift as drifts

    if series:
        columns, rows = drifts.SERIES_COLUMNS, drifts.table_of_series
        shown = Shown("Simulating", "Series without a change, in which one is found", "series")
        measure(shown, as_json, partial(drifts.run_series, repeats), columns, rows)
        return
    if limits:
        shown = Shown("Simulating", "Limits by which a calibration is wrong", "limits")
        run_limits = partial(drifts.run_limits, repeats)
        measure(shown, as_json, run_limits, drifts.LIMIT_COLUMNS, drifts.table_of_limits)
        return
    shown = Shown("Simulating", "Ten calibrations, one a month", "cases")
    run = partial(drifts.run_months, repeats)
    measure(shown, as_json, run, drifts.MONTH_COLUMNS, drifts.table_of_months)


def _batch_lost(
    recordings: int, disk: Path, stations: int, seconds: float, away_s: float, as_json: bool
) -> None:
    """Prints what became of recordings while everything was lost once."""
    from tests.bench.fleet.lost import COLUMNS, LossPlan, run, table

    plan = LossPlan(stations, recordings, seconds, away_s)
    shown = Shown("Losing", "Recordings while a worker, the scheduler and the store are lost")
    measure(shown, as_json, partial(run, plan, disk), COLUMNS, table)
