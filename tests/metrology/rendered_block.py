"""Pictures of a block by the simulation's ray caster, which shares no code with what is tested."""

from dataclasses import dataclass, replace

import numpy as np
from numpy.typing import NDArray

from crenel.metrology.detection.edges.measure_all import EdgeMeasurements, measure_edges
from crenel.metrology.detection.visibility import wireframe
from crenel.metrology.sensor.camera import Camera
from crenel.metrology.targets.crenellated_block import Crenellated
from crenel.metrology.transforms import Floats
from crenel_hardware.simulator.rendering.noise import Detector
from crenel_hardware.simulator.rendering.render import Renderer
from crenel_hardware.simulator.scene.camera import (
    LightPlane,
    Optics,
    camera_looking_at,
    light_plane_through,
)
from crenel_hardware.simulator.scene.random_scenes import draw_true_block, random_block
from crenel_hardware.simulator.scene.world import (
    Box,
    CrenellatedBlock,
    Light,
    SceneObject,
    SimulatedScene,
)

WIDTH, HEIGHT = 800, 640
MADE_MM = 0.002
"""Standard uncertainty of the certificates."""


@dataclass(frozen=True)
class RenderedBlock:
    """A picture of a block, the block's certificate, and the camera (object frame) that took it."""

    image: NDArray[np.uint8]
    block: Crenellated
    camera: Camera


def certificate(comb: CrenellatedBlock) -> Crenellated:
    y_mm, z_mm = (comb.front_y_mm, comb.back_y_mm), (comb.crest_z_mm, comb.floor_z_mm)
    return Crenellated("rendered", "R-1", comb.edges_x_mm, *y_mm, *z_mm, comb.base_z_mm, MADE_MM)


def _optics(
    comb: CrenellatedBlock, azimuth: float, elevation: float, roll: float, fill: float
) -> Optics:
    x = comb.edges_x_mm
    low = np.array([x[0], comb.front_y_mm, comb.base_z_mm])
    high = np.array([x[-1], comb.back_y_mm, comb.crest_z_mm])
    flat = np.cos(elevation)
    away = np.array([np.sin(azimuth) * flat, -np.cos(azimuth) * flat, np.sin(elevation)])
    eye = (low + high) / 2 + 135.0 * away
    T = camera_looking_at(eye, (low + high) / 2, np.array([1.0, 0.0, 0.0]), roll)
    box = np.array([np.where(np.array(bits), high, low) for bits in np.ndindex(2, 2, 2)])
    in_cam = box @ T[:3, :3].T + T[:3, 3]
    reach = np.abs(in_cam[:, :2] / in_cam[:, 2:]).max(axis=0)
    focal = fill * 0.5 * float(np.min([WIDTH, HEIGHT] / reach))
    return Optics(WIDTH, HEIGHT, focal, focal, 405.0, 315.0, (-0.04, 0.0, 0.0, 0.0, 0.0), T)


def _make_light_plane(comb: CrenellatedBlock) -> LightPlane:
    middle = (comb.front_y_mm + comb.back_y_mm) / 2
    light_plane = light_plane_through(
        np.array([0.0, 1.0, -0.02]), np.array([0.0, middle, 0.0]), np.array([0.0, middle, 130.0])
    )
    return replace(light_plane, half_angle_rad=0.5)


def render_block(
    seed: int,
    *,
    merlons: int | None = None,
    azimuth: float = 0.1,
    elevation: float = 0.95,
    roll: float = 0.0,
    fill: float = 0.85,
    laser: float = 0.0,
    table: float | None = None,
    shade: float = 0.3,
    blur_px: float = 0.7,
) -> RenderedBlock:
    """One picture of a random block. ``table`` is the brightness of what it stands on, if any."""
    rng = np.random.default_rng(seed)
    comb = random_block(rng, merlons)
    optics = _optics(comb, azimuth, elevation, roll, fill)
    things = [SceneObject("block", draw_true_block(comb, MADE_MM, rng), np.eye(4))]
    if table is not None:
        under = np.eye(4)
        under[2, 3] = comb.base_z_mm - 0.01
        slab = Box((-1500.0, -1500.0, -30.0), (1500.0, 1500.0, 0.0))
        things.append(SceneObject("table", slab, under, table))
    light = Light((0.3, -0.4, 1.0), groove_shade=shade)
    scene, detector = SimulatedScene(tuple(things), light), Detector(blur_px=blur_px)
    renderer = Renderer(scene, optics, _make_light_plane(comb), detector, seed)
    image = np.asarray(renderer.render(np.eye(4), 1.0, laser, 55), dtype=np.uint8)
    T = optics.T_cam_sensor
    lens = np.array(optics.distortion)
    camera = Camera(optics.matrix, T[:3, :3], T[:3, 3], WIDTH, HEIGHT, lens)
    return RenderedBlock(image, certificate(comb), camera)


def with_edge(block: Crenellated, edge: int, by_mm: float) -> Crenellated:
    """A certificate with one edge elsewhere along x."""
    edges = list(block.edges_x_mm)
    edges[edge] += by_mm
    return replace(block, edges_x_mm=tuple(edges))


def survey(
    shown: RenderedBlock,
    block: Crenellated | None = None,
    grey: Floats | None = None,
    blur_px: float = 0.7,
) -> EdgeMeasurements:
    """The edges of its block, or of another certificate, measured where the camera shows them."""
    image = shown.image.astype(float) if grey is None else grey
    found = measure_edges(image, wireframe(block or shown.block), shown.camera, blur_px, MADE_MM)
    assert found is not None
    return found
