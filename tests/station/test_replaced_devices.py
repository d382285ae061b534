"""Another device takes the place of the station's own, without a restart."""

import socket
import threading
from collections.abc import Callable, Iterator
from pathlib import Path

import cv2
import numpy as np
import pytest

from crenel.monitoring.health import device
from crenel.station.bus import Bus
from crenel.station.devices.rig import Rig
from crenel.station.setup.drivers import arm_factory, no_device_factory, sensor_factory
from crenel_hardware.interfaces import SensorDriver
from crenel_hardware.simulator.station import SimulatedStation
from tests.station.conftest import running, until

pytestmark = pytest.mark.device


def camera(folder: Path, width: int) -> Callable[[], SensorDriver]:
    """One that plays pictures of a width, which are written into the folder."""
    folder.mkdir()
    for index in range(3):
        cv2.imwrite(str(folder / f"{index}.png"), np.full((90, width), 50 * index, np.uint8))
    return sensor_factory("folder", {"path": str(folder), "rate_hz": 50.0})


@pytest.fixture
def rig(tmp_path: Path) -> Iterator[Rig]:
    """A station with one camera and no arm."""
    first = camera(tmp_path / "first", 120)
    with running(Rig(Bus(), no_device_factory("arm"), first, tmp_path)) as rig:
        yield rig


def width(rig: Rig) -> int | None:
    info = rig.sensor.info
    return None if info is None else info.width_px


def test_a_station_without_an_arm_says_so_and_its_camera_works(rig: Rig) -> None:
    until(lambda: rig.sensor.fresh)
    until(lambda: "No arm is chosen" in str(rig.arm.link().text))
    assert "Devices page" in str(rig.arm.link().text)
    assert rig.arm.link().state == "absent"
    assert device("arm", rig.arm.link()).remedy == ""  # the text has it


def test_an_arm_that_is_chosen_later_is_connected_to_and_absent_no_more(rig: Rig) -> None:
    until(lambda: rig.arm.link().state == "absent")
    rig.use_arm(arm_factory("bridge", {"url": "socket://127.0.0.1:1"}))
    until(lambda: rig.arm.link().state == "connecting")
    until(lambda: "127.0.0.1" in str(rig.arm.link().text))
    assert rig.arm.link().state == "connecting"


def test_another_camera_counts_from_the_start_with_own_frames(rig: Rig, tmp_path: Path) -> None:
    until(lambda: rig.sensor.link().received > 20)
    states: set[str] = set()
    stop = threading.Event()

    def watch() -> None:
        while not stop.wait(0.002):
            states.add(rig.sensor.link().state)

    watcher = threading.Thread(target=watch)
    watcher.start()
    rig.use_sensor(camera(tmp_path / "second", 160))
    until(lambda: width(rig) == 160 and rig.sensor.fresh)
    stop.set()
    watcher.join()
    assert "lost" not in states
    assert rig.sensor.link().received <= 20
    latest = rig.sensor.frames.latest
    assert latest is not None
    assert latest.image.shape == (90, 160)
    assert rig.real == {"sensor"}


def test_a_camera_that_is_missing_is_replaced_without_waiting(rig: Rig, tmp_path: Path) -> None:
    rig.use_sensor(sensor_factory("folder", {"path": str(tmp_path / "nowhere")}))
    until(lambda: "nowhere" in str(rig.sensor.link().text))
    assert rig.sensor.link().state == "connecting"
    rig.use_sensor(camera(tmp_path / "second", 160))
    until(lambda: rig.sensor.fresh)
    assert width(rig) == 160


def test_an_arm_that_never_answers_gives_way_at_once(rig: Rig) -> None:
    with socket.create_server(("127.0.0.1", 0)) as silent, SimulatedStation() as simulation:
        url = f"socket://127.0.0.1:{silent.getsockname()[1]}"
        rig.use_arm(arm_factory("bridge", {"url": url, "timeout_s": 60.0}))
        silent.settimeout(240.0)
        connection, _ = silent.accept()
        with connection:
            rig.use_arm(arm_factory("bridge", {"url": simulation.arm_url}))
            until(lambda: rig.arm.fresh)  # long before the 60 s are over


def test_a_station_ends_while_a_device_is_being_opened(tmp_path: Path) -> None:
    with socket.create_server(("127.0.0.1", 0)) as silent:
        url = f"socket://127.0.0.1:{silent.getsockname()[1]}"
        options: dict[str, object] = {"url": url, "timeout_s": 60.0}
        rig = Rig(Bus(), arm_factory("bridge", options), no_device_factory("sensor"), tmp_path)
        rig.start()
        silent.settimeout(240.0)
        connection, _ = silent.accept()
        with connection:
            rig.stop()
        assert not [one for one in threading.enumerate() if one.name == "arm-reader"]
