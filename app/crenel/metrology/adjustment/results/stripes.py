"""The laser stripes after the adjustment: their distances from the laser plane and the camera."""

from dataclasses import replace

import numpy as np

from crenel.metrology.adjustment.core.gauss_newton import AdjustmentResult
from crenel.metrology.adjustment.core.observations import AdjustmentProblem
from crenel.metrology.adjustment.core.parameters import pose_scene
from crenel.metrology.calibration.observation_model import Rows
from crenel.metrology.sensor.projection import COUNT
from crenel.metrology.sensor.triangulation import sensor_points
from crenel.metrology.transforms import Floats

# Index of the laser plane's offset among the parameters of a scene.
OFFSET = COUNT + 2


def reclassify_stripes(found: AdjustmentResult) -> AdjustmentProblem:
    """The problem with all stripes judged by the result."""
    problem, state = found.problem, found.state
    views = []
    for p, view in enumerate(problem.views):
        scene = pose_scene(state, problem, found.layout, p)
        views.append(view.reclassify_stripe(scene.camera, scene.plane, state.coordinates))
    return replace(problem, views=tuple(views))


def off_plane_mm(rows: Rows) -> Floats:
    """Distance of each point (N,) of a stripe from the laser plane; NaN if it is unknown.

    A pixel across the stripe corresponds to a length on the level, and that to a distance from the
    plane.
    """
    by_offset = rows.jacobian[:, OFFSET]
    return np.asarray(rows.residuals / np.where(by_offset == 0, np.nan, by_offset))


def stripe_rms_mm(found: AdjustmentResult) -> float:
    """Rms distance of the stripe points on their levels from the laser plane."""
    off = np.concatenate(
        [
            off_plane_mm(rows)[judgement.inliers]
            for (_, rows), (_, judgement) in zip(found.linear.rows, found.weights, strict=True)
        ]
    )
    off = off[np.isfinite(off)]
    return float(np.sqrt(np.mean(off**2))) if len(off) else 0.0


def object_depths_mm(found: AdjustmentResult, points_mm: Floats) -> tuple[float, float]:
    """The nearest and the furthest distance of points (N, 3) of the object from the camera."""
    distance = np.concatenate(
        [
            np.linalg.norm(points_mm - scene.camera.centre_mm, axis=1)
            for scene in found.linear.scenes
        ]
    )
    return float(distance.min()), float(distance.max())


def depth_range_mm(found: AdjustmentResult) -> tuple[float, float]:
    """The nearest and the furthest distance of the points of all stripes from the camera."""
    stripe = np.concatenate([view.stripe_px() for view in found.problem.views])
    points = sensor_points(found.state.camera, found.state.plane, stripe)
    distance = np.linalg.norm(points[np.isfinite(points).all(axis=1)], axis=1)
    return float(distance.min()), float(distance.max())
