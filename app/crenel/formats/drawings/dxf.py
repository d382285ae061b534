"""A drawing as DXF, with true dimensions, by the library ezdxf of the extra ``cad``."""

import importlib.util
import io
from pathlib import Path
from typing import Any

from crenel.formats.atomic_write import write_atomically
from crenel.formats.drawings.drawing import PartDrawing, scale_text
from crenel.formats.optional_library import import_library
from crenel.messages.catalogue import Render
from crenel.messages.message import Text, join, message

TEXT_MM = 2.5
"""Height of texts and dimensions on paper."""
EDGES, FINE, SIZES, NOTES = "EDGES", "THIN", "DIMENSIONS", "NOTES"
VERSION = "R2010"
LIBRARY = "ezdxf"


def write_dxf(path: Path, drawing: PartDrawing, render: Render) -> None:
    """Writes the part at its true size, in mm, with dimensions and notes on layers of their own.

    Raises:
        OperationError: ``extra-missing``, where ezdxf is not installed; the file cannot be written.
    """
    document = import_library(path, LIBRARY, *_missing()).new(VERSION, setup=True, units=4)
    space = document.modelspace()
    for layer in (EDGES, FINE, SIZES, NOTES):
        document.layers.add(layer)
    unit = 1 / drawing.scale
    for line in drawing.lines:
        layer = FINE if line.thin else EDGES
        space.add_line(line.start, line.end, dxfattribs={"layer": layer})
    _add_dimensions(space, drawing, unit)
    for label in drawing.labels:
        _add_text(space, render(label.text), label.at, TEXT_MM * unit)
    lines = [render(drawing.title), *map(render, drawing.notes)]
    lines.append(render(message("drawing-scale", scale=scale_text(drawing.scale))))
    for number, text in enumerate(lines):
        at = (drawing.low[0], drawing.low[1] - (number + 2) * 2 * TEXT_MM * unit)
        _add_text(space, text, at, TEXT_MM * unit)
    stream = io.StringIO()
    document.write(stream)
    write_atomically(path, stream.getvalue().encode(document.output_encoding, "dxfreplace"))


def dxf_obstacle() -> Text:
    """What to install before a DXF can be written; empty if nothing is missing."""
    return "" if importlib.util.find_spec(LIBRARY) is not None else join(_missing(), ". ")


def _missing() -> tuple[Text, Text]:
    """That the library is missing, and what to do."""
    return message("dxf-requires-package"), message("install-extra", extra="cad")


def _add_dimensions(space: Any, drawing: PartDrawing, unit: float) -> None:
    style = {
        "dimtxt": TEXT_MM * unit,
        "dimasz": TEXT_MM * unit,
        "dimexe": 0.5 * TEXT_MM * unit,
        "dimexo": 0.3 * TEXT_MM * unit,
        "dimgap": 0.3 * TEXT_MM * unit,
        "dimdec": drawing.decimals,
        "dimscale": 1.0,
        "dimlfac": 1.0,
    }
    for size in drawing.dimensions:
        away = size.away_mm * unit
        base = (size.start[0] + away, 0.0) if size.upright else (0.0, size.start[1] + away)
        space.add_linear_dim(
            base=base,
            p1=size.start,
            p2=size.end,
            angle=90 if size.upright else 0,
            dimstyle="EZDXF",
            override=style,
            dxfattribs={"layer": SIZES},
        ).render()


def _add_text(space: Any, text: str, at: tuple[float, float], height: float) -> None:
    attributes = {"layer": NOTES, "height": height, "insert": at}
    space.add_text(text, dxfattribs=attributes)
