"""``deviation.zip`` beside a scan: its map, what it rests on, and what is needed to show it again.

One file, so that it is replaced as a whole: ``deviation.json``, ``map.ply``, and tables of cells
and of the part's triangles as NumPy writes them.
"""

import io
import zipfile
from collections.abc import Mapping
from dataclasses import dataclass
from pathlib import Path
from typing import ClassVar, Literal

import numpy as np
from numpy.typing import NDArray

from crenel.errors import OperationError
from crenel.formats.atomic_write import atomic_file
from crenel.formats.file_names import display_path
from crenel.formats.io_errors import convert_io_errors
from crenel.formats.json_document import Document, DocumentPart, Matrix4, Number, Software
from crenel.formats.open_file import open_file
from crenel.messages.message import Text, message
from crenel.metrology.transforms import Floats
from crenel.parts.deviation.document_map import MAP, map_bytes, rows_of_map

COMPARISON = "deviation.zip"
JSON, CELLS, VERTICES, TRIANGLES = "deviation.json", "cells.npy", "vertices.npy", "triangles.npy"
DAMAGED = (zipfile.BadZipFile, ValueError, KeyError, EOFError)


class MapCounts(DocumentPart):
    """How many cells are decided how."""

    inside: int
    outside: int
    undecided: int


class ProfileResult(DocumentPart):
    """The tolerance of the whole surface as one decision."""

    decision: Literal["pass", "fail", "undecided"]
    probability: float
    """That all of the surface is within its limits."""


class ComparisonFile(Document):
    """A scan against its part; deviations are positive outside of the material."""

    FORMAT: ClassVar[str] = "crenel/deviation"

    scan: str
    """Id of the scan."""
    scan_name: Text
    part: str
    """Name of the part's file."""
    part_sha256: str
    unit: str
    """Of the part's numbers, as its file or its user states it."""
    made_at: str
    calibration_id: str
    uncertainty: Literal["full", "scatter"]
    """Scatter: what calibration and arm add is not known, and nothing is decided."""
    lower_mm: Number
    upper_mm: Number
    cell_mm: Number
    T_arm_part: Matrix4
    residual_um: float | None = None
    """Median distance of the scan from the part in the best fit."""
    locked: tuple[str, ...] = ()
    cells: int
    points: int
    beyond: int
    """Points farther than 2 mm from the part, which are left out."""
    at_edges: int
    least_um: float
    median_um: float
    most_um: float
    scatter_um: float
    standard_uncertainty_um: float | None = None
    """Median over the cells."""
    budget_um: dict[str, float]
    """Rms over the cells of the standard uncertainty by each source."""
    counts: MapCounts
    profile: ProfileResult | None = None
    out_by_chance: float | None = None
    guard_factor: Number
    warnings: tuple[Text, ...] = ()
    software: Software


@dataclass(frozen=True)
class PartComparison:
    """All of ``deviation.zip``."""

    document: ComparisonFile
    rows: NDArray[np.void]
    """(C,) of ``document_map.CELL``."""
    normals: Floats
    """(C, 3) unit, outwards, part frame."""
    chord_um: Floats
    """(C,) how far the curved surface may be from its facets."""
    scatter_um: Floats
    """(C,) standard deviation of the distances of a cell's points."""
    variances_um2: Mapping[str, Floats]
    """(C,) by source, which add up to the square of the standard uncertainty; empty: scatter
    only."""
    vertices_mm: Floats
    """(V, 3) of the part, part frame."""
    triangles: NDArray[np.int32]
    """(T, 3)"""

    @property
    def at_mm(self) -> Floats:
        """(C, 3) places of the cells on the part."""
        return np.column_stack([self.rows[axis] for axis in "xyz"]).astype(np.float64)


def write_comparison(path: Path, made: PartComparison) -> None:
    """Writes the file whole, or not at all; raises ``OperationError``."""
    columns = {
        "normal": made.normals.astype(np.float32),
        "chord_um": made.chord_um.astype(np.float32),
        "scatter_um": made.scatter_um.astype(np.float32),
    }
    columns |= {f"by_{name}": one.astype(np.float32) for name, one in made.variances_um2.items()}
    kinds = [(name, "<f4", one.shape[1:]) for name, one in columns.items()]
    table = np.zeros(len(made.rows), np.dtype(kinds))
    for name, one in columns.items():
        table[name] = one
    members = {
        CELLS: table,
        VERTICES: made.vertices_mm.astype(np.float32),
        TRIANGLES: made.triangles.astype(np.int32),
    }
    with (
        atomic_file(path) as file,
        zipfile.ZipFile(file, "w", zipfile.ZIP_DEFLATED, compresslevel=1) as packed,
    ):
        packed.writestr(JSON, made.document.text())
        packed.writestr(MAP, map_bytes(made.rows))
        for name, array in members.items():
            content = io.BytesIO()
            np.lib.format.write_array(content, array, allow_pickle=False)
            packed.writestr(name, content.getvalue())


def read_document(path: Path) -> ComparisonFile:
    """What the file says of its map; raises ``OperationError`` where it cannot be read."""
    return ComparisonFile.parse_text(read_member(path, JSON).decode("utf-8", "replace"), path)


def read_member(path: Path, name: str) -> bytes:
    """One of the files in it; raises ``OperationError`` where it cannot be read."""
    with convert_io_errors(path), open_file(path) as file:
        try:
            with zipfile.ZipFile(file) as packed:
                return packed.read(name)
        except DAMAGED as error:
            raise _damage_error(path) from error


def read_comparison(path: Path) -> PartComparison:
    """The whole file; raises ``OperationError`` where it cannot be read."""
    document = read_document(path)
    try:
        rows = rows_of_map(read_member(path, MAP))
        table, vertices, triangles = (
            np.lib.format.read_array(io.BytesIO(read_member(path, name)), allow_pickle=False)
            for name in (CELLS, VERTICES, TRIANGLES)
        )
        names = [name for name in table.dtype.names or () if name.startswith("by_")]
        return PartComparison(
            document,
            rows,
            table["normal"].astype(np.float64),
            table["chord_um"].astype(np.float64),
            table["scatter_um"].astype(np.float64),
            {name.removeprefix("by_"): table[name].astype(np.float64) for name in names},
            vertices.astype(np.float64),
            triangles,
        )
    except DAMAGED as error:
        raise _damage_error(path) from error


def _damage_error(path: Path) -> OperationError:
    return OperationError(
        "comparison-damaged",
        message("compare-file-damaged", path=display_path(path)),
        "",
        message("compare-again"),
    )
