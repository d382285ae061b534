"""The fonts of a PDF, and what is shown of characters that they lack."""

from functools import cache

from reportlab.pdfbase import pdfmetrics
from reportlab.pdfbase.ttfonts import TTFont

from crenel.messages.catalogue import TURNING
from crenel.report.fonts import REGULAR, SEMIBOLD
from crenel.report.pdf_figure import BOLD, PLAIN


@cache
def register_fonts() -> frozenset[int]:
    """Registers the fonts once; returns their characters."""
    regular = TTFont(PLAIN, REGULAR)
    pdfmetrics.registerFont(regular)
    pdfmetrics.registerFont(TTFont(BOLD, SEMIBOLD))
    pdfmetrics.registerFontFamily(PLAIN, normal=PLAIN, bold=BOLD, italic=PLAIN, boldItalic=BOLD)
    return frozenset(regular.face.charToGlyph)


def replace_missing(text: str) -> str:
    """The text with a box for each character that the font lacks, or that changes the text
    direction."""
    known = register_fonts()
    boxed = TURNING.sub("□", text)
    return "".join(c if ord(c) in known else " " if c.isspace() else "□" for c in boxed)
