"""``crenel bench``: the tables of docs/accuracy.md, measured on the machine it runs on."""

from collections.abc import Callable, Sequence
from dataclasses import asdict, dataclass
from functools import partial
from pathlib import Path
from typing import Annotated, Any, TypeVar

import typer

from app.console import (
    AsJson,
    FullHelpGroup,
    print_json,
    print_table,
    progress_bar,
    report_errors,
    warn,
)
from app.messages.message import Text
from app.progress import Progress

bench = typer.Typer(
    help="Measure the figures of docs/accuracy.md on this machine.",
    cls=FullHelpGroup,
    rich_markup_mode=None,
    no_args_is_help=True,
)

T = TypeVar("T")


@dataclass(frozen=True)
class Shown:
    """What a measurement is called while it runs, over its table, and in JSON."""

    work: str
    title: str
    key: str = ""
    """Of the list of its results; empty where it has one result, whose fields are the JSON."""


def _measure(
    shown: Shown,
    as_json: bool,
    run: Callable[[Progress], T],
    columns: Sequence[Text],
    table: Callable[[T], Sequence[Sequence[Text]]],
) -> None:
    """Runs a measurement, and prints its results as JSON or as a table."""
    with progress_bar(shown.work, not as_json) as progress:
        results: Any = run(progress)
    if not as_json:
        print_table(shown.title, columns, table(results))
    elif shown.key:
        print_json({shown.key: [asdict(one) for one in results]})
    else:
        print_json(asdict(results))


@bench.command()
@report_errors
def calibration(
    solves: Annotated[int, typer.Option(min=20, help="Simulated solves of each set-up.")] = 200,
    as_json: AsJson = False,
) -> None:
    """Compare the error with the Cramér-Rao bound and the stated uncertainty (Monte Carlo)."""
    from app.bench.metrology.calibration import COLUMNS, run, table

    shown = Shown("Solving", "Calibration against its bound (k = 1, flange frame)", "set_ups")
    _measure(shown, as_json, partial(run, solves), COLUMNS, table)


@bench.command()
@report_errors
def paper(
    arms: Annotated[
        int, typer.Option(min=1, help="Simulated arms, each 250 µm off its model.")
    ] = 5,
    as_json: AsJson = False,
) -> None:
    """Repeat the article's test: one plane, rebuilt with ten calibrations by each method."""
    from app.bench.metrology.repeatability import COLUMNS, run, table

    shown = Shown("Calibrating", "A gauge plane over ten calibrations of one arm", "methods")
    _measure(shown, as_json, partial(run, arms), COLUMNS, table)


@bench.command()
@report_errors
def performance(
    draws: Annotated[int, typer.Option(min=100, help="Draws of white noise.")] = 10_000,
    tests: Annotated[
        int, typer.Option(min=0, help="Simulated tests for the uncertainty of every figure.")
    ] = 200,
    rendered: Annotated[
        bool, typer.Option("--rendered", help="Plant faults on the rendered simulated station.")
    ] = False,
    as_json: AsJson = False,
) -> None:
    """Check the figures of performance tests against expectations and planted faults."""
    if rendered:
        from app.bench.metrology import rendered_faults as faults

        shown = Shown("Rendering", "Faults of the simulated station, µm", "faults")
        _measure(shown, as_json, faults.run, faults.COLUMNS, faults.table)
        return
    from app.bench.metrology.performance import COLUMNS, run, table

    shown = Shown("Drawing", "Figures of performance tests, µm", "figures")
    _measure(shown, as_json, partial(run, draws, tests), COLUMNS, table)


@bench.command()
@report_errors
def detection(
    images: Annotated[int, typer.Option(min=1, help="Pictures to render and search.")] = 300,
    seed: Annotated[int, typer.Option(help="Seed of the first picture.")] = 0,
) -> None:
    """Test the detection of the object in spoilt pictures: right, refused or wrong."""
    from app.bench.metrology.detection import run

    with progress_bar("Searching", True) as progress:
        found = run(images, seed, lambda done, of: progress(done / of, f"{done} of {of} pictures"))
    print("\n".join(found.lines()))


@bench.command()
@report_errors
def boards(
    folder: Annotated[
        Path,
        typer.Argument(help="Folder of sets: in each, pictures and the board as object.json."),
    ],
    as_json: AsJson = False,
) -> None:
    """Find chessboards in real pictures, beside both finders of OpenCV."""
    from app.bench.metrology.real_boards import COLUMNS, COLUMNS_RMS, run, table

    shown = Shown("Searching", f"Chessboards in pictures of {folder}", "sets")
    _measure(shown, as_json, partial(run, folder), (*COLUMNS, *COLUMNS_RMS), table)


@bench.command()
@report_errors
def real(
    folder: Annotated[
        Path,
        typer.Argument(
            help="Folder with boards/SET and lines/SET, as docs/accuracy.md says; or of pictures of"
            " one line.",
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

    Of boards: found, refused, wrong, and the rms of the corners, as crenel bench boards.

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
    from app.bench.metrology import real_boards
    from app.bench.real import real_pictures
    from app.metrology.stripe import StripeSettings

    with progress_bar("Searching", not as_json) as progress:
        settings = StripeSettings(smoothing_px=smoothing)
        found = real_pictures.run(folder, harder, progress, draw, settings)
    if as_json:
        print_json(asdict(found))
        return
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
    real: Annotated[
        Path | None, typer.Option(hidden=True, help="The same as crenel bench real FOLDER.")
    ] = None,
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
    if real is not None:
        warn(f"use crenel bench real {real}, which this runs")
        _real_pictures(real, as_json)
        return
    from app.bench.stripe.extraction import run
    from app.bench.stripe.speed import COLUMNS, table

    shown = Shown("Measuring", "Stripe extraction, 1280 × 1024, one thread", "measures")
    _measure(shown, as_json, partial(run, frames), COLUMNS, table)


def _extraction_paired(against: Path | None, as_json: bool) -> None:
    """Prints the rates of every variant, and of another checkout, by turns in one run."""
    from app.bench.stripe.paired import COLUMNS, run, table

    beside = "" if against is None else " (in brackets: over the other's rate)"
    shown = Shown("Measuring", f"Plain frames, 1280 × 1024, one thread{beside}", "rates")
    _measure(shown, as_json, partial(run, against), COLUMNS, table)


def _extraction_clipped(as_json: bool) -> None:
    """Prints the rates and errors where the line is clipped, beside those where it is not."""
    from app.bench.stripe.clipped import COLUMNS, run, table

    shown = Shown("Measuring", "Lines that are clipped, 1280 × 1024, one thread", "kinds")
    _measure(shown, as_json, run, COLUMNS, table)


@bench.command()
@report_errors
def live(
    seconds: Annotated[float, typer.Option(min=1.0, help="Duration of the scan.")] = 60.0,
    profiles_hz: Annotated[float, typer.Option(min=1.0, help="Frames per second.")] = 600.0,
    points: Annotated[int, typer.Option(min=100, help="Points per frame.")] = 2000,
    as_json: AsJson = False,
) -> None:
    """Run the whole station on a fast simulated sensor, recording and watched by viewers."""
    from app.bench.station.live import COLUMNS, run, table
    from hardware.simulator.devices.fast_simulator import FastStationConfig

    station = FastStationConfig(profiles_hz=profiles_hz, width_px=points)
    shown = Shown("Scanning", f"{profiles_hz:.0f} frames a second of {points} points")
    _measure(shown, as_json, partial(run, station, seconds), COLUMNS, table)


@bench.command()
@report_errors
def camera(
    minutes: Annotated[float, typer.Option(min=0.05, help="Duration of the stream.")] = 10.0,
    rate_hz: Annotated[float, typer.Option(min=1.0, help="Pictures per second.")] = 100.0,
    lost_per_mille: Annotated[
        int, typer.Option(min=0, max=999, help="Packets that are lost, of a thousand.")
    ] = 10,
    as_json: AsJson = False,
) -> None:
    """Stream from a simulated GigE Vision camera that loses packets (package aravis-tools)."""
    from app.bench.station.camera import COLUMNS, run, table

    shown = Shown("Streaming", "1280 × 1024 pixels over GigE Vision")
    measure = partial(run, 60.0 * minutes, rate_hz, lost_per_mille)
    _measure(shown, as_json, measure, COLUMNS, table)


@bench.command()
@report_errors
def view(
    million_points: Annotated[float, typer.Option(min=0.1, help="Millions of points.")] = 50.0,
    as_json: AsJson = False,
) -> None:
    """Measure the 3D view after a long scan: a second viewer joins, and the colours change."""
    from app.bench.station.view import COLUMNS, run, table

    shown = Shown("Showing", "The 3D view after a long scan")
    _measure(shown, as_json, partial(run, round(1e6 * million_points)), COLUMNS, table)


@bench.command()
@report_errors
def viewers(
    number: Annotated[int, typer.Option(min=2, help="Number of browsers that watch.")] = 20,
    seconds: Annotated[float, typer.Option(min=4.0, help="Duration of the scan.")] = 30.0,
    as_json: AsJson = False,
) -> None:
    """Measure the age of the state in many browsers during a scan, one of them slow."""
    from app.bench.station.viewers import COLUMNS, run, table
    from hardware.simulator.devices.fast_simulator import FastStationConfig

    station = FastStationConfig(profiles_hz=60.0, width_px=1280)
    shown = Shown("Watching", "A scan of 60 frames a second, watched by many")
    _measure(shown, as_json, partial(run, station, number, seconds), COLUMNS, table)


@bench.command()
@report_errors
def faults(
    only: Annotated[
        list[str] | None,
        typer.Option(help="Only kills, disk, damage, floods or devices. Repeatable."),
    ] = None,
    seed: Annotated[int, typer.Option(help="Seed of the random tests.")] = 0,
    as_json: AsJson = False,
) -> None:
    """Test what is lost when processes are killed, the disk is full, or files or devices fail."""
    from app.bench.faults import devices, everything, row

    kinds = [name for name in only or () if name != devices.KIND]
    with progress_bar("Failing", not as_json) as progress:
        rows = everything.run(kinds, seed, progress) if kinds or not only else []
        failing = devices.run(progress) if not only or devices.KIND in only else []
    if as_json:
        found = {"faults": [asdict(one) for one in rows], "failures": [asdict(f) for f in failing]}
        print_json(found)
        return
    if rows:
        print_table("Faults, and what was lost", row.COLUMNS, row.table(rows))
    if failing:
        print_table("Devices that fail on the way", devices.COLUMNS, devices.table(failing))


@bench.command()
@report_errors
def start(
    against: Annotated[
        Path | None,
        typer.Option(help="Another copy to compare with: its crenel, or a checkout with a .venv."),
    ] = None,
    session: Annotated[
        Path | None,
        typer.Option(help="Folder of a calibration session with a recording to rebuild."),
    ] = None,
    cold: Annotated[int, typer.Option(min=0, help="Rounds with empty caches.")] = 1,
    warm: Annotated[int, typer.Option(min=0, help="Rounds with filled caches.")] = 3,
    busy: Annotated[int, typer.Option(min=0, help="Rounds with a busy process on every core.")] = 3,
    as_json: AsJson = False,
) -> None:
    """Measure the start: first page, calibration, commands; memory and size."""
    from app.bench.station.start import Rounds, columns, run, table
    from app.bench.station.started import find_copy, running_copy

    rounds = Rounds(cold, warm, busy)
    copies = [running_copy(), *([find_copy("against", against)] if against else [])]
    shown = Shown("Starting", "From the start on: median (least–most)", "measures")
    _measure(shown, as_json, partial(run, copies, rounds, session), columns(copies), table)


@bench.command()
@report_errors
def catalogue(
    rows: Annotated[int, typer.Option(min=10_000, help="Rows of all tables.")] = 1_000_000,
    database: Annotated[
        str, typer.Option(help="Address of an empty catalogue; by default a file of SQLite.")
    ] = "",
    as_json: AsJson = False,
) -> None:
    """Store invented records of 100 stations in a catalogue, and measure its questions."""
    from app.fleet.catalogue.libraries import check_libraries

    check_libraries()
    from app.bench.fleet.catalogue import COLUMNS, run, table

    shown = Shown("Storing", "The catalogue of 100 stations")
    _measure(shown, as_json, partial(run, rows, database), COLUMNS, table)


@bench.command()
@report_errors
def batch(
    recordings: Annotated[int, typer.Option(min=2, help="Of all stations together.")] = 200,
    disk: Annotated[
        Path, typer.Option(help="Folder on the disk that is measured.", file_okay=False)
    ] = Path(),
    lost: Annotated[
        bool,
        typer.Option(
            "--lost",
            help="Instead, let stations record into an S3-compatible store (package moto), and "
            "rebuild while a worker, the scheduler and the store are lost.",
        ),
    ] = False,
    stations: Annotated[int, typer.Option(min=1, max=50, help="With --lost.")] = 3,
    seconds: Annotated[
        float, typer.Option(min=0.1, help="With --lost, of each recording; otherwise 5.")
    ] = 5.0,
    away: Annotated[
        float, typer.Option(min=0.0, metavar="S", help="With --lost: the store is away so long.")
    ] = 60.0,
    as_json: AsJson = False,
) -> None:
    """Rebuild copies of a simulated recording by one and two workers, in memory and on a disk."""
    if lost:
        _batch_lost(recordings, disk, stations, seconds, away, as_json)
        return
    from app.bench.fleet.batch import COLUMNS, run, table

    shown = Shown("Rebuilding", "Many recordings of 5 s", "runs")
    _measure(shown, as_json, partial(run, recordings, disk), COLUMNS, table)


def _batch_lost(
    recordings: int, disk: Path, stations: int, seconds: float, away_s: float, as_json: bool
) -> None:
    """Prints what became of recordings while everything was lost once."""
    from app.bench.fleet.lost import COLUMNS, LossPlan, run, table

    plan = LossPlan(stations, recordings, seconds, away_s)
    shown = Shown("Losing", "Recordings while a worker, the scheduler and the store are lost")
    _measure(shown, as_json, partial(run, plan, disk), COLUMNS, table)
