"""Observations of the crenellated block for the adjustment: certificate, pictures, contact
points."""

from collections.abc import Sequence
from dataclasses import dataclass, replace

import numpy as np
from numpy.typing import NDArray

from crenel.metrology.adjustment.core.arm_errors import arm_motion, tip_by_links
from crenel.metrology.adjustment.core.observations import ContactObservations, TargetPrior
from crenel.metrology.adjustment.core.robust_weights import (
    RobustWeights,
    bin_neighbours,
    unit_weights,
)
from crenel.metrology.arm.kinematics import Arm, tip_centres, tip_covariances
from crenel.metrology.calibration.laser_plane_fit import agreeing_levels
from crenel.metrology.calibration.observation_model import (
    Rows,
    SceneModel,
    coordinates,
    corner_rows,
    edge_rows,
    empty_rows,
    stripe_rows,
    with_coordinates,
)
from crenel.metrology.detection.detect_block import Corner, EdgePoints
from crenel.metrology.sensor.camera import Camera
from crenel.metrology.sensor.laser_plane import LaserPlane
from crenel.metrology.stripe import Stripe, empty_stripe
from crenel.metrology.targets.crenellated_block import Crenellated, probing_face
from crenel.metrology.transforms import Floats

LEAST_CERTIFICATE_MM = 1e-6


@dataclass(frozen=True)
class BlockView:
    """The block in the pictures of one pose: points on its edges, and the stripe on it.

    Corners count only if there are no edge points, because corners are computed from edge points.
    """

    block: Crenellated
    edges: tuple[EdgePoints, ...]
    corners: tuple[Corner, ...]
    stripe: Stripe
    level: NDArray[np.str_]  # of each stripe point that counts; empty for others

    def rows(self, camera: Camera, plane: LaserPlane, coordinates: Floats) -> tuple[Rows, Rows]:
        scene = SceneModel(camera, plane, with_coordinates(self.block, coordinates))
        if self.edges:
            shape = edge_rows(scene, self.edges)
        elif self.corners:
            shape = corner_rows(scene, self.corners)
        else:
            shape = empty_rows(scene)
        return shape, stripe_rows(scene, self.stripe, self.level)

    def reclassify_stripe(
        self, camera: Camera, plane: LaserPlane, coordinates: Floats
    ) -> "BlockView":
        block = with_coordinates(self.block, coordinates)
        return replace(self, level=agreeing_levels(camera, block, self.stripe, plane))

    def bin_points(
        self, rows: tuple[Rows, Rows], judged: tuple[RobustWeights, RobustWeights]
    ) -> tuple["BlockView", tuple[RobustWeights, RobustWeights]]:
        shape, stripe = self.edges, self.stripe
        as_shape = judged[0]
        if self.edges:
            shape = self._bin_edges(rows[0], judged[0])
            as_shape = unit_weights(sum(len(edge.uv_px) for edge in shape))
        used = np.flatnonzero(self.level != "")
        few = bin_neighbours(rows[1].places, stripe.sigma_px[used], rows[1].line, judged[1])
        level = self.level[used][few.first]
        u, v = few.uv_px.T
        fewer = Stripe(u, v, stripe.intensity[used][few.first], few.sigma_px, stripe.axis)
        view = replace(self, edges=shape, stripe=fewer, level=level)
        return view, (as_shape, unit_weights(len(level)))

    def _bin_edges(self, rows: Rows, judged: RobustWeights) -> tuple[EdgePoints, ...]:
        few = bin_neighbours(rows.places, rows.sigma, rows.line, judged)
        normal = np.concatenate([edge.normal for edge in self.edges])[few.first]
        line = rows.line[few.first]
        return tuple(
            EdgePoints(edge.edge, few.uv_px[own], normal[own], few.sigma_px[own])
            for number, edge in enumerate(self.edges)
            if (own := line == number).any()
        )

    def stripe_px(self) -> Floats:
        return np.asarray(self.stripe.uv_px[self.level != ""])

    def without_line(self) -> "BlockView":
        return replace(self, stripe=empty_stripe(self.stripe.axis), level=np.zeros(0, "<U5"))


def block_prior(block: Crenellated) -> TargetPrior:
    """The certificate as a prior: every coordinate with its standard uncertainty."""
    count = len(block.edges_x_mm)
    names = tuple(f"edge_x:{i}" for i in range(count))
    names += ("front_y", "back_y", "crest_z", "floor_z", "base_z")
    return TargetPrior(names, coordinates(block), np.maximum(block.sds_mm, LEAST_CERTIFICATE_MM))


def block_contacts(
    arm: Arm,
    block: Crenellated,
    features: Sequence[str],
    q_rad: Floats,
    kept: NDArray[np.bool_],
) -> ContactObservations:
    """Contact points (N) on the block's faces at encoder angles (N, n)."""
    moves = arm_motion(arm, q_rad)
    values = coordinates(block)
    faces = {face: _face(block, face, values) for face in set(features)}
    return ContactObservations(
        tuple(features),
        np.array([faces[face][0] for face in features]),
        np.array([faces[face][1] for face in features]),
        arm.tip.radius_mm,
        tip_centres(arm, q_rad),
        moves.T_arm_flange[:, :3, :3],
        tip_by_links(moves, arm.tip.centre_mm),
        tip_covariances(arm, q_rad),
        kept,
    )


def _face(block: Crenellated, face: str, values: Floats) -> tuple[Floats, Floats]:
    """Normal (3,) of a face, and its offset as a linear function (B,) of the coordinates."""
    normal, offset_mm = probing_face(block, face)
    by_coordinates = np.zeros(len(values))
    for k in range(len(values)):
        moved = values.copy()
        moved[k] += 1.0
        by_coordinates[k] = probing_face(with_coordinates(block, moved), face)[1] - offset_mm
    return normal, by_coordinates
