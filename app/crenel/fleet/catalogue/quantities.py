"""What the quantities of the catalogue are called, in words."""

from crenel.findings import capital
from crenel.gauges.plan.document_symbols import TITLES
from crenel.gauges.quick.document import FIGURE_TITLES
from crenel.messages.message import Text, message

CALIBRATION_TITLES: dict[str, Text] = {
    "laser-plane-offset": message("fleet-laser-plane-offset"),
    "focal-length-u": message("fleet-focal-length-u"),
    "focal-length-v": message("fleet-focal-length-v"),
    "probe-x": message("fleet-probe-translation", axis="X"),
    "probe-y": message("fleet-probe-translation", axis="Y"),
    "probe-z": message("fleet-probe-translation", axis="Z"),
    "point-uncertainty": message("fleet-point-uncertainty"),
    "reprojection-rms": message("fleet-reprojection-rms"),
    "laser-plane-rms": message("fleet-laser-plane-rms"),
    "contacts-rms": message("fleet-contacts-rms"),
}
"""Titles of the figures of a calibration."""
CHECK_TITLES: dict[str, Text] = {
    "arm-half-range": message("fleet-arm-half-range"),
    "arm-two-sigma": message("fleet-arm-two-sigma"),
    "arm-largest": message("fleet-arm-largest"),
    "tip-diameter-error": message("fleet-tip-diameter-error"),
    "tip-scatter": message("fleet-tip-scatter"),
}
QUANTITY_TITLES: dict[str, Text] = {
    **CALIBRATION_TITLES,
    **CHECK_TITLES,
    **{
        f"gauge-{name.replace('_', '-')}": message("fleet-of-gauge", title=title)
        for name, title in FIGURE_TITLES.items()
    },
    **{quantity: capital(title) for quantity, title in TITLES.items()},
}


def title_of(quantity: str) -> Text:
    """The words of a quantity; one of a later version of the program is called by its id.

    Example:
        >>> str(title_of("probe-x"))
        'Probe matrix, translation along X'
    """
    return QUANTITY_TITLES.get(quantity, quantity)
