"""Widths of merlons and grooves by which a block is never taken for its mirror image.

From left to right, each merlon and each groove is narrower than the one before it. No two are
equal, and hardly any order of these widths differs more from its mirror image and from its copy
shifted by a merlon (``tests/metrology/test_design.py`` tries them all).
"""

import numpy as np

SPREAD = 0.4
"""The narrowest width is the mean less this share, the widest the mean and this share."""


def merlon_edges(width_mm: float, merlons: int, step_mm: float) -> tuple[float, ...] | None:
    """Left and right edges of merlons about x = 0, on a grid of sizes.

    Args:
        width_mm: of the block, at most.
        merlons: how many, 2 or more.
        step_mm: every width is a multiple of it.

    Returns:
        ``2 merlons`` ascending edges in mm; None where the grid is too coarse for so many
        different widths.

    Example:
        >>> merlon_edges(44.0, 3, 0.5)
        (-21.5, -9.5, 1.0, 9.5, 16.5, 21.5)
    """
    count = 2 * merlons - 1
    shares = np.linspace(1 + SPREAD, 1 - SPREAD, count)
    steps = np.floor(shares * width_mm / count / step_mm + 1e-9).astype(np.int64)
    if steps[-1] < 1 or (np.diff(steps) >= 0).any():
        return None
    edges = np.concatenate([[0], np.cumsum(steps)])
    edges = (edges - round(edges[-1] / 2)) * step_mm
    return tuple(round(float(x), 6) for x in edges)
