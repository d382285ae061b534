"""What is said of pictures that are dark, overexposed or blurred."""

from pathlib import Path
from typing import Any

import cv2
import numpy as np
import pytest
from numpy.typing import NDArray

from crenel.metrology.detection.image_quality import edge_blur_px, grey_levels, image_findings
from crenel.metrology.image import Image
from crenel_hardware.simulator.session import SessionPlan, render_session
from tests.metrology.refusals import refusal_of
from tests.metrology.rendered_block import render_block
from tests.pictures import Depth, blur, of_depth, read_picture


@pytest.fixture(scope="module")
def image() -> NDArray[np.uint8]:
    return render_block(4).image


def codes(picture: Image) -> list[str]:
    return [finding.code for finding in image_findings(picture)]


def test_nothing_is_wrong_with_a_good_picture(image: NDArray[np.uint8]) -> None:
    assert codes(image) == []


@pytest.mark.parametrize("kind", [np.uint8, np.uint16])
def test_a_black_picture_is_dark(kind: Depth) -> None:
    rng = np.random.default_rng(1)
    noise = of_depth(rng.integers(0, 4, (480, 640)), kind)
    assert codes(noise) in (["image-dark"], ["image-dim"])
    assert codes(of_depth(np.zeros((480, 640)), kind)) == ["image-dark"]


def test_a_dim_picture_and_an_overexposed_one(image: NDArray[np.uint8]) -> None:
    assert codes((image // 5).astype(np.uint8)) == ["image-dim"]
    bright = np.clip(image.astype(float) * 3, 0, 255).astype(np.uint8)
    assert codes(bright) == ["image-saturated"]


def test_a_sharp_picture_that_is_half_black_is_not_called_blurred(image: NDArray[np.uint8]) -> None:
    half = image.copy()
    half[half.shape[0] // 2 :] = 0
    assert codes(half) == []


@pytest.mark.parametrize("width_px", [640, 800, 1280])
def test_the_picture_of_a_small_camera_is_not_called_soft(width_px: int, tmp_path: Path) -> None:
    """Lens and pixels blur by the same number of pixels, however few the pixels are."""
    render_session(tmp_path, 5, SessionPlan(width_px=width_px, height_px=width_px * 4 // 5))
    (sharp,) = tmp_path.glob("images/*ambient*")
    assert codes(read_picture(sharp)) == []


@pytest.mark.parametrize("sigma_px", [1.5, 2.5, 4.0, 6.0])
def test_the_blur_is_measured(image: NDArray[np.uint8], sigma_px: float) -> None:
    soft = np.asarray(cv2.GaussianBlur(image.astype(np.float64), (0, 0), sigma_px), np.float64)
    soft += np.random.default_rng(2).normal(0, 1.5, image.shape)
    # The lens has blurred by 0.7 px, the pixels by the root of a twelfth.
    assert edge_blur_px(soft) == pytest.approx(np.sqrt(sigma_px**2 + 0.49 + 1 / 12), rel=0.2)


def test_soft_and_blurred(image: NDArray[np.uint8]) -> None:
    assert codes(blur(image, 2.0)) == ["image-soft"]
    assert codes(blur(image, 5.0)) == ["image-blurred"]


def test_a_twelve_bit_picture_reads_as_an_eight_bit_one(image: NDArray[np.uint8]) -> None:
    wide, _ = grey_levels((image.astype(np.uint16) * 16) + 8)
    assert np.abs(wide - image).max() < 1.0
    assert codes(image.astype(np.uint16) * 16) == []


@pytest.mark.parametrize("bad", [np.zeros((480, 640, 3), np.uint8), np.zeros((480, 640))])
def test_what_is_not_a_grey_picture_is_refused(bad: NDArray[Any]) -> None:
    assert refusal_of(image_findings, bad).code == "image-not-grey"
