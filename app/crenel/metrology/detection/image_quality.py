"""Checks whether a picture is suitable for measurement: exposure, saturation and sharpness."""

from dataclasses import dataclass, replace

import cv2
import numpy as np
from numpy.typing import NDArray

from crenel.errors import OperationError
from crenel.messages.message import Text, message, quantity
from crenel.metrology.image import saturation_level
from crenel.metrology.mosaic import shows_mosaic
from crenel.metrology.robust import median, sigma_from_median
from crenel.metrology.stripe.laser_alone import MOST_SHIFTED, LaserAlone
from crenel.metrology.transforms import Floats

Image = NDArray[np.uint8] | NDArray[np.uint16]

# Bright parts below this share of full scale: noise and rounding become significant.
DIM = 0.15
# Contrast below this share of full scale cannot be distinguished from the noise of one frame.
DARK = 0.03
# Share of clipped pixels from which a face, not just a glint or the stripe, is lost.
CLIPPED = 0.03
# Width of a step of brightness (standard deviation of the blur) relative to the longer side. Beyond
# the second, the two edges of a groove's side merge.
SOFT = 0.0016
BLURRED = 0.004
# Lens and pixels blur this much in focus: in a small picture, less is no fault.
IN_FOCUS_PX = 1.5
# Ratio of noise to contrast at which the smaller steps between faces are lost.
NOISY = 0.04
_SMOOTH_PX = 0.7
# From 10 % to 90 % of its height, a step is this many standard deviations wide.
EDGE_WIDTH = 2.56
# Code of a raw picture of a colour camera that is taken for a grey one.
RAW = "image-raw"


@dataclass(frozen=True)
class ImageFinding:
    """A problem of a picture that the operator should correct.

    ``value`` and ``limit`` are shares of full scale, of the pixels, or pixels; 1 and 0 of a raw
    picture.
    """

    code: str
    text: Text
    remedy: Text
    value: float
    limit: float


def grey_levels(image: Image) -> tuple[Floats, NDArray[np.bool_]]:
    """Grey levels on a scale of 0 to 255, and which pixels are clipped.

    Args:
        image: (H, W), 8 to 16 bits, at least 64 pixels each way.

    Returns:
        (H, W) grey levels; (H, W) True where a pixel is clipped.

    Raises:
        OperationError: ``image-not-grey``.
    """
    array = image
    if array.ndim != 2 or array.dtype not in (np.uint8, np.uint16) or min(array.shape) < 64:
        raise OperationError(
            "image-not-grey",
            message("image-shape-type", shape=str(array.shape), dtype=str(array.dtype)),
            message("object-looked-grey-images-8-16"),
        )
    clipped = array >= saturation_level(array)
    if array.dtype == np.uint8:
        return array.astype(np.float64), clipped
    # The smallest bit depth of current sensors that can hold this picture.
    bits = next(b for b in (8, 10, 12, 14, 16) if int(array.max()) < 2**b)
    return array.astype(np.float64) * (255.0 / (2**bits - 1)), clipped


def is_noisy(grey: Floats) -> bool:
    """Whether a picture (H, W) is so noisy, relative to its contrast, that edges of faces may be
    lost."""
    bend = np.abs(grey[1:-1:2, 2::2] - 2 * grey[1:-1:2, 1:-1:2] + grey[1:-1:2, :-2:2])
    noise = sigma_from_median(bend) / np.sqrt(6.0)
    low, high = np.percentile(grey[::4, ::4], (2.0, 98.0))
    return bool(noise > NOISY * float(high - low))


def edge_blur_px(grey: NDArray[np.floating]) -> float:
    """Standard deviation of the blur at the edges of an image.

    A step of height a, blurred by s, has a maximum slope of ``a / (s sqrt(2 pi))``; height and
    slope are taken where the image is steepest.

    Args:
        grey: (H, W).

    Returns:
        Blur in px; inf if there are no edges.
    """
    shrink = max(1, max(grey.shape) // 2000)
    blur = float("inf")
    while shrink <= 16:
        size = (grey.shape[1] // shrink, grey.shape[0] // shrink)
        small = np.asarray(grey, np.float32)
        if shrink > 1:
            small = np.asarray(cv2.resize(small, size, interpolation=cv2.INTER_AREA), np.float32)
        found = _level_blur_px(small)
        blur = found * shrink if np.isfinite(found) else blur
        # Beyond this, the window in which the height of the step is measured is too small.
        if found < 3.0:
            break
        shrink *= 2
    return blur


def _level_blur_px(small: NDArray[np.float32]) -> float:
    smooth = cv2.GaussianBlur(small, (0, 0), _SMOOTH_PX)
    slope = cv2.magnitude(
        cv2.Sobel(smooth, cv2.CV_32F, 1, 0, ksize=1) * 0.5,
        cv2.Sobel(smooth, cv2.CV_32F, 0, 1, ksize=1) * 0.5,
    )
    box = np.ones((15, 15), np.uint8)
    height = cv2.dilate(smooth, box) - cv2.erode(smooth, box)
    noise = median(slope[::2, ::2]) / 1.1774
    low, high = np.percentile(smooth[::4, ::4], (1.0, 99.0))
    ridge = (slope > 6 * noise + 0.3) & (height > 0.3 * (high - low))
    ridge &= slope >= cv2.dilate(slope, np.ones((3, 3), np.uint8))
    # A step within the box is at least as steep as its height over the box's diagonal; anything
    # less steep is noise beside a step.
    ridge &= slope * 20.0 > height
    if int(ridge.sum()) < 50:
        return float("inf")
    blur = median(height[ridge] / slope[ridge]) / np.sqrt(2 * np.pi)
    return float(np.sqrt(max(blur**2 - _SMOOTH_PX**2, 0.05)))


@dataclass(frozen=True)
class ImageQuality:
    """The quality of a picture in figures.

    ``saturated`` is the share of clipped pixels, ``low`` and ``high`` the levels of the dark and
    bright parts as shares of full scale, ``blur_px`` the standard deviation of the blur at its
    edges: None in a dim or clipped picture, where it would be misleading, and if there are no
    edges. ``soft_px`` is the limit of the blur. ``mosaic``: the pixels alternate as in a raw
    picture of a colour camera.
    """

    saturated: float
    low: float
    high: float
    blur_px: float | None
    soft_px: float
    mosaic: bool = False

    @property
    def dark(self) -> bool:
        """No contrast that could be distinguished from noise."""
        return self.high - self.low < DARK

    @property
    def dim(self) -> bool:
        return self.high < DIM

    @property
    def overexposed(self) -> bool:
        return self.saturated > CLIPPED


def measure_image_quality(image: Image) -> ImageQuality:
    """Exposure and sharpness of an image in figures; fast enough for live use.

    Args:
        image: (H, W) grey, 8 to 16 bits.

    Returns:
        Shares of full scale and of the pixels, and the blur in px.

    Raises:
        OperationError: ``image-not-grey``.
    """
    step = max(1, min(image.shape) // 500) if image.ndim == 2 else 1
    thin, clipped = grey_levels(image[::step, ::step])
    low, high = np.percentile(thin[::2, ::2], (1.0, 99.0)) / 255.0
    longer = max(image.shape)
    found = ImageQuality(
        saturated=float(clipped.mean()),
        low=float(low),
        high=float(high),
        blur_px=None,
        soft_px=max(SOFT * longer, IN_FOCUS_PX),
        mosaic=shows_mosaic(image),
    )
    if found.overexposed or found.dark or found.dim:
        return found
    return replace(found, blur_px=_blur_px(image))


def image_findings(image: Image) -> list[ImageFinding]:
    """What is wrong with an image of the target, most serious first; fast enough for live use.

    Args:
        image: (H, W) grey, 8 to 16 bits.

    Returns:
        Findings with the codes ``image-raw``, ``image-dark``, ``image-dim``, ``image-saturated``,
        ``image-soft`` and ``image-blurred``; none for a good image.

    Raises:
        OperationError: ``image-not-grey``.

    Example:
        >>> [finding.code for finding in image_findings(np.full((128, 128), 255, np.uint8))]
        ['image-saturated']
    """
    return quality_findings(measure_image_quality(image))


def pose_findings(ambient: Image, alone: LaserAlone) -> list[ImageFinding]:
    """What is wrong with the pictures of a pose: with the one with ambient light, as
    ``image_findings``, and with both, if they do not show the same place (``image-moved``)."""
    findings = image_findings(ambient)
    if not alone.shifted:
        return findings
    return [
        *findings,
        ImageFinding(
            "image-moved",
            message(
                "pictures-with-and-without-laser-differ-by-motion",
                shifted=quantity(100 * alone.shifted, "%"),
            ),
            message("hold-still-for-both-pictures"),
            alone.shifted,
            MOST_SHIFTED,
        ),
    ]


def quality_findings(picture: ImageQuality) -> list[ImageFinding]:
    """What is wrong with an image by its figures.

    Args:
        picture: as of ``measure_image_quality``.

    Returns:
        Findings as of ``image_findings``.
    """
    if picture.mosaic:
        return [
            ImageFinding(RAW, message("pixels-alternate-as-raw"), message("state-bayer"), 1.0, 0.0)
        ]
    if picture.overexposed:
        return [
            ImageFinding(
                "image-saturated",
                message("picture-overexposed", saturated=quantity(100 * picture.saturated, "%")),
                message("turn-down-exposure-until-objects-faces"),
                picture.saturated,
                CLIPPED,
            )
        ]
    if picture.dark:
        contrast = picture.high - picture.low
        return [
            ImageFinding(
                "image-dark",
                message(
                    "picture-shows-no-contrast-full-scale",
                    contrast=quantity(100 * contrast, "%", 1),
                ),
                message("turn-up-light-exposure-look-object"),
                contrast,
                DARK,
            )
        ]
    if picture.dim:
        return [
            ImageFinding(
                "image-dim",
                message(
                    "picture-dim-bright-parts-reach-full", high=quantity(100 * picture.high, "%")
                ),
                message("turn-up-light-exposure"),
                picture.high,
                DIM,
            )
        ]
    return _sharpness(picture)


def _blur_px(array: Image) -> float | None:
    shrink = min(1.0, 640 / max(array.shape))
    grey = array.astype(np.float32)
    if shrink < 1.0:
        grey = np.asarray(
            cv2.resize(grey, None, fx=shrink, fy=shrink, interpolation=cv2.INTER_AREA), np.float32
        )
    blur = edge_blur_px(grey) / shrink
    return blur if np.isfinite(blur) else None


def _sharpness(picture: ImageQuality) -> list[ImageFinding]:
    blur, soft = picture.blur_px, picture.soft_px
    if blur is None or blur <= soft:
        return []
    width = quantity(EDGE_WIDTH * blur, "px")
    code, text, limit = "image-soft", message("picture-soft-edges-wide", width=width), soft
    if blur > soft * BLURRED / SOFT:
        limit = soft * BLURRED / SOFT
        code, text = "image-blurred", message("picture-blurred-edges-wide", width=width)
    return [
        ImageFinding(
            code,
            text,
            message("focus-camera-bring-object-and-hold-still"),
            blur,
            limit,
        )
    ]
