"""Reads the file of a part, and compares a finished scan with it: what a station's processes do."""

from dataclasses import dataclass
from datetime import UTC, datetime
from pathlib import Path

import numpy as np

from crenel.errors import OperationError
from crenel.formats.file_names import display_path, register_data_folder
from crenel.formats.io_errors import convert_io_errors
from crenel.formats.json_document import SOFTWARE, file_sha256
from crenel.messages.message import Message, Text, message, replace_name
from crenel.parts.cad.evaluate_part import Part, read_part
from crenel.parts.compare.document_comparison import (
    ComparisonFile,
    MapCounts,
    PartComparison,
    ProfileResult,
    write_comparison,
)
from crenel.parts.compare.document_part import PART, KeptPart
from crenel.parts.compare.evaluate_process import step
from crenel.parts.compare.maths_squares import thin_triangles
from crenel.parts.deviation.evaluate_deviation import DeviationOrder, DeviationResult, deviate
from crenel.parts.deviation.maths_decisions import IN, OUT, UNDECIDED, DeviationLimits
from crenel.progress import Progress

ASKED = ("part-without-unit", "part-has-bodies")
"""Notes that a page asks about instead."""
MOST_SHOWN = 300_000
"""Triangles of the part that a browser draws."""
PART_SHARE = 0.1


@dataclass(frozen=True)
class PartOrder:
    """A file in its folder, of which ``part.json`` is to be written."""

    data: Path
    """The station's data folder."""
    folder: Path
    file: str
    name: str


def examine_part(order: PartOrder, progress: Progress) -> None:
    """Reads the file of a part and writes what it holds beside it.

    Raises:
        OperationError: as ``read_part``; no ``part.json`` is written then.
    """
    register_data_folder(order.data)
    progress(0.1, message("compare-reading-part"))
    part = _read(order.folder / order.file, order.name)
    x, y, z = part.mesh.size_mm.tolist()
    known = KeptPart(
        name=order.name,
        file=order.file,
        added_at=_now(),
        form=part.form,
        has_unit=part.has_unit,
        size=(x, y, z),
        triangles=len(part.mesh.triangles),
        is_closed=part.is_closed,
        bodies=part.bodies,
        notes=_notes(part),
    )
    known.write(order.folder / PART)


@dataclass(frozen=True)
class ComparisonOrder:
    """A finished scan, the part that it is of, and what is permitted."""

    data: Path
    """The station's data folder."""
    scan: str
    scan_name: Text
    source: Path
    """Its recording; its cloud where that is all there is."""
    calibration: Path | None
    """Beside the arm's file."""
    calibration_id: str
    arm: Path | None
    part: Path
    """The part's file."""
    part_name: str
    unit: str | None
    body: int | None
    limits: DeviationLimits
    locked: tuple[str, ...]
    output: Path


def compare_scan(order: ComparisonOrder, progress: Progress) -> None:
    """Compares a scan with a part and writes ``deviation.zip``.

    Raises:
        OperationError: as ``read_part`` and ``deviate``; nothing is written then.
    """
    register_data_folder(order.data)
    progress(0.0, message("compare-reading-part"))
    part = _read(order.part, order.part_name, order.unit, order.limits.width_mm, order.body)
    asked = DeviationOrder(
        order.source,
        part,
        order.calibration,
        order.arm,
        limits=order.limits,
        locked=order.locked,
    )
    reading = message("compare-rebuilding-points")
    result = deviate(asked, step(reading, PART_SHARE, 0.95, progress))
    progress(0.95, message("compare-saving"))
    write_comparison(order.output, _comparison(order, part, asked, result))


def _read(
    path: Path,
    name: str,
    unit: str | None = None,
    tolerance_mm: float | None = None,
    body: int | None = None,
) -> Part:
    """As ``read_part``; a refusal calls the file as its user does."""
    try:
        return read_part(path, unit, tolerance_mm, body)
    except OperationError as error:
        own = str(display_path(path))
        texts = (replace_name(one, own, name) for one in (error.what, error.why, error.remedy))
        raise OperationError(error.code, *texts) from error


def _notes(part: Part) -> tuple[Text, ...]:
    return tuple(
        one for one in part.notes if not (isinstance(one, Message) and one.message_id in ASKED)
    )


def _warning(text: Text) -> Text:
    """What a command says of a cloud, said of a kept scan."""
    if isinstance(text, Message) and text.message_id == "part-cloud-has-scatter-only":
        return message("compare-cloud-has-scatter-only")
    return text


def _comparison(
    order: ComparisonOrder, part: Part, asked: DeviationOrder, result: DeviationResult
) -> PartComparison:
    cells = result.placed.cells
    vertices, triangles = thin_triangles(part.mesh.vertices_mm, part.mesh.triangles, MOST_SHOWN)
    return PartComparison(
        _document(order, asked, result),
        result.rows(),
        cells.normals,
        1e3 * cells.chord_error_mm,
        1e3 * cells.scatter_mm,
        {name: 1e6 * one for name, one in result.variances_mm2.items()},
        vertices,
        triangles,
    )


def _document(
    order: ComparisonOrder, asked: DeviationOrder, result: DeviationResult
) -> ComparisonFile:
    placed, profile = result.placed, result.profile
    cells, off = placed.cells, 1e3 * placed.cells.deviation_mm
    with convert_io_errors(order.part):
        digest = file_sha256(order.part)
    is_known = bool(np.isfinite(result.u_mm).all())
    fields = {
        "scan": order.scan,
        "scan_name": order.scan_name,
        "part": order.part_name,
        "part_sha256": digest,
        "unit": asked.part.unit,
        "made_at": _now(),
        "calibration_id": order.calibration_id,
        "uncertainty": "full" if is_known else "scatter",
        "lower_mm": order.limits.lower_mm,
        "upper_mm": order.limits.upper_mm,
        "cell_mm": asked.cell_mm,
        "T_arm_part": result.pose_of_part.tolist(),
        "residual_um": None if placed.fit is None else 1e3 * placed.fit.residual_mm,
        "locked": order.locked,
        "cells": len(cells),
        "points": int(cells.count.sum()),
        "beyond": cells.beyond,
        "at_edges": cells.at_edges,
        "least_um": float(off.min()),
        "median_um": float(np.median(off)),
        "most_um": float(off.max()),
        "scatter_um": 1e3 * float(np.median(cells.scatter_mm)),
        "standard_uncertainty_um": 1e3 * float(np.median(result.u_mm)) if is_known else None,
        "budget_um": result.budget_um,
        "counts": MapCounts(
            inside=result.count(IN), outside=result.count(OUT), undecided=result.count(UNDECIDED)
        ),
        "profile": None
        if profile is None
        else ProfileResult(decision=profile.decision, probability=profile.probability),
        "out_by_chance": result.by_chance,
        "guard_factor": asked.rule.guard_factor,
        "warnings": (*_notes(asked.part), *map(_warning, result.warnings)),
        "software": SOFTWARE,
    }
    return ComparisonFile.model_validate(fields)


def _now() -> str:
    return datetime.now(UTC).isoformat(timespec="seconds")
