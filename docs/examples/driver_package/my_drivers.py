"""Drivers for the arm and the camera of ``vendor_sdk``.

``MyArm`` meets ``ArmDriver`` and ``MyCamera`` meets ``SensorDriver`` (crenel_hardware.interfaces).
``pyproject.toml`` registers the two functions at the end, so that ``station.toml`` can name them.
"""

import math
import threading
from collections.abc import Iterator, Mapping, Sequence
from typing import Annotated

import vendor_sdk

from crenel_hardware.clock import now_ns
from crenel_hardware.device_clock import DeviceClock
from crenel_hardware.errors import DeviceError
from crenel_hardware.interfaces import (
    ArmInfo,
    ArmRecord,
    Button,
    ButtonEvent,
    Frame,
    JointSample,
    LinkHealth,
    SensorInfo,
)
from crenel_hardware.options import Options, Shown, read_options

FIRST_PACKET_S = 2.0
BUTTONS = {"trigger": Button.PRIMARY, "red": Button.UNDO, "black": Button.BACK}


class DeviceOptions(Options):
    """The keys of ``[arm]`` and ``[sensor]`` in station.toml, without ``driver``."""

    title = "Vendor arm or camera"
    address: Annotated[str, Shown("Address", "As on the controller's display")]


class MyArm:
    """The arm. Nothing is sent to it before ``open``."""

    def __init__(self, options: DeviceOptions) -> None:
        self._address = options.address
        self._state = threading.Lock()
        self._connection: vendor_sdk.ArmConnection | None = None
        self._clock = DeviceClock()
        self._last: vendor_sdk.ArmPacket | None = None
        self.health = LinkHealth()

    def open(self) -> ArmInfo:
        with self._state:
            if self._connection is None:
                self._connection = self._connect()
                self._clock, self.health = DeviceClock(), LinkHealth()
            arm = self._connection
            return ArmInfo("Vendor arm", arm.serial, arm.joints, arm.rate_hz)

    def _connect(self) -> vendor_sdk.ArmConnection:
        """A connection whose first packet has arrived: it says which buttons are down already."""
        try:
            connection = vendor_sdk.ArmConnection(self._address)
            packets = connection.packets(FIRST_PACKET_S)
        except vendor_sdk.VendorError as error:
            raise DeviceError(
                f"The arm {self._address} does not answer", "Switch it on."
            ) from error
        if not packets:
            connection.close()
            raise DeviceError(f"The arm {self._address} sends nothing", "Switch it off and on.")
        self._last = packets[-1]
        return connection

    def read(self, timeout_s: float) -> Sequence[ArmRecord]:
        connection = self._connection
        if connection is None:
            raise DeviceError(f"The arm {self._address} is not open")
        try:
            packets = connection.packets(timeout_s)
        except vendor_sdk.VendorError as error:
            self._drop(connection)
            raise DeviceError(f"The arm {self._address} was lost", "Check its cable.") from error
        arrival_ns = now_ns()
        for packet in packets:
            self._clock.observe(packet.time_us * 1000, arrival_ns)
        return [record for packet in packets for record in self._records(packet)]

    def close(self) -> None:
        self._drop(self._connection)

    def _drop(self, connection: vendor_sdk.ArmConnection | None) -> None:
        """Closing the connection ends a ``read`` that waits in another thread."""
        with self._state:
            if connection is not None:
                connection.close()
            if self._connection is connection:
                self._connection = None

    def _records(self, packet: vendor_sdk.ArmPacket) -> Iterator[ArmRecord]:
        """The sample, then the buttons that changed since the sample before."""
        last = self._last or packet
        self.health.received += 1
        self.health.lost += max(packet.number - last.number - 1, 0)
        self._last = packet
        stamp_ns = self._clock.stamp(packet.time_us * 1000)
        yield JointSample(packet.number, stamp_ns, tuple(map(math.radians, packet.angles_deg)))
        for name in packet.buttons ^ last.buttons:
            pressed = name in packet.buttons
            yield ButtonEvent(packet.number, stamp_ns, BUTTONS[name], pressed)


class MyCamera:
    """The camera with its laser."""

    def __init__(self, options: DeviceOptions) -> None:
        self._address = options.address
        self._state = threading.Lock()
        self._connection: vendor_sdk.CameraConnection | None = None
        self._clock = DeviceClock()
        self._last = -1
        self.health = LinkHealth()

    def open(self) -> SensorInfo:
        with self._state:
            if self._connection is None:
                try:
                    self._connection = vendor_sdk.CameraConnection(self._address)
                except vendor_sdk.VendorError as error:
                    raise DeviceError(
                        f"The camera {self._address} does not answer", "Check its cable."
                    ) from error
                self._clock, self._last, self.health = DeviceClock(), -1, LinkHealth()
            return SensorInfo(
                name="Vendor camera",
                serial_number=self._connection.serial,
                width_px=vendor_sdk.WIDTH,
                height_px=vendor_sdk.HEIGHT,
                exposure_range_us=self._connection.exposure_range_us,
                has_laser_switch=True,
            )

    def read(self, timeout_s: float) -> Frame | None:
        connection = self._connection
        if connection is None:
            raise DeviceError(f"The camera {self._address} is not open")
        try:
            picture = connection.picture(timeout_s)
        except vendor_sdk.VendorError as error:
            self._drop(connection)
            raise DeviceError(f"The camera {self._address} was lost", "Check its cable.") from error
        if picture is None:
            return None
        self.health.received += 1
        self.health.lost += picture.number - self._last - 1 if self._last >= 0 else 0
        self._last = picture.number
        self._clock.observe(picture.end_us * 1000, now_ns())
        end_ns = self._clock.stamp(picture.end_us * 1000)
        mid_ns = end_ns - round(500 * picture.exposure_us)
        image = picture.pixels.copy()  # the library overwrites its buffer
        return Frame(picture.number, mid_ns, image, picture.exposure_us, picture.laser_on)

    def set_exposure_us(self, exposure_us: float) -> None:
        if (connection := self._connection) is not None:
            shortest, longest = connection.exposure_range_us
            connection.set_exposure(min(max(exposure_us, shortest), longest))

    def set_laser(self, on: bool) -> None:
        if (connection := self._connection) is not None:
            connection.set_laser(on)

    def close(self) -> None:
        self.set_laser(False)
        self._drop(self._connection)

    def _drop(self, connection: vendor_sdk.CameraConnection | None) -> None:
        with self._state:
            if connection is not None:
                connection.close()
            if self._connection is connection:
                self._connection = None


def arm_from_options(options: Mapping[str, object]) -> MyArm:
    return MyArm(read_options(DeviceOptions, options, "arm"))


def sensor_from_options(options: Mapping[str, object]) -> MyCamera:
    return MyCamera(read_options(DeviceOptions, options, "sensor"))
