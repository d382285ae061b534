"""The file of a board to print."""

from dataclasses import dataclass

from crenel.errors import OperationError
from crenel.formats.datasheets.target import CharucoFile, ChessboardFile
from crenel.messages.message import message
from crenel.metrology.design.board_pattern import board_pattern, scale_board
from crenel.metrology.targets.chessboard import DICTIONARIES, Chessboard, Markers

USUAL_DICTIONARIES = ("DICT_4X4_50", "DICT_4X4_100", "DICT_4X4_250", "DICT_4X4_1000")
MARKER_SHARE = 0.75
"""The share of a square that a marker takes."""


def plan_board(
    name: str, squares: tuple[int, int], square_mm: float, markers: bool, first_id: int = 0
) -> Chessboard:
    """A board of so many columns and rows of squares.

    Args:
        first_id: of its first marker, where it is not the only board of a set.

    Raises:
        OperationError: ``board-squares``, where they are too few or too many; ``board-ids``, where
            no dictionary has so many.
    """
    columns, rows = squares
    if not (min(squares) >= 4 and max(squares) <= 60):
        raise OperationError(
            "board-squares", message("board-has-4-to-60-squares"), "", message("correct-it")
        )
    count = columns * rows // 2
    needed = first_id + count
    dictionary = next((one for one in USUAL_DICTIONARIES if DICTIONARIES[one] >= needed), None)
    if markers and dictionary is None:
        largest = USUAL_DICTIONARIES[-1]
        ids = {"first": first_id, "last": needed - 1, "most": DICTIONARIES[largest] - 1}
        raise OperationError(
            "board-ids",
            message("board-needs-ids-beyond", **ids, dictionary=largest),
            "",
            message("board-fewer-squares-or-lower-first-id"),
        )
    own = None
    if markers and dictionary:
        own = Markers(dictionary, MARKER_SHARE * square_mm, first_id=first_id)
    file = board_file(Chessboard(name, "", (columns - 1, rows - 1), square_mm, 0.05, markers=own))
    return file.board()


def both_lengths(x_mm: float | None, y_mm: float | None) -> tuple[float, float] | None:
    """Width and height as they were measured on a print, or neither.

    Raises:
        OperationError: ``board-measured``, if one is given without the other.
    """
    if x_mm is None and y_mm is None:
        return None
    if x_mm is None or y_mm is None:
        raise OperationError(
            "board-measured",
            message("one-length-of-print-alone"),
            "",
            message("measure-width-and-height-of-print"),
        )
    return x_mm, y_mm


@dataclass(frozen=True)
class PrintedBoard:
    """A board as it is to be printed, and as it was printed, as far as that was measured."""

    planned: Chessboard
    printed: Chessboard

    @property
    def size_mm(self) -> tuple[float, float]:
        """Width and height of the pattern that is to be printed."""
        return board_pattern(self.planned).size_mm


def scale_print(
    planned: Chessboard, measured_mm: tuple[float, float] | None, measured_sd_mm: float
) -> PrintedBoard:
    """The board, scaled by width and height of the pattern on its print where they are known.

    Raises:
        OperationError: as ``scale_board``.
    """
    if measured_mm is None:
        return PrintedBoard(planned, planned)
    return PrintedBoard(planned, scale_board(planned, measured_mm, measured_sd_mm))


def board_file(board: Chessboard) -> CharucoFile | ChessboardFile:
    """The ``object.json`` of a board."""
    columns, rows = board.inner_corners
    sd_mm = round(board.standard_uncertainty_mm, 6)
    if board.markers is None:
        return ChessboardFile(
            kind="chessboard",
            name=board.name,
            serial_number=board.serial_number,
            inner_corners=board.inner_corners,
            square_mm=round(board.square_mm, 6),
            standard_uncertainty_mm=sd_mm,
            flatness_mm=board.flatness_mm,
        )
    return CharucoFile(
        kind="charuco",
        name=board.name,
        serial_number=board.serial_number,
        squares_x=columns + 1,
        squares_y=rows + 1,
        square_mm=round(board.square_mm, 6),
        marker_mm=round(board.markers.side_mm, 6),
        dictionary=board.markers.dictionary,
        legacy_pattern=board.markers.legacy,
        first_id=board.markers.first_id,
        standard_uncertainty_mm=sd_mm,
        flatness_mm=board.flatness_mm,
    )
