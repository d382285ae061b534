"""The delay between arm and camera on the command line."""

from pathlib import Path
from typing import TYPE_CHECKING, Annotated

import typer

from app.cli.scan import paths_by_sensor
from app.console import AsJson, print_figures, print_json, progress_bar, report_errors, warn

if TYPE_CHECKING:
    from app.formats.settings.sync import Sync


@report_errors
def sync(
    recording: Annotated[
        Path,
        typer.Argument(
            metavar="SCAN.mcap",
            help="A pass over a plane, moving nearer and away again several times.",
        ),
    ],
    calibration: Annotated[
        str,
        typer.Option(
            metavar="[NAME=]CALIBRATION",
            help="The sensor's calibration.json; of several sensors, the one with this name.",
        ),
    ],
    arm: Annotated[Path, typer.Option(help="The arm's arm.json.")],
    output: Annotated[Path, typer.Option("-o", "--output", help="Output file.")] = Path(
        "sync.json"
    ),
    as_json: AsJson = False,
) -> None:
    """Determine the delay between arm and camera, with its jumps, its drift and its uncertainty.

    For crenel reconstruct --sync. The Settings page of a station determines and applies it, too.
    """
    from app.formats.atomic_write import check_output_path
    from app.formats.datasheets.arm import read_any_arm
    from app.formats.results.calibration import read_calibration
    from app.workflows.estimate_delay import delay_findings
    from app.workflows.estimate_delay import estimate_recording_delay as run

    ((name, file),) = paths_by_sensor([calibration]).items()
    check_output_path(output, (recording, file, arm))
    sensor, arm_model = read_calibration(file), read_any_arm(arm)
    with progress_bar("Determining the delay", not as_json) as progress:
        document = run(recording, sensor, arm_model, progress, sensor=name)
        document.write(output)
    if as_json:
        print_json({**document.fields(), "file": str(output)})
        return
    for one in delay_findings(document):
        warn(f"{one.text!s} {one.remedy!s}")
    print_figures(f"Delay between arm and camera, {recording}", _delay_figures(document))
    print(f"{output} written")


def _delay_figures(sync: "Sync") -> list[tuple[str, str]]:
    """The figures of a delay, in the words of the console."""
    u_ppm = sync.drift_standard_uncertainty_ppm or 0.0
    drift = f"{sync.drift_ppm:+.1f} ppm, standard uncertainty {u_ppm:.1f} ppm (k = 1)"
    if not sync.drift_ppm:
        drift = f"none found; standard uncertainty {u_ppm:.1f} ppm (k = 1)"
    jumps = [
        f"{jump.change_ms:+.3f} ms (k = 1: {jump.standard_uncertainty_ms:.3f} ms) at "
        f"{jump.at_s:.2f} s (k = 1: {jump.at_standard_uncertainty_s:.2f} s)"
        for jump in sync.jumps
    ]
    without = "unknown" if sync.rms_without_um is None else f"{sync.rms_without_um:.0f} µm rms"
    changing = ", at the end of the pass" if sync.jumps or sync.drift_ppm else ""
    return [
        ("delay of the arm's time stamps", f"{sync.delay_ms:.3f} ms{changing}"),
        ("standard uncertainty", f"{sync.standard_uncertainty_ms:.3f} ms (k = 1)"),
        ("drift", drift),
        ("jumps after the first picture", "; ".join(jumps) or "none found"),
        ("pass", f"{sync.seconds:.1f} s, {sync.reversals} reversals"),
        (
            "pictures",
            f"{sync.frames} used, {sync.frames_off} do not fit the plane, "
            f"{sync.frames_unplaced} without a reading of the arm",
        ),
        ("speed across the plane", f"{sync.speed_mm_s:.0f} mm/s rms"),
        ("points about the plane", f"{without} without it, {sync.rms_um:.0f} µm with it"),
    ]
