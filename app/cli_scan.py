"""The command line's part for scans: rebuilt, compared, and shown again."""

import time
from dataclasses import asdict
from pathlib import Path
from typing import Annotated

import typer

from app.console import print_figures, print_json, progress_bar, refusing, warn

AsJson = Annotated[bool, typer.Option("--json", help="Print the result for programs on stdout.")]


@refusing
def reconstruct(
    recording: Annotated[Path, typer.Argument(metavar="SCAN.mcap", help="A scan recording.")],
    calibration: Annotated[Path, typer.Option(help="The sensor's calibration.json.")],
    arm: Annotated[Path, typer.Option(help="The arm's arm.json.")],
    output: Annotated[
        Path,
        typer.Option(
            "-o", "--output", help="The cloud: .ply, .pcd, .e57, .xyz, .las or .laz by its name."
        ),
    ] = Path("cloud.ply"),
    as_json: AsJson = False,
) -> None:
    """Rebuild the cloud of a recording in the arm frame, with any calibration."""
    from app.files.clouds import SUFFIXES

    if output.suffix.lower() not in SUFFIXES:
        raise typer.BadParameter(
            f"'{output}': clouds are written as {', '.join(SUFFIXES)}; name it "
            f"{output.with_suffix('.ply').name}",
            param_hint="'-o'",
        )
    from app.files.arm import read_arm
    from app.files.atomic import checked_target
    from app.files.calibration import read_calibration
    from app.files.rebuild import rebuild

    began = time.perf_counter()
    checked_target(output, (recording, calibration, arm))
    sensor, arm_model = read_calibration(calibration), read_arm(arm)
    with progress_bar("Reconstructing", not as_json) as tell:
        rebuilt = rebuild(recording, sensor, arm_model, output, tell)
    seconds = time.perf_counter() - began
    for text in rebuilt.warnings:
        warn(text)
    if as_json:
        told = {"file": str(output), "seconds": seconds}
        print_json({**asdict(rebuilt), **told})
        return
    figures = (
        ("points", f"{rebuilt.points:,}".replace(",", " ")),
        ("frames", f"{rebuilt.frames} with points, {rebuilt.frames_without_stripe} without stripe"),
        ("speed", f"{rebuilt.all_frames / seconds:.0f} frames/s"),
    )
    print_figures(f"Cloud of {recording}", figures)
    print(f"{output} written in {seconds:.2f} s")
