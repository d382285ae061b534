"""A report in another language: the same content, every sentence and word of it said there."""

from collections.abc import Callable
from dataclasses import replace

from app.errors import Refusal
from app.report.content import (
    Block,
    Facts,
    Finding,
    Findings,
    Pictures,
    Report,
    Section,
    Signatures,
    Table,
    Text,
    Verdict,
)
from app.report.figure import Figure, Words
from app.strings.files import ENGLISH, languages
from app.strings.sentences import sentences_of

Say = Callable[[str], str]


def in_language(report: Report, language: str) -> Report:
    """The report in a language.

    Raises:
        Refusal: there is no such language.
    """
    if language not in languages():
        raise Refusal(
            "report-language",
            f"there is no language '{language}'",
            remedy=f"Take one of {', '.join(languages())}",
        )
    if language == ENGLISH:
        return report
    return replace(said_by(report, sentences_of(language).said), language=language)


def said_by(report: Report, say: Say) -> Report:
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


def _block(block: Block, say: Say) -> Block:
    match block:
        case Facts():
            return Facts([(say(name), say(value)) for name, value in block.rows])
        case Table():
            rows = [[say(cell) for cell in row] for row in block.rows]
            return replace(block, columns=[say(cell) for cell in block.columns], rows=rows)
        case Text():
            return replace(block, text=say(block.text))
        case Findings():
            found = [Finding(row.quality, say(row.text), say(row.remedy)) for row in block.rows]
            return Findings(found)
        case Pictures():
            figures = [(_figure(figure, say), say(caption)) for figure, caption in block.figures]
            return replace(block, figures=figures)
        case Signatures():
            return Signatures([(say(role), name) for role, name in block.lines])


def _figure(figure: Figure, say: Say) -> Figure:
    items = [
        replace(item, text=say(item.text)) if isinstance(item, Words) else item
        for item in figure.items
    ]
    return Figure(figure.width, figure.height, say(figure.title), items)
