"""The ``pylon`` driver: a camera of Basler through Basler's own library.

For cameras that the driver ``genicam`` does not reach, and for those who want the vendor's support.
The library is proprietary, free of charge, and installed with ``pip install "crenel[pylon]"``. In
station.toml::

    [sensor]
    driver = "pylon"
    serial_number = "22812345"   # optional; without it and address, the first camera found
    address = "192.168.1.30"     # optional, of a GigE Vision camera

The other options are those of ``genicam`` (``crenel_hardware.sensor.genicam.driver``) without
``chunks`` and those of lines. A loss of the camera is noticed when the library notices it: on a
network after its heartbeat, about 3 s.

Source:
    Basler, pylon C++ API reference: ``CInstantCamera``, ``CGrabResultData``.
"""

import threading
import warnings
from collections.abc import Iterator, Mapping, Sequence
from contextlib import contextmanager
from typing import Any

import numpy as np

from crenel.messages.message import Text, message
from crenel_hardware.clock import now_ns
from crenel_hardware.errors import DeviceError, device_lost_error
from crenel_hardware.options import read_options
from crenel_hardware.sensor.genicam.camera import in_use_error, no_camera_error
from crenel_hardware.sensor.genicam.camera_source import ArrivedPicture, CameraSource
from crenel_hardware.sensor.genicam.features import FeatureError
from crenel_hardware.sensor.genicam.node_map import NodeMapCamera
from crenel_hardware.sensor.genicam.profiles.profile_points import NO_IMAGE, ArrivedImage
from crenel_hardware.sensor.genicam.settings import CameraOptions, switch_laser
from crenel_hardware.sensor.genicam.setup.refusals import settings_refusal_error
from crenel_hardware.sensor.grabbing import GrabbingSensor
from crenel_hardware.sensor.grey import require_colour
from crenel_hardware.sensor.image_source import EndOfRecordingError, GrabbedImage, NoImage
from crenel_hardware.shared_options import KnownAddress, PacketSize

_WAIT_MS = 100
_BUFFERS = 32
_NO_BLOCK_ID = 2**64 - 1
_FIRST_WITHIN_S = 5.0


class PylonOptions(CameraOptions):
    """Options of the driver in station.toml."""

    title = message("driver-pylon")
    address: KnownAddress = None
    packet_size: PacketSize = None


def from_options(options: Mapping[str, object]) -> GrabbingSensor:
    """The driver for one ``[sensor]`` table of station.toml; raises ``DeviceError``."""
    read = read_options(PylonOptions, options, "sensor")
    require_colour(read.bayer, read.laser_colour)
    named = read.address or read.serial_number
    title = message("first-basler-camera") if named is None else message("camera", source=named)

    def connect(stop: threading.Event) -> PylonSource:
        return PylonSource(title, read, stop)

    return GrabbingSensor(title, connect, _FIRST_WITHIN_S)


class PylonFeatures(NodeMapCamera):
    """The features of an open camera."""

    def __init__(self, node_map: Any) -> None:
        self._nodes = node_map

    def has(self, feature: str) -> bool:
        with _refusals():
            return bool(self._nodes.GetNode(feature).IsReadable())

    def value(self, feature: str) -> str | float | bool:
        with _refusals():
            value: str | float | bool = self._nodes.GetNode(feature).GetValue()
            return value

    def set_value(self, feature: str, value: str | float | bool) -> None:
        with _refusals():
            self._nodes.GetNode(feature).SetValue(value)

    def limits(self, feature: str) -> tuple[float, float]:
        with _refusals():
            node = self._nodes.GetNode(feature)
            return node.GetMin(), node.GetMax()

    def entries(self, feature: str) -> Sequence[str]:
        with _refusals():
            entries: Sequence[str] = self._nodes.GetNode(feature).GetSettableValues()
            return entries


class PylonSource(CameraSource):
    """An open camera of Basler. Raises ``DeviceError``.

    Args:
        title: the camera in words, for errors.
        stop: an event that is set when ``grab`` must end.
    """

    def __init__(self, title: Text, options: PylonOptions, stop: threading.Event) -> None:
        super().__init__(title, options)
        self._stop = stop
        self._pylon = _load_pylon()
        self._camera: Any = None
        self._is_open = False
        with self.opening(), _refusals():
            self._open(options)
            self._start()

    def _open(self, options: PylonOptions) -> None:
        factory = self._pylon.TlFactory.GetInstance()
        found = [
            each
            for each in factory.EnumerateDevices()
            if options.serial_number in (None, each.GetSerialNumber())
            and (
                options.address is None
                or (each.IsIpAddressAvailable() and each.GetIpAddress() == options.address)
            )
        ]
        if not found:
            raise no_camera_error(self._title)
        info = found[0]
        if not factory.IsDeviceAccessible(info):
            raise in_use_error(self._title)
        self.name = f"{info.GetVendorName()} {info.GetModelName()}"
        self.serial_number = info.GetSerialNumber()
        self._camera = self._pylon.InstantCamera(factory.CreateDevice(info))
        self._camera.Open()
        self._is_open = True

    def _start(self) -> None:
        features = PylonFeatures(self._camera.GetNodeMap())
        self.set_up(features)
        ticks = "GevTimestampTickFrequency"
        self._ticks_hz = int(features.value(ticks)) if features.has(ticks) else 1_000_000_000
        self._camera.MaxNumBuffer.SetValue(_BUFFERS)
        self._camera.StartGrabbing(self._pylon.GrabStrategy_OneByOne)

    def grab(self) -> GrabbedImage | NoImage:
        if self._stop.is_set():
            raise EndOfRecordingError
        try:
            with _refusals():
                result = self._camera.RetrieveResult(_WAIT_MS, self._pylon.TimeoutHandling_Return)
                arrival_ns = now_ns()
                if result.IsValid():
                    try:
                        return self.show(self._complete(result, arrival_ns))
                    finally:
                        result.Release()
        except FeatureError as error:
            self.require_answer()
            raise settings_refusal_error(self._title, error) from error
        self.require_answer()
        return NoImage.SILENCE

    def is_alive(self) -> bool:
        return not self._camera.IsCameraDeviceRemoved()

    def require_answer(self) -> None:
        """Raises ``DeviceError`` if the library has noticed that the camera is gone."""
        if not self.is_alive():
            raise device_lost_error(self._title)

    def release(self) -> None:
        """Switches the laser off, stops the camera and closes it."""
        if not self._is_open:
            return
        self._is_open = False
        try:
            with _refusals():
                if self.has_laser_switch and self.is_alive():
                    switch_laser(PylonFeatures(self._camera.GetNodeMap()), False)
                self._camera.StopGrabbing()
                self._camera.Close()
        except FeatureError:
            return  # it is gone, and the library has nothing left to close

    def _complete(self, result: Any, arrival_ns: int) -> ArrivedPicture:
        whole = bool(result.GrabSucceeded())
        block_id = result.BlockID if result.BlockID != _NO_BLOCK_ID else result.ImageNumber
        ticks = int(result.TimeStamp) if whole else 0
        return ArrivedPicture(
            block_id=int(block_id),
            whole=whole,
            arrival_ns=arrival_ns,
            device_ns=ticks * 1_000_000_000 // self._ticks_hz or None,
            exposure_us=None,
            image=_image(result) if whole else NO_IMAGE,
        )


def _image(result: Any) -> ArrivedImage:
    return ArrivedImage(
        np.frombuffer(result.GetBuffer(), np.uint8),
        int(result.PixelType),
        int(result.Width),
        int(result.Height),
        int(result.PaddingX),
    )


@contextmanager
def _refusals() -> Iterator[None]:
    """Raises ``FeatureError`` in place of the library's exceptions."""
    from pypylon import genicam

    try:
        yield
    except genicam.GenericException as error:
        raise FeatureError(str(error).partition(" : ")[0].strip()) from error


def _load_pylon() -> Any:
    """The library; raises ``DeviceError`` if it is not installed."""
    try:
        with warnings.catch_warnings():
            # its wrapper (SWIG) uses types that Python 3.12 deprecates
            warnings.simplefilter("ignore", DeprecationWarning)
            from pypylon import pylon
    except ImportError as error:
        raise DeviceError(
            message("python-package-missing", package="pypylon"),
            message("install-extra", extra="pylon"),
        ) from error
    return pylon
