"""The camera drivers on pictures that the tests make: files, a folder, a network stream."""

import contextlib
import socket
import threading
import time
from collections.abc import Iterator
from http.server import BaseHTTPRequestHandler, ThreadingHTTPServer
from pathlib import Path

import cv2
import numpy as np
import pytest
from numpy.typing import NDArray

from crenel.metrology.bayer import BAYER_PATTERNS, BayerPattern, BayerPlane
from crenel.metrology.colour import LaserColour
from crenel_hardware.errors import DeviceError
from crenel_hardware.interfaces import SelectedColour, SensorDriver
from crenel_hardware.sensor import folder, opencv_camera
from crenel_hardware.sensor.grey import to_grey
from tests.hardware.conformance import SensorBench, SensorConformance
from tests.hardware.reading import LONG_S, next_frame, opened, wait_until

pytestmark = pytest.mark.device

Picture = NDArray[np.uint8] | NDArray[np.uint16]
WIDTH, HEIGHT, PICTURES, RATE_HZ = 160, 128, 7, 60.0


def picture(index: int) -> NDArray[np.uint8]:
    """A noise picture that differs from all others."""
    return np.random.default_rng(index).integers(0, 256, (HEIGHT, WIDTH), dtype=np.uint8)


def write_video(path: Path, codec: str) -> None:
    writer = cv2.VideoWriter(
        str(path), cv2.VideoWriter.fourcc(*codec), RATE_HZ, (WIDTH, HEIGHT), isColor=False
    )
    assert writer.isOpened()
    for index in range(PICTURES):
        writer.write(picture(index))
    writer.release()


def write_folder(path: Path) -> None:
    path.mkdir()
    for index in range(PICTURES):
        cv2.imwrite(str(path / f"{index}.png"), picture(index))


class PathBench(SensorBench):
    """Unplugging a recording takes it away."""

    def __init__(self, path: Path, driver: SensorDriver) -> None:
        self._path = path
        self._away = path.with_name("away")
        self._driver = driver

    def driver(self) -> SensorDriver:
        return self._driver

    def unplug(self) -> None:
        self._path.rename(self._away)

    def plug_in(self) -> None:
        self._away.rename(self._path)


@pytest.mark.parametrize(
    "codec", ["FFV1", pytest.param("MJPG", marks=pytest.mark.soak)], scope="class"
)
class TestVideoFile(SensorConformance):
    @pytest.fixture
    def bench(self, tmp_path: Path, codec: str) -> SensorBench:
        path = tmp_path / "block.avi"
        return PathBench(path, video_of(path, codec, loop=True))


class TestFolder(SensorConformance):
    @pytest.fixture
    def bench(self, tmp_path: Path) -> SensorBench:
        path = tmp_path / "block"
        write_folder(path)
        return PathBench(path, folder_of(path, RATE_HZ))


def camera_of(source: object, **options: object) -> SensorDriver:
    return opencv_camera.from_options({"source": source, **options})


def video_of(path: Path, codec: str = "FFV1", **options: object) -> SensorDriver:
    """A driver of a video that is written."""
    write_video(path, codec)
    return camera_of(str(path), **options)


def folder_of(path: object, rate_hz: float = 200.0, **options: object) -> SensorDriver:
    return folder.from_options({"path": str(path), "rate_hz": rate_hz, **options})


class MjpegServer:
    """A network camera: motion JPEG over HTTP."""

    def __init__(self) -> None:
        self.sent = 0
        self._port = 0
        self._server: ThreadingHTTPServer | None = None
        self._running = threading.Event()
        self.plug_in()
        self.url = f"http://127.0.0.1:{self._port}/video.mjpg"

    def plug_in(self) -> None:
        camera, running = self, threading.Event()
        self._running = running
        running.set()

        class Handler(BaseHTTPRequestHandler):
            def do_GET(self) -> None:
                self.send_response(200)
                self.send_header("Content-Type", "multipart/x-mixed-replace; boundary=next")
                self.end_headers()
                index = 0
                while running.is_set():
                    ok, jpeg = cv2.imencode(".jpg", picture(index % PICTURES))
                    assert ok
                    head = f"--next\r\nContent-Type: image/jpeg\r\nContent-Length: {len(jpeg)}"
                    try:
                        self.wfile.write(head.encode() + b"\r\n\r\n" + jpeg.tobytes() + b"\r\n")
                    except OSError:
                        return
                    index += 1
                    camera.sent += 1
                    time.sleep(1 / RATE_HZ)
                with contextlib.suppress(OSError):
                    self.connection.shutdown(socket.SHUT_RDWR)

            def log_message(self, *_: object) -> None:
                """The test's output stays clean."""

        self._server = ThreadingHTTPServer(("127.0.0.1", self._port), Handler)
        self._server.daemon_threads = True
        self._port = self._server.server_address[1]
        threading.Thread(target=self._server.serve_forever, args=(0.05,), daemon=True).start()

    def unplug(self) -> None:
        self._running.clear()
        server, self._server = self._server, None
        if server is not None:
            server.shutdown()
            server.server_close()


class StreamBench(SensorBench):
    def __init__(self, server: MjpegServer) -> None:
        self._server = server

    def driver(self) -> SensorDriver:
        return camera_of(self._server.url)

    def unplug(self) -> None:
        self._server.unplug()

    def plug_in(self) -> None:
        self._server.plug_in()


@pytest.fixture
def server() -> Iterator[MjpegServer]:
    server = MjpegServer()
    yield server
    server.unplug()


class TestNetworkStream(SensorConformance):
    @pytest.fixture
    def bench(self, server: MjpegServer) -> SensorBench:
        return StreamBench(server)


def shown(driver: SensorDriver, count: int) -> list[Picture]:
    return [next_frame(driver).image for _ in range(count)]


def test_a_lossless_video_arrives_unchanged_and_in_order(tmp_path: Path) -> None:
    with opened(video_of(tmp_path / "v.avi", loop=True)) as driver:
        images = shown(driver, 2 * PICTURES)
    for index, image in enumerate(images):
        np.testing.assert_array_equal(image, picture(index % PICTURES))


def test_a_video_is_stamped_at_its_own_rate(tmp_path: Path) -> None:
    with opened(video_of(tmp_path / "v.avi")) as driver:
        stamps = [next_frame(driver).mid_exposure_ns for _ in range(PICTURES)]
    np.testing.assert_allclose(np.diff(stamps), 1e9 / RATE_HZ, atol=2)


def test_after_the_last_picture_comes_none(tmp_path: Path) -> None:
    write_folder(tmp_path / "f")
    for made in (video_of(tmp_path / "v.avi"), folder_of(tmp_path / "f", 100.0, loop=False)):
        with opened(made) as driver:
            assert len(shown(driver, PICTURES)) == PICTURES
            assert driver.read(0.1) is None
            assert driver.read(0.1) is None


def test_a_slow_reader_of_a_recording_misses_nothing(tmp_path: Path) -> None:
    write_folder(tmp_path / "f")
    with opened(folder_of(tmp_path / "f", 500.0, loop=False)) as driver:
        for number in range(PICTURES):
            time.sleep(0.05)
            assert next_frame(driver).sequence == number
        assert driver.health.lost == 0


def test_a_slow_reader_gets_fresh_pictures_and_the_loss_is_counted(server: MjpegServer) -> None:
    with opened(camera_of(server.url)) as driver:
        sent = server.sent
        wait_until(lambda: server.sent >= sent + 15)
        frames = [next_frame(driver) for _ in range(6)]
        assert 0 < frames[0].sequence <= driver.health.lost


def test_latency_and_half_the_exposure_come_off_the_stamp(server: MjpegServer) -> None:
    with opened(camera_of(server.url, latency_us=400_000.0)) as driver:
        for _ in range(5):
            frame = next_frame(driver)
        assert time.monotonic_ns() - frame.mid_exposure_ns >= 400_000_000


def test_names_are_sorted_as_numbers(tmp_path: Path) -> None:
    for index in (10, 9, 100):
        cv2.imwrite(str(tmp_path / f"image_{index}.bmp"), np.full((4, 6), index, np.uint8))
    with opened(folder_of(tmp_path)) as driver:
        assert [int(image[0, 0]) for image in shown(driver, 4)] == [9, 10, 100, 9]


def test_sixteen_bits_stay_sixteen(tmp_path: Path) -> None:
    image = np.arange(48, dtype=np.uint16).reshape(6, 8) * 1000
    for suffix in ("png", "tif"):
        cv2.imwrite(str(tmp_path / f"a.{suffix}"), image)
    with opened(folder_of(tmp_path)) as driver:
        for got in shown(driver, 2):
            assert got.dtype == np.uint16
            np.testing.assert_array_equal(got, image)


def test_pages_of_a_tiff_are_pictures_and_its_thumbnails_are_none(tmp_path: Path) -> None:
    sizes = {1: (6, 8), 2: (3, 4), 3: (6, 8)}
    pages = [np.full(size, number, np.uint16) for number, size in sizes.items()]
    cv2.imwritemulti(str(tmp_path / "1.tif"), pages)
    cv2.imwrite(str(tmp_path / "2.png"), np.full((6, 8), 4, np.uint16))
    with opened(folder_of(tmp_path)) as driver:
        assert [int(image[0, 0]) for image in shown(driver, 5)] == [1, 3, 4, 1, 3]


def test_a_folder_says_which_picture_is_wrong(tmp_path: Path) -> None:
    write_folder(tmp_path / "f")
    (tmp_path / "f" / "3.png").write_bytes(b"no picture")
    driver = folder_of(tmp_path / "f")
    driver.open()
    shown(driver, 3)
    with pytest.raises(DeviceError, match=r"3\.png cannot be read"):
        driver.read(LONG_S)
    cv2.imwrite(str(tmp_path / "f" / "3.png"), picture(0)[:, :50])
    driver.open()
    shown(driver, 3)
    with pytest.raises(DeviceError, match="from 160 × 128 to 50 × 128 pixels"):
        driver.read(LONG_S)
    (tmp_path / "g").mkdir()
    cv2.imwrite(str(tmp_path / "g" / "0.tif"), picture(0).astype(np.float32))
    with pytest.raises(DeviceError, match=r"0\.tif contains float32 numbers"):
        folder.from_options({"path": str(tmp_path / "g")}).open()


def test_an_empty_or_missing_source_is_named(tmp_path: Path) -> None:
    (tmp_path / "x.avi").write_bytes(bytes(1000))
    for factory, source, words in (
        (folder_of, tmp_path, "no picture in the folder"),
        (folder_of, tmp_path / "x", "There is no folder"),
        (camera_of, str(tmp_path / "y.avi"), "There is no video file"),
        (camera_of, str(tmp_path / "x.avi"), "cannot be played"),
        (camera_of, 61, "The camera 61 cannot be opened"),
        (camera_of, "http://127.0.0.1:9/x", r"The video stream .* cannot be opened"),
        (camera_of, f"file://{tmp_path}/x.avi", "begins with one of rtsp://"),
    ):
        with pytest.raises(DeviceError, match=words):
            factory(source).open()


def test_a_size_is_not_set_of_a_file(tmp_path: Path) -> None:
    with pytest.raises(DeviceError, match="width_px cannot be set for a video file"):
        video_of(tmp_path / "v.avi", width_px=640).open()


@pytest.mark.parametrize(
    ("option", "words"),
    [
        ({"width_px": 640}, "does not support width_px = 640; it offers 160"),
        ({"exposure_us": 2000.0}, "does not accept an exposure"),
    ],
)
def test_a_size_or_exposure_that_the_camera_has_not_is_refused(
    server: MjpegServer, option: dict[str, object], words: str
) -> None:
    with pytest.raises(DeviceError, match=words):
        camera_of(server.url, **option).open()


def test_a_truncated_video_plays_to_its_cut(tmp_path: Path) -> None:
    write_video(tmp_path / "whole.avi", "MJPG")
    whole = (tmp_path / "whole.avi").read_bytes()
    (tmp_path / "cut.avi").write_bytes(whole[: len(whole) // 2])
    with opened(camera_of(str(tmp_path / "cut.avi"))) as driver:
        while driver.read(0.5) is not None:
            pass
        assert 0 < driver.health.received < PICTURES


def assert_grey(got: Picture | None, wanted: NDArray[np.generic] | None) -> None:
    assert got is not None
    assert wanted is not None
    assert got.dtype == wanted.dtype
    np.testing.assert_array_equal(got, wanted)


def test_every_layout_of_a_camera_gives_its_luma() -> None:
    grey = picture(1)
    chroma = np.full_like(grey, 128)
    jpeg = cv2.imencode(".jpg", grey)[1].reshape(1, -1)
    planar = np.vstack([grey, chroma[: HEIGHT // 2]])
    for raw in (grey, np.dstack([grey, chroma]), np.dstack([grey] * 3), planar):
        assert_grey(to_grey(raw, HEIGHT), grey)
    deep = grey.astype(np.uint16) * 257
    assert_grey(to_grey(deep, HEIGHT), deep)
    assert_grey(to_grey(jpeg, HEIGHT), cv2.imdecode(jpeg, cv2.IMREAD_GRAYSCALE))
    assert to_grey(np.zeros((1, 50), np.uint8), HEIGHT) is None


def test_a_lasers_channel_is_taken_of_a_colour_camera() -> None:
    colours = np.dstack([picture(1), picture(2), picture(3)])
    assert_grey(to_grey(colours, HEIGHT, "red"), colours[..., 2])
    jpeg = cv2.imencode(".jpg", colours)[1].reshape(1, -1)
    decoded = cv2.imdecode(jpeg, cv2.IMREAD_COLOR)
    assert decoded is not None
    assert_grey(to_grey(jpeg, HEIGHT, "green"), decoded[..., 1])
    assert to_grey(np.zeros((1, 50), np.uint8), HEIGHT, "red") is None


@pytest.mark.parametrize("pattern", BAYER_PATTERNS)
@pytest.mark.parametrize("colour", ["red", "green", "blue"])
def test_raw_pixels_are_those_of_files(pattern: BayerPattern, colour: LaserColour) -> None:
    rng = np.random.default_rng(4)
    levels = rng.integers(0, 4095, (HEIGHT, 62))
    levels[:4] = 4095
    for raw in ((levels // 16).astype(np.uint8), levels.astype(np.uint16)):
        assert_grey(to_grey(raw, HEIGHT, colour, pattern), BayerPlane(pattern, colour).select(raw))


def test_a_folder_of_raw_pictures_shows_the_lasers_pixels(tmp_path: Path) -> None:
    raw = picture(1)
    cv2.imwrite(str(tmp_path / "a.png"), raw)
    options = {"path": str(tmp_path), "laser_colour": "red", "bayer": "GRBG"}
    driver = folder.from_options(options)
    assert driver.open().selected == SelectedColour("red", "GRBG")
    (seen,) = shown(driver, 1)
    np.testing.assert_array_equal(seen, raw[::2, 1::2])
    driver.close()
    with pytest.raises(DeviceError, match="bayer requires laser_colour"):
        folder.from_options({"path": str(tmp_path), "bayer": "GRBG"})
    cv2.imwrite(str(tmp_path / "a.png"), np.dstack([raw, raw, 255 - raw]))
    with pytest.raises(DeviceError, match="is in colour"):
        driver.open()


@pytest.mark.parametrize("exposure_us", [1.0, 149.0, 2000.0, 20_000.0])
def test_exposures_are_set_in_the_systems_own_units(exposure_us: float) -> None:
    steps, actual_us = opencv_camera.exposure_setting("V4L2", exposure_us)
    assert actual_us == 100 * steps
    assert abs(actual_us - exposure_us) <= 99
    power, actual_us = opencv_camera.exposure_setting("MSMF", exposure_us)
    assert actual_us == pytest.approx(1e6 * 2**power)
    assert 0.70 < actual_us / exposure_us < 1.42


def test_a_usb_camera_is_known_by_name_and_serial_number(tmp_path: Path) -> None:
    usb_device = tmp_path / "devices" / "1-2"
    (usb_device / "1-2:1.0").mkdir(parents=True)
    (usb_device / "serial").write_text("C0042\n")
    video = tmp_path / "video4linux" / "video3"
    video.mkdir(parents=True)
    (video / "name").write_text("Stripe camera\n")
    (video / "device").symlink_to(usb_device / "1-2:1.0")
    for source in (3, "/dev/video3"):
        found = opencv_camera.usb_identity(source, tmp_path / "video4linux")
        assert found == ("Stripe camera", "C0042")
    url = "rtsp://camera.local/stream"
    assert opencv_camera.usb_identity(url, tmp_path / "video4linux") == (url, "")
