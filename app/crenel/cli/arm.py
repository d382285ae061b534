"""The command line's part for the arm itself: identified, and checked."""

import time
from pathlib import Path
from typing import Annotated

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

Limit = Annotated[
    float | None, typer.Option(min=0.0, help="Largest (max − min)/2 along any axis, in µm.")
]


@report_errors
def identify(
    folder: Annotated[
        Path,
        typer.Argument(
            help="Folder of arm.json and articulation.csv, spheres.csv, ballbars.csv or "
            "coordinates.csv."
        ),
    ],
    output: Annotated[Path, typer.Option("-o", "--output", help="Output file.")] = Path("arm.json"),
    check: Annotated[
        Path | None, typer.Option(help="Folder of places that check the fit and do not enter it.")
    ] = None,
    as_json: AsJson = False,
) -> None:
    """Identify the arm's own geometry from seats, spheres and ball bars touched with it, or from
    coordinates that a laser tracker or a measuring machine measured."""
    from crenel.workflows.identify_arm import (
        correlation_figures,
        identification_summary,
        identify_folder,
        list_fixed_parameters,
        parameter_rows,
    )

    began = time.perf_counter()
    with progress_bar("Identifying", not as_json) as progress:
        document, result = identify_folder(folder, output, check, progress)
    seconds = time.perf_counter() - began
    for text in result.warnings:
        warn(text)
    if as_json:
        print_json({**document.fields(), "file": str(output), "seconds": seconds})
        return
    print_figures(f"Arm of {folder}", identification_summary(result))
    columns = ("parameter", "before", "after", "change", "uncertainty (k = 1)")
    print_table("Changed parameters", columns, parameter_rows(result))
    if pairs := correlation_figures(result):
        print_figures("Correlated (well determined together, less well each alone)", pairs)
    print_figures("Unchanged parameters", list_fixed_parameters(result))
    print(f"{output} written in {seconds:.2f} s")
    print("The flange frame is now that of this arm: calibrate the arm's sensors again.")


@report_errors
def import_arm(
    source: Annotated[
        Path,
        typer.Argument(
            metavar="FILE|NAME",
            help="The arm's D-H table as text or CSV, its URDF, or calibration.conf of a UR; or "
            "the name of a robot of the list.",
        ),
    ],
    tip: Annotated[
        tuple[float, float, float, float],
        typer.Option(metavar="X Y Z DIAMETER", help="The tip's centre on the flange, in mm."),
    ],
    output: Annotated[Path, typer.Option("-o", "--output", help="Output file.")] = Path("arm.json"),
    name: Annotated[str, typer.Option(help="Name of the arm. Default: that in the file.")] = "",
    serial_number: Annotated[str, typer.Option(help="Its serial number.")] = "",
    say: Annotated[
        list[str] | None,
        typer.Option(metavar="KEY=VALUE", help="What the file leaves open, such as length=mm."),
    ] = None,
    as_json: AsJson = False,
) -> None:
    """Make arm.json from the model of an arm as its maker states it.

    What the file does not say itself, such as the unit of its lengths, is asked and never guessed:
    the command names what is open, and what is likely. Repeat it with --say.
    """
    from crenel.formats.arm_models.import_model import import_arm_file

    answers = {}
    for one in say or []:
        key, sign, value = one.partition("=")
        if not sign:
            raise typer.BadParameter(f"{one}: KEY=VALUE is expected", param_hint="--say")
        answers[key.strip()] = value.strip()
    document, model = import_arm_file(source, output, answers, tip, name, serial_number)
    for note in model.notes:
        warn(note)
    if as_json:
        print_json({**document.fields(), "file": str(output)})
        return
    joints = [
        (
            one.name,
            *(f"{value:.6g}" for value in (one.a_mm, one.alpha_deg, one.d_mm, one.theta_deg)),
        )
        for one in model.joints
    ]
    print_table(
        f"{model.source!s}: {model.convention}", ("joint", "a mm", "α °", "d mm", "θ °"), joints
    )
    print(f"{output} written. Check the table, and try the arm against its own display.")


@report_errors
def articulation(
    place: Annotated[
        Path, typer.Argument(metavar="FOLDER|CSV", help="articulation.csv or its folder.")
    ],
    arm: Annotated[
        Path | None, typer.Option(help="The arm's arm.json. Default: beside the table.")
    ] = None,
    limit_um: Limit = None,
    limit_two_sigma_um: Annotated[
        float | None, typer.Option(min=0.0, help="Largest 2σ along any axis, in µm.")
    ] = None,
    as_json: AsJson = False,
) -> None:
    """Check an arm by single-point articulation, in µm.

    Prints (max − min)/2 and 2σ of each axis, and in space the figures of ASME B89.4.22: the
    largest distance from the mean, and 2s of the distances.

    Exits with status 1 if a limit is exceeded.
    """
    from crenel.metrology.arm.identification.articulation import ArticulationLimits
    from crenel.workflows.check_articulation import (
        check_table,
        report_fields,
        report_rows,
        worst_verdict,
    )

    reports = check_table(place, arm, ArticulationLimits(limit_um, limit_two_sigma_um))
    if as_json:
        print_json(report_fields(reports))
    else:
        columns = ["set", "points", "½range x", "y", "z", "2σ x", "y", "z"]
        columns += ["largest", "2s", "2σ encoders", "swing °", "verdict"]
        print_table(f"Articulation of {place}, µm", columns, report_rows(reports))
    if worst_verdict(reports) == "fail":
        worst = max(reports, key=lambda report: float(report.check.half_range_um.max()))
        fail(
            f"{place}: set {worst.name} scatters by {worst.check.half_range_um.max():.0f} µm "
            f"((max − min)/2) and {worst.check.two_sigma_um.max():.0f} µm (2σ): beyond the limit. "
            "Check seat, stylus and clamping, and repeat. If it persists, identify the arm again."
        )
