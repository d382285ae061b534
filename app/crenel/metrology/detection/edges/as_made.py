"""The block as the picture shows it made, where its certificate leaves its planes open by pixels.

A block known by its drawing alone lies off it by more than its edges are measured to. Its planes
are estimated together with the camera, with the certificate as their prior, and the picture is
then judged against the block as made: what the tolerance allows is no contradiction.
"""

import numpy as np

from crenel.metrology.detection.edges.camera_from_edges import (
    WITH_K1,
    prior_rows,
    residuals_with_jacobian,
)
from crenel.metrology.detection.edges.dimension_test import planes, shift_effects
from crenel.metrology.detection.edges.measure_all import EdgeMeasurements
from crenel.metrology.robust import huber_weights, median, sigma_from_median
from crenel.metrology.targets.crenellated_block import Crenellated
from crenel.metrology.transforms import Floats

AS_MADE_MM = 0.003
"""Standard uncertainty of a plane that was estimated in the picture itself."""
# A certificate this good, in pixels, needs no estimate.
_OPEN_PX = 0.15
# A plane further off than this many standard uncertainties is another block's, not one of this
# making.
_FURTHEST_SIGMAS = 4.0
# Points further off than this many standard deviations have less weight (Huber), and iterations.
_HUBER, _ROUNDS = 2.5, 4


def is_open(found: EdgeMeasurements, certificate_mm: float) -> bool:
    """Whether the certificate leaves the planes of the block open by a visible part of a pixel."""
    depth = found.at.points_mm @ found.camera.rotation[2] + found.camera.translation_mm[2]
    return bool(certificate_mm * found.camera.matrix[0, 0] / median(depth) > _OPEN_PX)


def block_as_made(found: EdgeMeasurements, certificate: Crenellated) -> Crenellated | None:
    """The block whose planes lie where the picture shows them.

    One adjustment of the camera and of all planes to the measured edges. What the camera explains
    as well, such as the size of the whole block, stays as certified.

    Args:
        found: the edges, measured along those of a block like it.
        certificate: the block by its certificate, with the standard uncertainty of its making.

    Returns:
        The block, known to ``AS_MADE_MM``; None if a plane lies where its making does not allow.
    """
    rows, at = np.flatnonzero(found.used), found.at
    made_mm, before_mm = certificate.standard_uncertainty_mm, _planes_mm(found.frame.block)
    off, by_camera = residuals_with_jacobian(
        found.camera, at.points_mm[rows], found.uv_px[rows], at.normal[rows]
    )
    by_planes = -shift_effects(found, rows, planes(found.frame))
    table = np.hstack([by_camera[:, WITH_K1], by_planes]) / found.sigma_px[rows, None]
    off_certificate = before_mm - _planes_mm(certificate)
    camera_prior = prior_rows(found.camera, WITH_K1)
    prior = np.zeros((len(camera_prior) + len(before_mm), table.shape[1]))
    prior[: len(camera_prior), : len(WITH_K1)] = camera_prior
    prior[len(camera_prior) :, len(WITH_K1) :] = np.eye(len(before_mm)) / made_mm
    wanted = np.append(np.zeros(len(camera_prior)), -off_certificate / made_mm)
    by_mm = _solve(off / found.sigma_px[rows], table, prior, wanted)[len(WITH_K1) :]
    if np.abs(off_certificate + by_mm).max() > _FURTHEST_SIGMAS * made_mm:
        return None
    *edges, front, back, base, floor, crest = map(float, before_mm + by_mm)
    return Crenellated(
        certificate.name,
        certificate.serial_number,
        tuple(edges),
        front,
        back,
        crest,
        floor,
        base,
        AS_MADE_MM,
    )


def _planes_mm(block: Crenellated) -> Floats:
    """(K,) the planes of a block in the order of ``planes``."""
    y, z = (block.front_y_mm, block.back_y_mm), (block.base_z_mm, block.floor_z_mm)
    return np.array([*block.edges_x_mm, *y, *z, block.crest_z_mm])


def _solve(off: Floats, table: Floats, prior: Floats, wanted: Floats) -> Floats:
    """The step (U,) that whitened distances (N,) with derivatives (N, U) ask for, robustly; the
    rows of the prior (H, U) want values (H,)."""
    weight = np.ones(len(off))
    step = np.zeros(table.shape[1])
    scale = 1 / np.linalg.norm(np.vstack([table, prior]), axis=0)
    for _ in range(_ROUNDS):
        root = np.sqrt(weight)
        rows = np.vstack([table * root[:, None], prior]) * scale
        step = scale * np.linalg.lstsq(rows, np.append(-off * root, wanted), rcond=None)[0]
        left = np.abs(off + table @ step)
        weight = huber_weights(left, _HUBER * max(1.0, sigma_from_median(left)))
    return np.asarray(step)
