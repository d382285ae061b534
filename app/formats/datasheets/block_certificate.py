"""A block's certificate from readings of its faces."""

from dataclasses import dataclass
from pathlib import Path

import numpy as np

from app.errors import OperationError
from app.formats.datasheets.block_readings import face_name, read_readings
from app.formats.datasheets.target import (
    COARSEST_MM,
    CoordinateUncertainties,
    ObjectFile,
    read_block,
)
from app.messages.message import Text, message, quantity, signed
from app.metrology.calibration.observation_model import coordinates
from app.metrology.targets.block_readings import BlockReading, ReadingFit, fit_readings
from app.metrology.targets.crenellated_block import Crenellated
from app.metrology.transforms import Floats


@dataclass(frozen=True)
class BlockCertificate:
    """A block by its readings: what was read, how it fits, and ``object.json``."""

    drawing: Crenellated
    readings: tuple[BlockReading, ...]
    fit: ReadingFit
    document: ObjectFile


def certify_block(drawing: Path, readings: Path, certificate: str) -> BlockCertificate:
    """The certificate of the block whose ``object.json`` has at least its drawing.

    The axes of its frame stay where the drawing has the mean of the faces.

    Args:
        certificate: who certifies it and when, for reports.

    Raises:
        OperationError: as ``read_block`` and ``read_readings``; ``readings-contradict`` with every
            reading that contradicts the others; ``certificate-too-coarse``.
    """
    block = read_block(drawing)
    read = read_readings(readings, block)
    fit = fit_readings(read, len(block.edges_x_mm))
    _refuse_contradictions(read, fit, len(block.edges_x_mm))
    largest_mm = float(np.max(fit.sds_mm))
    if largest_mm > COARSEST_MM:
        raise OperationError(
            "certificate-too-coarse",
            message("face-known-only-to", known=quantity(1e3 * largest_mm, "µm")),
            message("certificate-must-be-known-to", most=quantity(1e3 * COARSEST_MM, "µm")),
            message("add-readings-from-face-known"),
        )
    return BlockCertificate(block, read, fit, _document(block, fit, certificate))


def _document(block: Crenellated, fit: ReadingFit, certificate: str) -> ObjectFile:
    edges = len(block.edges_x_mm)
    values = fit.coordinates_mm + _means(coordinates(block), edges)
    names = ("front_y_mm", "back_y_mm", "crest_z_mm", "floor_z_mm", "base_z_mm")

    def fields(of: Floats) -> dict[str, object]:
        # to the nanometre, which no reading reaches
        rounded = [round(float(value), 6) for value in of]
        return {"edges_x_mm": rounded[:edges], **dict(zip(names, rounded[edges:], strict=True))}

    each = CoordinateUncertainties.model_validate(fields(fit.sds_mm))
    return ObjectFile.model_validate(
        {
            "name": block.name,
            "serial_number": block.serial_number,
            "certificate": certificate,
            **fields(values),
            "standard_uncertainty_mm": max(each.values_mm()),
            "standard_uncertainties_mm": each,
        }
    )


def _means(values: Floats, edges: int) -> Floats:
    """(B,) the mean of each axis, for each of its faces."""
    parts = (values[:edges], values[edges : edges + 2], values[edges + 2 :])
    return np.concatenate([np.full(len(part), part.mean()) for part in parts])


def _refuse_contradictions(readings: tuple[BlockReading, ...], fit: ReadingFit, edges: int) -> None:
    if fit.exchanged is not None:
        one, other = (_row(i, readings, edges) for i in fit.exchanged)
        raise OperationError(
            "readings-exchanged",
            message("readings-agree-if-exchanged", one=one, other=other),
            "",
            message("exchange-readings-or-read-again"),
        )
    wrong = np.flatnonzero(~fit.kept | fit.doubtful)
    if len(wrong):
        off = [
            message(
                "reading-off-by",
                reading=_row(int(i), readings, edges),
                off=signed(1e3 * float(fit.residuals_mm[i]), "µm"),
            )
            for i in wrong[:4]
        ]
        raise OperationError(
            "readings-contradict",
            message("readings-contradict-others", count=len(wrong), first=off[0]),
            message("one-of-readings-is-wrong") if fit.doubtful.any() else "",
            message("read-these-again"),
        )


def _row(index: int, readings: tuple[BlockReading, ...], edges: int) -> Text:
    one = readings[index]
    return message(
        "reading-in-row",
        number=index + 1,
        first=face_name(one.first, edges),
        second=face_name(one.second, edges),
    )
