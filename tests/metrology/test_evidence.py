"""A refused picture says what is at fault, and marks it where it shows."""

import numpy as np
import pytest

from crenel.errors import OperationError
from crenel.metrology.detection.detect_block import detect_object
from crenel.metrology.detection.errors import contradiction_error
from crenel.metrology.detection.failure_evidence import DetectionError, with_evidence
from crenel.metrology.detection.image_quality import ImageFinding, edge_blur_px
from crenel.metrology.detection.rejection import RejectionReason
from crenel.metrology.image import Image
from crenel.metrology.sensor.camera import project
from crenel.metrology.targets.crenellated_block import Crenellated
from crenel.metrology.targets.crenellated_block import corners as corners_of
from crenel_hardware.simulator.rendering.degradations import draw_degraded_image
from tests.bench.metrology.detection import block_certificate, detect_block
from tests.metrology.refusals import detection_refusal_of
from tests.metrology.rendered_block import RenderedBlock, with_edge
from tests.pictures import blur
from tests.running.usual import usual

pytestmark = pytest.mark.slow


def refused(image: Image, block: Crenellated) -> DetectionError:
    return detection_refusal_of(detect_object, image, block)


def marks_of(refusal: DetectionError, kind: str) -> np.ndarray:
    """(N, 4) the lines of one kind."""
    lines = [(m.u0, m.v0, m.u1, m.v1) for m in refusal.marks if m.kind == kind]
    return np.array(lines).reshape(-1, 4)


def test_overexposed_faces_are_framed(plain: RenderedBlock) -> None:
    bright = np.clip(plain.image.astype(float) * 4, 0, 255).astype(np.uint8)
    refusal = refused(bright, plain.block)
    assert (refusal.code, refusal.fault) == ("image-saturated", "exposure")
    boxes = marks_of(refusal, "clipped")
    v, u = np.nonzero(bright == 255)
    assert boxes[:, [0, 2]].min() == pytest.approx(u.min(), abs=8)
    assert boxes[:, [1, 3]].max() == pytest.approx(v.max(), abs=8)


def test_a_blurred_picture_is_the_focus_s_fault(plain: RenderedBlock) -> None:
    refusal = refused(blur(plain.image, 6.0), plain.block)
    assert (refusal.code, refusal.fault) == ("image-blurred", "focus")


def test_in_a_dim_picture_more_light_is_the_first_remedy() -> None:
    dim = ImageFinding("image-dim", "the picture is dim", "turn up the light", 0.04, 0.15)
    unclear = OperationError("object-unclear", "it is not clear", "few edges show", "come nearer")
    refusal = with_evidence(unclear, [dim], np.zeros((8, 8), np.bool_), None, None, None)
    assert refusal.fault == "exposure"
    assert str(refusal.why) == "the picture is dim; few edges show"
    assert str(refusal.remedy) == "turn up the light; come nearer"


def test_a_picture_with_hardly_an_edge_out_of_its_noise_is_declined(plain: RenderedBlock) -> None:
    noise = np.random.default_rng(0).normal(size=(5, *plain.image.shape))[-1]
    dim = np.clip(np.rint(4 + 0.027 * plain.image + 2.5 * noise), 0, 255).astype(np.uint8)
    assert np.isinf(edge_blur_px(dim.astype(float)))
    assert refused(dim, plain.block).fault == "exposure"


def test_a_wrong_size_is_marked_where_it_disagrees(plain: RenderedBlock) -> None:
    claimed = with_edge(plain.block, 3, 1.0)
    refusal = refused(plain.image, claimed)
    assert (refusal.code, refusal.fault) == ("object-does-not-match", "object")
    wrong = marks_of(refusal, "disagrees")
    assert len(wrong)
    at = corners_of(claimed)
    ends = project(plain.camera, np.array([at["crest:1:R:front"], at["crest:1:R:back"]]))
    assert min(np.hypot(*(line.reshape(2, 2) - ends).T).max() for line in wrong) < 5.0
    assert len(marks_of(refusal, "outline")) > 10


@pytest.mark.parametrize("begin", usual([440, 480], 1, pytest.mark.soak))
def test_what_is_out_of_the_frame_is_marked(plain: RenderedBlock, begin: int) -> None:
    # A window on the right of the picture shows one whole merlon.
    window = np.ascontiguousarray(plain.image[:, begin:])
    refusal = refused(window, plain.block)
    assert (refusal.code, refusal.fault) == ("object-cut-off", "framing")
    outside = marks_of(refusal, "outside")
    assert len(outside)
    assert (outside[:, [0, 2]] < 0).all()


def test_straight_edges_are_shown_where_there_is_no_block(plain: RenderedBlock) -> None:
    board = (np.indices(plain.image.shape) // 60).sum(axis=0) % 2 * 150 + 40
    refusal = refused(board.astype(np.uint8), plain.block)
    assert refusal.code in ("object-not-found", "object-does-not-match")
    assert refusal.fault in ("framing", "object", "lighting")
    assert refusal.marks


def test_a_single_edge_elsewhere_is_not_called_another_object(plain: RenderedBlock) -> None:
    """A shadow along a crest is like a merlon of another width."""
    edge = "the left edge of the crest of merlon 3 lies 90 µm off"
    against = RejectionReason(edge, True, (1,), True, 1.4)
    refusal = contradiction_error(plain.block, against, [], 0.7)
    assert refusal.code == "object-unclear"
    assert "the crest of merlon 3" in str(refusal.why)
    assert "shadow" in str(refusal.why)


def refused_shot(seed: int) -> DetectionError:
    shot = draw_degraded_image(seed)
    return detection_refusal_of(detect_block, shot, block_certificate(shot.certificate))


@pytest.mark.soak
def test_no_wrong_size_is_reported_from_a_placing_that_hardly_shows() -> None:
    """A bar, noise and tool marks: what is placed is not quite the block."""
    refusal = refused_shot(6023)
    assert refusal.code == "object-unclear"
    assert "of its visible edges appear" in str(refusal.why)


def test_floors_and_base_in_shadow_are_not_called_another_object() -> None:
    refusal = refused_shot(5130)
    assert (refusal.code, refusal.fault) == ("object-unclear", "lighting")
    assert "none of the edges of its floors and its base" in str(refusal.why)


SOFT = ImageFinding("image-soft", "soft", "focus the camera", 3.0, 2.0)


@pytest.mark.parametrize(
    ("off_px", "findings", "code"),
    [
        (5.0, [SOFT], "object-unclear"),
        (9.0, [SOFT], "object-does-not-match"),
        (5.0, [], "object-does-not-match"),
    ],
)
def test_a_soft_picture_shows_no_size_to_less_than_its_edges_are_wide(
    plain: RenderedBlock, off_px: float, findings: list[ImageFinding], code: str
) -> None:
    edge = "the front edge of the base lies 90 µm off"
    against = RejectionReason(edge, True, (1,), off_px=off_px)
    refusal = contradiction_error(plain.block, against, findings, 3.0)
    assert refusal.code == code
    assert ("focus the camera" in str(refusal.remedy)) == (code == "object-unclear")
