"""The report of a tip check, from the folder of its session alone."""

from pathlib import Path

import numpy as np

from crenel.formats.datasheets.arm import read_arm
from crenel.formats.results.arm_checks import TIP_CHECK, TipCheckFile
from crenel.formats.results.decision_rule import describe_rule
from crenel.formats.session.arm_session import ARM, SPHERES, read_spheres
from crenel.gauges.quick.maths.probed_gauge import sphere_through
from crenel.gauges.report.head import QUALITIES, WORDS
from crenel.messages.message import Text, message, quantity, rounded, signed
from crenel.messages.uncertainty import uncertainty_quantity
from crenel.metrology.arm.kinematics import tip_centres
from crenel.metrology.fitting.touched_shape import agree_on_sphere
from crenel.metrology.transforms import Floats
from crenel.report.content import (
    Facts,
    Pictures,
    Report,
    ReportTable,
    Section,
    TextBlock,
    Verdict,
    signatures,
)
from crenel.report.contents.arm_report import arm_facts, arm_report
from crenel.report.figure import BLUE, FAINT, LINE, PANEL, RED, SOFT, Dot, Figure, Polyline
from crenel.report.formatting import (
    at_most,
    device_name,
    in_both_units,
    micrometres,
    plus_minus,
)
from crenel.report.provenance import inputs_section


def tip_check_report(folder: Path) -> Report[Text]:
    """The report of the ``tip-check.json`` in the folder of a session.

    Raises:
        OperationError: there is none, or a required file is missing or damaged.
    """
    check = TipCheckFile.read(folder / TIP_CHECK)
    arm = read_arm(folder / ARM)
    tips = tip_centres(arm, read_spheres(folder / SPHERES, arm)[-1].q_rad)
    verdict = Verdict(QUALITIES[check.decision], WORDS[check.decision], check.words)
    sections: list[Section[Text]] = [
        Section(message("what-checked"), [_facts(check)]),
        Section(message("results"), [_table(check), *_rule(check)]),
        signatures(check.operator),
        Section(message("contact-points-heading"), [Pictures([_contact_figure(tips, check)])]),
        inputs_section(folder, check.inputs, TIP_CHECK),
    ]
    return arm_report(folder, message("tip-check"), check, check.checked_at, verdict, sections)


def _facts(check: TipCheckFile) -> Facts[Text]:
    rows: list[tuple[Text, Text]] = [
        (message("arm"), device_name(check.arm_name, check.arm_serial)),
        (message("sphere"), _sphere(check)),
        (message("contact-points-label"), str(check.touches)),
    ]
    return arm_facts(check, (message("checked"), check.checked_at), rows)


def _sphere(check: TipCheckFile) -> Text:
    diameter = quantity(check.sphere_mm, "mm", 4)
    if not check.sphere_standard_uncertainty_mm:
        return message("sphere-of-unknown-uncertainty", diameter=diameter)
    known = micrometres(1e3 * check.sphere_standard_uncertainty_mm)
    return message("sphere-known-to", diameter=diameter, known=known)


def _table(check: TipCheckFile) -> ReportTable[Text]:
    limit_um, error_um, scatter_um = check.limit_um, check.error_um, check.scatter_um
    error, scatter = (in_both_units(one, [limit_um]) for one in (error_um, scatter_um))
    known = plus_minus(uncertainty_quantity(check.expanded_uncertainty_um, "µm"))
    rows: list[tuple[Text, ...]] = [
        (message("diameter-of-tip-by-datasheet"), "", quantity(check.expected_mm, "mm", 4), "", ""),
        (message("diameter-tip-found"), "", quantity(check.diameter_mm, "mm", 4), known, ""),
        (message("error"), *error, known, at_most(limit_um, error_um)),
        (message("largest-distance-touch-sphere"), *scatter, "", at_most(limit_um, scatter_um)),
    ]
    if check.bend_um is not None:
        rows.append((message("tip-off-place-arm"), *in_both_units(check.bend_um), "", ""))
    return ReportTable(
        (message("result"), message("value"), message("mm"), "U, k = 2", message("limit")),
        rows,
        (40, 15, 18, 15, 15),
    )


def _rule(check: TipCheckFile) -> list[TextBlock[Text]]:
    return [
        TextBlock(describe_rule(check.rule)),
        TextBlock(message("tip-rule-applies-to-error-alone")),
        TextBlock(message("not-by-standard-other-touches")),
    ]


def _contact_figure(tips_mm: Floats, check: TipCheckFile) -> tuple[Figure[Text], Text]:
    """The distance of each contact point from the sphere through those that agree, in order."""
    limit_um, noise = check.limit_um, np.zeros((len(tips_mm), 3, 3))
    found = agree_on_sphere(tips_mm, noise, (check.sphere_mm + check.expected_mm) / 2)
    centre, reach_mm, _ = sphere_through(tips_mm[found.kept])
    off_um = 1e3 * (np.linalg.norm(tips_mm - centre, axis=1) - reach_mm)
    end = 1.2 * max(float(np.abs(off_um).max()), limit_um or 0.0, 1.0)
    figure = Figure[Text](520, 150, message("each-touchs-distance-sphere"))
    left, width, top, height = 50.0, 455.0, 6.0, 120.0
    figure.box((left, top), width, height, PANEL, LINE)
    middle, scale = top + height / 2, height / (2 * end)
    figure.line((left, middle), (left + width, middle), stroke=FAINT)
    for sign in (-1, 1):
        at = (left - 5, middle - sign * (height / 2 - 5))
        figure.label(at, signed(sign * end, "µm"), 7, FAINT, "end")
        if limit_um is not None:
            y = middle - sign * limit_um * scale
            figure.items.append(Polyline(((left, y), (left + width, y)), RED, 1, dash=(4, 3)))
    step = width / len(off_um)
    for i, off in enumerate(off_um):
        x, y = left + (i + 0.5) * step, middle - float(off) * scale
        figure.line((x, middle), (x, y), stroke=BLUE, width=1.2)
        figure.items.append(Dot((x, y), 2.2, BLUE))
        figure.label((x, top + height + 12), str(i + 1), 7, SOFT, "middle")
    if limit_um is None:
        return figure, message("distance-each-touch-sphere-through-all")
    return figure, message("touches-about-sphere-limit", limit=rounded(limit_um, "µm"))
