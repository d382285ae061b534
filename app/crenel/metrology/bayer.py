"""Raw pictures of colour cameras: the pixels under the filter of one colour, without interpolation.

A picture interpolated to full size invents three of four red pixels from their neighbours: its
line is smeared and its noise correlated. The pixels of one colour by themselves are a picture
of half the size, and what is measured in it is brought back to the pixels of the raw one.
"""

from dataclasses import dataclass, replace
from typing import Literal, cast, get_args

import numpy as np
from numpy.typing import NDArray

from crenel.metrology.colour import LaserColour
from crenel.metrology.image import Image
from crenel.metrology.sensor.camera import Camera
from crenel.metrology.stripe import Stripe, StripeSettings
from crenel.metrology.transforms import Floats

BayerPattern = Literal["RGGB", "BGGR", "GRBG", "GBRG"]
"""The colours of a picture's first two pixels, and of the two below them."""
BAYER_PATTERNS: tuple[BayerPattern, ...] = get_args(BayerPattern)
CELL_PX = 2


@dataclass(frozen=True)
class BayerPlane:
    """The pixels of one colour in a raw picture.

    Of green, the mean of the two in each cell of 2 × 2 pixels, which lies in the cell's centre.

    Example:
        >>> BayerPlane("GRBG", "red").offset_px
        (1.0, 0.0)
        >>> BayerPlane("GRBG", "green").offset_px
        (0.5, 0.5)
    """

    pattern: BayerPattern
    colour: LaserColour

    @property
    def places(self) -> tuple[tuple[int, int], ...]:
        """Column and row within the cell of each pixel of the colour."""
        letter = self.colour[0].upper()
        return tuple(
            (at % CELL_PX, at // CELL_PX)
            for at in range(len(self.pattern))
            if self.pattern[at] == letter
        )

    @property
    def offset_px(self) -> tuple[float, float]:
        """Where the plane's first pixel lies in the raw picture (u, v)."""
        u, v = np.mean(self.places, axis=0)
        return float(u), float(v)

    def select(self, raw: Image) -> Image:
        """The plane (H // 2, W // 2) of a raw picture (H, W), of the same type.

        Where one of two green pixels is as bright as any, and so perhaps clipped, the mean is
        as bright.
        """
        height, width = (size // CELL_PX * CELL_PX for size in raw.shape)
        parts = [raw[v:height:CELL_PX, u:width:CELL_PX] for u, v in self.places]
        if len(parts) == 1:
            return cast(Image, np.ascontiguousarray(parts[0]))
        mean = (parts[0].astype(np.uint32) + parts[1] + 1) // 2
        brighter = np.maximum(*parts)
        return cast(Image, np.where(brighter == brighter.max(), brighter, mean).astype(raw.dtype))

    def select_mask(self, where: NDArray[np.bool_]) -> NDArray[np.bool_]:
        """The mask (H // 2, W // 2) of the plane: where all its pixels are allowed."""
        height, width = (size // CELL_PX * CELL_PX for size in where.shape)
        parts = [where[v:height:CELL_PX, u:width:CELL_PX] for u, v in self.places]
        return np.asarray(np.logical_and.reduce(parts))

    def select_settings(self, settings: StripeSettings) -> StripeSettings:
        """Settings whose widths and smoothing are in the plane's pixels."""
        least, most = (
            None if width_px is None else width_px / CELL_PX
            for width_px in (settings.min_width_px, settings.max_width_px)
        )
        return replace(
            settings,
            min_width_px=least,
            max_width_px=most,
            smoothing_px=settings.smoothing_px / CELL_PX,
        )

    def raw_px(self, uv_px: Floats) -> Floats:
        """(N, 2) pixels of the raw picture, of those of the plane."""
        return np.asarray(CELL_PX * uv_px + np.array(self.offset_px))

    def raw_stripe(self, stripe: Stripe) -> Stripe:
        """A stripe in pixels of the raw picture."""
        u, v = self.raw_px(stripe.uv_px).T
        return replace(stripe, u=u, v=v, sigma_px=CELL_PX * stripe.sigma_px)

    def raw_camera(self, camera: Camera, width_px: int, height_px: int) -> Camera:
        """A camera of the raw picture, of one that took the plane."""
        to_raw = np.diag([CELL_PX, CELL_PX, 1.0])
        to_raw[:2, 2] = self.offset_px
        matrix = to_raw @ camera.matrix
        return replace(camera, matrix=matrix, width_px=width_px, height_px=height_px)
