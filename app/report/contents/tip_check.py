"""The report on a check of the tip, from its session's folder alone."""

from pathlib import Path

import numpy as np

from app.formats.datasheets.arm import read_arm
from app.formats.results.arm_checks import TIP_CHECK, TipCheckFile
from app.formats.session.arm_session import ARM, SPHERES, read_spheres
from app.metrology.arm.kinematics import tip_centres
from app.metrology.gauges.probed_gauge import sphere_through
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
from app.report.contents.verification import QUALITIES, WORDS
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


def tip_check_report(folder: Path) -> Report:
    """The report on the ``tip-check.json`` of a session's folder.

    Raises:
        Refusal: there is none, or a file that it needs is missing or damaged.
    """
    check = TipCheckFile.read(folder / TIP_CHECK)
    arm = read_arm(folder / ARM)
    tips = tip_centres(arm, read_spheres(folder / SPHERES, arm)[-1].q_rad)
    word = WORDS.get(check.decision, "No limit was set")
    return Report(
        title="Tip check",
        number=folder.resolve().name,
        station=check.station or "Measuring arm",
        date=format_moment(check.checked_at),
        verdict=Verdict(QUALITIES[check.decision], word, check.words),
        sections=[
            Section("What was checked", [Facts(_facts(check))]),
            Section("Results", [_table(check), *_rule()]),
            signatures(check.operator),
            Section("The touches", [Pictures([_contact_figure(tips, check.limit_um)])]),
            inputs_section(folder, check.inputs, TIP_CHECK),
        ],
        notes=simulation_notes(check.simulated),
    )


def _facts(check: TipCheckFile) -> list[tuple[str, str]]:
    unsure = 1e3 * check.sphere_standard_uncertainty_mm
    known = f"known to {unsure:.1f} µm (k = 1)" if unsure else "its uncertainty is not stated"
    return [
        ("Operator", check.operator or UNKNOWN),
        ("Checked", format_moment(check.checked_at)),
        ("Temperature", temperature(check.temperature_c)),
        ("Arm", device_name(check.arm_name, check.arm_serial)),
        ("Sphere", f"Ø {check.sphere_mm:.4f} mm, {known}"),
        ("Touches", str(check.touches)),
        ("Software", f"Crenel {check.software.version}"),
    ]


def _table(check: TipCheckFile) -> ReportTable:
    limit = "none" if check.limit_um is None else f"≤ {check.limit_um:g} µm"
    u = f"± {micrometres(check.expanded_uncertainty_um)}"
    rows = [
        ("Diameter of the tip by its papers", "", f"{check.expected_mm:.4f} mm", "", ""),
        ("Diameter of the tip found", "", f"{check.diameter_mm:.4f} mm", u, ""),
        ("Its error", *_um(check.error_um), u, limit),
        ("Largest distance of a touch from the sphere", *_um(check.scatter_um), "", limit),
    ]
    if check.bend_um is not None:
        rows.append(("Tip off its place on the arm", *_um(check.bend_um), "", ""))
    return ReportTable(
        ("Result", "Value", "In mm", "U, k = 2", "Limit"), rows, (40, 15, 18, 15, 15)
    )


def _um(value_um: float) -> tuple[str, str]:
    return micrometres(value_um), millimetres(value_um)


def _rule() -> list[TextBlock]:
    return [
        TextBlock(
            "Decision rule by ISO 14253-1: the error of the diameter passes where it is proven "
            "within its limit, by more than its expanded uncertainty (k = 2); it fails where it is "
            "proven beyond. The scatter is compared with its limit directly."
        ),
        TextBlock(
            "Not to standard: the touches are not those of the sphere tests of ISO 10360-12, so "
            "that no symbol of theirs is printed."
        ),
    ]


def _contact_figure(tips_mm: Floats, limit_um: float | None) -> tuple[Figure, str]:
    """Each touch's distance from the sphere through all of them, one after another."""
    centre, reach_mm, _ = sphere_through(tips_mm)
    off_um = 1e3 * (np.linalg.norm(tips_mm - centre, axis=1) - reach_mm)
    end = 1.2 * max(float(np.abs(off_um).max()), limit_um or 0.0, 1.0)
    figure = Figure(520, 150, "Each touch's distance from the sphere")
    left, width, top, height = 50.0, 455.0, 6.0, 120.0
    figure.box((left, top), width, height, "#f7f8fa", LINE)
    middle, scale = top + height / 2, height / (2 * end)
    figure.line((left, middle), (left + width, middle), stroke=FAINT)
    for sign in (-1, 1):
        at = (left - 5, middle - sign * (height / 2 - 5))
        figure.label(at, f"{sign * end:+.0f} µm", 7, FAINT, "end")
        if limit_um is not None:
            y = middle - sign * limit_um * scale
            figure.items.append(Polyline(((left, y), (left + width, y)), RED, 1, dash=(4, 3)))
    step = width / len(off_um)
    for i, off in enumerate(off_um):
        x, y = left + (i + 0.5) * step, middle - float(off) * scale
        figure.line((x, middle), (x, y), stroke=BLUE, width=1.2)
        figure.items.append(Dot((x, y), 2.2, BLUE))
        figure.label((x, top + height + 12), str(i + 1), 7, SOFT, "middle")
    words = "Distance of each touch from the sphere through all of them."
    return figure, words + ("" if limit_um is None else f" Dashed: the limit of {limit_um:g} µm.")
