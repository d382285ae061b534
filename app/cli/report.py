"""The command line's part for reports."""

from pathlib import Path
from typing import Annotated

import typer

from app.console import report_errors


@report_errors
def report(
    folder: Annotated[
        Path, typer.Argument(help="Folder of a calibration, an arm check or a verification.")
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
