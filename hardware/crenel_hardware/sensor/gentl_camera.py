"""The ``gentl`` driver: a camera through its vendor's GenTL producer, with the package Harvesters.

For cameras that the driver ``genicam`` does not reach, such as those on CoaXPress or Camera Link
HS: their vendors deliver a library with the ending ``.cti``, a GenTL producer. Harvesters is
installed with ``pip install "crenel[gentl]"``. In station.toml::

    [sensor]
    driver = "gentl"
    producer = "/opt/vendor/lib/producer.cti"  # optional; else all in GENICAM_GENTL64_PATH
    serial_number = "22812345"   # optional; else the first camera found

The other options are those of ``genicam`` (``crenel_hardware.sensor.genicam.driver``) without
``address``, ``packet_size`` and ``chunks``. Of a camera that sends several components, the
intensity is taken, and of a profile camera that is asked for lines, the rows.

Source:
    EMVA, GenTL 1.6; the documentation of Harvesters 1.4.
"""

import os
import threading
import time
from collections.abc import Iterator, Mapping, Sequence
from contextlib import contextmanager, suppress
from pathlib import Path
from typing import Annotated, Any

import numpy as np
from pydantic import Field

from crenel.messages.message import Text, message
from crenel_hardware.clock import now_ns
from crenel_hardware.errors import DeviceError, device_lost_error
from crenel_hardware.options import Shown, read_options
from crenel_hardware.sensor.genicam.camera import in_use_error, no_camera_error
from crenel_hardware.sensor.genicam.camera_source import ArrivedPicture, CameraSource
from crenel_hardware.sensor.genicam.features import FeatureError
from crenel_hardware.sensor.genicam.node_map import NodeMapCamera
from crenel_hardware.sensor.genicam.pixel_formats import FORMATS, Bytes
from crenel_hardware.sensor.genicam.profiles.profile_points import (
    COORDINATES,
    ArrivedImage,
    choose_image,
)
from crenel_hardware.sensor.genicam.settings import ProfileOptions, switch_laser
from crenel_hardware.sensor.genicam.setup.refusals import (
    settings_refusal_error,
    unknown_format_error,
)
from crenel_hardware.sensor.grabbing import GrabbingSensor
from crenel_hardware.sensor.grey import require_colour
from crenel_hardware.sensor.image_source import EndOfRecordingError, GrabbedImage, NoImage

PRODUCER_PATH = "GENICAM_GENTL64_PATH"
"""Folders with producers, as GenTL 1.6, section 4.2 defines it."""
_WAIT_S = 0.1
_SILENT_S = 0.3
_BUFFERS = 32
_FIRST_WITHIN_S = 5.0
_READABLE = (3, 4)
"""RO and RW of the access modes of GenApi."""


class GentlOptions(ProfileOptions):
    """Options of the driver in station.toml."""

    title = message("driver-gentl")
    producer: Annotated[str | None, Field(min_length=1), Shown(message("option-producer"))] = None


def from_options(options: Mapping[str, object]) -> GrabbingSensor:
    """The driver for one ``[sensor]`` table of station.toml; raises ``DeviceError``."""
    read = read_options(GentlOptions, options, "sensor")
    require_colour(read.bayer, read.laser_colour)
    named = read.serial_number
    title = message("first-gentl-camera") if named is None else message("camera", source=named)

    def connect(stop: threading.Event) -> GentlSource:
        return GentlSource(title, read, stop)

    return GrabbingSensor(title, connect, _FIRST_WITHIN_S)


class GentlFeatures(NodeMapCamera):
    """The features of an open camera."""

    def __init__(self, node_map: Any) -> None:
        self._nodes = node_map

    def has(self, feature: str) -> bool:
        with _refusals():
            found = self._nodes.has_node(feature)
            return found and self._nodes.get_node(feature).get_access_mode() in _READABLE

    def value(self, feature: str) -> str | float | bool:
        with _refusals():
            value: str | float | bool = self._nodes.get_node(feature).value
            return value

    def set_value(self, feature: str, value: str | float | bool) -> None:
        with _refusals():
            self._nodes.get_node(feature).value = value

    def limits(self, feature: str) -> tuple[float, float]:
        with _refusals():
            node = self._nodes.get_node(feature)
            return node.min, node.max

    def entries(self, feature: str) -> Sequence[str]:
        with _refusals():
            entries: Sequence[str] = self._nodes.get_node(feature).symbolics
            return entries


class GentlSource(CameraSource):
    """An open camera. Raises ``DeviceError``.

    Args:
        title: the camera in words, for errors.
        stop: an event that is set when ``grab`` must end.
    """

    def __init__(self, title: Text, options: GentlOptions, stop: threading.Event) -> None:
        super().__init__(title, options)
        self._stop = stop
        self._harvester = _load_harvester()
        self._camera: Any = None
        self._lost = False
        with self.opening(), _refusals():
            self._open(options)
            self._start()

    def _open(self, options: GentlOptions) -> None:
        from genicam import gentl

        for producer in find_producers(options.producer):
            try:
                self._harvester.add_file(str(producer), check_validity=bool(options.producer))
            except OSError as error:
                raise DeviceError(
                    message("gentl-producer-unusable", producer=str(producer), reason=error),
                    message("install-gentl-producer"),
                ) from error
        self._harvester.update()
        found = [
            each
            for each in self._harvester.device_info_list
            if options.serial_number in (None, each.serial_number)
        ]
        if not found:
            raise no_camera_error(self._title)
        about = found[0].property_dict
        self.name = f"{about['vendor']} {about['model']}"
        self.serial_number = about["serial_number"]
        try:
            self._camera = self._harvester.create({"id_": about["id_"]})
        except (gentl.ResourceInUseException, gentl.AccessDeniedException) as error:
            raise in_use_error(self._title) from error

    def _start(self) -> None:
        features = GentlFeatures(self._camera.remote_device.node_map)
        self.set_up(features)
        self._camera.num_buffers = _BUFFERS
        self.start_stream()

    def start_stream(self) -> None:
        with _refusals():
            self._camera.start()
        self._heard_s = time.monotonic()

    def stop_stream(self) -> None:
        with _refusals():
            self._camera.stop()

    def grab(self) -> GrabbedImage | NoImage:
        if self._stop.is_set():
            raise EndOfRecordingError
        try:
            with _refusals():
                buffer = self._fetch()
                if buffer is not None:
                    arrival_ns, self._heard_s = now_ns(), time.monotonic()
                    try:
                        return self.show(self._complete(buffer, arrival_ns))
                    finally:
                        buffer.queue()
        except FeatureError as error:
            self.require_answer()
            raise settings_refusal_error(self._title, error) from error
        if time.monotonic() - self._heard_s > _SILENT_S:
            self.require_answer()
        return NoImage.SILENCE

    def _fetch(self) -> Any:
        """A buffer; None if none came. Harvesters looks up the pixel format in its own table."""
        try:
            return self._camera.try_fetch(timeout=_WAIT_S)
        except KeyError as error:
            code = error.args[0]
            name = f"0x{code:08X}" if isinstance(code, int) else str(code)
            raise unknown_format_error(self._title, name) from error

    def is_alive(self) -> bool:
        try:
            with _refusals():
                self._camera.remote_device.port.read(0, 4)
        except FeatureError:
            return False
        return True

    def require_answer(self) -> None:
        """Reads a register; raises ``DeviceError`` if the camera does not answer."""
        if not self.is_alive():
            self._lost = True
            raise device_lost_error(self._title)
        self._heard_s = time.monotonic()

    def release(self) -> None:
        """Switches the laser off, stops the camera and closes it."""
        camera, self._camera = self._camera, None
        with suppress(FeatureError), _refusals():
            if camera is not None:
                if self.has_laser_switch and not self._lost:
                    switch_laser(GentlFeatures(camera.remote_device.node_map), False)
                camera.stop()
                camera.destroy()
        with suppress(FeatureError), _refusals():
            self._harvester.reset()

    def _complete(self, buffer: Any, arrival_ns: int) -> ArrivedPicture:
        """The rows of a profile, else the first component; incomplete buffers do not come here."""
        raw = np.frombuffer(buffer.module.raw_buffer, np.uint8)
        # no payload, or None in it, is what Harvesters does not understand
        payload = buffer.payload.components if buffer.payload is not None else ()
        components = [one for one in payload if one is not None]
        if not components:
            raise unknown_format_error(self._title, _payload_name(buffer.module))
        image, brightness = choose_image([_image(one, raw) for one in components])
        if not image.code:
            raise unknown_format_error(self._title, components[0].data_format)
        return ArrivedPicture(
            block_id=int(buffer.module.frame_id),
            whole=True,
            arrival_ns=arrival_ns,
            device_ns=_stamp_ns(buffer.module),
            exposure_us=None,
            image=image,
            brightness=brightness,
        )


def _payload_name(module: Any) -> str:
    """The name of a buffer's payload, as GenTL has it."""
    with suppress(FeatureError), _refusals():
        return str(getattr(module.payload_type, "name", module.payload_type))
    return "–"


def _image(component: Any, raw: Bytes) -> ArrivedImage:
    """A component in the bytes of its buffer; its code is 0 if it is not understood."""
    name = component.data_format
    code, _ = COORDINATES.get(name, (FORMATS[name].code if name in FORMATS else 0, ""))
    return ArrivedImage(
        raw[component.data_offset :],
        code,
        int(component.width),
        int(component.height),
        int(component.x_padding),
    )


def find_producers(producer: str | None) -> list[Path]:
    """The producer of the options, else those in the folders of the environment.

    Raises:
        DeviceError: there is none.
    """
    if producer is not None:
        found = [Path(producer)]
    else:
        folders = [
            Path(each) for each in os.environ.get(PRODUCER_PATH, "").split(os.pathsep) if each
        ]
        found = sorted(path for folder in folders for path in folder.glob("*.cti"))
    missing = [path for path in found if not path.is_file()]
    if missing or not found:
        raise DeviceError(
            message("gentl-producer-missing", producer=producer or PRODUCER_PATH),
            message("install-gentl-producer"),
        )
    return found


def _stamp_ns(module: Any) -> int | None:
    """The camera's stamp of a buffer; None if it has none."""
    with suppress(FeatureError), _refusals():
        return int(module.timestamp_ns) or None
    return None


@contextmanager
def _refusals() -> Iterator[None]:
    """Raises ``FeatureError`` in place of the libraries' exceptions."""
    from genicam import genapi, gentl

    try:
        yield
    except (genapi.GenericException, gentl.GenericException) as error:
        raise FeatureError(str(error).strip()) from error


def _load_harvester() -> Any:
    """A harvester without producers; raises ``DeviceError`` if the package is not installed."""
    try:
        from harvesters.core import Harvester
    except ImportError as error:
        raise DeviceError(
            message("python-package-missing", package="harvesters"),
            message("install-extra", extra="gentl"),
        ) from error
    return Harvester()
