"""Which error of the station the figures of a one-sphere test show, in words."""

from crenel.gauges.sphere.evaluate_position import PositionResult
from crenel.messages.message import Text, message, quantity

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
