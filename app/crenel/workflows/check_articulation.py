"""The arm check from a table of angles: the result of each seat, and the verdict."""

from dataclasses import dataclass
from pathlib import Path

import numpy as np

from crenel.formats.datasheets.arm import read_arm
from crenel.formats.io_errors import prefix_errors
from crenel.formats.session.arm_session import ARM, ARTICULATION, read_seats
from crenel.messages.message import message
from crenel.metrology.arm.identification.articulation import (
    Articulation,
    ArticulationLimits,
    ArticulationVerdict,
    check_articulation,
)


@dataclass(frozen=True)
class SeatReport:
    """One seat of a check."""

    name: str
    check: Articulation


def check_table(
    place: Path, arm_path: Path | None, limits: ArticulationLimits
) -> tuple[SeatReport, ...]:
    """Checks every set of an ``articulation.csv``.

    Args:
        place: the table, or a folder that holds it.
        arm_path: the file of the arm; by default the ``arm.json`` next to the table.

    Raises:
        OperationError: a file is missing or wrong, a set has too few points, or the
            arm hardly moved in it.
    """
    table = place / ARTICULATION if place.is_dir() else place
    arm = read_arm(arm_path or table.parent / ARM)
    seats = read_seats(table, arm)
    with prefix_errors(table):
        return tuple(
            SeatReport(
                seat.name,
                check_articulation(arm, seat.q_rad, limits, message("set", name=seat.name)),
            )
            for seat in seats
        )


def worst_verdict(reports: tuple[SeatReport, ...]) -> ArticulationVerdict:
    """The worst verdict of all seats."""
    verdicts = [report.check.verdict for report in reports]
    return "fail" if "fail" in verdicts else verdicts[0]


def report_rows(reports: tuple[SeatReport, ...]) -> list[list[str]]:
    """One row per seat: (max - min)/2 and 2 sigma by axis in µm, largest distance and 2 s in space,
    the encoders' part, the range of motion."""
    rows: list[list[str]] = []
    for report in reports:
        check = report.check
        rows.append(
            [
                report.name,
                str(check.points),
                *(f"{value:.1f}" for value in check.half_range_um),
                *(f"{value:.1f}" for value in check.two_sigma_um),
                f"{check.largest_um:.1f}",
                f"{check.two_s_um:.1f}",
                f"{float(np.max(check.encoders_two_sigma_um)):.1f}",
                f"{float(np.rad2deg(np.max(check.swing_rad))):.0f}",
                {"pass": "pass", "fail": "FAIL", "none": ""}[check.verdict],
            ]
        )
    return rows


def report_fields(reports: tuple[SeatReport, ...]) -> dict[str, object]:
    """The check as JSON for programs."""
    return {
        "verdict": worst_verdict(reports),
        "sets": [
            {
                "set": report.name,
                "points": report.check.points,
                "centre_mm": report.check.centre_mm.tolist(),
                "half_range_um": report.check.half_range_um.tolist(),
                "two_sigma_um": report.check.two_sigma_um.tolist(),
                "largest_um": report.check.largest_um,
                "two_s_um": report.check.two_s_um,
                "encoders_two_sigma_um": report.check.encoders_two_sigma_um.tolist(),
                "swing_deg": np.rad2deg(report.check.swing_rad).tolist(),
                "verdict": report.check.verdict,
            }
            for report in reports
        ],
    }
