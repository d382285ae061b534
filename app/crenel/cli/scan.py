"""The command line's part for scans: rebuilt, compared, and shown again."""

import time
from collections.abc import Sequence
from dataclasses import asdict
from functools import partial
from pathlib import Path
from typing import TYPE_CHECKING, Annotated

import typer

from crenel.cli.batch_options import (
    BatchOptions,
    Config,
    PeriodOption,
    Scheduler,
    Station,
    TakenWith,
    Workers,
    name_places,
)
from crenel.console import (
    SOME_LEFT_OUT,
    AsJson,
    fail,
    print_figures,
    print_json,
    print_table,
    progress_bar,
    report_errors,
    warn,
)

if TYPE_CHECKING:
    from crenel.formats.settings.sync import Sync

EachCalibration = Annotated[
    list[str],
    typer.Option(
        metavar="[NAME=]CALIBRATION",
        help="The sensor's calibration.json; of several sensors, one for each, as in "
        "left=calibration.json.",
    ),
]


def paths_by_sensor(given: Sequence[str]) -> dict[str, Path]:
    """Files by the name of their sensor, as given; an empty name without one.

    Raises:
        typer.BadParameter: two files for one sensor, or some without a name.
    """
    from crenel.formats.recording.topics import SENSOR_NAME

    found: dict[str, Path] = {}
    for text in given:
        name, equals, path = text.partition("=")
        if not (equals and SENSOR_NAME.fullmatch(name)) or Path(text).exists():
            name, path = "", text
        if name in found or (found and ("" in found or not name)):
            raise typer.BadParameter(
                "of several sensors, give each its own, as in left=calibration.json",
                param_hint="'--calibration'",
            )
        found[name] = Path(path)
    return found


@report_errors
def reconstruct(
    recording: Annotated[Path, typer.Argument(metavar="SCAN.mcap", help="A scan recording.")],
    calibration: EachCalibration,
    arm: Annotated[Path, typer.Option(help="The arm's arm.json.")],
    output: Annotated[
        Path,
        typer.Option(
            "-o", "--output", help="Output file: .ply, .pcd, .e57, .xyz, .las, .laz or .copc.laz."
        ),
    ] = Path("cloud.ply"),
    delay_ms: Annotated[
        float | None,
        typer.Option(
            min=-5000.0,
            max=5000.0,
            help="Delay of the arm's time stamps behind the camera's. Default: as applied by the "
            "station.",
        ),
    ] = None,
    sync: Annotated[
        Path | None, typer.Option(help="Take the delay from a sync.json that crenel sync wrote.")
    ] = None,
    allow_incomplete: Annotated[
        bool,
        typer.Option(
            "--allow-incomplete",
            help="Make the points that are possible, where more than a tenth of the scan is left "
            "out and it would be refused.",
        ),
    ] = False,
    as_json: AsJson = False,
) -> None:
    """Rebuild the cloud of a recording in the arm frame, with any calibration."""
    from crenel.formats.clouds.files import SUFFIXES

    if output.suffix.lower() not in SUFFIXES:
        raise typer.BadParameter(
            f"'{output}': clouds are written as {', '.join(SUFFIXES)}; name it "
            f"{output.with_suffix('.ply').name if output.name else 'cloud.ply'}",
            param_hint="'-o'",
        )
    if delay_ms is not None and sync is not None:
        raise typer.BadParameter("give only one of the two", param_hint="'--delay-ms', '--sync'")
    from crenel.formats.atomic_write import check_output_path
    from crenel.formats.datasheets.arm import read_any_arm
    from crenel.formats.results.calibration import read_calibration
    from crenel.metrology.time_delay.course import DelayCourse
    from crenel.workflows.estimate_delay import read_sync
    from crenel.workflows.reconstruct import reconstruct_cloud

    files = paths_by_sensor(calibration)
    if sync is not None and len(files) > 1:
        raise typer.BadParameter(
            "is of one sensor; the recording states the delay of each", param_hint="'--sync'"
        )
    began = time.perf_counter()
    check_output_path(output, [recording, *files.values(), arm, *([sync] if sync else [])])
    sensors = {name: read_calibration(path) for name, path in files.items()}
    arm_model = read_any_arm(arm)
    delay = None if delay_ms is None else DelayCourse(1e6 * delay_ms)
    if sync is not None:
        delay = read_sync(sync, next(iter(sensors.values())), arm_model).course
    with progress_bar("Reconstructing", not as_json) as progress:
        rebuilt = reconstruct_cloud(
            recording,
            sensors,
            arm_model,
            output,
            progress,
            delay,
            allow_incomplete=allow_incomplete,
        )
    seconds = time.perf_counter() - began
    for text in rebuilt.warnings:
        warn(text)
    if as_json:
        written = {
            "cut": str(rebuilt.cut),
            "warnings": list(map(str, rebuilt.warnings)),
            "file": str(output),
            "seconds": seconds,
        }
        print_json({**asdict(rebuilt), **written})
    else:
        without = rebuilt.frames_without_stripe
        figures = (
            ("points", f"{rebuilt.points:,}".replace(",", " ")),
            ("frames", f"{rebuilt.frames} with points, {without} without stripe"),
            ("speed", f"{rebuilt.all_frames / seconds:.0f} frames/s"),
        )
        print_figures(f"Cloud of {recording}", figures)
        print(f"{output} written in {seconds:.2f} s")
    if rebuilt.incomplete:
        fail(f"{output} is incomplete", SOME_LEFT_OUT)


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
    from crenel.formats.atomic_write import check_output_path
    from crenel.formats.datasheets.arm import read_any_arm
    from crenel.formats.results.calibration import read_calibration
    from crenel.workflows.estimate_delay import delay_findings
    from crenel.workflows.estimate_delay import estimate_recording_delay as run

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


@report_errors
def study(
    given: Annotated[
        list[str],
        typer.Argument(
            metavar="RECORDING... | PLACE...",
            help="Scans of one plane; .json files among them are calibrations. Or archives and "
            "data folders, whose verifications are studied.",
        ),
    ],
    arm: Annotated[
        Path | None, typer.Option(help="The arm's arm.json; not needed for places.")
    ] = None,
    calibrations: Annotated[
        list[str] | None,
        typer.Option(
            "--calibrations", metavar="CALIBRATION...", help="Calibrations of the sensor."
        ),
    ] = None,
    nominal: Annotated[
        Path | None, typer.Option(help="nominal.json: the true position of the plane.")
    ] = None,
    output: Annotated[
        str | None,
        typer.Option(
            "-o", "--output", help="Write the table to this CSV file; of places, their folder."
        ),
    ] = None,
    period: PeriodOption = None,
    station: Station = None,
    taken_with: TakenWith = None,
    workers: Workers = None,
    scheduler: Scheduler = None,
    config: Config = None,
    as_json: AsJson = False,
) -> None:
    """Repeat the article's study: clouds of one plane, each rebuilt with each calibration.

    Reports how far the plane rotates and shifts between calibrations, and between clouds. Of
    archives and data folders: the clouds of all verifications, with all calibrations of the
    station.
    """
    if name_places(given):
        from crenel.cli.batch_verifications import measure_places

        options = BatchOptions(
            output or "studied", period, station, taken_with, workers, scheduler, config, as_json
        )
        measure_places("study", given, calibrations or (), arm, None, options)
        return
    if arm is None:
        raise typer.BadParameter("none given", param_hint="'--arm'")
    files = [Path(one) for one in given]
    known = [Path(one) for one in calibrations or ()]
    _study_files(files, arm, known, nominal, None if output is None else Path(output), as_json)


def _study_files(
    files: list[Path],
    arm: Path,
    calibrations: list[Path],
    nominal: Path | None,
    output: Path | None,
    as_json: bool,
) -> None:
    from crenel.formats.atomic_write import check_output_path
    from crenel.formats.datasheets.arm import read_any_arm
    from crenel.formats.results.calibration import read_calibration
    from crenel.gauges.quick.clouds.evaluate_repeatability import range_rows
    from crenel.gauges.quick.clouds.evaluate_repeatability import run_study as run

    calibration_files = [
        *calibrations,
        *(path for path in files if path.suffix.lower() == ".json"),
    ]
    recordings = [path for path in files if path.suffix.lower() != ".json"]
    if not calibration_files or not recordings:
        missing = "--calibrations" if not calibration_files else "RECORDING..."
        raise typer.BadParameter("none given", param_hint=f"'{missing}'")
    if output is not None:
        check_output_path(output, [*files, *calibration_files, arm])
    known = [(path, read_calibration(path)) for path in calibration_files]
    arm_model = read_any_arm(arm)
    with progress_bar("Rebuilding", not as_json) as progress:
        done = run(recordings, known, arm_model, nominal, progress)
        if output is not None:
            done.write_csv(output)
    for text in done.warnings:
        warn(text)
    if as_json:
        print_json({**asdict(done), "warnings": list(map(str, done.warnings))})
        return
    rows = [
        (
            row.recording,
            row.calibration,
            str(row.points),
            f"{row.rms_um:.1f}",
            f"{row.angle_arcsec:.1f}",
            f"{row.offset_um:.1f}",
        )
        for row in done.rows
    ]
    columns = ("cloud", "calibration", "points", "rms µm", "angle ″", "offset µm")
    print_table(f"Plane against {nominal or 'the mean of all'}", columns, rows)
    columns = ("range", "angle, mean", "largest", "offset, mean", "largest", "the article")
    print_table("Rotation and shift of the plane", columns, range_rows(done))
    if output is not None:
        print(f"{output} written")


@report_errors
def replay(
    recording: Annotated[Path, typer.Argument(metavar="SCAN.mcap", help="A scan recording.")],
    calibration: Annotated[
        list[str] | None,
        typer.Option(
            metavar="[NAME=]CALIBRATION",
            help="The sensor's calibration.json, or one for each of several sensors; default: "
            "beside the recording.",
        ),
    ] = None,
    arm: Annotated[
        Path | None, typer.Option(help="The arm's arm.json; default: beside the recording.")
    ] = None,
    speed: Annotated[
        float, typer.Option(min=0.0, help="1: original speed; 0: as fast as the file can be read.")
    ] = 1.0,
    host: Annotated[str, typer.Option(help="Address to listen on.")] = "127.0.0.1",
    port: Annotated[int, typer.Option(min=0, max=65535, help="Port to listen on.")] = 8000,
    open_browser: Annotated[
        bool, typer.Option("--open/--no-open", help="Open the browser.")
    ] = True,
) -> None:
    """Show a recording in the live display, with any calibration."""
    from crenel.formats.datasheets.arm import read_any_arm
    from crenel.formats.results.calibration import read_calibration
    from crenel.server.live_replay import Replay
    from crenel.server.replayed_calibration import put_in_use
    from crenel.server.startup import replay as run_replay

    files = paths_by_sensor(calibration or [str(recording.with_name("calibration.json"))])
    sensors = {name: read_calibration(path) for name, path in files.items()}
    arm_file = arm or recording.with_name("arm.json")
    show = Replay(recording, sensors, read_any_arm(arm_file), speed)
    # of several sensors, the first one is shown
    fill = partial(put_in_use, calibration=next(iter(files.values())), arm=arm_file)
    # a name that needs no translation
    run_replay(show, recording.name, host, port, open_browser, fill)
