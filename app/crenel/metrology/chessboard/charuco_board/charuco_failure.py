"""Why a ChArUco board was not found: another board, a mirrored picture, or markers not readable.

An arrangement is judged by three markers or more. What costs time is looked for only here.
"""

from crenel.errors import OperationError
from crenel.messages.message import Text, message
from crenel.metrology.chessboard.charuco_board.arrangement import (
    Arrangement,
    arrangement_of,
    find_arrangement,
)
from crenel.metrology.chessboard.charuco_board.marker_reading import (
    SCALES,
    BoardReading,
    MarkerReading,
    read_dictionary,
)
from crenel.metrology.chessboard.charuco_board.unread_markers import explain_unread
from crenel.metrology.chessboard.failure_evidence import fail_with_marks
from crenel.metrology.chessboard.marked_squares import LARGEST
from crenel.metrology.detection.failure_evidence import DetectionError
from crenel.metrology.image import Image
from crenel.metrology.targets.chessboard import DICTIONARIES, Chessboard, Markers

CODE = "another-board"
# Dictionaries whose markers may be read instead of the certificate's.
OTHERS = (
    *LARGEST,
    "DICT_ARUCO_ORIGINAL",
    "DICT_ARUCO_MIP_36h12",
    "DICT_APRILTAG_16h5",
    "DICT_APRILTAG_25h9",
    "DICT_APRILTAG_36h10",
)


def explain_markers(
    image: Image, board: Chessboard, markers: Markers, reading: BoardReading, *, thorough: bool
) -> DetectionError:
    """The error for a picture in which too few corners lie between markers of the board.

    Args:
        image: (H, W) grey, 8 to 16 bits.
        reading: what was read of the board's dictionary.
        thorough: also look for mirrored markers, and for those of other dictionaries.
    """
    found = find_arrangement(reading, board, markers)
    if found is not None and found != arrangement_of(board, markers):
        refusal = _explain_arrangement(board, markers, reading, found)
        return fail_with_marks(refusal, "object", image, reading.annotations)
    if found is None and thorough:
        other = _explain_mirrored(image, board, markers)
        other = other or _explain_dictionary(image, board, markers)
        if other is not None:
            return other
    return explain_unread(image, board, markers, reading, thorough=thorough)


def refuse_arrangement(
    image: Image, board: Chessboard, markers: Markers, reading: BoardReading
) -> DetectionError:
    """The error for many corners that are not where the certificate has them."""
    found = find_arrangement(reading, board, markers)
    if found is not None:
        refusal = _explain_arrangement(board, markers, reading, found)
    else:
        refusal = OperationError(
            CODE,
            message(
                "markers-were-found", count=len(reading.markers), dictionary=markers.dictionary
            ),
            message("markers-not-arranged-so", name=board.name),
            message("give-certificate-of-charuco-board"),
        )
    return fail_with_marks(refusal, "object", image, reading.annotations)


def _explain_arrangement(
    board: Chessboard, markers: Markers, reading: MarkerReading, found: Arrangement
) -> OperationError:
    """The numbers that the markers have instead of those of the certificate."""
    stated = arrangement_of(board, markers)
    columns, rows = (count + 1 for count in board.inner_corners)
    if found.squares_x == columns and found.first_id != markers.first_id:
        ids = {"first": int(reading.markers.min()), "last": int(reading.markers.max())}
        return OperationError(
            CODE,
            message("markers-have-ids", dictionary=markers.dictionary, **ids),
            message(
                "board-has-ids",
                name=board.name,
                first=markers.first_id,
                last=markers.first_id + columns * rows // 2 - 1,
            ),
            message("state-first-id", first=found.first_id),
        )
    if found.squares_x == columns and found.first_is_white != stated.first_is_white:
        white, legacy = message("upper-left-square-black"), "false"
        if found.first_is_white:
            white, legacy = message("upper-left-square-white"), "true"
        why = message("board-is-otherwise", name=board.name)
        return OperationError(CODE, white, why, message("state-legacy-pattern", legacy=legacy))
    return _other_squares(board, markers, reading, found)


def _other_squares(
    board: Chessboard, markers: Markers, reading: MarkerReading, found: Arrangement
) -> OperationError:
    columns, rows = (count + 1 for count in board.inner_corners)
    least = int(found.places(reading.markers)[:, 1].max()) + 1
    if found.squares_x == rows and least <= columns:
        least = columns  # both are exchanged
    remedy: Text = message("state-squares", columns=found.squares_x, rows=least)
    if found.first_id != markers.first_id:
        remedy = message(
            "state-squares-and-first-id",
            columns=found.squares_x,
            rows=least,
            first=found.first_id,
        )
    return OperationError(
        CODE,
        message("markers-arranged-so", columns=found.squares_x, rows=least),
        message("board-has-squares", name=board.name, columns=columns, rows=rows),
        remedy,
    )


def _explain_mirrored(image: Image, board: Chessboard, markers: Markers) -> DetectionError | None:
    """Markers that the mirrored picture has, if they are arranged as on any board."""
    flipped = read_dictionary(image[:, ::-1].copy(), markers.dictionary, SCALES)
    if find_arrangement(flipped, board, markers) is None:
        return None
    refusal = OperationError(
        "board-mirrored",
        message("picture-mirrored"),
        message(
            "markers-read-if-mirrored",
            count=len(flipped.markers),
            dictionary=markers.dictionary,
        ),
        message("switch-off-mirroring"),
    )
    outlines_px = flipped.outlines_px * [-1, 1] + [image.shape[1] - 1, 0]
    marks = MarkerReading(flipped.markers, outlines_px).annotations
    return fail_with_marks(refusal, "camera", image, marks)


def _explain_dictionary(image: Image, board: Chessboard, markers: Markers) -> DetectionError | None:
    """Markers of another dictionary, if they are arranged as on a board."""
    for name in OTHERS:
        is_own = name.rpartition("_")[0] == markers.dictionary.rpartition("_")[0]
        if is_own and DICTIONARIES[name] <= DICTIONARIES[markers.dictionary]:
            continue
        found = read_dictionary(image, name)
        if find_arrangement(found, board, markers) is None:
            continue
        refusal = OperationError(
            CODE,
            message(
                "markers-were-found",
                count=len(found.markers),
                dictionary=_smallest(name, int(found.markers.max())),
            ),
            message("board-states-dictionary", name=board.name, dictionary=markers.dictionary),
            message("state-dictionary", dictionary=_smallest(name, int(found.markers.max()))),
        )
        return fail_with_marks(refusal, "object", image, found.annotations)
    return None


def _smallest(dictionary: str, last: int) -> str:
    """The smallest dictionary of its kind that has an id, as larger ones begin with it."""
    family = dictionary.rpartition("_")[0]
    alike = {
        name: count
        for name, count in DICTIONARIES.items()
        if name.rpartition("_")[0] == family and dictionary[5].isdigit() and count > last
    }
    return min(alike, key=lambda name: alike[name]) if alike else dictionary
