"""A block's certificate from readings of its faces, and from touches of them."""

from dataclasses import dataclass
from pathlib import Path

import numpy as np

from crenel.errors import OperationError
from crenel.formats.certifying.block_points import TouchingArm, TouchTable, read_touches
from crenel.formats.certifying.block_readings import face_name, name_of_reading, read_readings
from crenel.formats.certifying.block_touch_checks import exchange_refusal, place_table, touch_in_row
from crenel.formats.datasheets.target import (
    COARSEST_MM,
    CoordinateUncertainties,
    ObjectFile,
    read_block,
)
from crenel.messages.message import Text, join, message, quantity, signed
from crenel.metrology.calibration.observation_model import coordinates
from crenel.metrology.targets.block_fit import BlockFit, TouchFit, fit_block, shows_tip
from crenel.metrology.targets.block_readings import TIP, BlockReading, centre_axes, open_faces
from crenel.metrology.targets.crenellated_block import Crenellated
from crenel.metrology.transforms import Floats
from crenel.timestamps import utc_now

MOST_NAMED = 4
"""How many readings that contradict are shown."""


@dataclass(frozen=True)
class BlockCertificate:
    """A block by its readings and touches: what was measured, how it fits, and ``object.json``."""

    drawing: Crenellated
    readings: tuple[BlockReading, ...]
    touches: TouchTable | None
    fit: BlockFit
    document: ObjectFile

    def list_faces(self) -> list[tuple[str, float, float, float]]:
        """Each face by its name, as drawn, as measured, and its standard uncertainty, mm."""
        drawn, found = coordinates(self.drawing), coordinates(self.document.block())
        names = [face_name(face, len(self.document.edges_x_mm)) for face in range(len(drawn))]
        sds = self.document.block().sds_mm
        return list(zip(names, drawn.tolist(), found.tolist(), sds.tolist(), strict=True))


def certify_block(
    drawing: Path,
    readings: Path | None,
    certificate: str,
    points: Path | None = None,
    by: TouchingArm | None = None,
) -> BlockCertificate:
    """The certificate of the block whose ``object.json`` has at least its drawing.

    Args:
        readings: distances of faces; None where the touches tell everything.
        certificate: who certifies it and when, for reports.
        points: touches of the faces.
        by: the arm that took them, where they are joint angles.

    Raises:
        OperationError: as ``read_block``, ``read_readings``, ``read_touches`` and
            ``certify_measured``.
    """
    block = read_block(drawing)
    read = () if readings is None else read_readings(readings, block)
    touched = None if points is None else read_touches(points, block, by)
    return certify_measured(block, read, touched, certificate)


def certify_measured(
    block: Crenellated,
    readings: tuple[BlockReading, ...],
    touched: TouchTable | None,
    certificate: str,
) -> BlockCertificate:
    """The certificate of a block as drawn, by its readings and touches, issued today.

    The axes of its frame stay where the drawing has the mean of the faces.

    Raises:
        OperationError: as ``place_table``; ``nothing-measured``; ``readings-incomplete`` for a face
            that nothing reaches; ``tip-unknown`` for a tip whose diameter nothing shows;
            ``readings-exchanged``, ``touches-exchanged``, or ``readings-contradict`` with every
            reading and touch that contradicts the others; ``certificate-too-coarse``.
    """
    if not readings and touched is None:
        raise OperationError(
            "nothing-measured",
            message("neither-readings-nor-points"),
            "",
            message("give-readings-points-or-both"),
        )
    _refuse_incomplete(readings, touched, block)
    drawn_mm, edges = coordinates(block), len(block.edges_x_mm)
    placed = None if touched is None else place_table(touched, drawn_mm)
    touches = None if touched is None else touched.touches
    fit = fit_block(drawn_mm, readings, touches, None if placed is None else placed.block)
    _refuse_exchanges(readings, touched, fit, edges)
    if placed is not None and placed.refusal is not None:
        raise placed.refusal
    _refuse_contradictions(readings, touched, fit, edges)
    largest_mm = float(np.max(fit.sds_mm))
    if largest_mm > COARSEST_MM:
        raise OperationError(
            "certificate-too-coarse",
            message("face-known-only-to", known=quantity(1e3 * largest_mm, "µm")),
            message("certificate-must-be-known-to", most=quantity(1e3 * COARSEST_MM, "µm")),
            message("add-readings-from-face-known"),
        )
    return BlockCertificate(block, readings, touched, fit, _document(block, fit, certificate))


def _refuse_incomplete(
    readings: tuple[BlockReading, ...], touched: TouchTable | None, block: Crenellated
) -> None:
    edges = len(block.edges_x_mm)
    touches = None if touched is None else touched.touches
    faces = () if touches is None else tuple(dict.fromkeys(touches.faces.tolist()))
    missing = open_faces(readings, edges, faces)
    if missing:
        raise OperationError(
            "readings-incomplete",
            message(
                "readings-miss-faces",
                count=len(missing),
                faces=", ".join(face_name(face, edges) for face in missing),
            ),
            message("readings-must-connect-faces"),
            message("add-readings-from-face-known"),
        )
    if not shows_tip(coordinates(block), readings, touches):
        raise OperationError(
            "tip-unknown",
            message("tip-diameter-not-shown", tool=TIP),
            message("tip-alone-never-shows-diameter"),
            message("add-micrometer-reading-of-width"),
        )


def _document(block: Crenellated, fit: BlockFit, certificate: str) -> ObjectFile:
    edges = len(block.edges_x_mm)
    drawn_mm = coordinates(block)
    values = fit.coordinates_mm + drawn_mm - centre_axes(edges) @ drawn_mm
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
            "issued_on": utc_now()[:10],
            **fields(values),
            "standard_uncertainty_mm": max(each.values_mm()),
            "standard_uncertainties_mm": each,
        }
    )


def _refuse_exchanges(
    readings: tuple[BlockReading, ...], touched: TouchTable | None, fit: BlockFit, edges: int
) -> None:
    if fit.exchanged is not None:
        one, other = (name_of_reading(i, readings, edges) for i in fit.exchanged)
        raise OperationError(
            "readings-exchanged",
            message("readings-agree-if-exchanged", one=one, other=other),
            "",
            message("exchange-readings-or-read-again"),
        )
    if touched is not None and fit.touched is not None and fit.touched.exchanged is not None:
        raise exchange_refusal(touched, fit.touched.exchanged, edges)


def _refuse_contradictions(
    readings: tuple[BlockReading, ...], touched: TouchTable | None, fit: BlockFit, edges: int
) -> None:
    wrong = [
        (name_of_reading(int(i), readings, edges), float(fit.residuals_mm[i]))
        for i in np.flatnonzero(~fit.kept | fit.doubtful)
    ]
    doubtful = bool(fit.doubtful.any())
    if touched is not None and fit.touched is not None:
        wrong += _wrong_touches(touched, fit.touched, edges)
        doubtful = doubtful or bool(fit.touched.doubtful.any())
    if wrong:
        off = [
            message("reading-off-by", reading=row, off=signed(1e3 * residual_mm, "µm"))
            for row, residual_mm in wrong[:MOST_NAMED]
        ]
        raise OperationError(
            "readings-contradict",
            message("readings-contradict-others", count=len(wrong), first=join(off)),
            message("one-of-readings-is-wrong") if doubtful else "",
            message("read-these-again"),
        )


def _wrong_touches(touched: TouchTable, fit: TouchFit, edges: int) -> list[tuple[Text, float]]:
    return [
        (touch_in_row(touched, int(i), edges), float(fit.residuals_mm[i]))
        for i in np.flatnonzero(~fit.kept | fit.doubtful)
    ]
