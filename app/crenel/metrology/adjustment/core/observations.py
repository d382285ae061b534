"""The data of the adjustment: the pictures of each pose, and the contact points."""

from collections import Counter
from collections.abc import Sequence
from dataclasses import dataclass, replace
from typing import Protocol

import numpy as np
from numpy.typing import NDArray

from crenel.errors import OperationError
from crenel.messages.message import message
from crenel.metrology.adjustment.core.arm_errors import FlangeMotion
from crenel.metrology.adjustment.core.hand_eye import Thing
from crenel.metrology.adjustment.core.robust_weights import RobustWeights
from crenel.metrology.calibration.observation_model import Rows
from crenel.metrology.detection.detect_block import ObjectDetection
from crenel.metrology.detection.image_quality import ImageFinding
from crenel.metrology.sensor.camera import Camera
from crenel.metrology.sensor.laser_plane import LaserPlane
from crenel.metrology.stripe import Stripe
from crenel.metrology.transforms import Floats, inverse


class PoseView(Protocol):
    """The object in the pictures of one pose."""

    def rows(self, camera: Camera, plane: LaserPlane, coordinates: Floats) -> tuple[Rows, Rows]:
        """Observation equations of the object's shape, and of the stripe.

        Args:
            camera: with the object's frame as its sensor frame.
            plane: the laser plane in the object's frame.
            coordinates: (B,) coordinates of the object, as in its ``TargetPrior``.

        Returns:
            Rows whose parameters are the camera's (``projection.PARAMETERS``), the
            plane's two tilts and offset, and the B coordinates.
        """
        ...

    def reclassify_stripe(
        self, camera: Camera, plane: LaserPlane, coordinates: Floats
    ) -> "PoseView":
        """The view with the stripe points judged against this camera and plane."""
        ...

    def bin_points(
        self, rows: tuple[Rows, Rows], judged: tuple[RobustWeights, RobustWeights]
    ) -> tuple["PoseView", tuple[RobustWeights, RobustWeights]]:
        """The view with fewer points of equal weight, by the judgement of its ``rows``, and the
        weights of those; a view with few points may return itself."""
        ...

    def stripe_px(self) -> Floats:
        """(N, 2) pixels of the stripe that are in use."""
        ...

    def without_line(self) -> "PoseView":
        """The view without a stripe."""
        ...


@dataclass(frozen=True)
class TargetPrior:
    """The coordinates of the object by its certificate, each with a standard deviation (mm)."""

    names: tuple[str, ...]
    coordinates: Floats  # (B,)
    sd: Floats  # (B,)


@dataclass(frozen=True)
class ContactObservations:
    """N contact points: the tip centre is one radius outside the face that was probed.

    In the object frame, a face has the normal ``normals`` (N, 3) and the offset
    ``offset_by_coordinates @ coordinates`` (N, B). Tip centres ``tips_mm`` (N, 3) are those of the
    arm's model, with the flange rotated by ``R_arm_flange`` (N, 3, 3); ``by_links`` (N, 3, 6n) are
    their derivatives by the link errors and ``noise_mm2`` (N, 3, 3) their covariance due to the
    encoder noise. ``kept`` (N,) marks the contact points that agree with each other.
    """

    features: tuple[str, ...]
    normals: Floats
    offset_by_coordinates: Floats
    radius_mm: float
    tips_mm: Floats
    R_arm_flange: Floats
    by_links: Floats
    noise_mm2: Floats
    inliers: NDArray[np.bool_]

    def __len__(self) -> int:
        return len(self.features)


@dataclass(frozen=True)
class AdjustmentProblem:
    """The adjustment problem: P seen poses, contact points (possibly none), and the prior.

    Without ``has_lines``, the laser plane is no unknown, and where it ``keeps_sensor``, neither are
    camera and mounting: they keep the values of the start.
    """

    numbers: tuple[int, ...]
    views: tuple[PoseView, ...]
    motion: FlangeMotion
    contacts: ContactObservations | None
    prior: TargetPrior
    width_px: int
    height_px: int
    has_lines: bool = True
    keeps_sensor: bool = False

    def without_poses(self, left_out: NDArray[np.bool_]) -> "AdjustmentProblem":
        """The problem without the poses marked (P,)."""
        keep = np.flatnonzero(~left_out)
        motion = self.motion
        return replace(
            self,
            numbers=tuple(self.numbers[i] for i in keep),
            views=tuple(self.views[i] for i in keep),
            motion=replace(
                motion,
                T_arm_flange=motion.T_arm_flange[keep],
                by_links=motion.by_links[keep],
                by_noise=motion.by_noise[keep],
            ),
        )


@dataclass(frozen=True)
class ContactRows:
    """Residuals (N,) of the contact points in mm, positive outward, and their derivatives."""

    residuals_mm: Floats
    by_place: Floats  # (N, 6) left twist of T_arm_obj
    by_links: Floats  # (N, 6n)
    by_coordinates: Floats  # (N, B)
    noise_mm2: Floats  # (N,) variance due to the encoders


def contact_rows(
    touches: ContactObservations, T_arm_obj: Floats, coordinates: Floats, links: Floats
) -> ContactRows:
    """Distances of the tips from their faces, for a pose of the object and link errors (6n,)."""
    tips = touches.tips_mm + touches.by_links @ links
    T_obj_arm = inverse(T_arm_obj)
    in_obj = tips @ T_obj_arm[:3, :3].T + T_obj_arm[:3, 3]
    normals_arm = touches.normals @ T_arm_obj[:3, :3].T
    offsets = touches.offset_by_coordinates @ coordinates + touches.radius_mm
    return ContactRows(
        np.sum(touches.normals * in_obj, axis=1) - offsets,
        -np.column_stack([np.cross(tips, normals_arm), normals_arm]),
        np.einsum("ni,nis->ns", normals_arm, touches.by_links),
        -touches.offset_by_coordinates,
        np.einsum("ni,nij,nj->n", normals_arm, touches.noise_mm2, normals_arm),
    )


PICTURE_TWICE = "picture-twice"
"""Code of a pose whose picture is that of another pose."""


@dataclass(frozen=True)
class FailedPose:
    """A pose whose pictures could not be used, with the reason."""

    number: int
    error: OperationError


def require_observations(
    seen: Sequence[object], unseen: Sequence[FailedPose], thing: Thing
) -> None:
    """Refuses the input if no picture shows the ``thing``, with the commonest reason.

    Raises:
        OperationError: that of the first picture with the commonest reason, or ``no-images``.
    """
    if seen:
        return
    if unseen:
        codes = [pose.error.code for pose in unseen]
        raise unseen[codes.index(Counter(codes).most_common(1)[0][0])].error
    raise OperationError(
        "no-images", message("no-pose-given"), "", message("take-picture-of-target", thing=thing)
    )


@dataclass(frozen=True)
class BlockObservation:
    """The detections in the pictures of one pose, by themselves."""

    number: int
    detection: ObjectDetection
    stripe: Stripe
    image_findings: tuple[ImageFinding, ...] = ()

    @property
    def fingerprint(self) -> bytes:
        """Equal for pictures with the same pixels, and for these alone."""
        edges = [edge.uv_px for edge in self.detection.edges]
        return b"".join(uv.tobytes() for uv in edges)
