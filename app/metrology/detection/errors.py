"""Why a picture or what was found in it is declined, in words, and what to do."""

import numpy as np
from numpy.typing import NDArray

from app.errors import OperationError
from app.metrology.detection.edges.measure_all import EdgeMeasurements
from app.metrology.detection.image_quality import BLURRED, EDGE_WIDTH, ImageFinding
from app.metrology.detection.rejection import RejectionReason
from app.metrology.detection.search.coarse_pose import SearchResult
from app.metrology.targets.crenellated_block import Crenellated

# Share of the edges in the frame that makes the object whole.
COMPLETE_SHARE = 0.9


def refuse_unusable(findings: list[ImageFinding], clipped: NDArray[np.bool_]) -> None:
    """Refuses a black picture and one that is clipped all over.

    Raises:
        OperationError: ``image-dark``, ``image-saturated``.
    """
    for finding in findings:
        hopeless = finding.code == "image-dark" or (
            finding.code == "image-saturated" and float(clipped.mean()) > 0.5
        )
        if hopeless:
            raise OperationError(finding.code, finding.text, "", finding.remedy)


def refuse_bad_image(findings: list[ImageFinding], consequence: str) -> None:
    """Refuses a picture that is overexposed or blurred, where that is why a step failed.

    Raises:
        OperationError: ``image-saturated``, ``image-blurred``.
    """
    for finding in findings:
        if finding.code in ("image-saturated", "image-blurred"):
            raise OperationError(finding.code, f"{finding.text}: {consequence}", "", finding.remedy)


def not_found_error(found: SearchResult) -> OperationError:
    """The refusal for a picture in which nothing like the block was found."""
    return OperationError(
        "object-not-found",
        "no crenellated object was found in the picture",
        f"its {found.segment_count} straight edges do not make a block",
        "bring the whole object into view, from its front and above, and light it evenly",
    )


def unclear_error(block: Crenellated, why: str) -> OperationError:
    """The refusal for a block that is not seen well enough to be sure of it."""
    return OperationError(
        "object-unclear",
        f"{block.name} is not seen well enough to be sure of it",
        why,
        "light it from the front and above so that crests, floors and front differ, come"
        " nearer, and clear away what stands before it",
    )


def mismatch_error(block: Crenellated, why: str) -> OperationError:
    """The refusal for a block that is not the certificate's."""
    return OperationError(
        "object-does-not-match",
        f"the object in the picture does not match the certificate of {block.name}"
        f" ({block.serial_number})",
        why,
        "choose the object that is before the camera; if it is this one, look whether its"
        " edges are clean and undamaged",
    )


def barely_visible_error(
    block: Crenellated, against: RejectionReason, shown: float
) -> OperationError:
    """The refusal for a block whose placing is as doubtful as what is objected to it.

    ``shown``: the share of its visible edges that shows.
    """
    few = f"only {100 * shown:.0f} % of its visible edges show in the picture"
    return unclear_error(block, f"{against.text}, and {few}")


def contradiction_error(
    block: Crenellated, against: RejectionReason, findings: list[ImageFinding], blur_px: float
) -> OperationError:
    """The refusal for a block that a placing shows, but for what is objected to that.

    ``blur_px``: the blur at the block's own edges; a picture that was found soft is softer
    elsewhere.
    """
    if against.alone:
        return unclear_error(
            block,
            f"{against.text}, and nothing else bears that out: a shadow, a highlight or something"
            " before it may look like that",
        )
    soft = next((one for one in findings if one.code in ("image-soft", "image-blurred")), None)
    width_px = EDGE_WIDTH * max(blur_px, soft.value if soft is not None else 0.0)
    if soft is not None and against.off_px < width_px:
        return OperationError(
            "object-unclear",
            f"{block.name} is not seen sharply enough to be sure of it",
            f"{against.text}, less than the {width_px:.0f} px that the picture's edges are wide",
            soft.remedy,
        )
    return mismatch_error(block, against.text)


def mirror_error(block: Crenellated, share: float) -> OperationError:
    """The refusal for a block that reads the wrong way round."""
    if share < COMPLETE_SHARE:
        return out_of_frame_error(
            block, share, "what it shows reads rather like the object's mirror image"
        )
    return OperationError(
        "object-mirrored",
        f"the merlons of {block.name} read in the mirrored order",
        "the picture is mirrored, or the camera looks at the object's back",
        "turn off the camera's mirroring, or turn the object so that its front faces the camera",
    )


def ambiguity_error(block: Crenellated, share: float) -> OperationError:
    """The refusal for a picture that more than one placing explains."""
    if share < COMPLETE_SHARE:
        return out_of_frame_error(
            block, share, "what it shows could be more than one part of the object"
        )
    return OperationError(
        "object-ambiguous",
        f"the picture of {block.name} can be read in more than one way",
        "its merlons read alike from either side",
        "use an object whose merlons differ in width",
    )


def out_of_frame_error(block: Crenellated, share: float, why: str) -> OperationError:
    """The refusal for a block of which the frame shows too little."""
    return OperationError(
        "object-cut-off",
        f"the frame shows only {100 * share:.0f} % of {block.name}'s visible edges",
        why,
        "move the sensor until the whole object is in the picture",
    )


def refuse_blurred(found: EdgeMeasurements) -> None:
    """Refuses a picture whose edges are too wide for its lines to keep apart.

    Raises:
        OperationError: ``image-blurred``.
    """
    limit_px = BLURRED * max(found.camera.width_px, found.camera.height_px)
    if found.blur_px > limit_px:
        # From a tenth to nine tenths of its height, a step is 2.56 standard deviations wide.
        raise OperationError(
            "image-blurred",
            f"the picture is blurred: its edges are {2.56 * found.blur_px:.0f} px wide,"
            f" at most {2.56 * limit_px:.0f} px can be measured",
            "",
            "focus the camera on the object, bring it into the working distance, hold it still",
        )


def too_incomplete_error(block: Crenellated, share: float) -> OperationError:
    """The refusal for a block of which the frame leaves too little to tell it or to use it."""
    return out_of_frame_error(
        block, share, "a camera needs two levels and four sides of its merlons"
    )
