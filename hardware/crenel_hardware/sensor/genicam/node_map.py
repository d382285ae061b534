"""The features of a camera in a GenApi node map, as the vendors' libraries hand it out.

Source:
    EMVA, GenICam Standard Features Naming Convention (SFNC) 2.7; the names that end in ``Abs`` are
    those of cameras before SFNC 2.
"""

from abc import ABC, abstractmethod
from collections.abc import Sequence

from crenel_hardware.sensor.genicam.features import Quantity

_NAMES: dict[Quantity, tuple[str, ...]] = {
    "exposure_time": ("ExposureTime", "ExposureTimeAbs"),
    "gain": ("Gain",),
    "frame_rate": ("AcquisitionFrameRate", "AcquisitionFrameRateAbs"),
}


class NodeMapCamera(ABC):
    """A ``FeatureCamera`` whose features are nodes with values.

    A subclass reaches the nodes of one library. All methods raise ``FeatureError``.
    """

    @abstractmethod
    def has(self, feature: str) -> bool: ...

    @abstractmethod
    def value(self, feature: str) -> str | float | bool:
        """The value of a feature: a text of an enumeration or a string, else a number."""

    @abstractmethod
    def set_value(self, feature: str, value: str | float | bool) -> None: ...

    @abstractmethod
    def limits(self, feature: str) -> tuple[float, float]:
        """Smallest and largest value of a number."""

    @abstractmethod
    def entries(self, feature: str) -> Sequence[str]:
        """The values of an enumeration that exists."""

    def choice(self, feature: str) -> str:
        return str(self.value(feature))

    def choose(self, feature: str, value: str) -> None:
        if self.value(feature) != value:  # what is fixed cannot be set to what it is
            self.set_value(feature, value)

    def choices(self, feature: str) -> list[str]:
        return list(self.entries(feature)) if self.has(feature) else []

    def switch(self, feature: str, on: bool) -> None:
        if self.value(feature) != on:
            self.set_value(feature, on)

    def is_on(self, feature: str) -> bool:
        return bool(self.value(feature))

    def integer(self, feature: str) -> int:
        return int(self.value(feature))

    def set_integer(self, feature: str, value: int) -> None:
        self.set_value(feature, value)

    def real(self, feature: str) -> float:
        return float(self.value(feature))

    def set_real(self, feature: str, value: float) -> None:
        self.set_value(feature, value)

    def offers(self, quantity: Quantity) -> bool:
        return any(self.has(name) for name in _NAMES[quantity])

    def quantity(self, quantity: Quantity) -> float:
        return float(self.value(self._name(quantity)))

    def set_quantity(self, quantity: Quantity, value: float) -> None:
        if quantity == "frame_rate" and self.has("AcquisitionFrameRateEnable"):
            self.switch("AcquisitionFrameRateEnable", True)
        self.set_value(self._name(quantity), value)

    def bounds(self, quantity: Quantity) -> tuple[float, float]:
        return self.limits(self._name(quantity))

    def sensor_size(self) -> tuple[int, int]:
        sizes = []
        for size in ("Width", "Height"):
            most = f"{size}Max"
            sizes.append(self.value(most) if self.has(most) else self.limits(size)[1])
        return int(sizes[0]), int(sizes[1])

    def region(self) -> tuple[int, int, int, int]:
        x, y, width, height = (
            int(self.value(name)) if self.has(name) else 0
            for name in ("OffsetX", "OffsetY", "Width", "Height")
        )
        return x, y, width, height

    def set_region(self, x: int, y: int, width: int, height: int) -> None:
        offsets = {"OffsetX": x, "OffsetY": y}
        # each size is limited by the present offset
        for name, offset in offsets.items():
            if self.has(name) and offset == 0:
                self.set_value(name, 0)
        self.set_value("Width", width)
        self.set_value("Height", height)
        for name, offset in offsets.items():
            if self.has(name):
                self.set_value(name, offset)

    def clear_triggers(self) -> None:
        if not self.has("TriggerMode"):
            return
        for trigger in self.choices("TriggerSelector") or [""]:
            if trigger:
                self.choose("TriggerSelector", trigger)
            if self.has("TriggerMode"):
                self.choose("TriggerMode", "Off")

    def set_packet_size(self, size: int) -> None:
        if self.has("GevSCPSPacketSize"):
            self.set_value("GevSCPSPacketSize", size)

    def send_parts(self, on: bool) -> bool:
        return False

    def _name(self, quantity: Quantity) -> str:
        names = _NAMES[quantity]
        return next((name for name in names if self.has(name)), names[0])
