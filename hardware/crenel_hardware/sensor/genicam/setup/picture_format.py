"""Which pictures a camera sends: component, pixel format, region."""

from collections.abc import Sequence
from contextlib import suppress

from crenel.messages.message import Text
from crenel_hardware.sensor.genicam.features import FeatureCamera, FeatureError
from crenel_hardware.sensor.genicam.pixel_formats import FORMATS, PixelFormat
from crenel_hardware.sensor.genicam.setup.refusals import (
    not_offered_error,
    require_offered,
    unknown_format_error,
)
from crenel_hardware.sensor.grey import BayerPattern, LaserColour, require_colour

INTENSITY = "Intensity"
"""The component with the grey picture."""


def select_intensity(camera: FeatureCamera) -> None:
    """Lets the grey picture alone be sent, of the components of a 3D camera."""
    if INTENSITY in camera.choices("ComponentSelector"):
        select_components(camera, [INTENSITY])


def select_components(camera: FeatureCamera, wanted: Sequence[str]) -> None:
    """Lets these components be sent, and no others; the last one of them stays selected."""
    offered = camera.choices("ComponentSelector")
    for component in sorted(offered, key=lambda name: name in wanted):
        camera.choose("ComponentSelector", component)
        with suppress(FeatureError):  # what cannot be switched stays as it is
            camera.switch("ComponentEnable", component in wanted)


def set_pixel_format(
    title: Text,
    camera: FeatureCamera,
    wanted: str | None,
    bayer: BayerPattern | None,
    laser_colour: LaserColour | None,
) -> PixelFormat:
    """The format of the options; else the present one, if it is understood; else the best known."""
    offered = camera.choices("PixelFormat")
    if wanted is not None:
        require_offered(title, "pixel_format", wanted, offered)
    else:
        present = camera.choice("PixelFormat")
        order = list(FORMATS)
        known = sorted((name for name in offered if name in FORMATS), key=order.index)
        wanted = present if present in FORMATS or not known else known[0]
    if wanted not in FORMATS:
        raise unknown_format_error(title, wanted)
    camera.choose("PixelFormat", wanted)
    pixel_format = FORMATS[wanted]
    require_colour(bayer or pixel_format.bayer, laser_colour)
    return pixel_format


def set_region(title: Text, camera: FeatureCamera, region: list[int] | None) -> None:
    """Sets the region of interest, without one the whole sensor."""
    width_px, height_px = camera.sensor_size()
    wanted = (0, 0, width_px, height_px) if region is None else tuple(region)
    x, y, width, height = wanted
    if x + width > width_px or y + height > height_px:
        raise not_offered_error(title, "region", str(region), f"[0, 0, {width_px}, {height_px}]")
    # a camera limits each offset by the present size, and each size by the present offset
    camera.set_region(0, 0, width, height)
    camera.set_region(x, y, width, height)
    found = camera.region()
    if region is not None and found != wanted:
        raise not_offered_error(title, "region", str(region), str(list(found)))
