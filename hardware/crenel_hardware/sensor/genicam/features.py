"""The features of a camera by their names in GenICam, whichever library reaches it.

Source:
    EMVA, GenICam Standard Features Naming Convention (SFNC) 2.7.
"""

from typing import Literal, Protocol

Quantity = Literal["exposure_time", "gain", "frame_rate"]


class FeatureError(Exception):
    """The library or the camera refused a call; the text is that of the library, in English."""


class FeatureCamera(Protocol):
    """An open camera, as the settings need it. Its methods raise ``FeatureError``."""

    def has(self, feature: str) -> bool:
        """Whether a feature exists, and is available now."""

    def choice(self, feature: str) -> str:
        """The present value of an enumeration."""

    def choose(self, feature: str, value: str) -> None:
        """Sets an enumeration, unless it has the value."""

    def choices(self, feature: str) -> list[str]:
        """The values that an enumeration offers now; none if the camera does not have it."""

    def switch(self, feature: str, on: bool) -> None:
        """Sets a boolean."""

    def is_on(self, feature: str) -> bool:
        """The present value of a boolean."""

    def integer(self, feature: str) -> int:
        """The present value of an integer."""

    def set_integer(self, feature: str, value: int) -> None:
        """Sets an integer."""

    def real(self, feature: str) -> float:
        """The present value of a float."""

    def set_real(self, feature: str, value: float) -> None:
        """Sets a float; the camera may round."""

    def offers(self, quantity: Quantity) -> bool:
        """Whether the camera has a quantity, under the name of SFNC or an older one."""

    def quantity(self, quantity: Quantity) -> float:
        """Its present value: exposure in µs, gain in dB, frame rate in Hz."""

    def set_quantity(self, quantity: Quantity, value: float) -> None:
        """Sets it; the camera may round."""

    def bounds(self, quantity: Quantity) -> tuple[float, float]:
        """Its smallest and largest value."""

    def sensor_size(self) -> tuple[int, int]:
        """Width and height in px."""

    def region(self) -> tuple[int, int, int, int]:
        """Offsets x and y, width and height in px."""

    def set_region(self, x: int, y: int, width: int, height: int) -> None:
        """Sets the region of interest."""

    def clear_triggers(self) -> None:
        """Switches all triggers off."""

    def set_packet_size(self, size: int) -> None:
        """Sets the bytes per packet of GigE Vision; without effect on other cameras."""

    def send_parts(self, on: bool) -> bool:
        """Lets a buffer have several components or not; returns whether it now may.

        False, too, of a camera or a library of which that is not known.
        """
