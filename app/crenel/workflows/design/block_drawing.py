"""The drawing by which a workshop makes a designed block."""

from itertools import pairwise

from crenel.formats.drawings.drawing import (
    DrawingDimension,
    DrawingLabel,
    DrawingLine,
    PartDrawing,
    Point,
)
from crenel.messages.message import Text, message, rounded
from crenel.metrology.design.propose_block import BlockDesign
from crenel.metrology.targets.crenellated_block import Crenellated, outline_mm

SCALES = (20.0, 10.0, 5.0, 2.0, 1.0, 0.5, 0.2, 0.1)
SPACE_MM = (255.0, 125.0)
"""What the views and their dimensions may take on A4 in landscape."""
APART_MM, STEP_MM = 14.0, 6.5
"""Between the views, and between dimensions, on paper."""
MEASURED_TOLERANCE_MM = 0.1
"""The tolerance of a block that a laboratory measures."""
LEAST_BREAK_MM = 0.005


def draw_block(design: BlockDesign) -> PartDrawing:
    """Front and side of the block, with dimensions from one corner, tolerances and surface."""
    block = design.block
    scale = next((one for one in SCALES if _fits(block, one)), SCALES[-1])
    left, base = block.edges_x_mm[0], block.base_z_mm
    outline = _outline(block)
    height, length = block.crest_z_mm - base, block.back_y_mm - block.front_y_mm
    width = block.edges_x_mm[-1] - left
    beside = width + (APART_MM + 3 * STEP_MM) / scale
    side = [(beside, 0.0), (beside + length, 0.0), (beside + length, height), (beside, height)]
    floor = block.floor_z_mm - base
    lines = [DrawingLine(a, b) for a, b in pairwise([*outline, outline[0]])]
    lines += [DrawingLine(a, b) for a, b in pairwise([*side, side[0]])]
    lines.append(DrawingLine((beside, floor), (beside + length, floor), thin=True))
    sizes = [
        DrawingDimension((0.0, height), (x - left, height), STEP_MM * (number + 1))
        for number, x in enumerate(block.edges_x_mm[1:])
    ]
    sizes += [
        DrawingDimension((width, 0.0), (width, floor), STEP_MM, upright=True),
        DrawingDimension((width, floor), (width, height), STEP_MM, upright=True),
        DrawingDimension((width, 0.0), (width, height), 2 * STEP_MM, upright=True),
        DrawingDimension((beside, height), (beside + length, height), STEP_MM),
    ]
    below = -STEP_MM / scale
    labels = (
        DrawingLabel((0.0, below), message("drawing-front-view")),
        DrawingLabel((beside, below), message("drawing-side-view")),
    )
    top = height + STEP_MM * (len(block.edges_x_mm) + 0.5) / scale
    return PartDrawing(
        block.name,
        tuple(lines),
        tuple(sizes),
        labels,
        _notes(design),
        scale,
        (0.0, below),
        (beside + length, top),
        3 if min(b - a for a, b in pairwise(block.edges_x_mm)) < 2.0 else 2,
    )


def edge_break_mm(design: BlockDesign) -> float:
    """How far edges may be broken: no further than the tolerance moves them, and half a pixel."""
    return max(min(design.tolerance_mm, design.sensor.pixel_mm / 2), LEAST_BREAK_MM)


def _fits(block: Crenellated, scale: float) -> bool:
    width = block.edges_x_mm[-1] - block.edges_x_mm[0] + block.back_y_mm - block.front_y_mm
    height = block.crest_z_mm - block.base_z_mm
    across = width * scale + APART_MM + 5 * STEP_MM
    up = height * scale + STEP_MM * (len(block.edges_x_mm) + 2)
    return across <= SPACE_MM[0] and up <= SPACE_MM[1]


def _outline(block: Crenellated) -> list[Point]:
    """The front from its lower left corner, anticlockwise."""
    left, base = block.edges_x_mm[0], block.base_z_mm
    return [(x - left, z - base) for x, z in outline_mm(block)]


def _notes(design: BlockDesign) -> tuple[Text, ...]:
    tolerance = design.tolerance_mm
    return (
        message(
            "drawing-tolerance",
            tolerance=rounded(tolerance, "mm"),
            loose=rounded(MEASURED_TOLERANCE_MM, "mm"),
        ),
        message("drawing-flat", within=rounded(tolerance / 2, "mm")),
        message("drawing-edges", largest=rounded(edge_break_mm(design), "mm", 2)),
        message("drawing-surface-without-gloss"),
        message("drawing-material"),
    )
