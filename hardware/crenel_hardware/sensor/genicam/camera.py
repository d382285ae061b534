"""One camera, opened through Aravis: its features, its registers, its control."""

import socket
import threading
from ctypes import byref, c_char, c_double, c_int, c_uint32
from dataclasses import dataclass
from typing import Any

from crenel.messages.message import Text, message
from crenel_hardware.errors import DeviceError
from crenel_hardware.sensor.genicam.aravis import Aravis, AravisError, load_aravis
from crenel_hardware.sensor.genicam.features import Quantity
from crenel_hardware.sensor.genicam.gige_vision.control_register import read_control

GIGE_VISION, USB3_VISION = "GigEVision", "USB3Vision"
_NEVER_ADJUST = 0
_LISTING = threading.Lock()
_NEEDED_FEATURES = ("Width", "Height", "PixelFormat", "AcquisitionStart")
HEARTBEAT_TIMEOUT_REGISTER = 0x0938
"""GigE Vision 2.0, section 28 (bootstrap registers)."""


@dataclass(frozen=True, slots=True)
class ListedCamera:
    """A camera that answered a search."""

    device_id: str
    """The name by which Aravis opens it."""
    protocol: str
    vendor: str
    model: str
    serial_number: str
    address: str
    """The IP address of a GigE Vision camera."""


def list_cameras(aravis: Aravis) -> list[ListedCamera]:
    """Searches all networks and USB; takes about a second."""
    with _LISTING:
        aravis.call("arv_update_device_list")
        return [
            ListedCamera(
                *(
                    (aravis.call(f"arv_get_device_{name}", index) or b"").decode("utf-8", "replace")
                    for name in ("id", "protocol", "vendor", "model", "serial_nbr", "address")
                )
            )
            for index in range(aravis.call("arv_get_n_devices"))
        ]


class AravisCamera:
    """An open camera, a ``FeatureCamera``; for any thread. Its methods raise ``AravisError``."""

    def __init__(self, aravis: Aravis, handle: int, address: str) -> None:
        self.aravis = aravis
        self.handle = handle
        self.address = address
        """The IP address of a GigE Vision camera; empty for others."""
        self.device: int = aravis.call("arv_camera_get_device", handle)
        self.is_gige = bool(aravis.call("arv_camera_is_gv_device", handle))
        self._lock = threading.RLock()
        self._closed = False

    def call(self, name: str, *arguments: Any) -> Any:
        """Calls ``arv_camera_NAME`` on this camera."""
        return self._call_open(f"arv_camera_{name}", self.handle, *arguments)

    def _call_open(self, name: str, *arguments: Any) -> Any:
        with self._lock:
            if self._closed:
                raise AravisError("the camera is closed")
            return self.aravis.call(name, *arguments)

    def text(self, name: str) -> str:
        """The result of ``arv_camera_NAME``, a text; empty if the camera does not have it."""
        try:
            return (self.call(name) or b"").decode("utf-8", "replace")
        except AravisError:
            return ""

    def has(self, feature: str) -> bool:
        return bool(self.call("is_feature_available", feature.encode()))

    def choice(self, feature: str) -> str:
        return (self.call("get_string", feature.encode()) or b"").decode("utf-8", "replace")

    def choose(self, feature: str, value: str) -> None:
        if self.choice(feature) != value:  # what is fixed cannot be set to what it is
            self.call("set_string", feature.encode(), value.encode())

    def choices(self, feature: str) -> list[str]:
        with self._lock:
            return self.aravis.entries(self.handle, feature) if self.has(feature) else []

    def integer(self, feature: str) -> int:
        return int(self.call("get_integer", feature.encode()))

    def switch(self, feature: str, on: bool) -> None:
        self.call("set_boolean", feature.encode(), on)

    def is_on(self, feature: str) -> bool:
        return bool(self.call("get_boolean", feature.encode()))

    def set_integer(self, feature: str, value: int) -> None:
        self.call("set_integer", feature.encode(), value)

    def real(self, feature: str) -> float:
        return float(self.call("get_float", feature.encode()))

    def set_real(self, feature: str, value: float) -> None:
        self.call("set_float", feature.encode(), value)

    def offers(self, quantity: Quantity) -> bool:
        return bool(self.call(f"is_{quantity}_available"))

    def quantity(self, quantity: Quantity) -> float:
        return float(self.call(f"get_{quantity}"))

    def set_quantity(self, quantity: Quantity, value: float) -> None:
        self.call(f"set_{quantity}", value)

    def bounds(self, quantity: Quantity) -> tuple[float, float]:
        least, most = c_double(), c_double()
        self.call(f"get_{quantity}_bounds", byref(least), byref(most))
        return least.value, most.value

    def sensor_size(self) -> tuple[int, int]:
        width, height = c_int(), c_int()
        self.call("get_sensor_size", byref(width), byref(height))
        return width.value, height.value

    def region(self) -> tuple[int, int, int, int]:
        x, y, width, height = (c_int() for _ in range(4))
        self.call("get_region", byref(x), byref(y), byref(width), byref(height))
        return x.value, y.value, width.value, height.value

    def set_region(self, x: int, y: int, width: int, height: int) -> None:
        self.call("set_region", x, y, width, height)

    def clear_triggers(self) -> None:
        self.call("clear_triggers")

    def set_packet_size(self, size: int) -> None:
        if self.is_gige:
            self._call_open("arv_gv_device_set_packet_size_adjustment", self.device, _NEVER_ADJUST)
            self.call("gv_set_packet_size", size)

    def send_parts(self, on: bool) -> bool:
        possible = self.is_gige and self.aravis.has("arv_camera_gv_set_multipart")
        if not possible or not self.call("gv_is_multipart_supported"):
            return False
        self.call("gv_set_multipart", on)
        return on

    @property
    def has_control(self) -> bool:
        """False if another program controls the camera, as far as Aravis knows."""
        return not self.is_gige or bool(
            self.aravis.call("arv_gv_device_is_controller", self.device)
        )

    def read_heartbeat_timeout(self) -> int:
        """The register of a GigE Vision camera, in ms."""
        value = c_uint32()
        self._call_open(
            "arv_device_read_register", self.device, HEARTBEAT_TIMEOUT_REGISTER, byref(value)
        )
        return value.value

    def write_heartbeat_timeout(self, timeout_ms: int) -> None:
        self.write_register(HEARTBEAT_TIMEOUT_REGISTER, timeout_ms)

    def write_register(self, address: int, value: int) -> None:
        """A register of 32 bits of a GigE Vision camera."""
        self._call_open("arv_device_write_register", self.device, address, value)

    def read_wide_register(self, address: int) -> int:
        """A number of 64 bits in two registers of a GigE Vision camera."""
        value = (c_char * 8)()
        self._call_open("arv_device_read_memory", self.device, address, 8, value)
        return int.from_bytes(value.raw, "big")

    def read_first_bytes(self) -> None:
        """Reads the version at the beginning of the register map, which every camera has."""
        version = (c_char * 4)()
        self._call_open("arv_device_read_memory", self.device, 0, 4, version)

    def close(self) -> None:
        """Gives the camera up; idempotent. Aravis waits some seconds for one that is gone."""
        with self._lock:
            if self._closed:
                return
            self._closed = True
        self.aravis.call("g_object_unref", self.handle)


def open_camera(title: Text, address: str | None, serial_number: str | None) -> AravisCamera:
    """Opens the camera at an address; or with a serial number; or the first one that is found.

    With an address, nothing is sent to any other device.

    Raises:
        DeviceError: Aravis is missing, no such camera answers, another program controls it, or it
            has no pictures.
    """
    aravis = load_aravis()
    device_id = address
    if device_id is None:
        listed = _find(title, list_cameras(aravis), serial_number)
        address = listed.address if listed.protocol == GIGE_VISION else ""
        device_id = address or listed.device_id
    handle = _connect(title, aravis, device_id, address)
    camera = AravisCamera(aravis, handle, address or "")
    try:
        _require_usable(title, camera, serial_number)
    except BaseException:
        camera.close()
        raise
    return camera


def _connect(title: Text, aravis: Aravis, device_id: str, address: str | None) -> int:
    """The handle of a camera.

    Aravis takes up to 5 s to fail, and does not say why: a camera with an address is asked first.
    One that answers, and obeys nobody, did not answer Aravis in time: it is opened again, once.
    """
    if address:
        _require_free(title, address)
    try:
        return _new_handle(aravis, device_id)
    except AravisError:
        if address:
            _require_free(title, address)
    try:
        return _new_handle(aravis, device_id)
    except AravisError as error:
        if address:
            _require_free(title, address)
        raise DeviceError(
            message("camera-answers-but-does-not-open", title=title, reason=error),
            message("check-network-load-or-power"),
        ) from error


def _new_handle(aravis: Aravis, device_id: str) -> int:
    with _LISTING:
        handle: int = aravis.call("arv_camera_new", device_id.encode())
        return handle


def _require_free(title: Text, address: str) -> None:
    """Raises ``DeviceError`` if no camera answers at an address, or another program controls it."""
    try:
        control = read_control(address)
    except socket.gaierror as error:
        raise DeviceError(
            message("camera-address-not-known", address=address), message("check-sensor-address")
        ) from error
    if control is None:
        raise DeviceError(
            message("no-camera-answers", title=title), message("check-camera-power-cable-network")
        )
    # a program may let no other read the camera's registers, which Aravis needs
    if control:
        raise in_use_error(title)


def _find(title: Text, listed: list[ListedCamera], serial_number: str | None) -> ListedCamera:
    for camera in listed:
        if serial_number in (None, camera.serial_number):
            return camera
    if not listed:
        raise no_camera_error(title)
    names = ", ".join(f"{camera.model} {camera.serial_number}" for camera in listed)
    raise DeviceError(message("no-camera-found", title=title), message("cameras-are", names=names))


def _require_usable(title: Text, camera: AravisCamera, serial_number: str | None) -> None:
    if not camera.has_control:
        raise in_use_error(title)
    if not all(camera.has(feature) for feature in _NEEDED_FEATURES):
        raise DeviceError(
            message("device-without-pictures", title=title), message("check-sensor-address")
        )
    found = camera.text("get_device_serial_number")
    if serial_number is not None and found != serial_number:
        raise DeviceError(
            message("other-serial-number", title=title, found=found, wanted=serial_number),
            message("check-sensor-address"),
        )


def no_camera_error(title: Text) -> DeviceError:
    """The error where no camera, or not the wanted one, is in reach."""
    return DeviceError(
        message("no-camera-found", title=title), message("check-camera-power-cable-network")
    )


def in_use_error(title: Text) -> DeviceError:
    """The error of a camera that another program controls."""
    return DeviceError(
        message("camera-used-by-other-program", title=title),
        message("close-other-program-or-wait"),
    )
