"""Benches of calibrations, performance tests and the detection of objects."""

from functools import partial
from pathlib import Path
from typing import Annotated

import typer

from crenel.console import AsJson, print_json, progress_bar, report_errors
from tests.bench.commands.group import Shown, bench, measure


@bench.command()
@report_errors
def calibration(
    solves: Annotated[int, typer.Option(min=20, help="Simulated solves of each set-up.")] = 200,
    as_json: AsJson = False,
) -> None:
    """Compare the error with the Cramér-Rao bound and the stated uncertainty (Monte Carlo)."""
    from tests.bench.metrology.calibration import COLUMNS, run, table

    shown = Shown("Solving", "Calibration against its bound (k = 1, flange frame)", "set_ups")
    measure(shown, as_json, partial(run, solves), COLUMNS, table)


@bench.command()
@report_errors
def paper(
    arms: Annotated[
        int, typer.Option(min=1, help="Simulated arms, each 250 µm off its model.")
    ] = 5,
    as_json: AsJson = False,
) -> None:
    """Repeat the article's test: one plane, rebuilt with ten calibrations by each method."""
    from tests.bench.metrology.repeatability import COLUMNS, run, table

    shown = Shown("Calibrating", "A gauge plane over ten calibrations of one arm", "methods")
    measure(shown, as_json, partial(run, arms), COLUMNS, table)


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
        from tests.bench.metrology import rendered_faults as faults

        shown = Shown("Rendering", "Faults of the simulated station, µm", "faults")
        measure(shown, as_json, faults.run, faults.COLUMNS, faults.table)
        return
    from tests.bench.metrology.performance import COLUMNS, run, table

    shown = Shown("Drawing", "Figures of performance tests, µm", "figures")
    measure(shown, as_json, partial(run, draws, tests), COLUMNS, table)


@bench.command()
@report_errors
def detection(
    images: Annotated[int, typer.Option(min=1, help="Pictures to render and search.")] = 300,
    seed: Annotated[int, typer.Option(help="Seed of the first picture.")] = 0,
    as_json: AsJson = False,
) -> None:
    """Test the detection of the object in spoilt pictures: right, refused or wrong."""
    from tests.bench.metrology.detection import run

    with progress_bar("Searching", not as_json) as progress:
        found = run(images, seed, lambda done, of: progress(done / of, f"{done} of {of} pictures"))
    if as_json:
        print_json(found.figures())
        return
    print("\n".join(found.lines()))


@bench.command()
@report_errors
def boards(
    folder: Annotated[
        Path, typer.Argument(help="Folder of sets: in each, pictures and the board as object.json.")
    ],
    as_json: AsJson = False,
) -> None:
    """Find chessboards in real pictures, beside both finders of OpenCV."""
    from tests.bench.metrology.real_boards import COLUMNS, COLUMNS_RMS, run, table

    shown = Shown("Searching", f"Chessboards in pictures of {folder}", "sets")
    measure(shown, as_json, partial(run, folder), (*COLUMNS, *COLUMNS_RMS), table)


@bench.command("sync")
@report_errors
def clock_delay(
    passes: Annotated[int, typer.Option(min=8, help="Simulated passes of all kinds.")] = 420,
    seed: Annotated[int, typer.Option(min=0, help="Seed of the first pass of each kind.")] = 0,
    as_json: AsJson = False,
) -> None:
    """Determine the delay of simulated passes over a plate: constant, jumping, drifting, varying.

    Delays are up to 5 s, jumps 2 ms to 2 s, drifts 20 to 300 ppm; packets of the arm are late by 1
    to 30 ms, or hold 5 to 40 ms of readings, or their lateness wanders by 0.3 to 20 ms.
    """
    from tests.bench.clocks.delays import COLUMNS, run, table

    shown = Shown("Determining", "Delay between arm and camera in simulated passes", "kinds")
    measure(shown, as_json, partial(run, passes, seed), COLUMNS, table)
