"""The course of the delay over a pass: constant, drifting, with jumps."""

from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from crenel.errors import OperationError
from crenel.messages.limits import beside_limit
from crenel.messages.message import message, quantity, signed
from crenel.metrology.arm.reading_interpolation import Stamps
from crenel.metrology.transforms import Floats

PPM = 1e-6
MOST_UNCERTAINTY_MS = 1.0
"""A delay with a larger uncertainty does more harm than good."""


@dataclass(frozen=True)
class DelayJump:
    """A clock that was set within the pass."""

    stamp_ns: int
    """When, by the camera's clock."""
    change_ns: float
    """The change of the delay."""
    unclear_ns: tuple[int, int] | None = None
    """Time stamps of the first and last frame around it that have no certain pose: a clock that was
    set back gives the same stamps twice."""


@dataclass(frozen=True)
class DelayCourse:
    """The delay of the arm's time stamps behind the camera's, at any time stamp of the camera."""

    delay_ns: float
    """At ``stamp_ns``, and without drift after the last jump."""
    stamp_ns: int = 0
    drift_ppm: float = 0.0
    jumps: tuple[DelayJump, ...] = ()
    uncertainty_ns: float = 0.0
    """k = 1, at ``stamp_ns``."""
    drift_uncertainty_ppm: float = 0.0
    """k = 1; counts where there is a drift."""

    def check_age(self, stamps_ns: Stamps) -> None:
        """Refuses a drifting delay so long before or after its pass that it is no longer known.

        Raises:
            OperationError: ``delay-too-old``, for the time stamps of any of these frames.
        """
        if not self.drift_ppm or not len(stamps_ns):
            return
        away_ns = float(np.abs(stamps_ns - self.stamp_ns).max())
        u_ms = np.hypot(self.uncertainty_ns, PPM * away_ns * self.drift_uncertainty_ppm) / 1e6
        if u_ms <= MOST_UNCERTAINTY_MS:
            return
        u, limit = beside_limit(float(u_ms), MOST_UNCERTAINTY_MS, "ms", 1)
        raise OperationError(
            "delay-too-old",
            message(
                "delay-drifts-its-pass-is-away",
                drift=signed(self.drift_ppm, "ppm", 1),
                away=quantity(away_ns / 60e9, "min"),
            ),
            message("it-is-known-to-limit", u=u, limit=limit),
            message("determine-delay-again-pass-close"),
        )

    def at(self, stamps_ns: Stamps) -> Stamps:
        """(F,) the delay of frames with these time stamps, ns.

        Example:
            >>> course = DelayCourse(60e6, jumps=(DelayJump(100, 50e6),))
            >>> course.at(np.array([99, 100])).tolist()
            [10000000, 60000000]
        """
        shape = CourseShape(
            self.stamp_ns, self.drift_ppm != 0.0, tuple(jump.stamp_ns for jump in self.jumps)
        )
        drift = [self.drift_ppm] if shape.drifts else []
        values = [self.delay_ns, *drift, *(jump.change_ns for jump in self.jumps)]
        return np.asarray(np.rint(shape.basis(stamps_ns) @ np.array(values)), dtype=np.int64)

    def at_one(self, stamp_ns: int) -> int:
        """The delay of one frame, ns."""
        return int(self.at(np.array([stamp_ns], dtype=np.int64))[0])

    def is_clear(self, stamps_ns: Stamps) -> NDArray[np.bool_]:
        """(F,) False for frames whose pose is uncertain because a clock was set then."""
        clear = np.ones(len(stamps_ns), dtype=np.bool_)
        for jump in self.jumps:
            if jump.unclear_ns is not None:
                first_ns, last_ns = jump.unclear_ns
                clear &= (stamps_ns < first_ns) | (stamps_ns > last_ns)
        return clear


NO_DELAY = DelayCourse(0.0)


@dataclass(frozen=True)
class CourseShape:
    """The terms of a course: its values are the delay at ``stamp_ns`` (ns), the drift (ppm) and the
    changes at the jumps (ns), in this order."""

    stamp_ns: int
    drifts: bool = False
    jumps_ns: tuple[int, ...] = ()

    @property
    def first_jump(self) -> int:
        """The place of the first jump among the values."""
        return 2 if self.drifts else 1

    def basis(self, stamps_ns: Stamps) -> Floats:
        """(F, m) derivatives of the delays (ns) by the values."""
        columns: list[Floats] = [np.ones(len(stamps_ns))]
        if self.drifts:
            columns.append(np.asarray(PPM * (stamps_ns - self.stamp_ns), dtype=np.float64))
        columns += [-(stamps_ns < jump_ns).astype(np.float64) for jump_ns in self.jumps_ns]
        return np.column_stack(columns)

    def piece(self, stamps_ns: Stamps) -> NDArray[np.int64]:
        """(F,) number of the piece between two jumps in which a frame lies."""
        return np.searchsorted(np.array(self.jumps_ns, dtype=np.int64), stamps_ns, side="right")
