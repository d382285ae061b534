"""``sync.json``: the delay between arm and camera, as a pass over a plane determined it."""

from typing import ClassVar

from crenel.formats.json_document import Document, DocumentPart, NotNegative, Number
from crenel.metrology.time_delay.course import DelayCourse, DelayJump


class SyncJump(DocumentPart):
    """A jump of the delay within the pass, where a clock was set."""

    at_s: NotNegative
    """After the first picture of the pass."""
    at_standard_uncertainty_s: NotNegative
    change_ms: Number
    standard_uncertainty_ms: NotNegative
    stamp_ns: int
    """The same by the camera's clock: from then on, the delay is the later one."""
    unclear_ns: tuple[int, int] | None = None
    """Time stamps of the first and last picture whose pose is uncertain because of it."""


class Sync(Document):
    """``sync.json``: by how much the arm's stamps are later than the camera's."""

    FORMAT: ClassVar[str] = "crenel/sync"

    delay_ms: Number
    """At the end of the pass."""
    standard_uncertainty_ms: NotNegative
    unsteadiness_ms: NotNegative = 0.0
    """What of this comes from a delay that varies within the pass."""
    stamp_ns: int = 0
    """The end of the pass, by the camera's clock; matters where the delay drifts."""
    drift_ppm: Number = 0.0
    drift_standard_uncertainty_ppm: NotNegative | None = None
    """Also where no drift was found."""
    jumps: tuple[SyncJump, ...] = ()
    frames: int
    frames_off: int = 0
    """Pictures that do not fit the plane at this delay."""
    frames_unplaced: int = 0
    """Pictures without a reading of the arm at this delay."""
    reversals: int
    seconds: NotNegative
    speed_mm_s: NotNegative
    rms_without_um: NotNegative | None = None
    """Missing where the arm's readings do not reach the pictures without the delay."""
    rms_um: NotNegative
    arm_serial: str = ""
    sensor_serial: str = ""
    recording: str = ""

    @property
    def course(self) -> DelayCourse:
        """The delay at any time stamp of the camera."""
        jumps = [DelayJump(one.stamp_ns, 1e6 * one.change_ms, one.unclear_ns) for one in self.jumps]
        return DelayCourse(
            1e6 * self.delay_ms,
            self.stamp_ns,
            self.drift_ppm,
            tuple(jumps),
            1e6 * self.standard_uncertainty_ms,
            self.drift_standard_uncertainty_ppm or 0.0,
        )
