"""The report of a verification, from its folder alone."""

from pathlib import Path

from crenel.formats.results.decision_rule import describe_rule
from crenel.gauges.quick.document import (
    VERIFICATION,
    FigurePart,
    FiltersPart,
    PlacingPart,
    VerificationFile,
    read_verification,
)
from crenel.gauges.quick.evaluate_deviation_maps import read_maps, scale_end_um
from crenel.gauges.quick.report_figures import deviation_figure, limit_figure
from crenel.gauges.quick.report_tables import (
    MARK,
    budget_sections,
    cloud_sections,
    results_table,
)
from crenel.gauges.report.head import (
    QUALITIES,
    device_facts,
    report_with_verdict,
    temperatures_text,
)
from crenel.messages.message import Text, join, message, quantity, rounded
from crenel.messages.uncertainty import point_quantity
from crenel.report.content import (
    Facts,
    Findings,
    Pictures,
    Report,
    ReportFinding,
    Section,
    TextBlock,
    signatures,
)
from crenel.report.formatting import (
    UNKNOWN,
    device_name,
    format_moment,
    micrometres,
    software_name,
)
from crenel.report.provenance import inputs_section


def verification_report(folder: Path) -> Report[Text]:
    """The report of the ``verification.json`` in the folder of a verification.

    Raises:
        OperationError: there is none, or a required file is missing or damaged.
    """
    document = read_verification(folder)
    reasons = [
        ReportFinding(QUALITIES[figure.decision], _reason(figure), "")
        for figure in document.figures
    ]
    notes = [ReportFinding[Text]("neutral", note, "") for note in document.notes]
    sections: list[Section[Text]] = [
        Section(message("what-verified"), [Facts(_facts(document))]),
        Section(message("results"), [results_table(document), *_rule(document)], together=False),
        signatures(document.operator),
        Section(message("reasons"), [Findings([*reasons, *notes])], together=False),
        Section(message("against-limits"), [Pictures([limit_figure(document)])]),
        *budget_sections(document),
        *cloud_sections(document),
        *_maps(folder, document),
        inputs_section(folder, document.inputs, VERIFICATION),
    ]
    title = message("verification-gauge", shape=document.gauge.shape)
    return report_with_verdict(document, title, document.accepted_at, sections)


def _reason(figure: FigurePart) -> Text:
    """The sentence of a figure, beginning with its title; in older files, it may lack the title."""
    reason = figure.reason
    if isinstance(reason, str) and not reason.startswith(str(figure.title)):
        return message("titled-text", title=figure.title, text=reason)
    return reason


def _facts(document: VerificationFile) -> list[tuple[Text, Text]]:
    gauge, used, celsius = document.gauge, document.calibration, document.temperature
    return [
        (message("operator"), document.operator or UNKNOWN),
        (message("begun"), format_moment(document.started_at)),
        (message("accepted"), format_moment(document.accepted_at)),
        (message("temperature"), temperatures_text(celsius.start_c, celsius.end_c)),
        (message("gauge"), _gauge_name(document)),
        (
            message("certificate"),
            message(
                "known-m-k-1-form-m",
                certificate=message("certificate-named", certificate=gauge.certificate)
                if gauge.certificate
                else message("no-certificate-stated"),
                known=rounded(gauge.standard_uncertainty_um, "µm"),
                form=rounded(gauge.form_um, "µm"),
            ),
        ),
        *device_facts(document.serial_numbers),
        (
            message("calibration"),
            message("point-known-k-1", name=used.name, total=point_quantity(used.total_um)),
        ),
        (message("placed"), _placement_text(document.placing)),
        (message("software"), software_name(document.software.version)),
    ]


def _gauge_name(document: VerificationFile) -> Text:
    gauge = document.gauge
    name = device_name(gauge.name, gauge.serial_number)
    if gauge.radius_mm is None:
        return name
    return join([name, message("with-radius", radius=quantity(gauge.radius_mm, "mm", 4))])


def _placement_text(placing: PlacingPart | None) -> Text:
    if placing is None:
        return message("gauge-touched-shape-size-only")
    return message(
        "touches-rms-known-k-1",
        touches=placing.touches,
        rms=micrometres(placing.rms_um),
        known=micrometres(placing.standard_uncertainty_um),
    )


def _rule(document: VerificationFile) -> list[TextBlock[Text]]:
    texts: list[Text] = [describe_rule(document.rule)]
    if any(figure.test_uncertainty is not None for figure in document.figures):
        texts.append(message("limits-judged-by-marked-uncertainty", mark=MARK))
    if document.filters is not None:
        texts.append(_filters(document.filters))
    texts.append(message("not-by-standard-other-positions"))
    return [TextBlock(text) for text in texts]


def _filters(filters: FiltersPart) -> Text:
    """Every filter, with its parameters."""
    gate = rounded(filters.gate_mm, "mm")
    return join(
        [
            message(
                "filters-of-figures",
                sigmas=rounded(filters.sigmas),
                place=rounded(filters.same_place_mm, "mm"),
            ),
            message("gate-of-plane", gate=gate)
            if filters.gate_deg is None
            else message("gate-of-sphere", gate=gate, angle=rounded(filters.gate_deg, "°")),
        ],
        " ",
    )


def _maps(folder: Path, document: VerificationFile) -> list[Section[Text]]:
    """The deviations of each cloud from its own shape, all by one scale, if the folder has them."""
    of = [(cloud.name, (folder / cloud.recording).parent) for cloud in document.clouds]
    maps = {at: one for at, one in read_maps([at for _, at in of]).items() if one.deviation_um}
    if not maps:
        return []
    end_um = scale_end_um([*maps.values()])
    figures = [deviation_figure(name, maps[at], end_um) for name, at in of if at in maps]
    return [Section(message("residuals-on-gauge"), [Pictures(figures, 3)], together=False)]
