"""What the detector adds: shot and read noise, speckle, and the limits of its numbers."""

from dataclasses import dataclass
from functools import lru_cache
from typing import Any

import cv2
import numpy as np
from numpy.typing import NDArray

from crenel.native.arguments import F32, I64, U8, U16, Array, Function, Integer, Real
from crenel_hardware.simulator.native import SIMULATOR
from crenel_hardware.simulator.rendering.casting import Image

RawImage = NDArray[np.uint8] | NDArray[np.uint16]

POOL = 1 << 21
TILE = 512
GRAIN = 256


@dataclass(frozen=True)
class Detector:
    """Brightness in 8-bit digits at the exposure ``nominal_exposure_us``, and its noise."""

    crest_dn: float = 120.0
    """A white face square to the room's light, above the dark level."""
    stripe_dn: float = 190.0
    """The stripe's peak on a white face square to the laser."""
    haze_dn: float = 20.0
    """Even veil of the room's light."""
    dark_dn: float = 6.0
    read_dn: float = 1.5
    shot_dn: float = 0.045
    """Variance of the shot noise per digit of signal; 0 for none."""
    blur_px: float = 0.7
    """Sigma of the lens' point spread."""
    speckle_contrast: float = 0.17
    speckle_px: float = 0.9
    """Sigma of the field filter that makes the grains; they are about twice as wide."""
    bits: int = 8
    nominal_exposure_us: float = 5000.0


def empty_image(height: int, width: int, detector: Detector) -> RawImage:
    """An image to be filled, of the detector's kind of digits."""
    if detector.bits <= 8:
        return np.zeros((height, width), dtype=np.uint8)
    return np.zeros((height, width), dtype=np.uint16)


def speckle_tile(detector: Detector, seed: int) -> Image:
    """(512, 512) of mean 1, seamless, not to be written to: intensities of summed independent
    speckle fields."""
    if detector.speckle_contrast <= 0:
        return np.ones((TILE, TILE), dtype=np.float32)
    looks = max(1, round(1 / detector.speckle_contrast**2))
    return _sum_speckle_fields(looks, detector.speckle_px, seed)


@lru_cache(maxsize=4)
def _sum_speckle_fields(looks: int, sigma_px: float, seed: int) -> Image:
    rng = np.random.default_rng(seed)
    reach = int(np.ceil(4 * sigma_px))
    size = (2 * reach + 1, 2 * reach + 1)
    inside = slice(reach, reach + TILE)
    field = np.empty((TILE, TILE, 2), dtype=np.float32)  # real, imaginary
    squares = np.zeros_like(field)
    for _ in range(looks):
        rng.standard_normal(dtype=np.float32, out=field)
        wide = cv2.copyMakeBorder(field, reach, reach, reach, reach, cv2.BORDER_WRAP)
        cv2.accumulateSquare(cv2.GaussianBlur(wide, size, sigma_px)[inside, inside], squares)
    tile: Image = squares.sum(axis=2)
    tile /= tile.mean()
    tile.flags.writeable = False  # it is shared
    return tile


def grain_tile(rng: np.random.Generator) -> Image:
    """(256, 256) of mean 0 and sd 1, seamless and smooth: a surface's weak texture."""
    frequency = np.fft.fftfreq(GRAIN)
    radius2 = frequency[:, None] ** 2 + frequency[None] ** 2
    low_pass = np.exp(-2 * (np.pi * 2.0) ** 2 * radius2)
    tile = np.real(np.fft.ifft2(np.fft.fft2(rng.normal(size=(GRAIN, GRAIN))) * low_pass))
    return np.asarray((tile - tile.mean()) / tile.std(), dtype=np.float32)


LIGHT = Array(F32, "height", "width")
speckle = Function(
    SIMULATOR,
    "speckle",
    Array(F32, "height", "width", written=True),
    Array(F32, TILE, TILE),
    Integer(),
    Integer(),
)
"""Multiplies the laser's light by the speckle, shifted by rows and columns, in place."""


def _digitise_function(name: str, digits: np.dtype[Any]) -> Function:
    """Digitises the light with the pool, where each row begins in it, ``Detector`` numbers, and
    digits."""
    pool, offsets, numbers = Array(F32, "pool"), Array(I64, "height"), [Real()] * 7
    out = Array(digits, "height", "width", written=True)
    return Function(SIMULATOR, name, LIGHT, pool, offsets, *numbers, out)


_DIGITISE = {
    digits: _digitise_function(f"digitise_{8 * digits.itemsize}", digits) for digits in (U8, U16)
}


def digitise(
    light: Image,
    gain: float,
    haze: float,
    detector: Detector,
    pool: Image,
    offsets: NDArray[np.int64],
    out: RawImage,
) -> None:
    """Digits of a frame from its light, with noise; saturates.

    Args:
        light: (H, W).
        gain: 8-bit digits per unit of light.
        haze: even light that is added, in 8-bit digits.
        pool: of normal deviates.
        offsets: (H,) where each row's begin in the pool.
        out: (H, W) filled.
    """
    d, scale = detector, 2.0 ** (detector.bits - 8)
    numbers = (gain, d.dark_dn, haze, d.read_dn, d.shot_dn, 256.0 - 1.0 / scale, scale)
    _DIGITISE[out.dtype](light, pool, offsets, *numbers, out)
