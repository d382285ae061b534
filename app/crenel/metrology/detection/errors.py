"""Errors of refused pictures and detections: the reason, and what to do."""

import numpy as np
from numpy.typing import NDArray

from crenel.errors import OperationError
from crenel.messages.limits import beside_limit
from crenel.messages.message import Text, join, message, quantity
from crenel.metrology.detection.edges.measure_all import EdgeMeasurements
from crenel.metrology.detection.image_quality import BLURRED, EDGE_WIDTH, ImageFinding
from crenel.metrology.detection.rejection import RejectionReason
from crenel.metrology.detection.search.coarse_pose import SearchResult
from crenel.metrology.targets.crenellated_block import Crenellated

# Share of the edges in the frame from which the object counts as complete.
COMPLETE_SHARE = 0.9


def refuse_unusable(findings: list[ImageFinding], clipped: NDArray[np.bool_]) -> None:
    """Refuses a black picture, or one that is clipped everywhere.

    Raises:
        OperationError: ``image-dark``, ``image-saturated``.
    """
    for finding in findings:
        hopeless = finding.code == "image-dark" or (
            finding.code == "image-saturated" and float(clipped.mean()) > 0.5
        )
        if hopeless:
            raise OperationError(finding.code, finding.text, "", finding.remedy)


def refuse_bad_image(findings: list[ImageFinding], consequence: Text) -> None:
    """Refuses a picture that is overexposed or blurred, if that is why a step failed.

    Raises:
        OperationError: ``image-saturated``, ``image-blurred``.
    """
    for finding in findings:
        if finding.code in ("image-saturated", "image-blurred"):
            what = join([finding.text, consequence], ": ")
            raise OperationError(finding.code, what, "", finding.remedy)


def not_found_error(found: SearchResult) -> OperationError:
    """The error for a picture in which nothing like the block was found."""
    return OperationError(
        "object-not-found",
        message("no-crenellated-object-found-picture"),
        message("straight-edges-do-not-form-block", segment_count=found.segment_count),
        message("bring-whole-object-into-view-front"),
    )


def unclear_error(block: Crenellated, why: Text) -> OperationError:
    """The error for a block that is not clear enough to be identified."""
    return OperationError(
        "object-unclear",
        message("not-visible-enough", name=block.name),
        why,
        message("light-front-above-so-crests-floors"),
    )


def mismatch_error(block: Crenellated, why: Text) -> OperationError:
    """The error for a block that does not match the certificate."""
    return OperationError(
        "object-does-not-match",
        message(
            "object-does-not-match-certificate",
            name=block.name,
            serial_number=block.serial_number,
        ),
        why,
        message("choose-object-before-camera-if-one"),
    )


def barely_visible_error(
    block: Crenellated, against: RejectionReason, shown: float
) -> OperationError:
    """The error for a block whose hypothesis is as doubtful as the evidence against it.

    ``shown``: the visible share of its edges.
    """
    why = message(
        "rejected-and-few-edges-show", text=against.text, shown=quantity(100 * shown, "%")
    )
    return unclear_error(block, why)


def contradiction_error(
    block: Crenellated, against: RejectionReason, findings: list[ImageFinding], blur_px: float
) -> OperationError:
    """The error for a block that a hypothesis shows, with evidence against it.

    ``blur_px``: the blur at the block's own edges; a soft picture is softer elsewhere.
    """
    if against.alone:
        return unclear_error(
            block,
            message("nothing-else-bears-out-shadow-highlight", text=against.text),
        )
    soft = next((one for one in findings if one.code in ("image-soft", "image-blurred")), None)
    width_px = EDGE_WIDTH * max(blur_px, soft.value if soft is not None else 0.0)
    if soft is not None and against.off_px < width_px:
        return OperationError(
            "object-unclear",
            message("not-sharp-enough", name=block.name),
            message(
                "less-than-pictures-edges-wide", text=against.text, width=quantity(width_px, "px")
            ),
            soft.remedy,
        )
    return mismatch_error(block, against.text)


def mirror_error(block: Crenellated, share: float) -> OperationError:
    """The error for a mirrored block."""
    if share < COMPLETE_SHARE:
        return out_of_frame_error(block, share, message("what-shows-reads-rather-like-objects"))
    return OperationError(
        "object-mirrored",
        message("merlons-read-mirrored-order", name=block.name),
        message("picture-mirrored-camera-looks-objects-back"),
        message("turn-off-cameras-mirroring-turn-object"),
    )


def ambiguity_error(block: Crenellated, share: float) -> OperationError:
    """The error for a picture that more than one hypothesis explains."""
    if share < COMPLETE_SHARE:
        return out_of_frame_error(block, share, message("what-shows-could-more-than-one"))
    return OperationError(
        "object-ambiguous",
        message("picture-can-read-more-than-one", name=block.name),
        message("merlons-read-alike-either-side"),
        message("use-object-whose-merlons-differ-width"),
    )


def out_of_frame_error(block: Crenellated, share: float, why: Text) -> OperationError:
    """The error for a block of which the frame shows too little."""
    return OperationError(
        "object-cut-off",
        message(
            "frame-shows-only-s-visible-edges", share=quantity(100 * share, "%"), name=block.name
        ),
        why,
        message("move-sensor-until-whole-object-picture"),
    )


def refuse_blurred(found: EdgeMeasurements) -> None:
    """Refuses a picture whose edges are too wide to separate its lines.

    Raises:
        OperationError: ``image-blurred``.
    """
    limit_px = BLURRED * max(found.camera.width_px, found.camera.height_px)
    if found.blur_px > limit_px:
        # From 10 % to 90 % of its height, a step is 2.56 standard deviations wide.
        blur, limit = beside_limit(2.56 * found.blur_px, 2.56 * limit_px, "px")
        raise OperationError(
            "image-blurred",
            message("picture-blurred-edges-wide-most-can", blur=blur, limit=limit),
            "",
            message("focus-camera-object-bring-into-working"),
        )


def too_incomplete_error(block: Crenellated, share: float) -> OperationError:
    """The error for a block of which too little is in the frame to identify or use it."""
    return out_of_frame_error(block, share, message("camera-needs-two-levels-four-sides"))
