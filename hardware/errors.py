"""What a device driver raises."""


class DeviceError(Exception):
    """A device could not be opened, or was lost while in use.

    Args:
        what: what happened, naming the device and its address.
        remedy: what to do about it; may be empty.
    """

    def __init__(self, what: str, remedy: str = "") -> None:
        self.what = what
        self.remedy = remedy
        super().__init__(f"{what.rstrip('.')}. {remedy}".strip())
