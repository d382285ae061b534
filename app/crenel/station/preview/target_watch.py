"""Searches for the object in the live picture a few times per second, in a separate thread."""

import logging
import threading
import time
from dataclasses import dataclass

from crenel.errors import OperationError
from crenel.findings import Finding
from crenel.loop_states import waiting
from crenel.loops import Loop
from crenel.messages.message import message
from crenel.metrology.stripe import Stripe
from crenel.metrology.targets.target import CalibrationTarget
from crenel.station.preview.image_quality import error_finding
from crenel.station.preview.target_overlay import DetectedCorner, Segment, detect_target
from crenel_hardware.interfaces import Frame

log = logging.getLogger(__name__)

# The detection may use half of one core, whatever its cost.
REST_SHARE = 1.0
SHORTEST_REST_S = 0.15
LONGEST_SEARCH_S = 60.0
"""In a large picture, on a slow machine."""


@dataclass(frozen=True)
class TargetDetection:
    """The detection of the object in the frame exposed at ``stamp_ns``."""

    stamp_ns: int = 0
    corners: tuple[DetectedCorner, ...] = ()
    outline: tuple[Segment, ...] = ()
    finding: Finding | None = None


NO_DETECTION = TargetDetection()


class TargetWatch:
    """Detects the object in the newest frame, and rests between two detections."""

    def __init__(self) -> None:
        self._offered = threading.Condition()
        self._item: CalibrationTarget | None = None
        self._frame: tuple[Frame, Stripe | None] | None = None
        self._detection = NO_DETECTION
        self._resting = False
        self._ending = threading.Event()
        self._loop: Loop | None = None

    def start(self) -> None:
        self._ending.clear()
        self._loop = Loop(
            "object-watch", self._detect_next, ending=self._ending, longest_s=LONGEST_SEARCH_S
        )
        self._loop.start()

    def stop(self) -> None:
        if self._loop is not None:
            self._loop.stop(wake=self._wake)
            self._loop = None

    def _wake(self) -> None:
        with self._offered:
            self._offered.notify()

    def watch(self, item: CalibrationTarget | None) -> None:
        """Sets the object to search for; None ends the search."""
        with self._offered:
            if item != self._item:
                self._item, self._detection, self._frame = item, NO_DETECTION, None

    @property
    def detection(self) -> TargetDetection:
        """The result of the last search; ``NO_DETECTION`` if none is wanted."""
        with self._offered:
            return self._detection

    def rest(self, resting: bool) -> None:
        """While resting, no new search starts."""
        with self._offered:
            self._resting = resting

    def forget(self, seen: TargetDetection) -> None:
        """The last result is outdated: the next search starts at once."""
        with self._offered:
            if self._detection is seen:
                self._detection = NO_DETECTION
                self._offered.notify()

    def offer(self, frame: Frame, stripe: Stripe | None) -> None:
        """Passes the newest frame, with its stripe if the laser is on; never waits."""
        with self._offered:
            if self._item is not None and not self._resting:
                self._frame = (frame, stripe)
                self._offered.notify()

    def _detect_next(self) -> None:
        with self._offered:
            with waiting():
                self._offered.wait_for(lambda: self._ending.is_set() or self._frame is not None)
            taken, item = self._frame, self._item
            self._frame = None
        if self._ending.is_set() or taken is None or item is None:
            return
        started_s = time.monotonic()
        seen = _search(taken[0], taken[1], item)
        with self._offered:
            if self._item == item:
                self._detection = seen
        rest_s = max(SHORTEST_REST_S, REST_SHARE * (time.monotonic() - started_s))
        with self._offered:
            self._offered.wait_for(
                lambda: self._ending.is_set() or self._detection is NO_DETECTION, rest_s
            )


def _search(frame: Frame, stripe: Stripe | None, item: CalibrationTarget) -> TargetDetection:
    stamp_ns = frame.mid_exposure_ns
    try:
        found = detect_target(frame.image, item, stripe)
    except OperationError as refusal:
        return TargetDetection(stamp_ns, finding=error_finding(refusal))
    except Exception:  # an odd picture must not end the preview
        log.exception("the search for the object failed")
        return TargetDetection(
            stamp_ns, finding=Finding("attention", message("search-object-failed"))
        )
    return TargetDetection(stamp_ns, found.corners, found.outline)
