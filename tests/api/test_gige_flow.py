"""A sensor whose camera speaks GigE Vision: server and scanned through its real stream.

One of a hundred packets is lost on the line. The simulated camera is ours; the driver reads it
through Aravis, which is not.
"""

import asyncio
import uuid
from collections.abc import Iterator
from contextlib import contextmanager
from dataclasses import replace
from typing import Any

import numpy as np
import pytest

from crenel_hardware.simulator.devices.gige_camera.faults import GigeFaults
from tests.api.calibrated import use_truth
from tests.api.conftest import Server, running_server, until, wait_for
from tests.api.test_robot_flow import distances_from_plate_um, scan_plate, stated_um
from tests.api.test_watch import topics
from tests.bench.faults.served import HALF
from tests.hardware.fake_cameras import port_for_this_test
from tests.hardware.test_genicam import require_aravis
from tests.sent_texts import english

pytestmark = [pytest.mark.device, pytest.mark.xdist_group("gige")]

CONFIG = replace(HALF, camera="gige", frames_hz=25.0)
LOST_PACKETS = 0.01
SLOW_BYTES_PER_S = 2e6
"""A quarter of what the pictures need."""


@pytest.fixture(scope="module")
def server(tmp_path_factory: pytest.TempPathFactory) -> Iterator[Server]:
    require_aravis()
    with port_for_this_test(), running_server(tmp_path_factory.mktemp("gige"), CONFIG) as server:
        server.simulation.gige_camera.faults.packet_drop_rate = LOST_PACKETS
        yield server
    assert not server.sent.untranslated()


@pytest.mark.soak
def test_a_whole_calibration_through_its_stream(server: Server) -> None:
    """On the block, by the simulated operator, from the first step to the accepted calibration."""
    server.http.post("/api/flow/start").raise_for_status()
    server.do("confirm_devices")
    server.do("choose", field="object", id="simulated")
    server.do("confirm_setup")
    view = server.simulate_up_to_review()
    result = view["picture"]["result"]
    # at half the size, block edges look soft: attention is called to that
    assert result["verdict"] in ("good", "attention"), view["findings"]
    assert 0 < result["total_um"] < 20
    server.do("accept")


def test_every_picture_arrives_or_counts_as_lost(server: Server) -> None:
    camera, reader = server.simulation.gige_camera, server.context.rig.sensor.reader
    wait_for(lambda: camera.packets_lost, lambda lost: lost > 10)
    link, sent = reader.link(), camera.blocks
    assert (link.state, link.corrupt) == ("connected", 0)
    assert sent > 10
    # a few are on their way
    assert abs(link.received + link.lost - sent) < 12


def test_a_scan_in_motion_lies_on_the_plate(server: Server) -> None:
    session = server.data / "sessions" / use_truth(server, f"truth-{uuid.uuid4().hex[:6]}")
    until(lambda: server.http.get("/api/scan").json()["state"] == "idle")
    live, _ = scan_plate(server, session)
    off_um = distances_from_plate_um(server, live.points_mm)
    on_plate_um = off_um[np.abs(off_um) < 200]
    expanded_um = 2 * stated_um(session)
    assert len(on_plate_um) > 1000
    assert abs(np.median(on_plate_um)) < expanded_um
    # single points also have the speckle of the laser in them
    assert np.median(np.abs(on_plate_um)) < expanded_um


def sensor_state(server: Server) -> tuple[str, str]:
    sensor = topics(server, {"devices"})["devices"]["sensor"]
    return sensor["state"], english(sensor["text"])


@contextmanager
def camera_faults(server: Server) -> Iterator[GigeFaults]:
    """Faults for a camera that is connected; without them it is connected again by itself."""
    until(lambda: sensor_state(server)[0] == "connected")
    faults = server.simulation.gige_camera.faults
    try:
        yield faults
    finally:
        faults.clear()
    until(lambda: sensor_state(server)[0] == "connected")


@pytest.mark.parametrize(
    ("fault", "said"), [("unplugged", "does not answer"), ("taken", "in use by another program")]
)
def test_a_camera_is_lost_and_comes_back(server: Server, fault: str, said: str) -> None:
    with camera_faults(server) as faults:
        setattr(faults, fault, True)
        until(lambda: sensor_state(server)[0] == "lost")
        until(lambda: said in sensor_state(server)[1])


def losses(server: Server) -> dict[str, Any]:
    items = server.http.get("/api/health").json()["health"]["items"]
    return dict(next(item for item in items if item["id"] == "losses-sensor"))


def test_a_slow_line_shows_by_late_pictures_and_by_those_it_loses(server: Server) -> None:
    with camera_faults(server) as faults, server.context.bus.subscribe() as subscription:
        # what the tests before made it lose is said for a while
        until(lambda: not server.context.rig.sensor.link().losing)
        before = server.context.rig.sensor.link().lost
        faults.line_bytes_per_s = SLOW_BYTES_PER_S
        until(lambda: server.context.rig.sensor.link().losing)
        driver = server.context.rig.sensor.reader.driver
        assert driver is not None
        # pictures are late before the camera's memory is full, and the first one is lost
        assert driver.health.late > 0
        until(lambda: "late" in english(losses(server)["what"]))
        assert "sensor-losing" in [event.kind for event in asyncio.run(subscription.next()).events]
        until(lambda: server.context.rig.sensor.link().lost > before + 30)
        until(lambda: losses(server)["quality"] != "good")
        said = losses(server)
        assert "lost" in english(said["what"])
        assert "cable" in english(said["remedy"])
