"""Artefacts that cannot serve: then no symbol is stated, and it is said why."""

from datetime import date

from app.formats.datasheets.length_standard import LengthStandardFile
from app.formats.performance.plan import PerformancePlan, PlatePart, SpherePart
from app.formats.results.calibration import Calibration
from app.messages.message import Text, message, quantity

Artefact = SpherePart | LengthStandardFile | PlatePart
LEAST_DIAMETER_MM = 10.0
"""ISO 10360-5 and -8."""


def artefact_problems(plan: PerformancePlan, calibration: Calibration | None) -> list[Text]:
    """Why the artefact of a plan cannot serve; empty if it can."""
    artefact = plan.sphere or plan.length or plan.plate
    if artefact is None:
        return [message("artefact-missing")]
    own = None if calibration is None else calibration.serial_numbers.object
    return list_problems(artefact, plan.started_at[:10], own or "")


def list_problems(artefact: Artefact, day: str, own: str) -> list[Text]:
    """Why an artefact cannot serve; empty if it can.

    Args:
        day: of the test, ISO 8601.
        own: serial number of the calibration's own object; empty if it is not known.
    """
    problems: list[Text] = []
    if own and artefact.serial_number and own == artefact.serial_number:
        problems.append(message("artefact-is-calibration-object", serial_number=own))
    until = artefact.valid_until
    if until and until < day:
        problems.append(message("certificate-out-of-date", until=until))
    if until and not _is_date(until):
        problems.append(message("certificate-date-unreadable", until=until))
    if isinstance(artefact, SpherePart):
        problems += _sphere_problems(artefact)
    elif isinstance(artefact, PlatePart):
        if artefact.flatness_um == 0 == artefact.flatness_sd_um:
            problems.append(message("certificate-without-uncertainty"))
    elif any(one.standard_uncertainty_um == 0 for one in artefact.lengths):
        problems.append(message("certificate-without-uncertainty"))
    return problems


def _sphere_problems(sphere: SpherePart) -> list[Text]:
    problems: list[Text] = []
    if sphere.diameter_mm < LEAST_DIAMETER_MM:
        problems.append(
            message(
                "sphere-too-small",
                diameter=quantity(sphere.diameter_mm, "mm", 3),
                least=quantity(LEAST_DIAMETER_MM, "mm"),
            )
        )
    if sphere.diameter_sd_um == 0:
        problems.append(message("certificate-without-uncertainty"))
    return problems


def _is_date(text: str) -> bool:
    try:
        date.fromisoformat(text)
    except ValueError:
        return False
    return True
