"""The questions that ``crenel catalogue`` answers: ageing, spread, calibration of a part."""

from typing import TYPE_CHECKING, Annotated

import typer

from crenel.cli.choice import count_words
from crenel.cli.fleet.catalogue import (
    Config,
    Since,
    Station,
    Until,
    catalogue,
    check_catalogue_stations,
    format_moment,
    open_catalogue,
    parse_days,
    plain_fields,
)
from crenel.console import AsJson, fail, print_json, print_table, report_errors

if TYPE_CHECKING:
    from sqlalchemy import Connection

    from crenel.metrology.common_slope import CommonSlope

Quantity = Annotated[
    str, typer.Argument(help="As in the results of a record, for example location-scan.")
]


@catalogue.command()
@report_errors
def calibration(
    text: Annotated[str, typer.Argument(help="Words of the scan, or their beginnings: its part.")],
    station: Station = "",
    config: Config = None,
    as_json: AsJson = False,
) -> None:
    """Which calibration was in use when a part was scanned, and which is the newest."""
    from crenel.fleet.questions import find_calibrations

    with open_catalogue(config) as (_, opened), opened.reading() as connection:
        check_catalogue_stations(connection, [station] if station else [])
        found = find_calibrations(connection, text, station)
    if as_json:
        print_json({"recordings": [plain_fields(one) for one in found]})
        return
    if not found:
        print("No scan is found.")
        return
    rows = [
        (
            f"{one.recording.station}/scan/{one.recording.id}",
            one.recording.label,
            format_moment(one.recording.at),
            one.recording.calibration_id,
            "unknown" if one.calibration is None else format_moment(one.calibration.at),
            "" if one.calibration is None else one.calibration.verdict,
            "" if one.newest is None else one.newest.id,
        )
        for one in found
    ]
    columns = ("recording", "label", "time", "calibration", "accepted", "verdict", "newest")
    print_table(count_words(len(found), "recording"), columns, rows)


@catalogue.command()
@report_errors
def spread(
    quantity: Quantity, station: Station = "", config: Config = None, as_json: AsJson = False
) -> None:
    """How much a figure differs between all calibrations of each sensor."""
    from crenel.fleet.ageing import spread_of
    from crenel.fleet.catalogue.quantities import title_of

    with open_catalogue(config) as (_, opened), opened.reading() as connection:
        check_quantity(connection, quantity)
        check_catalogue_stations(connection, [station] if station else [])
        found = spread_of(connection, quantity, [station] if station else [])
    if as_json:
        print_json({"quantity": quantity, "sensors": [plain_fields(one) for one in found]})
        return
    rows = [
        (
            one.station,
            one.sensor_serial,
            str(len(one.values)),
            f"{one.median:.4g} {one.unit}",
            "" if one.standard_deviation is None else f"{one.standard_deviation:.2g} {one.unit}",
            f"{one.values[-1].value:.4g} {one.unit}",
            format_moment(one.values[-1].at),
        )
        for one in found
    ]
    columns = ("station", "sensor", "calibrations", "median", "standard deviation", "newest", "of")
    print_table(str(title_of(quantity)), columns, rows)


@catalogue.command()
@report_errors
def ageing(
    quantity: Quantity,
    station: Station = "",
    since: Since = "",
    until: Until = "",
    config: Config = None,
    as_json: AsJson = False,
) -> None:
    """How a figure changes with the hours since the calibration, and with the temperature."""
    from crenel.fleet.ageing import ageing_of
    from crenel.fleet.catalogue.quantities import title_of

    chosen = [station] if station else []
    with open_catalogue(config) as (_, opened), opened.reading() as connection:
        check_quantity(connection, quantity)
        check_catalogue_stations(connection, chosen)
        found = ageing_of(connection, quantity, chosen, *parse_days(since, until))
    if as_json:
        print_json({"quantity": quantity, "stations": [plain_fields(one) for one in found]})
        return
    rows = [
        (
            one.station,
            str(len(one.points)),
            str(one.left_out),
            "the first value" if one.since == "first" else "the calibration",
            _slope(one.per_1000_h, f"{one.unit}/1000 h"),
            _slope(one.per_kelvin, f"{one.unit}/K"),
        )
        for one in found
    ]
    columns = ("station", "values", "left out", "hours since", "with hours", "with temperature")
    print_table(f"{title_of(quantity)!s} (95 %)", columns, rows)


def _slope(found: "CommonSlope | None", unit: str) -> str:
    if found is None:
        return "too few values"
    text = f"{found.value:+.3g} ± {found.expanded_uncertainty:.2g} {unit}"
    return text if found.is_significant else f"none shown ({text})"


def check_quantity(connection: "Connection", quantity: str) -> None:
    """Ends the command if the catalogue has no such values."""
    from crenel.fleet.catalogue.reading import quantities

    known = quantities(connection)
    if quantity not in known:
        if not known:
            fail(f"there are no values of {quantity}: the catalogue has no results yet.")
        fail(f"there are no values of {quantity}; choose one of {', '.join(known)}.")
