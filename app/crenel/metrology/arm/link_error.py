"""Error transforms of links (Eq. 3), as six terms and as matrices."""

from dataclasses import dataclass

import numpy as np

from crenel.metrology.transforms import Floats


@dataclass(frozen=True)
class LinkError:
    """Error transform after a link, ``E = T(x, y, z) Rz(rz) Ry(ry) Rx(rx)`` (Eq. 3)."""

    x_mm: float = 0.0
    y_mm: float = 0.0
    z_mm: float = 0.0
    rx_rad: float = 0.0
    ry_rad: float = 0.0
    rz_rad: float = 0.0


def error_transform(error: LinkError) -> Floats:
    """``E = T(x, y, z) Rz Ry Rx``, the error transform after a link.

    Args:
        error: translations in mm, rotations in rad.

    Returns:
        (4, 4).

    Source:
        Eq. 3 of the article.
    """
    cx, sx = np.cos(error.rx_rad), np.sin(error.rx_rad)
    cy, sy = np.cos(error.ry_rad), np.sin(error.ry_rad)
    cz, sz = np.cos(error.rz_rad), np.sin(error.rz_rad)
    return np.array(
        [
            [cz * cy, cz * sy * sx - sz * cx, cz * sy * cx + sz * sx, error.x_mm],
            [sz * cy, sz * sy * sx + cz * cx, sz * sy * cx - cz * sx, error.y_mm],
            [-sy, cy * sx, cy * cx, error.z_mm],
            [0.0, 0.0, 0.0, 1.0],
        ]
    )


def error_from_transform(T: Floats) -> LinkError:
    """The error terms of a transform; inverse of ``error_transform``.

    Args:
        T: (4, 4). With ry at a right angle, rz is 0 and rx holds the whole rotation.
    """
    x, y, z = (float(v) for v in T[:3, 3])
    ry = float(np.arctan2(-T[2, 0], np.hypot(T[0, 0], T[1, 0])))
    if np.hypot(T[0, 0], T[1, 0]) < 1e-9:
        return LinkError(x, y, z, float(np.arctan2(T[0, 1] * np.sign(ry), T[1, 1])), ry, 0.0)
    rx, rz = float(np.arctan2(T[2, 1], T[2, 2])), float(np.arctan2(T[1, 0], T[0, 0]))
    return LinkError(x, y, z, rx, ry, rz)
