"""Looks for the object in the live picture a few times a second, on a thread of its own."""

import logging
import threading
import time
from dataclasses import dataclass

import numpy as np

from app.metrology.camera import project
from app.metrology.crenellated import Crenellated, corners
from app.metrology.detection.corners import ObjectDetection, detect_object
from app.metrology.detection.visibility import visible_parts
from app.metrology.refusal import Refusal
from app.metrology.stripe import Stripe
from app.station.findings import Finding
from app.station.picture_words import refused
from hardware.interfaces import Frame

Segment = tuple[float, float, float, float]
"""A line in the picture: u0, v0, u1, v1."""

log = logging.getLogger(__name__)

# The detection may take half of one core, whatever it costs.
REST_SHARE = 1.0
SHORTEST_REST_S = 0.15


@dataclass(frozen=True)
class SeenCorner:
    """A corner found in a picture; as ``ImageCorner`` of the browser's types."""

    name: str
    u: float
    v: float
    residual_px: float | None


@dataclass(frozen=True)
class Seen:
    """What was found of the object in the frame exposed at ``stamp_ns``."""

    stamp_ns: int = 0
    corners: tuple[SeenCorner, ...] = ()
    outline: tuple[Segment, ...] = ()
    finding: Finding | None = None


NOTHING = Seen()


class ObjectWatch:
    """Detects on the newest frame that was offered, and rests between two detections."""

    def __init__(self) -> None:
        self._offered = threading.Condition()
        self._block: Crenellated | None = None
        self._frame: tuple[Frame, Stripe | None] | None = None
        self._seen = NOTHING
        self._resting = False
        self._stopping = False
        self._thread: threading.Thread | None = None

    def start(self) -> None:
        self._stopping = False
        self._thread = threading.Thread(target=self._run, name="object-watch", daemon=True)
        self._thread.start()

    def stop(self) -> None:
        with self._offered:
            self._stopping = True
            self._offered.notify()
        if self._thread is not None:
            self._thread.join(5.0)
            self._thread = None

    def watch(self, block: Crenellated | None) -> None:
        """Names the object to look for; None ends the search."""
        with self._offered:
            if block != self._block:
                self._block, self._seen, self._frame = block, NOTHING, None

    @property
    def seen(self) -> Seen:
        """What the last search found; ``NOTHING`` while none is wanted."""
        with self._offered:
            return self._seen

    def rest(self, resting: bool) -> None:
        """While resting, no new search begins."""
        with self._offered:
            self._resting = resting

    def forget(self, seen: Seen) -> None:
        """What was found is out of date: the next search begins at once."""
        with self._offered:
            if self._seen is seen:
                self._seen = NOTHING
                self._offered.notify()

    def offer(self, frame: Frame, stripe: Stripe | None) -> None:
        """Gives the newest frame, with its stripe where the laser is on; never waits."""
        with self._offered:
            if self._block is not None and not self._resting:
                self._frame = (frame, stripe)
                self._offered.notify()

    def _run(self) -> None:
        while True:
            with self._offered:
                self._offered.wait_for(lambda: self._stopping or self._frame is not None)
                if self._stopping:
                    return
                taken, block = self._frame, self._block
                self._frame = None
            if taken is None or block is None:
                continue
            started_s = time.monotonic()
            seen = _search(taken[0], taken[1], block)
            with self._offered:
                if self._block == block:
                    self._seen = seen
            rest_s = max(SHORTEST_REST_S, REST_SHARE * (time.monotonic() - started_s))
            with self._offered:
                self._offered.wait_for(lambda: self._stopping or self._seen is NOTHING, rest_s)


def _search(frame: Frame, stripe: Stripe | None, block: Crenellated) -> Seen:
    stamp_ns = frame.mid_exposure_ns
    try:
        found = detect_object(frame.image, block, stripe)
    except Refusal as refusal:
        return Seen(stamp_ns, finding=refused(refusal))
    except Exception:  # a preview must not end because a picture is odd
        log.exception("the search for the object failed")
        return Seen(stamp_ns, finding=Finding("attention", "The search for the object failed"))
    return Seen(stamp_ns, seen_corners(found, block), outline(found, block))


def seen_corners(found: ObjectDetection, block: Crenellated) -> tuple[SeenCorner, ...]:
    """The detected corners, each with its distance from where the fitted camera puts it."""
    points = corners(block)
    at = project(found.camera, np.array([points[corner.name] for corner in found.corners]))
    return tuple(
        SeenCorner(c.name, c.u, c.v, float(np.hypot(c.u - u, c.v - v)))
        for c, (u, v) in zip(found.corners, at, strict=True)
    )


def outline(found: ObjectDetection, block: Crenellated) -> tuple[Segment, ...]:
    """What is seen of the block's edges, as lines in the picture."""
    parts = visible_parts(block, found.camera.centre_mm)
    ends = project(
        found.camera, np.array([(part.start_mm, part.end_mm) for part in parts]).reshape(-1, 3)
    )
    return tuple(
        (float(u0), float(v0), float(u1), float(v1)) for u0, v0, u1, v1 in ends.reshape(-1, 4)
    )
