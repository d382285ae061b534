"""A laser stripe sensor by the numbers of its datasheet: camera and laser plane as designed."""

from dataclasses import dataclass
from typing import Literal

import numpy as np

from crenel.errors import OperationError
from crenel.messages.message import message, quantity
from crenel.metrology.sensor.camera import Camera, project
from crenel.metrology.sensor.laser_plane import LaserPlane
from crenel.metrology.targets.crenellated_block import Crenellated, corners
from crenel.metrology.transforms import Floats

USUAL_ANGLE_DEG = 30.0
"""Between the laser light and the camera's axis, where the datasheet is silent."""
USUAL_K1 = -0.04
"""A lens is not free of distortion, and its first term has to be found."""
SHALLOWEST = 0.05
"""A depth of field below this share of the field of view leaves no grooves to see."""
VOLUME = (13, 9)
"""Points of the measuring range across and along the laser light."""


@dataclass(frozen=True)
class StripeSensor:
    """A sensor: the laser shines along -Z of its frame, the camera looks at the stripe from -Y.

    ``field_of_view_mm`` is the picture's extent along the stripe, at ``standoff_mm`` from camera
    and laser; there is the origin of the sensor frame, in the middle of the ``depth_of_field_mm``
    in which the picture is sharp. ``stripe_axis`` is ``u`` where the stripe has one point in each
    column.
    """

    field_of_view_mm: float
    standoff_mm: float
    depth_of_field_mm: float
    width_px: int
    height_px: int
    stripe_axis: Literal["u", "v"] = "u"
    angle_deg: float = USUAL_ANGLE_DEG

    @property
    def pixels_along(self) -> int:
        """Pixels along the stripe."""
        return self.width_px if self.stripe_axis == "u" else self.height_px

    @property
    def pixel_mm(self) -> float:
        """Size of a pixel in the middle of the range."""
        return self.field_of_view_mm / self.pixels_along


def require_usable_sensor(sensor: StripeSensor) -> None:
    """Refuses numbers that belong to no sensor.

    Raises:
        OperationError: ``sensor-numbers``, with the number that is wrong.
    """
    field, depth = sensor.field_of_view_mm, sensor.depth_of_field_mm
    if depth < SHALLOWEST * field:
        least = quantity(SHALLOWEST * field, "mm", 1)
        raise OperationError(
            "sensor-numbers",
            message("depth-of-field-too-small", depth=quantity(depth, "mm", 1), least=least),
            message("block-needs-depth"),
            message("check-sensor-numbers"),
        )
    if depth >= 2 * sensor.standoff_mm or field > 3 * sensor.standoff_mm:
        raise OperationError(
            "sensor-numbers",
            message(
                "range-too-large-for-standoff",
                depth=quantity(depth, "mm", 1),
                field=quantity(field, "mm", 1),
                standoff=quantity(sensor.standoff_mm, "mm", 1),
            ),
            "",
            message("check-sensor-numbers"),
        )


def nominal_camera(sensor: StripeSensor) -> Camera:
    """The sensor's camera as designed, with its pose in the sensor frame.

    Its lens has the distortion ``USUAL_K1``; its axis goes through the origin.
    """
    angle = np.radians(sensor.angle_deg)
    eye = np.array([0.0, -sensor.standoff_mm * np.tan(angle), sensor.standoff_mm])
    distance_mm = float(np.linalg.norm(eye))
    forward = -eye / distance_mm
    right = np.array([1.0, 0.0, 0.0])
    down = np.cross(forward, right)
    upright = np.stack([right, down, forward])
    rotation = upright if sensor.stripe_axis == "u" else np.stack([down, -right, forward])
    focal_px = sensor.pixels_along * distance_mm / sensor.field_of_view_mm
    middle = (np.array([sensor.width_px, sensor.height_px]) - 1) / 2
    K = np.array([[focal_px, 0.0, middle[0]], [0.0, focal_px, middle[1]], [0.0, 0.0, 1.0]])
    lens = np.array([USUAL_K1, 0.0, 0.0, 0.0, 0.0])
    return Camera(K, rotation, -rotation @ eye, sensor.width_px, sensor.height_px, lens)


def nominal_plane() -> LaserPlane:
    """The laser plane as designed, y = 0 of the sensor frame."""
    return LaserPlane(np.array([0.0, 1.0, 0.0]), 0.0)


def range_points(sensor: StripeSensor) -> Floats:
    """A grid over the measuring range: the laser plane in the depth of field and in the picture.

    Returns:
        (G, 3) mm in the sensor frame, from the left to the right of each depth.
    """
    half = sensor.field_of_view_mm / 2, sensor.depth_of_field_mm / 2
    x, z = (np.linspace(-side, side, count) for side, count in zip(half, VOLUME, strict=True))
    at = np.column_stack([axis.ravel() for axis in np.meshgrid(x, z)])
    points = np.column_stack([at[:, 0], np.zeros(len(at)), at[:, 1]])
    size = np.array([sensor.width_px, sensor.height_px])
    uv = project(nominal_camera(sensor), points)
    return points[((uv > -0.5) & (uv < size - 0.5)).all(axis=1)]


def middle_height_mm(block: Crenellated) -> float:
    """Z of the block's middle between floors and crests, which is held in the sensor's origin."""
    return (block.crest_z_mm + block.floor_z_mm) / 2


def share_of_picture(sensor: StripeSensor, block: Crenellated) -> float:
    """Share of the picture, from its middle to its border, that the block needs.

    The laser plane is y = 0 of the block, and the middle of its grooves in the sensor's origin.
    """
    points = np.array(list(corners(block).values())) - [0.0, 0.0, middle_height_mm(block)]
    half = np.array([sensor.width_px, sensor.height_px]) / 2
    away = np.abs(project(nominal_camera(sensor), points) + 0.5 - half) / half
    return float(away.max())
