"""The example bridge for FARO arms, without the vendor's driver, in front of the driver."""

import importlib.util
import subprocess
import sys
import threading
from collections.abc import Iterator
from contextlib import closing
from pathlib import Path
from types import ModuleType
from typing import Any

import numpy as np
import pytest
from scipy.spatial.transform import Rotation

from crenel_hardware.arm.serial_encoder import from_options
from crenel_hardware.interfaces import ArmDriver, Button, PoseSample
from tests.bench.station.subprocess_station import free_port
from tests.hardware.conformance import ArmBench, ArmConformance
from tests.hardware.reading import button_edges, opened, read_readings, read_until, select_readings
from tests.present import present

pytestmark = pytest.mark.device

SCRIPT = Path(__file__).parents[2] / "docs/examples/faro_bridge/faro_bridge.py"
BITS = {Button.PRIMARY: 1, Button.UNDO: 2, Button.BACK: 4}


def load() -> ModuleType:
    spec = present(importlib.util.spec_from_file_location("faro_bridge", SCRIPT))
    assert spec.loader is not None
    module = importlib.util.module_from_spec(spec)
    sys.modules["faro_bridge"] = module
    spec.loader.exec_module(module)
    return module


bridge: Any = load()


class FaroBench(ArmBench):
    """Updates as of the vendor's driver at 200 Hz, through the example's own conversion."""

    def __init__(self) -> None:
        command = "--host 127.0.0.1 --port 0 --rate 200 --stamp-unit-s 0.001"
        self.options = bridge.read_options(command.split())
        self.bridge = bridge.Bridge(self.options)
        self.buttons, self.silent, self.bad = 0, False, 0
        self._lock = threading.Lock()
        self.server = self.bridge.serve("FARO arm", "F-1")
        self.options.port = self.server.port
        self._ended = threading.Event()
        self._thread = threading.Thread(target=self._run, daemon=True)
        self._thread.start()

    def _run(self) -> None:
        number = 0
        while not self._ended.wait(0.005):
            with self._lock:
                number += 1
                x = 1.0 * number
                if self.bad:
                    self.bad -= 1
                    x = float("nan")
                where = (x, -80.25, 433.0), (30.0, -20.0, 75.0)
                if not self.silent:
                    self.bridge.take((*where, self.buttons, number * 5.0))

    def driver(self) -> ArmDriver:
        return from_options({"url": f"socket://127.0.0.1:{self.options.port}", "timeout_s": 5.0})

    def contacts(self) -> int:
        return int(self.server.requests)

    def unplug(self) -> None:
        self.server.close()

    def plug_in(self) -> None:
        with self._lock:
            self.server = self.bridge.serve("FARO arm", "F-1")

    def silence(self, silent: bool) -> None:
        self.silent = silent

    def lose_samples(self, count: int) -> None:
        self.bad = count

    def set_buttons(self, pressed: set[Button]) -> None:
        self.buttons = sum(BITS[button] for button in pressed)

    def close(self) -> None:
        self._ended.set()
        self._thread.join()
        self.server.close()


@pytest.fixture
def bench() -> Iterator[FaroBench]:
    with closing(FaroBench()) as made:
        yield made


class TestFaroBridge(ArmConformance):
    """Of poses."""


def test_the_pose_is_the_one_of_the_update(bench: FaroBench) -> None:
    with closing(bench.driver()) as driver:
        info = driver.open()
        pose = read_readings(driver)[0]
    assert (info.reports, info.pose_of, info.stamps) == ("pose", "tool", "device")
    assert (info.name, info.serial_number, info.rate_hz) == ("FARO arm", "F-1", 200.0)
    assert isinstance(pose, PoseSample)
    assert pose.position_mm[1:] == (-80.25, 433.0)
    expected = Rotation.from_euler("ZYX", [30.0, -20.0, 75.0], degrees=True)
    assert (Rotation.from_quat(pose.quaternion_xyzw).inv() * expected).magnitude() < 1e-9


@pytest.mark.parametrize("order", ["zyx", "xyz", "zyz", "zxz"])
def test_orders_of_angles_are_those_of_turned_axes(order: str) -> None:
    angles = [0.3, -0.7, 1.9]
    expected = Rotation.from_euler(order.upper(), angles).as_matrix()
    found = Rotation.from_quat(bridge.quaternion_from_angles(angles, order)).as_matrix()
    np.testing.assert_allclose(found, expected, atol=1e-12)


@pytest.mark.parametrize("order", ["zy", "abc", "zyxz"])
def test_an_order_without_axes_is_refused(order: str, capsys: pytest.CaptureFixture[str]) -> None:
    with pytest.raises(SystemExit):
        bridge.read_options(["--angles", order])
    assert "three axes" in capsys.readouterr().err


def test_a_press_at_rest_comes_through_if_only_changes_are_sent() -> None:
    """One update for the press, one for the release, and then none."""
    command = "--host 127.0.0.1 --port 0 --rate 100 --only-changes"
    source = bridge.Bridge(bridge.read_options(command.split()))
    with closing(source.serve("FARO arm", "F-1")) as server:
        edges: list[tuple[Button, bool]] = []
        with opened(from_options({"url": f"socket://127.0.0.1:{server.port}"})) as driver:
            for pressed in (0, 1, 0):
                source.take(((600.0, 0.0, 300.0), (0.0, 0.0, 0.0), pressed, 0.0))
                edges += button_edges(read_until(driver, select_readings))
    assert edges == [(Button.PRIMARY, True), (Button.PRIMARY, False)]


def test_the_file_alone_serves_a_simulated_arm(tmp_path: Path) -> None:
    """With the standard library only: no installed package is visible to it."""
    port = free_port()
    alone = tmp_path / "faro_bridge.py"
    alone.write_bytes(SCRIPT.read_bytes())
    command = [sys.executable, "-I", "-S", str(alone), "--simulate", "--host", "127.0.0.1"]
    command += ["--port", str(port), "--only-changes"]
    with (
        subprocess.Popen(command, stdout=subprocess.PIPE, text=True) as process,
        closing(from_options({"url": f"socket://127.0.0.1:{port}", "setting": 1})) as driver,
    ):
        try:
            assert f"poses per second at port {port}" in present(process.stdout).readline()
            info = driver.open()
            assert (info.stamps, info.free_running) == ("arrival", False)
            assert driver.is_alive()
            poses = read_readings(driver, 51)
        finally:
            process.terminate()
    assert all(isinstance(pose, PoseSample) and pose.position_mm[0] == 600.0 for pose in poses)
