"""The report of an identification of the arm, from the folder of its session alone."""

from pathlib import Path

from crenel.errors import OperationError, sentence
from crenel.formats.datasheets.arm import ArmFile
from crenel.formats.datasheets.arm_identification import IdentificationPart, ParameterPart
from crenel.formats.file_names import display_path
from crenel.formats.results.calibration import Input
from crenel.formats.session.arm_session import ARM, IDENTIFIED, read_identification_session
from crenel.messages.message import Text, message, quantity, signed
from crenel.metrology.arm.identification.observations import ArmObservations
from crenel.report.content import (
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
from crenel.report.contents.arm_report import arm_facts, arm_report
from crenel.report.figure import BLUE, FAINT, GROUND, INK, SOFT, Figure
from crenel.report.formatting import (
    NONE,
    ball_diameter,
    device_name,
    in_both_units,
    micrometres,
)
from crenel.report.provenance import inputs_section

Pair = tuple[Text, float, float]
"""A figure's title, and its value before and after."""
BARS = 205.0
"""Wide enough for the longest title and "before" or "after", in every language."""


def identification_report(folder: Path) -> Report[Text]:
    """The report of the ``identified.json`` in the folder of a session.

    Raises:
        OperationError: there is none, or a required file is missing or damaged.
    """
    document = ArmFile.read(folder / IDENTIFIED)
    found = document.identification
    if found is None:
        raise OperationError(
            "not-identified",
            message("says-nothing-identification", folder=display_path(folder / IDENTIFIED)),
            message("arm-by-its-datasheet"),
            message("identify-arm-folders-again", arm=ARM),
        )
    inputs = [Input(file=one.file, sha256=one.sha256) for one in found.inputs]
    sections: list[Section[Text]] = [
        Section(message("what-identified"), [_facts(folder, document, found)]),
        Section(message("results"), [_results(found), *_explanation(found)]),
        signatures(found.operator),
        Section(message("before-after"), [Pictures([_before_and_after(_pairs(found))])]),
        Section(message("arms-parameters"), _parameters(found), together=False),
        inputs_section(folder, inputs, IDENTIFIED),
    ]
    title = message("identification-arm")
    return arm_report(folder, title, found, found.created_at, _verdict(found), sections)


def _verdict(found: IdentificationPart) -> Verdict[Text]:
    before, after = quantity(found.volume_before_um, "µm"), micrometres(found.volume_after_um)
    text = (
        message("over-reach-tip-off-rms-now", before=before, after=after)
        if found.size_known
        else message("tip-known-without-size", before=before, after=after)
    )
    return Verdict("attention" if found.warnings else "good", message("identified"), text)


def _facts(folder: Path, document: ArmFile, found: IdentificationPart) -> Facts[Text]:
    rows: list[tuple[Text, Text]] = [
        (message("arm"), device_name(document.name, document.serial_number)),
        (message("axes"), str(len(document.joints))),
        (message("tip"), "" if document.tip is None else ball_diameter(document.tip.diameter_mm)),
        *_observation_facts(read_identification_session(folder).observations),
    ]
    return arm_facts(found, (message("identified"), found.created_at), rows)


def _observation_facts(observed: ArmObservations) -> list[tuple[Text, Text]]:
    """The number of seats and artefacts that the tip measured."""
    bars = len({bar.name for bar in observed.bars})
    points, frames = observed.coordinates_count, {one.frame for one in observed.coordinates}
    return [
        (message("seats"), str(len(observed.seats)) if observed.seats else NONE),
        (message("spheres"), str(len(observed.spheres)) if observed.spheres else NONE),
        (
            message("ball-bars"),
            message("positions", bars=bars, positions=len(observed.bars)) if bars else NONE,
        ),
        (
            message("coordinates-measured"),
            message("poses-measured", points=points, frames=len(frames)) if points else NONE,
        ),
    ]


def _pairs(found: IdentificationPart) -> list[Pair]:
    """Before and after, in µm: over the reach, and at places that the fit did not use."""
    before, after = found.validation.before, found.validation.after
    validated: tuple[tuple[Text, float | None, float | None], ...] = (
        (message("seats-held-out"), before.seats_um, after.seats_um),
        (message("spheres-held-out"), before.spheres_um, after.spheres_um),
        (message("lengths-ball-bars-held-out"), before.lengths_um, after.lengths_um),
        (message("coordinates-held-out"), before.coordinates_um, after.coordinates_um),
    )
    return [
        (message("tip-over-whole-reach"), found.volume_before_um, found.volume_after_um),
        *((name, was, now) for name, was, now in validated if was is not None and now is not None),
    ]


def _results(found: IdentificationPart) -> ReportTable[Text]:
    rows: list[tuple[Text, ...]] = [
        (name, *in_both_units(was), *in_both_units(now), NONE) for name, was, now in _pairs(found)
    ]
    for name, scatter_um in (
        (message("scatter-single-points-beyond-encoders"), found.scatter_um),
        (message("scatter-coordinates-beyond-uncertainty"), found.coordinates_scatter_um),
    ):
        if scatter_um is not None:
            rows.append((name, "", "", *in_both_units(scatter_um), NONE))
    head = (
        message("result-rms"),
        message("before"),
        message("mm"),
        message("after"),
        message("mm"),
        message("limit"),
    )
    return ReportTable(head, rows, (40, 15, 16, 15, 16, 10))


def _explanation(found: IdentificationPart) -> list[Block[Text]]:
    validation = found.validation
    how = (
        message("folder-their-own") if validation.method == "separate" else message("held-out-turn")
    )
    texts = (
        message("over-reach-before-difference-arm-identified"),
        message(
            "held-out-places-fit-did-see",
            places=validation.places,
            how=how,
            before=quantity(validation.before.normalised, "", 1),
            after=quantity(validation.after.normalised, "", 2),
        ),
        message("no-limit-set-identification-check-arm"),
        message("flange-frame-of-this-arm-former-calibrations-not-valid"),
    )
    blocks: list[Block[Text]] = [TextBlock(text) for text in texts]
    findings = [ReportFinding[Text]("attention", sentence(text), "") for text in found.warnings]
    for outlier in found.outliers:
        findings.append(
            ReportFinding("attention", message("excluded-for-reason", text=outlier), "")
        )
    return [Findings(findings), *blocks] if findings else blocks


def _parameters(found: IdentificationPart) -> list[Block[Text]]:
    rows = [_row(one) for one in found.parameters]
    head = (
        message("parameter"),
        message("unit"),
        message("before"),
        message("after"),
        message("change"),
        "u, k = 1",
    )
    blocks: list[Block[Text]] = [ReportTable(head, rows, (26, 8, 18, 18, 16, 14), 2, small=True)]
    fixed: dict[Text, list[str]] = {}
    for one in found.held:
        fixed.setdefault(one.reason, []).append(one.name)
    if fixed:
        rest: list[tuple[Text, ...]] = [(", ".join(names), why) for why, names in fixed.items()]
        blocks.append(
            ReportTable((message("unchanged"), message("why")), rest, (60, 40), 2, small=True)
        )
    if found.correlated:
        pairs: list[tuple[Text, ...]] = [
            (f"{pair.first}, {pair.second}", signed(pair.coefficient, "", 3))
            for pair in found.correlated
        ]
        title = message("correlated-known-together")
        blocks.append(ReportTable((title, message("coefficient")), pairs, (70, 30), 1, small=True))
    return blocks


def _row(one: ParameterPart) -> tuple[Text, ...]:
    decimals, unit = (6, "°") if one.name.endswith("_deg") else (4, "mm")
    return (
        one.name.removesuffix("_deg").removesuffix("_mm"),
        unit,
        quantity(one.before, "", decimals),
        quantity(one.after, "", decimals),
        signed(one.after - one.before, "", decimals),
        quantity(one.standard_uncertainty, "", decimals),
    )


def _before_and_after(pairs: list[Pair]) -> tuple[Figure[Text], Text]:
    """Two bars each, with separate scales."""
    pitch, left, width = 44.0, BARS, 235.0
    figure = Figure[Text](520, pitch * len(pairs), message("before-after-identification"))
    for i, (name, was, now) in enumerate(pairs):
        top, largest = i * pitch + 4, max(was, now, 1e-9)
        figure.label((2, top + 18), name, 8, INK)
        bars = ((message("before-mark"), was, FAINT), (message("after-mark"), now, BLUE))
        for j, (label, value, colour) in enumerate(bars):
            y = top + 16 * j
            figure.label((left - 6, y + 9), label, 7, SOFT, "end")
            figure.box((left, y), width, 12, GROUND)
            figure.box((left, y), width * value / largest, 12, colour)
            figure.label((left + width + 8, y + 9), micrometres(value), 8, INK)
    return figure, message("rms-before-after-each-pair-scale")
