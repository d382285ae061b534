"""Finding, trying and choosing devices of a running station."""

import socket
from collections.abc import Callable, Iterator
from dataclasses import replace
from http import HTTPStatus
from pathlib import Path
from typing import Any

import numpy as np
import pytest

from crenel.api.monitoring.support import context_redactor
from crenel.errors import OperationError
from crenel.formats.datasheets.arm import read_any_arm
from crenel.formats.datasheets.sensor import read_sensor
from crenel.formats.images import write_png
from crenel.guide.common.datasheet_library import DatasheetEntry, DatasheetLibrary
from crenel.operations.datasheets.new_datasheet import (
    UndescribedArm,
    is_described,
    write_arm_datasheet,
)
from crenel.settings.station_toml import read_settings
from crenel.station.setup.trials import DeviceTrials
from crenel_hardware.simulator.devices.rtde_server import RobotState, RtdeServer
from tests.api.conftest import Server, View, running_server, wait_for
from tests.bench.station.subprocess_station import free_port
from tests.hardware.test_kuka_rsi import rsi_packet
from tests.hardware.udp_robot import UdpRobot
from tests.pictures import decode_picture
from tests.present import present
from tests.sent_texts import english
from tests.simulated_robots import robot

pytestmark = pytest.mark.device

WIDTH, HEIGHT = 160, 120


@pytest.fixture
def pictures(tmp_path: Path) -> Path:
    """A camera of its own: a folder of pictures."""
    folder = tmp_path / "pictures"
    folder.mkdir()
    for index in range(5):
        write_png(folder / f"{index}.png", np.full((HEIGHT, WIDTH), 40 * index, np.uint8))
    return folder


@pytest.fixture
def station(server: Server) -> Iterator[Server]:
    yield server
    server.http.delete("/api/devices/trial").raise_for_status()
    for kind in ("arm", "sensor"):
        server.http.post("/api/devices/remove", json={"kind": kind}).raise_for_status()


def view(server: Server) -> dict[str, Any]:
    return dict(server.http.get("/api/devices").raise_for_status().json())


def trial(server: Server) -> dict[str, Any]:
    return dict(server.http.get("/api/devices/trial").raise_for_status().json())


def try_device(server: Server, body: View, ready: Callable[[View], object]) -> View:
    server.http.post("/api/devices/trial", json=body).raise_for_status()
    return wait_for(lambda: trial(server), ready)


def is_live(shown: View) -> bool:
    return bool(shown["state"] == "live")


def has_picture(shown: View) -> bool:
    return shown["picture"] is not None


def wait_for_device(server: Server, kind: str) -> dict[str, Any]:
    return wait_for(lambda: device(server, kind), lambda one: one["state"]["state"] == "connected")


def asked(pictures: Path, **more: object) -> dict[str, object]:
    options = {"path": str(pictures), "rate_hz": "50", "exposure_us": "500"}
    return {"kind": "sensor", "driver": "folder", "options": options} | more


def device(server: Server, kind: str) -> dict[str, Any]:
    return next(one for one in view(server)["devices"] if one["kind"] == kind)


def test_a_demonstration_has_simulated_devices_and_lists_the_drivers(station: Server) -> None:
    shown = view(station)
    assert shown["demonstration"]
    assert shown["file"] == "station.toml"
    assert [one["simulated"] for one in shown["devices"]] == [True, True]
    drivers = {(one["kind"], one["name"]): one for one in shown["drivers"]}
    assert drivers["sensor", "folder"]["fields"][0]["key"] == "path"
    assert ("arm", "serial-encoder") in drivers


def test_a_search_ends_and_says_so(station: Server) -> None:
    station.http.post("/api/devices/search").raise_for_status()
    shown = wait_for(lambda: view(station), lambda one: one["searched"] and not one["searching"])
    assert all(one["kind"] in ("arm", "sensor") for one in shown["found"])


def test_a_tried_camera_shows_pictures_and_is_closed(station: Server, pictures: Path) -> None:
    live = try_device(station, asked(pictures), lambda one: one["rate_hz"] is not None)
    assert (live["state"], live["in_use"]) == ("live", False)
    assert (live["width_px"], live["height_px"]) == (WIDTH, HEIGHT)
    assert (live["stamps"], live["lost"], live["corrupt"]) == ("arrival", 0, 0)
    later = wait_for(lambda: trial(station), lambda one: one["picture"] != live["picture"])
    assert later["picture"] > live["picture"]
    answer = station.http.get("/api/devices/trial/picture.jpg").raise_for_status()
    assert decode_picture(answer.content).shape == (HEIGHT, WIDTH)
    station.http.delete("/api/devices/trial").raise_for_status()
    assert station.http.get("/api/devices/trial").json() is None
    assert station.http.get("/api/devices/trial/picture.jpg").status_code == HTTPStatus.NO_CONTENT


def test_a_tried_camera_whose_pictures_are_raw_says_so(station: Server, pictures: Path) -> None:
    raw = np.full((HEIGHT, WIDTH), 100, np.uint8)
    raw[::2, ::2], raw[1::2, 1::2] = 60, 80
    for path in pictures.iterdir():
        write_png(path, raw)
    live = try_device(station, asked(pictures), has_picture)
    assert "raw picture of a colour camera" in english(live["picture_text"])
    measured = asked(pictures)
    measured["options"] |= {"bayer": "BGGR", "laser_colour": "red"}  # type: ignore[operator]
    assert not try_device(station, measured, has_picture)["picture_text"]


def test_a_tried_arm_shows_its_joints(station: Server) -> None:
    options = {"url": station.simulation.arm_url}
    body = {"kind": "arm", "driver": "serial-encoder", "options": options}
    live = try_device(station, body, lambda one: len(one["joints_deg"]) > 0)
    assert live["name"]
    assert live["stamps"] == "device"


def test_a_tried_robot_whose_packets_are_damaged_says_so(station: Server) -> None:
    controller = UdpRobot(free_port(socket.SOCK_DGRAM), 4, rsi_packet)
    options = {"address": "127.0.0.1", "port": controller.port}
    body = {"kind": "arm", "driver": "kuka-rsi", "options": options}
    try:
        assert not try_device(station, body, is_live)["loss_text"]
        controller.spoil = lambda data: b"damaged"
        losing = wait_for(lambda: trial(station), lambda one: one["loss_text"])
        assert "is being lost" in english(losing["loss_text"])
    finally:
        controller.stop()


def test_what_cannot_be_opened_says_why(station: Server, tmp_path: Path) -> None:
    failed = try_device(station, asked(tmp_path / "nowhere"), lambda one: one["state"] == "failed")
    assert "nowhere" in str(failed["text"])


def test_a_wrong_option_is_refused_in_the_drivers_words(station: Server, pictures: Path) -> None:
    body = asked(pictures)
    body["options"] = {"pth": str(pictures)}
    answer = station.http.post("/api/devices/trial", json=body)
    assert answer.json()["code"] == "driver-options"
    assert "no option 'pth'" in answer.json()["detail"]
    unknown = station.http.post("/api/devices/trial", json=body | {"driver": "foldr"})
    assert "Did you mean folder?" in unknown.json()["remedy"]


def test_a_chosen_camera_is_used_at_once_and_when_restarted(tmp_path: Path, pictures: Path) -> None:
    data = tmp_path / "data"
    with running_server(data) as server:
        chosen = asked(pictures, label="Left camera")
        server.http.post("/api/devices", json=chosen).raise_for_status()
        state = wait_for(
            lambda: device(server, "sensor"),
            lambda one: one["state"]["state"] == "connected" and one["state"]["rate_hz"],
        )
        assert (state["driver"], state["label"]) == ("folder", "Left camera")
        assert "Left camera · pictures" in str(server.context.rig.sensor.link().text)
        assert state["options"] == {"path": str(pictures), "rate_hz": 50, "exposure_us": 500}
        assert not state["simulated"]
        assert not server.context.station.has_simulation
        assert server.context.station.simulated, "the arm still is"
        assert read_settings(data / "station.toml").devices["sensor"].driver == "folder"
    with running_server(data) as again:
        assert wait_for_device(again, "sensor")["driver"] == "folder"
        again.http.post("/api/devices/remove", json={"kind": "sensor"}).raise_for_status()
        assert wait_for_device(again, "sensor")["simulated"]
        assert again.context.station.has_simulation


def test_a_chosen_camera_gets_its_datasheet_by_one_answer(station: Server, pictures: Path) -> None:
    assert view(station)["undescribed"] is None, "the simulated camera has its datasheet"
    refused = station.http.post("/api/devices/datasheet", json={"stripe_axis": "u"})
    assert refused.json()["code"] == "no-sensor"
    station.http.post("/api/devices", json=asked(pictures)).raise_for_status()
    wanted = wait_for(lambda: view(station)["undescribed"], lambda one: one is not None)
    assert (wanted["width_px"], wanted["height_px"]) == (WIDTH, HEIGHT)
    answer = station.http.post("/api/devices/datasheet", json={"stripe_axis": "v"})
    assert answer.raise_for_status().json()["undescribed"] is None
    (written,) = (station.data / "sensors").glob("pictures*.json")
    datasheet = read_sensor(written)
    assert (datasheet.name, datasheet.stripe_axis) == ("pictures", "v")
    assert (datasheet.width_px, datasheet.height_px) == (WIDTH, HEIGHT)
    written.unlink()


def test_a_robot_that_was_entered_is_shown_and_gets_its_datasheet(station: Server) -> None:
    assert view(station)["undescribed_arm"] is None, "the simulated arm has its datasheet"
    controller = RtdeServer(lambda _: RobotState(np.zeros(6), np.eye(4)))
    controller.start()
    try:
        options = {"address": "127.0.0.1", "port": str(controller.port)}
        body = {"kind": "arm", "driver": "ur-rtde", "options": options}
        station.http.post("/api/devices", json=body).raise_for_status()
        wanted = wait_for(lambda: view(station)["undescribed_arm"], lambda one: one is not None)
        assert wanted["joint_count"] == 0
        (row,) = [one for one in view(station)["found"] if one["kind"] == "arm" and one["in_use"]]
        assert row["title"].startswith("Universal Robots")
        assert "127.0.0.1" in row["title"]
        answer = station.http.post("/api/devices/arm-datasheet")
        assert answer.raise_for_status().json()["undescribed_arm"] is None
        (written,) = (station.data / "arms").glob("universal-robots*.json")
        assert read_any_arm(written).reading_kind == "pose"
        assert station.http.post("/api/devices/arm-datasheet").json()["code"] == "no-arm"
        written.unlink()
    finally:
        station.http.post("/api/devices/remove", json={"kind": "arm"}).raise_for_status()
        controller.stop()


def test_an_arm_of_another_unit_needs_its_own_model() -> None:
    arm = robot(6)
    library = DatasheetLibrary({"a": DatasheetEntry("a", Path("a"), arm)}, {}, {}, ())
    same = UndescribedArm("Arm", arm.serial_number, 6)
    assert is_described(same, library)
    assert is_described(replace(same, serial_number=""), library)
    for other in (replace(same, serial_number="X-9"), replace(same, joint_count=7)):
        assert not is_described(other, library)
        with pytest.raises(OperationError, match="reports poses"):
            write_arm_datasheet(other, Path("nowhere"))


def test_the_stations_own_device_is_shown_and_not_reopened(station: Server, pictures: Path) -> None:
    station.http.post("/api/devices", json=asked(pictures)).raise_for_status()
    assert try_device(station, asked(pictures), is_live)["in_use"]
    slower = asked(pictures, options={"path": str(pictures), "rate_hz": "5"})
    station.http.post("/api/devices/trial", json=slower).raise_for_status()
    assert trial(station)["in_use"], "another rate is the same camera"
    station.http.delete("/api/devices/trial").raise_for_status()
    assert station.context.rig.sensor.fresh


def test_secrets_of_a_tried_device_do_not_leave_the_station(station: Server) -> None:
    address = "rtsp://admin:nobody-knows-it@127.0.0.1:9/stream"
    body = {"kind": "sensor", "driver": "opencv", "options": {"source": address}}
    station.http.post("/api/devices/trial", json=body).raise_for_status()
    station.http.delete("/api/devices/trial").raise_for_status()
    redactor = context_redactor(station.context)
    assert "nobody-knows-it" not in redactor.text("the password nobody-knows-it is wrong")


def test_devices_do_not_change_during_a_session(at_setup: Server, pictures: Path) -> None:
    before = device(at_setup, "sensor")
    refused = at_setup.http.post("/api/devices", json=asked(pictures)).json()
    assert refused["code"] == "busy"
    assert "on the page “Calibrate”" in refused["detail"]  # where it is ended
    assert device(at_setup, "sensor")["simulated"] == before["simulated"]
    file = at_setup.data / "station.toml"
    assert not file.exists() or not read_settings(file).devices
    at_setup.do("abandon")


def test_a_file_with_an_error_is_not_overwritten(station: Server, pictures: Path) -> None:
    file = station.data / "station.toml"
    file.write_text("[sensor\n")
    answer = station.http.post("/api/devices", json=asked(pictures))
    assert answer.json()["code"] == "settings-not-valid"
    assert file.read_text() == "[sensor\n"
    assert device(station, "sensor")["simulated"]
    file.unlink()


@pytest.mark.parametrize(
    ("longest_s", "away_s", "looks", "words"),
    [(0.5, 60.0, True, "Closed after"), (60.0, 0.3, False, "nobody was looking")],
)
def test_a_trial_ends_by_itself(
    station: Server, pictures: Path, longest_s: float, away_s: float, looks: bool, words: str
) -> None:
    setup = station.context.device_setup
    before, setup.trials = setup.trials, DeviceTrials(station.context.rig, longest_s, away_s)
    try:
        setup.try_device("sensor", "folder", {"path": str(pictures)})
        inside = present(setup.trials._trial)
        assert inside.sensor is not None
        if looks:
            wait_for(setup.trials.view, lambda one: one is not None and one.state == "ended")
        else:
            wait_for(lambda: inside.ended, bool)
        ended = present(setup.trials.view())
        assert words in str(ended.text)
        wait_for(lambda: inside.sensor and inside.sensor.reader.driver, lambda one: one is None)
    finally:
        setup.trials.close()
        setup.trials = before
