"""``crenel catalogue``: the records of all stations, collected and found."""

from collections.abc import Iterator, Sequence
from contextlib import contextmanager
from datetime import datetime
from pathlib import Path
from typing import TYPE_CHECKING, Annotated

import typer

from crenel.cli.choice import check_stations, count_words
from crenel.console import (
    AsJson,
    FullHelpGroup,
    fail,
    fail_if_left_out,
    print_figures,
    print_json,
    print_table,
    report_errors,
    warn,
)
from crenel.messages.uncertainty import uncertainty_decimals

if TYPE_CHECKING:
    from sqlalchemy import Connection

    from crenel.fleet.catalogue.catalogue import FleetCatalogue
    from crenel.fleet.fleet_settings import FleetSettings

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
    from crenel.fleet.collection.collector import collect as collect_all

    with open_catalogue(config) as (settings, opened):
        stations = settings.list_stations()
        result = collect_all(opened, stations, complete)
    are = "is" if result.new == 1 else "are"
    print(f"{count_words(result.new, 'record')} {are} new in {opened.place}.")
    for station, problem in result.problems.items():
        warn(f"{station}: {problem.line}")
    fail_if_left_out(
        len(result.problems),
        len(stations) + (result.new > 0),
        "no record could be collected; the next time tries again.",
        "not every record could be collected; the next time continues with these.",
    )


@catalogue.command()
@report_errors
def status(config: Config = None, as_json: AsJson = False) -> None:
    """List the stations with their records, and when they were collected."""
    from dataclasses import asdict

    from crenel.fleet.catalogue.reading import summarise_stations

    with open_catalogue(config) as (_, opened), opened.reading() as connection:
        stations = summarise_stations(connection)
    if as_json:
        listed = [{**asdict(one), **_moments(one.collected_at, one.newest_at)} for one in stations]
        print_json({"place": opened.place, "stations": listed})
        return
    columns = ("station", "records", "archived", "size", "newest", "collected", "problem")
    rows = [
        (
            one.id,
            str(one.records),
            str(one.archived),
            _size(one.size_bytes),
            format_moment(one.newest_at),
            format_moment(one.collected_at),
            one.problem,
        )
        for one in stations
    ]
    print_table(opened.place, columns, rows)


def _size(count: int) -> str:
    return f"{count / 1e6:.1f} MB" if count < 1e9 else f"{count / 1e9:.1f} GB"


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
    from crenel.fleet.catalogue.reading import SearchQuery
    from crenel.fleet.catalogue.reading import search as search_all

    check_kind(kind)
    first, last = parse_days(since, until)
    query = SearchQuery(
        text=text, station=station, kind=kind, since=first, until=last, limit=most + 1
    )
    with open_catalogue(config) as (_, opened), opened.reading() as connection:
        check_catalogue_stations(connection, [station] if station else [])
        found = search_all(connection, query)
    more, found = len(found) > most, found[:most]
    if as_json:
        print_json({"more": more, "records": [plain_fields(one.entry) for one in found]})
        return
    if not found:
        print("No record is found.")
        return
    rows = [
        (
            one.entry.station,
            one.entry.kind,
            one.entry.id,
            format_moment(one.entry.at),
            one.entry.label,
            one.entry.verdict,
            one.entry.calibration_id,
        )
        for one in found
    ]
    listed = count_words(len(found), "record")
    print_table(
        f"the newest {listed}; there are more, see --most" if more else listed,
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
    from crenel.fleet.catalogue.reading import read_record

    check_kind(kind)
    with open_catalogue(config) as (_, opened), opened.reading() as connection:
        check_catalogue_stations(connection, [station])
        entry = read_record(connection, station, kind, record_id)
    if entry is None:
        fail(f"the catalogue has no {kind} {record_id} of {station}.")
    if as_json:
        print_json(plain_fields(entry))
        return
    fields = {name: value for name, value in plain_fields(entry).items() if value not in ("", None)}
    rows = [(name, str(value)) for name, value in fields.items() if not isinstance(value, list)]
    print_figures(f"{station}/{kind}/{record_id}", rows)
    if entry.figures:
        figures = [
            (
                one.symbol,
                one.title,
                f"{one.value:g} {one.unit}",
                _uncertainty_text(one.expanded_uncertainty),
                "" if one.limit is None else f"{one.limit:g}",
                one.decision,
            )
            for one in entry.figures
        ]
        print_table(
            "results", ("symbol", "quantity", "value", "U (k = 2)", "limit", "decision"), figures
        )
    files = [(file.path, str(file.bytes), file.sha256) for file in entry.files]
    print_table("files", ("file", "bytes", "SHA-256"), files)


@catalogue.command()
@report_errors
def export(
    folder: Annotated[Path, typer.Argument(help="Folder of the Parquet files.", metavar="FOLDER")],
    config: Config = None,
) -> None:
    """Write the catalogue as Parquet files, for DuckDB and other programs."""
    from crenel.fleet.exports import export_parquet

    with open_catalogue(config) as (_, opened), opened.reading() as connection:
        rows = export_parquet(connection, folder)
    for name, number in rows.items():
        print(f"{folder / name}.parquet: {count_words(number, 'row')}")


@contextmanager
def open_catalogue(config: Path | None) -> "Iterator[tuple[FleetSettings, FleetCatalogue]]":
    """The settings and their catalogue; raises ``OperationError``."""
    from crenel.fleet.catalogue.catalogue import FleetCatalogue
    from crenel.fleet.catalogue.libraries import check_libraries

    check_libraries()  # the settings import places that need them
    from crenel.fleet.fleet_settings import read_fleet_settings

    settings = read_fleet_settings(config)
    with FleetCatalogue(settings.catalogue.url()) as opened:
        yield settings, opened


def plain_fields(value: object) -> dict[str, object]:
    """An entry, or an answer that contains some, as plain values."""
    from pydantic import TypeAdapter

    fields: dict[str, object] = TypeAdapter(type(value)).dump_python(value, mode="json")
    return fields


def parse_day(text: str) -> datetime | None:
    from crenel.timestamps import is_moment, parse_moment

    if not text:
        return None
    if not is_moment(text):
        raise typer.BadParameter(f"{text}: give a day or a moment, as 2026-05-04")
    return parse_moment(text)


def parse_days(since: str, until: str) -> tuple[datetime | None, datetime | None]:
    """Both ends of a period; ends the command if there is nothing between them."""
    first, last = parse_day(since), parse_day(until)
    if first is not None and last is not None and first >= last:
        fail(f"--until {until} is not after --since {since}.")
    return first, last


def check_kind(kind: str) -> None:
    """Ends the command for what is no kind of records; empty is every kind."""
    from crenel.fleet.catalogue.entry import ENTRY_KINDS

    if kind and kind not in ENTRY_KINDS:
        fail(f"there is no kind {kind}; choose one of {', '.join(ENTRY_KINDS)}.")


def check_catalogue_stations(connection: "Connection", stations: Sequence[str]) -> None:
    """Ends the command if the catalogue has no such station."""
    from crenel.fleet.catalogue.reading import summarise_stations

    if stations:
        there = [one.id for one in summarise_stations(connection)]
        check_stations(stations, there, "in the catalogue")


def format_moment(at: datetime | None) -> str:
    return "" if at is None else at.isoformat(" ", "minutes")


def _moments(collected_at: datetime | None, newest_at: datetime | None) -> dict[str, str]:
    return {"collected_at": format_moment(collected_at), "newest_at": format_moment(newest_at)}


def _uncertainty_text(expanded: float | None) -> str:
    return "" if expanded is None else f"{expanded:.{uncertainty_decimals(expanded)}f}"
