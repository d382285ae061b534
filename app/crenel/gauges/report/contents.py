"""The report of a performance test, from its folder alone."""

from pathlib import Path

from crenel.errors import sentence
from crenel.gauges.judgement.document import PerformanceFile, read_performance
from crenel.gauges.plan.document import RESULT
from crenel.gauges.report.figures import bar_pictures, lengths_pictures, limits_figure
from crenel.gauges.report.head import QUALITIES, report_with_verdict
from crenel.gauges.report.tables import (
    figures_table,
    gate_texts,
    positions_table,
    rule_text,
    sensitivity_table,
    test_facts,
    values_table,
)
from crenel.gauges.sphere.report_figures import centre_pictures, offset_figure, sphere_pictures
from crenel.messages.message import Text, message
from crenel.report.content import (
    Block,
    Facts,
    Findings,
    Pictures,
    Quality,
    Report,
    ReportFinding,
    Section,
    TextBlock,
    signatures,
)
from crenel.report.provenance import inputs_section


def performance_report(folder: Path) -> Report[Text]:
    """The report of the ``performance.json`` in the folder of a performance test.

    Raises:
        OperationError: there is none, or it is damaged.
    """
    document = read_performance(folder)
    sections: list[Section[Text]] = [
        Section(message("what-tested"), [Facts(test_facts(document))]),
        Section(message("results"), [figures_table(document), TextBlock(rule_text(document.rule))]),
        signatures(document.operator),
        Section(message("reasons"), [Findings(_findings(document))], together=False),
        *_conditions(document),
        *_pictures(document),
        Section(
            message("what-figures-mean"),
            [TextBlock(message("what-figures-mean-text")), sensitivity_table()],
            together=False,
        ),
        Section(message("origin-of-figures"), [values_table(document)], together=False),
        inputs_section(folder, document.inputs, RESULT),
    ]
    status = [document.status] if document.status else []
    title = message("performance-test", kind=document.kind)
    return report_with_verdict(document, title, document.ended_at, sections, status)


def _findings(document: PerformanceFile) -> list[ReportFinding[Text]]:
    """Each figure's decision in a sentence, what is missing, and what else should be known."""
    figures = [
        ReportFinding(QUALITIES[one.decision], sentence(one.reason), "") for one in document.figures
    ]
    offset = document.offset
    if offset is not None and offset.text:
        quality: Quality = "attention" if offset.significant else "neutral"
        figures.append(ReportFinding(quality, offset.text, ""))
    problems = [ReportFinding[Text]("attention", text, "") for text in document.problems]
    notes = [ReportFinding[Text]("neutral", text, "") for text in document.notes]
    return [*figures, *problems, *notes]


def _conditions(document: PerformanceFile) -> list[Section[Text]]:
    """The gate and the filters of a sphere's scans, and what each position had; the gates of
    lengths and plates are among the notes."""
    blocks: list[Block[Text]] = []
    by_scan = [one for one in document.figures if one.quantity.endswith(("-scan", "-both"))]
    if by_scan and document.spheres:
        blocks += [TextBlock(text) for text in gate_texts(document.gate)]
    if document.spheres:
        blocks.append(positions_table(document))
    return [Section(message("gate-and-filters"), blocks)] if blocks else []


def _pictures(document: PerformanceFile) -> list[Section[Text]]:
    """The figures, each kind in a section of its own."""
    limits = limits_figure(document.figures)
    places = [picture for one in document.spheres for picture in sphere_pictures(one)]
    stated = {one.quantity for one in document.figures if one.value is not None}
    centres = [picture for one in document.spheres for picture in centre_pictures(one, stated)]
    found = [
        (message("against-limits"), [limits] if limits else [], 1),
        (message("deviations-of-places"), places, 2),
        (message("location-over-articulations"), centres, 1),
        (
            message("implied-offset"),
            [offset_figure(document.offset)] if document.offset else [],
            1,
        ),
        (
            message("errors-of-lengths"),
            lengths_pictures(document.lengths),
            1,
        ),
        (
            message("performance-single-values", test=document.kind),
            bar_pictures(document),
            2,
        ),
    ]
    return [
        Section[Text](title, [Pictures(pictures, across)], together=False)
        for title, pictures, across in found
        if pictures
    ]
