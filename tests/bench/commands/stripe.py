"""Benches of stripe extraction, also on real pictures."""

from dataclasses import asdict
from functools import partial
from pathlib import Path
from typing import Annotated

import typer

from crenel.console import AsJson, print_json, print_table, progress_bar, report_errors, warn
from tests.bench.commands.group import Shown, bench, measure


@bench.command()
@report_errors
def real(
    folder: Annotated[
        Path,
        typer.Argument(
            help="Folder with boards/SET and lines/SET, as docs/accuracy.md says; or of pictures of"
            " one line."
        ),
    ],
    harder: Annotated[
        bool,
        typer.Option(
            "--harder",
            help="Also measure harder pictures made of each set: scaled, blurred, clipped,"
            " tinted, compressed, cut.",
        ),
    ] = False,
    draw: Annotated[
        Path | None,
        typer.Option(
            help="Also write each picture: points of lines green, false ones yellow, missed red.",
            file_okay=False,
        ),
    ] = None,
    smoothing: Annotated[
        float, typer.Option(metavar="PX", help="Smooth lines along themselves, as crenel extract.")
    ] = 0.0,
    as_json: AsJson = False,
) -> None:
    """Measure real pictures: boards beside OpenCV, laser lines beside three peers.

    Of boards: found, refused, wrong, and the rms of the corners, as python -m tests.bench boards.

    Of lines: the peers are a column-wise centroid, Gauss and parabola, and Steger's ridge. A
    column is agreed where all three have a point within 3 px (a fifth of the line's width where
    that is more), in a run of at least 20 columns and three widths. Missed: agreed columns
    without a point of Crenel. False: points further off than that from the points of all other
    methods, unless these do not agree and half of the point's run is confirmed; beside it, the
    best peer's. Noise: what a quadratic through 21 columns leaves of
    the middle one. Scatter / σ: of repeated frames, observed over stated.

    Of pictures without a line: the share of columns with points.
    """
    _real_pictures(folder, as_json, harder, draw, smoothing)


def _real_pictures(
    folder: Path,
    as_json: bool,
    harder: bool = False,
    draw: Path | None = None,
    smoothing: float = 0.0,
) -> None:
    """Measures real pictures, and prints a table for each kind of set."""
    from crenel.metrology.stripe import StripeSettings
    from tests.bench.metrology import real_boards
    from tests.bench.real import real_pictures

    with progress_bar("Searching", not as_json) as progress:
        settings = StripeSettings(smoothing_px=smoothing)
        found = real_pictures.run(folder, harder, progress, draw, settings)
    if as_json:
        print_json(asdict(found))
        return
    for line in found.unreadable:
        warn(f"left out: {line}")
    if found.boards:
        of_boards = (*real_boards.COLUMNS, *real_boards.COLUMNS_RMS)
        print_table("Chessboards", of_boards, real_boards.table(found.boards))
    for name in found.unknown_boards:
        print(f"{name} has no object.json: its board is not looked for")
    if found.lines:
        of_lines = real_pictures.line_table(found.lines)
        print_table("Laser lines", real_pictures.LINE_COLUMNS, of_lines)
    if found.no_line:
        without = real_pictures.no_line_table(found.no_line)
        print_table("Pictures without a laser line", real_pictures.NO_LINE_COLUMNS, without)


@bench.command()
@report_errors
def extraction(
    frames: Annotated[
        int, typer.Option(min=4, help="Frames of each kind to measure errors on.")
    ] = 12,
    variants: Annotated[
        bool, typer.Option(help="Measure plain frames with every processor variant instead.")
    ] = False,
    against: Annotated[
        Path | None,
        typer.Option(exists=True, help="Python of another checkout to compare rates with."),
    ] = None,
    clipped: Annotated[
        bool, typer.Option(help="Measure frames whose line is partly clipped instead.")
    ] = False,
    as_json: AsJson = False,
) -> None:
    """Measure stripe extraction: speed and error, with OpenCV and numpy for comparison."""
    if variants or against is not None:
        _extraction_paired(against, as_json)
        return
    if clipped:
        _extraction_clipped(as_json)
        return
    from tests.bench.stripe.extraction import run
    from tests.bench.stripe.speed import COLUMNS, table

    shown = Shown("Measuring", "Stripe extraction, 1280 × 1024, one thread", "measures")
    measure(shown, as_json, partial(run, frames), COLUMNS, table)


def _extraction_paired(against: Path | None, as_json: bool) -> None:
    """Prints the rates of every variant, and of another checkout, by turns in one run."""
    from tests.bench.stripe.paired import COLUMNS, run, table

    beside = "" if against is None else " (in brackets: over the other's rate)"
    shown = Shown("Measuring", f"Plain frames, 1280 × 1024, one thread{beside}", "rates")
    measure(shown, as_json, partial(run, against), COLUMNS, table)


def _extraction_clipped(as_json: bool) -> None:
    """Prints the rates and errors where the line is clipped, beside those where it is not."""
    from tests.bench.stripe.clipped import COLUMNS, run, table

    shown = Shown("Measuring", "Lines that are clipped, 1280 × 1024, one thread", "kinds")
    measure(shown, as_json, run, COLUMNS, table)
