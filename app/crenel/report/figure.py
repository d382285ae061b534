"""A drawing of lines, faces, labels and photographs, in points, y downward.

It is drawn once, and looks the same in a browser (``svg``) and on paper (``pdf``).
"""

from dataclasses import dataclass, field
from typing import Generic, Literal, TypeVar

from crenel.messages.message import Text

T = TypeVar("T", bound=Text)
"""``Text``, or ``str`` after rendering."""
Point = tuple[float, float]
Anchor = Literal["start", "middle", "end"]

INK, SOFT, FAINT, LINE = "#12161b", "#434d59", "#7c8794", "#b9c1cc"
BLUE, RED, ORANGE = "#1d5bd0", "#c8232a", "#b45309"
INSIDE, OUTSIDE = BLUE, ORANGE
"""The colours of a distance from a shape or a face, in every drawing, as on the deviation maps."""
WHITE, PANEL, GROUND = "#ffffff", "#f7f8fa", "#f2f4f7"


@dataclass(frozen=True)
class Polyline:
    """A line through points, or a face if it is ``closed``."""

    points: tuple[Point, ...]
    stroke: str = ""
    width: float = 0.75
    fill: str = ""
    closed: bool = False
    dash: tuple[float, float] | None = None


@dataclass(frozen=True)
class Dot:
    """A circle."""

    at: Point
    radius: float
    fill: str = ""
    stroke: str = ""
    width: float = 0.75


@dataclass(frozen=True)
class Label(Generic[T]):
    """One line of text; ``at`` is on its baseline."""

    at: Point
    text: T
    size: float = 7.5
    colour: str = SOFT
    anchor: Anchor = "start"
    bold: bool = False


@dataclass(frozen=True)
class Photo:
    """A JPEG in a rectangle given by its upper left corner."""

    at: Point
    width: float
    height: float
    jpeg: bytes


Item = Polyline | Dot | Label[T] | Photo


@dataclass
class Figure(Generic[T]):
    """Later elements are drawn above earlier ones."""

    width: float
    height: float
    title: T
    """Alternative text for screen readers."""
    items: list[Item[T]] = field(default_factory=list)

    def line(self, *points: Point, stroke: str = LINE, width: float = 0.75) -> None:
        self.items.append(Polyline(points, stroke, width))

    def face(self, *points: Point, fill: str, stroke: str = "", width: float = 0.5) -> None:
        self.items.append(Polyline(points, stroke, width, fill, closed=True))

    def box(self, at: Point, width: float, height: float, fill: str, stroke: str = "") -> None:
        x, y = at
        corners = ((x, y), (x + width, y), (x + width, y + height), (x, y + height))
        self.face(*corners, fill=fill, stroke=stroke)

    def arrow(self, start: Point, end: Point, stroke: str, width: float = 0.75) -> None:
        """A line with an arrowhead of 2.5 points, or less if it is short."""
        self.line(start, end, stroke=stroke, width=width)
        dx, dy = end[0] - start[0], end[1] - start[1]
        length = (dx * dx + dy * dy) ** 0.5
        if length < 1.5:
            return
        head = min(2.5, 0.5 * length) / length
        bx, by = end[0] - head * dx, end[1] - head * dy
        px, py = -0.5 * head * dy, 0.5 * head * dx
        self.line((bx + px, by + py), end, (bx - px, by - py), stroke=stroke, width=width)

    def label(
        self,
        at: Point,
        text: T,
        size: float = 7.5,
        colour: str = SOFT,
        anchor: Anchor = "start",
        bold: bool = False,
    ) -> None:
        self.items.append(Label(at, text, size, colour, anchor, bold))


def magnification(largest: float, space: float) -> float:
    """A round factor (1, 2 or 5 times a power of ten) that makes ``largest`` at most ``space``."""
    if largest <= 0:
        return 1.0
    wanted = space / largest
    power = 1.0
    while power > wanted:
        power /= 10
    while 10 * power <= wanted:
        power *= 10
    return next(step * power for step in (5.0, 2.0, 1.0) if step * power <= wanted)
