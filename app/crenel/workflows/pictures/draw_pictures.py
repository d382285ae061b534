"""Pictures with what was found drawn on them, for people to look at."""

from collections.abc import Iterable, Mapping, Sequence
from pathlib import Path

import cv2
import numpy as np
from numpy.typing import NDArray

from crenel.errors import OperationError
from crenel.formats.atomic_write import write_atomically
from crenel.formats.file_names import display_path
from crenel.formats.images import GreyImage, to_8_bits
from crenel.messages.message import message
from crenel.metrology.detection.failure_evidence import DetectionError
from crenel.metrology.stripe import LineEvidence, PieceReason, Stripe
from crenel.metrology.stripe.line_evidence import PIECE_REASONS
from crenel.workflows.pictures.detect_targets import ImageDetection
from crenel.workflows.pictures.line_reasons import LINE_TEXTS, PIECE_TEXTS, count_pieces

Drawing = NDArray[np.uint8]
Colour = tuple[int, int, int]
FOUND, LINE, EVIDENCE = (60, 200, 60), (60, 60, 255), (0, 160, 255)
"""Blue, green, red."""
PIECES: Mapping[PieceReason, Colour] = {
    "main": LINE,
    "bright": (200, 60, 255),
    "continued": (60, 160, 255),
    "dim": (255, 160, 60),
    "ghost": (255, 255, 60),
    "no-line": EVIDENCE,
}
TEXT = (255, 255, 255)
TEXT_PX = 900
"""Texts are legible on a picture so wide; larger ones get larger texts."""


def draw_detection(image: GreyImage, found: ImageDetection) -> Drawing:
    """Corners with their numbers; of a refused picture, what was found of the object."""
    drawing, size = _canvas(image)
    for corner in found.corners:
        at = (round(corner.u), round(corner.v))
        cv2.circle(drawing, at, round(4 * size), FOUND, round(size), cv2.LINE_AA)
        beside = (at[0] + round(5 * size), at[1] - round(5 * size))
        cv2.putText(drawing, corner.number, beside, 0, 0.4 * size, FOUND, round(size), cv2.LINE_AA)
    if isinstance(found.refusal, DetectionError):
        for mark in found.refusal.marks:
            ends = (round(mark.u0), round(mark.v0)), (round(mark.u1), round(mark.v1))
            cv2.line(drawing, *ends, EVIDENCE, round(size), cv2.LINE_AA)
    return drawing


def draw_outcome(
    image: GreyImage,
    corners: Iterable[tuple[float, float]],
    stripe: Iterable[tuple[float, float]],
    marks: Iterable[tuple[float, float, float, float]],
) -> Drawing:
    """Corners, points of the stripe, and lines (u0, v0, u1, v1) that show why a picture was
    refused."""
    drawing, size = _canvas(image)
    for u, v in stripe:
        cv2.circle(drawing, (round(u), round(v)), round(size), LINE, -1)
    for u0, v0, u1, v1 in marks:
        ends = (round(u0), round(v0)), (round(u1), round(v1))
        cv2.line(drawing, *ends, EVIDENCE, round(size), cv2.LINE_AA)
    for u, v in corners:
        cv2.circle(drawing, (round(u), round(v)), round(4 * size), FOUND, round(size), cv2.LINE_AA)
    return drawing


def draw_stripe(image: GreyImage, stripe: Stripe, why: LineEvidence | None = None) -> Drawing:
    """The points of a stripe; those that were left, and in words what decided, where it is known.

    Each point has the colour of the evidence that took or left it.
    """
    drawing, size = _canvas(image)
    reasons = np.zeros(len(stripe.u), np.int64)
    if why is not None and len(why.taken) == len(reasons):
        reasons = why.taken.astype(np.int64)
    for u, v, reason in zip(stripe.u, stripe.v, reasons, strict=True):
        cv2.circle(drawing, (round(u), round(v)), round(size), PIECES[PIECE_REASONS[reason]], -1)
    if why is None:
        return drawing
    for along, across, reason in zip(why.along, why.across, why.left, strict=True):
        at = (round(along), round(across))
        at = at if stripe.axis == "u" else at[::-1]
        cv2.circle(drawing, at, round(size), PIECES[PIECE_REASONS[reason]], -1)
    lines = [(str(LINE_TEXTS[why.decision]), TEXT)]
    for name, count in count_pieces(why):
        lines.append((f"{PIECE_TEXTS[name]!s} ({count})", PIECES[name]))
    return _write_below(drawing, lines, size)


def _write_below(drawing: Drawing, lines: Sequence[tuple[str, Colour]], size: float) -> Drawing:
    """The drawing with lines of text below it, each in its colour."""
    height, step = drawing.shape[0], round(18 * size)
    more = step * len(lines) + step // 2
    drawing = np.asarray(cv2.copyMakeBorder(drawing, 0, more, 0, 0, cv2.BORDER_CONSTANT), np.uint8)
    for number, (text, colour) in enumerate(lines, 1):
        at = (round(8 * size), height + step * number)
        cv2.putText(drawing, text, at, 0, 0.45 * size, colour, round(size), cv2.LINE_AA)
    return drawing


def write_drawings(folder: Path, drawings: Iterable[tuple[Path, Drawing]]) -> None:
    """Writes each picture's drawing as PNG under the picture's own name.

    Raises:
        OperationError: two pictures have one name, or the folder cannot be written.
    """
    names: set[str] = set()
    for path, drawing in drawings:
        name = f"{path.stem}.png"
        if name in names:
            raise OperationError(
                "drawings-of-one-name",
                message("two-pictures-named", name=path.stem, folder=display_path(folder)),
                remedy=message("draw-pictures-of-each-folder-apart"),
            )
        names.add(name)
        folder.mkdir(parents=True, exist_ok=True)
        write_atomically(folder / name, encode_drawing(drawing))


def encode_drawing(drawing: Drawing) -> bytes:
    """A drawing as PNG."""
    return cv2.imencode(".png", drawing)[1].tobytes()


def _canvas(image: GreyImage) -> tuple[Drawing, float]:
    """The picture in colour with 8 bits, and how thick lines must be."""
    grey = to_8_bits(image)
    size = max(1.0, max(image.shape) / TEXT_PX)
    return np.asarray(cv2.cvtColor(grey, cv2.COLOR_GRAY2BGR), np.uint8), size
