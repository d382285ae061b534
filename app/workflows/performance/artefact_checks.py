"""Artefacts that cannot serve: then no symbol is stated, and it is said why."""

from datetime import date

from app.formats.performance.plan import PerformancePlan, SpherePart
from app.formats.results.calibration import Calibration
from app.messages.message import Text, message, quantity

LEAST_DIAMETER_MM = 10.0
"""ISO 10360-5 and -8."""


def artefact_problems(plan: PerformancePlan, calibration: Calibration | None) -> list[Text]:
    """Why the artefact of a plan cannot serve; empty if it can."""
    problems: list[Text] = []
    artefact = plan.sphere or plan.length or plan.plate
    if artefact is None:
        return [message("artefact-missing")]
    own = None if calibration is None else calibration.serial_numbers.object
    if own and artefact.serial_number and own == artefact.serial_number:
        problems.append(message("artefact-is-calibration-object", serial_number=own))
    until = artefact.valid_until
    if until and until < plan.started_at[:10]:
        problems.append(message("certificate-out-of-date", until=until))
    if until and not _is_date(until):
        problems.append(message("certificate-date-unreadable", until=until))
    if isinstance(artefact, SpherePart):
        problems += _sphere_problems(artefact)
    elif (
        plan.length is not None
        and any(one.standard_uncertainty_um == 0 for one in plan.length.lengths)
    ) or (plan.plate is not None and plan.plate.flatness_um == 0 == plan.plate.flatness_sd_um):
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
