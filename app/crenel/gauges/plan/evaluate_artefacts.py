"""Artefacts that cannot serve: then no symbol is stated, and it is said why."""

from datetime import date

from crenel.formats.results.calibration import Calibration
from crenel.gauges.plan.document import PerformancePlan, PlatePart, SpherePart
from crenel.gauges.plan.document_gauge import GaugeFile
from crenel.gauges.plan.document_length_standard import LengthStandardFile
from crenel.gauges.plan.maths_length_places import arm_reach
from crenel.messages.limits import beside_limit
from crenel.messages.message import Text, message, quantity
from crenel.metrology.arm.kinematics import AnyArm

Artefact = SpherePart | LengthStandardFile | PlatePart
LEAST_DIAMETER_MM = 10.0
"""ISO 10360-5 and -8."""
LEAST_WIDTH_MM = 50.0
"""The least width of a plate, and of what a scan shows of it; a choice of this program."""


def problems_of_artefact(
    artefact: Artefact,
    plan: PerformancePlan,
    calibration: Calibration | None,
    arm: AnyArm | None = None,
) -> list[Text]:
    """Why one artefact of a plan cannot serve; empty if it can.

    Args:
        arm: whose reach a length must not exceed; None if that is not checked.
    """
    own = None if calibration is None else calibration.serial_numbers.object
    return list_problems(artefact, plan.started_at[:10], own or "", arm)


def list_problems(artefact: Artefact, day: str, own: str, arm: AnyArm | None = None) -> list[Text]:
    """Why an artefact cannot serve; empty if it can.

    Args:
        day: of the test, ISO 8601.
        own: serial number of the calibration's own object; empty if it is not known.
        arm: by which lengths are measured; None if it is not known.
    """
    problems: list[Text] = []
    number = _same_number(artefact.serial_number)
    if number and number == _same_number(own):
        problems.append(message("artefact-is-calibration-object", serial_number=own))
    until = artefact.valid_until
    if until and until < day:
        problems.append(message("certificate-out-of-date", until=until))
    if until and not _is_date(until):
        problems.append(message("certificate-date-unreadable", until=until))
    if isinstance(artefact, SpherePart):
        problems += _sphere_problems(artefact)
    elif isinstance(artefact, PlatePart):
        problems += _plate_problems(artefact)
    else:
        problems += _length_problems(artefact, arm)
    return problems


def unknown_form(sphere: SpherePart | GaugeFile, name: str) -> Text:
    """Why a form of a sphere cannot be decided; empty if its certificate states its own.

    Args:
        name: of the sphere.
    """
    if sphere.form_um > 0 or sphere.form_sd_um > 0:
        return ""
    return message("performance-form-unknown", name=name)


def _same_number(serial_number: str) -> str:
    """As it is compared: typed by hand, it may differ in case and spaces."""
    return "".join(serial_number.split()).casefold()


def _length_problems(standard: LengthStandardFile, arm: AnyArm | None) -> list[Text]:
    problems: list[Text] = []
    if any(one.standard_uncertainty_um == 0 for one in standard.lengths):
        problems.append(message("certificate-without-uncertainty"))
    shortest_mm = min(one.length_mm for one in standard.lengths)
    diameter_mm = standard.sphere_diameter_mm or 0.0
    if shortest_mm < diameter_mm:
        problems.append(
            message(
                "length-below-spheres",
                length=quantity(shortest_mm, "mm", 3),
                diameter=quantity(diameter_mm, "mm", 3),
            )
        )
    reach, longest_mm = arm and arm_reach(arm), max(one.length_mm for one in standard.lengths)
    if reach and reach.known and longest_mm > reach.radius_mm:
        problems.append(
            message(
                "length-beyond-reach",
                length=quantity(longest_mm, "mm"),
                reach=quantity(reach.radius_mm, "mm"),
            )
        )
    return problems


def _plate_problems(plate: PlatePart) -> list[Text]:
    problems: list[Text] = []
    if plate.flatness_sd_um == 0:
        problems.append(message("certificate-without-uncertainty"))
    if plate.width_mm is not None and plate.width_mm < LEAST_WIDTH_MM:
        width, least = beside_limit(plate.width_mm, LEAST_WIDTH_MM, "mm")
        problems.append(message("plate-too-narrow", width=width, least=least))
    return problems


def _sphere_problems(sphere: SpherePart) -> list[Text]:
    problems: list[Text] = []
    if sphere.diameter_mm < LEAST_DIAMETER_MM:
        diameter, least = beside_limit(sphere.diameter_mm, LEAST_DIAMETER_MM, "mm", 3)
        problems.append(message("sphere-too-small", diameter=diameter, least=least))
    if sphere.diameter_sd_um == 0:
        problems.append(message("certificate-without-uncertainty"))
    return problems


def _is_date(text: str) -> bool:
    try:
        date.fromisoformat(text)
    except ValueError:
        return False
    return True
