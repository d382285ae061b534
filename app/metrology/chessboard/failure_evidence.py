"""What of a refused picture of a chessboard is at fault, and where in the picture that shows."""

from app.errors import Refusal
from app.metrology.chessboard.grid import Lattice
from app.metrology.chessboard.saddle_points import Saddles
from app.metrology.detection.failure_evidence import (
    DetectionRefusal,
    Fault,
    Mark,
    by_picture,
    clipped_regions,
)
from app.metrology.detection.image_quality import picture_findings
from app.metrology.image import Image, saturation_level

_FAULTS: dict[str, Fault] = {
    "board-not-found": "framing",
    "board-partly-seen": "framing",
    "board-blurred": "focus",
    "another-board": "object",
}


def with_board_evidence(
    refusal: Refusal, image: Image, saddles: Saddles, lattice: Lattice
) -> DetectionRefusal:
    """The refusal with what is at fault, and what was found of the board's lines as marks."""
    fault = _FAULTS[refusal.code]
    if refusal.code in ("board-not-found", "board-blurred"):
        fault, refusal = by_picture(fault, refusal, picture_findings(image), guessed=True)
    marks = clipped_regions(image >= saturation_level(image)) if fault == "exposure" else []
    return DetectionRefusal(refusal, fault, (*marks, *_lines(saddles, lattice)))


def _lines(saddles: Saddles, lattice: Lattice) -> list[Mark]:
    """From each corner that was found to its neighbours along the row and the column."""
    marks = []
    for (i, j), saddle in lattice.items():
        for beside in ((i + 1, j), (i, j + 1)):
            if beside in lattice:
                one, other = (saddles.uv_px[k].tolist() for k in (saddle, lattice[beside]))
                marks.append(Mark("segment", *one, *other))
    return marks
