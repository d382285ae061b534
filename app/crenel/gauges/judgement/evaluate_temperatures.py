"""Whether artefact and arm kept their temperature in a test, whether the artefact's expansion is
known, and what is said of it."""

from crenel.gauges.judgement.document import TemperaturesPart
from crenel.gauges.plan.document import PerformancePlan, SpherePart
from crenel.gauges.plan.document_gauge import GaugeFile
from crenel.gauges.plan.document_length_standard import LengthStandardFile
from crenel.gauges.plan.document_symbols import Quantity
from crenel.gauges.plan.document_temperatures import EndTemperatures
from crenel.gauges.plan.maths_temperature import (
    REFERENCE_C,
    ROUNDING_C,
    TemperatureLimits,
    TemperatureSpan,
)
from crenel.messages.limits import beside_limit, decimals_beside
from crenel.messages.message import Text, message, quantity, rounded

Expanding = SpherePart | GaugeFile | LengthStandardFile
UNKNOWN_FROM_20_C = 0.2
"""So far from 20 °C an unknown expansion is neglected: 2.3 µm of a metre of steel."""
BY_SPHERE: tuple[Quantity, ...] = (
    "size-touch", "size-scan", "size-all-scan", "size-both", "effective-diameter",
)  # fmt: skip
"""What is compared with the diameter of the sphere. Forms and locations do not expand with it."""
BY_LENGTHS: tuple[Quantity, ...] = (
    "length-touch", "length-scan", "volumetric-largest", "volumetric-two-rms",
)  # fmt: skip
"""What is compared with the lengths of a standard."""


def find_unsteady(
    artefact: TemperatureSpan, arm: TemperatureSpan, limits: TemperatureLimits
) -> list[Text]:
    """Why temperatures were not steady; empty if they were, as far as they are known."""
    found: list[Text] = []
    for which, span in (("artefact", artefact), ("arm", arm)):
        if span.is_change_too_large(limits):
            change, most = beside_limit(abs(span.change_c or 0.0), limits.change_c, "°C", 1)
            found.append(
                message("performance-temperature-changed", which=which, change=change, most=most)
            )
        if span.is_too_far(limits):
            found.append(
                message(
                    "performance-temperature-far",
                    which=which,
                    celsius=_celsius_beside(span.farthest_c or 0.0, limits.from_20_c),
                    most=rounded(limits.from_20_c, "°C"),
                )
            )
    return found


def _celsius_beside(celsius: float, most_from_20_c: float) -> Text:
    """A temperature with as many decimals as show on which side of its limits it lies."""
    limits = REFERENCE_C - most_from_20_c, REFERENCE_C + most_from_20_c
    return quantity(celsius, "°C", decimals_beside(celsius, limits, 1))


def is_expansion_known(artefact: Expanding) -> bool:
    """Whether a coefficient is stated; a true zero has an uncertainty."""
    return artefact.expansion_per_c > 0 or artefact.expansion_sd_per_c > 0


def unknown_expansion(artefact: Expanding, name: str, span: TemperatureSpan) -> Text:
    """Why the size of an artefact is not known at its temperature; empty if it is.

    Args:
        name: of the artefact.
        span: its temperatures.
    """
    farthest_c = span.farthest_c
    if is_expansion_known(artefact) or farthest_c is None:
        return ""
    if abs(farthest_c - REFERENCE_C) <= UNKNOWN_FROM_20_C + ROUNDING_C:
        return ""
    return message(
        "performance-expansion-unknown",
        name=name,
        celsius=_celsius_beside(farthest_c, UNKNOWN_FROM_20_C),
        most=rounded(UNKNOWN_FROM_20_C, "°C"),
    )


def unknown_expansions(plan: PerformancePlan, span: TemperatureSpan) -> dict[Quantity, Text]:
    """The quantities that are not decided, as their artefact has no coefficient, each with why.

    Args:
        span: temperatures of the artefact.
    """
    found: dict[Quantity, Text] = {}
    for artefact, quantities in ((plan.sphere, BY_SPHERE), (plan.length, BY_LENGTHS)):
        why = "" if artefact is None else unknown_expansion(artefact, artefact.name, span)
        if why:
            found |= dict.fromkeys(quantities, why)
    return found


def artefact_span(plan: PerformancePlan, end: EndTemperatures) -> TemperatureSpan:
    """The span of the artefact's temperatures."""
    return TemperatureSpan(plan.artefact_c, end.artefact_c)


def arm_span(plan: PerformancePlan, end: EndTemperatures) -> TemperatureSpan:
    """The span of the arm's temperatures."""
    return TemperatureSpan(plan.arm_c, end.arm_c)


def temperatures_part(plan: PerformancePlan, end: EndTemperatures) -> TemperaturesPart | None:
    """The readings and whether they were steady; None if none was taken."""
    artefact, arm = artefact_span(plan, end), arm_span(plan, end)
    known = len(artefact.known_c) + len(arm.known_c)
    if not known:
        return None
    unsteady = bool(find_unsteady(artefact, arm, plan.temperature_limits.limits))
    return TemperaturesPart(
        artefact_c=(artefact.begin_c, artefact.end_c),
        arm_c=(arm.begin_c, arm.end_c),
        artefact_sd_c=plan.temperature_sd_c,
        limits=plan.temperature_limits,
        steady=False if unsteady else True if known == 4 else None,
    )


def temperature_notes(plan: PerformancePlan, end: EndTemperatures, has_size: bool) -> list[Text]:
    """What should be known of the temperatures, one sentence each; what they mean for sizes and
    lengths comes last.

    Args:
        has_size: whether the artefact has a size or a length.
    """
    artefact, arm = artefact_span(plan, end), arm_span(plan, end)
    part, notes = temperatures_part(plan, end), list[Text]()
    if part is not None and part.steady is None:
        notes.append(message("performance-steadiness-unknown"))
    if part is not None and part.steady:
        largest_c = max(abs(span.change_c or 0.0) for span in (artefact, arm))
        change, most = beside_limit(largest_c, plan.temperature_limits.change_c, "°C", 1)
        notes.append(
            message(
                "performance-temperatures-steady",
                change=change,
                most=most,
                off=quantity(plan.temperature_limits.from_20_c, "°C", 1),
            )
        )
    if has_size:
        known = any(one and is_expansion_known(one) for one in (plan.sphere, plan.length))
        notes.append(_correction_note(artefact, corrected=known))
    return notes


def _correction_note(artefact: TemperatureSpan, corrected: bool) -> Text:
    if not artefact.known_c:
        return message("performance-temperature-not-stated")
    low, high = artefact.known_c[0], artefact.known_c[-1]
    celsius: Text = quantity(low, "°C", 1)
    if low != high:
        celsius = message("from-to", low=quantity(low, "", 1), high=quantity(high, "°C", 1))
    if not corrected:
        return message("performance-not-brought-to-20", celsius=celsius)
    return message("performance-brought-to-20", celsius=celsius)
