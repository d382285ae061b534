"""What goes into the adjustment: what each pose's pictures show, and the contact points."""

from collections.abc import Sequence
from dataclasses import dataclass, replace
from typing import Protocol

import numpy as np
from numpy.typing import NDArray

from app.errors import OperationError
from app.messages.message import message
from app.metrology.adjustment.core.arm_errors import FlangeMotion
from app.metrology.adjustment.core.hand_eye import Thing
from app.metrology.adjustment.core.robust_weights import RobustWeights
from app.metrology.calibration.observation_model import Rows
from app.metrology.detection.detect_block import ObjectDetection
from app.metrology.detection.image_quality import ImageFinding
from app.metrology.sensor.camera import Camera
from app.metrology.sensor.laser_plane import LaserPlane
from app.metrology.stripe import Stripe
from app.metrology.transforms import Floats, inverse


class PoseView(Protocol):
    """What the pictures of one pose show of the object."""

    def rows(self, camera: Camera, plane: LaserPlane, coordinates: Floats) -> tuple[Rows, Rows]:
        """Observation equations of the object's shape, and of the stripe.

        Args:
            camera: with the object's frame as its sensor frame.
            plane: the laser plane in the object's frame.
            coordinates: (B,) the object's own, as in its ``TargetPrior``.

        Returns:
            rows whose parameters are the camera's (``projection.PARAMETERS``), the
            plane's two tilts and offset, and the B coordinates.
        """
        ...

    def reclassify_stripe(
        self, camera: Camera, plane: LaserPlane, coordinates: Floats
    ) -> "PoseView":
        """The same, with the stripe's points judged against this camera and plane."""
        ...

    def bin_points(
        self, rows: tuple[Rows, Rows], judged: tuple[RobustWeights, RobustWeights]
    ) -> tuple["PoseView", tuple[RobustWeights, RobustWeights]]:
        """Fewer points of equal weight, by what was judged of the ``rows`` of these, and
        how those count; a view of few points may give itself."""
        ...

    def stripe_px(self) -> Floats:
        """(N, 2) pixels of the stripe that are in use."""
        ...

    def without_line(self) -> "PoseView":
        """The same with no stripe at all."""
        ...


@dataclass(frozen=True)
class TargetPrior:
    """The object's coordinates by its certificate, each known to a standard deviation (mm)."""

    names: tuple[str, ...]
    coordinates: Floats  # (B,)
    sd: Floats  # (B,)


@dataclass(frozen=True)
class ContactObservations:
    """N contact points: the tip's centre lies one radius outside the face that was touched.

    In the object's frame a face has the normal ``normals`` (N, 3) and the offset
    ``offset_by_coordinates @ coordinates`` (N, B). Tip centres ``tips_mm`` (N, 3) are by
    the arm's model, the flange turned by ``R_arm_flange`` (N, 3, 3); ``by_links``
    (N, 3, 6n) is how they move with the links' errors and
    ``noise_mm2`` (N, 3, 3) their covariance by the encoders' noise. ``kept`` (N,) are
    those that agree with one another.
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
    """All that is to agree: P poses seen, contacts (perhaps none), and the prior."""

    numbers: tuple[int, ...]
    views: tuple[PoseView, ...]
    motion: FlangeMotion
    contacts: ContactObservations | None
    prior: TargetPrior
    width_px: int
    height_px: int

    def without_poses(self, left_out: NDArray[np.bool_]) -> "AdjustmentProblem":
        """The same without the poses marked (P,)."""
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
    """Contact residuals (N,) in mm, positive outward, and what they change with."""

    residuals_mm: Floats
    by_place: Floats  # (N, 6) left twist of T_arm_obj
    by_links: Floats  # (N, 6n)
    by_coordinates: Floats  # (N, B)
    noise_mm2: Floats  # (N,) variance by the encoders


def contact_rows(
    touches: ContactObservations, T_arm_obj: Floats, coordinates: Floats, links: Floats
) -> ContactRows:
    """How the tips lie on their faces, for a place of the object and errors of the links (6n,)."""
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


@dataclass(frozen=True)
class FailedPose:
    """A pose whose pictures could not be used, and why."""

    number: int
    error: OperationError


def require_observations(
    seen: Sequence[object], unseen: Sequence[FailedPose], thing: Thing
) -> None:
    """Refuses where no picture shows the ``thing``, with the reason of the first.

    Raises:
        OperationError: the first picture's own, or that there is no picture.
    """
    if seen:
        return
    if unseen:
        raise unseen[0].error
    raise OperationError(
        "no-images", message("no-pose-given"), "", message("take-picture-2", thing=thing)
    )


@dataclass(frozen=True)
class BlockObservation:
    """What the pictures of one pose showed, each by itself."""

    number: int
    detection: ObjectDetection
    stripe: Stripe
    image_findings: tuple[ImageFinding, ...] = ()
