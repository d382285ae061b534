"""The report on an identification of the arm, from its session's folder alone."""

from pathlib import Path

from app.errors import OperationError
from app.formats.datasheets.arm import ArmFile
from app.formats.datasheets.arm_identification import IdentificationPart, ParameterPart
from app.formats.file_names import display_path
from app.formats.results.calibration import Input
from app.formats.session.arm_session import ARM, IDENTIFIED, read_identification_session
from app.metrology.arm.identification.observations import ArmObservations
from app.report.content import (
    Block,
    Facts,
    Findings,
    Pictures,
    Report,
    ReportFinding,
    ReportTable,
    Section,
    TextBlock,
    Verdict,
    signatures,
)
from app.report.figure import BLUE, FAINT, GROUND, INK, SOFT, Figure
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

Pair = tuple[str, float, float]


def identification_report(folder: Path) -> Report:
    """The report on the ``identified.json`` of a session's folder.

    Raises:
        Refusal: there is none, or a file that it needs is missing or damaged.
    """
    sheet = ArmFile.read(folder / IDENTIFIED)
    found = sheet.identification
    if found is None:
        raise OperationError(
            "not-identified",
            f"{display_path(folder / IDENTIFIED)} says nothing of an identification",
            "it is an arm as its papers have it",
            f"Identify the arm of the folder's {ARM} again",
        )
    inputs = [Input(file=one.file, sha256=one.sha256) for one in found.inputs]
    return Report(
        title="Identification of the arm",
        number=folder.resolve().name,
        station=found.station or "Measuring arm",
        date=format_moment(found.created_at),
        verdict=_verdict(found),
        sections=[
            Section("What was identified", [Facts(_facts(folder, sheet, found))]),
            Section("Results", [_results(found), *_explanation(found)]),
            signatures(found.operator),
            Section("Before and after", [Pictures([_before_and_after(_pairs(found))])]),
            Section("The arm's parameters", _parameters(found), together=False),
            inputs_section(folder, inputs, IDENTIFIED),
        ],
        notes=simulation_notes(found.simulated),
    )


def _verdict(found: IdentificationPart) -> Verdict:
    size = "" if found.size_known else ", apart from the arm's size"
    text = (
        f"Over its reach the tip was off by {found.volume_before_um:.0f} µm rms and is now known "
        f"to {found.volume_after_um:.1f} µm (k = 1){size}."
    )
    return Verdict("attention" if found.warnings else "good", "Identified", text)


def _facts(folder: Path, sheet: ArmFile, found: IdentificationPart) -> list[tuple[str, str]]:
    tip = "" if sheet.tip is None else f"Ø {sheet.tip.diameter_mm:.4g} mm"
    return [
        ("Operator", found.operator or UNKNOWN),
        ("Identified", format_moment(found.created_at)),
        ("Temperature", temperature(found.temperature_c)),
        ("Arm", device_name(sheet.name, sheet.serial_number)),
        ("Axes", str(len(sheet.joints))),
        ("Tip", tip),
        *_observation_facts(read_identification_session(folder).observations),
        ("Software", f"Crenel {found.software.version}"),
    ]


def _observation_facts(seen: ArmObservations) -> list[tuple[str, str]]:
    """What the tip was held in and touched."""
    bars = len({bar.name for bar in seen.bars})
    return [
        ("Seats", str(len(seen.seats)) if seen.seats else "none"),
        ("Spheres", str(len(seen.spheres)) if seen.spheres else "none"),
        ("Ball bars", f"{bars} in {len(seen.bars)} positions" if bars else "none"),
    ]


def _pairs(found: IdentificationPart) -> list[Pair]:
    """Before and after, in µm: over the reach, and on places that the fit did not see."""
    before, after = found.validation.before, found.validation.after
    held = (
        ("Seats, held out", before.seats_um, after.seats_um),
        ("Spheres, held out", before.spheres_um, after.spheres_um),
        ("Lengths of ball bars, held out", before.lengths_um, after.lengths_um),
    )
    return [
        ("Tip over the whole reach", found.volume_before_um, found.volume_after_um),
        *((name, was, now) for name, was, now in held if was is not None and now is not None),
    ]


def _results(found: IdentificationPart) -> ReportTable:
    rows = [
        (name, micrometres(was), millimetres(was), micrometres(now), millimetres(now), "none")
        for name, was, now in _pairs(found)
    ]
    scatter = found.scatter_um
    single = "Scatter of single points beyond the encoders"
    rows.append((single, "", "", micrometres(scatter), millimetres(scatter), "none"))
    head = ("Result, rms", "Before", "In mm", "After", "In mm", "Limit")
    return ReportTable(head, rows, (40, 15, 16, 15, 16, 10))


def _explanation(found: IdentificationPart) -> list[Block]:
    seen = found.validation
    how = "in a folder of their own" if seen.method == "separate" else "held out in turn"
    blocks: list[Block] = [
        TextBlock(
            "Over the reach: before, the difference from the arm as identified; after, the "
            "standard uncertainty, k = 1."
        ),
        TextBlock(
            f"Held out: on {seen.places} places that the fit did not see, {how}; the encoders' "
            f"noise is included. In standard deviations of the points {seen.before.normalised:.1f} "
            f"before and {seen.after.normalised:.2f} after, where 1 is noise alone."
        ),
        TextBlock("No limit is set for an identification: a check of the arm judges it."),
        TextBlock(
            "The flange's frame is now this arm's: calibrations made with the arm before do not "
            "belong to it."
        ),
    ]
    findings = [
        ReportFinding("attention", f"{text[:1].upper()}{text[1:]}.") for text in found.warnings
    ]
    findings += [ReportFinding("attention", f"Left out: {text}.") for text in found.outliers]
    return [Findings(findings), *blocks] if findings else blocks


def _parameters(found: IdentificationPart) -> list[Block]:
    rows = [_row(one) for one in found.parameters]
    head = ("Parameter", "Unit", "Before", "After", "Change", "u, k = 1")
    blocks: list[Block] = [ReportTable(head, rows, (26, 8, 18, 18, 16, 14), 2, small=True)]
    kept: dict[str, list[str]] = {}
    for held in found.held:
        kept.setdefault(held.reason, []).append(held.name)
    if kept:
        rest = [(", ".join(names), why) for why, names in kept.items()]
        blocks.append(ReportTable(("Kept", "Why"), rest, (60, 40), 2, small=True))
    if found.correlated:
        pairs = [(f"{p.first}, {p.second}", f"{p.coefficient:+.3f}") for p in found.correlated]
        title = "Correlated: told together, each alone less well"
        blocks.append(ReportTable((title, "Coefficient"), pairs, (70, 30), 1, small=True))
    return blocks


def _row(one: ParameterPart) -> tuple[str, ...]:
    decimals, unit = (6, "°") if one.name.endswith("_deg") else (4, "mm")
    values = (one.before, one.after)
    change, known = one.after - one.before, one.standard_uncertainty
    return (
        one.name.removesuffix("_deg").removesuffix("_mm"),
        unit,
        *(f"{value:.{decimals}f}" for value in values),
        f"{change:+.{decimals}f}",
        f"{known:.{decimals}f}",
    )


def _before_and_after(pairs: list[Pair]) -> tuple[Figure, str]:
    """Two bars each, on a scale of their own."""
    pitch, left, width = 44.0, 170.0, 270.0
    figure = Figure(520, pitch * len(pairs), "Before and after the identification")
    for i, (name, was, now) in enumerate(pairs):
        top, largest = i * pitch + 4, max(was, now, 1e-9)
        figure.label((2, top + 18), name, 8, INK)
        for j, (word, value, colour) in enumerate((("before", was, FAINT), ("after", now, BLUE))):
            y = top + 16 * j
            figure.label((left - 6, y + 9), word, 7, SOFT, "end")
            figure.box((left, y), width, 12, GROUND)
            figure.box((left, y), width * value / largest, 12, colour)
            figure.label((left + width + 8, y + 9), micrometres(value), 8, INK)
    return figure, "Rms before and after, each pair on a scale of its own."
