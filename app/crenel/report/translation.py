"""A report's texts, rendered into one language."""

from crenel.errors import OperationError
from crenel.messages.catalogue import Render, renderer
from crenel.messages.language_file import languages
from crenel.messages.message import Text, join, message
from crenel.report.content import (
    Block,
    Facts,
    Findings,
    Pictures,
    Report,
    ReportFinding,
    ReportTable,
    Section,
    Signatures,
    TextBlock,
    Verdict,
)
from crenel.report.figure import Figure, Item, Label


def translate_report(report: Report[Text], language: str) -> Report[str]:
    """The report in a language, with the decimal sign of that language.

    Raises:
        OperationError: there is no such language.
    """
    if language not in languages():
        raise OperationError(
            "report-language",
            message("there-no-language", language=language),
            remedy=message("take-one", languages=join(languages())),
        )
    render = renderer(language)
    verdict = report.verdict
    return Report(
        title=render(report.title),
        number=report.number,
        station=render(report.station),
        date=render(report.date),
        verdict=Verdict(verdict.quality, render(verdict.word), render(verdict.text)),
        sections=[
            Section(
                render(section.title),
                [_block(block, render) for block in section.blocks],
                section.together,
            )
            for section in report.sections
        ],
        notes=[render(note) for note in report.notes],
        language=language,
        logo=report.logo,
    )


def _block(block: Block[Text], render: Render) -> Block[str]:
    match block:
        case Facts():
            return Facts([(render(name), render(value)) for name, value in block.rows])
        case ReportTable():
            return ReportTable(
                [render(cell) for cell in block.columns],
                [[render(cell) for cell in row] for row in block.rows],
                block.widths,
                block.numbers,
                block.small,
            )
        case TextBlock():
            return TextBlock(render(block.text), block.small)
        case Findings():
            return Findings(
                [
                    ReportFinding(row.quality, render(row.text), render(row.remedy))
                    for row in block.rows
                ]
            )
        case Pictures():
            return Pictures(
                [(_figure(figure, render), render(caption)) for figure, caption in block.figures],
                block.across,
            )
        case Signatures():
            return Signatures([render(line) for line in block.lines])


def _figure(figure: Figure[Text], render: Render) -> Figure[str]:
    items: list[Item[str]] = [
        Label(item.at, render(item.text), item.size, item.colour, item.anchor, item.bold)
        if isinstance(item, Label)
        else item
        for item in figure.items
    ]
    return Figure(figure.width, figure.height, render(figure.title), items)
