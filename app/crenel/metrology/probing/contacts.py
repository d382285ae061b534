"""Contact points on the crenellated object, and whether they determine its position."""

from collections.abc import Sequence
from dataclasses import dataclass, replace
from itertools import combinations

import numpy as np
from numpy.typing import NDArray

from crenel.errors import OperationError
from crenel.messages.message import Text, join, message
from crenel.metrology.robust import median
from crenel.metrology.targets.crenellated_block import (
    FACES,
    Crenellated,
    face_size_mm,
    on_face,
    probing_face,
)
from crenel.metrology.transforms import Floats, apply, inverse

DIRECTIONS = (("crest", "floor"), ("front", "back"), ("left", "right"))
MIN_CONTACTS = 3
"""On each of three non-parallel faces: with fewer, there is no residual to judge by."""
MIN_SPREAD_MM, MIN_SPREAD_SHARE = 0.5, 0.03
"""Contact points with a smaller rms distance from their best line count as lying on it; on a small
block, with one below this share of the shorter side of their face."""
CONTACT_SD_MM = 0.001
"""Repeatability of the touch itself, in addition to the encoder noise."""
ALIKE_MM = 0.1
"""Contact points that differ by less may be on one plane."""
OPEN_MM = 0.01
"""Faces that are known worse than this are estimated with the pose: contacts know them better."""
FACE_SLACK_MM = 1.5
"""Tolerated distance of a contact point beyond its face before it counts as off the face."""
MERLON_SLACK_MM = 0.5
"""The same across a crest or floor: the tip meets the edge before it passes it."""


@dataclass(frozen=True)
class FaceContacts:
    """Contact points with the planes that they touch."""

    features: tuple[str, ...]
    tips_mm: Floats  # (N, 3) tip centres in the arm frame
    normals: Floats  # (N, 3) outward normal of each contact point's face, object frame
    reach_mm: Floats  # (N,) face offset plus tip radius
    tip_covariances_mm2: Floats  # (N, 3, 3) of the tip centres; equal if nothing is known
    tip_shared_mm: Floats
    """(N, 3, L) what errors that all contacts share move each tip by, per standard deviation."""
    made_mm: float
    """Standard uncertainty of a face's offset that contacts are to find; 0 where it is known."""

    @property
    def faces(self) -> tuple[str, ...]:
        """The faces whose offsets are to be found."""
        return tuple(dict.fromkeys(self.features)) if self.made_mm else ()

    def by_faces(self) -> Floats:
        """(N, F) derivatives of the residuals by the offsets of ``faces``."""
        return -np.array(
            [[float(own == face) for face in self.faces] for own in self.features]
        ).reshape(len(self.features), len(self.faces))

    def with_faces_at(self, offsets_mm: Floats) -> "FaceContacts":
        """The contacts on ``faces`` that lie further out by offsets (F,)."""
        return replace(self, reach_mm=self.reach_mm - self.by_faces() @ offsets_mm)

    def residuals_mm(self, T_arm_obj: Floats) -> Floats:
        """(..., N) distance of each contact point from its face, positive outward, at poses
        (..., 4, 4)."""
        in_obj = (self.tips_mm - T_arm_obj[..., None, :3, 3]) @ T_arm_obj[..., :3, :3]
        return np.asarray((self.normals * in_obj).sum(axis=-1) - self.reach_mm)

    def sds_mm(self, T_arm_obj: Floats) -> Floats:
        """(N,) expected standard deviation of each contact point along the normal of its face."""
        normals_arm = self.normals @ T_arm_obj[:3, :3].T
        variances = np.einsum("ij,ijk,ik->i", normals_arm, self.tip_covariances_mm2, normals_arm)
        return np.asarray(np.sqrt(variances + CONTACT_SD_MM**2))


def missing_contacts(features: Sequence[str]) -> Text:
    """What must still be probed before an alignment is possible; empty if nothing is missing.

    Args:
        features: the face of each contact point so far.
    """
    wanted = []
    for faces in DIRECTIONS:
        taken = sum(features.count(face) for face in faces)
        if taken < MIN_CONTACTS:
            wanted.append(message("more-on-either-face", count=MIN_CONTACTS - taken, pair=faces[0]))
    return message("touch-more-contacts", contacts=join(wanted)) if wanted else ""


def build_contacts(
    features: tuple[str, ...],
    tip_centres_mm: Floats,
    tip_radius_mm: float,
    block: Crenellated,
    tip_covariances_mm2: Floats | None,
    tip_shared_mm: Floats | None,
) -> FaceContacts:
    tips = np.asarray(tip_centres_mm, dtype=np.float64)
    for i, face in enumerate(features):
        if face not in FACES:
            raise OperationError(
                "unknown-face",
                message("contact-unknown-face", number=i + 1, face=face),
                message("faces-are", names=", ".join(FACES)),
            )
    if tips.shape != (len(features), 3) or not np.all(np.isfinite(tips)):
        raise OperationError(
            "bad-contacts",
            message("contacts-were-given-positions", count=len(features), shape=str(tips.shape)),
        )
    missing = missing_contacts(features)
    if missing:
        raise OperationError(
            "too-few-contacts",
            message("contacts-do-not-determine-object", count=len(features)),
            message("least-needed-each-three-non-parallel", least=MIN_CONTACTS),
            missing,
        )
    planes = [probing_face(block, face) for face in features]
    return FaceContacts(
        features=features,
        tips_mm=tips,
        normals=np.array([normal for normal, _ in planes]),
        reach_mm=np.array([offset for _, offset in planes]) + tip_radius_mm,
        tip_covariances_mm2=(
            np.zeros((len(features), 3, 3)) if tip_covariances_mm2 is None else tip_covariances_mm2
        ),
        tip_shared_mm=np.zeros((len(features), 3, 0)) if tip_shared_mm is None else tip_shared_mm,
        made_mm=made_mm if (made_mm := block.standard_uncertainty_mm) > OPEN_MM else 0.0,
    )


def refuse_lines(contacts: FaceContacts, block: Crenellated) -> None:
    """Raises ``OperationError`` where no face of a direction shows how it is turned."""
    labels = np.array(contacts.features)
    for faces in DIRECTIONS:
        own = [face for face in faces if face in contacts.features]
        spreads = {face: in_plane_spread(contacts.tips_mm[labels == face]) for face in own}
        face = max(own, key=lambda name: spreads[name][0])
        least_mm = min(MIN_SPREAD_MM, MIN_SPREAD_SHARE * float(face_size_mm(block, face).min()))
        if spreads[face][0] < least_mm:
            raise OperationError(
                "contacts-on-a-line",
                message(
                    "contacts-face-lie-one-line",
                    count=int((labels == face).sum()),
                    where=on_face(face),
                ),
                message("face-can-turn-about-line"),
                message("touch-face-also-beside-line", face=face),
            )


def in_plane_spread(points_mm: Floats) -> tuple[float, Floats]:
    """Rms distance of points (N, 3) from their best line, and their plane's normal (3,).

    The plane fits most of the points (least median of squares over triples), so that a contact
    point on a wrong face does not tilt it.
    """
    if len(points_mm) < 3:
        return 0.0, np.zeros(3)
    triples = np.array(list(combinations(range(len(points_mm)), 3)))
    corners = points_mm[triples[:: max(1, len(triples) // 500)]]
    normals = np.cross(corners[:, 1] - corners[:, 0], corners[:, 2] - corners[:, 0])
    lengths = np.linalg.norm(normals, axis=1)
    proper = lengths > 1e-9 * np.max(lengths, initial=1e-9)
    if not proper.any():
        return 0.0, np.zeros(3)
    normals, corners = normals[proper] / lengths[proper, None], corners[proper]
    offsets = np.einsum("ij,ij->i", normals, corners[:, 0])
    distances = np.abs(points_mm @ normals.T - offsets)
    # of planes that fit alike, as any three of four points do, the one through the widest triangle
    alike = (np.median(distances, axis=0) / ALIKE_MM).round()
    best = int(np.lexsort((-lengths[proper], alike))[0])
    near = distances[:, best] <= np.maximum(3 * median(distances[:, best]), ALIKE_MM)
    _, s, Vt = np.linalg.svd(points_mm[near] - points_mm[near].mean(axis=0))
    return float(s[1] / np.sqrt(near.sum())), Vt[2]


def surface_points(contacts: FaceContacts, T_arm_obj: Floats, tip_radius_mm: float) -> Floats:
    return np.asarray(
        apply(inverse(T_arm_obj), contacts.tips_mm) - tip_radius_mm * contacts.normals
    )


def off_face_mask(
    features: Sequence[str], points_obj_mm: Floats, block: Crenellated
) -> NDArray[np.bool_]:
    """(N,) contact points (N, 3) that lie outside the bounds of their face.

    A crest ends at its groove and a floor at its walls, so that contact points on the crests
    distinguish a block from the same block rotated by half a turn.
    """
    x, y, z = points_obj_mm.T
    edges = np.array(block.edges_x_mm)
    slack = FACE_SLACK_MM
    in_x = (x > edges[0] - slack) & (x < edges[-1] + slack)
    in_y = (y > block.front_y_mm - slack) & (y < block.back_y_mm + slack)
    in_z = (z > block.base_z_mm - slack) & (z < block.crest_z_mm + slack)
    within = {
        "crest": _within_spans(x, edges[0::2], edges[1::2]) & in_y,
        "floor": _within_spans(x, edges[1:-1:2], edges[2::2]) & in_y,
        "front": in_x & in_z,
        "back": in_x & in_z,
        "left": in_y & in_z,
        "right": in_y & in_z,
    }
    return np.array([not within[face][i] for i, face in enumerate(features)], dtype=bool)


def _within_spans(x_mm: Floats, left_mm: Floats, right_mm: Floats) -> NDArray[np.bool_]:
    """(N,) positions on one of the merlons, or grooves, of these edges."""
    after = x_mm[:, None] > left_mm - MERLON_SLACK_MM
    return np.asarray((after & (x_mm[:, None] < right_mm + MERLON_SLACK_MM)).any(axis=1))
