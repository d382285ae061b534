"""What one position of the sphere gave in the one-sphere test, and its test value uncertainty."""

from collections.abc import Mapping, Sequence
from dataclasses import dataclass, field

import numpy as np

from crenel.gauges.judgement.document import SphereMeasurement
from crenel.gauges.judgement.maths_value_uncertainty import (
    SphereCertificate,
    form_of_both_uncertainty_um,
    form_uncertainty_um,
    location_uncertainty_um,
    size_uncertainty_um,
)
from crenel.gauges.plan.document import SpherePart
from crenel.gauges.plan.document_symbols import Quantity
from crenel.messages.message import Text, message, quantity
from crenel.metrology.transforms import Floats


@dataclass
class PositionResult:
    """What one position of the sphere gave."""

    position: int
    values_mm: dict[Quantity, float] = field(default_factory=dict)
    problems: dict[Quantity, Text] = field(default_factory=dict)
    data: dict[Quantity, tuple[str, ...]] = field(default_factory=dict)
    details: dict[str, object] = field(default_factory=dict)
    """Fields of ``SphereMeasurement``."""
    centres_mm: Floats | None = None
    """(A, 3) of the articulations by scan."""
    R_arm_sensor: Floats | None = None
    """(A, 3, 3) of the sensor in them."""
    touch_sd_mm: float = 0.0
    """Standard deviation of a touch about the sphere of the 25; 0 without these."""
    outlier_share: float = 0.0
    """The share of outliers among the points of the scans."""
    tactile_sd_mm: float = 0.0
    """Standard deviation along an axis of the centres by touch in the articulations."""
    notes: list[Text] = field(default_factory=list)
    """Articulations that were not held as wanted."""
    form_effects_um: dict[Quantity, float] = field(default_factory=dict)
    """What the form of the sphere makes of forms and dispersion, k = 1."""
    moved_mm: Floats = field(default_factory=lambda: np.zeros(3))
    """(3,) of the sphere, between the first touches and the last; 0 if not touched again."""

    @property
    def moved_um(self) -> float:
        return 1e3 * float(np.linalg.norm(self.moved_mm))

    def measurement(self, stated: bool) -> SphereMeasurement:
        """What is kept of it.

        Args:
            stated: whether the sphere could serve. What has the meaning of a figure is left out
                where that figure is not stated.
        """
        second: dict[str, Quantity] = {
            "location_fixed_um": "location-scan",
            "free_dispersion_um": "dispersion-scan",
        }
        unstated = [of for of, figure in second.items() if figure not in self.values_mm]
        left_out = unstated if stated else list(second)
        details = {name: value for name, value in self.details.items() if name not in left_out}
        return SphereMeasurement.model_validate({"position": self.position, **details})

    def note(self, quantity: Quantity, value_mm: float, *data: str) -> None:
        self.values_mm[quantity], self.data[quantity] = value_mm, data

    def refuse(self, problem: Text, *quantities: Quantity) -> None:
        for one in quantities:
            self.problems.setdefault(one, problem)


def bring_sizes_to_20(result: PositionResult, sphere: SpherePart, off_c: float) -> None:
    """Errors of size with the sphere at 20 °C.

    Args:
        off_c: its temperature in the test minus 20 °C.
    """
    growth = 1 + sphere.expansion_per_c * off_c
    for of, error_mm in result.values_mm.items():
        if of.startswith("size"):
            at_20_mm = (error_mm + sphere.diameter_mm) / growth
            result.values_mm[of] = at_20_mm - sphere.diameter_mm


def worst(results: Sequence[PositionResult], of: Quantity) -> float | None:
    """The value of larger magnitude in µm; None unless every position has one."""
    values = [result.values_mm.get(of) for result in results]
    known = [value for value in values if value is not None]
    return 1e3 * max(known, key=abs) if len(known) == len(values) and known else None


def largest_form_effect(results: Sequence[PositionResult], of: Quantity) -> float | None:
    """What the sphere's form makes of a quantity in µm, k = 1; None if that is unknown."""
    return max(
        (one.form_effects_um[of] for one in results if of in one.form_effects_um), default=None
    )


def problems_of(results: Sequence[PositionResult], of: Quantity) -> Text:
    """Why a quantity cannot be stated; empty if it can."""
    found: Mapping[int, Text] = {
        one.position: one.problems[of] for one in results if of in one.problems
    }
    if not found:
        return ""
    position, text = next(iter(found.items()))
    return text if len(results) == 1 else message("at-position", position=position, text=text)


def sphere_certificate(sphere: SpherePart) -> SphereCertificate:
    """What the certificate of a plan's sphere says."""
    return SphereCertificate(
        sphere.diameter_mm,
        sphere.diameter_sd_um,
        sphere.form_um,
        sphere.form_sd_um,
        sphere.expansion_per_c,
        sphere.expansion_sd_per_c,
    )


def sphere_uncertainty_um(
    of: Quantity,
    sphere: SphereCertificate,
    moved_um: float,
    form_effect_um: float | None = None,
    temperature_sd_c: float = 0.0,
    off_c: float = 0.0,
) -> float:
    """Test value uncertainty of a quantity of the one-sphere test, k = 1.

    Args:
        moved_um: of the sphere, between the first touches and the last.
        form_effect_um: what its form makes of this form or dispersion; None if that is unknown,
            which makes it the half form of ISO/TS 23165.
        off_c: temperature of the sphere minus 20 °C.
    """
    if of.startswith("size"):
        return size_uncertainty_um(sphere, temperature_sd_c, off_c)
    if of == "location-touch":
        return location_uncertainty_um(sphere, moved_um, "touch")
    if of == "location-scan":
        return location_uncertainty_um(sphere, moved_um, "scan")
    if of == "location-both":
        return location_uncertainty_um(sphere, moved_um, "both")
    if of == "form-both":
        return form_of_both_uncertainty_um(sphere, moved_um)
    return form_uncertainty_um(sphere) if form_effect_um is None else form_effect_um


SIZE_BY_TOUCH = 0.66
"""Standard deviation of the diameter by 25 touches, for one of a touch of 1."""
LOCATION_BY_TOUCH = 3.2
"""Mean diameter of the sphere that holds the centres by five touches each, for the same."""
CERTAIN = 4.0
"""Standard deviations beyond which a size is not by chance."""
CERTAIN_LOCATION = 2.0
"""Times its mean beyond which a location error is not by chance."""
OUTLIERS = 0.01


def name_causes(result: PositionResult, size_uncertainty_um: float) -> list[Text]:
    """What is wrong with the station, as far as one position of a sphere tells it apart.

    Args:
        size_uncertainty_um: of the sphere's diameter, k = 1.

    Source:
        docs/performance.md, "Which error shows where": links move the centres by touch, a tip
        changes the size alone. Errors of the probe matrix are ``estimate_offset``'s.
    """
    causes: list[Text] = []
    expected_mm = LOCATION_BY_TOUCH * result.touch_sd_mm
    apart_mm = result.values_mm.get("location-touch", 0.0)
    arm_errs = result.touch_sd_mm > 0 and apart_mm > CERTAIN_LOCATION * expected_mm
    if arm_errs:
        apart, usual = (quantity(1e3 * one, "µm") for one in (apart_mm, expected_mm))
        causes.append(message("performance-cause-arm", apart=apart, usual=usual))
    size_um = 1e3 * result.values_mm.get("size-touch", 0.0)
    by_chance_um = CERTAIN * (1e3 * SIZE_BY_TOUCH * result.touch_sd_mm + size_uncertainty_um)
    tip_errs = abs(size_um) > by_chance_um
    if tip_errs and not arm_errs:
        causes.append(message("performance-cause-tip", **_size(size_um)))
    if result.outlier_share > OUTLIERS:
        share = quantity(100 * result.outlier_share, "%", 1)
        causes.append(message("performance-cause-outliers", share=share))
    return causes


def _size(error_um: float) -> dict[str, Text]:
    return {"size": quantity(abs(error_um), "µm"), "way": "large" if error_um > 0 else "small"}
