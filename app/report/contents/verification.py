"""The report of a verification, from its folder alone."""

from pathlib import Path

from app.formats.results.decision_rule import describe_rule
from app.formats.results.verification import (
    VERIFICATION,
    CloudPart,
    Decision,
    FigurePart,
    FiltersPart,
    PlacingPart,
    VerificationFile,
    read_verification,
)
from app.messages.message import Message, Text, join, message, quantity, rounded, word
from app.report.content import (
    Facts,
    Findings,
    Pictures,
    Quality,
    Report,
    ReportFinding,
    ReportTable,
    Section,
    TextBlock,
    Verdict,
    signatures,
)
from app.report.contents.verification_figures import cloud_plot, deviation_figure, limit_figure
from app.report.formatting import (
    NONE,
    UNKNOWN,
    device_name,
    error_value,
    format_moment,
    micrometres,
    millimetres,
    plus_minus,
    simulation_notes,
    software_name,
    temperature,
)
from app.report.provenance import inputs_section
from app.workflows.measure_gauge import MAP, MapFile

WORDS: dict[Decision, Message] = {
    "pass": message("pass"),
    "fail": message("fail"),
    "uncertain": message("undecided"),
    "none": message("no-limit-set-3"),
}
QUALITIES: dict[Decision, Quality] = {
    "pass": "good",
    "fail": "bad",
    "uncertain": "attention",
    "none": "neutral",
}
MARK = " *"
DECISIONS: dict[Decision, Message] = {
    "pass": word("pass"),
    "fail": word("fail"),
    "uncertain": word("undecided"),
    "none": message("no-limit"),
}


def verification_report(folder: Path) -> Report[Text]:
    """The report of the ``verification.json`` in the folder of a verification.

    Raises:
        OperationError: there is none, or a required file is missing or damaged.
    """
    document = read_verification(folder)
    result = document.verdict.result
    reasons = [
        ReportFinding(QUALITIES[figure.decision], _reason(figure), "")
        for figure in document.figures
    ]
    notes = [ReportFinding[Text]("neutral", note, "") for note in document.notes]
    sections: list[Section[Text]] = [
        Section(message("what-verified"), [Facts(_facts(document))]),
        Section(message("results"), [_results(document), *_rule(document)], together=False),
        signatures(document.operator),
        Section(message("reasons"), [Findings([*reasons, *notes])], together=False),
        Section(message("against-limits"), [Pictures([limit_figure(document)])]),
        *_clouds(document),
        *_maps(folder, document),
        inputs_section(folder, document.inputs, VERIFICATION),
    ]
    return Report(
        title=message("verification-gauge", shape=document.gauge.shape),
        number=document.id,
        station=document.station,
        date=format_moment(document.accepted_at),
        verdict=Verdict(QUALITIES[result], WORDS[result], document.verdict.text),
        notes=simulation_notes(document.simulated),
        sections=sections,
    )


def _reason(figure: FigurePart) -> Text:
    """The sentence of a figure, beginning with its title; in older files, it may lack the title."""
    reason = figure.reason
    if isinstance(reason, str) and not reason.startswith(str(figure.title)):
        return message("titled-text", title=figure.title, text=reason)
    return reason


def _facts(document: VerificationFile) -> list[tuple[Text, Text]]:
    gauge, used, serials = document.gauge, document.calibration, document.serial_numbers
    return [
        (message("operator-2"), document.operator or UNKNOWN),
        (message("begun"), format_moment(document.started_at)),
        (message("accepted"), format_moment(document.accepted_at)),
        (message("temperature"), _temperatures(document)),
        (message("gauge"), _gauge_name(document)),
        (
            message("certificate"),
            message(
                "known-m-k-1-form-m",
                certificate=message("certificate-2", certificate=gauge.certificate)
                if gauge.certificate
                else message("no-certificate-stated"),
                known=rounded(gauge.standard_uncertainty_um, "µm"),
                form=rounded(gauge.form_um, "µm"),
            ),
        ),
        (message("arm-4"), message("serial-number", serial_number=serials.arm or UNKNOWN)),
        (message("sensor-2"), message("serial-number", serial_number=serials.sensor or UNKNOWN)),
        (
            message("calibration"),
            message("point-known-k-1", name=used.name, total=micrometres(used.total_um)),
        ),
        (message("placed"), _placement_text(document.placing)),
        (message("software"), software_name(document.software.version)),
    ]


def _temperatures(document: VerificationFile) -> Text:
    start, end = document.temperature.start_c, document.temperature.end_c
    if start is None or end is None:
        return temperature(start if start is not None else end)
    return message("from-to", low=quantity(start, "", 1), high=quantity(end, "°C", 1))


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


def _results(document: VerificationFile) -> ReportTable[Text]:
    rows: list[tuple[Text, ...]] = [
        (
            figure.title,
            error_value(figure.value, figure.unit),
            millimetres(figure.value) if figure.unit == "µm" else "",
            *_uncertainties(figure),
            NONE if figure.limit is None else error_value(figure.limit, figure.unit),
            DECISIONS[figure.decision],
        )
        for figure in document.figures
    ]
    columns = (
        message("figure"),
        message("value"),
        message("mm"),
        message("measurement-u"),
        message("test-u"),
        message("limit-3"),
        message("decision"),
    )
    return ReportTable(columns, rows, (28, 12, 13, 13, 13, 11, 14))


def _uncertainties(figure: FigurePart) -> tuple[Text, Text]:
    """Measurement and test value uncertainty, k = 2; the one that the limit is judged by is
    marked."""
    by_test = figure.judged_by == "test"
    measured = plus_minus(error_value(figure.expanded_uncertainty, figure.unit))
    if figure.test_uncertainty is None:
        return measured, NONE
    test = plus_minus(error_value(2 * figure.test_uncertainty, figure.unit))
    return (measured, join([test, MARK], "")) if by_test else (join([measured, MARK], ""), test)


def _rule(document: VerificationFile) -> list[TextBlock[Text]]:
    texts: list[Text] = [describe_rule(document.rule)]
    if any(figure.test_uncertainty is not None for figure in document.figures):
        texts.append(message("limits-judged-by-marked-uncertainty", mark=MARK))
    if document.filters is not None:
        texts.append(_filters(document.filters))
    texts.append(message("standard-positions-articulations-counts-iso-10360"))
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


FORM_FIGURES: tuple[tuple[str, Text, int], ...] = (
    ("form_all_um", message("form-all-m"), 1),
    ("range_all_um", message("range-all-m"), 1),
)
"""Of all points in the gate; older clouds have none."""
CLOUD_FIGURES: tuple[tuple[str, Text, int], ...] = (
    ("angle_arcsec", message("angle"), 0),
    ("z_error_um", "Z, µm", 1),
    ("offset_error_um", message("offset-m"), 1),
    ("radius_error_um", message("radius-m"), 1),
    ("centre_error_um", message("centre-m"), 1),
)


def _clouds(document: VerificationFile) -> list[Section[Text]]:
    """The figures of each cloud as a table, and as points over the clouds (article, Figs. 7-11)."""
    known = [
        (name, title, decimals)
        for name, title, decimals in CLOUD_FIGURES
        if any(getattr(cloud, name) is not None for cloud in document.clouds)
    ]
    forms = [
        (name, title, decimals)
        for name, title, decimals in FORM_FIGURES
        if any(getattr(cloud, name) is not None for cloud in document.clouds)
    ]
    rows: list[tuple[Text, ...]] = [
        (
            cloud.name,
            str(cloud.used),
            quantity(cloud.rms_um, decimals=1),
            quantity(cloud.form_um, decimals=1),
            *(_cell(cloud, name, decimals) for name, _, decimals in (*forms, *known)),
        )
        for cloud in document.clouds
    ]
    columns = (
        message("cloud"),
        message("points-used"),
        "rms, µm",
        message("form-95-m"),
        *(title for _, title, _ in (*forms, *known)),
    )
    widths = (18, 12, 10, 13, *[12] * (len(forms) + len(known)))
    table = ReportTable[Text](columns, rows, widths)
    sections = [Section[Text](message("clouds-2"), [table], together=False)]
    if len(document.clouds) > 1 and known:
        plots = [cloud_plot(document, name, title) for name, title, _ in known]
        sections.append(Section(message("over-clouds"), [Pictures(plots, 3)], together=False))
    return sections


def _maps(folder: Path, document: VerificationFile) -> list[Section[Text]]:
    """The deviations of each cloud from its own shape, if the folder has them."""
    maps = [
        (cloud, MapFile.read(path))
        for cloud in document.clouds
        if (path := (folder / cloud.recording).parent / MAP).is_file()
    ]
    figures = [deviation_figure(cloud.name, cells) for cloud, cells in maps if cells.deviation_um]
    if not figures:
        return []
    return [Section(message("residuals-gauge-2"), [Pictures(figures, 3)], together=False)]


def _cell(cloud: CloudPart, name: str, decimals: int) -> Text:
    value = getattr(cloud, name)
    return "–" if value is None else quantity(value, decimals=decimals)
