"""Tags of a PDF: which text is a heading, a cell or a caption, and what a figure shows.

The layout library draws pages and knows no tags. Text and figures mark what they draw; the tree of
these marks is written with the file (ISO 32000-1, 14.7 and 14.8). Screen readers read it in order.
"""

from collections.abc import Iterable, Iterator, Sequence
from contextlib import contextmanager
from dataclasses import dataclass, field
from typing import Any, Literal

from reportlab.pdfbase.pdfdoc import PDFArray, PDFDictionary, PDFName, PDFString
from reportlab.pdfgen.canvas import Canvas
from reportlab.platypus import Flowable, Image, KeepTogether, Paragraph
from reportlab.platypus import Table as Grid

from crenel.report.pdf_figure import Drawing

Kind = Literal["Document", "H1", "H2", "P", "Table", "TR", "TH", "TD", "Figure"]


@dataclass
class Tag:
    """An element of the structure: others within it, or what is drawn of it."""

    kind: Kind
    within: list["Tag"] = field(default_factory=list)
    marks: list[tuple[int, int]] = field(default_factory=list)
    """Page, and number of the marked content on it."""
    says: str = ""
    """What a figure shows."""


class TaggedCanvas(Canvas):  # type: ignore[misc]  # the library has no types
    """Pages on which content is marked, and the tree of the marks."""

    root: Tag | None = None

    def __init__(self, *arguments: Any, **options: Any) -> None:
        super().__init__(*arguments, **options)
        self._marked: list[list[Tag]] = [[]]

    @contextmanager
    def mark(self, tag: Tag | None) -> Iterator[None]:
        """What is drawn inside belongs to this element; None: it is decoration."""
        if tag is None:
            self._code.append("/Artifact BMC")
        else:
            here = self._marked[-1]
            tag.marks.append((len(self._marked) - 1, len(here)))
            self._code.append(f"/{tag.kind} <</MCID {len(here)}>> BDC")
            here.append(tag)
        yield
        self._code.append("EMC")

    def showPage(self) -> None:  # noqa: N802  named by the library
        super().showPage()
        self._marked.append([])

    def save(self) -> None:
        if self._code:
            self.showPage()
        if self.root is not None:
            self._write_tree(self.root)
        super().save()

    def _write_tree(self, root: Tag) -> None:
        """Adds the structure to the catalogue, and to each page where its marks belong."""
        document = self._doc
        pages = list(document.Pages.pages)
        elements: dict[int, Any] = {}
        top = PDFDictionary({"Type": PDFName("StructTreeRoot")})
        document.Catalog.StructTreeRoot = top
        document.Catalog.MarkInfo = PDFDictionary({"Marked": "true"})
        parent = document.Reference(top)

        def write(tag: Tag, above: Any) -> Any:
            element = PDFDictionary({"Type": PDFName("StructElem"), "S": PDFName(tag.kind)})
            reference = document.Reference(element)
            elements[id(tag)] = reference
            kids = [write(one, reference) for one in tag.within]
            kids += [
                PDFDictionary(
                    {
                        "Type": PDFName("MCR"),
                        "Pg": document.Reference(pages[page]),
                        "MCID": number,
                    }
                )
                for page, number in tag.marks
            ]
            element["P"], element["K"] = above, PDFArray(kids)
            if tag.says:
                element["Alt"] = PDFString(tag.says)
            if tag.kind == "TH":
                scope = {"O": PDFName("Table"), "Scope": PDFName("Column")}
                element["A"] = PDFDictionary(scope)
            return reference

        top["K"] = write(root, parent)
        numbers: list[Any] = []
        for number, (page, tags) in enumerate(zip(pages, self._marked, strict=False)):
            page.__NoDefault__ = [*page.__NoDefault__, "StructParents", "Tabs"]
            page.StructParents, page.Tabs = number, PDFName("S")
            numbers += [number, PDFArray([elements[id(tag)] for tag in tags])]
        top["ParentTree"] = PDFDictionary({"Nums": PDFArray(numbers)})
        top["ParentTreeNextKey"] = len(pages)


class TaggedParagraph(Paragraph):  # type: ignore[misc]  # the library has no types
    """A paragraph that is marked as what it is, also where it goes on overleaf."""

    tag: Tag | None = None

    def draw(self) -> None:
        # the head of a table that goes on overleaf is said once
        again = self.tag is None or (self.tag.kind == "TH" and self.tag.marks)
        with self.canv.mark(None if again else self.tag):
            super().draw()

    def split(self, width: float, height: float) -> list[Flowable]:
        parts: list[Flowable] = super().split(width, height)
        for part in parts:
            if isinstance(part, TaggedParagraph):
                part.tag = self.tag
        return parts


class TaggedDrawing(Drawing):
    """A figure with what it shows."""

    tag: Tag | None = None

    def draw(self) -> None:
        with self.canv.mark(self.tag):
            super().draw()


class DecorativeImage(Image):  # type: ignore[misc]  # the library has no types
    """A picture that says nothing, such as a logo."""

    def draw(self) -> None:
        with self.canv.mark(None):
            super().draw()


class TaggedGrid(Grid):  # type: ignore[misc]  # the library has no types
    """A table, or a layout of several things beside each other; lines and grounds are decoration.

    ``is_table``: rows and columns mean something; the first row has the names of the columns.
    """

    is_table = False

    def _drawBkgrnd(self) -> None:  # noqa: N802
        with self.canv.mark(None):
            super()._drawBkgrnd()

    def _drawLines(self) -> None:  # noqa: N802
        with self.canv.mark(None):
            super()._drawLines()


def tag_story(story: Sequence[Flowable]) -> Tag:
    """The structure of all that is to be drawn, in its order; sets the tag of each part."""
    return Tag("Document", list(_tags(story)))


def _tags(parts: Iterable[object]) -> Iterator[Tag]:
    for part in parts:
        if isinstance(part, TaggedParagraph):
            part.tag = part.tag or Tag("P")
            yield part.tag
        elif isinstance(part, TaggedDrawing):
            part.tag = Tag("Figure", says=part.figure.title)
            yield part.tag
        elif isinstance(part, TaggedGrid):
            yield from _grid_tags(part)
        elif isinstance(part, KeepTogether):
            yield from _tags(part._content)
        elif isinstance(part, list | tuple):
            yield from _tags(part)


def _grid_tags(grid: TaggedGrid) -> Iterator[Tag]:
    if not grid.is_table:
        yield from _tags(grid._cellvalues)
        return
    rows = []
    for number, cells in enumerate(grid._cellvalues):
        row = Tag("TR")
        for cell in cells:
            if isinstance(cell, TaggedParagraph):
                cell.tag = Tag("TD" if number else "TH")
                row.within.append(cell.tag)
        rows.append(row)
    yield Tag("Table", rows)
