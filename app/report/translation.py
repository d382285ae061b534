"""A report in another language: the same content, every sentence and word of it said there."""

from collections.abc import Callable
from dataclasses import replace

from app.errors import OperationError
from app.report.content import (
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
from app.report.figure import Figure, Label
from app.strings.files import ENGLISH, languages
from app.strings.sentences import load_sentences

Translate = Callable[[str], str]


def translate_report(report: Report, language: str) -> Report:
    """The report in a language.

    Raises:
        Refusal: there is no such language.
    """
    if language not in languages():
        raise OperationError(
            "report-language",
            f"there is no language '{language}'",
            remedy=f"Take one of {', '.join(languages())}",
        )
    if language == ENGLISH:
        return report
    return replace(apply_translation(report, load_sentences(language).translate), language=language)


def apply_translation(report: Report, say: Translate) -> Report:
    """The report with each of its texts as ``say`` says it; who signs keeps the name."""
    return replace(
        report,
        title=say(report.title),
        station=say(report.station),
        verdict=Verdict(report.verdict.quality, say(report.verdict.word), say(report.verdict.text)),
        sections=[
            Section(say(one.title), [_block(block, say) for block in one.blocks], one.together)
            for one in report.sections
        ],
        notes=[say(note) for note in report.notes],
    )


def _block(block: Block, say: Translate) -> Block:
    match block:
        case Facts():
            return Facts([(say(name), say(value)) for name, value in block.rows])
        case ReportTable():
            rows = [[say(cell) for cell in row] for row in block.rows]
            return replace(block, columns=[say(cell) for cell in block.columns], rows=rows)
        case TextBlock():
            return replace(block, text=say(block.text))
        case Findings():
            found = [
                ReportFinding(row.quality, say(row.text), say(row.remedy)) for row in block.rows
            ]
            return Findings(found)
        case Pictures():
            figures = [(_figure(figure, say), say(caption)) for figure, caption in block.figures]
            return replace(block, figures=figures)
        case Signatures():
            return Signatures([(say(role), name) for role, name in block.lines])


def _figure(figure: Figure, say: Translate) -> Figure:
    items = [
        replace(item, text=say(item.text)) if isinstance(item, Label) else item
        for item in figure.items
    ]
    return Figure(figure.width, figure.height, say(figure.title), items)
