"""The errors of a camera that does not do what the options ask for."""

from collections.abc import Iterator, Sequence
from contextlib import contextmanager

from crenel.messages.message import Text, message
from crenel_hardware.errors import DeviceError
from crenel_hardware.sensor.genicam.features import FeatureError
from crenel_hardware.sensor.genicam.pixel_formats import FORMATS


@contextmanager
def refusals(title: Text) -> Iterator[None]:
    """Raises ``DeviceError`` in place of ``FeatureError``."""
    try:
        yield
    except FeatureError as error:
        raise settings_refusal_error(title, error) from error


def settings_refusal_error(title: Text, error: FeatureError) -> DeviceError:
    """The error of a camera that refuses what is set or asked."""
    return DeviceError(
        message("camera-refused-settings", title=title, reason=error),
        message("check-options-or-restart-camera"),
    )


def require_offered(title: Text, key: str, value: str, offered: Sequence[str]) -> None:
    """Raises ``DeviceError`` unless a value is among those that the camera offers."""
    if value not in offered:
        raise not_offered_error(title, key, value, ", ".join(offered) or "–")


def not_offered_error(title: Text, key: str, value: str, given: str) -> DeviceError:
    """The error of an option that the camera does not offer; ``given`` is what it offers."""
    return DeviceError(
        message("camera-cannot-do", title=title, key=key, value=value, given=given),
        message("correct-sensor-take-out", key=key),
    )


def unknown_format_error(title: Text, name: str) -> DeviceError:
    """The error of a pixel format that the driver does not understand."""
    return DeviceError(
        message("pixel-format-unknown", title=title, name=name),
        message("pixel-formats-are", names=", ".join(FORMATS)),
    )
