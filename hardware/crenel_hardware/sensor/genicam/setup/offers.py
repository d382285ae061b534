"""What a camera offers for the options of its driver: choices, and ranges."""

from collections.abc import Callable, Iterator
from contextlib import suppress

from crenel_hardware.interfaces import OptionOffer
from crenel_hardware.sensor.genicam.features import FeatureCamera, FeatureError, Quantity
from crenel_hardware.sensor.genicam.pixel_formats import FORMATS
from crenel_hardware.sensor.genicam.settings import LONGEST_EXPOSURE_US

_QUANTITIES: tuple[tuple[str, Quantity], ...] = (
    ("exposure_us", "exposure_time"),
    ("gain_db", "gain"),
    ("rate_hz", "frame_rate"),
)
_CHOICES = (
    ("trigger", "TriggerSource"),
    ("laser_line", "LineSelector"),
)


def camera_offers(camera: FeatureCamera) -> tuple[OptionOffer, ...]:
    """What an open camera offers as it is set now; without what it does not say."""
    questions: list[Callable[[FeatureCamera], Iterator[OptionOffer]]] = [
        _pixel_formats,
        _sensor,
        _ranges,
        _choices,
    ]
    found: list[OptionOffer] = []
    for ask in questions:
        with suppress(FeatureError):  # a form without it can be filled in, too
            found.extend(ask(camera))
    return tuple(found)


def _pixel_formats(camera: FeatureCamera) -> Iterator[OptionOffer]:
    names = tuple(name for name in camera.choices("PixelFormat") if name in FORMATS)
    if names:
        yield OptionOffer("pixel_format", choices=names)


def _sensor(camera: FeatureCamera) -> Iterator[OptionOffer]:
    width_px, height_px = camera.sensor_size()
    yield OptionOffer("region", largest=f"0, 0, {width_px}, {height_px}")


def _ranges(camera: FeatureCamera) -> Iterator[OptionOffer]:
    for key, quantity in _QUANTITIES:
        if camera.offers(quantity):
            least, most = camera.bounds(quantity)
            if quantity == "exposure_time":
                most = min(most, LONGEST_EXPOSURE_US)
            yield OptionOffer(key, bounds=(least, most))


def _choices(camera: FeatureCamera) -> Iterator[OptionOffer]:
    for key, feature in _CHOICES:
        names = tuple(camera.choices(feature))
        if names:
            yield OptionOffer(key, choices=names)
