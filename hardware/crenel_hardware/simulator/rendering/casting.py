"""The pixel loops of the room's light (``native/c/casting.c``): a ray for each, many at edges."""

import numpy as np
from numpy.typing import NDArray

from crenel.native.arguments import F32, F64, I32, Array, Function
from crenel_hardware.simulator.devices.kinematics import Floats
from crenel_hardware.simulator.native import SIMULATOR
from crenel_hardware.simulator.rendering.tracing import BUNDLE, OBJECTS

Image = NDArray[np.float32]
Codes = NDArray[np.int32]

LINES = Array(F32, "height", "width", 2)
SPOTS = Array(F64, "spots", 2)
LIGHT = (Array(F64, "things", 3), Array(F64, "places", "things", 16), Array(F64, 5))
"""The way to light from afar in each thing's frame; bundles from places on the lamp, none for
light from afar; directed, ambient, shade, texture, and how far the lamp is from the sensor
frame's origin."""
GRAIN = Array(F32, 256, 256)
CODES = Array(I32, "height", "width", written=True)
LIGHT_OUT = Array(F32, "height", "width", written=True)

cast_room = Function(
    SIMULATOR, "cast_room", LINES, *OBJECTS, BUNDLE, *LIGHT, GRAIN, CODES, LIGHT_OUT
)
refine_room = Function(
    SIMULATOR, "refine_room", LINES, SPOTS, *OBJECTS, BUNDLE, *LIGHT, GRAIN, CODES, LIGHT_OUT
)


def lattice(count: int) -> Floats:
    """(count, 2) places in a pixel, -0.5 to 0.5, evenly spread in every direction.

    A rank-1 lattice of Fibonacci's kind (``count`` 5, 13, 21, 34, 55, 89 ...): projected on
    either axis its points are equidistant, so that a straight edge through the pixel
    is placed to about half of 1/count.
    """
    before = {5: 3, 13: 8, 21: 13, 34: 21, 55: 34, 89: 55, 144: 89}[count]
    i = np.arange(count)
    return np.column_stack([(i + 0.5) / count, ((i * before) % count + 0.5) / count]) - 0.5
