"""``sync.json``: the delay between arm and camera."""

from typing import ClassVar

from app.formats.json_document import Document, NotNegative, Number


class Sync(Document):
    """``sync.json``: by how much the arm's stamps are later than the camera's."""

    FORMAT: ClassVar[str] = "crenel/sync"

    delay_ms: Number
    standard_uncertainty_ms: NotNegative
    frames: int
    reversals: int
    seconds: NotNegative
    speed_mm_s: NotNegative
    rms_without_um: NotNegative
    rms_um: NotNegative
    arm_serial: str = ""
    sensor_serial: str = ""
    recording: str = ""

    @property
    def delay_ns(self) -> int:
        return round(self.delay_ms * 1e6)
