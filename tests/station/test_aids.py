"""What helps to expose, focus, frame and keep the distance, and the automatic exposure."""

import numpy as np
import pytest

from crenel.guide.calibration.steps.first_pose import first_outline
from crenel.metrology.detection.image_quality import image_findings, measure_image_quality
from crenel.metrology.sensor.camera import Camera
from crenel.metrology.sensor.laser_plane import LaserPlane
from crenel.metrology.sensor.triangulation import sensor_points
from crenel.metrology.stripe import Stripe
from crenel.station.devices.auto_exposure import TARGET, better_exposure_us, brightness
from crenel.station.preview.capture_aids import (
    distance_aid,
    exposure_aid,
    focus_aid,
    framing_aid,
    line_aid,
)
from crenel.station.preview.image_quality import CELL_PX, saturation
from crenel.station.working_distance import WorkingRange, classify_distance
from crenel_hardware.interfaces import Frame
from tests.formats.builders import BLOCK
from tests.pictures import of_depth
from tests.present import present

WIDTH, HEIGHT = 640, 480
RANGE_US = (20.0, 100_000.0)
RIGHT_US = 2000.0


def picture(level: float, blur_px: float = 0.4) -> np.ndarray:
    """Bright bars on grey, their edges blurred."""
    import cv2

    image = np.full((HEIGHT, WIDTH), 40.0)
    for left in range(60, 600, 120):
        image[80:400, left : left + 60] = level
    image = cv2.GaussianBlur(image, (0, 0), blur_px)
    noise = np.random.default_rng(1).normal(0, 1.0, image.shape)
    return np.clip(image + noise, 0, 255).astype(np.uint8)


def test_a_good_picture_is_called_so_in_figures() -> None:
    found = measure_image_quality(picture(180))
    exposure, focus = exposure_aid(found), focus_aid(found)
    assert (exposure.quality, exposure.words) == ("good", "")
    assert exposure.value == pytest.approx(100 * 180 / 255, abs=2)
    assert focus is not None
    assert focus.quality == "good"
    assert 0 < focus.value < 2.56 * 0.0016 * WIDTH


def test_too_bright_too_dark_and_out_of_focus_say_by_how_much() -> None:
    bright = exposure_aid(measure_image_quality(picture(400)))
    assert str(bright.words).startswith("Too bright: ")
    assert str(bright.words).endswith(" % saturated")
    assert bright.value > 3
    assert str(exposure_aid(measure_image_quality(picture(60) // 3)).words).startswith("Too dark")
    soft = present(focus_aid(measure_image_quality(picture(180, blur_px=3.0))))
    assert soft.quality == "attention"
    assert "allowed" in str(soft.words)
    # the aid and the finding report the same width
    (finding,) = image_findings(picture(180, blur_px=3.0))
    assert f"{soft.value:.0f} px wide" in str(finding.text)


@pytest.mark.parametrize(
    ("outline", "words"),
    [
        ([(220, 160, 420, 300)], "Move closer"),
        ([(2, 2, 638, 478)], "Move further"),
        ([(20, 100, 320, 380)], "too far to the left"),
        ([(160, 100, 480, 380)], ""),
    ],
)
def test_the_object_is_led_into_the_frame(
    outline: list[tuple[float, float, float, float]], words: str
) -> None:
    aid = present(framing_aid(outline, WIDTH, HEIGHT))
    assert words in str(aid.words)
    assert (aid.words == "") == (words == "")
    assert framing_aid((), WIDTH, HEIGHT) is None


def test_the_lines_exposure_is_of_the_line() -> None:
    image = np.full((HEIGHT, WIDTH), 10, np.uint8)
    u = np.arange(100.0, 500.0)
    v = np.full(400, 240.0)
    image[240, 100:500] = 180
    good = present(line_aid(image, Stripe(u, v, np.full(400, 170.0), np.full(400, 0.1))))
    assert good.quality == "good"
    image[240, 100:140] = 255
    bright = present(line_aid(image, Stripe(u, v, np.full(400, 170.0), np.full(400, 0.1))))
    assert str(bright.words) == "Line too bright: 10 % saturated"
    assert line_aid(image, Stripe(u[:0], v[:0], v[:0], v[:0])) is None


def test_what_is_saturated_is_marked_where_it_is() -> None:
    image = np.full((HEIGHT, WIDTH), 90, np.uint8)
    image[100, 100] = 255  # a hot pixel
    percent, boxes = saturation(image)
    assert percent == pytest.approx(100 / image.size)
    assert boxes == ()
    image[160:176, 320:384] = 255
    percent, boxes = saturation(image)
    assert boxes == ((320, 160, 4 * CELL_PX, CELL_PX),)
    assert percent == pytest.approx(100 * (16 * 64 + 1) / image.size)


def watch(axis: str = "u") -> WorkingRange:
    """A camera that looks along z, and a laser plane that crosses its view."""
    matrix = np.array([[1600.0, 0, 319.5], [0, 1600.0, 239.5], [0, 0, 1]])
    camera = Camera(matrix, np.eye(3), np.zeros(3), WIDTH, HEIGHT)
    tilt = np.radians(30.0)
    normal = np.array([0.0, np.cos(tilt), np.sin(tilt)])
    if axis == "v":
        normal = normal[[1, 0, 2]]
    plane = LaserPlane(normal, float(normal @ [0, 0, 100.0]))
    return WorkingRange(camera, plane, (95.0, 108.0), "u" if axis == "u" else "v")


@pytest.mark.parametrize("axis", ["u", "v"])
def test_the_bands_lines_lie_at_its_distances(axis: str) -> None:
    found = watch(axis)
    for line, mm in ((found.band.near, 95.0), (found.band.far, 108.0)):
        assert len(line) == 17
        points = sensor_points(found._camera, found._plane, np.array(line))
        np.testing.assert_allclose(np.linalg.norm(points, axis=1), mm, atol=0.05)
    assert found.fits(WIDTH, HEIGHT)
    assert not found.fits(HEIGHT, WIDTH)


def test_the_distance_of_a_line() -> None:
    found = watch()
    u = np.linspace(0, WIDTH - 1, 200)
    at_mm = found.stripe_distance(Stripe(u, np.full(200, 239.5), np.ones(200), np.ones(200)))
    assert at_mm is not None
    assert at_mm.mm == pytest.approx(100.5, abs=1)
    assert at_mm.state == "in"
    aid = distance_aid(classify_distance(120.0, (95.0, 108.0)))
    assert aid.quality == "attention"
    assert str(aid.words) == "Too far: 120 mm, 95 mm to 108 mm required"


@pytest.mark.parametrize("upright", [True, False])
def test_the_first_outline_fills_the_picture(upright: bool) -> None:
    lines = first_outline(BLOCK, 1280, 1024, upright)
    aid = present(framing_aid(lines, 1280, 1024))
    assert aid.words == ""
    assert aid.value == pytest.approx(68, abs=3)
    ends = np.array(lines).reshape(-1, 2)
    wide, tall = np.ptp(ends, axis=0)
    assert (wide > tall) == upright


def frame_of(exposure_us: float, bits: int, shift: int, stripe_only: bool) -> Frame:
    """A laser line on black, or a lit scene, that is right at ``RIGHT_US``."""
    white = (1 << bits) - 1
    rows, columns = np.arange(256)[:, None], np.arange(320)
    light = np.exp(-0.5 * ((rows - 120 - 0.05 * columns) / 2.0) ** 2)
    if not stripe_only:
        light = 0.3 + 0.7 * np.abs(np.sin(columns / 50) * np.sin(rows / 40))
    noise = np.random.default_rng(0).normal(0, 0.004, light.shape)
    grey = white * (0.02 + TARGET * light * exposure_us / RIGHT_US + noise)
    kind = np.uint8 if bits == 8 else np.uint16
    image = np.clip(np.rint(grey), 0, white).astype(np.uint16) << shift
    return Frame(0, 0, of_depth(image, kind), exposure_us, True)


@pytest.mark.parametrize("stripe_only", [True, False])
@pytest.mark.parametrize(("bits", "shift"), [(8, 0), (10, 0), (12, 4), (16, 0)])
@pytest.mark.parametrize("off", [1 / 60, 1 / 8, 1.5, 12, 45])
def test_the_exposure_settles_within_five_frames(
    bits: int, shift: int, off: float, stripe_only: bool
) -> None:
    exposure_us = RIGHT_US * off
    for _ in range(5):
        better = better_exposure_us(frame_of(exposure_us, bits, shift, stripe_only), RANGE_US)
        if better is None:
            break
        exposure_us = better
    settled = frame_of(exposure_us, bits, shift, stripe_only)
    assert better_exposure_us(settled, RANGE_US) is None
    assert brightness(settled) == pytest.approx(TARGET, rel=0.11)


def test_a_black_picture_goes_to_the_longest_exposure_and_a_white_one_to_the_shortest() -> None:
    for grey, end in ((0, RANGE_US[1]), (255, RANGE_US[0])):
        exposure_us = RIGHT_US
        for _ in range(5):
            image = np.full((100, 100), grey, np.uint8)
            frame = Frame(0, 0, image, exposure_us, True)
            exposure_us = better_exposure_us(frame, RANGE_US) or exposure_us
        assert exposure_us == end
