"""``crenel design board``: a chessboard or ChArUco board to print."""

from enum import StrEnum
from pathlib import Path
from typing import Annotated

import typer

from crenel.cli.design.block import LARGEST_MM, two_numbers
from crenel.console import AsJson, Language, print_json, report_errors


class BoardKind(StrEnum):
    """What is in its white squares."""

    CHARUCO = "charuco"
    CHESSBOARD = "chessboard"


@report_errors
def board(
    kind: Annotated[BoardKind, typer.Argument(help="With markers, or without.")],
    squares: Annotated[str, typer.Option(help="Columns and rows of squares, as in 11x8.")],
    square: Annotated[
        float, typer.Option(min=0.2, max=LARGEST_MM, help="Width of a square, in mm.")
    ],
    output: Annotated[
        Path, typer.Option("-o", "--output", help="Folder for board.pdf and object.json.")
    ] = Path("board"),
    name: Annotated[str | None, typer.Option(help="Name of the board.")] = None,
    first_id: Annotated[
        int, typer.Option(min=0, help="Of the first marker, where other boards have those before.")
    ] = 0,
    measured_x: Annotated[
        float | None,
        typer.Option(min=1.0, max=LARGEST_MM, help="Width of the printed pattern, in mm."),
    ] = None,
    measured_y: Annotated[
        float | None,
        typer.Option(min=1.0, max=LARGEST_MM, help="Height of the printed pattern, in mm."),
    ] = None,
    measured_sd: Annotated[
        float, typer.Option(min=0.0, max=1e3, help="Standard uncertainty of both, in mm.")
    ] = 0.1,
    page: Annotated[
        str | None,
        typer.Option(
            help="A4 to A0, letter, legal or tabloid; otherwise, the smallest of A4 to A0."
        ),
    ] = None,
    language: Language = "en",
    as_json: AsJson = False,
) -> None:
    """Make a board to print, to scale; or, of a printed one, its file by two measured lengths."""
    from crenel.formats.atomic_write import write_atomically
    from crenel.report.printed.board_pdf import board_pdf, read_page
    from crenel.workflows.design.board_files import (
        board_file,
        both_lengths,
        plan_board,
        scale_print,
    )
    from crenel.workflows.design.design_files import make_folder

    size = two_numbers(squares, "--squares")
    planned = plan_board(
        name or f"{kind.value} {size[0]} x {size[1]}", size, square, kind == "charuco", first_id
    )
    measured = both_lengths(measured_x, measured_y)
    both = scale_print(planned, measured, measured_sd)
    paths = [output / "object.json"]
    if measured is None:
        content = board_pdf(planned, language, read_page(page))
        make_folder(output)
        write_atomically(output / "board.pdf", content)
        paths.append(output / "board.pdf")
    else:
        make_folder(output)
    file = board_file(both.printed)
    file.write(paths[0])
    if as_json:
        print_json({"object": file.fields(), "files": [str(path) for path in paths]})
        return
    for path in paths:
        print(f"{path} written")
