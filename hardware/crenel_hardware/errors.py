"""The error that device drivers raise."""

from crenel.messages.message import Text, message


class DeviceError(Exception):
    """A device could not be opened, or was lost while in use.

    Args:
        what: what happened, naming the device and its address.
        remedy: what to do about it; may be empty.
    """

    def __init__(self, what: Text, remedy: Text = "") -> None:
        self.what = what
        self.remedy = remedy
        super().__init__(what, remedy)

    def __str__(self) -> str:
        """The error as one line of English text, for logs and the console."""
        return f"{str(self.what).rstrip('.')}. {self.remedy!s}".strip()


def device_lost_error(title: Text) -> DeviceError:
    """The error of a device that does not answer any more."""
    return DeviceError(message("device-lost", title=title), message("check-cable-power"))
