"""The points of an arm session: sampled while the arm swings about its tip, and as the
identification takes them. Pure."""

from collections.abc import Sequence
from dataclasses import dataclass

import numpy as np

from crenel.guide.arm.state import Angles, ArmState
from crenel.metrology.arm.identification.observations import ArmObservations, Bar, Seat, Sphere
from crenel.metrology.arm.kinematics import Arm, tip_centres
from crenel.metrology.arm.reading_interpolation import shortest_turn
from crenel.station.devices.reading_buffer import ReadingWindow

TURN_RAD = float(np.deg2rad(3.0))
"""A point is taken whenever a joint has turned so far since the last."""
LEFT_MM = 3.0
"""A tip further than this from where it was is not in its seat."""
HOLD_NS = 400_000_000
"""So long before the tip leaves its seat, and after it returns, no point counts."""


@dataclass(frozen=True)
class SampledPoints:
    """What a stretch of joint samples gives."""

    q_rad: tuple[Angles, ...]
    left_mm: float | None
    """How far the tip is from the seat now, where it has left it."""


def sample_points(
    arm: Arm, taken: Sequence[Angles], samples: ReadingWindow, first_ns: int, last_ns: int
) -> SampledPoints:
    """The samples that become points.

    Args:
        taken: points of this seat so far; the first is taken with the tip in the seat.
        samples: a little more than what is asked for, so that it is known whether the
            tip was leaving or coming.
        first_ns, last_ns: between these stamps samples may become points.
    """
    if not len(samples):
        return SampledPoints((), None)
    tips = tip_centres(arm, samples.readings)
    begun = min(int(np.searchsorted(samples.stamps_ns, first_ns)), len(tips) - 1)
    centre = np.median(tip_centres(arm, np.array(taken)), axis=0) if taken else tips[begun]
    off_mm = np.linalg.norm(tips - centre, axis=1)
    away_ns = samples.stamps_ns[off_mm > LEFT_MM]
    picked: list[Angles] = []
    last = np.array(taken[-1]) if taken else None
    for stamp, q in zip(samples.stamps_ns, samples.readings, strict=True):
        if not first_ns <= stamp <= last_ns:
            continue
        if len(away_ns) and np.min(np.abs(away_ns - stamp)) < HOLD_NS:
            continue
        if last is None or float(np.max(np.abs(shortest_turn(q - last)))) >= TURN_RAD:
            last = q
            picked.append(tuple(float(angle) for angle in q))
    return SampledPoints(tuple(picked), float(off_mm[-1]) if off_mm[-1] > LEFT_MM else None)


def collect_observations(state: ArmState) -> ArmObservations:
    """What was taken so far, as the identification has it; half a bar is left out."""
    taken = [seat for seat in state.seats if seat.q_rad]
    of = {
        kind: [seat for seat in taken if seat.artefact.kind == kind]
        for kind in ("seat", "bar", "sphere")
    }
    ends = of["bar"]
    return ArmObservations(
        tuple(Seat(seat.name, np.array(seat.q_rad)) for seat in of["seat"]),
        tuple(
            Sphere(seat.name, seat.artefact.size_mm or 0.0, np.array(seat.q_rad))
            for seat in of["sphere"]
        ),
        tuple(
            Bar(
                f"{a.artefact.size_mm:g} mm",
                a.name.split(",")[0],
                a.artefact.size_mm or 0.0,
                a.artefact.standard_uncertainty_mm,
                ("A", "B"),
                (np.array(a.q_rad), np.array(b.q_rad)),
            )
            for a, b in zip(ends[::2], ends[1::2], strict=False)
        ),
    )
