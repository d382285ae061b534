"""``crenel inspect`` and ``crenel align``: a part against its program."""

from pathlib import Path
from typing import TYPE_CHECKING, Annotated

import typer

from crenel.console import (
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
    from crenel.parts.document_results import AlignmentFile, InspectionFile, Outcome

SOME_FAIL, SOME_UNDECIDED = 4, 5
"""Exit statuses of an inspection whose part fails, or of which something is undecided."""

Folder = Annotated[
    Path, typer.Argument(metavar="FOLDER", help="A folder with program.json and what it needs.")
]
Scans = Annotated[
    list[Path] | None,
    typer.Option("--scan", metavar="SCAN.mcap", help="Recordings; default: those in scans."),
]
Touches = Annotated[
    Path | None, typer.Option(help="The touches; default: touches.csv of the folder.")
]
CalibrationOption = Annotated[
    Path | None, typer.Option(help="The sensor's calibration.json; default: the folder's.")
]
ArmOption = Annotated[Path | None, typer.Option(help="The arm's arm.json; default: the folder's.")]
TipOption = Annotated[
    float,
    typer.Option(
        "--tip-um", min=0.0, help="Standard uncertainty of the tip's diameter, µm; default: none."
    ),
]


@report_errors
def inspect(
    folder: Folder,
    scan: Scans = None,
    touches: Touches = None,
    calibration: CalibrationOption = None,
    arm: ArmOption = None,
    tip_um: TipOption = 0.0,
    output: Annotated[
        list[Path] | None,
        typer.Option(
            "-o",
            "--output",
            help="Output file: .json, .csv, .xlsx, .qif, .html or .pdf; can be given again. "
            "Default: results.json of the folder.",
        ),
    ] = None,
    map_: Annotated[
        Path | None,
        typer.Option("--map", metavar="MAP.ply", help="Write the deviations from part.stl, too."),
    ] = None,
    schema: Annotated[
        Path | None, typer.Option(help="QIFDocument.xsd, by which QIF is checked.")
    ] = None,
    language: Annotated[str, typer.Option(help="Of .html and .pdf.")] = "en",
    temperature: Annotated[
        float | None,
        typer.Option(help="Of the part, °C: lengths are then those at 20 °C, by its expansion."),
    ] = None,
    temperature_sd: Annotated[
        float, typer.Option(min=0.0, help="Standard uncertainty of the temperature, °C.")
    ] = 0.5,
    undecided_passes: Annotated[
        bool,
        typer.Option(
            "--undecided-passes", help="End with status 0 where nothing fails, not with 5."
        ),
    ] = False,
    as_json: AsJson = False,
) -> None:
    """Measure a part by its program, with uncertainties and decisions.

    Ends with status 0 if everything passes, 4 if something fails, 5 if nothing fails and
    something is undecided.
    """
    from crenel.metrology.decision import GUARDED_95
    from crenel.parts.command_line_files import check_result_files, write_result_files
    from crenel.parts.document_program import ProgramFile
    from crenel.parts.document_results import RESULTS
    from crenel.parts.evaluate import judge_part, measure_part
    from crenel.parts.evaluate_folder import find_files
    from crenel.parts.evaluate_temperature import PartTemperature, find_compensation

    if map_ is not None and temperature is not None:
        raise typer.BadParameter("a map has no temperature", param_hint="'--temperature'")
    files = find_files(folder, scan or (), touches, calibration, arm, tip_um)
    written = output or [folder / RESULTS]
    maps = [] if map_ is None else [map_]
    check_result_files(written, maps, files.all_files, language)
    at = None if temperature is None else PartTemperature(temperature, temperature_sd)
    find_compensation(ProgramFile.read(files.program), at)  # refused before anything is measured
    part = None
    if map_ is not None:
        from crenel.parts.deviation.evaluate_inspection_map import read_inspected_part

        part = read_inspected_part(files)
    with progress_bar("Measuring", not as_json) as progress:
        found = measure_part(files, progress)
        result = judge_part(found, GUARDED_95, at)
        if part is not None and map_ is not None:
            from crenel.parts.deviation.document_map import write_map
            from crenel.parts.deviation.evaluate_inspection_map import map_part, with_map

            deviations = map_part(found, part, GUARDED_95)
            result = with_map(result, deviations, files.program)
            write_map(map_, deviations.rows())
    notes = [] if part is None else list(part.notes)
    notes += write_result_files(result, folder, written, language, schema)
    for text in (*notes, *result.warnings):
        warn(text)
    places = [*written, *maps]
    if as_json:
        print_json({**result.fields(), "files": list(map(str, places))})
    else:
        _print_inspection(result)
        for path in places:
            print(f"{path} written")
    words = [one.decision for one in result.dimensions]
    skipped = len(result.not_measured)
    count, open_ = len(words) + skipped, words.count("undecided") + skipped
    of_map = "" if result.map is None else f", map: {result.map.decision}"
    end_by_outcome(
        result.verdict,
        f"{words.count('fail')} of {count} dimensions fail{of_map}",
        f"{open_} of {count} dimensions are undecided{of_map}",
        undecided_passes,
    )


@report_errors
def align(
    folder: Folder,
    scan: Scans = None,
    touches: Touches = None,
    calibration: CalibrationOption = None,
    arm: ArmOption = None,
    tip_um: TipOption = 0.0,
    output: Annotated[
        Path | None,
        typer.Option("-o", "--output", help="Output file; default: alignment.json of the folder."),
    ] = None,
    as_json: AsJson = False,
) -> None:
    """Find the frame of a part by its datums, and what it is known to at each feature."""
    from crenel.formats.atomic_write import check_output_path
    from crenel.parts.document_results import ALIGNMENT
    from crenel.parts.evaluate import align_part
    from crenel.parts.evaluate_folder import find_files

    files = find_files(folder, scan or (), touches, calibration, arm, tip_um)
    written = output or folder / ALIGNMENT
    check_output_path(written, files.all_files)
    with progress_bar("Aligning", not as_json) as progress:
        result = align_part(files, progress)
    result.write(written)
    for text in result.warnings:
        warn(text)
    if as_json:
        print_json({**result.fields(), "file": str(written)})
    else:
        _print_alignment(result)
        print(f"{written} written")


def _print_inspection(result: "InspectionFile") -> None:
    is_full = result.uncertainty == "full"
    rows = []
    for one in result.dimensions:
        spread = one.standard_uncertainty if is_full else one.scatter
        limits = " … ".join(
            "" if limit is None else f"{limit:+g}" for limit in (one.lower, one.upper)
        )
        rows.append(
            (
                one.id,
                f"{one.value:.4f} {one.unit}",
                f"{one.nominal:g}",
                limits if limits.strip(" …") else "",
                "" if spread is None else f"{2 * spread:.4f}",
                one.decision,
            )
        )
    label = "U (k = 2)" if is_full else "scatter (k = 2)"
    columns = ("dimension", "measured", "nominal", "limits", label, "decision")
    print_table(f"Part {result.part or result.program}", columns, rows)
    if result.alignment is not None and result.alignment.known_at:
        known = [one.u_um for one in result.alignment.known_at]
        print(f"The part frame is known to {min(known):.0f} to {max(known):.0f} µm (k = 1).")


def _print_alignment(result: "AlignmentFile") -> None:
    places = [(one.feature, f"{one.u_um:.1f} µm (k = 1)") for one in result.alignment.known_at]
    print_figures(f"Part frame of {result.program}, known at", places)


def end_by_outcome(outcome: "Outcome", failed: str, undecided: str, undecided_passes: bool) -> None:
    """Ends a command with the status of what it decided, and says why on one line.

    Args:
        undecided_passes: what is undecided ends as if it passed.
    """
    if outcome == "fail":
        fail(failed, SOME_FAIL)
    if outcome == "undecided" and not undecided_passes:
        fail(undecided, SOME_UNDECIDED)
