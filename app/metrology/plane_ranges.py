"""How far one plane turns and shifts from one measurement of it to another (paper, Fig. 7-10)."""

import numpy as np

from app.metrology.frames import Floats
from app.metrology.gauges import ARCSEC_PER_RAD


def angle_ranges_arcsec(normals: Floats) -> Floats:
    """The largest angle (K,) between any two of the C normals (C, K, 3), of one sense."""
    apart = np.linalg.norm(normals[:, None] - normals[None], axis=3)
    return np.asarray(2 * np.arcsin((apart / 2).clip(0, 1)).max(axis=(0, 1)) * ARCSEC_PER_RAD)


def offset_ranges_um(offsets_mm: Floats) -> Floats:
    """Largest minus smallest (K,) of the C offsets (C, K)."""
    return np.asarray(1e3 * np.ptp(offsets_mm, axis=0))
