"""The command line: ``crenel``. Heavy modules are imported by the command that needs them."""

import os
import signal
import sys
from enum import StrEnum
from pathlib import Path
from typing import Annotated, NoReturn

import typer

from crenel.cli.archive import archive
from crenel.cli.arm import articulation, identify, import_arm
from crenel.cli.batch import rebuild
from crenel.cli.batch_options import (
    ArmFile,
    BatchOptions,
    Config,
    EachCalibration,
    PeriodOption,
    Scheduler,
    Station,
    TakenWith,
    Workers,
    name_places,
)
from crenel.cli.design import design
from crenel.cli.drift import drift
from crenel.cli.fleet.catalogue import catalogue
from crenel.cli.pictures import detect, extract
from crenel.cli.scan import reconstruct, replay, study, sync
from crenel.cli.session import calibrate, import_scan, report
from crenel.cli.station import backup, mqtt_schema, password
from crenel.console import (
    AsJson,
    FullHelpGroup,
    print_json,
    print_table,
    progress_bar,
    report_errors,
    warn,
)
from crenel.gauges.command_line import performance
from crenel.gauges.exchange.command_line import certificate
from crenel.parts.cad.command_line import part
from crenel.parts.command_line import align, inspect
from crenel.parts.deviation.command_line import deviate
from crenel.parts.nests.command_line import check_nests

cli = typer.Typer(
    name="crenel",
    cls=FullHelpGroup,
    rich_markup_mode=None,  # Rich would double the time that --help takes
    help="Calibrates a laser stripe sensor on a measuring arm in one step, and scans with it.",
    add_completion=False,
    no_args_is_help=True,
    pretty_exceptions_enable=False,
    context_settings={"help_option_names": ["-h", "--help"]},
)

Host = Annotated[str, typer.Option(help="Address to listen on.")]
Port = Annotated[int, typer.Option(min=0, max=65535, help="Port to listen on; 0: a free one.")]
Open = Annotated[bool, typer.Option("--open/--no-open", help="Open the browser.")]
RootPath = Annotated[
    str,
    typer.Option("--root-path", help="Sub-path under which a proxy offers it, such as /crenel."),
]
DataFolder = Annotated[
    Path | None, typer.Option("--data", help="Data folder of the station.", file_okay=False)
]


class ShapeOption(StrEnum):
    """What a gauge is."""

    PLANE = "plane"
    SPHERE = "sphere"


class UnitOption(StrEnum):
    """The unit of coordinates."""

    MM = "mm"
    M = "m"
    INCH = "inch"


def main() -> None:
    """The entry point of ``crenel``."""
    signal.signal(signal.SIGTERM, _terminate)
    # pydantic would read the metadata of every installed package in search of plugins
    os.environ.setdefault("PYDANTIC_DISABLE_PLUGINS", "__all__")
    cli()


def _terminate(number: int, frame: object) -> NoReturn:
    """Leaves by an exception, so that files under way are removed."""
    sys.exit(128 + number)


def _print_version(wanted: bool) -> None:
    if wanted:
        from crenel.formats.json_document import SOFTWARE

        print(f"{SOFTWARE.name} {SOFTWARE.version}")
        raise typer.Exit


@cli.callback()
def _options(
    version: Annotated[
        bool,
        typer.Option(
            "--version", callback=_print_version, is_eager=True, help="Print the version and exit."
        ),
    ] = False,
) -> None:
    pass


@cli.command()
@report_errors
def demo(
    data: DataFolder = None,
    host: Host = "127.0.0.1",
    port: Port = 8000,
    open_browser: Open = True,
    robot: Annotated[
        bool, typer.Option("--robot", help="A robot carries the sensor, read by RTDE.")
    ] = False,
    gige: Annotated[
        bool, typer.Option("--gige", help="The camera sends its pictures over GigE Vision.")
    ] = False,
    root_path: RootPath = "",
) -> None:
    """Run the whole station on simulated hardware, in the browser."""
    from crenel.server.startup import demo as run_demo

    run_demo(data, host, port, open_browser, robot, gige, root_path)


@cli.command()
@report_errors
def serve(
    config: Annotated[
        Path | None, typer.Option("--config", help="station.toml: drivers and settings.")
    ] = None,
    data: DataFolder = None,
    host: Host = "127.0.0.1",
    port: Port = 8000,
    open_browser: Open = False,
    root_path: RootPath = "",
) -> None:
    """Run the station on real hardware."""
    from crenel.server.startup import serve as run_serve

    run_serve(config, data, host, port, open_browser, root_path)


@cli.command()
@report_errors
def fleet(
    config: Annotated[
        Path | None, typer.Option("--config", help="fleet.toml: database, stations, broker.")
    ] = None,
    host: Host = "127.0.0.1",
    port: Port = 8100,
    open_browser: Open = False,
    root_path: RootPath = "",
) -> None:
    """Serve one page for all stations: search, drift, calibrations, archive state."""
    from crenel.server.fleet.start import serve_fleet

    serve_fleet(config, host, port, open_browser, root_path)


cli.command()(calibrate)


@cli.command()
@report_errors
def verify(
    shape: Annotated[ShapeOption, typer.Argument(help="Shape of the gauge.")],
    given: Annotated[
        list[str],
        typer.Argument(
            metavar="CLOUD... | PLACE...",
            help="Clouds of the gauge, in any format that crenel writes; or archives and data "
            "folders, whose verifications are measured again.",
        ),
    ],
    nominal: Annotated[
        Path | None, typer.Option(help="nominal.json: the true position of the gauge.")
    ] = None,
    output: Annotated[
        str | None,
        typer.Option(
            "-o", "--output", help="Also write the report to this file; of places, their folder."
        ),
    ] = None,
    unit: Annotated[
        UnitOption | None,
        typer.Option(
            help="Of the numbers in the clouds; by default as the file states it (E57: m), else mm."
        ),
    ] = None,
    columns: Annotated[
        str | None,
        typer.Option(
            help="Columns of x, y and z, by name or by number from 1, as in 2,3,4; by default they "
            "are found by their names."
        ),
    ] = None,
    calibration: EachCalibration = None,
    arm: ArmFile = None,
    period: PeriodOption = None,
    station: Station = None,
    taken_with: TakenWith = None,
    workers: Workers = None,
    scheduler: Scheduler = None,
    config: Config = None,
    as_json: AsJson = False,
) -> None:
    """Check clouds of a gauge plane or sphere against its nominal, in arcsec and µm.

    Of archives and data folders: measure the clouds of all their verifications again.
    """
    if name_places(given):
        from crenel.cli.batch_verifications import measure_places

        options = BatchOptions(
            output or "verified", period, station, taken_with, workers, scheduler, config, as_json
        )
        measure_places("verify", given, calibration or (), arm, shape.value, options)
        return
    _verify_files(shape, [Path(one) for one in given], nominal, output, unit, columns, as_json)


def _three_columns(text: str) -> list[str]:
    names = [name.strip() for name in text.split(",")]
    if len(names) != 3 or not all(names):
        raise typer.BadParameter("three columns, separated by commas", param_hint="--columns")
    return names


def _verify_files(
    shape: ShapeOption,
    clouds: list[Path],
    nominal: Path | None,
    report_file: str | None,
    unit: UnitOption | None,
    columns: str | None,
    as_json: bool,
) -> None:
    from crenel.formats.atomic_write import check_output_path
    from crenel.gauges.quick.clouds.evaluate import verify_clouds
    from crenel.gauges.quick.clouds.evaluate_tables import budget_table, report_table

    output = None if report_file is None else Path(report_file)
    if output is not None:
        check_output_path(output, clouds if nominal is None else [*clouds, nominal])
    with progress_bar("Verifying", not as_json) as progress:
        report, warnings = verify_clouds(
            shape.value,
            clouds,
            nominal,
            progress,
            None if unit is None else unit.value,
            None if columns is None else _three_columns(columns),
        )
        if output is not None:
            report.write(output)
    for text in warnings:
        warn(text)
    if as_json:
        print_json({**report.fields(), "warnings": list(map(str, warnings))})
        return
    against = f" against {nominal}" if nominal else ", no nominal given"
    print_table(f"Gauge {shape.value}{against}; ± U (k = 2)", *report_table(report))
    headings, rows = budget_table(report)
    if rows:
        print_table("U is the root of the sum of squares of its parts (k = 2)", headings, rows)
    if output is not None:
        print(f"{output} written")


cli.command()(extract)
cli.command()(detect)
cli.command("import")(import_scan)
cli.command("import-arm")(import_arm)
cli.command()(reconstruct)
cli.command()(inspect)
cli.command()(align)
cli.command("moved")(check_nests)
cli.command()(rebuild)
cli.command()(drift)
catalogue.command()(drift)
cli.command()(sync)
cli.command()(study)
cli.command()(replay)
cli.command()(identify)
cli.command()(articulation)
cli.command()(report)
cli.command()(part)
cli.command()(deviate)
cli.command()(backup)
cli.command()(password)
cli.command()(mqtt_schema)
cli.add_typer(archive, name="archive")
cli.add_typer(catalogue, name="catalogue")
cli.add_typer(performance, name="performance")
cli.add_typer(certificate, name="certificate")
cli.add_typer(design, name="design")
