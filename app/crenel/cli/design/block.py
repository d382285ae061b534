"""``crenel design block``: a crenellated block, its drawing and solid, and its accuracy."""

from pathlib import Path
from typing import TYPE_CHECKING, Annotated, Literal

import typer

from crenel.console import (
    AsJson,
    Language,
    print_figures,
    print_json,
    print_table,
    progress_bar,
    report_errors,
    warn,
)

if TYPE_CHECKING:
    from crenel.metrology.design.propose_block import BlockDesign


LARGEST_MM = 1e6
"""The largest length that can be given, as by HTTP."""


@report_errors
def block(
    field_of_view: Annotated[
        float,
        typer.Option(min=1.0, max=LARGEST_MM, help="Width of the picture along the stripe, in mm."),
    ],
    depth_of_field: Annotated[
        float,
        typer.Option(min=0.5, max=LARGEST_MM, help="Depth in which the picture is sharp, in mm."),
    ],
    output: Annotated[
        Path,
        typer.Option("-o", "--output", help="Folder for drawing, solid and object.json."),
    ] = Path("block"),
    sensor: Annotated[
        Path | None, typer.Option(help="sensor.json: pixels, direction of the stripe, stand-off.")
    ] = None,
    standoff: Annotated[
        float | None,
        typer.Option(
            min=1.0, max=LARGEST_MM, help="From the sensor to the middle of its range, in mm."
        ),
    ] = None,
    pixels: Annotated[
        str | None, typer.Option(help="Width and height of the picture, as in 1280x1024.")
    ] = None,
    angle: Annotated[
        float, typer.Option(min=5.0, max=70.0, help="Between laser and camera, in degrees.")
    ] = 30.0,
    stripe_axis: Annotated[
        str | None, typer.Option(help="u: the stripe has one point a column; v: one a row.")
    ] = None,
    arm: Annotated[
        Path | None, typer.Option(help="arm.json of the arm; otherwise, a usual portable arm.")
    ] = None,
    width: Annotated[
        float | None,
        typer.Option(
            min=1.0, max=LARGEST_MM, help="Width of the block, in mm; otherwise proposed."
        ),
    ] = None,
    merlons: Annotated[
        int | None, typer.Option(min=2, max=9, help="Number of merlons; otherwise proposed.")
    ] = None,
    groove_depth: Annotated[
        float | None,
        typer.Option(
            min=0.1, max=LARGEST_MM, help="Depth of the grooves, in mm; otherwise proposed."
        ),
    ] = None,
    tolerance: Annotated[
        float | None,
        typer.Option(
            min=0.001, max=0.3, help="± to which the block is made, in mm; otherwise proposed."
        ),
    ] = None,
    name: Annotated[str, typer.Option(help="Name of the block.")] = "Crenellated block",
    language: Language = "en",
    as_json: AsJson = False,
) -> None:
    """Propose a crenellated block for a sensor, and state the accuracy that it will give."""
    from crenel.workflows.design.ordered_block import BlockOrder, design_block

    order = BlockOrder(
        field_of_view_mm=field_of_view,
        depth_of_field_mm=depth_of_field,
        angle_deg=angle,
        sensor=sensor,
        standoff_mm=standoff,
        size_px=None if pixels is None else two_numbers(pixels, "--pixels"),
        stripe_axis=_axis(stripe_axis),
        arm=arm,
        width_mm=width,
        merlons=merlons,
        groove_mm=groove_depth,
        tolerance_mm=tolerance,
    )
    with progress_bar("Designing", not as_json) as progress:
        found = design_block(order, name, progress).design
    files = _write(found, output, language)
    if as_json:
        _print_json(found, files)
        return
    _print(found, files)


def two_numbers(text: str, option: str) -> tuple[int, int]:
    """Both numbers of ``1280x1024``."""
    parts = text.lower().replace("×", "x").split("x")
    if len(parts) != 2 or not all(part.strip().isdigit() for part in parts):
        raise typer.BadParameter("two whole numbers, as in 12x8", param_hint=option)
    return int(parts[0]), int(parts[1])


def _axis(text: str | None) -> Literal["u", "v"] | None:
    match text:
        case None | "u" | "v":
            return text
    raise typer.BadParameter("u or v", param_hint="--stripe-axis")


def _write(found: "BlockDesign", folder: Path, language: str) -> list[Path]:
    from crenel.errors import OperationError
    from crenel.formats.atomic_write import write_atomically
    from crenel.report.printed.drawing_pdf import drawing_pdf
    from crenel.workflows.design.block_drawing import draw_block
    from crenel.workflows.design.design_files import make_folder, write_dxf_of, write_solid

    content = drawing_pdf(draw_block(found), language)
    make_folder(folder)
    path = folder / "block.pdf"
    write_atomically(path, content)
    written = [*write_solid(found, folder), path]
    try:
        written.append(write_dxf_of(found, folder, language))
    except OperationError as refusal:
        if refusal.code != "extra-missing":
            raise
        warn(refusal.line)
    return written


def _print(found: "BlockDesign", files: list[Path]) -> None:
    from crenel.workflows.design.design_files import design_figures, tolerance_rows

    print_figures(found.block.name, design_figures(found))
    columns = ("block", "one pose", "eight poses")
    print_table("Standard uncertainty of a scanned point, k = 1", columns, tolerance_rows(found))
    for path in files:
        print(f"{path} written")


def _print_json(found: "BlockDesign", files: list[Path]) -> None:
    from crenel.workflows.design.design_files import design_fields

    print_json({**design_fields(found), "files": [str(path) for path in files]})
