"""The report of an inspection, from its results alone."""

from collections.abc import Sequence
from pathlib import Path

from crenel.formats.json_document import SOFTWARE
from crenel.formats.results.decision_rule import describe_rule
from crenel.gauges.report.head import QUALITIES, WORDS
from crenel.messages.message import Message, Text, message
from crenel.parts.document_results import RESULTS, InspectionFile
from crenel.parts.report.figures import limits_picture
from crenel.parts.report.tables import (
    OUTCOMES,
    budget_table,
    dimensions_table,
    exclusions_text,
    features_table,
    frame_texts,
)
from crenel.report.content import (
    Block,
    Facts,
    Findings,
    Pictures,
    Report,
    ReportFinding,
    Section,
    TextBlock,
    Verdict,
    signatures,
)
from crenel.report.formatting import UNKNOWN, format_moment, software_name
from crenel.report.provenance import inputs_section


def folder_inspection_report(folder: Path) -> Report[Text]:
    """The report of the ``results.json`` in an inspection folder.

    Raises:
        OperationError: there is none, or it is damaged.
    """
    return inspection_report(InspectionFile.read(folder / RESULTS), folder, RESULTS)


def inspection_report(
    document: InspectionFile, folder: Path, result: str | None = None
) -> Report[Text]:
    """The report of an inspection.

    Args:
        folder: of the files that it was made from.
        result: the file of the result there, if it was written.
    """
    decision = OUTCOMES[document.verdict]
    return Report(
        title=message("part-inspection"),
        number=document.serial_number or document.drawing,
        station=document.part or document.program or UNKNOWN,
        date=format_moment(document.measured_at),
        verdict=Verdict(QUALITIES[decision], WORDS[decision], _verdict_text(document)),
        sections=[
            Section(message("part-measured"), [Facts(_facts(document))]),
            Section(message("part-dimensions"), _dimensions(document), together=False),
            *_frame(document),
            *_warnings(document.warnings),
            signatures(""),
            Section(
                message("part-features"),
                [features_table(document), *exclusions_text(document)],
                together=False,
            ),
            *_budget(document),
            inputs_section(folder, document.inputs, result),
        ],
    )


def _verdict_text(document: InspectionFile) -> Message:
    return message(
        "part-verdict",
        count=len(document.dimensions),
        passed=document.count("pass"),
        failed=document.count("fail"),
        undecided=document.count("undecided"),
    )


def _facts(document: InspectionFile) -> list[tuple[Text, Text]]:
    version = (document.software or SOFTWARE).version
    return [
        (message("part-name"), document.part or UNKNOWN),
        (message("part-drawing"), document.drawing or UNKNOWN),
        (message("part-serial-number"), document.serial_number or UNKNOWN),
        (message("part-program"), document.program or UNKNOWN),
        (message("software"), software_name(version)),
    ]


def _dimensions(document: InspectionFile) -> list[Block[Text]]:
    """The table, each value against its limits, and how it was judged."""
    blocks: list[Block[Text]] = [dimensions_table(document)]
    if (picture := limits_picture(document)) is not None:
        blocks.append(Pictures([picture]))
    if document.uncertainty == "full":
        blocks.append(TextBlock(message("part-uncertainty-is-of-all-errors"), small=True))
    else:
        blocks.append(TextBlock(message("part-scatter-is-no-uncertainty")))
    return [*blocks, TextBlock(describe_rule(document.rule), small=True)]


def _frame(document: InspectionFile) -> list[Section[Text]]:
    texts = frame_texts(document)
    blocks = [TextBlock(text) for text in texts]
    return [Section(message("part-frame"), blocks)] if blocks else []


def _warnings(texts: Sequence[Text]) -> list[Section[Text]]:
    rows = [ReportFinding[Text]("attention", text, "") for text in texts]
    title = message("part-warnings")
    return [Section(title, [Findings(rows)], together=False)] if rows else []


def _budget(document: InspectionFile) -> list[Section[Text]]:
    table = budget_table(document)
    if table is None:
        return []
    note = TextBlock[Text](message("part-budget-squares-add-up"), small=True)
    return [Section(message("part-budget"), [table, note], together=False)]
