"""Pictures of the block as a workshop spoils them: many things in the way, several at once.

``draw_degraded_image`` makes another block, camera, light and surroundings for every seed. A
picture counts as usable where at least ``USABLE`` of the block's visible edges are in it
and not covered, by length; nothing else is asked for. So there are pictures among them in
which faces are as bright as each other, or edges drown in noise, blur or tool marks:
those a detection has to refuse, and to say why.
"""

from dataclasses import dataclass, replace

import numpy as np

from crenel_hardware.simulator.devices.kinematics import Floats, rotation_about, translation
from crenel_hardware.simulator.rendering.noise import Detector, RawImage
from crenel_hardware.simulator.rendering.render import Renderer
from crenel_hardware.simulator.rendering.tracing import first_hits, ray_bundle
from crenel_hardware.simulator.scene.camera import (
    LightPlane,
    Optics,
    camera_looking_at,
    light_plane_through,
    to_pixels,
)
from crenel_hardware.simulator.scene.random_scenes import draw_true_block
from crenel_hardware.simulator.scene.world import (
    Box,
    CrenellatedBlock,
    GaugeSphere,
    Light,
    ObjectShape,
    SceneObject,
    SimulatedScene,
    SurfaceFinish,
    shape_rows,
)

USABLE = 0.6
NUISANCES = {
    "equal-faces": 0.3,
    "stripe": 0.3,
    "uneven-light": 0.3,
    "shadows": 0.3,
    "highlights": 0.25,
    "tool-marks": 0.3,
    "defocus": 0.3,
    "noise": 0.3,
    "rolled": 0.6,
    "cut-off": 0.2,
    "covered": 0.12,
    "clutter": 0.45,
    "deep-bits": 0.4,
}
"""What may spoil a picture, and how often each does."""
SENSORS_PX = ((800, 640), (1024, 768), (1280, 1024), (1600, 1200), (2048, 1536), (2592, 1944))
SENSOR_SHARES = (0.2, 0.2, 0.3, 0.15, 0.1, 0.05)
RAYS = 34
CERTIFICATE_SD_MM = 0.002


@dataclass(frozen=True)
class DegradedImage:
    """One picture and its truth. The sensor's and the arm's frame are the block's.

    ``lit``: the laser is on in it. ``made``: the block as truly made. ``visible_edge_share``: share
    of the block's visible edges that the picture shows.
    """

    image: RawImage
    laser_on: bool
    certificate: CrenellatedBlock
    true_block: CrenellatedBlock
    optics: Optics
    nuisances: frozenset[str]
    visible_share: float


def draw_degraded_image(seed: int) -> DegradedImage:
    """A picture for a seed, of all that may happen to one."""
    rng = np.random.default_rng((seed, 20_061))
    spoilt = frozenset(name for name, share in NUISANCES.items() if rng.uniform() < share)
    certificate = draw_workshop_block(rng)
    made = draw_true_block(certificate, CERTIFICATE_SD_MM, rng)
    size = SENSORS_PX[int(rng.choice(len(SENSORS_PX), p=SENSOR_SHARES))]
    while True:
        optics = _optics(made, size, spoilt, rng)
        scene = SimulatedScene(_draw_objects(made, spoilt, rng), _light(spoilt, rng))
        share = visible_edge_share(scene, optics)
        if share >= USABLE and (share < 0.97 or "cut-off" not in spoilt):
            break
    renderer = Renderer(
        scene, optics, _draw_light_plane(made, rng), _detector(size, spoilt, rng), seed
    )
    brightest = float(np.percentile(renderer.room_light(np.eye(4), RAYS)[::4, ::4], 97))
    exposure = rng.uniform(0.45, 1.5) / max(brightest, 0.05)
    laser = float(rng.uniform(0.5, 1.1)) if "stripe" in spoilt else 0.0
    image = renderer.render(np.eye(4), exposure, laser, RAYS)
    return DegradedImage(image, laser > 0, certificate, made, optics, spoilt, share)


def draw_workshop_block(rng: np.random.Generator) -> CrenellatedBlock:
    """A block of three to six merlons that is not its own mirror image.

    Of any proportions, or, as often, as workshops make them: of one pitch, but for one or two
    of its widths.
    """
    count = int(rng.integers(3, 7))
    widths = _regular_widths(rng, count) if rng.random() < 0.5 else _random_widths(rng, count)
    edges = np.concatenate([[0.0], np.cumsum(widths)]) - np.round(widths.sum() / 2)
    depth = float(np.round(rng.uniform(14.0, 34.0), 1))
    front = -float(np.round(depth * rng.uniform(0.3, 0.7), 1))
    crest = float(np.round(rng.uniform(7.0, 19.0), 1))
    base = -float(np.round(rng.uniform(5.0, 18.0), 1))
    return CrenellatedBlock(
        tuple(round(float(x), 1) for x in edges), front, front + depth, crest, 0.0, base
    )


def _random_widths(rng: np.random.Generator, count: int) -> Floats:
    """Widths of merlons and grooves in turn, mm, that differ by 1.5 from their mirror image."""
    total = rng.uniform(32.0, 60.0)
    while True:
        widths: Floats = np.round(rng.uniform(1.0, 2.6, 2 * count - 1), 1)
        widths = np.round(widths / widths.sum() * total, 1)
        if widths.min() >= 2.5 and np.max(np.abs(widths - widths[::-1])) >= 1.5:
            return widths


def _regular_widths(rng: np.random.Generator, count: int) -> Floats:
    """The same of one pitch, whole mm, but for one or two, which differ by 1 mm or more."""
    while True:
        merlon, groove = rng.integers(4, 10, 2)
        even = np.arange(2 * count - 1) % 2 == 0
        widths: Floats = np.where(even, merlon, groove).astype(np.float64)
        odd = rng.choice(len(widths), int(rng.integers(1, 3)), replace=False)
        widths[odd] += rng.choice([-2.0, -1.0, 1.0, 2.0, 3.0], len(odd))
        apart = np.max(np.abs(widths - widths[::-1]))
        if widths.min() >= 3.0 and widths.sum() <= 60.0 and apart >= 1.0:
            return widths


def _block_bounds(comb: CrenellatedBlock) -> tuple[Floats, Floats]:
    """Lowest and highest corner (3,) of the block."""
    x = comb.edges_x_mm
    low = np.array([x[0], comb.front_y_mm, comb.base_z_mm])
    return low, np.array([x[-1], comb.back_y_mm, comb.crest_z_mm])


def _optics(
    comb: CrenellatedBlock, size: tuple[int, int], spoilt: frozenset[str], rng: np.random.Generator
) -> Optics:
    """A camera that looks at the block from its front and above."""
    low, high = _block_bounds(comb)
    azimuth, elevation = rng.uniform(-0.6, 0.6), rng.uniform(0.45, 1.2)
    flat = np.cos(elevation)
    away = np.array([np.sin(azimuth) * flat, -np.cos(azimuth) * flat, np.sin(elevation)])
    middle = (low + high) / 2
    roll = rng.uniform(-np.pi, np.pi) if "rolled" in spoilt else rng.normal(0.0, 0.08)
    eye = middle + rng.uniform(2.2, 5.0) * float(np.linalg.norm(high - low)) * away
    T = camera_looking_at(eye, middle + rng.normal(0.0, 1.0, 3), np.array([1.0, 0.0, 0.0]), roll)
    box = np.array([np.where(np.array(bits), high, low) for bits in np.ndindex(2, 2, 2)])
    in_cam = box @ T[:3, :3].T + T[:3, 3]
    width, height = size
    reach = np.abs(in_cam[:, :2] / in_cam[:, 2:]).max(axis=0)
    cut = "cut-off" in spoilt
    fill = rng.uniform(0.6, 1.3) if cut else rng.uniform(0.5, 0.9)
    focal = fill * 0.5 * float(np.min(np.array(size) / reach))
    aside = rng.normal(0.0, 0.25 if cut else 0.02, 2) * size
    if cut:
        # The camera is aimed past the block; its lens stays centred.
        direction = np.array([aside[0] / focal, aside[1] / focal, 1.0]) @ T[:3, :3]
        T = camera_looking_at(eye, eye + 100.0 * direction, T[0, :3], 0.0)
        aside = rng.normal(0.0, 0.02, 2) * size
    return Optics(
        width,
        height,
        focal,
        focal * (1 + float(rng.normal(0.0, 2e-4))),
        (width - 1) / 2 + float(aside[0]),
        (height - 1) / 2 + float(aside[1]),
        (float(rng.uniform(-0.1, 0.05)), 0.0, 0.0, 0.0, 0.0),
        T,
    )


def _light_direction(spoilt: frozenset[str], rng: np.random.Generator) -> Floats:
    """Unit vector (3,) to the light, which is above; for equal faces half-way between two."""
    if "equal-faces" in spoilt:
        side = float(rng.choice([-1.0, 1.0]))
        other = rng.uniform(0.1, 0.9)
        found = np.array(
            [(side * other, -1.0, 1.0), (side, -other, 1.0), (side, -1.0, other)][rng.integers(3)]
        )
    else:
        around, up = rng.uniform(-np.pi, np.pi), rng.uniform(0.5, 1.4)
        found = np.array([np.sin(around) * np.cos(up), -np.cos(around) * np.cos(up), np.sin(up)])
    return np.asarray(found / np.linalg.norm(found))


def _light(spoilt: frozenset[str], rng: np.random.Generator) -> Light:
    towards = _light_direction(spoilt, rng)
    light = Light(
        (float(towards[0]), float(towards[1]), float(towards[2])),
        directed=float(rng.uniform(0.4, 0.9)),
        ambient=float(rng.uniform(0.15, 0.5)),
        groove_shade=0.0 if "equal-faces" in spoilt else float(rng.uniform(0.0, 0.8)),
        texture=float(rng.uniform(0.003, 0.03)),
    )
    if not spoilt & {"uneven-light", "shadows", "highlights"}:
        return light
    far = rng.uniform(80.0, 250.0) if "uneven-light" in spoilt else rng.uniform(400.0, 900.0)
    x, y, z = (float(value) for value in towards * far)
    radius = float(rng.uniform(0.0, 0.15) * far) if "shadows" in spoilt else 0.25 * far
    return replace(light, lamp_mm=(x, y, z), lamp_radius_mm=radius)


def _finish(spoilt: frozenset[str], rng: np.random.Generator) -> SurfaceFinish:
    return SurfaceFinish(
        float(rng.uniform(0.2, 1.2)) if "highlights" in spoilt else 0.0,
        float(np.exp(rng.uniform(np.log(8.0), np.log(150.0)))),
        float(rng.uniform(0.03, 0.15)) if "tool-marks" in spoilt else 0.0,
        float(rng.uniform(0.08, 0.4)),
    )


def _draw_objects(
    comb: CrenellatedBlock, spoilt: frozenset[str], rng: np.random.Generator
) -> tuple[SceneObject, ...]:
    """The block, what it stands on, and what lies about and over it."""
    low, high = _block_bounds(comb)
    things = [SceneObject("block", comb, np.eye(4), 1.0, _finish(spoilt, rng))]
    ground = translation(0.0, 0.0, comb.base_z_mm - 0.01)
    if rng.uniform() < 0.85:
        slab = Box((-900.0, -900.0, -30.0), (900.0, 900.0, 0.0))
        albedo = float(np.exp(rng.uniform(np.log(0.04), np.log(1.1))))
        turned = ground @ rotation_about("z", float(rng.uniform(-np.pi, np.pi)))
        things.append(SceneObject("table", slab, turned, albedo, _finish(spoilt, rng)))
    half = float(np.linalg.norm(high[:2] - low[:2])) / 2
    middle = (low + high) / 2
    for _ in range(int(rng.integers(1, 6)) if "clutter" in spoilt else 0):
        shape, radius, lift = _clutter(rng)
        bearing = rng.uniform(-np.pi, np.pi)
        away = half + radius + rng.uniform(1.0, 35.0)
        place = translation(
            float(middle[0] + away * np.sin(bearing)),
            float(middle[1] - away * np.cos(bearing)),
            lift,
        )
        turn = rotation_about("z", float(rng.uniform(-np.pi, np.pi)))
        albedo = float(rng.uniform(0.1, 1.2))
        things.append(
            SceneObject("clutter", shape, ground @ place @ turn, albedo, _finish(spoilt, rng))
        )
    if "covered" in spoilt:
        bar = Box(
            (-70.0, -float(rng.uniform(0.5, 2.0)), 0.5), (70.0, float(rng.uniform(0.5, 2)), 3)
        )
        at = translation(
            float(rng.uniform(low[0], high[0])), float(rng.uniform(low[1], high[1])), high[2]
        )
        turn = rotation_about("z", float(rng.uniform(-np.pi, np.pi)))
        things.append(SceneObject("bar", bar, at @ turn, float(rng.uniform(0.1, 1.2))))
    return tuple(things)


def _clutter(rng: np.random.Generator) -> tuple[ObjectShape, float, float]:
    """A thing from the bench: its shape, the circle it needs, and its frame's height above it."""
    kind = int(rng.integers(4))
    if kind == 0:
        other = draw_workshop_block(rng)
        low, high = _block_bounds(other)
        return other, float(np.hypot(*np.abs([low, high]).max(axis=0)[:2])), -other.base_z_mm
    if kind == 1:
        ball = GaugeSphere(float(rng.uniform(4.0, 15.0)))
        return ball, ball.radius_mm, ball.radius_mm
    long = rng.uniform(30.0, 120.0) if kind == 2 else rng.uniform(8.0, 40.0)
    wide = rng.uniform(3.0, 10.0) if kind == 2 else rng.uniform(8.0, 40.0)
    tall = rng.uniform(2.0, 12.0) if kind == 2 else rng.uniform(5.0, 40.0)
    a, b, c = float(long / 2), float(wide / 2), float(tall)
    return Box((-a, -b, 0.0), (a, b, c)), float(np.hypot(a, b)), 0.0


def _draw_light_plane(comb: CrenellatedBlock, rng: np.random.Generator) -> LightPlane:
    """A laser across the merlons."""
    low, high = _block_bounds(comb)
    normal = np.array([0.0, 1.0, 0.0]) + rng.normal(0.0, [0.15, 0.0, 0.1], 3)
    middle = (low + high) / 2
    point = middle + np.array([0.0, rng.uniform(-0.3, 0.3) * (high[1] - low[1]), 0.0])
    lamp = point + np.array([0.0, 0.0, 2.5 * float(np.linalg.norm(high - low))])
    return replace(light_plane_through(normal, point, lamp), half_angle_rad=0.4)


def _detector(size: tuple[int, int], spoilt: frozenset[str], rng: np.random.Generator) -> Detector:
    soft = rng.uniform(0.0006, 0.0016) * size[0] if "defocus" in spoilt else 0.0
    return Detector(
        haze_dn=float(rng.uniform(0.0, 30.0)),
        read_dn=float(rng.uniform(3.0, 7.0) if "noise" in spoilt else rng.uniform(0.5, 2.0)),
        shot_dn=float(rng.uniform(0.01, 0.08)),
        blur_px=float(max(soft, rng.uniform(0.5, 0.9))),
        bits=int(rng.choice([10, 12, 16])) if "deep-bits" in spoilt else 8,
    )


def visible_edge_share(scene: SimulatedScene, optics: Optics) -> float:
    """Share of the block's visible edges that is in the picture and uncovered.

    The block is the scene's first thing, in whose frame the camera's pose is given.
    """
    comb = scene.objects[0].shape
    assert isinstance(comb, CrenellatedBlock)
    points = _edge_points(comb)
    kinds, rows = shape_rows(scene)
    T = np.linalg.inv(optics.T_cam_sensor)
    into = np.stack([np.linalg.inv(thing.T_arm_obj) @ T for thing in scene.objects])
    eyes = ray_bundle(into, rows, np.zeros(3))
    in_cam = points @ optics.T_cam_sensor[:3, :3].T + optics.T_cam_sensor[:3, 3]
    pixels = to_pixels(optics, points)
    own = first_hits(kinds[:1], rows[:1], eyes[:1], in_cam) >= 1 - 1e-6
    uncovered = first_hits(kinds, rows, eyes, in_cam) > 1 - 1e-6
    within = np.all((pixels > 0) & (pixels < [optics.width_px, optics.height_px]), axis=1)
    return float(np.sum(own & uncovered & within)) / max(float(np.sum(own)), 1.0)


def _edge_points(comb: CrenellatedBlock) -> Floats:
    """(N, 3) points every millimetre or so of all the block's edges, a hair outside of it."""
    x, n = comb.edges_x_mm, len(comb.edges_x_mm)
    y = (comb.front_y_mm, comb.back_y_mm)
    spans = []
    for i in range(n):
        tops = {comb.crest_z_mm, comb.floor_z_mm if 0 < i < n - 1 else comb.base_z_mm}
        spans += [((x[i], y[0], z), (x[i], y[1], z)) for z in tops]
        spans += [((x[i], at, max(tops)), (x[i], at, min(tops))) for at in y]
    for i in range(n - 1):
        z = comb.crest_z_mm if i % 2 == 0 else comb.floor_z_mm
        spans += [((x[i], at, z), (x[i + 1], at, z)) for at in y]
    spans += [((x[0], at, comb.base_z_mm), (x[-1], at, comb.base_z_mm)) for at in y]
    points = []
    for begin, end in np.array(spans):
        count = max(3, round(float(np.linalg.norm(end - begin))))
        points.append(begin + ((np.arange(count) + 0.5) / count)[:, None] * (end - begin))
    return np.vstack(points)
