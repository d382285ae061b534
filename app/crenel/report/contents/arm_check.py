"""The report of an arm check, from the folder of its session alone."""

from pathlib import Path

import numpy as np

from crenel.formats.datasheets.arm import read_arm
from crenel.formats.results.arm_checks import ARM_CHECK, ArmCheckFile
from crenel.formats.results.decision_rule import describe_rule
from crenel.formats.session.arm_session import ARM, ARTICULATION, read_seats
from crenel.messages.limits import beside_limit
from crenel.messages.message import Message, Text, message, quantity, rounded, signed
from crenel.metrology.arm.kinematics import Arm, tip_centres
from crenel.metrology.transforms import Floats
from crenel.report.content import (
    Facts,
    Pictures,
    Quality,
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
    ball_diameter,
    device_name,
    in_both_units,
)
from crenel.report.provenance import inputs_section

WORDS: dict[Quality, Message] = {
    "good": message("within-limit"),
    "attention": message("attention"),
    "bad": message("beyond-limit"),
    "neutral": message("no-limit-set-heading"),
}
AXES = "xyz"


def arm_check_report(folder: Path) -> Report[Text]:
    """The report of the ``arm-check.json`` in the folder of a session.

    Raises:
        OperationError: there is none, or a required file is missing or damaged.
    """
    check = ArmCheckFile.read(folder / ARM_CHECK)
    arm = read_arm(folder / ARM)
    seat = read_seats(folder / ARTICULATION, arm)[-1]
    sections: list[Section[Text]] = [
        Section(message("what-checked"), [_facts(check, arm)]),
        Section(message("results"), [_table(check), *_rule(check)]),
        signatures(check.operator),
        Section(message("tips-places"), [Pictures([_places(arm, seat.q_rad, check.limit_um)])]),
        Section(message("how-arm-swung"), [_swing(arm, seat.q_rad)]),
        inputs_section(folder, check.inputs, ARM_CHECK),
    ]
    verdict = Verdict(check.verdict, WORDS[check.verdict], _sentence(check))
    return arm_report(folder, message("arm-check"), check, check.checked_at, verdict, sections)


def _sentence(check: ArmCheckFile) -> Message:
    worst_um = max(check.half_range_um)
    if check.limit_um is None:
        return message("tip-held-seat-moved-max-min", worst=quantity(worst_um, "µm"))
    worst, limit = beside_limit(worst_um, check.limit_um, "µm")
    return message("tip-in-seat-moved-limit", worst=worst, limit=limit)


def _facts(check: ArmCheckFile, arm: Arm) -> Facts[Text]:
    rows: list[tuple[Text, Text]] = [
        (message("arm"), device_name(check.arm_name, check.arm_serial)),
        (message("axes"), str(arm.joint_count)),
        (message("tip"), ball_diameter(2 * arm.tip.radius_mm)),
        (message("points"), str(check.points)),
    ]
    return arm_facts(check, (message("checked"), check.checked_at), rows)


def _table(check: ArmCheckFile) -> ReportTable[Text]:
    rows: list[tuple[Text, ...]] = []
    if check.largest_um is not None and check.two_s_um is not None:
        rows.append((message("largest-distance-from-mean"), *in_both_units(check.largest_um), ""))
        rows.append((message("two-s-of-distances"), *in_both_units(check.two_s_um), ""))
    for axis, value in zip(AXES, check.half_range_um, strict=True):
        shown = in_both_units(value, [check.limit_um])
        limit = at_most(check.limit_um, value)
        rows.append((message("max-min-2-along", axis=axis), *shown, limit))
    for axis, value in zip(AXES, check.two_sigma_um, strict=True):
        rows.append((message("n-2-along", axis=axis), *in_both_units(value), ""))
    for axis, value in zip(AXES, check.encoders_two_sigma_um, strict=True):
        rows.append((message("n-2-encoders-alone", axis=axis), *in_both_units(value), ""))
    return ReportTable(
        (message("result"), message("value"), message("mm"), message("limit")),
        rows,
        (46, 18, 18, 18),
    )


def _rule(check: ArmCheckFile) -> list[TextBlock[Text]]:
    return [
        TextBlock(describe_rule(check.rule)),
        TextBlock(message("arm-check-uncertainty-is-zero")),
        TextBlock(message("not-by-standard-one-seat")),
    ]


def _places(arm: Arm, q_rad: Floats, limit_um: float | None) -> tuple[Figure[Text], Text]:
    """The tip relative to its middle, seen along z and along y, with the limit as a square."""
    tips = tip_centres(arm, q_rad)
    off_um = 1e3 * (tips - (tips.max(axis=0) + tips.min(axis=0)) / 2)
    reach = 1.15 * max(float(np.abs(off_um).max()), limit_um or 0.0, 1.0)
    figure = Figure[Text](520, 232, message("tips-places-about-their-middle"))
    for number, (across, up) in enumerate(((0, 1), (0, 2))):
        left, top, size = 70.0 + 240.0 * number, 6.0, 200.0
        scale = size / (2 * reach)
        middle = (left + size / 2, top + size / 2)
        figure.box((left, top), size, size, PANEL, LINE)
        figure.line((left, middle[1]), (left + size, middle[1]))
        figure.line((middle[0], top), (middle[0], top + size))
        if limit_um is not None:
            d = limit_um * scale
            square = [(-d, -d), (d, -d), (d, d), (-d, d), (-d, -d)]
            points = tuple((middle[0] + x, middle[1] + y) for x, y in square)
            figure.items.append(Polyline(points, RED, 1, dash=(4, 3)))
        for off in off_um:
            at = (middle[0] + float(off[across]) * scale, middle[1] - float(off[up]) * scale)
            figure.items.append(Dot(at, 1.5, BLUE))
        figure.label((middle[0], top + size + 12), f"{AXES[across]}, µm", 7.5, SOFT, "middle")
        figure.label((left - 6, middle[1] + 3), f"{AXES[up]}, µm", 7.5, SOFT, "end")
        for sign in (-1, 1):
            x = middle[0] + sign * size / 2
            figure.label((x, top + size + 12), signed(sign * reach), 7, FAINT, "middle")
    if limit_um is None:
        return figure, message("each-point-swing-about-middle-all")
    return figure, message("swing-about-middle-limit", limit=rounded(limit_um, "µm"))


def _swing(arm: Arm, q_rad: Floats) -> ReportTable[Text]:
    rows: list[tuple[Text, ...]] = [
        (joint.name, *(quantity(angle, "°", 1) for angle in (q.min(), q.max(), np.ptp(q))))
        for joint, q in zip(arm.joints, np.rad2deg(q_rad).T, strict=True)
    ]
    return ReportTable(
        (message("joint"), message("from"), message("to"), message("swing")),
        rows,
        (25, 25, 25, 25),
    )
