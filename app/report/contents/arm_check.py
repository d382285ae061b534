"""The report on a daily check of the arm, from its session's folder alone."""

from pathlib import Path

import numpy as np

from app.formats.datasheets.arm import read_arm
from app.formats.results.arm_checks import ARM_CHECK, ArmCheckFile
from app.formats.session.arm_session import ARM, ARTICULATION, read_seats
from app.metrology.arm.kinematics import Arm, tip_centres
from app.metrology.transforms import Floats
from app.report.content import (
    Facts,
    Pictures,
    Report,
    ReportTable,
    Section,
    TextBlock,
    Verdict,
    signatures,
)
from app.report.figure import BLUE, FAINT, LINE, RED, SOFT, Dot, Figure, Polyline
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

WORDS = {
    "good": "Within the limit",
    "attention": "Attention",
    "bad": "Beyond the limit",
    "neutral": "No limit was set",
}
AXES = "xyz"


def arm_check_report(folder: Path) -> Report:
    """The report on the ``arm-check.json`` of a session's folder.

    Raises:
        Refusal: there is none, or a file that it needs is missing or damaged.
    """
    check = ArmCheckFile.read(folder / ARM_CHECK)
    arm = read_arm(folder / ARM)
    seat = read_seats(folder / ARTICULATION, arm)[-1]
    worst = max(check.half_range_um)
    limit = "" if check.limit_um is None else f"; the limit is {check.limit_um:g} µm"
    text = (
        f"The tip held in a seat moved by {worst:.0f} µm, (max − min)/2 on the worst axis{limit}."
    )
    sections = [
        Section("What was checked", [Facts(_check_facts(check, arm))]),
        Section("Results", [_table(check), *_rule()]),
        signatures(check.operator),
        Section("The tip's places", [Pictures([_places(arm, seat.q_rad, check.limit_um)])]),
        Section("How the arm swung", [_swing(arm, seat.q_rad)]),
        inputs_section(folder, check.inputs, ARM_CHECK),
    ]
    notes = simulation_notes(check.simulated)
    return Report(
        title="Arm check",
        number=folder.resolve().name,
        station=check.station or "Measuring arm",
        date=format_moment(check.checked_at),
        verdict=Verdict(check.verdict, WORDS[check.verdict], text),
        sections=sections,
        notes=notes,
    )


def _check_facts(check: ArmCheckFile, arm: Arm) -> list[tuple[str, str]]:
    return [
        ("Operator", check.operator or UNKNOWN),
        ("Checked", format_moment(check.checked_at)),
        ("Temperature", temperature(check.temperature_c)),
        ("Arm", device_name(check.arm_name, check.arm_serial)),
        ("Axes", str(arm.joint_count)),
        ("Tip", f"Ø {2 * arm.tip.radius_mm:.4g} mm"),
        ("Points", str(check.points)),
        ("Software", f"Crenel {check.software.version}"),
    ]


def _table(check: ArmCheckFile) -> ReportTable:
    rows = [
        (f"(max − min)/2 along {axis}", micrometres(value), millimetres(value), _limit(check))
        for axis, value in zip(AXES, check.half_range_um, strict=True)
    ]
    rows += [
        (f"2σ along {axis}", micrometres(value), millimetres(value), "")
        for axis, value in zip(AXES, check.two_sigma_um, strict=True)
    ]
    rows += [
        (f"2σ by the encoders alone, {axis}", micrometres(value), millimetres(value), "")
        for axis, value in zip(AXES, check.encoders_two_sigma_um, strict=True)
    ]
    return ReportTable(("Result", "Value", "In mm", "Limit"), rows, (46, 18, 18, 18))


def _limit(check: ArmCheckFile) -> str:
    return "none" if check.limit_um is None else f"≤ {check.limit_um:g} µm"


def _rule() -> list[TextBlock]:
    return [
        TextBlock(
            "Decision rule: (max − min)/2 of each axis is compared with its limit directly; "
            "there is no guard band: what the form of seat and tip adds is not stated."
        ),
        TextBlock(
            "Not to standard: one seat and a continuous swing, not the positions and points of "
            "ASME B89.4.22 or ISO 10360-12. No result of theirs is claimed."
        ),
    ]


def _places(arm: Arm, q_rad: Floats, limit_um: float | None) -> tuple[Figure, str]:
    """The tip about its middle, seen along z and along y, with the limit as a square."""
    tips = tip_centres(arm, q_rad)
    off_um = 1e3 * (tips - (tips.max(axis=0) + tips.min(axis=0)) / 2)
    reach = 1.15 * max(float(np.abs(off_um).max()), limit_um or 0.0, 1.0)
    figure = Figure(520, 232, "The tip's places about their middle")
    for number, (across, up) in enumerate(((0, 1), (0, 2))):
        left, top, size = 70.0 + 240.0 * number, 6.0, 200.0
        scale = size / (2 * reach)
        middle = (left + size / 2, top + size / 2)
        figure.box((left, top), size, size, "#f7f8fa", LINE)
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
            figure.label((x, top + size + 12), f"{sign * reach:+.0f}", 7, FAINT, "middle")
    words = "Each point of the swing about the middle of all, in the arm's frame."
    if limit_um is not None:
        words += f" Dashed: the limit of {limit_um:g} µm."
    return figure, words


def _swing(arm: Arm, q_rad: Floats) -> ReportTable:
    degrees = np.rad2deg(q_rad)
    rows = [
        (joint.name, f"{q.min():.1f}°", f"{q.max():.1f}°", f"{np.ptp(q):.1f}°")
        for joint, q in zip(arm.joints, degrees.T, strict=True)
    ]
    return ReportTable(("Joint", "From", "To", "Swing"), rows, (25, 25, 25, 25))
