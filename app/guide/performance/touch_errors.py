"""Why a touch on a sphere or a length standard is not taken."""

from app.errors import OperationError
from app.messages.message import message, quantity


def same_place_error() -> OperationError:
    """The sphere was touched near there already."""
    return OperationError(
        "same-place",
        message("performance-sphere-touched-there"),
        remedy=message("performance-touch-sphere-elsewhere"),
    )


def another_length_error(found_mm: float, wanted_mm: float) -> OperationError:
    """The touch would make another length than that of the standard."""
    return OperationError(
        "another-length",
        message(
            "performance-another-length",
            found=quantity(found_mm, "mm"),
            wanted=quantity(wanted_mm, "mm"),
        ),
        remedy=message("performance-touch-ends-of-length"),
    )
