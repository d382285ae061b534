"""Pictures of the simulated scene, as the simulated sensor takes them.

``Renderer.picture`` is all that others need: where the sensor is, how much of the
room's light and of the laser's, and a frame of digits comes back.
"""

from functools import cached_property
from typing import cast

import cv2
import numpy as np
from numpy.lib.stride_tricks import sliding_window_view

from crenel_hardware.simulator.devices.kinematics import Floats
from crenel_hardware.simulator.rendering.casting import (
    Codes,
    Image,
    cast_room,
    lattice,
    refine_room,
)
from crenel_hardware.simulator.rendering.noise import (
    POOL,
    Detector,
    RawImage,
    digitise,
    empty_image,
    grain_tile,
    speckle,
    speckle_tile,
)
from crenel_hardware.simulator.rendering.striping import band_around, cast_laser, trace_fan
from crenel_hardware.simulator.rendering.tracing import Ints, ray_bundle
from crenel_hardware.simulator.scene.camera import LightPlane, Optics, sight_lines
from crenel_hardware.simulator.scene.world import SimulatedScene, shape_rows

FINE, QUICK, SMEARED = 89, 13, 0
"""Rays over a pixel at an edge: for measuring; while the sensor drifts; and while it moves
so fast that the exposure smears the picture, which is then cast at half its size."""
FAN_RAYS = 1500
LAMP_PLACES = 15
"""Places on a wide lamp; a place in half shadow sees some of them."""
SPARE_RAD = 0.15
"""Added to the field of view and to the laser's fan when things out of sight are left out."""
SPECKLE_PER_MM = np.array([[23.0, 7.0, 31.0], [11.0, 29.0, 17.0]])
"""Pixels that the speckle wanders as the sensor moves."""


class Renderer:
    """Takes pictures of one scene with one sensor. Not for two threads at once.

    The last light of the room and of the laser is kept, so that a sensor that
    stands still costs only fresh noise.
    """

    def __init__(
        self,
        scene: SimulatedScene,
        optics: Optics,
        light_plane: LightPlane,
        detector: Detector,
        seed: int = 0,
    ) -> None:
        self.scene, self.optics, self.light_plane, self.detector = (
            scene,
            optics,
            light_plane,
            detector,
        )
        self._rng = np.random.default_rng(seed)
        self._kinds, self._rows = shape_rows(scene)
        self._grain = grain_tile(np.random.default_rng(seed + 1))
        self._speckle = speckle_tile(detector, seed + 2)
        self._lines = sight_lines(optics)
        corner = float(np.arctan(np.linalg.norm(self._lines, axis=2).max()))
        self._view_rad = max(corner, light_plane.half_angle_rad) + SPARE_RAD
        self._allocate(optics.height_px, optics.width_px)
        self._cast: tuple[Floats, Codes, Image] | None = None
        self._room: tuple[Floats, int, Image] | None = None
        self._stripe: tuple[Floats, Image, int, int] | None = None

    def show(self, scene: SimulatedScene) -> None:
        """Takes pictures of another scene from now on."""
        self.scene = scene
        self._kinds, self._rows = shape_rows(scene)
        self._cast = self._room = self._stripe = None

    def _allocate(self, height: int, width: int) -> None:
        self._pool = np.empty(POOL + width, dtype=np.float32)
        self._rng.standard_normal(out=self._pool[:POOL], dtype=np.float32)
        self._pool[POOL:] = self._pool[:width]
        dark = empty_image(1, POOL + width, self.detector)
        start = np.zeros(1, dtype=np.int64)
        unlit = np.zeros_like(self._pool)[None]
        digitise(unlit, 0.0, 0.0, self.detector, self._pool, start, dark)
        self._dark_rows = sliding_window_view(dark[0], width)
        self._laser_codes = np.full((height, width), -2, dtype=np.int32)
        self._laser_offs = np.zeros((height, width), dtype=np.float32)
        self._laser_light = np.zeros((height, width), dtype=np.float32)
        self._band = np.zeros((height, width), dtype=np.int32)

    def _visible_objects(self, T_arm_sensor: Floats) -> tuple[Ints, Floats, Floats]:
        """Kinds, rows, and (K, 4, 4) the camera's frame into each thing's.

        Only of things that the camera may see or that may stand in the laser's way; of all
        where a lamp may cast their shadows into view.
        """
        T_arm_cam = T_arm_sensor @ np.linalg.inv(self.optics.T_cam_sensor)
        into = [np.linalg.inv(thing.T_arm_obj) @ T_arm_cam for thing in self.scene.objects]
        _, emitter, _, _ = self._light_plane_in_camera
        middle = np.array([0.0, 0.0, np.linalg.norm(self.optics.centre_mm)])
        near = []
        for k, (T, row) in enumerate(zip(into, self._rows, strict=True)):
            centre = T[:3, :3].T @ (row[:3] - T[:3, 3])
            eyes = (np.zeros(3), emitter)
            if self.scene.light.lamp_mm or any(
                _off_axis_rad(eye, middle, centre, row[3]) < self._view_rad for eye in eyes
            ):
                near.append(k)
        return self._kinds[near], self._rows[near], np.stack([into[k] for k in near])

    def _lamp_bundles(self, into: Floats, rows: Floats) -> Floats:
        """(M, K, 16) of places on the room's lamp, fifteen on a wide one; none for light from afar.

        They lie on a disc that faces the sensor frame's origin.
        """
        light, T = self.scene.light, self.optics.T_cam_sensor
        if light.lamp_mm is None:
            return np.empty((0, len(rows), 16))
        at = T[:3, :3] @ np.array(light.lamp_mm) + T[:3, 3]
        towards = (T[:3, 3] - at) / np.linalg.norm(T[:3, 3] - at)
        side = np.linalg.svd(towards[None])[2][1:]
        count = LAMP_PLACES if light.lamp_radius_mm > 0 else 1
        turn = np.arange(count) * np.pi * (3.0 - np.sqrt(5.0))
        radius = light.lamp_radius_mm * np.sqrt(np.arange(count) / count)
        places = at + (radius * np.stack([np.cos(turn), np.sin(turn)])).T @ side
        return np.stack([ray_bundle(into, rows, place) for place in places])

    def room_light(self, T_arm_sensor: Floats, rays: int = FINE) -> Image:
        """(H, W) light of the room with 1 for a bright face, lens blur included, no noise."""
        kept = self._room
        if kept is not None and kept[1] >= rays and np.array_equal(kept[0], T_arm_sensor):
            return kept[2]
        kinds, rows, into = self._visible_objects(T_arm_sensor)
        eyes = ray_bundle(into, rows, np.zeros(3))
        light = self.scene.light
        towards = np.array(light.direction) / np.linalg.norm(light.direction)
        in_cam = self.optics.T_cam_sensor[:3, :3] @ towards
        lights = np.ascontiguousarray(into[:, :3, :3] @ in_cam)
        away_mm = float(np.linalg.norm(light.lamp_mm or 0.0))
        look = np.array([light.directed, light.ambient, light.groove_shade, light.texture, away_mm])
        lamps = self._lamp_bundles(into, rows)
        lines = self._lines if rays > SMEARED else np.ascontiguousarray(self._lines[::2, ::2])
        codes, wide = self._cast_buffers(T_arm_sensor, lines.shape[:2])
        scene = (kinds, rows, eyes, lights, lamps, look, self._grain, codes, wide)
        if self._cast is None:
            cast_room(lines, *scene)
            self._cast = (T_arm_sensor.copy(), codes, wide)
        if rays > SMEARED:
            refine_room(lines, lattice(rays), *scene)
            image = self._blur(wide)[1:-1, 1:-1].copy()
        else:
            height, width = self._lines.shape[:2]
            half = np.array([[0.5, 0.0, 0.0], [0.0, 0.5, 0.0]])
            flags = cv2.INTER_LINEAR | cv2.WARP_INVERSE_MAP
            whole = cv2.warpAffine(
                wide, half, (width, height), flags=flags, borderMode=cv2.BORDER_REPLICATE
            )
            image = cast(Image, whole)[1:-1, 1:-1].copy()
        self._room = (T_arm_sensor.copy(), rays, image)
        return image

    def _cast_buffers(self, T_arm_sensor: Floats, shape: tuple[int, ...]) -> tuple[Codes, Image]:
        """Codes and light of one ray a pixel: those of before where the sensor has not moved,
        which a finer picture only refines; else empty, and ``_cast`` is None."""
        kept = self._cast
        if kept is not None and kept[1].shape == shape and np.array_equal(kept[0], T_arm_sensor):
            return kept[1:]
        self._cast = None
        return np.empty(shape, dtype=np.int32), np.empty(shape, dtype=np.float32)

    def laser_light(self, T_arm_sensor: Floats) -> tuple[Image, int, int]:
        """(H, W) light of the laser, peak about 1, blur and speckle included, no noise.

        Also the rows from, to (excluded) that any of it falls on.
        """
        kept = self._stripe
        if kept is not None and np.array_equal(kept[0], T_arm_sensor):
            return kept[1:]
        kinds, rows, into = self._visible_objects(T_arm_sensor)
        fan, emitter, light_plane, lens = self._light_plane_in_camera
        eyes, lamps = ray_bundle(into, rows, np.zeros(3)), ray_bundle(into, rows, emitter)
        shapes = (kinds, rows)
        angles = np.linspace(
            -self.light_plane.half_angle_rad, self.light_plane.half_angle_rad, FAN_RAYS
        )
        landed = np.empty((8 * FAN_RAYS, 5))
        ray_count = trace_fan(angles, fan, emitter, light_plane, lens, *shapes, lamps, landed)
        count = band_around(landed[:ray_count], self._laser_codes, self._band)
        marked = self._band.reshape(-1)[:count]
        light = self._laser_light
        light[:] = 0.0
        cast_laser(
            self._lines,
            marked,
            lattice(55),
            lattice(5),
            emitter,
            light_plane,
            *shapes,
            eyes,
            lamps,
            self._laser_codes,
            self._laser_offs,
            light,
        )
        self._laser_codes.reshape(-1)[marked] = -2
        height, width = light.shape
        first, last = 0, 0
        if count:
            first = max(int(marked.min()) // width - 4, 0)
            last = min(int(marked.max()) // width + 5, height)
            light[first:last] = self._blur(light[first:last])
            shift = SPECKLE_PER_MM @ T_arm_sensor[:3, 3]
            speckle(light[first:last], self._speckle, int(shift[0]) + first, int(shift[1]))
        self._stripe = (T_arm_sensor.copy(), light, first, last)
        return light, first, last

    def _blur(self, image: Image) -> Image:
        sigma = self.detector.blur_px
        if sigma <= 0:
            return image
        size = 2 * int(np.ceil(4 * sigma)) + 1
        return cast(Image, cv2.GaussianBlur(image, (size, size), sigma))

    @cached_property
    def _light_plane_in_camera(self) -> tuple[Floats, Floats, Floats, Floats]:
        """In the camera's frame: fan's middle and side (2, 3), emitter, plane (5,), lens (9,)."""
        T, light_plane = self.optics.T_cam_sensor, self.light_plane
        normal = T[:3, :3] @ np.array(light_plane.normal)
        offset = light_plane.offset_mm + float(normal @ T[:3, 3])
        emitter = T[:3, :3] @ np.array(light_plane.emitter_mm) + T[:3, 3]
        down = np.array([0.0, 0.0, -1.0]) + light_plane.normal[2] * np.array(light_plane.normal)
        down /= np.linalg.norm(down)
        side = np.cross(light_plane.normal, down)
        fan = np.stack([down, side]) @ T[:3, :3].T
        return (
            np.ascontiguousarray(fan),
            emitter,
            np.array([*normal, offset, light_plane.sigma_mm]),
            self.optics.lens,
        )

    def render(
        self,
        T_arm_sensor: Floats,
        room: float = 1.0,
        laser: float = 0.0,
        rays: int = FINE,
    ) -> RawImage:
        """A frame (H, W) with noise.

        Args:
            T_arm_sensor: (4, 4) where the sensor truly is.
            room: the room's light times exposure; 1 is nominal, 0 is dark.
            laser: the laser's light times exposure.
            rays: over a pixel at an edge, ``FINE``, ``QUICK`` or ``SMEARED``, or 21, 34, 55, 144.
        """
        detector = self.detector
        height, width = self.optics.height_px, self.optics.width_px
        out = empty_image(height, width, detector)
        offsets = self._rng.integers(0, POOL, height)
        first, last, light = 0, 0, self._laser_light
        if laser > 0:
            light, first, last = self.laser_light(T_arm_sensor)
        stripe_dn = laser * detector.stripe_dn
        if room > 0:
            total, gain = self.room_light(T_arm_sensor, rays), room * detector.crest_dn
            if last > first:
                total = total.copy()
                total[first:last] += light[first:last] * np.float32(stripe_dn / gain)
            digitise(total, gain, room * detector.haze_dn, detector, self._pool, offsets, out)
            return out
        out[:first] = self._dark_rows[offsets[:first]]
        out[last:] = self._dark_rows[offsets[last:]]
        lit, starts = slice(first, last), offsets[first:last]
        digitise(light[lit], stripe_dn, 0.0, detector, self._pool, starts, out[lit])
        return out


def _off_axis_rad(eye: Floats, target: Floats, centre: Floats, radius: float) -> float:
    """Angle in rad between the line from an eye to a target and the nearest of a ball."""
    line, way = target - eye, centre - eye
    distance = float(np.linalg.norm(way))
    if distance <= radius:
        return 0.0
    cosine = float(line @ way) / float(np.linalg.norm(line)) / distance
    return float(np.arccos(np.clip(cosine, -1.0, 1.0)) - np.arcsin(radius / distance))
