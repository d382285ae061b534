"""The object in the sample sessions' pictures, whose true lens is known."""

import json
from pathlib import Path

import cv2
import numpy as np
import pytest
from numpy.typing import NDArray
from scipy.optimize import least_squares

from crenel.formats.datasheets.target import read_object
from crenel.metrology.detection.detect_block import ObjectDetection, detect_object
from crenel.metrology.sensor.camera import Camera, project
from crenel.metrology.targets.crenellated_block import Crenellated
from crenel.metrology.targets.crenellated_block import corners as corners_of
from crenel.metrology.transforms import Floats, rotation_from_vector
from tests.metrology.refusals import refusal_of
from tests.pictures import read_picture
from tests.running.usual import usual

pytestmark = pytest.mark.slow

PICTURES = [("many-poses", 7), ("metal", 0), ("one-pose", 0), ("many-poses", 0), ("metal", 2)]


def block_of(session: Path) -> Crenellated:
    block = read_object(session / "object.json")
    assert isinstance(block, Crenellated)
    return block


def picture_of(session: Path, pose: int) -> NDArray[np.uint8]:
    return read_picture(session / "images" / f"pose{pose:02d}_ambient.png")


def off_the_true_lens(found: ObjectDetection, session: Path) -> float:
    """Rms in px of the corners about the true lens's picture of the block, posed to fit best."""
    truth = json.loads((session / "truth.json").read_text())["camera"]
    block = block_of(session)
    points = np.array([corners_of(block)[corner.name] for corner in found.corners])
    pixels = np.array([[corner.u, corner.v] for corner in found.corners])
    spread = [np.sqrt(np.trace(corner.covariance_px2)) for corner in found.corners]
    sd = np.hypot(spread, 0.05)[:, None]
    start = found.camera

    def off(step: Floats) -> Floats:
        turn = rotation_from_vector(step[:3])
        placed = (turn @ start.rotation, start.translation_mm + step[3:], 1280, 1024)
        camera = Camera(np.array(truth["matrix"]), *placed, np.array(truth["distortion"]))
        return np.ravel((project(camera, points) - pixels) / sd)

    return float(np.sqrt(np.mean(off(least_squares(off, np.zeros(6)).x) ** 2)))


@pytest.mark.parametrize(("name", "pose"), usual(PICTURES, 2, pytest.mark.soak))
def test_corners_lie_where_the_true_lens_puts_them(samples: Path, name: str, pose: int) -> None:
    session = samples / name
    found = detect_object(picture_of(session, pose), block_of(session))
    assert len(found.corners) >= 20
    # In their own deviations and the certificate's: about 1.
    assert off_the_true_lens(found, session) < 1.5
    assert found.rms_px < 0.25


@pytest.mark.parametrize("quarter", usual([1, 2, 3], 1, pytest.mark.soak))
def test_the_camera_may_be_rolled(samples: Path, quarter: int) -> None:
    session = samples / "one-pose"
    image = picture_of(session, 0)
    upright = detect_object(image, block_of(session))
    rolled = detect_object(np.ascontiguousarray(np.rot90(image, quarter)), block_of(session))
    assert rolled.camera.centre_mm == pytest.approx(upright.camera.centre_mm, abs=0.2)
    assert {c.name for c in rolled.corners} == {c.name for c in upright.corners}


@pytest.mark.parametrize(
    ("angle_deg", "zoom"), usual([(87.0, 1.0), (0.0, 1.18)], 1, pytest.mark.soak)
)
def test_merlons_of_one_pitch_are_read_right(samples: Path, angle_deg: float, zoom: float) -> None:
    session = samples / "one-pose"
    image = picture_of(session, 0)
    height, width = image.shape
    M = cv2.getRotationMatrix2D(((width - 1) / 2, (height - 1) / 2), angle_deg, zoom)
    moved = cv2.warpAffine(
        image, M, (width, height), flags=cv2.INTER_CUBIC, borderMode=cv2.BORDER_REPLICATE
    )
    upright = detect_object(image, block_of(session))
    expected = {c.name: M @ [c.u, c.v, 1.0] for c in upright.corners}
    found = detect_object(np.asarray(moved, dtype=np.uint8), block_of(session))
    off = [np.hypot(*(expected[c.name] - [c.u, c.v])) for c in found.corners if c.name in expected]
    assert len(off) >= 20
    assert max(off) < 1.0


@pytest.mark.soak
def test_a_mirrored_picture_is_refused(samples: Path) -> None:
    mirrored = np.ascontiguousarray(picture_of(samples / "metal", 0)[:, ::-1])
    refusal = refusal_of(detect_object, mirrored, block_of(samples / "metal"))
    assert refusal.code == "object-mirrored"


@pytest.mark.soak
def test_another_block_is_refused(samples: Path) -> None:
    image, other = picture_of(samples / "one-pose", 0), block_of(samples / "many-poses")
    assert refusal_of(detect_object, image, other).code == "object-does-not-match"
