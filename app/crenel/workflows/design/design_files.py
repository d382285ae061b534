"""What a design is made from, and the files and figures that it comes to."""

from itertools import pairwise
from pathlib import Path
from typing import Literal

from crenel.errors import OperationError
from crenel.formats.datasheets.sensor import read_sensor
from crenel.formats.datasheets.target import ObjectFile
from crenel.formats.drawings.dxf import write_dxf
from crenel.formats.drawings.step import write_step
from crenel.formats.drawings.stl import write_stl
from crenel.formats.io_errors import convert_io_errors
from crenel.messages.catalogue import renderer
from crenel.messages.message import Text, join, message, quantity, rounded
from crenel.metrology.design.making_tolerance import MEASURED_MM
from crenel.metrology.design.propose_block import BlockDesign
from crenel.metrology.design.stripe_sensor import StripeSensor
from crenel.metrology.targets.crenellated_block import mirror_difference_mm
from crenel.workflows.design.block_drawing import draw_block, edge_break_mm


def sensor_numbers(
    *,
    field_of_view_mm: float,
    depth_of_field_mm: float,
    angle_deg: float,
    datasheet: Path | None,
    standoff_mm: float | None,
    size_px: tuple[int, int] | None,
    stripe_axis: Literal["u", "v"] | None,
) -> StripeSensor:
    """The numbers that are given, and of the datasheet those that are not.

    Raises:
        OperationError: ``sensor-numbers``, if one is missing; as ``read_sensor``.
    """
    known = None if datasheet is None else read_sensor(datasheet)
    if known is not None:
        size_px = size_px or (known.width_px, known.height_px)
        standoff_mm = standoff_mm or known.standoff_mm
        stripe_axis = stripe_axis or known.stripe_axis
    if size_px is None or standoff_mm is None or min(size_px) < 64:
        raise OperationError(
            "sensor-numbers",
            message("design-needs-pixels-and-standoff"),
            "",
            message("design-give-pixels-and-standoff"),
        )
    return StripeSensor(
        field_of_view_mm,
        standoff_mm,
        depth_of_field_mm,
        *size_px,
        stripe_axis or "u",
        angle_deg,
    )


def make_folder(folder: Path) -> None:
    """Makes the folder of a design where it is missing; raises ``OperationError``."""
    with convert_io_errors(folder):
        folder.mkdir(parents=True, exist_ok=True)


def object_file(design: BlockDesign) -> ObjectFile:
    """The block's file with nominal sizes, good for a block that is used as drawn."""
    block = design.block
    return ObjectFile(
        name=block.name,
        serial_number=block.serial_number,
        edges_x_mm=block.edges_x_mm,
        front_y_mm=block.front_y_mm,
        back_y_mm=block.back_y_mm,
        crest_z_mm=block.crest_z_mm,
        floor_z_mm=block.floor_z_mm,
        base_z_mm=block.base_z_mm,
        tolerance_mm=design.tolerance_mm,
    )


def write_solid(design: BlockDesign, folder: Path) -> list[Path]:
    """Writes ``object.json``, ``block.stl`` and ``block.step``; returns their paths."""
    paths = [folder / "object.json", folder / "block.stl", folder / "block.step"]
    object_file(design).write(paths[0])
    write_stl(paths[1], design.block)
    write_step(paths[2], design.block)
    return paths


def write_dxf_of(design: BlockDesign, folder: Path, language: str) -> Path:
    """Writes ``block.dxf``; raises ``OperationError``, also where ezdxf is not installed."""
    path = folder / "block.dxf"
    write_dxf(path, draw_block(design), renderer(language))
    return path


def design_figures(design: BlockDesign) -> list[tuple[Text, Text]]:
    """Names and values of what was designed."""
    block = design.block
    x = block.edges_x_mm
    widths = [round(right - left, 3) for left, right in pairwise(x)]
    return [
        (message("design-merlons"), _lengths(widths[0::2])),
        (message("design-grooves"), _lengths(widths[1::2])),
        (message("design-groove-depth"), rounded(block.crest_z_mm - block.floor_z_mm, "mm")),
        (message("design-width"), rounded(x[-1] - x[0], "mm")),
        (message("design-length"), rounded(block.back_y_mm - block.front_y_mm, "mm")),
        (message("design-height"), rounded(block.crest_z_mm - block.base_z_mm, "mm")),
        (message("design-mirror"), rounded(mirror_difference_mm(x), "mm")),
        (message("design-tolerance"), message("plus-minus", uncertainty=_mm(design.tolerance_mm))),
        (message("design-edge-break"), quantity(edge_break_mm(design), "mm", 3)),
    ]


def tolerance_rows(design: BlockDesign) -> list[tuple[Text, Text, Text]]:
    """How the block is made, and the accuracy with one pose and with eight."""
    rows: list[tuple[Text, Text, Text]] = []
    for effect in design.effects:
        if effect.tolerance_mm is None:
            how: Text = message("block-measured-to", value=rounded(MEASURED_MM, "mm"))
        else:
            how = message("block-as-drawn", value=_mm(effect.tolerance_mm))
        one, eight = quantity(effect.one_pose_um, "µm", 1), quantity(effect.eight_poses_um, "µm", 1)
        rows.append((how, one, eight))
    return rows


def design_fields(design: BlockDesign) -> dict[str, object]:
    """The design for programs; lengths in mm, accuracies in µm, k = 1."""
    return {
        "object": object_file(design).fields(),
        "tolerance_mm": design.tolerance_mm,
        "edge_break_mm": edge_break_mm(design),
        "mirror_difference_mm": mirror_difference_mm(design.block.edges_x_mm),
        "one_pose_um": design.one_pose.total_um,
        "eight_poses_um": design.eight_poses.total_um,
        "one_pose_budget_um": {row.source: row.value_um for row in design.one_pose.rows},
        "eight_poses_budget_um": {row.source: row.value_um for row in design.eight_poses.rows},
        "by_tolerance": [
            {
                "tolerance_mm": effect.tolerance_mm,
                "one_pose_um": effect.one_pose_um,
                "eight_poses_um": effect.eight_poses_um,
            }
            for effect in design.effects
        ],
    }


def _lengths(values_mm: list[float]) -> Text:
    return join([_mm(value) for value in values_mm])


def _mm(value_mm: float) -> Text:
    return rounded(value_mm, "mm")
