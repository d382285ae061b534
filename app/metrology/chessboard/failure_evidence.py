"""Why the board was not detected in a picture, and where the picture shows it."""

from app.errors import OperationError
from app.metrology.chessboard.lattice import Lattice
from app.metrology.chessboard.saddle_points import Saddles
from app.metrology.detection.failure_evidence import (
    DetectionError,
    Fault,
    ImageAnnotation,
    mark_clipped_regions,
    prefer_image_fault,
)
from app.metrology.detection.image_quality import image_findings
from app.metrology.image import Image, saturation_level

_FAULTS: dict[str, Fault] = {
    "board-not-found": "framing",
    "board-partly-seen": "framing",
    "board-blurred": "focus",
    "another-board": "object",
}


def with_board_evidence(
    refusal: OperationError, image: Image, saddles: Saddles, lattice: Lattice
) -> DetectionError:
    """The error with its cause, and with the detected lines of the board as marks."""
    fault = _FAULTS[refusal.code]
    if refusal.code in ("board-not-found", "board-blurred"):
        fault, refusal = prefer_image_fault(fault, refusal, image_findings(image), guessed=True)
    marks = mark_clipped_regions(image >= saturation_level(image)) if fault == "exposure" else []
    return DetectionError(refusal, fault, (*marks, *_lines(saddles, lattice)))


def _lines(saddles: Saddles, lattice: Lattice) -> list[ImageAnnotation]:
    """Lines from each detected corner to its neighbours along the row and the column."""
    marks = []
    for (i, j), saddle in lattice.items():
        for beside in ((i + 1, j), (i, j + 1)):
            if beside in lattice:
                one, other = (saddles.uv_px[k].tolist() for k in (saddle, lattice[beside]))
                marks.append(ImageAnnotation("segment", *one, *other))
    return marks
