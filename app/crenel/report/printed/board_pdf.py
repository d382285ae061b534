"""A board to print, as PDF to scale, with what checks the printer."""

from typing import Literal

from reportlab.lib.pagesizes import A0, A1, A2, A3, A4, TABLOID, landscape, legal, letter
from reportlab.lib.units import mm
from reportlab.pdfgen.canvas import Canvas

from crenel.errors import OperationError
from crenel.messages.catalogue import Render, renderer
from crenel.messages.message import message, quantity
from crenel.metrology.design.board_pattern import BoardPattern, board_pattern
from crenel.metrology.targets.chessboard import Chessboard
from crenel.metrology.transforms import Floats
from crenel.report.fonts.pdf_fonts import replace_missing
from crenel.report.pdf_figure import BOLD, PLAIN
from crenel.report.printed.pdf_page import draw_page

BAR_MM = 100.0
"""Length of the bar that checks the printer."""
MARGIN_MM, FOOT_MM, GAP_MM = 12.0, 32.0, 6.0
"""Around everything, for the bar and the words below, and of white around the pattern."""
TEXT_PT, LINE_MM, TICK_MM = 8.0, 0.2, 4.0
PageName = Literal["A4", "A3", "A2", "A1", "A0", "letter", "legal", "tabloid"]
PAGES: dict[PageName, tuple[float, float]] = {
    "A4": A4,
    "A3": A3,
    "A2": A2,
    "A1": A1,
    "A0": A0,
    "letter": letter,
    "legal": legal,
    "tabloid": TABLOID,
}
TRIED: tuple[PageName, ...] = ("A4", "A3", "A2", "A1", "A0")


def board_pdf(board: Chessboard, language: str, page: PageName | None = None) -> bytes:
    """One page with the pattern at its size: as asked, or the smallest of A4 to A0 with room.

    Below are a bar of ``BAR_MM`` and the nominal width and height of the pattern.

    Raises:
        OperationError: ``board-too-large``.
    """
    pattern = board_pattern(board)
    name, size = _page(pattern, page)
    left_mm = (size[0] / mm - pattern.size_mm[0]) / 2
    low_mm = MARGIN_MM + FOOT_MM + GAP_MM

    def draw(canvas: Canvas) -> None:
        canvas.saveState()
        canvas.translate(left_mm * mm, low_mm * mm)
        _fill(canvas, pattern.black, 0.0)
        for cells in pattern.white:
            _fill(canvas, cells, 1.0)
        canvas.restoreState()
        _foot(canvas, board, pattern, name, renderer(language))

    return draw_page(size, board.name, language, draw)


def board_page(board: Chessboard, page: PageName | None = None) -> str:
    """The name of the page that ``board_pdf`` takes; raises ``OperationError`` as it does."""
    name, _ = _page(board_pattern(board), page)
    return name


def read_page(text: str | None) -> PageName | None:
    """The page of a name in any case; raises ``OperationError`` (``board-page``)."""
    if text is None:
        return None
    for name in PAGES:
        if name.lower() == text.strip().lower():
            return name
    raise OperationError(
        "board-page",
        message("no-page-of-this-name", name=text),
        "",
        message("give-one-of", names=", ".join(PAGES)),
    )


def _page(pattern: BoardPattern, wanted: PageName | None) -> tuple[str, tuple[float, float]]:
    """The page, by its name, and its width and height in points."""
    width = max(pattern.size_mm[0], BAR_MM) + 2 * (MARGIN_MM + GAP_MM)
    height = pattern.size_mm[1] + 2 * (MARGIN_MM + GAP_MM) + FOOT_MM
    for name in TRIED if wanted is None else (wanted,):
        for across, up in (PAGES[name], landscape(PAGES[name])):
            if width * mm <= across and height * mm <= up:
                return name, (across, up)
    if wanted is not None:
        raise OperationError(
            "board-too-large",
            message(
                "board-does-not-fit-page",
                width=quantity(pattern.size_mm[0], "mm"),
                height=quantity(pattern.size_mm[1], "mm"),
                page=wanted,
            ),
            "",
            message("board-larger-page-or-fewer-squares"),
        )
    raise OperationError(
        "board-too-large",
        message(
            "board-does-not-fit-a0",
            width=quantity(pattern.size_mm[0], "mm"),
            height=quantity(pattern.size_mm[1], "mm"),
        ),
        "",
        message("board-fewer-or-smaller-squares"),
    )


def _fill(canvas: Canvas, rectangles_mm: Floats, grey: float) -> None:
    """All rectangles as one path, so that no seam shows between neighbours."""
    canvas.setFillGray(grey)
    path = canvas.beginPath()
    for left, bottom, right, top in rectangles_mm:
        path.rect(left * mm, bottom * mm, (right - left) * mm, (top - bottom) * mm)
    canvas.drawPath(path, stroke=0, fill=1)


def _foot(
    canvas: Canvas, board: Chessboard, pattern: BoardPattern, page: str, render: Render
) -> None:
    """The bar, and what to measure."""
    canvas.setFillGray(0.0)
    canvas.setLineWidth(LINE_MM * mm)
    level = (MARGIN_MM + 22.0) * mm
    begin, end = MARGIN_MM * mm, (MARGIN_MM + BAR_MM) * mm
    canvas.line(begin, level, end, level)
    for x in (begin, end):
        canvas.line(x, level - TICK_MM / 2 * mm, x, level + TICK_MM / 2 * mm)
    canvas.setFont(PLAIN, TEXT_PT)
    width, height = (quantity(size, "mm", 2) for size in pattern.size_mm)
    rows = [
        message("board-bar", length=quantity(BAR_MM, "mm")),
        message("board-nominal-size", width=width, height=height),
        message("board-print-and-glue", page=page),
    ]
    for number, row in enumerate(rows):
        at = (MARGIN_MM + 15.0 - 4.5 * number) * mm
        canvas.drawString(MARGIN_MM * mm, at, replace_missing(render(row)))
    canvas.setFont(BOLD, TEXT_PT)
    canvas.drawString(MARGIN_MM * mm, (MARGIN_MM + 27.0) * mm, replace_missing(board.name))
