"""``crenel deviate``: a scan or a cloud against its part, as a map with decisions."""

from pathlib import Path
from typing import TYPE_CHECKING, Annotated

import typer

from crenel.console import (
    AsJson,
    print_figures,
    print_json,
    progress_bar,
    report_errors,
    warn,
)
from crenel.parts.cad.command_line import BodyOfPart, UnitOfPart
from crenel.parts.command_line import end_by_outcome

if TYPE_CHECKING:
    from crenel.parts.deviation.evaluate_deviation import DeviationOrder, DeviationResult


@report_errors
def deviate(
    source: Annotated[
        Path, typer.Argument(metavar="CLOUD|SCAN.mcap", help="A cloud or a recording of the part.")
    ],
    part: Annotated[Path, typer.Option(help="The part: .stl, .step or .stp.")],
    alignment: Annotated[
        Path | None,
        typer.Option(help="alignment.json of crenel align; by default, the scan is fitted."),
    ] = None,
    tolerance: Annotated[
        tuple[float, float] | None,
        typer.Option(help="Least and largest deviation permitted, mm, outward positive."),
    ] = None,
    calibration: Annotated[
        Path | None,
        typer.Option(help="The sensor's calibration.json; default: beside the recording."),
    ] = None,
    arm: Annotated[
        Path | None, typer.Option(help="The arm's arm.json; default: beside the recording.")
    ] = None,
    radius: Annotated[
        float, typer.Option(min=0.05, max=50.0, help="Edge of a cell of the map, mm.")
    ] = 0.8,
    lock: Annotated[
        list[str] | None,
        typer.Option(help="A motion that the fit leaves as it is: x, y, z, rx, ry or rz."),
    ] = None,
    unit: UnitOfPart = None,
    body: BodyOfPart = None,
    undecided_passes: Annotated[
        bool,
        typer.Option(
            "--undecided-passes", help="End with status 0 where nothing is out, not with 5."
        ),
    ] = False,
    output: Annotated[Path, typer.Option("-o", "--output", help="Output file.")] = Path("map.ply"),
    as_json: AsJson = False,
) -> None:
    """Compare a scan with its part: deviation, uncertainty and decision of each cell.

    With a tolerance, it ends with status 0 if all of the surface is within it, 4 if some of it is
    out, 5 if nothing is out and something is undecided.
    """
    from crenel.formats.atomic_write import check_output_path
    from crenel.parts.cad.evaluate_part import read_part
    from crenel.parts.deviation.document_map import write_map
    from crenel.parts.deviation.evaluate_deviation import (
        DeviationOrder,
        result_fields,
    )
    from crenel.parts.deviation.evaluate_deviation import deviate as compare
    from crenel.parts.deviation.maths_decisions import OUT, UNDECIDED, DeviationLimits
    from crenel.parts.maths.datums import MOTION_NAMES

    if any(name not in MOTION_NAMES for name in lock or ()):
        raise typer.BadParameter(f"one of {', '.join(MOTION_NAMES)}", param_hint="'--lock'")
    limits = None
    if tolerance is not None:
        lower, upper = tolerance
        if not lower < upper:
            raise typer.BadParameter("the first is to be less", param_hint="'--tolerance'")
        limits = DeviationLimits(lower, upper)
    inputs = [one for one in (source, part, alignment, calibration, arm) if one is not None]
    check_output_path(output, inputs)
    with progress_bar("Comparing", not as_json) as progress:
        nominal = read_part(
            part,
            None if unit is None else unit.value,
            None if limits is None else limits.width_mm,
            body,
        )
        order = DeviationOrder(
            source,
            nominal,
            calibration,
            arm,
            alignment,
            limits,
            radius,
            tuple(lock or ()),
        )
        result = compare(order, progress)
        write_map(output, result.rows())
    for text in (*nominal.notes, *result.warnings):
        warn(text)
    if as_json:
        print_json({**result_fields(result, order), "file": str(output)})
    else:
        print_figures(f"Deviation of {source} from {part}", _figures(result, order))
        print(f"{output} written")
    if limits is not None:
        end_by_outcome(
            result.outcome,
            f"{result.count(OUT)} cells are out of tolerance",
            f"{result.count(UNDECIDED)} cells are undecided",
            undecided_passes,
        )


def _figures(result: "DeviationResult", order: "DeviationOrder") -> list[tuple[str, str]]:
    import numpy as np

    cells = result.placed.cells
    off = 1e3 * cells.deviation_mm
    figures = [
        ("cells", f"{len(cells)} of {order.cell_mm:g} mm, {int(cells.count.sum())} points"),
        ("left out", f"{cells.beyond} points beyond the band, {cells.at_edges} at edges"),
        ("deviation", f"{off.min():+.1f} to {off.max():+.1f} µm, median {np.median(off):+.1f} µm"),
    ]
    if result.budget_um:
        figures.append(("U (k = 2)", f"{2e3 * float(np.median(result.u_mm)):.1f} µm, median"))
        parts = ", ".join(f"{name} {2 * value:.1f}" for name, value in result.budget_um.items())
        figures.append(("of which", f"{parts} µm"))
    else:
        scatter = 1e3 * float(np.median(cells.scatter_mm))
        figures.append(("scatter", f"{scatter:.1f} µm, median; uncertainty unknown"))
    if order.limits is not None:
        from crenel.parts.deviation.maths_decisions import IN, OUT, UNDECIDED

        low, high = order.limits.lower_mm, order.limits.upper_mm
        named = f"{result.count(IN)} in, {result.count(OUT)} out, {result.count(UNDECIDED)}"
        figures.append((f"tolerance {low:+g} {high:+g} mm", f"{named} undecided"))
        if result.by_chance is not None:
            figures.append(("out by chance", f"{result.by_chance:.2f} cells of a perfect part"))
        if result.profile is not None:
            chance = 100 * result.profile.probability
            figures.append(("profile", f"{result.profile.decision}, {chance:.1f} % within"))
    return figures
