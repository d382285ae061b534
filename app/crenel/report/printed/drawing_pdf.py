"""A drawing of a part as PDF on A4 in landscape."""

from reportlab.lib.pagesizes import A4, landscape
from reportlab.lib.units import mm
from reportlab.pdfgen.canvas import Canvas

from crenel.formats.drawings.drawing import DrawingDimension, PartDrawing, Point, scale_text
from crenel.messages.catalogue import Render, renderer
from crenel.messages.message import message
from crenel.report.fonts.pdf_fonts import replace_missing
from crenel.report.pdf_figure import BOLD, PLAIN
from crenel.report.printed.pdf_page import draw_page

MARGIN_MM = 14.0
ARROW_MM, TEXT_PT, TITLE_PT = 1.8, 8.0, 13.0
LINE_MM, THIN_MM, DIMENSION_MM = 0.5, 0.25, 0.18
NOTE_STEP_MM = 4.6


def drawing_pdf(drawing: PartDrawing, language: str) -> bytes:
    """The whole file, in a language of the program."""
    render, page = renderer(language), landscape(A4)
    title = render(drawing.title)
    rows = [render(note) for note in drawing.notes]
    rows.append(render(message("drawing-scale", scale=scale_text(drawing.scale))))
    foot = MARGIN_MM + NOTE_STEP_MM * len(rows)

    def draw(canvas: Canvas) -> None:
        for number, row in enumerate(rows):
            canvas.setFont(PLAIN, TEXT_PT)
            at = MARGIN_MM + NOTE_STEP_MM * (len(rows) - 1 - number)
            canvas.drawString(MARGIN_MM * mm, at * mm, replace_missing(row))
        canvas.setFont(BOLD, TITLE_PT)
        top = page[1] / mm - MARGIN_MM
        canvas.drawString(MARGIN_MM * mm, (top - 4) * mm, replace_missing(title))
        canvas.rect(8 * mm, 8 * mm, page[0] - 16 * mm, page[1] - 16 * mm)
        _Views(canvas, drawing, foot + 8.0).draw(render)

    return draw_page(page, title, language, draw)


class _Views:
    """The views of a drawing, placed above a height of the page."""

    def __init__(self, canvas: Canvas, drawing: PartDrawing, above_mm: float) -> None:
        self.canvas, self.drawing, self.above_mm = canvas, drawing, above_mm

    def draw(self, render: Render) -> None:
        """Lines, dimensions, labels."""
        canvas = self.canvas
        for line in self.drawing.lines:
            canvas.setLineWidth((THIN_MM if line.thin else LINE_MM) * mm)
            canvas.line(*self._at(line.start), *self._at(line.end))
        canvas.setFont(PLAIN, TEXT_PT)
        for label in self.drawing.labels:
            canvas.drawString(*self._at(label.at), replace_missing(render(label.text)))
        canvas.setLineWidth(DIMENSION_MM * mm)
        for size in self.drawing.dimensions:
            self._dimension(size)

    def _at(self, point: Point) -> Point:
        """The place of a point of the part on the page, in points."""
        low, scale = self.drawing.low, self.drawing.scale
        x = MARGIN_MM + 4.0 + (point[0] - low[0]) * scale
        y = self.above_mm + (point[1] - low[1]) * scale
        return x * mm, y * mm

    def _dimension(self, size: DrawingDimension) -> None:
        """Two extension lines, the dimension line with arrows, and the number."""
        canvas, away = self.canvas, size.away_mm * mm
        (ax, ay), (bx, by) = self._at(size.start), self._at(size.end)
        canvas.saveState()
        if size.upright:  # along +Y with the offset to the right: turned by a quarter
            canvas.translate(ax, ay)
            canvas.rotate(90)
            ax, ay, bx, by = 0.0, 0.0, by - self._at(size.start)[1], 0.0
            away = -away
        level, beyond = ay + away, 1.5 * mm * (1 if away > 0 else -1)
        for x in (ax, bx):
            canvas.line(x, ay + beyond / 2, x, level + beyond / 2)
        canvas.line(ax, level, bx, level)
        arrow = min(ARROW_MM * mm, abs(bx - ax) / 3)
        for x, way in ((ax, 1), (bx, -1)):
            path = canvas.beginPath()
            path.moveTo(x, level)
            path.lineTo(x + way * arrow, level + arrow / 5)
            path.lineTo(x + way * arrow, level - arrow / 5)
            path.close()
            canvas.drawPath(path, stroke=0, fill=1)
        text = f"{size.length_mm:.{self.drawing.decimals}f}"
        canvas.setFont(PLAIN, TEXT_PT)
        canvas.drawCentredString((ax + bx) / 2, level + 0.8 * mm, text)
        canvas.restoreState()
