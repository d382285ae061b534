"""What is said of pictures that are dark, overexposed or blurred."""

import cv2
import numpy as np
import pytest

from app.errors import OperationError
from app.metrology.detection.image_quality import edge_blur_px, grey_levels, image_findings
from tests.metrology.rendered_block import render_block


@pytest.fixture(scope="module")
def image():
    return render_block(4).image


def codes(picture) -> list[str]:
    return [finding.code for finding in image_findings(picture)]


def test_nothing_is_wrong_with_a_good_picture(image):
    assert codes(image) == []


@pytest.mark.parametrize("kind", [np.uint8, np.uint16])
def test_a_black_picture_is_dark(kind):
    rng = np.random.default_rng(1)
    assert codes(rng.integers(0, 4, (480, 640)).astype(kind)) in (["image-dark"], ["image-dim"])
    assert codes(np.zeros((480, 640), kind)) == ["image-dark"]


def test_a_dim_picture_and_an_overexposed_one(image):
    assert codes((image // 5).astype(np.uint8)) == ["image-dim"]
    bright = np.clip(image.astype(float) * 3, 0, 255).astype(np.uint8)
    assert codes(bright) == ["image-saturated"]


def test_a_sharp_picture_that_is_half_black_is_not_called_blurred(image):
    half = image.copy()
    half[half.shape[0] // 2 :] = 0
    assert codes(half) == []


@pytest.mark.parametrize("blur", [1.5, 2.5, 4.0, 6.0])
def test_the_blur_is_measured(image, blur):
    soft = cv2.GaussianBlur(image.astype(np.float64), (0, 0), blur)
    soft += np.random.default_rng(2).normal(0, 1.5, image.shape)
    # The lens has blurred by 0.7 px, the pixels by the root of a twelfth.
    assert edge_blur_px(soft) == pytest.approx(np.sqrt(blur**2 + 0.49 + 1 / 12), rel=0.2)


def test_soft_and_blurred(image):
    assert codes(cv2.GaussianBlur(image, (0, 0), 2.0)) == ["image-soft"]
    assert codes(cv2.GaussianBlur(image, (0, 0), 5.0)) == ["image-blurred"]


def test_a_twelve_bit_picture_reads_as_an_eight_bit_one(image):
    wide, _ = grey_levels((image.astype(np.uint16) * 16) + 8)
    assert np.abs(wide - image).max() < 1.0
    assert codes(image.astype(np.uint16) * 16) == []


@pytest.mark.parametrize("bad", [np.zeros((480, 640, 3), np.uint8), np.zeros((480, 640))])
def test_what_is_not_a_grey_picture_is_refused(bad):
    with pytest.raises(OperationError) as refused:
        image_findings(bad)
    assert refused.value.code == "image-not-grey"
