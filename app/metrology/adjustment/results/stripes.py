"""The laser's stripes after the adjustment: how they lie to its plane, and how far away."""

from dataclasses import replace

import numpy as np

from app.metrology.adjustment.core.gauss_newton import AdjustmentResult
from app.metrology.adjustment.core.observations import AdjustmentProblem
from app.metrology.adjustment.core.parameters import pose_scene
from app.metrology.calibration.observation_model import Rows
from app.metrology.sensor.projection import COUNT
from app.metrology.sensor.triangulation import sensor_points
from app.metrology.transforms import Floats

# Where the laser plane's offset stands among a scene's parameters.
OFFSET = COUNT + 2


def reclassify_stripes(found: AdjustmentResult) -> AdjustmentProblem:
    """The problem with all stripes judged against what was found."""
    problem, state = found.problem, found.state
    views = []
    for p, view in enumerate(problem.views):
        scene = pose_scene(state, problem, found.layout, p)
        views.append(view.reclassify_stripe(scene.camera, scene.plane, state.coordinates))
    return replace(problem, views=tuple(views))


def off_plane_mm(rows: Rows) -> Floats:
    """How far each point (N,) of a stripe lies off the laser plane, NaN where that is unknown.

    A pixel across the stripe is a length on the level, and so much of it off the plane.
    """
    by_offset = rows.jacobian[:, OFFSET]
    return np.asarray(rows.residuals / np.where(by_offset == 0, np.nan, by_offset))


def stripe_rms_mm(found: AdjustmentResult) -> float:
    """Rms distance from the laser plane of the stripe's points on their levels."""
    off = np.concatenate(
        [
            off_plane_mm(rows)[judgement.inliers]
            for (_, rows), (_, judgement) in zip(found.linear.rows, found.weights, strict=True)
        ]
    )
    off = off[np.isfinite(off)]
    return float(np.sqrt(np.mean(off**2))) if len(off) else 0.0


def depth_range_mm(found: AdjustmentResult) -> tuple[float, float]:
    """How near and how far from the camera the points of all stripes lie."""
    stripe = np.concatenate([view.stripe_px() for view in found.problem.views])
    points = sensor_points(found.state.camera, found.state.plane, stripe)
    distance = np.linalg.norm(points[np.isfinite(points).all(axis=1)], axis=1)
    return float(distance.min()), float(distance.max())
