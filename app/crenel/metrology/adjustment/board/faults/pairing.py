"""Pictures and poses that slipped against each other: which pose belongs to which picture.

The angle between two poses is the same for the flange and for the board before the camera, however
the sensor is mounted. It shows in microseconds whether poses may belong to pictures.
"""

from collections.abc import Iterator, Sequence
from dataclasses import dataclass
from itertools import combinations
from typing import Literal

import numpy as np
from numpy.typing import NDArray

from crenel.metrology.transforms import Floats

PairingFault = Literal["before", "after", "late", "early", "reversed", "sorted", "swapped", "mixed"]
MOST_ROWS = 5
"""By which pictures and poses are taken to have slipped."""
TURN_RAD = np.deg2rad(1.5)
"""By which flange and board may turn differently between two poses that belong to them."""
LEAST_SHARE = 0.6
"""Share of the pairs of pictures that turn alike in a pairing that is worth a closer look."""
MOST_LOOKS = 8
FEWEST_MIXED = 6
"""Pictures whose poses are looked for one by one: fewer agree with something."""


@dataclass(frozen=True)
class Pairing:
    """The poses ``pose`` (K,) of the pictures ``picture`` (K,), as rows of observations.

    ``first`` and ``other`` are rows: from which one on the poses are late or early by ``rows``, or
    the two that were swapped.
    """

    fault: PairingFault
    picture: NDArray[np.intp]
    pose: NDArray[np.intp]
    first: int = 0
    other: int = 0
    rows: int = 0


def angles_between(flat: Floats) -> Floats:
    """(N, N) angles between rotations (N, 9), rad."""
    return np.asarray(np.arccos(np.clip((flat @ flat.T - 1) / 2, -1.0, 1.0)))


def list_pairings(
    R_arm_flange: Floats, R_cam_obj: Sequence[Floats], rows: Sequence[int]
) -> list[Pairing]:
    """Pairings by which flange and board turn alike, the likeliest of each kind first.

    Args:
        R_arm_flange: (P, 3, 3) in the order of the table.
        R_cam_obj: of each of P pictures, (W, 3, 3) for each way to number its corners.
        rows: (P,) of the table; pictures that show no board are missing.
    """
    apart = _Turns(R_arm_flange, R_cam_obj)
    simple = _likeliest(list(_whole(rows)), apart)
    slipped = _likeliest([*_slips(rows), *_swaps(len(rows))], apart)
    mixed = [] if simple or slipped else _match(apart)
    return [*simple, *slipped, *mixed]


class _Turns:
    """Whether the flange turns between any two poses as the board between any two pictures."""

    def __init__(self, R_arm_flange: Floats, R_cam_obj: Sequence[Floats]) -> None:
        self.of_flange = angles_between(R_arm_flange.reshape(len(R_arm_flange), 9))
        ways = max(map(len, R_cam_obj))
        padded = np.array([np.resize(R, (ways, 3, 3)) for R in R_cam_obj])
        count = len(padded)
        every = angles_between(padded.reshape(count * ways, 9)).reshape(count, ways, count, ways)
        # from one way of a picture, the others are compared in all of theirs
        self.of_board = every[:, 0]  # (P, P, W)

    def alike(self, picture: NDArray[np.intp], pose: NDArray[np.intp]) -> Floats:
        """(K, K) of pictures with these poses."""
        of_flange = self.of_flange[np.ix_(pose, pose)]
        off = np.abs(self.of_board[np.ix_(picture, picture)] - of_flange[:, :, None]).min(axis=-1)
        return np.asarray(off < TURN_RAD)

    def share(self, pairing: Pairing) -> float:
        """The share of the pairs of pictures that turn alike."""
        count = len(pairing.picture)
        alike = self.alike(pairing.picture, pairing.pose)
        return float((alike.sum() - count) / max(count * (count - 1), 1))


def _likeliest(pairings: Sequence[Pairing], apart: _Turns) -> list[Pairing]:
    shares = np.array([apart.share(one) for one in pairings])
    order = np.argsort(-shares, kind="stable")[:MOST_LOOKS]
    return [pairings[k] for k in order if shares[k] >= LEAST_SHARE]


def _whole(rows: Sequence[int]) -> Iterator[Pairing]:
    """All rows shifted, reversed, or one of the two columns sorted by name."""
    count = len(rows)
    every = np.arange(count)
    for shift in (1, -1):
        yield _slip(rows, "before" if shift < 0 else "after", 0, shift)
    for by in range(2, MOST_ROWS + 1):
        yield _slip(rows, "late", 0, by)
        yield _slip(rows, "early", 0, -by)
    yield Pairing("reversed", every, every[::-1].copy())
    for start in (0, 1):
        names = [str(k + start) for k in range(count)]
        by_name = np.array(sorted(range(count), key=names.__getitem__))
        if not np.array_equal(by_name, every):
            yield Pairing("sorted", every, by_name)
            yield Pairing("sorted", every, np.argsort(by_name))


def _slips(rows: Sequence[int]) -> Iterator[Pairing]:
    for first in range(1, len(rows) - 1):
        for by in range(1, MOST_ROWS + 1):
            yield _slip(rows, "late", first, by)
            yield _slip(rows, "early", first, -by)


def _slip(rows: Sequence[int], fault: PairingFault, first: int, by: int) -> Pairing:
    """From a picture on, each with the pose that stands ``by`` rows further down. Where it stands
    further up, poses were lost, and the first pictures have none."""
    at = {row: k for k, row in enumerate(rows)}
    lost = range(rows[first], rows[first] - by)
    wanted = [
        -1 if row in lost else at.get(row + by if k >= first else row, -1)
        for k, row in enumerate(rows)
    ]
    picture = np.flatnonzero(np.array(wanted) >= 0)
    return Pairing(fault, picture, np.array(wanted, np.intp)[picture], first, rows=abs(by))


def _swaps(count: int) -> Iterator[Pairing]:
    every = np.arange(count)
    for one, other in combinations(range(count), 2):
        pose = every.copy()
        pose[[one, other]] = other, one
        yield Pairing("swapped", every, pose, one, other)


def _match(apart: _Turns) -> list[Pairing]:
    """The pose of every picture on its own, from two that are tried in all poses."""
    count = len(apart.of_flange)
    if count < FEWEST_MIXED:
        return []
    every = np.arange(count)
    found: list[Pairing] = []
    seen: set[tuple[int, ...]] = set()
    for two in combinations(range(min(count, 4)), 2):
        board = apart.of_board[list(two)]  # (2, P, W)
        for anchors in np.argwhere(np.ones((count, count)) - np.eye(count)):
            turned = apart.of_flange[anchors]  # (2, P)
            off = np.abs(board[:, :, None, :] - turned[:, None, :, None]).min(axis=-1)
            cost = off.max(axis=0)  # (P, P) of a picture with a pose
            cost[list(two)] = np.inf
            cost[list(two), anchors] = 0.0
            pose = cost.argmin(axis=1)
            if tuple(pose) in seen or len(set(pose.tolist())) < count - 1:
                continue
            seen.add(tuple(pose))
            found.append(Pairing("mixed", every, pose))
    return _likeliest(found, apart)
