"""``crenel catalogue``: the records of all stations, collected and found."""

from collections.abc import Iterator, Sequence
from contextlib import contextmanager
from datetime import datetime
from pathlib import Path
from typing import TYPE_CHECKING, Annotated

import typer

from app.console import (
    AsJson,
    FullHelpGroup,
    fail,
    print_figures,
    print_json,
    print_table,
    report_errors,
    warn,
)

if TYPE_CHECKING:
    from app.fleet.catalogue.catalogue import FleetCatalogue
    from app.fleet.fleet_settings import FleetSettings
    from app.fleet.questions import AffectedPeriod, StationDrift

catalogue = typer.Typer(
    cls=FullHelpGroup,
    help="The catalogue of a fleet: what all stations recorded, with its results.",
    no_args_is_help=True,
)
Config = Annotated[
    Path | None, typer.Option("--config", help="fleet.toml: database, stations, broker.")
]
Station = Annotated[str, typer.Option("--station", help="Only of this station.")]
Since = Annotated[str, typer.Option("--since", help="First day or moment, as 2026-05-04.")]
Until = Annotated[str, typer.Option("--until", help="First day or moment that is too late.")]


@catalogue.command()
@report_errors
def collect(
    config: Config = None,
    complete: Annotated[
        bool, typer.Option("--complete", help="Look at records of all ages in the archives.")
    ] = False,
) -> None:
    """Add what the stations recorded since the last time."""
    from app.fleet.collection.collector import collect as collect_all

    with _open_catalogue(config) as (settings, opened):
        result = collect_all(opened, settings.list_stations(), complete)
    print(f"{result.new} records are new in {opened.place}.")
    for station, problem in result.problems.items():
        warn(f"{station}: {problem.line}")
    if result.problems:
        fail("not every record could be collected; the next time continues with these.")


@catalogue.command()
@report_errors
def status(config: Config = None, as_json: AsJson = False) -> None:
    """List the stations with their records, and when they were collected."""
    from dataclasses import asdict

    from app.fleet.catalogue.reading import summarise_stations

    with _open_catalogue(config) as (_, opened), opened.reading() as connection:
        stations = summarise_stations(connection)
    if as_json:
        listed = [{**asdict(one), **_moments(one.collected_at, one.newest_at)} for one in stations]
        print_json({"place": opened.place, "stations": listed})
        return
    columns = ("station", "records", "archived", "GB", "newest", "collected", "problem")
    rows = [
        (
            one.id,
            str(one.records),
            str(one.archived),
            f"{one.size_bytes / 1e9:.1f}",
            _moment(one.newest_at),
            _moment(one.collected_at),
            one.problem,
        )
        for one in stations
    ]
    print_table(opened.place, columns, rows)


@catalogue.command()
@report_errors
def search(
    text: Annotated[
        str, typer.Argument(help="Beginnings of words: part, operator, id, serial number.")
    ] = "",
    station: Station = "",
    kind: Annotated[
        str, typer.Option("--kind", help="scan, calibration, verification, performance and others.")
    ] = "",
    since: Since = "",
    until: Until = "",
    most: Annotated[int, typer.Option("--most", min=1, max=10_000, help="At most so many.")] = 50,
    config: Config = None,
    as_json: AsJson = False,
) -> None:
    """Find records of all stations, newest first."""
    from app.fleet.catalogue.reading import SearchQuery
    from app.fleet.catalogue.reading import search as search_all

    query = SearchQuery(
        text=text,
        station=station,
        kind=kind,
        since=_parse_day(since),
        until=_parse_day(until),
        limit=most,
    )
    with _open_catalogue(config) as (_, opened), opened.reading() as connection:
        found = search_all(connection, query)
    if as_json:
        print_json({"records": [_plain(one.entry) for one in found]})
        return
    rows = [
        (
            one.entry.station,
            one.entry.kind,
            one.entry.id,
            _moment(one.entry.at),
            one.entry.label,
            one.entry.verdict,
            one.entry.calibration_id,
        )
        for one in found
    ]
    print_table(
        f"{len(found)} records",
        ("station", "kind", "id", "time", "label", "verdict", "calibration"),
        rows,
    )


@catalogue.command()
@report_errors
def show(
    station: Annotated[str, typer.Argument(help="As in fleet.toml.", metavar="STATION")],
    kind: Annotated[str, typer.Argument(help="As in the list of records.", metavar="KIND")],
    record_id: Annotated[str, typer.Argument(help="As in the list of records.", metavar="ID")],
    config: Config = None,
    as_json: AsJson = False,
) -> None:
    """Show a record with its results and its files."""
    from app.fleet.catalogue.reading import read_record

    with _open_catalogue(config) as (_, opened), opened.reading() as connection:
        entry = read_record(connection, station, kind, record_id)
    if entry is None:
        fail(f"the catalogue has no {kind} {record_id} of {station}.")
    if as_json:
        print_json(_plain(entry))
        return
    fields = {name: value for name, value in _plain(entry).items() if value not in ("", None)}
    rows = [(name, str(value)) for name, value in fields.items() if not isinstance(value, list)]
    print_figures(f"{station}/{kind}/{record_id}", rows)
    if entry.figures:
        figures = [
            (
                one.symbol,
                f"{one.value:g} {one.unit}",
                "" if one.expanded_uncertainty is None else f"{one.expanded_uncertainty:g}",
                "" if one.limit is None else f"{one.limit:g}",
                one.decision,
            )
            for one in entry.figures
        ]
        print_table("results", ("symbol", "value", "U (k = 2)", "limit", "decision"), figures)
    files = [(file.path, str(file.bytes), file.sha256) for file in entry.files]
    print_table("files", ("file", "bytes", "SHA-256"), files)


@catalogue.command()
@report_errors
def drift(
    quantity: Annotated[
        str, typer.Argument(help="As in the results of a record, for example location-scan.")
    ],
    station: Station = "",
    since: Since = "",
    until: Until = "",
    config: Config = None,
    as_json: AsJson = False,
) -> None:
    """Since when a figure changed, with its uncertainty, and which recordings are affected."""
    from app.fleet.catalogue.reading import quantities
    from app.fleet.questions import drift_of, find_affected

    chosen = [station] if station else []
    with _open_catalogue(config) as (_, opened), opened.reading() as connection:
        known = quantities(connection)
        if quantity not in known:
            fail(f"there are no values of {quantity}; choose one of {', '.join(known) or 'none'}.")
        drifts = drift_of(connection, quantity, chosen, _parse_day(since), _parse_day(until))
        periods = [one for found in drifts for one in find_affected(connection, found)]
    if as_json:
        print_json({"quantity": quantity, "periods": [_plain(one) for one in periods]})
        return
    values = sum(len(found.points) for found in drifts)
    print(f"{quantity}: {values} values of {len(drifts)} stations, {len(periods)} changes.")
    for period in periods:
        _print_period(period, drifts)


def _print_period(period: "AffectedPeriod", drifts: "Sequence[StationDrift]") -> None:
    change = period.change
    unit = next(found.points[0].unit for found in drifts if found.station == period.station)
    expanded = 2 * change.standard_uncertainty
    lasts = "lasts" if period.ended is None else f"until {_moment(period.ended.by)}"
    calibrations = ", ".join(period.calibration_ids)
    rows = [
        ("changed between", f"{_moment(change.after)} and {_moment(change.by)}"),
        ("95 %", f"{_moment(change.earliest)} to {_moment(change.latest)}"),
        ("from", f"{change.before_value:.2f} {unit} to {change.after_value:.2f} {unit}"),
        ("by", f"{change.size:+.2f} ± {expanded:.2f} {unit} (k = 2)"),
        ("ends", lasts),
        ("calibrations", calibrations or "none that explains it"),
        ("affected recordings", str(len(period.recordings))),
        ("perhaps affected", str(len(period.possible))),
    ]
    print_figures(period.station, rows)
    for doubt, recordings in (("", period.recordings), ("perhaps ", period.possible)):
        for one in recordings:
            print(f"{doubt}{one.station}/scan/{one.id}  {_moment(one.at)}  {one.label}")


@catalogue.command()
@report_errors
def calibration(
    text: Annotated[str, typer.Argument(help="Beginnings of words of the scan: its part.")],
    station: Station = "",
    config: Config = None,
    as_json: AsJson = False,
) -> None:
    """Which calibration was in use when a part was scanned, and which is the newest."""
    from app.fleet.questions import find_calibrations

    with _open_catalogue(config) as (_, opened), opened.reading() as connection:
        found = find_calibrations(connection, text, station)
    if as_json:
        print_json({"recordings": [_plain(one) for one in found]})
        return
    rows = [
        (
            f"{one.recording.station}/scan/{one.recording.id}",
            one.recording.label,
            _moment(one.recording.at),
            one.recording.calibration_id,
            "unknown" if one.calibration is None else _moment(one.calibration.at),
            "" if one.calibration is None else one.calibration.verdict,
            "" if one.newest is None else one.newest.id,
        )
        for one in found
    ]
    columns = ("recording", "label", "time", "calibration", "accepted", "verdict", "newest")
    print_table(f"{len(found)} recordings", columns, rows)


@catalogue.command()
@report_errors
def export(
    folder: Annotated[Path, typer.Argument(help="Folder of the Parquet files.", metavar="FOLDER")],
    config: Config = None,
) -> None:
    """Write the catalogue as Parquet files, for DuckDB and other programs."""
    from app.fleet.exports import export_parquet

    with _open_catalogue(config) as (_, opened), opened.reading() as connection:
        rows = export_parquet(connection, folder)
    for name, number in rows.items():
        print(f"{folder / name}.parquet: {number} rows")


@contextmanager
def _open_catalogue(config: Path | None) -> "Iterator[tuple[FleetSettings, FleetCatalogue]]":
    """The settings and their catalogue; raises ``OperationError``."""
    from app.fleet.catalogue.catalogue import FleetCatalogue
    from app.fleet.catalogue.libraries import check_libraries

    check_libraries()  # the settings import places that need them
    from app.fleet.fleet_settings import read_fleet_settings

    settings = read_fleet_settings(config)
    with FleetCatalogue(settings.catalogue.url()) as opened:
        yield settings, opened


def _plain(value: object) -> dict[str, object]:
    """An entry, or an answer that contains some, as plain values."""
    from pydantic import TypeAdapter

    fields: dict[str, object] = TypeAdapter(type(value)).dump_python(value, mode="json")
    return fields


def _parse_day(text: str) -> datetime | None:
    from app.timestamps import is_moment, parse_moment

    if not text:
        return None
    if not is_moment(text):
        raise typer.BadParameter(f"{text}: give a day or a moment, as 2026-05-04")
    return parse_moment(text)


def _moment(at: datetime | None) -> str:
    return "" if at is None else at.isoformat(" ", "minutes")


def _moments(collected_at: datetime | None, newest_at: datetime | None) -> dict[str, str]:
    return {"collected_at": _moment(collected_at), "newest_at": _moment(newest_at)}
