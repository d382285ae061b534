"""The command line's part for reports."""

from pathlib import Path
from typing import Annotated

import typer

from app.console import refusing


@refusing
def report(
    folder: Annotated[
        Path, typer.Argument(help="Folder of a calibration, an arm check or a verification.")
    ],
    output: Annotated[
        Path, typer.Option("-o", "--output", help="Where to write it: .pdf or .html.")
    ] = Path("report.pdf"),
    language: Annotated[
        str, typer.Option("--language", help="en, or another language of app/strings.")
    ] = "en",
) -> None:
    """Write the report on a session from its folder alone, as the station serves it."""
    from app.formats.atomic_write import checked_target, write_atomically
    from app.report.reports import report_as

    checked_target(output)
    write_atomically(output, report_as(folder, output.suffix, language))
    print(f"{output} written")
