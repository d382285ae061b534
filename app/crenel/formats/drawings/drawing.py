"""A drawing of a part: lines, dimensions and notes, whatever file it becomes."""

from dataclasses import dataclass

from crenel.messages.message import Text

Point = tuple[float, float]


@dataclass(frozen=True)
class DrawingLine:
    """A visible edge between two points, mm of the part; ``thin`` for what is no edge."""

    start: Point
    end: Point
    thin: bool = False


@dataclass(frozen=True)
class DrawingDimension:
    """A length between two points, drawn ``away_mm`` (of paper) from them.

    It is measured along X; along Y where ``upright``, to the right of the points.
    """

    start: Point
    end: Point
    away_mm: float
    upright: bool = False

    @property
    def length_mm(self) -> float:
        """What the dimension says."""
        axis = 1 if self.upright else 0
        return abs(self.end[axis] - self.start[axis])


@dataclass(frozen=True)
class DrawingLabel:
    """A short text at a point, mm of the part, left-aligned."""

    at: Point
    text: Text


@dataclass(frozen=True)
class PartDrawing:
    """Views of one part in one plane, in mm of the part, with notes below.

    ``scale`` is the size on paper over that of the part; ``low`` and ``high`` are the corners of
    what is drawn, dimensions included.
    """

    title: Text
    lines: tuple[DrawingLine, ...]
    dimensions: tuple[DrawingDimension, ...]
    labels: tuple[DrawingLabel, ...]
    notes: tuple[Text, ...]
    scale: float
    low: Point
    high: Point
    decimals: int = 2


def scale_text(scale: float) -> str:
    """``2 : 1`` or ``1 : 5``.

    Example:
        >>> scale_text(0.5), scale_text(2)
        ('1 : 2', '2 : 1')
    """
    return f"{scale:.0f} : 1" if scale >= 1 else f"1 : {1 / scale:.0f}"
