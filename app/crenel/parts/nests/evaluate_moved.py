"""Two rounds of touches of nests, and what has moved between them."""

from collections.abc import Sequence
from dataclasses import dataclass
from pathlib import Path

import numpy as np

from crenel.errors import OperationError
from crenel.formats.file_names import display_path
from crenel.formats.session.calibration_session import ContactReadings, read_contacts
from crenel.messages.message import Text, message
from crenel.metrology.arm.kinematics import tip_of
from crenel.metrology.transforms import Floats
from crenel.parts.evaluate_folder import StationKnowledge, read_station
from crenel.parts.evaluate_points import select_touches
from crenel.parts.maths.point_errors import TouchErrors
from crenel.parts.nests.maths_moved import (
    LEAST_NESTS,
    Hypothesis,
    choose_hypothesis,
    compare_hypotheses,
)

SEAT_UM = 0.1
"""A seat repeats no better than this: it keeps the covariance of shifts from being singular."""


@dataclass(frozen=True)
class NestShift:
    """How far one nest was found from where it was."""

    nest: str
    shift_mm: tuple[float, float, float]
    u_mm: float
    """Standard uncertainty of its length at most, k = 1."""

    @property
    def length_mm(self) -> float:
        return float(np.linalg.norm(self.shift_mm))


@dataclass(frozen=True)
class MovedCheck:
    """The shifts, the hypotheses, and the one that holds; None: none does."""

    shifts: tuple[NestShift, ...]
    hypotheses: tuple[Hypothesis, ...]
    chosen: Hypothesis | None
    warnings: tuple[Text, ...]

    def names(self, hypothesis: Hypothesis) -> list[str]:
        """The nests that moved by a hypothesis."""
        return [self.shifts[k].nest for k in hypothesis.nests]


def check_moved(
    before: Path, after: Path, calibration: Path, arm: Path, part: Sequence[str] = ()
) -> MovedCheck:
    """Whether anything has moved between two rounds of touches.

    Args:
        before, after: touches with the names of the nests in ``feature``.
        part: names of the nests on the part; the others are on the base.

    Raises:
        OperationError: a file is wrong, fewer than three nests are in both, a nest of the part is
            unknown, or the errors of the arm are.
    """
    station = read_station(calibration, arm)
    tip_of(station.arm)
    rounds = [read_contacts(path, station.arm, None) for path in (before, after)]
    names = [one for one in dict.fromkeys(rounds[0].features) if one in rounds[1].features]
    if len(names) < LEAST_NESTS:
        raise OperationError(
            "too-few-nests",
            message(
                "part-too-few-nests",
                before=display_path(before),
                after=display_path(after),
                count=len(names),
            ),
            "",
            message("part-touch-three-nests"),
        )
    for name in part:
        if name not in names:
            raise OperationError(
                "nest-unknown",
                message("part-nest-unknown", nest=name, names=", ".join(names)),
            )
    if station.shared is None:
        raise OperationError(
            "nests-without-uncertainty",
            station.warnings[-1] if station.warnings else display_path(calibration),
            message("part-moved-needs-uncertainty"),
        )
    places, covariance = _shifts(rounds, names, station, station.shared)
    on_part = [names.index(name) for name in part]
    hypotheses = compare_hypotheses(places[0], places[1], covariance, on_part)
    warnings: list[Text] = []
    if len(names) == LEAST_NESTS:
        warnings.append(message("part-three-nests-show-little"))
    return MovedCheck(
        tuple(_shift_of(name, k, places, covariance) for k, name in enumerate(names)),
        tuple(hypotheses),
        choose_hypothesis(hypotheses),
        tuple(warnings),
    )


def _shift_of(name: str, number: int, places: list[Floats], covariance: Floats) -> NestShift:
    own = slice(3 * number, 3 * number + 3)
    x, y, z = (places[1] - places[0])[number].tolist()
    largest = float(np.linalg.eigvalsh(covariance[own, own])[-1])
    return NestShift(name, (x, y, z), float(np.sqrt(max(largest, 0.0))))


def _shifts(
    rounds: list[ContactReadings], names: list[str], station: StationKnowledge, shared: Floats
) -> tuple[list[Floats], Floats]:
    """Places (K, 3) of both rounds, and the covariance (3K, 3K) of the shifts between them.

    What the arm errs by in both rounds cancels as far as its postures are alike.
    """
    count = len(names)
    A = np.zeros((3 * count, len(shared)))
    noise = np.zeros((3 * count, 3 * count))
    places = [np.zeros((count, 3)), np.zeros((count, 3))]
    for sign, contacts, found in zip((-1.0, 1.0), rounds, places, strict=True):
        for k, name in enumerate(names):
            errors, _ = select_touches(contacts, name, station, 1.0)
            by_shared, own = _mean_errors(errors)
            found[k] = errors.points_mm.mean(axis=0)
            some = slice(3 * k, 3 * k + 3)
            A[some] += sign * by_shared
            noise[some, some] += own
    covariance = A @ shared @ A.T + noise + (SEAT_UM / 1e3) ** 2 * np.eye(3 * count)
    return places, np.asarray((covariance + covariance.T) / 2)


def _mean_errors(errors: TouchErrors) -> tuple[Floats, Floats]:
    """Derivatives (3, P) of the mean place of touches by the shared errors, and the covariance
    (3, 3) of its own noise."""
    count = len(errors.points_mm)
    gains = np.full((count, 1), 1 / count)
    rows, by_readings = [], []
    for axis in np.eye(3):
        sums = errors.sums(gains, np.tile(axis, (count, 1)))
        rows.append(sums.shared[0])
        by_readings.append(sums.by_readings[:, 0].ravel())
    B, shared = np.array(by_readings), np.array(rows)
    shared[:, -1] = 0.0  # a seat holds the centre of the tip, whatever its radius
    return shared, B @ B.T + errors.touch_sd_mm**2 / count * np.eye(3)
