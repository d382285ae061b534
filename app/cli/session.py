"""The command line's part for the folder of a session: calibrated, and reported on."""

import time
from enum import StrEnum
from pathlib import Path
from typing import Annotated

import typer

from app.console import AsJson, print_figures, print_json, progress_bar, report_errors, warn


class Method(StrEnum):
    """How a session is calibrated."""

    JOINT = "joint"
    ONE_POSE = "one-pose"


@report_errors
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
    as_json: AsJson = False,
) -> None:
    """Calibrate from contact points and pictures: camera, laser plane, probe matrix."""
    from app.cli.calibration_table import calibration_summary
    from app.metrology.limits import Limits
    from app.workflows.calibrate import calibrate_session

    began = time.perf_counter()
    with progress_bar("Calibrating", not as_json) as progress:
        document, warnings = calibrate_session(
            session, output, progress, method.value, Limits(good_um, usable_um)
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
    language: Annotated[
        str, typer.Option("--language", help="en, or another language of app/messages.")
    ] = "en",
) -> None:
    """Write the report on a session from its folder alone, as the station serves it."""
    from app.formats.atomic_write import check_output_path, write_atomically
    from app.report.reports import render_report

    check_output_path(output)
    write_atomically(output, render_report(folder, output.suffix, language))
    print(f"{output} written")
