"""The command line's part for folders: a session calibrated and reported on, a scan imported."""

import time
from enum import StrEnum
from pathlib import Path
from typing import TYPE_CHECKING, Annotated

import typer

from crenel.cli.line_options import LineOptions, takes_line_options
from crenel.console import (
    SOME_LEFT_OUT,
    AsJson,
    Language,
    fail,
    print_figures,
    print_json,
    progress_bar,
    report_errors,
    warn,
)

if TYPE_CHECKING:
    from crenel.workflows.pictures.import_pictures import ImportedScan

MOST_NAMED = 5
"""Pictures that are named of those without a line."""


class Method(StrEnum):
    """How a session is calibrated."""

    JOINT = "joint"
    ONE_POSE = "one-pose"


@report_errors
@takes_line_options("smoothing")
def calibrate(
    session: Annotated[Path, typer.Argument(help="Folder of a calibration session.")],
    output: Annotated[Path, typer.Option("-o", "--output", help="Where to write it.")] = Path(
        "calibration.json"
    ),
    method: Annotated[
        Method,
        typer.Option(
            help="joint: all poses in one adjustment. one-pose: the article's, by the first pose."
        ),
    ] = Method.JOINT,
    good_um: Annotated[
        float, typer.Option(min=0.0, help="A point known to this (k = 1) is good.")
    ] = 50.0,
    usable_um: Annotated[
        float, typer.Option(min=0.0, help="Beyond this (k = 1) it is not to be used.")
    ] = 150.0,
    without_laser: Annotated[
        bool,
        typer.Option(
            "--without-laser",
            help="Camera and mounting alone, whatever line the pictures of a chessboard show.",
        ),
    ] = False,
    camera_from: Annotated[
        Path | None,
        typer.Option(
            metavar="CALIBRATION",
            help="Keep camera and mounting of this calibration, and add the laser plane.",
        ),
    ] = None,
    *,
    line: LineOptions,
    as_json: AsJson = False,
) -> None:
    """Calibrate from contact points and pictures: camera, laser plane, probe matrix.

    The line is looked for as line.json in the folder says, if there is one, unless options say
    otherwise.
    """
    from crenel.cli.calibration_table import calibration_summary
    from crenel.formats.atomic_write import check_output_path
    from crenel.metrology.limits import Limits
    from crenel.workflows.calibrate import calibrate_session

    if without_laser and camera_from is not None:
        raise typer.BadParameter(
            "--without-laser calibrates no laser plane to add", param_hint="'--camera-from'"
        )
    check_output_path(output, line.files)
    settings = line.settings()
    began = time.perf_counter()
    with progress_bar("Calibrating", not as_json) as progress:
        document, warnings = calibrate_session(
            session,
            output,
            progress,
            method.value,
            Limits(good_um, usable_um),
            "none" if without_laser else "auto",
            camera_from,
            None if settings.is_automatic else settings,
        )
    seconds = time.perf_counter() - began
    for text in warnings:
        warn(text)
    if as_json:
        written = {"file": str(output), "seconds": seconds, "warnings": list(map(str, warnings))}
        print_json({**document.fields(), **written})
        return
    print_figures(f"Calibration of {session}", calibration_summary(document))
    print(f"{output} written in {seconds:.2f} s")


@report_errors
def report(
    folder: Annotated[
        Path,
        typer.Argument(
            help="Folder of a calibration, a check, a verification or a performance test."
        ),
    ],
    output: Annotated[
        Path, typer.Option("-o", "--output", help="Where to write it: .pdf or .html.")
    ] = Path("report.pdf"),
    language: Language = "en",
) -> None:
    """Write the report on a session from its folder alone, as the station serves it."""
    from crenel.formats.atomic_write import check_output_path, write_atomically
    from crenel.report.contents.reports import render_report

    check_output_path(output)
    write_atomically(output, render_report(folder, output.suffix, language))
    print(f"{output} written")


@report_errors
@takes_line_options()
def import_scan(
    folder: Annotated[
        Path,
        typer.Argument(help="Folder with arm.json, sensor.json, images.csv and the pictures."),
    ],
    output: Annotated[
        Path, typer.Option("-o", "--output", metavar="SCAN.mcap", help="The recording to write.")
    ] = Path("scan.mcap"),
    *,
    line: LineOptions,
    as_json: AsJson = False,
) -> None:
    """Make a recording of pictures and poses that another program took.

    Each picture has its pose in images.csv; or the arm's readings over time are in readings.csv,
    and the times of the pictures in images.csv. Commands for recordings take the result: crenel
    reconstruct, study, sync, replay.
    """
    from crenel.formats.atomic_write import check_output_path
    from crenel.formats.session.scan_folder import read_scan_folder
    from crenel.workflows.pictures.import_pictures import import_pictures

    if output.suffix.lower() != ".mcap":
        raise typer.BadParameter(f"'{output}': recordings are written as .mcap", param_hint="'-o'")
    check_output_path(output)
    scan = read_scan_folder(folder)
    sources = [*scan.tables, *(picture.file for picture in scan.pictures)]
    check_output_path(output, [*sources, *line.files])
    settings = line.settings()
    began = time.perf_counter()
    with progress_bar("Importing", not as_json) as progress:
        result = import_pictures(scan, output, folder.resolve().name, settings, progress)
    _show_import(folder, output, result, time.perf_counter() - began, as_json)
    if result.left_out.is_too_much:
        missing = f"{result.left_out.frames} of {result.left_out.of} pictures"
        fail(f"{output} is incomplete: {missing} give no points", SOME_LEFT_OUT)


def _show_import(
    folder: Path, output: Path, result: "ImportedScan", seconds: float, as_json: bool
) -> None:
    """The counts, and the pictures that could not be read or show no line."""
    from crenel.workflows.pictures.extract_stripes import describe_two_lasers

    if as_json:
        print_json(
            {
                "file": str(output),
                "frames": result.frames,
                "points": result.points,
                "seconds_of_scan": result.seconds,
                "without_pose": result.without_pose,
                "along_other_axis": result.along_other_axis,
                "looking_raw": result.looking_raw,
                "two_lines": sum(result.two_lines),
                "without_line": [one.line for one in result.without_line],
                "unreadable": [one.line for one in result.unreadable],
                "seconds": seconds,
            }
        )
        return
    without = len(result.without_line)
    for one in result.unreadable:
        warn(one.line)
    for one in result.without_line[:MOST_NAMED]:
        warn(one.line)
    if without > MOST_NAMED:
        warn(f"{without - MOST_NAMED} more pictures show no line")
    if result.along_other_axis:
        warn(
            f"in {result.along_other_axis} pictures, the line runs along the other axis, so that "
            "most of it is lost. Set stripe_axis in sensor.json to the other axis, and import again"
        )
    if two := describe_two_lasers(result.two_lines):
        warn(two)
    if result.looking_raw:
        warn(
            f"in {result.looking_raw} pictures, the pixels alternate as in a raw picture of a "
            "colour camera, but were measured as grey. Set bayer and laser_wavelength_nm in "
            "sensor.json, and import again"
        )
    if result.without_pose:
        warn(
            f"{result.without_pose} frames give no points: their times are outside the arm's "
            "readings, or in gaps between them"
        )
    lasts = "no times" if result.seconds is None else f"{result.seconds:.3f} s"
    figures = (
        ("frames", f"{result.frames - without} with a line, {without} without"),
        ("pictures left out", str(len(result.unreadable))),
        ("points", f"{result.points:,}".replace(",", " ")),
        ("from the first to the last", lasts),
    )
    print_figures(f"Recording of {folder}", figures)
    print(f"{output} written in {seconds:.2f} s")
