"""The live picture: encoded while watched, described in words, with the object where it is seen."""

import asyncio
import json
import struct
import time
from collections.abc import Iterator
from pathlib import Path

import numpy as np
import pytest

from crenel.formats.datasheets.target import read_block
from crenel.formats.images import read_grey
from crenel.formats.settings.mask import Mask
from crenel.formats.settings.scan_settings import ScanSettings
from crenel.metrology.stripe import Stripe, extract_stripe
from crenel.station.bus import Bus
from crenel.station.devices.rig import Rig
from crenel.station.preview.preview import STRIPE_POINTS, Preview, PreviewImage, decimate, jpeg
from tests.pictures import decode_picture
from tests.station.conftest import HEIGHT, REST_RAD, WIDTH, Bench, until

pytestmark = pytest.mark.device


@pytest.fixture
def preview(bus: Bus, rig: Rig) -> Iterator[Preview]:
    preview = Preview(bus, rig.arm, rig.sensor)
    preview.start()
    yield preview
    preview.stop()


def newest(preview: Preview) -> PreviewImage:
    """A picture made from now on."""
    before = preview.latest()
    until(lambda: preview.latest() is not before)
    image = preview.latest()
    assert image is not None
    return image


def test_nothing_is_made_while_nobody_watches(preview: Preview, rig: Rig) -> None:
    arrived = rig.sensor.link().received
    until(lambda: rig.sensor.link().received > arrived + 20)
    assert preview.latest() is None
    with preview.watch():
        newest(preview)


def test_the_packed_picture_is_header_and_jpeg(preview: Preview, rig: Rig) -> None:
    rig.sensor.set_laser(True)
    with preview.watch():
        until(lambda: newest(preview).header.laser_on)
        packed = newest(preview).to_bytes()
    length = struct.unpack(">I", packed[:4])[0]
    header = json.loads(packed[4 : 4 + length])
    assert (header["width_px"], header["height_px"]) == (WIDTH, HEIGHT)
    assert header["arm_still"] is True
    assert 0 < len(header["stripe"]) <= STRIPE_POINTS
    np.testing.assert_allclose([v for _, v in header["stripe"]], 120.0, atol=1.0)
    picture = decode_picture(packed[4 + length :])
    assert picture.shape == (HEIGHT, WIDTH)


def test_a_moving_arm_and_a_bright_picture_are_reported(preview: Preview, bench: Bench) -> None:
    bench.joints_at = lambda seconds: REST_RAD + 0.1 * np.sin(5 * seconds)
    bench.scene_level = 1.0
    with preview.watch():
        until(lambda: newest(preview).header.saturated_percent > 50)
        until(lambda: any("saturated" in str(aid.words) for aid in newest(preview).header.aids))
        # the scripted arm jumps to its swing, which is reported first
        until(lambda: any("Moved" in str(one.text) for one in newest(preview).header.findings))
        header = newest(preview).header
    assert not header.arm_still
    assert len(header.findings) > 1
    assert header.saturated
    assert "Moved" in str(header.findings[0].text)
    assert all(finding.quality == "attention" for finding in header.findings)


def test_one_encode_serves_all_and_goes_over_the_bus(preview: Preview, bus: Bus) -> None:
    async def scenario() -> None:
        bus.attach(asyncio.get_running_loop())
        with preview.watch(), bus.subscribe() as one, bus.subscribe() as two:
            pictures = []
            for reader in (one, two):
                while "preview" not in (topics := (await reader.next()).topics):
                    pass
                pictures.append(topics["preview"])
            assert all(isinstance(picture, PreviewImage) for picture in pictures)
        bus.detach()

    asyncio.run(scenario())


def test_a_large_picture_is_made_small_and_a_deep_one_shown_in_full_range() -> None:
    wide = np.zeros((1024, 1280), dtype=np.uint16)
    wide[:, 640:] = 4095
    picture = decode_picture(jpeg(wide))
    assert picture.shape == (640, 800)
    assert picture[:, 420:].min() > 240
    assert picture[:, :380].max() < 15


def test_a_stripe_is_thinned_evenly() -> None:
    u = np.arange(1280.0)
    points = decimate(Stripe(u, 2 * u, u, u))
    assert len(points) <= STRIPE_POINTS
    np.testing.assert_allclose(np.diff([x for x, _ in points]), points[1][0] - points[0][0])
    assert decimate(None) == ()


def test_an_object_is_found_and_then_lost(preview: Preview, bench: Bench, samples: Path) -> None:
    session = samples / "one-pose"
    ambient = read_grey(session / "images/pose00_ambient.png")
    bench.picture = ambient
    preview.detect(read_block(session / "object.json"))
    until(lambda: len(newest(preview).header.corners) > 8)
    header = newest(preview).header
    assert header.width_px == ambient.shape[1]
    assert len(header.outline) > 10
    residuals = [corner.residual_px for corner in header.corners]
    assert max(r for r in residuals if r is not None) < 1.0
    bench.picture = np.full_like(ambient, 90)
    until(lambda: not newest(preview).header.corners)
    assert any(finding.remedy for finding in newest(preview).header.findings)
    preview.detect(None)
    with preview.watch():
        until(lambda: newest(preview).header.outline == ())


def test_what_was_found_goes_with_its_hold(preview: Preview, bench: Bench, samples: Path) -> None:
    session = samples / "one-pose"
    bench.picture = read_grey(session / "images/pose00_ambient.png")
    preview.detect(read_block(session / "object.json"))
    until(lambda: len(newest(preview).header.corners) > 8)
    began_s = time.monotonic()
    # 0.05 rad a second: between a picture and its search's end the camera is elsewhere
    bench.joints_at = lambda seconds: REST_RAD + 0.05 * (seconds + bench.start_s - began_s)
    until(lambda: newest(preview).header.corners == ())
    passing = [newest(preview).header for _ in range(8)]
    assert {(header.corners, header.outline) for header in passing} == {((), ())}
    held_s = time.monotonic()
    bench.joints_at = lambda seconds: REST_RAD + 0.05 * (held_s - began_s)
    until(lambda: len(newest(preview).header.corners) > 8)
    preview.detect(None)


def test_the_stripe_of_a_real_picture_is_drawn_on_it(samples: Path) -> None:
    picture = read_grey(samples / "one-pose/images/pose00_laser.png")
    stripe = extract_stripe(picture)
    at = np.array(decimate(stripe)).round().astype(int)
    assert np.median(picture[at[:, 1], at[:, 0]]) > 3 * np.median(picture)


def test_zones_cut_the_stripe_without_an_object(preview: Preview, rig: Rig, samples: Path) -> None:
    corners = ((-2.0, -2.0), (WIDTH / 2, -2.0), (WIDTH / 2, HEIGHT + 2.0), (-2.0, HEIGHT + 2.0))
    preview.set_settings(
        ScanSettings(mask=Mask(width_px=WIDTH, height_px=HEIGHT, zones=(corners,)))
    )
    rig.sensor.set_laser(True)
    with preview.watch():
        until(lambda: newest(preview).header.stripe)
        assert min(u for u, _ in newest(preview).header.stripe) > WIDTH / 2
        preview.detect(read_block(samples / "one-pose" / "object.json"))
        until(lambda: min(u for u, _ in newest(preview).header.stripe) < WIDTH / 4)
        preview.detect(None)
        until(lambda: min(u for u, _ in newest(preview).header.stripe) > WIDTH / 2)
