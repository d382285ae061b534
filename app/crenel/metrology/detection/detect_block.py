"""The crenellated block in a calibration image: its edges, its corners, and the camera.

No start values from the operator are needed. The block is found in a reduced image
(``locate_block``), its edges are measured in the full image (``edge_survey``) with a camera fitted
to all of them at once, and the result is accepted only if every edge lies where the certificate
puts it (``acceptance``).
"""

from dataclasses import dataclass

import numpy as np

from crenel.errors import OperationError
from crenel.messages.message import Text, message
from crenel.metrology.detection import acceptance
from crenel.metrology.detection import errors as refusals
from crenel.metrology.detection.corner_fit import Corner, fit_corners
from crenel.metrology.detection.edges.dimension_test import find_unobserved_planes
from crenel.metrology.detection.edges.measure_all import EdgeMeasurements
from crenel.metrology.detection.failure_evidence import with_evidence
from crenel.metrology.detection.image_quality import (
    Image,
    ImageFinding,
    grey_levels,
    image_findings,
    is_noisy,
)
from crenel.metrology.detection.search.coarse_pose import Cleaning, locate_block, working_image
from crenel.metrology.detection.search.verify_hypotheses import (
    NO_ATTEMPT,
    AttemptResult,
    CameraHypothesis,
    verify_hypotheses,
)
from crenel.metrology.detection.stripe_mask import stripe_mask
from crenel.metrology.sensor.camera import Camera
from crenel.metrology.stripe import Stripe
from crenel.metrology.targets.crenellated_block import Crenellated
from crenel.metrology.transforms import Floats

__all__ = [
    "Corner",
    "EdgePoints",
    "ImageFinding",
    "ObjectDetection",
    "detect_object",
    "image_findings",
]

# Longer sides, in pixels, of the images in which the block is searched, and how texture is
# suppressed there: small objects need a larger image, soft and noisy images a smaller one.
_ATTEMPTS: tuple[tuple[int, Cleaning], ...] = (
    (640, "coarse"),
    (640, "fine"),
    (320, "coarse"),
    (640, "speckled"),
    (320, "fine"),
    (1280, "fine"),
)
# If an image is not clear, a hypothesis supported by a smaller share of the visible edges may be
# wrong.
_HALF = 0.5
# An attempt that draws this share of another's edges is equally supported.
_AS_MUCH = 0.8

# The eleven parameters of a camera need at least this many corners, with two coordinates each.
_LEAST_CORNERS = 6


@dataclass(frozen=True)
class EdgePoints:
    """Measured points (N, 2) of one edge; each is free along the edge, and has the standard
    deviation ``sigma_px`` (N,) across it, along ``normal`` (N, 2)."""

    edge: str
    uv_px: Floats
    normal: Floats
    sigma_px: Floats


@dataclass(frozen=True)
class ObjectDetection:
    """The block in an image. ``camera`` has the object frame as its sensor frame; ``rms_px`` is the
    residual of the edge points along their normals; ``unseen`` names the planes of the block whose
    position the image does not show."""

    corners: tuple[Corner, ...]
    edges: tuple[EdgePoints, ...]
    camera: Camera
    rms_px: float
    unobserved_planes: tuple[tuple[int, int], ...] = ()


def detect_object(
    ambient: Image, block: Crenellated, stripe: Stripe | None = None
) -> ObjectDetection:
    """Detects, identifies and measures the block in one image, without start values.

    Args:
        ambient: (H, W) grey, 8 to 16 bits, with ambient light (and laser light, if ``stripe`` is
            given).
        block: the block by its certificate.
        stripe: the points of the laser stripe in this image; its pixels are excluded.

    Returns:
        Corners and edge points with their uncertainty in px, and a camera whose sensor frame is
        the object frame.

    Raises:
        OperationError: ``image-not-grey``.
        DetectionError: ``image-dark``, ``image-saturated``, ``image-blurred``,
            ``object-not-found``, ``object-unclear``, ``object-does-not-match``,
            ``object-mirrored``, ``object-ambiguous`` or ``object-cut-off``, with the cause and the
            evidence in the image.
    """
    grey, clipped = grey_levels(ambient)
    findings = image_findings(ambient)
    lit = None if stripe is None or len(stripe.u) == 0 else stripe_mask(grey, stripe)
    tries: list[AttemptResult] = []
    declined: list[CameraHypothesis] = []
    try:
        refusals.refuse_unusable(findings, clipped)
        hidden = clipped if lit is None else clipped | lit
        for longer_px, cleaning in _ATTEMPTS:
            small, ignore, scale = working_image(grey, lit, longer_px)
            found = locate_block(small, ignore, block, cleaning)
            tried = verify_hypotheses(grey, hidden, found, scale, block, declined)
            tries.append(tried)
            best = max(tries, key=lambda one: one.confirmed_px)
            if tried.good and not tried.doubtful and tried is best:
                _check_earlier_attempts(tried, tries[:-1], findings, block)
                return _detection(_select_measurement(tried, findings, block), block)
            if tried.is_other_object:
                break
        if best.good:
            return _detection(_select_measurement(best, findings, block), block)
        refusals.refuse_bad_image(findings, message("object-not-found"))
        raise _rejection_error(tries, findings, grey, block)
    except OperationError as refusal:
        shown = max(tries, key=lambda one: one.visible_px, default=NO_ATTEMPT)
        raise with_evidence(
            refusal, findings, clipped, shown.search, shown.measured, shown.against
        ) from None


def _check_earlier_attempts(
    tried: AttemptResult,
    before: list[AttemptResult],
    findings: list[ImageFinding],
    block: Crenellated,
) -> None:
    """Refuses a detection if an earlier attempt drew about as much of another object.

    Raises:
        OperationError: ``object-does-not-match``.
    """
    for one in before:
        as_much = one.visible_px > _AS_MUCH * tried.visible_px
        if one.nearest is not None and one.against is not None and one.against.definite and as_much:
            raise refusals.contradiction_error(block, one.against, findings, one.nearest.blur_px)


def _select_measurement(
    tried: AttemptResult, findings: list[ImageFinding], block: Crenellated
) -> EdgeMeasurements:
    """The measured hypothesis, if it is the only one and usable.

    Raises:
        OperationError: ``image-blurred``, ``image-saturated``, ``object-ambiguous``,
            ``object-mirrored``, ``object-cut-off``.
    """
    located, measured = tried.good[0]
    refusals.refuse_blurred(measured)
    share = acceptance.share_in_frame(measured)
    if tried.is_ambiguous or acceptance.is_symmetric(block):
        refusals.refuse_bad_image(findings, message("can-read-more-than-one-way"))
        raise refusals.ambiguity_error(block, share)
    if located.mirrored:
        raise refusals.mirror_error(block, share)
    if acceptance.is_cut_off(measured, block, share):
        raise refusals.too_incomplete_error(block, share)
    return measured


def _rejection_error(
    tries: list[AttemptResult], findings: list[ImageFinding], grey: Floats, block: Crenellated
) -> OperationError:
    """The error after the last attempt: another object, or an object that is not clear enough."""
    best = max(tries, key=lambda one: one.visible_px)
    # Lines that mostly do not form a block belong to tool marks and other things, which may hide
    # it.
    block_like = [acceptance.is_block_like(one.search) for one in tries]
    seen_well = not findings and not is_noisy(grey) and sum(block_like) > len(tries) / 2
    # A hypothesis with little support cannot say where the frame cuts the block off.
    if best.nearest is not None and best.visible_share > acceptance.LEAST_VISIBLE:
        share = acceptance.share_in_frame(best.nearest)
        if acceptance.is_cut_off(best.nearest, block, share):
            return refusals.too_incomplete_error(block, share)
    if best.nearest is not None and best.against is not None and best.against.definite:
        if not seen_well and best.visible_share < _HALF:
            return refusals.barely_visible_error(block, best.against, best.visible_share)
        return refusals.contradiction_error(block, best.against, findings, best.nearest.blur_px)
    if not any(block_like):
        return refusals.not_found_error(tries[0].search)
    why: Text = message("no-placing-edges-explains-those-picture")
    if best.against is not None:
        why = best.against.text
        seen_well = seen_well and not best.against.hidden
    return refusals.mismatch_error(block, why) if seen_well else refusals.unclear_error(block, why)


def _detection(measured: EdgeMeasurements, block: Crenellated) -> ObjectDetection:
    at = measured.at
    edges = []
    for edge in np.unique(at.edge[measured.used]):
        rows = np.flatnonzero(measured.used & (at.edge == edge))
        edges.append(
            EdgePoints(
                measured.frame.names[edge],
                measured.uv_px[rows],
                at.normal[rows],
                measured.sigma_px[rows],
            )
        )
    off = measured.off_px[measured.used]
    corners = fit_corners(measured)
    if len(corners) < _LEAST_CORNERS:
        raise refusals.unclear_error(
            block, message("only-corners-can-measured", found=len(corners))
        )
    return ObjectDetection(
        corners,
        tuple(edges),
        measured.camera,
        float(np.sqrt(np.mean(off**2))),
        find_unobserved_planes(measured),
    )
