"""Colours of the cloud: by height, brighter where more of the laser's light came back."""

import numpy as np
from numpy.typing import NDArray

from app.metrology.frames import Floats

Bytes = NDArray[np.uint8]

# Deep blue over teal and green to sand: told apart on light and dark ground, and by
# those who do not tell red from green.
_STOPS = np.array(
    [[44, 74, 158], [38, 132, 190], [52, 178, 168], [150, 205, 118], [240, 196, 88]], dtype=float
)
_AT = np.linspace(0.0, 1.0, len(_STOPS))
_RAMP = np.column_stack(
    [np.interp(np.linspace(0, 1, 256), _AT, _STOPS[:, channel]) for channel in range(3)]
)
_DARKEST, _BRIGHTEST = 0.62, 1.12


def shades(intensity: Floats) -> Bytes:
    """Brightness (N,) of points against the median of their own batch, 128 for that median."""
    if not len(intensity):
        return np.zeros(0, dtype=np.uint8)
    typical = max(float(np.median(intensity)), 1e-9)
    return np.asarray(np.clip(128 * intensity / typical, 0, 255).astype(np.uint8))


def colours(height: Floats, lowest: float, highest: float, shade: Bytes) -> Bytes:
    """Colours (N, 3) of points by height between two limits, times their shade."""
    span = max(highest - lowest, 1e-9)
    step = np.clip((height - lowest) / span * 255, 0, 255).astype(np.uint8)
    light = _DARKEST + (_BRIGHTEST - _DARKEST) * np.minimum(shade / 160.0, 1.0)
    return np.asarray(np.clip(_RAMP[step] * light[:, None], 0, 255).astype(np.uint8))
