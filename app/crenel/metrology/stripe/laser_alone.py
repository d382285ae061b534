"""The laser's light alone, from two pictures of one place in a lit room: with it and without."""

from dataclasses import dataclass, replace

import cv2
import numpy as np
from numpy.typing import NDArray

from crenel.metrology.image import Image, saturation_level
from crenel.metrology.robust import median, sigma_from_median
from crenel.metrology.stripe.points import Stripe
from crenel.metrology.stripe.settings import StripeSettings
from crenel.metrology.transforms import Floats

ROOM = 0.1
"""A room counts as lit if its brightest hundredth has this share of the brightest pixel of the
line; a pixel shows its light with the same share of that."""
UNCLIPPED = 0.95
"""Of full scale."""
LEAST_SHOWN = 0.05
"""The share of pixels that must show the room's light, or there is none to take off."""
ALIKE = (0.8, 1.25)
"""The room is as bright in both pictures but for this factor, such as by lamps that flicker; with
another exposure, or with the lamps off, the picture with the laser stands for itself."""
LASER_SDS = 6.0
"""From so many standard deviations on, a difference is taken for the laser's light."""
BLOCK_PX = 48
SHIFT_PX, SHIFT_SD_PX, MOST_SHIFTED = 0.12, 0.03, 0.15
"""Something moved if more than this share of the blocks that would show a shift is shifted. Of
pictures at rest it is 0.02 at most, and 0.13 as JPEG of quality 60; a shift of all by 0.1 px in
both directions leaves 0.26, one of a quarter of the picture by 1 px 0.17."""
MARGIN_SDS = 12.0
"""Darkness, in standard deviations of the difference, that its lowest level stands for."""
STEPS_PER_LEVEL, HIGHEST = 64.0, 60_000.0


@dataclass(frozen=True)
class LaserAlone:
    """The picture in which the line is looked for.

    ``image`` (H, W): the laser's light on a dark ground, in ``steps_per_level`` for one grey level,
    or the picture with the laser as it is. ``shifted``: the share of the blocks of the picture that
    show another place than without the laser, where they are so many that the two pictures were not
    subtracted.
    """

    image: Image
    is_difference: bool = False
    steps_per_level: float = 1.0
    shifted: float = 0.0

    def in_steps(self, settings: StripeSettings) -> StripeSettings:
        """Settings in grey levels of the picture, in the steps of ``image``."""
        if settings.threshold is None:
            return settings
        return replace(settings, threshold=settings.threshold * self.steps_per_level)

    def in_levels(self, stripe: Stripe) -> Stripe:
        """A stripe of ``image`` with its heights in grey levels of the picture."""
        return replace(stripe, intensity=stripe.intensity / self.steps_per_level)


def picture_with_line(ambient: Image, laser: Image | None) -> LaserAlone:
    """The picture of a pose in which the line is looked for: that with both lights, where ``laser``
    is None, or as ``take_off_room_light`` makes it."""
    return LaserAlone(ambient) if laser is None else take_off_room_light(laser, ambient)


def take_off_room_light(lit: Image, unlit: Image) -> LaserAlone:
    """The picture with the laser less that without it, where a lit room is in both.

    A line that is dimmer than its surroundings stands alone there. The difference has the noise of
    both pictures, as the extraction measures it. What is clipped in the picture with the laser is
    flat in the difference.

    Args:
        lit, unlit: (H, W) grey, 8 to 16 bits, of one exposure, with the laser on and off.

    Returns:
        The difference; the picture with the laser if the room is dark or differently lit there, or
        if something moved between the two.
    """
    if lit.shape != unlit.shape or lit.dtype != unlit.dtype:
        return LaserAlone(lit)
    on, off = lit.astype(np.float32), unlit.astype(np.float32)
    high = UNCLIPPED * max(saturation_level(lit), saturation_level(unlit))
    room = float(np.percentile(off, 99))
    shows = (off > ROOM * room) & (off < high) & (on < high)
    if room < ROOM * float(on.max()) or np.mean(shows) < LEAST_SHOWN:
        return LaserAlone(lit)
    gain = median(on[shows] / off[shows])
    if not ALIKE[0] <= gain <= ALIKE[1]:
        return LaserAlone(lit)
    light = on - gain * off
    light -= median(light[shows])
    # at least what rounding both pictures leaves
    sd = max(sigma_from_median(np.abs(light[shows])), 0.5)
    shifted = share_shifted(off, light, shows & (light < LASER_SDS * sd), sd)
    if shifted > MOST_SHIFTED:
        return LaserAlone(lit, shifted=shifted)
    light += MARGIN_SDS * sd
    steps = min(STEPS_PER_LEVEL, HIGHEST / float(light.max()))
    image = np.clip(np.round(steps * light), 0, np.iinfo(np.uint16).max).astype(np.uint16)
    return LaserAlone(image, True, steps)


def share_shifted(
    before: NDArray[np.float32], change: NDArray[np.float32], counts: NDArray[np.bool_], sd: float
) -> float:
    """The share of the blocks of a picture whose change (H, W) is a shift of what they show.

    In each block with enough texture, the shift along the prevailing slope of the grey levels is
    estimated.

    Args:
        before: (H, W) the picture.
        counts: (H, W) pixels whose change is none of the laser's light.
        sd: of the change by noise.

    Source:
        B. D. Lucas and T. Kanade, An Iterative Image Registration Technique, 1981; one step.
    """
    smooth = cv2.GaussianBlur(before, (0, 0), 1.0)
    by_x, by_y = (cv2.Sobel(smooth, cv2.CV_32F, *way, scale=1 / 8) for way in ((1, 0), (0, 1)))
    xx, xy, yy, x_change, y_change = (
        _sum_blocks(np.where(counts, product, 0.0))
        for product in (by_x**2, by_x * by_y, by_y**2, by_x * change, by_y * change)
    )
    turn = 0.5 * np.arctan2(2 * xy, xx - yy)
    c, s = np.cos(turn), np.sin(turn)
    slope = xx * c**2 + 2 * xy * c * s + yy * s**2
    shows = slope > (sd / SHIFT_SD_PX) ** 2
    if not shows.any():
        return 0.0
    shift_px = np.abs((x_change * c + y_change * s)[shows] / slope[shows])
    return float(np.mean(shift_px > SHIFT_PX))


def _sum_blocks(values: Floats) -> Floats:
    """(H // BLOCK_PX, W // BLOCK_PX) sums; what is left of a block at the edges does not count."""
    height, width = (size // BLOCK_PX for size in values.shape)
    whole = values[: height * BLOCK_PX, : width * BLOCK_PX]
    return np.asarray(whole.reshape(height, BLOCK_PX, width, BLOCK_PX).sum(axis=(1, 3)), np.float64)
