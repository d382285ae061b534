"""The pixel loops of the laser's light (``native/c/striping.c``), in the order of their use."""

from crenel.native.arguments import F32, F64, I32, Array, Function
from crenel_hardware.simulator.native import SIMULATOR
from crenel_hardware.simulator.rendering.casting import CODES, LIGHT_OUT
from crenel_hardware.simulator.rendering.tracing import BUNDLE, OBJECTS

EMITTER, LIGHT_PLANE = Array(F64, 3), Array(F64, 5)
"""In the camera's frame; of the light plane its normal, offset and half thickness."""

trace_fan = Function(
    SIMULATOR,
    "trace_fan",
    Array(F64, "angles"),
    Array(F64, 2, 3),
    EMITTER,
    LIGHT_PLANE,
    Array(F64, 9),
    *OBJECTS,
    BUNDLE,
    Array(F64, "most", 5, written=True),
    returns=int,
)
band_around = Function(
    SIMULATOR,
    "band_around",
    Array(F64, "rays", 5),
    CODES,
    Array(I32, "height", "width", written=True),
    returns=int,
)
cast_laser = Function(
    SIMULATOR,
    "cast_laser",
    Array(F32, "line_height", "line_width", 2),
    Array(I32, "pixels"),
    Array(F64, "many", 2),
    Array(F64, "few", 2),
    EMITTER,
    LIGHT_PLANE,
    *OBJECTS,
    BUNDLE,
    BUNDLE,
    CODES,
    LIGHT_OUT,
    LIGHT_OUT,
)
