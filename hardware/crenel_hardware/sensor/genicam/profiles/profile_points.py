"""The points of the laser line in one profile: the row that a camera states for each column.

Source:
    EMVA, GenICam Standard Features Naming Convention (SFNC) 2.7, chapter 3D Scan Control; Pixel
    Format Naming Convention (PFNC) 2.4 with its list of 32-bit values.
"""

from collections.abc import Sequence
from dataclasses import dataclass
from typing import NamedTuple

import numpy as np
from numpy.typing import NDArray

from crenel_hardware.sensor.genicam.pixel_formats import Bytes
from crenel_hardware.sensor.image_source import LinePoints

COORDINATES: dict[str, tuple[int, str]] = {
    "Coord3D_C16": (0x011000B8, "<u2"),
    "Coord3D_C32f": (0x012000BF, "<f4"),
    "Coord3D_C8": (0x010800B1, "<u1"),
}
"""The pixel formats of rows, the preferred one first: their values in PFNC, their numbers."""
COORDINATE_CODES = frozenset(code for code, _ in COORDINATES.values())
_NUMBERS = dict(COORDINATES.values())
_BRIGHTNESS: dict[int, str] = {
    0x01080001: "<u1",
    0x01100003: "<u2",
    0x01100005: "<u2",
    0x01100007: "<u2",
}
"""The pixel formats of brightness: Mono8, Mono10, Mono12, Mono16."""

INTENSITY = 128.0
"""The intensity of each point, in grey levels, if the camera sends no brightness: neither dark nor
clipped, and the same everywhere, so that nobody takes it for a measured one."""
UNKNOWN_SIGMA_PX = 0.5
"""The deviation of profiles with too few points to measure their scatter."""
FLOAT_SIGMA_PX = 0.01
"""The least of rows that are floats, whose steps are not known."""
_FEWEST_DIFFERENCES = 30
_APART = 4
"""Columns between those that are compared: speckle moves adjacent columns together."""
_THIRD_DIFFERENCE = np.sqrt(1 + 9 + 9 + 1)
"""Its standard deviation, in that of independent rows."""
_SMALLER_HALF = 0.3247
"""The mean of the smaller half of the sizes of normal deviates, in standard deviations. Unlike the
median, it is not bound to the steps of the camera."""


@dataclass(frozen=True, slots=True)
class ProfileFormat:
    """What the numbers of a profile mean: row = number × scale + offset, in the picture."""

    scale_px: float
    offset_px: float
    invalid: float | None
    """The number of a column without a point; None if the camera marks none."""
    size_px: tuple[int, int]
    """Width and height of the picture."""
    sigma_px: float | None
    """Standard deviation of a row, if it is known."""


@dataclass(frozen=True, slots=True)
class Brightness:
    """The brightness of the line in each column, as it arrived with the rows."""

    data: Bytes
    code: int
    """The value of its pixel format in PFNC."""


class ArrivedImage(NamedTuple):
    """One image of a buffer; its bytes need to be valid only until the next one."""

    data: Bytes
    code: int
    """The value of its pixel format in PFNC."""
    width_px: int
    height_px: int
    padding: int
    """Bytes after each line."""


NO_IMAGE = ArrivedImage(np.empty(0, np.uint8), 0, 0, 0, 0)
"""In place of the image of an incomplete buffer."""


def choose_image(images: Sequence[ArrivedImage]) -> tuple[ArrivedImage, Brightness | None]:
    """Chooses among the images of a buffer the rows, and the brightness beside them; or the first
    one."""
    for image in images:
        if image.code in COORDINATE_CODES:
            beside = [one for one in images if one.code in _BRIGHTNESS]
            return image, Brightness(beside[0].data, beside[0].code) if beside else None
    return images[0], None


def line_points(
    data: Bytes, code: int, profile: ProfileFormat, brightness: Brightness | None = None
) -> LinePoints | None:
    """The points of one profile.

    Columns whose number is the invalid one, no number, or a row outside the picture have no point.

    Args:
        data: (n,) bytes of the rows, one for each column of the picture.
        code: the value of their pixel format in PFNC, one of ``COORDINATE_CODES``.

    Returns:
        None if there are too few bytes.
    """
    kind = np.dtype(_NUMBERS[code])
    width_px, height_px = profile.size_px
    if data.size < width_px * kind.itemsize:
        return None
    numbers = data[: width_px * kind.itemsize].view(kind).astype(np.float64)
    rows = numbers * profile.scale_px + profile.offset_px
    with np.errstate(invalid="ignore"):
        valid = (rows >= -0.5) & (rows < height_px - 0.5)
    if profile.invalid is not None:
        valid &= numbers != profile.invalid
    u, v = np.flatnonzero(valid).astype(np.float64), rows[valid]
    sigma_px = profile.sigma_px
    if sigma_px is None:
        step_px = 0.0 if kind.kind == "f" else abs(profile.scale_px)
        sigma_px = estimate_sigma_px(u, v, step_px)
    intensity = _intensity(brightness, width_px)[valid]
    return LinePoints(u, v, intensity, np.full(len(u), sigma_px), profile.size_px)


def estimate_sigma_px(u: NDArray[np.float64], v: NDArray[np.float64], step_px: float) -> float:
    """Standard deviation of the rows of one profile, from their scatter along the profile.

    The scatter is that of third differences between columns 4 px apart: a line that is smooth over
    12 px counts with its noise alone. Edges and columns without sense do not matter as long as they
    are fewer than half. What more than 4 columns have in common is not seen, such as coarse speckle
    or a smoothing in the camera: then the deviation is larger than this.

    Args:
        u, v: (N,) columns in their order, and rows.
        step_px: between adjacent numbers of the camera; 0 of floats.

    Returns:
        No less than the deviation by rounding to steps; ``UNKNOWN_SIGMA_PX`` if too few columns
        stand side by side.
    """
    reach = 3 * _APART
    if len(v) < reach + _FEWEST_DIFFERENCES:
        return UNKNOWN_SIGMA_PX
    first, second, third, fourth = (v[k * _APART : len(v) - reach + k * _APART] for k in range(4))
    differences = fourth - 3 * third + 3 * second - first
    sizes = np.sort(np.abs(differences[u[reach:] - u[:-reach] == reach]))
    if len(sizes) < _FEWEST_DIFFERENCES:
        return UNKNOWN_SIGMA_PX
    scatter_px = float(sizes[: len(sizes) // 2].mean() / _SMALLER_HALF / _THIRD_DIFFERENCE)
    least_px = step_px / float(np.sqrt(12)) if step_px else FLOAT_SIGMA_PX
    return max(scatter_px, least_px)


def _intensity(brightness: Brightness | None, width_px: int) -> NDArray[np.float64]:
    """(width,) grey levels; ``INTENSITY`` if they did not arrive in a format that is understood."""
    kind = None if brightness is None else _BRIGHTNESS.get(brightness.code)
    if brightness is not None and kind is not None:
        size = width_px * np.dtype(kind).itemsize
        if brightness.data.size >= size:
            return brightness.data[:size].view(kind).astype(np.float64)
    return np.full(width_px, INTENSITY)
