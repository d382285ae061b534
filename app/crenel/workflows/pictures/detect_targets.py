"""What is seen of a calibration target in pictures: corners, or why there are none."""

from collections.abc import Sequence
from dataclasses import dataclass, replace
from pathlib import Path

import numpy as np

from crenel.errors import OperationError
from crenel.formats.atomic_write import write_atomically
from crenel.formats.csv_table import table_text
from crenel.formats.images import GreyImage, read_grey
from crenel.metrology.bayer import CELL_PX, BayerPlane
from crenel.metrology.channel import Channel
from crenel.metrology.chessboard.detect_board import detect_board
from crenel.metrology.chessboard.laser_light import drop_faint_stripe
from crenel.metrology.detection.detect_block import detect_object
from crenel.metrology.detection.failure_evidence import DetectionError, ImageAnnotation
from crenel.metrology.stripe import Stripe, extract_stripe
from crenel.metrology.targets.chessboard import Chessboard
from crenel.metrology.targets.target import CalibrationTarget
from crenel.metrology.transforms import Floats
from crenel.progress import Progress, no_progress
from crenel.workflows.pictures.extract_stripes import is_unstated_raw

COLUMNS = ("image", "number", "u", "v", "sigma_px", "refusal")


@dataclass(frozen=True)
class DetectedPoint:
    """A corner: its number on a board or its name on a block, where it is, and how sure that is.

    ``sigma_px`` is the standard deviation along the direction in which it is largest.
    """

    number: str
    u: float
    v: float
    sigma_px: float


@dataclass(frozen=True)
class ImageDetection:
    """What a picture shows: corners, or the refusal."""

    file: Path
    corners: tuple[DetectedPoint, ...]
    refusal: OperationError | None = None
    readable: bool = True
    looks_raw: bool = False
    """The pixels alternate as in a raw picture of a colour camera, but were measured as grey."""


def detect_targets(
    images: Sequence[Path],
    target: CalibrationTarget,
    axis: str | None = None,
    channel: Channel | None = None,
    progress: Progress = no_progress,
) -> list[ImageDetection]:
    """Looks for a block or a board in every picture, each by itself.

    A picture that cannot be read is listed with this refusal.

    Args:
        axis: of the laser stripe (``u`` or ``v``), where the pictures show it too.
        channel: what of colour or raw pictures is measured.
    """
    found: list[ImageDetection] = []
    for done, path in enumerate(images):
        progress(done / len(images), path.name)
        try:
            image = read_grey(path, channel)
        except OperationError as unreadable:
            found.append(ImageDetection(path, (), unreadable, readable=False))
            continue
        stripe = None if axis is None else extract_stripe(image, axis)
        try:
            seen = ImageDetection(path, _detect(image, target, stripe))
        except OperationError as refusal:
            seen = ImageDetection(path, (), refusal)
        seen = replace(seen, looks_raw=is_unstated_raw(image, channel))
        found.append(_in_raw_pixels(seen, channel) if isinstance(channel, BayerPlane) else seen)
    progress(1.0, "")
    return found


def _detect(
    image: GreyImage, target: CalibrationTarget, stripe: Stripe | None
) -> tuple[DetectedPoint, ...]:
    if isinstance(target, Chessboard):
        board = detect_board(image, target, stripe and drop_faint_stripe(image, stripe))
        rows = zip(board.number.tolist(), board.uv_px, board.covariance_px2, strict=True)
        return tuple(
            DetectedPoint(str(number), float(uv[0]), float(uv[1]), _largest_sigma_px(covariance))
            for number, uv, covariance in sorted(rows, key=lambda row: row[0])
        )
    block = detect_object(image, target, stripe)
    return tuple(
        DetectedPoint(one.name, one.u, one.v, _largest_sigma_px(one.covariance_px2))
        for one in block.corners
    )


def _in_raw_pixels(seen: ImageDetection, plane: BayerPlane) -> ImageDetection:
    """What a plane of a raw picture shows, in pixels of the picture."""

    def raw(u: float, v: float) -> tuple[float, float]:
        at = plane.raw_px(np.array([u, v]))
        return float(at[0]), float(at[1])

    corners = tuple(
        DetectedPoint(one.number, *raw(one.u, one.v), CELL_PX * one.sigma_px)
        for one in seen.corners
    )
    refusal = seen.refusal
    if isinstance(refusal, DetectionError):
        marks = (
            ImageAnnotation(mark.kind, *raw(mark.u0, mark.v0), *raw(mark.u1, mark.v1))
            for mark in refusal.marks
        )
        refusal = DetectionError(refusal, refusal.fault, tuple(marks))
    return ImageDetection(seen.file, corners, refusal)


def _largest_sigma_px(covariance_px2: Floats) -> float:
    return float(np.sqrt(np.linalg.eigvalsh(covariance_px2)[-1]))


def write_detections(path: Path, found: Sequence[ImageDetection]) -> None:
    """Writes ``image,number,u,v,sigma_px,refusal``: a row a corner, or one with the refusal."""
    rows: list[tuple[float | str, ...]] = []
    for picture in found:
        name = str(picture.file)
        if picture.refusal is not None:
            rows.append((name, "", "", "", "", picture.refusal.code))
        rows.extend((name, one.number, one.u, one.v, one.sigma_px, "") for one in picture.corners)
    write_atomically(path, table_text(COLUMNS, rows).encode())
