"""Why a touch of a gauge is not taken: it lies where the gauge cannot be."""

from crenel.errors import OperationError
from crenel.messages.message import message, quantity
from crenel.metrology.probing.reachable import off_plane_mm, off_sphere_mm
from crenel.metrology.transforms import Floats


def refuse_off_sphere(before_mm: Floats, tip_mm: Floats, reach_mm: float) -> None:
    """Refuses a new contact that is not on a sphere of known size.

    Args:
        before_mm: (N, 3) tip centres of those before.
        tip_mm: (3,) of the new one.
        reach_mm: radius of the sphere and of the tip together.

    Raises:
        OperationError: it is not on the sphere of those before.
    """
    off_mm = off_sphere_mm(before_mm, tip_mm, reach_mm)
    if off_mm:
        raise OperationError(
            "off-the-sphere",
            message("performance-touch-off-sphere", off=quantity(off_mm, "mm", 1)),
            remedy=message("performance-touch-same-sphere"),
        )


def refuse_off_plane(before_mm: Floats, tip_mm: Floats) -> None:
    """Refuses a new contact that is not on the plane of those before.

    Args:
        before_mm: (N, 3) tip centres of those before.
        tip_mm: (3,) of the new one.

    Raises:
        OperationError: it is not on the plane of those before.
    """
    off_mm = off_plane_mm(before_mm, tip_mm)
    if off_mm:
        raise OperationError(
            "off-the-plane",
            message("touch-off-plane", off=quantity(off_mm, "mm", 1)),
            remedy=message("touch-same-plane"),
        )
