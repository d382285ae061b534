"""Why the board was not detected in a picture, and where the picture shows it."""

from collections.abc import Sequence
from dataclasses import dataclass
from itertools import product

import cv2
import numpy as np
from numpy.typing import NDArray

from crenel.errors import OperationError
from crenel.messages.limits import beside_limit
from crenel.messages.message import Text, message
from crenel.metrology.chessboard.marked_squares import has_markers
from crenel.metrology.chessboard.missing_corners import Cause, CornerGrid, common_cause
from crenel.metrology.chessboard.slanted_board import (
    LEAST_SPACING_PX,
    explain_slant,
    is_slanted,
)
from crenel.metrology.detection.failure_evidence import (
    DetectionError,
    Fault,
    ImageAnnotation,
    is_raw,
    mark_clipped_regions,
    prefer_image_fault,
)
from crenel.metrology.detection.image_quality import image_findings
from crenel.metrology.image import Image, saturation_level
from crenel.metrology.targets.chessboard import Chessboard

# Share of a grid's corners that shows it to be a whole board.
WHOLE = 0.95
FEWEST_OF_A_GRID, FEWEST_OF_A_SIDE = 4, 3
# The squares of one end of a board are at most so many times as large as those of the other.
NEARER_END = 3.0
FEWEST_SLANTED = 8

_CAUSES: dict[Cause, tuple[Fault, Text, Text]] = {
    "outside": (
        "framing",
        message("board-partly-out-of-picture"),
        message("bring-whole-board-into-picture"),
    ),
    "laser": (
        "framing",
        message("laser-line-covers-others"),
        message("keep-line-off-outermost-corners"),
    ),
    "glare": (
        "lighting",
        message("others-are-overexposed"),
        message("tilt-board-against-reflection-or-shorten-exposure"),
    ),
    "unknown": (
        "framing",
        message("others-are-covered"),
        message("uncover-board-or-give-its-certificate"),
    ),
}


@dataclass(frozen=True)
class BoardFailure:
    """The nearest thing to the board in a picture: which corners there are (N), which of them can
    be measured (N,), and which lie in the one window of the board's size (N,), if there is one.

    ``refused``: every grid in the picture, this one too, as found and as far as it can be measured.
    """

    grid: CornerGrid
    measured: NDArray[np.bool_]
    within: NDArray[np.bool_] | None
    refused: tuple[CornerGrid, ...] = ()

    def measurable_grid(self) -> CornerGrid:
        """The corners that can be measured; what cannot may be no corner at all."""
        return _select(self.grid, self.measured)


def explain_failure(board: Chessboard, failure: BoardFailure) -> DetectionError:
    """The error with its cause, and with the detected lines of the board as marks."""
    grid = failure.grid
    columns, rows = board.inner_corners
    if len(grid.places) < FEWEST_OF_A_GRID:
        refusal = OperationError(
            "board-not-found",
            message("no-chessboard-x-inner-corners-found", columns=columns, rows=rows),
            message("out-picture-covered-too-small-or-another-object"),
            message("bring-whole-board-into-picture-sharp"),
        )
        return _with_image_fault("framing", refusal, grid)
    if failure.within is not None:
        return _explain_unmeasured(board, failure, failure.within)
    slanted = _find_slant(failure)
    if slanted is not None:
        return refuse_slanted(board, slanted)
    return _explain_size(board, failure)


def refuse_slanted(board: Chessboard, grid: CornerGrid) -> DetectionError:
    """The error for a board whose corners are seen at a slant; they may be joined to any size."""
    columns, rows = board.inner_corners
    what = message("no-chessboard-x-inner-corners-found", columns=columns, rows=rows)
    slant = explain_slant(grid.steps_px())
    return _with_marks(OperationError("board-slanted", what, *slant), "framing", grid)


def _find_slant(failure: BoardFailure) -> CornerGrid | None:
    """The nearest grid, or else the largest of the others that lies on it, if it is slanted: the
    corners of a slanted board may also be joined along diagonals."""
    if is_slanted(failure.grid):
        return failure.grid
    if failure.grid.spacing_px() < LEAST_SPACING_PX:  # those of a far board are joined anyhow
        return None
    others = (one for one in failure.refused if len(one.places) >= FEWEST_SLANTED)
    on_it = [one for one in others if is_slanted(one) and _overlap(failure.grid, one)]
    return max(on_it, key=lambda one: len(one.places), default=None)


def is_larger(board: Chessboard, grid: CornerGrid) -> bool:
    """Whether a grid has more columns or rows than the board, whichever way it lies."""
    return bool(
        (np.sort(grid.extent) > np.sort(board.inner_corners)).any() and len(grid.places) > 1
    )


def _explain_unmeasured(
    board: Chessboard, failure: BoardFailure, within: NDArray[np.bool_]
) -> DetectionError:
    """The board is there, and too few of its corners can be measured."""
    grid, measured = failure.grid, failure.measured & within
    columns, rows = board.inner_corners
    what = message(
        "corners-can-measured",
        found=int(measured.sum()),
        corners=columns * rows,
        name=board.name,
    )
    cause = common_cause(grid.causes(grid.places[within & ~measured]))
    if cause == "unknown" and _is_whole(failure.measurable_grid()):
        return _explain_size(board, failure)  # the others are its outline, and no corners
    if cause != "unknown":
        fault, why, remedy = _CAUSES[cause]
        return _with_marks(OperationError("board-partly-seen", what, why, remedy), fault, grid)
    if is_slanted(grid):
        slant = explain_slant(grid.steps_px())
        return _with_marks(OperationError("board-slanted", what, *slant), "framing", grid)
    if grid.spacing_px() < LEAST_SPACING_PX:
        return _with_marks(_too_small(what, grid), "framing", grid)
    if board.markers is None and has_markers(grid.image):
        why, remedy = message("markers-in-white-squares"), message("give-kind-charuco")
        return _with_marks(OperationError("another-board", what, why, remedy), "object", grid)
    refusal = OperationError(
        "board-blurred", what, message("picture-blurred-noisy"), message("focus-light-board-evenly")
    )
    return _with_image_fault("focus", refusal, grid)


def _explain_size(board: Chessboard, failure: BoardFailure) -> DetectionError:
    """No window of the board's size is certain."""
    grid = failure.grid
    columns, rows = board.inner_corners
    seen = failure.measurable_grid() if failure.measured.sum() >= FEWEST_OF_A_GRID else grid
    # given in the certificate's order, whichever way the picture lies
    found = sorted(seen.extent.tolist(), reverse=columns >= rows)
    what = message("chessboard-x-inner-corners-found", columns=found[0], rows=found[1])
    wanted = message("board-has-corners", name=board.name, columns=columns, rows=rows)
    if is_larger(board, seen):
        remedy = message("give-certificate-board-picture")
        return _with_marks(OperationError("another-board", what, wanted, remedy), "object", grid)
    short = sorted(found) != sorted(board.inner_corners)
    if short:
        divided = any(_is_divided(board, seen, other) for other in failure.refused)
        cause = "unknown" if divided else seen.cause_beyond(board.inner_corners)
        if cause == "unknown" and not divided and _is_whole(seen):
            remedy = message("give-certificate-or-uncover-board")
            if (np.sort(board.inner_corners) - np.sort(seen.extent) == 1).all():
                remedy = message("count-inner-corners", columns=columns, rows=rows)
            refusal = OperationError("another-board", what, wanted, remedy)
            return _with_marks(refusal, "object", grid)
    else:
        what = message(
            "corners-were-found", found=len(seen.places), corners=columns * rows, name=board.name
        )
        cause = common_cause(seen.causes(_missing_places(seen)))
    if cause == "unknown" and grid.spacing_px() < LEAST_SPACING_PX:
        return _with_marks(_too_small(what, grid), "framing", grid)
    fault, why, what_to_do = _CAUSES[cause]
    if short:
        why = message("board-has-corners-why", name=board.name, columns=columns, rows=rows, why=why)
    return _with_marks(OperationError("board-partly-seen", what, why, what_to_do), fault, grid)


def _is_divided(board: Chessboard, seen: CornerGrid, other: CornerGrid) -> bool:
    """Whether two grids are the board's ends, with something over the columns between them."""
    if len(other.places) < FEWEST_OF_A_GRID or _overlap(seen, other):
        return False
    small, large = sorted((seen.spacing_px(), other.spacing_px()))
    if large > NEARER_END * small:
        return False
    ends = [sorted(one.extent.tolist()) for one in (seen, other)]
    for along, across in (board.inner_corners, board.inner_corners[::-1]):
        for one, beside in product(*(((a, b), (b, a)) for a, b in ends)):
            whole = all(across - 1 <= end[1] <= across for end in (one, beside))
            if whole and one[0] + beside[0] <= along:
                return True
    return False


def _overlap(seen: CornerGrid, other: CornerGrid) -> bool:
    """Whether one grid lies on the other, as where both are of the same squares."""
    hull = cv2.convexHull(seen.uv_px.astype(np.float32))
    return any(cv2.pointPolygonTest(hull, at, False) >= 0 for at in other.uv_px.tolist())


def _is_whole(grid: CornerGrid) -> bool:
    """Whether hardly a corner is missing within what was found."""
    return bool(
        len(grid.places) >= WHOLE * grid.extent.prod() and min(grid.extent) >= FEWEST_OF_A_SIDE
    )


def _select(grid: CornerGrid, which: NDArray[np.bool_]) -> CornerGrid:
    return CornerGrid(grid.image, grid.laser, grid.places[which], grid.uv_px[which])


def _missing_places(grid: CornerGrid) -> NDArray[np.int64]:
    """(M, 2) places within the grid's extent where no corner is."""
    taken = {tuple(place) for place in grid.places.tolist()}
    low = grid.places.min(axis=0)
    every = [low + (i, j) for i in range(grid.extent[0]) for j in range(grid.extent[1])]
    return np.array([one for one in every if tuple(one.tolist()) not in taken]).reshape(-1, 2)


def _too_small(what: Text, grid: CornerGrid) -> OperationError:
    width, least = beside_limit(grid.spacing_px(), LEAST_SPACING_PX, "px", 1)
    return OperationError(
        "board-too-small",
        what,
        message("squares-too-small-in-picture", width=width, least=least),
        message("bring-camera-nearer-to-board"),
    )


def _with_image_fault(fault: Fault, refusal: OperationError, grid: CornerGrid) -> DetectionError:
    return fail_with_marks(refusal, fault, grid.image, _lines(grid), guessed=True)


def _with_marks(refusal: OperationError, fault: Fault, grid: CornerGrid) -> DetectionError:
    return fail_with_marks(refusal, fault, grid.image, _lines(grid))


def fail_with_marks(
    refusal: OperationError,
    fault: Fault,
    image: Image,
    found: Sequence[ImageAnnotation],
    guessed: bool = False,
) -> DetectionError:
    """The error with what was found, and with overexposed regions where they are its cause.

    Args:
        guessed: its causes are only listed, so that a problem of the picture as such replaces
            them; a picture that is merely soft is named beside them. In a raw picture that is taken
            for grey, nothing else is a cause.
    """
    found_in_image = image_findings(image)
    if guessed or is_raw(found_in_image):
        soft = [one for one in found_in_image if one.code == "image-soft"]
        graver = [one for one in found_in_image if one.code != "image-soft"]
        if soft and not graver:
            _, refusal = prefer_image_fault(fault, refusal, soft)
        fault, refusal = prefer_image_fault(fault, refusal, graver, guessed=True)
    clipped = image >= saturation_level(image)
    marks = mark_clipped_regions(clipped) if fault in ("exposure", "lighting") else []
    return DetectionError(refusal, fault, (*marks, *found))


def _lines(grid: CornerGrid) -> list[ImageAnnotation]:
    """Lines from each detected corner to its neighbours along the row and the column."""
    at = {(i, j): k for k, (i, j) in enumerate(grid.places.tolist())}
    marks = []
    for (i, j), k in at.items():
        for beside in ((i + 1, j), (i, j + 1)):
            if beside in at:
                one, other = grid.uv_px[k].tolist(), grid.uv_px[at[beside]].tolist()
                marks.append(ImageAnnotation("segment", *one, *other))
    return marks
