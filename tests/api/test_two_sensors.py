"""A station with two sensors, from its address: chosen, scanned with, listed, rebuilt."""

from collections.abc import Iterator

import numpy as np
import pytest

from crenel.errors import OperationError
from crenel.formats.clouds.files import read_cloud
from crenel.formats.recording.reader import open_recording
from crenel.formats.settings.scan_settings import ScanSettings
from crenel.operations.health_checks import HealthChecker
from crenel.operations.home import build_home
from crenel.operations.status_report import build_report
from crenel.station.operator_settings import StationSettings
from crenel.store.scans import ScanRecord
from crenel_hardware.simulator.station import SimulationConfig
from tests.api.conftest import Server, running_server, until
from tests.bench.faults.served import accept_truth
from tests.present import present

pytestmark = pytest.mark.device

CONFIG = SimulationConfig(
    second_sensor=True, width_px=640, height_px=512, frames_hz=12.0, pace=3.0, imperfection_um=0.0
)
SENSORS = {"left": False, "right": True}
"""Names, and whether it is the simulation's second one."""


@pytest.fixture(scope="module")
def station(tmp_path_factory: pytest.TempPathFactory) -> Iterator[Server]:
    with running_server(tmp_path_factory.mktemp("two"), CONFIG) as server:
        until(lambda: all(one.fresh for one in server.context.rig.sensors.values()))
        yield server


def select(station: Server, name: str) -> int:
    return station.http.post("/api/sensor", json={"name": name}).status_code


def test_each_is_calibrated_in_its_own_session(station: Server) -> None:
    """The set-up step asks which sensor; what is accepted is that sensor's alone."""
    assert station.http.post("/api/flow/start", json={}).status_code == 200
    station.do("confirm_devices")
    choice = station.flow()["picture"]["choices"][0]
    assert choice["field"] == "device"
    assert [option["id"] for option in choice["options"]] == ["left", "right"]
    assert choice["selected"] == "left"
    station.do("choose", field="device", id="right")
    assert station.context.rig.selected == "right"
    assert select(station, "left") == 422  # the open session's sensor stays
    assert station.command("choose", field="device", id="top").status_code in (409, 422)
    station.do("abandon")
    assert select(station, "left") == 200
    assert station.context.rig.selected == "left"


def test_both_scan_into_one_cloud_and_a_killed_scan_is_rebuilt(station: Server) -> None:
    context, store = station.context, station.context.store
    assert "left: not calibrated yet" in [str(one.text) for one in build_home(context).findings]
    for name, second in SENSORS.items():
        accept_truth(store, station.simulation, f"truth-{name}", name, second)
    active = {store.calibrations.active(name).id for name in SENSORS}  # type: ignore[union-attr]
    assert active == {"truth-left", "truth-right"}
    context.guide._on_closed()  # the station works with them from now on
    until(lambda: station.http.get("/api/scan").json()["state"] == "idle")

    assert station.http.post("/api/scan/start", json={}).status_code == 200
    assert select(station, "right") == 200  # a look at the other one leaves both lasers on
    assert all(sensor.laser.state == "on" for sensor in context.rig.sensors.values())
    assert select(station, "left") == 200
    assert station.simulation.operator.scan_part("sphere")
    assert station.http.get("/api/home").status_code == 200
    assert context.rig.devices().laser.state == "on"
    station.http.post("/api/scan/stop", json={})
    scan = store.scans.newest()
    assert scan is not None
    live = read_cloud(scan.folder / "cloud.ply").points_mm
    assert len(live) == scan.points > 1000
    topics = open_recording(scan.folder / "scan.mcap")
    assert list(topics.records())
    assert topics.sensors == ("left", "right")
    assert topics.station["scan_calibration/right"] == "truth-right"

    (scan.folder / "cloud.ply").unlink()
    assert context.recovery._rebuild(scan).points == scan.points
    np.testing.assert_allclose(read_cloud(scan.folder / "cloud.ply").points_mm, live, atol=1e-6)
    continue_scan(station, scan)


def continue_scan(station: Server, scan: ScanRecord) -> None:
    """The next scans are added to it, each with its recording, and all have its part."""
    http, scans = station.http, station.context.store.scans
    part = {"part": "Ball", "order": "A-1"}
    assert http.post(f"/api/scans/{scan.id}/part", json=part).status_code == 204
    assert http.post(f"/api/scans/{scan.id}/continued", json={"on": True}).status_code == 204
    for count in (2, 3):
        known = {one.id for one in scans.all()}
        assert http.post("/api/scan/start", json={}).status_code == 200
        assert station.simulation.operator.scan_part("sphere")
        http.post("/api/scan/stop", json={})
        until(lambda: http.get("/api/library").json()["continued"]["scans"] == count)  # noqa: B023
        merged = present(scans.get(http.get("/api/library").json()["continued"]["id"]))
        (added,) = (one for one in scans.all() if one.id not in known | {merged.id})
        assert added.part.part == merged.part.part == "Ball"
        assert "Ball" in open_recording(added.folder / "scan.mcap").station_metadata().values()
        assert (merged.sources[0], merged.sources[-1]) == (scan.id, added.id)
        cloud = read_cloud(merged.folder / "cloud.ply")
        assert (
            len(cloud.points_mm)
            == merged.points
            == sum(present(scans.get(one)).points for one in merged.sources)
        )
    assert http.post(f"/api/scans/{merged.id}/continued", json={"on": False}).status_code == 204


def test_every_page_lists_each_sensor(station: Server) -> None:
    ids = {item.id for item in HealthChecker(station.context).look().items}
    assert {"device-arm", "device-sensor-left", "device-sensor-right"} <= ids
    devices = station.http.get("/api/devices").json()["devices"]
    labels = [(one["kind"], one["label"]) for one in devices[1:]]
    assert labels == [("sensor", "left"), ("sensor", "right")]
    cameras = [one for one in build_report(station.context).devices if one.name == "camera"]
    assert [one.sensor for one in cameras] == ["left", "right"]
    # for readers of an earlier version
    assert [one.text.partition(":")[0] for one in cameras] == ["left", "right"]
    assert all(one.rate_hz and one.stamps for one in cameras)
    with pytest.raises(OperationError, match="several sensors"):
        station.context.device_setup.choose("sensor", "folder", {"path": "."}, "")


def test_exposure_and_preview_are_those_of_the_selected_one(station: Server) -> None:
    rig = station.context.rig
    before_us = rig.sensors["left"].exposure_us
    assert select(station, "right") == 200
    assert station.http.post("/api/exposure", json={"exposure_us": 800.0}).status_code == 200
    until(lambda: rig.sensors["right"].exposure_us == 800.0)
    assert rig.sensors["left"].exposure_us == before_us
    assert select(station, "top") == 422
    settings = station.http.post("/api/settings", json={"exposure_us": 900.0}).json()
    assert settings["exposure_us"] == 900.0
    until(lambda: rig.sensors["right"].exposure_us == 900.0)
    with station.context.preview.watch():
        newest = station.context.preview.latest()
        until(lambda: station.context.preview.latest() is not newest)
    assert select(station, "left") == 200
    assert station.http.get("/api/settings").json()["exposure_us"] is None
    shown = station.context.bus.latest("settings")
    assert isinstance(shown, StationSettings)
    assert shown.exposure_us is None
    station.http.post("/api/settings", json={"exposure_us": 700.0}).raise_for_status()
    stored = ScanSettings.read(station.data / "scan_settings.json")
    assert stored.exposure_us is None
    assert stored.sensor_exposures_us == {"left": 700.0, "right": 900.0}
    assert select(station, "right") == 200
    station.http.post("/api/settings", json={"exposure_us": None}).raise_for_status()
    assert station.http.get("/api/settings").json()["exposure_us"] is None
    assert select(station, "left") == 200
