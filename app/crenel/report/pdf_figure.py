"""A figure on a page of PDF."""

import io

from reportlab.lib.colors import HexColor
from reportlab.lib.utils import ImageReader
from reportlab.pdfgen.canvas import Canvas
from reportlab.platypus import Flowable

from crenel.report.figure import Dot, Figure, Label, Photo, Polyline

PLAIN, BOLD = "Crenel", "Crenel-Bold"


class Drawing(Flowable):  # type: ignore[misc]  # the library has no types
    """A figure at a given width."""

    def __init__(self, figure: Figure[str], width: float) -> None:
        super().__init__()
        self.figure = figure
        self.scale = width / figure.width
        self.width, self.height = width, figure.height * self.scale

    def wrap(self, _width: float, _height: float) -> tuple[float, float]:
        return self.width, self.height

    def draw(self) -> None:
        canvas = self.canv
        canvas.saveState()
        canvas.scale(self.scale, self.scale)
        for item in self.figure.items:
            if isinstance(item, Polyline):
                self._shape(canvas, item)
            elif isinstance(item, Dot):
                filled = _paint(canvas, item)
                canvas.circle(*self._up(item.at), item.radius, int(bool(item.stroke)), filled)
            elif isinstance(item, Photo):
                x, y = self._up(item.at)
                picture = ImageReader(io.BytesIO(item.jpeg))
                canvas.drawImage(picture, x, y - item.height, item.width, item.height)
            else:
                self._label(canvas, item)
        canvas.restoreState()

    def _up(self, at: tuple[float, float]) -> tuple[float, float]:
        """On paper, y points upward."""
        return at[0], self.figure.height - at[1]

    def _shape(self, canvas: Canvas, shape: Polyline) -> None:
        filled = _paint(canvas, shape)
        canvas.setDash(list(shape.dash or ()))
        path = canvas.beginPath()
        path.moveTo(*self._up(shape.points[0]))
        for point in shape.points[1:]:
            path.lineTo(*self._up(point))
        if shape.closed:
            path.close()
        canvas.drawPath(path, int(bool(shape.stroke)), filled)
        canvas.setDash([])

    def _label(self, canvas: Canvas, label: Label[str]) -> None:
        canvas.setFont(BOLD if label.bold else PLAIN, label.size)
        canvas.setFillColor(HexColor(label.colour))
        draw = {
            "start": canvas.drawString,
            "middle": canvas.drawCentredString,
            "end": canvas.drawRightString,
        }[label.anchor]
        draw(*self._up(label.at), label.text)


def _paint(canvas: Canvas, item: Polyline | Dot) -> int:
    """Sets line and fill; returns whether there is a fill."""
    if item.stroke:
        canvas.setStrokeColor(HexColor(item.stroke))
        canvas.setLineWidth(item.width)
        canvas.setLineJoin(1)
        canvas.setLineCap(1)
    if item.fill:
        canvas.setFillColor(HexColor(item.fill))
    return int(bool(item.fill))
