"""Why a touch on a sphere or a length standard is not taken."""

from crenel.errors import OperationError
from crenel.messages.limits import beside_limit
from crenel.messages.message import message


def same_place_error() -> OperationError:
    """The sphere was touched near there already."""
    return OperationError(
        "same-place",
        message("performance-sphere-touch-not-taken"),
        remedy=message("performance-touch-sphere-elsewhere"),
    )


def another_length_error(found_mm: float, wanted_mm: float) -> OperationError:
    """The touch would make another length than that of the standard."""
    found, wanted = beside_limit(found_mm, wanted_mm, "mm")
    return OperationError(
        "another-length",
        message("performance-another-length-not-taken", found=found, wanted=wanted),
        remedy=message("performance-touch-ends-of-length"),
    )
