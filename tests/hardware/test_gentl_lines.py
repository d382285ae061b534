"""The gentl driver on a profile camera, whose line outputs and profiles Viky does not have.

No GenTL producer for it can be had. In its place, the simulated GigE camera is reached directly:
EMVA's GenApi reads its description and its registers, and Harvesters makes components of what it
sends. Sockets and the calls of GenTL are left out.
"""

import queue
from collections.abc import Iterator
from contextlib import closing
from pathlib import Path
from types import SimpleNamespace
from typing import Any

import numpy as np
import pytest

from crenel_hardware.clock import now_ns
from crenel_hardware.errors import DeviceError
from crenel_hardware.interfaces import DeliversLines, Frame, Line, SensorDriver
from crenel_hardware.sensor import gentl_camera
from crenel_hardware.sensor.genicam.profiles.profile_points import INTENSITY
from crenel_hardware.sensor.grabbing import GrabbingSensor
from crenel_hardware.simulator.devices.gige_camera.camera import GigeCamera
from crenel_hardware.simulator.devices.gige_camera.gvsp import PictureBlock
from crenel_hardware.simulator.devices.gige_camera.registers import TICKS_PER_S, CameraIdentity
from crenel_hardware.simulator.devices.gige_camera.stream import Block
from crenel_hardware.simulator.rendering.line_sensor import find_profile
from tests.hardware.conformance import SensorBench, SensorConformance
from tests.hardware.fake_cameras import ADDRESS
from tests.hardware.reading import loss_of, next_frame, read_until_delivery, wait_until
from tests.hardware.test_profiles import DARK, DELAY_MS, DETECTOR, HEIGHT, WIDTH, picture, row_in
from tests.hardware.test_simulated_gige import serve
from tests.present import present

pytestmark = pytest.mark.device

genapi = pytest.importorskip("genicam.genapi")
gentl = pytest.importorskip("genicam.gentl")
core = pytest.importorskip("harvesters.core")


class CameraPort(genapi.AbstractPort):  # type: ignore[misc, name-defined]
    """The camera's memory, for GenApi."""

    def __init__(self, camera: GigeCamera) -> None:
        super().__init__()
        self._camera = camera

    def is_open(self) -> bool:
        return True

    def get_access_mode(self) -> Any:
        return genapi.EAccessMode.RW

    def read(self, address: int, length: int) -> bytes:
        self._require_plug()
        return self._camera._registers.read(address, length)

    def write(self, address: int, value: bytes) -> None:
        self._require_plug()
        self._camera._registers.write(address, bytes(value))

    def _require_plug(self) -> None:
        if not self._camera.is_plugged:
            raise gentl.TimeoutException


class Acquirer:
    """What Harvesters offers of an open camera, as far as the driver uses it."""

    def __init__(self, camera: GigeCamera) -> None:
        self._camera = camera
        self._port = CameraPort(camera)
        nodes = genapi.NodeMap()
        nodes.load_xml_from_string(camera._registers._description.rstrip(b"\0").decode())
        nodes.connect(self._port, "Device")
        self.remote_device = SimpleNamespace(node_map=nodes, port=self._port)
        self.num_buffers = 1
        self.payload_type = gentl.PAYLOADTYPE_INFO_IDS.PAYLOAD_TYPE_IMAGE
        self.pixel_format: int | None = None
        """What buffers state instead of what is in them."""
        self._blocks: queue.SimpleQueue[PictureBlock] = queue.SimpleQueue()
        present(camera._sender).submit = self._keep  # type: ignore[method-assign]

    def start(self) -> None:
        self.remote_device.node_map.TLParamsLocked.value = 1
        self.remote_device.node_map.AcquisitionStart.execute()

    def stop(self) -> None:
        self.remote_device.node_map.AcquisitionStop.execute()
        self.remote_device.node_map.TLParamsLocked.value = 0
        while not self._blocks.empty():
            self._blocks.get()

    def try_fetch(self, timeout: float) -> Any:
        try:
            block = self._blocks.get(timeout=timeout)
        except queue.Empty:
            return None
        module = SimpleNamespace(
            payload_type=self.payload_type,
            raw_buffer=block.data,
            pixel_format=self.pixel_format or block.pixel_format,
            width=block.region[2],
            height=block.region[3],
            padding_x=0,
            frame_id=block.block_id,
            timestamp_ns=block.timestamp * 1_000_000_000 // TICKS_PER_S,
        )
        nodes = self.remote_device.node_map
        payload = core.Buffer._build_payload(buffer=module, node_map=nodes)
        return SimpleNamespace(module=module, payload=payload, queue=lambda: None)

    def destroy(self) -> None: ...

    def _keep(self, block: Block, due_ns: int) -> None:
        """Instead of sending a block."""
        assert isinstance(block, PictureBlock)
        self._blocks.put(block)


class Producer:
    """A harvester that has found the camera."""

    def __init__(self, camera: GigeCamera) -> None:
        self._camera = camera
        self.opened: list[Acquirer] = []

    @property
    def device_info_list(self) -> list[Any]:
        about = {"vendor": "Crenel", "model": "Simulated GigE camera", "id_": "1"}
        about["serial_number"] = self._camera.identity.serial_number
        found = SimpleNamespace(serial_number=about["serial_number"], property_dict=about)
        return [found] if self._camera.is_plugged else []

    def add_file(self, path: str, check_validity: bool) -> None: ...

    def update(self) -> None: ...

    def reset(self) -> None: ...

    def create(self, about: dict[str, str]) -> Acquirer:
        self.opened.append(Acquirer(self._camera))
        return self.opened[-1]


@pytest.fixture
def camera() -> Iterator[GigeCamera]:
    made = GigeCamera(
        CameraIdentity(ADDRESS, "SIM-1", WIDTH, HEIGHT, 50.0, 1),
        picture,
        delay_ms=DELAY_MS,
        find_line=lambda image: find_profile(image, DETECTOR),
    )
    with serve(made):
        yield made


@pytest.fixture
def producer(camera: GigeCamera, monkeypatch: pytest.MonkeyPatch) -> Producer:
    made = Producer(camera)
    monkeypatch.setattr(gentl_camera, "_load_harvester", lambda: made)
    return made


@pytest.fixture
def options(producer: Producer, tmp_path: Path) -> dict[str, object]:
    path = tmp_path / "camera.cti"
    path.touch()
    return {"producer": str(path), "laser_line": "Line2", "exposure_us": 5000.0}


@pytest.fixture
def driver(options: dict[str, object]) -> Iterator[GrabbingSensor]:
    with closing(gentl_camera.from_options(options)) as made:
        yield made


class ProfileBench(SensorBench):
    def __init__(self, camera: GigeCamera, options: dict[str, object]) -> None:
        self._camera, self._options = camera, options
        self._driver = gentl_camera.from_options(options)

    def driver(self) -> SensorDriver:
        return self._driver

    def triggered_driver(self) -> SensorDriver:
        self._driver = gentl_camera.from_options({**self._options, "trigger": "Line1"})
        return self._driver

    def trigger(self) -> None:
        self._camera.trigger(now_ns())

    def unplug(self) -> None:
        self._set_unplugged(True)

    def plug_in(self) -> None:
        self._set_unplugged(False)

    def _set_unplugged(self, unplugged: bool) -> None:
        """Waits until the camera has noticed it, as it does before it answers at its sockets."""
        self._camera.faults.unplugged = unplugged
        control = present(self._camera._control)
        wait_until(lambda: control._was_plugged != unplugged)


class TestProfileCamera(SensorConformance):
    @pytest.fixture
    def bench(self, camera: GigeCamera, options: dict[str, object]) -> SensorBench:
        return ProfileBench(camera, options)


def test_the_output_switches_the_laser_of_pairs(camera: GigeCamera, driver: GrabbingSensor) -> None:
    assert driver.open().has_laser_switch
    for on in (True, False):
        driver.set_laser(on)
        while next_frame(driver).laser_on != on:
            pass
        frame = next_frame(driver)  # the laser may change during the exposure of the one before
        assert camera.laser.is_on == on
        assert (frame.image.max() > frame.image.min() + 50) == on
    driver.set_laser(True)
    driver.close()
    assert not camera.laser.is_on


def test_lines_are_those_of_the_picture(driver: GrabbingSensor) -> None:
    assert driver.open().delivers == {"picture", "line"}
    assert isinstance(driver, DeliversLines)
    driver.set_laser(True)
    driver.set_delivery("line")
    while not (line := read_until_delivery(driver, "line")).laser_on:
        pass
    assert isinstance(line, Line)
    np.testing.assert_allclose(line.v, row_in(line.u), atol=0.1)
    assert len(line.u) == WIDTH - len(DARK)
    assert set(line.intensity) == {INTENSITY}
    driver.set_delivery("picture")
    assert isinstance(read_until_delivery(driver, "picture"), Frame)


@pytest.mark.parametrize(
    ("payload", "pixel_format", "named"),
    [
        ("PAYLOAD_TYPE_IMAGE", 0x81234567, "0x81234567"),
        ("PAYLOAD_TYPE_RAW_DATA", None, "PAYLOAD_TYPE_RAW_DATA"),
        ("PAYLOAD_TYPE_JPEG", None, "PAYLOAD_TYPE_JPEG"),
    ],
)
def test_what_is_no_picture_is_named(
    producer: Producer, driver: GrabbingSensor, payload: str, pixel_format: int | None, named: str
) -> None:
    driver.open()
    (opened,) = producer.opened
    opened.payload_type = getattr(gentl.PAYLOADTYPE_INFO_IDS, payload)
    opened.pixel_format = pixel_format
    error = loss_of(driver)
    assert isinstance(error, DeviceError)
    assert named in str(error.what)
    assert error.remedy
