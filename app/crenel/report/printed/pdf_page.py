"""A PDF of one page that is drawn to scale, with identical bytes for the same drawing."""

import io
from collections.abc import Callable

from reportlab.pdfgen.canvas import Canvas

from crenel.report.fonts.pdf_fonts import register_fonts, replace_missing


def draw_page(
    size_pt: tuple[float, float], title: str, language: str, draw: Callable[[Canvas], None]
) -> bytes:
    """The whole file; a viewer prints it without scaling."""
    register_fonts()
    file = io.BytesIO()
    canvas = Canvas(file, pagesize=size_pt, invariant=1, lang=language)
    canvas.setTitle(replace_missing(title))
    canvas.setCreator("Crenel")
    canvas.setViewerPreference("PrintScaling", "None")
    draw(canvas)
    canvas.showPage()
    canvas.save()
    return file.getvalue()
