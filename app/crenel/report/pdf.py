"""A report as PDF on A4, with identical bytes for the same report."""

import io
from collections.abc import Sequence
from html import escape

from reportlab.lib.colors import Color, HexColor
from reportlab.lib.enums import TA_LEFT, TA_RIGHT
from reportlab.lib.pagesizes import A4
from reportlab.lib.styles import ParagraphStyle
from reportlab.lib.units import mm
from reportlab.lib.utils import ImageReader
from reportlab.platypus import (
    CondPageBreak,
    Flowable,
    KeepTogether,
    SimpleDocTemplate,
    Spacer,
    TableStyle,
)

from crenel.messages.catalogue import Render, renderer
from crenel.messages.message import message
from crenel.report.content import (
    Block,
    Facts,
    Findings,
    Pictures,
    Report,
    ReportTable,
    Section,
    Signatures,
    TextBlock,
)
from crenel.report.figure import FAINT, INK, SOFT
from crenel.report.fonts.pdf_fonts import register_fonts, replace_missing
from crenel.report.formatting import join_units
from crenel.report.html import MARKS, producer_text, result_line
from crenel.report.pdf_figure import BOLD, PLAIN
from crenel.report.pdf_tags import (
    DecorativeImage,
    Tag,
    TaggedCanvas,
    TaggedDrawing,
    TaggedGrid,
    TaggedParagraph,
    tag_story,
)

MARGIN = 16 * mm
WIDTH = A4[0] - 2 * MARGIN
FRAME = 6.0
"""Margin that the layout adds on each side."""
RULE = HexColor("#dde1e7")
COLOURS = {
    "good": ("#17794a", "#e4f4ec"),
    "attention": ("#8f5b00", "#fdf1da"),
    "bad": ("#bf2329", "#fdeaea"),
    "neutral": ("#5f6b79", "#f2f4f7"),
}
LOGO_WIDTH, LOGO_HEIGHT = 60 * mm, 18 * mm
LEAST_SPACE = 45 * mm
"""If less than this is left of a page, the next section begins on another."""


def pdf_document(report: Report[str]) -> bytes:
    """The whole file."""
    register_fonts()
    # each page has the total number of pages, which is known after the layout
    _, pages = _lay_out(report, 0)
    return _lay_out(report, pages)[0]


def _lay_out(report: Report[str], pages: int) -> tuple[bytes, int]:
    """The file with ``pages`` as the number of pages on each, and the true number."""
    file, render = io.BytesIO(), renderer(report.language)
    document = SimpleDocTemplate(
        file,
        pagesize=A4,
        leftMargin=MARGIN - FRAME,
        rightMargin=MARGIN - FRAME,
        topMargin=15 * mm,
        bottomMargin=18 * mm,
        title=f"{report.title} {report.number}",
        author=report.station,
        creator="Crenel",
        lang=report.language,
        invariant=1,
    )
    foot = replace_missing(f"{report.title} {report.number}")

    def footer(canvas: TaggedCanvas, own: SimpleDocTemplate) -> None:
        with canvas.mark(None):
            canvas.setFont(PLAIN, 7)
            canvas.setFillColor(HexColor(FAINT))
            canvas.drawString(MARGIN, 9 * mm, foot[:90])
            canvas.drawRightString(
                A4[0] - MARGIN, 9 * mm, render(message("of", page=own.page, pages=pages))
            )
            canvas.drawCentredString(A4[0] / 2, 5.5 * mm, render(producer_text()))

    story = [
        *_head(report),
        *_sections(report, render),
    ]
    root = tag_story(story)

    def open_canvas(*arguments: object, **options: object) -> TaggedCanvas:
        canvas = TaggedCanvas(*arguments, **options)
        canvas.root = root
        return canvas

    document.build(story, onFirstPage=footer, onLaterPages=footer, canvasmaker=open_canvas)
    return file.getvalue(), document.page


def _style(size: float, colour: str, bold: bool, right: bool) -> ParagraphStyle:
    return ParagraphStyle(
        "own",
        fontName=BOLD if bold else PLAIN,
        fontSize=size,
        leading=1.4 * size,
        textColor=HexColor(colour),
        alignment=TA_RIGHT if right else TA_LEFT,
    )


def _paragraph(
    text: str, size: float = 8.5, colour: str = INK, bold: bool = False, right: bool = False
) -> TaggedParagraph:
    return TaggedParagraph(
        escape(replace_missing(join_units(text)), quote=False), _style(size, colour, bold, right)
    )


def _head(report: Report[str]) -> list[Flowable]:
    of = [
        _paragraph(report.station, 8.5, INK, True, True),
        _paragraph(report.number, 8, SOFT, False, True),
        _paragraph(report.date, 8, SOFT, False, True),
    ]
    title = _paragraph(report.title, 18, INK, True)
    title.tag = Tag("H1")
    head = TaggedGrid([[title, of]], colWidths=[0.58 * WIDTH, 0.42 * WIDTH])
    head.setStyle(
        TableStyle(
            [
                ("LINEBELOW", (0, 0), (-1, -1), 1.2, HexColor(INK)),
                ("VALIGN", (0, 0), (-1, -1), "TOP"),
                *_padding(0, 0, 0, 8),
            ]
        )
    )
    notes = [
        _box([_paragraph(note, 8.5, INK, True)], HexColor("#ffffff"), HexColor("#b9c1cc"))
        for note in report.notes
    ]
    strong, soft = COLOURS[report.verdict.quality]
    verdict = _box(
        [_paragraph(report.verdict.word, 13, strong, True), _paragraph(report.verdict.text, 9)],
        HexColor(soft),
        None,
        HexColor(strong),
    )
    return [
        *_logo(report),
        head,
        *[part for note in notes for part in (Spacer(1, 8), note)],
        Spacer(1, 8),
        verdict,
    ]


def _logo(report: Report[str]) -> list[Flowable]:
    if report.logo is None:
        return []
    width, height = ImageReader(io.BytesIO(report.logo)).getSize()
    scale = min(LOGO_WIDTH / width, LOGO_HEIGHT / height)
    picture = DecorativeImage(io.BytesIO(report.logo), scale * width, scale * height, hAlign="LEFT")
    return [picture, Spacer(1, 8)]


def _box(
    inner: list[TaggedParagraph], ground: Color, border: Color | None, bar: Color | None = None
) -> TaggedGrid:
    grid = TaggedGrid([[inner]], colWidths=[WIDTH])
    style = [("BACKGROUND", (0, 0), (-1, -1), ground), *_padding(10, 7, 10, 9)]
    if border is not None:
        style.append(("BOX", (0, 0), (-1, -1), 0.75, border))
    if bar is not None:
        style.append(("LINEBEFORE", (0, 0), (0, -1), 4, bar))
    grid.setStyle(TableStyle(style))
    return grid


def _padding(left: float, top: float, right: float, bottom: float) -> list[tuple[object, ...]]:
    sides = (("LEFT", left), ("TOP", top), ("RIGHT", right), ("BOTTOM", bottom))
    return [(f"{name}PADDING", (0, 0), (-1, -1), value) for name, value in sides]


def _sections(report: Report[str], render: Render) -> list[Flowable]:
    """All sections; signatures stay on the page of what is before them."""
    story: list[Flowable] = []
    for section in report.sections:
        if section.is_signed:
            result = _paragraph(result_line(report), 8, SOFT)
            signed = [*_heading(section), result, *_blocks(section, render)]
            story[-1:] = [KeepTogether([*story[-1:], *signed])]
        else:
            story += _section(section, render)
    return story


def _heading(section: Section[str]) -> list[Flowable]:
    title = _paragraph(section.title, 11, INK, True)
    title.tag = Tag("H2")
    return [Spacer(1, 14), title, Spacer(1, 4)]


def _blocks(section: Section[str], render: Render) -> list[Flowable]:
    return [part for block in section.blocks for part in _block(block, render)]


def _section(section: Section[str], render: Render) -> list[Flowable]:
    headed, parts = _heading(section), _blocks(section, render)
    if section.together:
        return [KeepTogether([*headed, *parts])]
    if section.blocks and isinstance(section.blocks[0], Pictures):
        # a row of pictures is higher than the minimum space, and a title stays with its row
        return [KeepTogether([*headed, *parts[:1]]), *parts[1:]]
    return [CondPageBreak(LEAST_SPACE), *headed, *parts]


def _block(block: Block[str], render: Render) -> list[Flowable]:
    match block:
        case Facts():
            return [_facts(block)]
        case ReportTable():
            return [_table(block), Spacer(1, 6)]
        case TextBlock():
            size, colour = (7.5, SOFT) if block.small else (8.5, INK)
            return [_paragraph(block.text, size, colour), Spacer(1, 4)]
        case Findings():
            return [_findings(block, render)]
        case Pictures():
            return _pictures(block)
        case Signatures():
            return [Spacer(1, 44), _signatures(block)]


def _facts(facts: Facts[str]) -> TaggedGrid:
    rows = list(facts.rows)
    half = -(-len(rows) // 2)
    left, right = rows[:half], [*rows[half:], *[("", "")] * (2 * half - len(rows))]
    cells = [
        [_paragraph(a, colour=SOFT), _paragraph(b), "", _paragraph(c, colour=SOFT), _paragraph(d)]
        for (a, b), (c, d) in zip(left, right, strict=True)
    ]
    label, gap = 0.16 * WIDTH, 0.03 * WIDTH
    value = (WIDTH - 2 * label - gap) / 2
    grid = TaggedGrid(cells, colWidths=[label, value, gap, label, value])
    lines = [("LINEBELOW", (a, 0), (b, -1), 0.5, RULE) for a, b in ((0, 1), (3, 4))]
    grid.setStyle(TableStyle([*lines, ("VALIGN", (0, 0), (-1, -1), "TOP"), *_padding(0, 2, 4, 3)]))
    return grid


def _table(table: ReportTable[str]) -> TaggedGrid:
    size = 7.0 if table.small else 8.5

    def cells(row: Sequence[str], head: bool) -> list[TaggedParagraph]:
        look = (7.0 if table.small else 7.5, SOFT, True) if head else (size, INK, False)
        return [_paragraph(cell, *look, i >= table.numbers) for i, cell in enumerate(row)]

    total = sum(table.widths)
    grid = TaggedGrid(
        [cells(table.columns, True), *(cells(row, False) for row in table.rows)],
        colWidths=[WIDTH * width / total for width in table.widths],
        repeatRows=1,
    )
    grid.is_table = True
    grid.setStyle(
        TableStyle(
            [
                ("LINEBELOW", (0, 0), (-1, -1), 0.5, RULE),
                ("LINEBELOW", (0, 0), (-1, 0), 0.75, HexColor(INK)),
                ("VALIGN", (0, 0), (-1, -1), "TOP"),
                *_padding(0, 2, 3, 3 if not table.small else 2),
            ]
        )
    )
    return grid


def _findings(findings: Findings[str], render: Render) -> TaggedGrid:
    rows = [
        [
            _paragraph(render(MARKS[row.quality]), 8.5, COLOURS[row.quality][0], True),
            [_paragraph(row.text), *([_paragraph(row.remedy, 7.5, SOFT)] if row.remedy else [])],
        ]
        for row in findings.rows
    ]
    grid = TaggedGrid(rows, colWidths=[0.11 * WIDTH, 0.89 * WIDTH])
    grid.setStyle(
        TableStyle(
            [
                ("LINEBELOW", (0, 0), (-1, -1), 0.5, RULE),
                ("VALIGN", (0, 0), (-1, -1), "TOP"),
                *_padding(0, 2, 3, 3),
            ]
        )
    )
    return grid


def _pictures(pictures: Pictures[str]) -> list[Flowable]:
    gap = 12.0
    each = (WIDTH - gap * (pictures.across - 1)) / pictures.across
    parts: list[Flowable] = []
    for first in range(0, len(pictures.figures), pictures.across):
        row = pictures.figures[first : first + pictures.across]
        cells: list[object] = []
        for figure, caption in row:
            cells += [
                [TaggedDrawing(figure, each), Spacer(1, 3), _paragraph(caption, 7.5, SOFT)],
                "",
            ]
        grid = TaggedGrid(
            [cells[:-1]], colWidths=[each, *[gap, each] * (len(row) - 1)], hAlign="LEFT"
        )
        grid.setStyle(TableStyle([("VALIGN", (0, 0), (-1, -1), "TOP"), *_padding(0, 0, 0, 8)]))
        parts.append(grid)
    return parts


def _signatures(signatures: Signatures[str]) -> TaggedGrid:
    count, gap = len(signatures.lines), 24.0
    each = (WIDTH - gap * (count - 1)) / count
    cells: list[object] = []
    for line in signatures.lines:
        cells += [_paragraph(line, 8, SOFT), ""]
    grid = TaggedGrid([cells[:-1]], colWidths=[each, *[gap, each] * (count - 1)])
    lines = [("LINEABOVE", (2 * i, 0), (2 * i, 0), 0.75, HexColor(INK)) for i in range(count)]
    grid.setStyle(TableStyle([*lines, *_padding(0, 3, 0, 0)]))
    return grid
