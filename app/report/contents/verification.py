"""The report on a verification, from its folder alone."""

from pathlib import Path

from app.formats.results.verification import (
    VERIFICATION,
    CloudPart,
    FigurePart,
    PlacingPart,
    VerificationFile,
    read_verification,
)
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
from app.report.contents.gauge_figure import deviation_figure
from app.report.figure import (
    BLUE,
    FAINT,
    GROUND,
    INK,
    LINE,
    ORANGE,
    RED,
    SOFT,
    Dot,
    Figure,
    Polyline,
)
from app.report.formatting import (
    UNKNOWN,
    device_name,
    format_moment,
    micrometres,
    millimetres,
    simulation_notes,
    temperature,
)
from app.report.provenance import inputs_section
from app.workflows.measure_gauge import MAP, MapFile

WORDS = {"pass": "Pass", "fail": "Fail", "uncertain": "Undecided"}
QUALITIES: dict[str, Quality] = {
    "pass": "good",
    "fail": "bad",
    "uncertain": "attention",
    "none": "neutral",
}
LABELS = 192.0
"""Wide enough for the longest name of a figure, in every language."""
TICK_SPACE = 7.0
"""Between the numbers at a plot's side, so that none is written over another."""
DECISIONS = {"pass": "pass", "fail": "fail", "uncertain": "undecided", "none": "no limit"}


def verification_report(folder: Path) -> Report:
    """The report on the ``verification.json`` of a verification's folder.

    Raises:
        Refusal: there is none, or a file that it needs is missing or damaged.
    """
    sheet = read_verification(folder)
    result = sheet.verdict.result
    reasons = [
        ReportFinding(QUALITIES[figure.decision], _reason(figure)) for figure in sheet.figures
    ]
    notes = [ReportFinding("neutral", note) for note in sheet.notes]
    sections = [
        Section("What was verified", [Facts(_facts(sheet))]),
        Section("Results", [_results(sheet), *_rule()]),
        signatures(sheet.operator),
        Section("Reasons", [Findings([*reasons, *notes])], together=False),
        Section("Against the limits", [Pictures([_limit_figure(sheet)])]),
        *_clouds(sheet),
        *_maps(folder, sheet),
        inputs_section(folder, sheet.inputs, VERIFICATION),
    ]
    return Report(
        title=f"Verification on a gauge {sheet.gauge.shape}",
        number=sheet.id,
        station=sheet.station,
        date=format_moment(sheet.accepted_at),
        verdict=Verdict(QUALITIES[result], WORDS[result], sheet.verdict.text),
        notes=simulation_notes(sheet.simulated),
        sections=sections,
    )


def _reason(figure: FigurePart) -> str:
    """The figure's own sentence, beginning with what it is about."""
    told = figure.reason.startswith(figure.title)
    return figure.reason if told else f"{figure.title}: {figure.reason}"


def _facts(sheet: VerificationFile) -> list[tuple[str, str]]:
    gauge, used = sheet.gauge, sheet.calibration
    start, end = sheet.temperature.start_c, sheet.temperature.end_c
    known = temperature(start if start is not None else end)
    paper = f"certificate {gauge.certificate}" if gauge.certificate else "no certificate stated"
    radius = f", radius {gauge.radius_mm:.4f} mm" if gauge.radius_mm is not None else ""
    return [
        ("Operator", sheet.operator or UNKNOWN),
        ("Begun", format_moment(sheet.started_at)),
        ("Accepted", format_moment(sheet.accepted_at)),
        ("Temperature", known if start is None or end is None else f"{start:.1f} to {end:.1f} °C"),
        ("Gauge", device_name(gauge.name, gauge.serial_number) + radius),
        (
            "Its paper",
            f"{paper}; known to {gauge.standard_uncertainty_um:g} µm (k = 1), "
            f"form {gauge.form_um:g} µm",
        ),
        ("Arm", f"serial number {sheet.serial_numbers.arm or UNKNOWN}"),
        ("Sensor", f"serial number {sheet.serial_numbers.sensor or UNKNOWN}"),
        ("Calibration", f"{used.name}, a point known to {used.total_um:.1f} µm (k = 1)"),
        ("Placed", _placement_text(sheet.placing)),
        ("Software", f"Crenel {sheet.software.version}"),
    ]


def _placement_text(placing: PlacingPart | None) -> str:
    if placing is None:
        return "the gauge was not touched: shape and size only"
    known = micrometres(placing.standard_uncertainty_um)
    return f"by {placing.touches} touches, {placing.rms_um:.1f} µm rms, known to {known} (k = 1)"


def _results(sheet: VerificationFile) -> ReportTable:
    rows = [
        (
            figure.title,
            _value(figure.value, figure.unit),
            millimetres(figure.value) if figure.unit == "µm" else "",
            f"± {_value(figure.expanded_uncertainty, figure.unit)}",
            "none" if figure.limit is None else _value(figure.limit, figure.unit),
            DECISIONS[figure.decision],
        )
        for figure in sheet.figures
    ]
    columns = ("Figure", "Value", "In mm", "U, k = 2", "Limit", "Decision")
    return ReportTable(columns, rows, (34, 14, 15, 14, 13, 13))


def _value(value: float, unit: str) -> str:
    return f"{value:.0f}″" if unit == "″" else f"{value:.1f} µm"


def _rule() -> list[TextBlock]:
    return [
        TextBlock(
            "Decision rule by ISO 14253-1: pass where the value is proven within its limit, by "
            "more than its expanded uncertainty (k = 2); fail where it is proven beyond; else "
            "undecided."
        ),
        TextBlock(
            "Not to standard: the positions, articulations and counts of ISO 10360-8 and of "
            "ISO 10360-12 are not run to the letter, so that no symbol of theirs is printed."
        ),
    ]


def _limit_figure(sheet: VerificationFile) -> tuple[Figure, str]:
    """Each figure in shares of its limit, with its uncertainty and each cloud's own value."""
    shown = [figure for figure in sheet.figures if figure.limit is not None]
    figure = Figure(520, 24.0 * max(len(shown), 1) + 26, "The figures against their limits")
    left, width = LABELS, 270.0
    reach = max((_limit_share(one) for one in shown), default=1.0)
    scale = width / (2 * max(1.2, 1.05 * reach))
    zero = left + width / 2
    for row, one in enumerate(shown):
        assert one.limit is not None
        y = 24.0 * row + 14
        figure.box((left, y - 7), width, 14, GROUND)
        u = one.expanded_uncertainty / one.limit * scale
        at = zero + one.value / one.limit * scale
        colour = {"pass": BLUE, "fail": RED}.get(one.decision, ORANGE)
        for value in one.clouds:
            figure.items.append(Dot((zero + value / one.limit * scale, y), 1.8, "", FAINT, 0.7))
        figure.line((at - u, y), (at + u, y), stroke=colour, width=2)
        figure.items.append(Dot((at, y), 3, colour, "#ffffff", 0.6))
        figure.label((left - 8, y + 3), one.title, 7.5, SOFT, "end")
        figure.label((left + width + 8, y + 3), _value(one.value, one.unit), 8, INK)
    bottom = 24.0 * len(shown) + 4
    figure.line((zero, 2.0), (zero, bottom), stroke=LINE)
    for sign in (-1, 1):
        x = zero + sign * scale
        figure.items.append(Polyline(((x, 2.0), (x, bottom)), RED, 1, dash=(3, 2)))
        figure.label((x, bottom + 11), "limit", 7.5, RED, "middle")
    words = (
        "Values in shares of their limits: the bar is the expanded uncertainty (k = 2), circles "
        "are the single clouds."
    )
    return figure, words


def _limit_share(one: FigurePart) -> float:
    assert one.limit is not None
    return (abs(one.value) + one.expanded_uncertainty) / one.limit


CLOUD_FIGURES = (
    ("angle_arcsec", "Angle, ″", 0),
    ("z_error_um", "Z, µm", 1),
    ("offset_error_um", "Offset, µm", 1),
    ("radius_error_um", "Radius, µm", 1),
    ("centre_error_um", "Centre, µm", 1),
)


def _clouds(sheet: VerificationFile) -> list[Section]:
    """Each cloud's figures as a table, and as points over the clouds (paper, Figs. 7-11)."""
    told = [
        (name, title, decimals)
        for name, title, decimals in CLOUD_FIGURES
        if any(getattr(cloud, name) is not None for cloud in sheet.clouds)
    ]
    rows = [
        (
            cloud.name,
            str(cloud.used),
            f"{cloud.rms_um:.1f}",
            f"{cloud.form_um:.1f}",
            *(_cell(cloud, name, decimals) for name, _, decimals in told),
        )
        for cloud in sheet.clouds
    ]
    columns = ("Cloud", "Points used", "rms, µm", "Form 95 %, µm", *(t for _, t, _ in told))
    table = ReportTable(columns, rows, (22, 14, 11, 15, *[12] * len(told)))
    sections = [Section("Clouds", [table], together=False)]
    if len(sheet.clouds) > 1 and told:
        plots = [_plot(sheet, name, title) for name, title, _ in told]
        sections.append(Section("Over the clouds", [Pictures(plots, 3)], together=False))
    return sections


def _maps(folder: Path, sheet: VerificationFile) -> list[Section]:
    """How each cloud lies about its own shape, where the folder has it."""
    maps = [
        (cloud, MapFile.read(path))
        for cloud in sheet.clouds
        if (path := (folder / cloud.recording).parent / MAP).is_file()
    ]
    shown = [deviation_figure(cloud.name, found) for cloud, found in maps if found.deviation_um]
    if not shown:
        return []
    return [Section("Residuals on the gauge", [Pictures(shown, 3)], together=False)]


def _cell(cloud: CloudPart, name: str, decimals: int) -> str:
    value = getattr(cloud, name)
    return "–" if value is None else f"{value:.{decimals}f}"


def _plot(sheet: VerificationFile, name: str, title: str) -> tuple[Figure, str]:
    values = [getattr(cloud, name) for cloud in sheet.clouds]
    known = [float(value) for value in values if value is not None]
    low, high = min([0.0, *known]), max([0.0, *known])
    span = max(high - low, 1e-9) * 1.15
    figure = Figure(250, 120, title)
    left, width, bottom, height = 34.0, 208.0, 100.0, 88.0
    figure.box((left, bottom - height), width, height, "#f7f8fa", LINE)

    def y(value: float) -> float:
        return bottom - 4 - (value - low) / span * (height - 8)

    figure.line((left, y(0.0)), (left + width, y(0.0)), stroke=FAINT, width=0.6)
    figure.label((left - 4, y(0.0) + 2.5), "0", 7, FAINT, "end")
    told = [0.0]
    for value in (max(known, key=abs), min(known, key=abs)):
        # what would stand in another's place is read from the table
        if all(abs(y(value) - y(other)) >= TICK_SPACE for other in told):
            figure.label((left - 4, y(value) + 2.5), f"{value:.0f}", 7, FAINT, "end")
            told.append(value)
    step = width / len(values)
    for i, value in enumerate(values):
        x = left + (i + 0.5) * step
        figure.label((x, bottom + 10), str(i + 1), 7, FAINT, "middle")
        if value is not None:
            figure.items.append(Dot((x, y(value)), 2.6, BLUE))
    return figure, f"{title}, cloud by cloud."
