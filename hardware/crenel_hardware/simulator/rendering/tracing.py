"""Rays of one bundle share an origin: the camera's centre, the laser's emitter, a lamp.

Origin and turn into every thing's own frame are worked out once for all of them (``ray_bundle``);
``native/c/tracing.c`` then finds where each first meets a thing.
"""

import numpy as np
from numpy.typing import NDArray

from crenel.native.arguments import F64, I64, Array, Function
from crenel_hardware.simulator.devices.kinematics import Floats
from crenel_hardware.simulator.native import SIMULATOR

Ints = NDArray[np.int64]

OBJECTS = (Array(I64, "things"), Array(F64, "things", 64))
"""Kinds and rows of numbers, as of ``world.shape_rows``."""
BUNDLE = Array(F64, "things", 16)

_first_hits = Function(
    SIMULATOR, "first_hits", *OBJECTS, BUNDLE, Array(F64, "n", 3), Array(F64, "n", written=True)
)


def ray_bundle(into: Floats, rows: Floats, origin: Floats) -> Floats:
    """(K, 16): all that a ray caster needs to know of the rays from one origin.

    Args:
        into: (K, 4, 4) from the rays' frame into each thing's.
        rows: (K, 64) of the things.
        origin: (3,) where the rays start, in their frame.

    Returns:
        Per thing its turn (0-8), the origin in its frame (9-11), its bounding
        sphere's centre from the origin in the rays' frame (12-14), and that
        centre's distance squared less the radius squared (15).
    """
    found = np.empty((len(rows), 16))
    for k, T in enumerate(into):
        start = T[:3, :3] @ origin + T[:3, 3]
        centre = T[:3, :3].T @ (rows[k, :3] - start)
        found[k, :9], found[k, 9:12], found[k, 12:15] = T[:3, :3].ravel(), start, centre
        found[k, 15] = centre @ centre - rows[k, 3] ** 2
    return found


def first_hits(kinds: Ints, rows: Floats, rays: Floats, directions: Floats) -> Floats:
    """(N,) how far along each of ``directions`` (N, 3) the first thing is, in their lengths.

    1e30 where there is none. ``rays``: the ``ray_bundle`` that they are of.
    """
    found = np.empty(len(directions))
    _first_hits(kinds, rows, rays, np.ascontiguousarray(directions), found)
    return found
