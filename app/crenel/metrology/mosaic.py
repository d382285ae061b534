"""Whether a grey picture is in truth a raw one of a colour camera.

Under a mosaic of filters, neighbouring pixels differ by their colour, with green on one diagonal
of each 2 × 2 of them. Light then alternates from pixel to pixel along rows and along columns, by
(R - B) / 4 each, and on the diagonals by (2 G - R - B) / 4. Whatever the scene shows, the first two
have the same size all over the picture, and their ratio the same sign; and where the camera does
not balance white, the third keeps its sign. Edges, noise, compression and interlacing do neither.
"""

import numpy as np
from numpy.typing import NDArray

from crenel.metrology.image import Image
from crenel.metrology.transforms import Floats

BLOCK_PX = 16
DARK_PERCENT, SAMPLED_PX = 0.5, 4
"""Share of the pixels whose level is taken for black, and of which pixels."""
LEAST_CONTRAST, LEAST_AGREEMENT = 0.01, 0.7
"""What alternates along rows and columns: its rms as a share of the light's; how far all blocks
agree on the ratio, 1 or -1, where chance gives 0."""
LEAST_CONTRAST_OF_GREEN, LEAST_AGREEMENT_OF_SIGN = 0.02, 0.9
"""The same of what alternates on the diagonals, and its sign."""
ROUNDING = 1e-4
"""Share of the power of all light that counts as much as light above black."""
ENOUGH_PX = 2_000_000
"""Pixels that are examined: of a larger picture, evenly spread rows of blocks."""
LEAST_BLOCKS = 16.0
"""Blocks that carry the evidence, so that no single thing in the picture decides."""


def shows_mosaic(picture: Image) -> bool:
    """Whether the pixels of a picture (H, W) alternate as under the filters of a colour camera.

    False where the alternation is so weak that it does not matter, as of a grey scene of which the
    camera has balanced white.

    Example:
        >>> flat = np.full((128, 128), 100, np.uint8)
        >>> raw = flat.copy()
        >>> raw[::2, ::2] = 60
        >>> raw[1::2, 1::2] = 80
        >>> shows_mosaic(flat), shows_mosaic(raw)
        (False, True)
    """
    height, width = (size // BLOCK_PX * BLOCK_PX for size in picture.shape)
    if not height or not width:
        return False
    every = max(1, round(height * width / ENOUGH_PX))
    rows_of_blocks = picture[:height, :width].reshape(-1, BLOCK_PX, width)[::every]
    black = np.percentile(rows_of_blocks[:, ::SAMPLED_PX, ::SAMPLED_PX], DARK_PERCENT)
    light, along_rows, along_columns, on_diagonals = _block_means(rows_of_blocks)
    least = float(np.mean((light - black) ** 2) + ROUNDING * np.mean(light**2))
    power = (along_rows**2 + along_columns**2) / 2
    if _carries(power, LEAST_CONTRAST**2 * least):
        agreement = np.sum(along_rows * along_columns) / np.sum(power)
        if abs(agreement) >= LEAST_AGREEMENT:
            return True
    power = on_diagonals**2
    if not _carries(power, LEAST_CONTRAST_OF_GREEN**2 * least):
        return False
    agreement = np.sum(on_diagonals * np.abs(on_diagonals)) / np.sum(power)
    return bool(abs(agreement) >= LEAST_AGREEMENT_OF_SIGN)


def _block_means(rows_of_blocks: Image) -> tuple[Floats, Floats, Floats, Floats]:
    """The light of each block, and what alternates along rows, along columns and on diagonals.

    The weights are second differences: slopes of the light leave nothing in what alternates.

    Args:
        rows_of_blocks: (R, BLOCK_PX, W).
    """
    ends = np.array([1.0, 3.0])
    alternating = np.concatenate([ends, np.full(BLOCK_PX - 4, 4.0), ends[::-1]])
    alternating[1::2] *= -1.0
    alternating /= np.sum(np.abs(alternating))
    weights = np.stack([np.full(BLOCK_PX, 1.0 / BLOCK_PX), alternating]).astype(np.float32)
    count, _, width = rows_of_blocks.shape
    pixels: NDArray[np.float32] = rows_of_blocks.astype(np.float32)
    by_rows = weights @ pixels
    parts = (by_rows.reshape(-1, BLOCK_PX) @ weights.T).astype(np.float64)
    parts = parts.reshape(count, 2, width // BLOCK_PX, 2)
    return parts[:, 0, :, 0], parts[:, 0, :, 1], parts[:, 1, :, 0], parts[:, 1, :, 1]


def _carries(power: Floats, least: float) -> bool:
    """Whether enough blocks (rows, columns) have a mean power above the least."""
    total = float(np.sum(power))
    return bool(total > least * power.size and total**2 >= LEAST_BLOCKS * np.sum(power**2))
