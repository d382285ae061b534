"""The number of further contact points, and their faces, that bring the object's position to the
target uncertainty."""

from collections.abc import Sequence
from dataclasses import dataclass

import numpy as np

from crenel.messages.message import Text, join, message
from crenel.metrology.probing.alignment import Alignment
from crenel.metrology.targets.crenellated_block import FACES, Crenellated, on_face, probing_face
from crenel.metrology.transforms import Floats

MOST_MORE = 30
MARGIN_MM, MARGIN_SHARE = 2.0, 0.3
"""Contact points keep this distance from the edges of their face, of a small one this share."""


@dataclass(frozen=True)
class TouchAdvice:
    """``more`` contact points by face bring the object's position from ``now_um`` to ``then_um``, k
    = 1.

    The face that helps most comes first. ``reaches`` says whether the target is then met; ``more``
    is empty if it is met already.
    """

    more: tuple[tuple[str, int], ...]
    now_um: float
    then_um: float
    reaches: bool

    @property
    def words(self) -> Text:
        """``6 more on the left face, 2 on the crest``; empty if none are needed."""
        if not self.more:
            return ""
        (face, count), *others = self.more
        first = message("more-touches-on-face", count=count, where=on_face(face))
        return join(
            [first, *(message("touches-on-face", count=n, where=on_face(one)) for one, n in others)]
        )


def next_touches(
    alignment: Alignment, features: Sequence[str], block: Crenellated, target_um: float
) -> TouchAdvice:
    """The number of further contact points, by face, that would reach a target uncertainty.

    Contact points are added one at a time on the face where they help most, spread over the face,
    until the target is met or ``MOST_MORE`` are suggested.

    Args:
        alignment: the result of ``align`` for the contact points so far.
        features: the face of each of the N contact points.
        target_um: standard uncertainty of a point of the block in the arm frame, rms over its
            corners, k = 1.

    Returns:
        Number of contact points by face, and the uncertainty before and after.
    """
    information = _information(alignment, features, block)
    now = then = _point_uncertainty_um(information, block)
    rows = {face: _face_rows(face, block) / alignment.sigma_mm for face in FACES}
    more = dict.fromkeys(FACES, 0)
    while then > target_um and sum(more.values()) < MOST_MORE:
        tried = {}
        for face in FACES:
            row = rows[face][more[face] % len(rows[face])]
            tried[face] = information + np.outer(row, row)
        worth = {face: _point_uncertainty_um(one, block) for face, one in tried.items()}
        best = min(FACES, key=lambda face: worth[face])
        information, then = tried[best], worth[best]
        more[best] += 1
    named = sorted(((face, n) for face, n in more.items() if n), key=lambda one: -one[1])
    return TouchAdvice(tuple(named), now, then, then <= target_um)


def _face_rows(face: str, block: Crenellated) -> Floats:
    normal, _ = probing_face(block, face)
    places = face_sample_points(face, block)
    return _rows(places, np.broadcast_to(normal, places.shape))


def face_sample_points(face: str, block: Crenellated) -> Floats:
    """Positions (8, 3) for probing a face, far apart first, object frame."""
    x = _within(block.edges_x_mm[0], block.edges_x_mm[-1])
    y = _within(block.front_y_mm, block.back_y_mm)
    z = _within(block.base_z_mm, block.floor_z_mm)
    share = np.array([[0, 0], [1, 1], [1, 0], [0, 1], [0.5, 0], [0.5, 1], [0, 0.5], [1, 0.5]])
    first, second = {
        "crest": (x, y),
        "floor": (x, y),
        "front": (x, z),
        "back": (x, z),
        "left": (y, z),
        "right": (y, z),
    }[face]
    a = first[0] + share[:, 0] * (first[1] - first[0])
    b = second[0] + share[:, 1] * (second[1] - second[0])
    level = np.full(len(share), _level_mm(face, block))
    if face in ("crest", "floor"):
        return np.column_stack([a, b, level])
    return np.column_stack([a, level, b] if face in ("front", "back") else [level, a, b])


def _within(low_mm: float, high_mm: float) -> tuple[float, float]:
    """Between two edges, clear of both."""
    margin = min(MARGIN_MM, MARGIN_SHARE * (high_mm - low_mm))
    return low_mm + margin, high_mm - margin


def _level_mm(face: str, block: Crenellated) -> float:
    """Position of a face on the axis across it."""
    normal, offset_mm = probing_face(block, face)
    return float(offset_mm * normal.sum())


def _rows(points_mm: Floats, normals: Floats) -> Floats:
    """(N, 6) derivatives of the contact distances by a twist of the object, object frame."""
    return np.column_stack([np.cross(points_mm, normals), normals])


def _information(alignment: Alignment, features: Sequence[str], block: Crenellated) -> Floats:
    """(6, 6) information of the contact points that were kept, for a twist of the object in its own
    frame."""
    kept = np.flatnonzero(~alignment.outliers)
    normals = np.array([probing_face(block, features[int(i)])[0] for i in kept])
    rows = _rows(alignment.points_obj_mm[kept], normals) / alignment.sigma_mm
    return np.asarray(rows.T @ rows)


def _point_uncertainty_um(information: Floats, block: Crenellated) -> float:
    """The uncertainty of a point in micrometres: rms over the corners of the block."""
    covariance = np.linalg.inv(information)
    corners = np.array(
        [
            [x, y, z]
            for x in (block.edges_x_mm[0], block.edges_x_mm[-1])
            for y in (block.front_y_mm, block.back_y_mm)
            for z in (block.floor_z_mm, block.crest_z_mm)
        ]
    )
    squares = []
    for x, y, z in corners:
        J = np.hstack([np.array([[0, z, -y], [-z, 0, x], [y, -x, 0]]), np.eye(3)])
        squares.append(float(np.trace(J @ covariance @ J.T)))
    return float(1e3 * np.sqrt(np.mean(squares)))
