"""Raw pictures of colour cameras are recognised, whatever they show, and grey ones are not."""

from pathlib import Path

import cv2
import numpy as np
import pytest
from numpy.typing import NDArray

from app.metrology.bayer import BAYER_PATTERNS, BayerPattern, BayerPlane
from app.metrology.chessboard.detect_board import detect_board
from app.metrology.colour import LaserColour
from app.metrology.detection.failure_evidence import DetectionError
from app.metrology.detection.image_quality import image_findings
from app.metrology.image import Image
from app.metrology.mosaic import shows_mosaic
from app.metrology.targets.chessboard import Chessboard
from tests.colours import expose, mosaic, render_colours
from tests.pictures import compressed

SENSITIVITY = np.array([0.65, 1.0, 0.5])
"""Of a camera's blue, green and red pixels in daylight."""


def read_colours(path: Path) -> NDArray[np.uint8]:
    return np.asarray(cv2.imread(str(path), cv2.IMREAD_COLOR), np.uint8)


def raw_of(colours: NDArray[np.uint8], pattern: BayerPattern) -> NDArray[np.uint8]:
    """What a camera without white balance would have sent."""
    return mosaic((colours * SENSITIVITY).astype(np.uint8), pattern)


@pytest.mark.parametrize("pattern", BAYER_PATTERNS)
@pytest.mark.parametrize("colour", ["red", "green", "blue"])
@pytest.mark.parametrize("width_px", [3.0, 20.0])
def test_a_line_shows_a_mosaic(pattern: BayerPattern, colour: LaserColour, width_px: float) -> None:
    light = render_colours(colour, width_px)
    assert shows_mosaic(mosaic(expose(light, seed=1), pattern))
    assert shows_mosaic(mosaic(expose(4.0 * light, seed=1), pattern))  # clipped
    dark = light - light.min(axis=(0, 1)) + 2.0
    assert shows_mosaic(mosaic(expose(dark, seed=1), pattern))
    plane = BayerPlane(pattern, colour).select(mosaic(expose(light, seed=1), pattern))
    assert not shows_mosaic(plane)


def test_real_scenes_show_a_mosaic_only_if_raw(real: Path) -> None:
    for path in sorted((real / "boards/wide").iterdir())[:4]:
        colours = read_colours(path)
        for pattern in BAYER_PATTERNS:
            raw = raw_of(colours, pattern)
            assert shows_mosaic(raw)
            assert shows_mosaic((raw.astype(np.uint16) * 16).astype(np.uint16))
            assert shows_mosaic(compressed(raw, 75))
        interpolated = cv2.cvtColor(raw_of(colours, "RGGB"), cv2.COLOR_BayerRGGB2GRAY)
        assert not shows_mosaic(np.asarray(interpolated, np.uint8))


def harder(grey: NDArray[np.uint8]) -> dict[str, Image]:
    """Pictures that alternate in their own ways."""
    noise = np.random.default_rng(0).normal(0, 20, grey.shape)
    soft = cv2.GaussianBlur(grey, (0, 0), 1)
    rows = grey.copy()
    rows[1::2] = np.roll(rows[1::2], 4, axis=1) * 0.9
    return {
        "as it is": grey,
        "JPEG": compressed(grey, 30),
        "noisy": np.clip(grey + noise, 0, 255).astype(np.uint8),
        "sharpened": np.asarray(cv2.addWeighted(grey, 3, soft, -2, 0), np.uint8),
        "every second pixel": np.ascontiguousarray(grey[::2, ::2]),
        "each pixel twice": np.kron(grey, np.ones((2, 2), np.uint8)),
        "interlaced": rows,
    }


@pytest.mark.parametrize("kind", ["boards/*/*2*.jpg", "lines/weld/*.png", "robot*/calib1/*2.png"])
def test_real_grey_pictures_show_none(real: Path, kind: str) -> None:
    files = sorted(real.glob(kind))[:6]
    assert files
    for path in files:
        grey = np.asarray(cv2.imread(str(path), cv2.IMREAD_GRAYSCALE), np.uint8)
        for name, picture in harder(grey).items():
            assert not shows_mosaic(picture), (path.name, name)


def test_noise_and_small_pictures_show_none() -> None:
    rng = np.random.default_rng(3)
    for shape in ((8, 8), (16, 16), (128, 160), (480, 640)):
        assert not shows_mosaic(rng.normal(60, 15, shape).clip(0, 255).astype(np.uint8))
        assert not shows_mosaic(np.zeros(shape, np.uint16))


def test_a_board_in_a_raw_picture_is_refused_for_that(real: Path) -> None:
    board = Chessboard("B", "1", (8, 6), 10.0, 0.01)
    raw = raw_of(read_colours(sorted((real / "boards/wide").iterdir())[0]), "GRBG")
    assert [finding.code for finding in image_findings(raw)] == ["image-raw"]
    with pytest.raises(DetectionError, match=r"raw picture of a colour camera.*--bayer") as refused:
        detect_board(raw, board)
    assert refused.value.fault == "camera"
    assert len(detect_board(BayerPlane("GRBG", "green").select(raw), board).number) >= 40
