"""Lines from a camera that finds them itself: real sockets, read through Aravis.

The camera is ours, with the features of real profile cameras; Aravis and the driver do not know it.
"""

import time
from collections.abc import Iterator
from contextlib import closing

import numpy as np
import pytest
from numpy.typing import NDArray

from crenel_hardware.errors import DeviceError
from crenel_hardware.interfaces import (
    DeliversLines,
    Delivery,
    Frame,
    Line,
    SensorDriver,
    SensorReading,
)
from crenel_hardware.sensor.genicam.profiles.profile_points import INTENSITY
from crenel_hardware.sensor.grabbing import GrabbingSensor
from crenel_hardware.simulator.devices.gige_camera.camera import GigeCamera
from crenel_hardware.simulator.devices.gige_camera.pixels import RawImage
from crenel_hardware.simulator.devices.gige_camera.profile_features import SCALE_PX
from crenel_hardware.simulator.devices.gige_camera.registers import CameraIdentity
from crenel_hardware.simulator.rendering.line_sensor import find_line, find_profile
from crenel_hardware.simulator.rendering.noise import Detector
from tests.hardware.conformance import SensorBench, SensorConformance
from tests.hardware.fake_cameras import ADDRESS
from tests.hardware.reading import (
    LONG_S,
    loss_of,
    next_frame,
    next_reading,
    opened,
    read_until_delivery,
)
from tests.hardware.test_genicam import require_aravis
from tests.hardware.test_simulated_gige import GigeBench, serve
from tests.hardware.test_simulated_gige import make_driver as make_gige_driver

pytestmark = [pytest.mark.device, pytest.mark.xdist_group("gige")]

WIDTH, HEIGHT = 320, 240
DELAY_MS = 5.0
DETECTOR = Detector()
LINE_AND_PICTURE: tuple[Delivery, Delivery] = ("line", "picture")
DARK = range(100, 120)
"""Columns without a line."""


@pytest.fixture(autouse=True)
def reader() -> None:
    require_aravis()


def row_in(columns: NDArray[np.floating]) -> NDArray[np.float64]:
    """Where the line is in each column: a slope with a step."""
    return np.asarray(60.0 + 0.3 * columns + 20.0 * (columns > WIDTH // 2))


def picture(mid_ns: int, exposure_us: float, laser_share: float) -> RawImage:
    """A line on a dark ground, which lies still; the exposure is its brightness."""
    columns, rows = np.arange(float(WIDTH)), np.arange(HEIGHT)[:, None]
    peak = min(0.03 * exposure_us, 240.0) * laser_share
    light = peak * np.exp(-0.5 * ((rows - row_in(columns)) / 1.7) ** 2)
    light[:, DARK] = 0.0
    image: RawImage = np.rint(DETECTOR.dark_dn + light).clip(0, 255).astype(np.uint8)
    return image


def make_camera(
    first_block_id: int = 1, fewest_profiles: int = 1, sends_parts: bool = True
) -> GigeCamera:
    return GigeCamera(
        CameraIdentity(ADDRESS, "SIM-1", WIDTH, HEIGHT, 50.0, fewest_profiles, sends_parts),
        picture,
        delay_ms=DELAY_MS,
        first_block_id=first_block_id,
        find_line=lambda image: find_profile(image, DETECTOR),
    )


@pytest.fixture
def camera() -> Iterator[GigeCamera]:
    with serve(make_camera()) as made:
        yield made


def make_driver(**more: object) -> GrabbingSensor:
    driver = make_gige_driver(**more)
    assert isinstance(driver, DeliversLines)
    return driver


@pytest.fixture
def driver(camera: GigeCamera) -> Iterator[GrabbingSensor]:
    with closing(make_driver(exposure_us=5000.0)) as driver:
        yield driver


class ProfileBench(GigeBench):
    def make_camera(self, first_block_id: int = 1) -> GigeCamera:
        return make_camera(first_block_id)


class TestSimulatedProfileCamera(SensorConformance):
    @pytest.fixture
    def bench(self) -> Iterator[SensorBench]:
        bench = ProfileBench()
        yield bench
        bench.end()


def open_lit(driver: GrabbingSensor) -> None:
    driver.open()
    driver.set_laser(True)


def next_line(driver: SensorDriver) -> Line:
    reading = next_reading(driver)
    assert isinstance(reading, Line)
    return reading


def assert_counts_fit(driver: SensorDriver, camera: GigeCamera) -> None:
    """A busy machine may lose what the camera sent, but counts nothing else as lost."""
    assert driver.health.received + driver.health.lost <= camera.blocks


def lit_frame(driver: GrabbingSensor) -> Frame:
    """A picture with the laser on all through its exposure; the laser comes on during the first."""
    while not next_frame(driver).laser_on:
        pass
    return next_frame(driver)


def lit_line(driver: GrabbingSensor) -> Line:
    """A line with the laser on all through its exposure; the laser may come on during the first."""
    driver.set_delivery("line")
    read_until_delivery(driver, "line")
    while not next_line(driver).laser_on:
        pass
    return next_line(driver)


def test_a_line_is_the_one_in_the_picture(driver: GrabbingSensor) -> None:
    open_lit(driver)
    frame = lit_frame(driver)
    line = lit_line(driver)
    driver.close()
    wanted = find_line(frame, DETECTOR)
    np.testing.assert_array_equal(line.u, wanted.u)
    np.testing.assert_allclose(line.v, wanted.v, atol=SCALE_PX / 2)
    assert not set(DARK) & set(line.u.astype(int))
    assert len(line.u) == WIDTH - len(DARK)
    assert (line.width_px, line.height_px) == (WIDTH, HEIGHT)
    assert line.exposure_us == 5000.0
    np.testing.assert_array_equal(line.intensity, np.rint(wanted.intensity))
    assert np.ptp(line.intensity) > 0


def test_a_camera_of_one_component_gives_lines_of_one_intensity() -> None:
    with serve(make_camera(sends_parts=False)), closing(make_driver(exposure_us=5000.0)) as driver:
        open_lit(driver)
        line = lit_line(driver)
    assert set(line.intensity) == {INTENSITY}
    np.testing.assert_allclose(line.v, row_in(line.u), atol=0.1)


def test_a_stated_deviation_counts_and_else_the_scatter_of_the_line(camera: GigeCamera) -> None:
    """This picture has no noise. The errors of the line's centre are periodic along the line, and
    their differences overstate them."""
    with closing(make_driver(exposure_us=5000.0, line_sigma_px=0.3)) as driver:
        open_lit(driver)
        assert set(lit_line(driver).sigma_px) == {0.3}
    with closing(make_driver(exposure_us=5000.0)) as driver:
        open_lit(driver)
        line = lit_line(driver)
    (sigma_px,) = set(line.sigma_px)
    assert sigma_px >= SCALE_PX / np.sqrt(12)
    true_px = np.std(line.v - row_in(line.u))
    assert true_px < sigma_px < 3 * true_px


@pytest.mark.parametrize("rows", ["region", "sensor"])
def test_a_region_s_corner_is_the_lines_zero(camera: GigeCamera, rows: str) -> None:
    """This camera counts rows from the region's first one on."""
    x, y, width, height = region = [16, 40, 240, 128]
    options = {"region": region, "line_rows": rows, "line_offset_px": 0.25}
    with closing(make_driver(exposure_us=5000.0, **options)) as driver:
        open_lit(driver)
        line = lit_line(driver)
        driver.set_delivery("picture")
        frame = read_until_delivery(driver, "picture")
    assert isinstance(frame, Frame)
    assert frame.image.shape == (height, width)
    assert (line.width_px, line.height_px) == (width, height)
    away_px = line.v - (row_in(line.u + x) - y)
    expected_px = 0.25 if rows == "region" else 0.25 - y
    np.testing.assert_allclose(away_px, expected_px, atol=0.1)
    assert line.v.min() >= -0.5
    assert line.v.max() < height - 0.5


def test_changing_to_and_fro_loses_no_count(camera: GigeCamera, driver: GrabbingSensor) -> None:
    open_lit(driver)
    last: SensorReading = next_frame(driver)
    for _ in range(5):
        for delivery in LINE_AND_PICTURE:
            driver.set_delivery(delivery)
            first = read_until_delivery(driver, delivery)
            second = next_reading(driver)
            assert second.sequence > first.sequence > last.sequence
            assert second.mid_exposure_ns > first.mid_exposure_ns > last.mid_exposure_ns
            assert second.laser_on
            last = second
    assert driver.health.corrupt == 0
    assert last.sequence < driver.health.received + driver.health.lost + 64
    assert_counts_fit(driver, camera)


def test_the_exposure_is_kept_when_it_changes(driver: GrabbingSensor) -> None:
    open_lit(driver)
    changes: list[tuple[Delivery, float]] = [("line", 7e3), ("picture", 4e3), ("line", 4e3)]
    for delivery, exposure_us in changes:
        driver.set_delivery(delivery)
        driver.set_exposure_us(exposure_us)
        deadline = time.monotonic() + LONG_S
        while read_until_delivery(driver, delivery).exposure_us != exposure_us:
            assert time.monotonic() < deadline


def test_lines_come_at_a_rate_of_their_own(camera: GigeCamera) -> None:
    with closing(make_driver(exposure_us=1000.0, rate_hz=20.0, line_rate_hz=100.0)) as driver:
        open_lit(driver)
        assert camera._exposures is not None
        rates: list[tuple[Delivery, float]] = [("line", 100.0), ("picture", 20.0), ("line", 100.0)]
        for delivery, rate_hz in rates:
            driver.set_delivery(delivery)
            read_until_delivery(driver, delivery)
            assert camera._exposures._rate_hz() == pytest.approx(rate_hz)


def test_a_camera_of_many_profiles_a_buffer_goes_on_with_pictures() -> None:
    with serve(make_camera(fewest_profiles=8)) as camera, closing(make_driver()) as driver:
        assert driver.open().delivers == {"picture", "line"}
        with pytest.raises(DeviceError, match="64 profiles into one buffer") as caught:
            driver.set_delivery("line")
        assert caught.value.remedy
        for _ in range(3):
            next_frame(driver)
        assert_counts_fit(driver, camera)


def test_lost_lines_are_counted() -> None:
    camera = make_camera()
    camera.faults.resends = False
    with serve(camera), opened(make_driver()) as driver:
        driver.set_delivery("line")
        first = read_until_delivery(driver, "line")
        camera.faults.lost_packets = frozenset((block, 1) for block in range(1, 2000, 3))
        lines = [next_line(driver) for _ in range(20)]
        gaps = lines[-1].sequence - first.sequence - len(lines)
        assert gaps >= 5
        assert driver.health.lost >= gaps


def test_a_camera_without_profiles_sends_pictures_alone() -> None:
    camera = GigeCamera(CameraIdentity(ADDRESS, "SIM-1", WIDTH, HEIGHT, 50.0), picture)
    with serve(camera), closing(make_driver()) as driver:
        assert driver.open().delivers == {"picture"}
        driver.set_delivery("picture")
        with pytest.raises(DeviceError, match="pictures alone"):
            driver.set_delivery("line")
        next_frame(driver)
    with pytest.raises(DeviceError, match="not open"):
        driver.set_delivery("picture")


def test_a_triggered_camera_numbers_its_lines_by_pulses(camera: GigeCamera) -> None:
    driver = make_driver(trigger="Line1", exposure_us=1000.0)
    driver.open()
    counted = 0
    for delivery in LINE_AND_PICTURE[::-1]:
        driver.set_delivery(delivery)
        wanted, last = Frame if delivery == "picture" else Line, None
        while not isinstance(last, wanted):  # at first, the camera does not hear the triggers
            camera.trigger(time.monotonic_ns())
            last = driver.read(0.5)
        while (reading := driver.read(0.5)) is not None:
            last = reading
        assert last.pulse is not None
        assert last.pulse > counted, "it counts on"
        counted = last.pulse
        for _ in range(3):
            camera.trigger(time.monotonic_ns())
            counted += 1
            assert read_until_delivery(driver, delivery).pulse == counted
    assert_counts_fit(driver, camera)
    driver.close()


def test_a_camera_is_lost_while_it_sends_lines(camera: GigeCamera, driver: GrabbingSensor) -> None:
    open_lit(driver)
    driver.set_delivery("line")
    read_until_delivery(driver, "line")
    camera.faults.unplugged = True
    loss_of(driver, 0.2)
    with pytest.raises(DeviceError):
        driver.set_delivery("picture")
    camera.faults.unplugged = False
