"""What a camera and a laser would show of the block, point by point, with noise."""

from itertools import pairwise

import numpy as np

from crenel.metrology.calibration.observation_model import coordinates, with_coordinates
from crenel.metrology.detection.detect_block import EdgePoints
from crenel.metrology.detection.visibility import visible_parts
from crenel.metrology.sensor.camera import Camera, project
from crenel.metrology.sensor.laser_plane import LaserPlane
from crenel.metrology.stripe import Stripe
from crenel.metrology.targets.crenellated_block import Crenellated
from crenel.metrology.transforms import Floats, rotation_from_vector
from tests.metrology.numerics import unit


def camera_over(
    block: Crenellated,
    azimuth: float = 0.1,
    elevation: float = 1.0,
    roll: float = 0.0,
    k1: float = -0.05,
) -> Camera:
    """A camera at 135 mm that looks at the middle of the block, from the front and above."""
    target = np.array([np.mean(block.edges_x_mm), 0.0, (block.crest_z_mm + block.floor_z_mm) / 2])
    flat = np.cos(elevation)
    away = np.array([np.sin(azimuth) * flat, -np.cos(azimuth) * flat, np.sin(elevation)])
    x = unit(np.cross(-away, [0.0, 0.0, 1.0]))
    R = rotation_from_vector(np.array([0.0, 0.0, roll])) @ np.array([x, np.cross(-away, x), -away])
    K = np.array([[2800.0, 0.0, 645.0], [0.0, 2800.4, 507.0], [0.0, 0.0, 1.0]])
    distortion = np.array([k1, 0.0, 0.0, 0.0, 0.0])
    return Camera(K, R, -R @ (target + 135.0 * away), 1280, 1024, distortion)


def laser_plane(tilt: float = 0.02, offset_mm: float = 0.5) -> LaserPlane:
    """A plane that stands on the block, across its grooves."""
    return LaserPlane(unit([tilt / 2, 1.0, tilt]), offset_mm)


def draw_true_block(block: Crenellated, rng: np.random.Generator) -> Crenellated:
    """A block whose sizes are off its certificate as far as that allows."""
    values = coordinates(block)
    off = rng.normal(0, block.standard_uncertainty_mm, len(values))
    return with_coordinates(block, values + off)


def simulate_stripe(
    camera: Camera, block: Crenellated, plane: LaserPlane, rng: np.random.Generator, sd_px: float
) -> Stripe:
    """One point a column where the plane meets crests and floors that the camera sees."""
    uv = []
    for i, (left, right) in enumerate(pairwise(block.edges_x_mm)):
        z = block.floor_z_mm if i % 2 else block.crest_z_mm
        x = np.linspace(left, right, 400)
        y = (plane.offset_mm - plane.normal[0] * x - plane.normal[2] * z) / plane.normal[1]
        pixels = project(camera, np.column_stack([x, y, np.full(400, z)]))
        columns = np.arange(np.ceil(pixels[:, 0].min()), np.floor(pixels[:, 0].max()))
        order = np.argsort(pixels[:, 0])
        uv.append(np.column_stack([columns, np.interp(columns, *pixels[order].T)]))
    points = np.vstack(uv)
    points[:, 1] += rng.normal(0, sd_px, len(points))
    count = len(points)
    return Stripe(points[:, 0], points[:, 1], np.full(count, 150.0), np.full(count, sd_px))


def simulate_edges(
    camera: Camera, block: Crenellated, rng: np.random.Generator, sd_px: float
) -> list[EdgePoints]:
    """A point every eight pixels of each visible edge, its deviation across the edge ``sd_px``."""
    seen = []
    for part in visible_parts(block, camera.centre_mm):
        ends = project(camera, np.array([part.start_mm, part.end_mm]))
        length = float(np.linalg.norm(ends[1] - ends[0]))
        share = np.arange(8.0, length - 8.0, 8.0) / length
        if len(share) < 4:
            continue
        uv = project(camera, part.start_mm + share[:, None] * (part.end_mm - part.start_mm))
        tangent = (ends[1] - ends[0]) / length
        normal = np.tile([-tangent[1], tangent[0]], (len(uv), 1))
        uv = uv + normal * rng.normal(0, sd_px, (len(uv), 1))
        seen.append(EdgePoints(part.edge, uv, normal, np.full(len(uv), sd_px)))
    return seen


def volume_points(camera: Camera, plane: LaserPlane, block: Crenellated) -> tuple[Floats, Floats]:
    """Pixels (N, 2) and points (N, 3) of the laser plane all over the measuring volume."""
    across, up = np.meshgrid(
        np.linspace(block.edges_x_mm[0], block.edges_x_mm[-1], 9),
        np.linspace(block.floor_z_mm, block.crest_z_mm, 5),
    )
    x, z = across.ravel(), up.ravel()
    y = (plane.offset_mm - plane.normal[0] * x - plane.normal[2] * z) / plane.normal[1]
    points = np.column_stack([x, y, z])
    return project(camera, points), points
