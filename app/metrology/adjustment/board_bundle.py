"""A bundle of pictures of one board: lens, places and the sheet's shape, from corners alone.

It needs neither arm nor laser, and starts the adjustment of everything.
"""

from collections.abc import Sequence
from dataclasses import dataclass, replace

import numpy as np

from app.metrology.adjustment.board_view import BoardView
from app.metrology.adjustment.linear import usual_camera
from app.metrology.adjustment.sheet import board_papers
from app.metrology.camera import Camera
from app.metrology.frames import Floats
from app.metrology.projection import COUNT, stepped
from app.metrology.scene import BLOCK

# Of ``PARAMETERS``: what all pictures have in common (fx, fy, u0, v0, k1, k2), what each has
# of its own, and what of the common ones' prior counts here.
COMMON = np.array([0, 1, 2, 3, 10, 11])
OWN = np.arange(4, 10)
OF_PRIOR = np.array([0, 1, 2, 3, 4, 5])
ROUNDS = 12
SETTLED_PX = 1e-3
# Corners scatter by this at least; and those beyond so many deviations do not count.
LEAST_SCATTER_PX, OUTLIER_SIGMAS = 0.02, 4.5


@dataclass(frozen=True)
class Bundle:
    """The camera in each of P poses, board frame as sensor frame; the sheet's coordinates; and
    how corners scatter (px, rms of one coordinate)."""

    cameras: tuple[Camera, ...]
    coordinates: Floats
    scatter_px: float


def bundle(views: Sequence[BoardView], cameras: Sequence[Camera]) -> Bundle:
    """The most likely lens, places and sheet for the corners of all views.

    Args:
        cameras: a start, one for each view, alike but for their places.
    """
    papers = board_papers(views[0].board)
    found = Bundle(tuple(cameras), papers.coordinates, np.inf)
    for _ in range(ROUNDS):
        before, found = found, _stepped(views, found, papers.coordinates, papers.sd)
        if abs(found.scatter_px - before.scatter_px) < SETTLED_PX:
            break
    return found


def _stepped(views: Sequence[BoardView], at: Bundle, certified: Floats, sd: Floats) -> Bundle:
    """One round of Gauss-Newton."""
    shared = len(COMMON) + len(certified)
    count = shared + len(OWN) * len(views)
    blocks, residuals = [], []
    for p, (view, camera) in enumerate(zip(views, at.cameras, strict=True)):
        rows = view.corner_rows(camera, at.coordinates)
        J = np.zeros((len(rows.residuals), count))
        J[:, : len(COMMON)] = rows.jacobian[:, COMMON]
        J[:, len(COMMON) : shared] = rows.jacobian[:, BLOCK]
        own = slice(shared + len(OWN) * p, shared + len(OWN) * (p + 1))
        J[:, own] = rows.jacobian[:, OWN]
        blocks.append(J)
        residuals.append(rows.residuals)
    J, r = np.concatenate(blocks), np.concatenate(residuals)
    scatter = max(float(np.median(np.abs(r))) / 0.6745, LEAST_SCATTER_PX)
    kept = np.abs(r) < OUTLIER_SIGMAS * scatter
    N = J[kept].T @ J[kept] / scatter**2
    g = J[kept].T @ r[kept] / scatter**2
    prior, pull = usual_camera(at.cameras[0])
    common = np.arange(len(COMMON))
    N[np.ix_(common, common)] += prior[np.ix_(OF_PRIOR, OF_PRIOR)]
    g[common] += pull[OF_PRIOR]
    sheet = np.arange(len(COMMON), shared)
    N[sheet, sheet] += sd**-2.0
    g[sheet] += (at.coordinates - certified) / sd**2
    scale = np.diag(N) ** -0.5
    step = -scale * np.linalg.solve(N * np.outer(scale, scale), scale * g)
    cameras = []
    for p, camera in enumerate(at.cameras):
        own_step = np.zeros(COUNT)
        own_step[COMMON] = step[common]
        own_step[OWN] = step[shared + len(OWN) * p : shared + len(OWN) * (p + 1)]
        cameras.append(stepped(camera, own_step))
    # all unknowns were free, the sheet's within its certificate
    degrees = max(int(kept.sum()) - len(COMMON) - len(OWN) * len(views), 1)
    rms = float(np.sqrt(r[kept] @ r[kept] / degrees))
    return Bundle(tuple(cameras), at.coordinates + step[sheet], max(rms, LEAST_SCATTER_PX))


def unplaced(camera: Camera) -> Camera:
    """The camera with its own frame as sensor frame."""
    return replace(camera, rotation=np.eye(3), translation_mm=np.zeros(3))
