"""Benches of a running station: its start, its load and its faults."""

from dataclasses import asdict
from functools import partial
from pathlib import Path
from typing import Annotated

import typer

from crenel.console import AsJson, print_json, print_table, progress_bar, report_errors
from tests.bench.commands.group import Shown, bench, measure


@bench.command()
@report_errors
def live(
    seconds: Annotated[float, typer.Option(min=1.0, help="Duration of the scan.")] = 60.0,
    profiles_hz: Annotated[float, typer.Option(min=1.0, help="Frames per second.")] = 600.0,
    points: Annotated[int, typer.Option(min=100, help="Points per frame.")] = 2000,
    as_json: AsJson = False,
) -> None:
    """Run the whole station on a fast simulated sensor, recording and watched by viewers."""
    from crenel_hardware.simulator.devices.fast_simulator import FastStationConfig
    from tests.bench.station.live import COLUMNS, run, table

    station = FastStationConfig(profiles_hz=profiles_hz, width_px=points)
    shown = Shown("Scanning", f"{profiles_hz:.0f} frames a second of {points} points")
    measure(shown, as_json, partial(run, station, seconds), COLUMNS, table)


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
    from tests.bench.station.camera import COLUMNS, run, table

    shown = Shown("Streaming", "1280 × 1024 pixels over GigE Vision")
    stream = partial(run, 60.0 * minutes, rate_hz, lost_per_mille)
    measure(shown, as_json, stream, COLUMNS, table)


@bench.command()
@report_errors
def view(
    million_points: Annotated[float, typer.Option(min=0.1, help="Millions of points.")] = 50.0,
    as_json: AsJson = False,
) -> None:
    """Measure the 3D view after a long scan: a second viewer joins, and the colours change."""
    from tests.bench.station.view import COLUMNS, run, table

    shown = Shown("Showing", "The 3D view after a long scan")
    measure(shown, as_json, partial(run, round(1e6 * million_points)), COLUMNS, table)


@bench.command()
@report_errors
def viewers(
    number: Annotated[int, typer.Option(min=2, help="Number of browsers that watch.")] = 20,
    seconds: Annotated[float, typer.Option(min=4.0, help="Duration of the scan.")] = 30.0,
    as_json: AsJson = False,
) -> None:
    """Measure the age of the state in many browsers during a scan, one of them slow."""
    from crenel_hardware.simulator.devices.fast_simulator import FastStationConfig
    from tests.bench.station.viewers import COLUMNS, run, table

    station = FastStationConfig(profiles_hz=60.0, width_px=1280)
    shown = Shown("Watching", "A scan of 60 frames a second, watched by many")
    measure(shown, as_json, partial(run, station, number, seconds), COLUMNS, table)


@bench.command()
@report_errors
def faults(
    only: Annotated[
        list[str] | None,
        typer.Option(help="Only kills, disk, damage, floods, broker or devices. Repeatable."),
    ] = None,
    seed: Annotated[int, typer.Option(help="Seed of the random tests.")] = 0,
    as_json: AsJson = False,
) -> None:
    """Test what is lost when processes are killed, the disk is full, or files or devices fail."""
    from tests.bench.faults import devices, everything, row

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
    from tests.bench.station.start import Rounds, columns, run, table
    from tests.bench.station.started import find_copy, running_copy

    rounds = Rounds(cold, warm, busy)
    copies = [running_copy(), *([find_copy("against", against)] if against else [])]
    shown = Shown("Starting", "From the start on: median (least–most)", "measures")
    measure(shown, as_json, partial(run, copies, rounds, session), columns(copies), table)
