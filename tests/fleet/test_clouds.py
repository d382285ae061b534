"""Clouds on demand: ``crenel fleet`` makes them from a station's archive, each once, and keeps
them."""

import json
import os
import shutil
import signal
import time
from collections.abc import Iterator
from contextlib import ExitStack, contextmanager, suppress
from pathlib import Path
from typing import Any

import httpx
import numpy as np
import pytest

pytest.importorskip("distributed")
pytest.importorskip("copclib")

from crenel.batch.places import Place, settings_for
from crenel.batch.rebuild import key_of
from crenel.batch.results import PROBE, ResultStore
from crenel.batch.single_cloud import CloudOrder, plan_cloud
from crenel.batch.task import perform
from crenel.formats.clouds.files import COPC, read_cloud
from crenel.formats.datasheets.arm import read_any_arm
from crenel.formats.recording.reader import ARM_SERIAL, SCAN_CALIBRATION, SENSOR_SERIAL
from crenel.formats.recording.topics import sensor_key
from crenel.formats.recording.writer import RecordingWriter
from crenel.formats.results.calibration import CALIBRATION as CALIBRATION_FILE
from crenel.formats.results.calibration import CalibrationFile, read_calibration
from crenel.server.fleet.clouds.kept_clouds import KeptClouds
from crenel.server.fleet.clouds.orders_file import ORDERS_FILE, KeptOrder, KeptOrders
from crenel.workflows.reconstruct import reconstruct_cloud
from tests.archive.filled import archive_of
from tests.batch.filled import CALIBRATION, fill_station
from tests.batch.standing_dask import standing_dask as standing_dask
from tests.bench.fleet.dask_processes import DaskProcesses
from tests.fleet.test_server import count, refused_start, running_fleet, until
from tests.fleet.test_sign_in import HOST, PASSWORD, browser_of, sign_in
from tests.formats.builders import q_at
from tests.refusals import refused
from tests.single_sign_on.mock_provider import SIGN_IN, mock_provider
from tests.store.test_full_disk import fill
from tests.store.test_full_disk import small as small
from tests.workflows.test_reconstruct import MS, NAMES, record_stripe

pytestmark = pytest.mark.device

TODAYS, FOREIGN = "20260601-090000-today", "20260602-090000-other"
OF_TWO = {"left": CALIBRATION, "right": FOREIGN}
"""The calibrations of a scan of two sensors."""
RECORDS = 6
"""Three scans and three calibrations."""
ARCHIVE = 'archive = { url = "plant/room-2" }'
CLOUDS = "/api/fleet/records/room-2/scan/{}/clouds"
LONG_FRAMES = 10_000
"""Of the third scan, which takes about a second."""


def add_calibrations(data: Path) -> None:
    """Today's calibration of the same devices, and one of another sensor."""
    used = data / "sessions" / CALIBRATION
    document = CalibrationFile.read(used / CALIBRATION_FILE)
    for name, sensor in ((TODAYS, "S-1"), (FOREIGN, "S-2")):
        folder = data / "sessions" / name
        folder.mkdir()
        serials = document.serial_numbers.model_copy(update={"sensor": sensor})
        path = folder / CALIBRATION_FILE
        document.model_copy(update={"serial_numbers": serials}).write(path)
        path.write_text(path.read_text().replace("0.25", "0.35"))
        shutil.copy(used / "arm.json", folder)


def write_long_recording(path: Path) -> None:
    """The arm moves back and forth."""
    about = {ARM_SERIAL: "A-1", SENSOR_SERIAL: "S-1", SCAN_CALIBRATION: CALIBRATION}
    with RecordingWriter(path, NAMES, about) as writer:
        for number in range(LONG_FRAMES + 20):
            writer.joints(number * 4 * MS, q_at(abs(number % 400 - 200) * 4 * MS))
        for number in range(10, LONG_FRAMES):
            record_stripe(writer, number * 4 * MS)


def write_recording_of_two(path: Path) -> None:
    """Of two sensors, ``left`` and ``right``, which were calibrated on the same arm."""
    about = {ARM_SERIAL: "A-1"}
    for sensor, serial in (("left", "S-1"), ("right", "S-2")):
        about[sensor_key(SENSOR_SERIAL, sensor)] = serial
        about[sensor_key(SCAN_CALIBRATION, sensor)] = OF_TWO[sensor]
    path.unlink()
    with RecordingWriter(path, NAMES, about, tuple(OF_TWO)) as writer:
        for number in range(60):
            writer.joints(number * 4 * MS, q_at(number * 4 * MS))
        for number in range(10, 40):
            record_stripe(writer, number * 4 * MS, sensor="left" if number % 2 else "right")


def write_settings(folder: Path, place: str = ARCHIVE, more: str = "") -> Path:
    path = folder / "fleet.toml"
    path.write_text(
        '[catalogue]\ndatabase = "sqlite:///catalogue.db"\n'
        f'[stations.room-2]\nname = "Room 2"\n{place}\n{more}'
    )
    return path


def fill_room(folder: Path, of_two: bool = False) -> None:
    """The archive of a station that has three scans, one of them perhaps of two sensors, and its
    folder."""
    archive, data = folder / "plant/room-2", folder / "data"
    archive.mkdir(parents=True)
    store = fill_station(data, ("one", "two", "long"))
    add_calibrations(data)
    for name in (TODAYS, FOREIGN):
        store.journal.begin_session(name, "calibration")
        store.journal.end_session(name)
    (data / "scans/long/scan.mcap").unlink()
    write_long_recording(data / "scans/long/scan.mcap")
    if of_two:
        write_recording_of_two(data / "scans/two/scan.mcap")
    archive_of(store, str(archive)).run()
    store.close()


@pytest.fixture(scope="module")
def filled(tmp_path_factory: pytest.TempPathFactory) -> Path:
    folder = tmp_path_factory.mktemp("clouds")
    fill_room(folder)
    return folder


@pytest.fixture
def folder(filled: Path, tmp_path: Path) -> Path:
    """The archive only."""
    shutil.copytree(filled / "plant", tmp_path / "plant")
    return tmp_path


@contextmanager
def collected(settings: Path, *options: str) -> Iterator[httpx.Client]:
    with running_fleet(settings, *options) as client:
        until(lambda: count(client) == RECORDS)
        yield client


def state_of(client: httpx.Client, scan_id: str = "one") -> Any:
    return client.get(CLOUDS.format(scan_id)).raise_for_status().json()


def order(client: httpx.Client, scan_id: str = "one", **wish: str) -> httpx.Response:
    return client.post(CLOUDS.format(scan_id), json=wish)


def ended(client: httpx.Client, scan_id: str = "one") -> Any:
    """The clouds of a scan when nothing is wanted any more, or what was wanted failed."""
    until(lambda: all(one["state"] == "failed" for one in state_of(client, scan_id)["orders"]))
    return state_of(client, scan_id)


def failure(client: httpx.Client, scan_id: str = "one") -> str:
    """The ids of why the only cloud that was wanted of a scan was not made."""
    (failed,) = ended(client, scan_id)["orders"]
    return ids_in(failed["problem"])


def ids_in(text: Any) -> str:
    return json.dumps(text)


def names_in(folder: Path) -> list[str]:
    return sorted(path.name for path in folder.iterdir())


def test_a_cloud_is_made_once_with_each_calibration(filled: Path, folder: Path) -> None:
    settings = write_settings(folder)
    kept = folder / "fleet-clouds"
    with collected(settings) as client:
        before = state_of(client)
        assert (before["problem"], before["made"], before["orders"]) == ("", [], [])
        assert [one["id"] for one in before["calibrations"]] == [TODAYS, CALIBRATION]
        assert before["used_calibration_id"] == CALIBRATION
        wanted = order(client).raise_for_status().json()
        assert order(client, calibration_id=CALIBRATION).json()["id"] == wanted["id"]
        order(client, calibration_id=TODAYS, format="ply").raise_for_status()
        todays, used = ended(client)["made"]
        assert (used["calibration_ids"], todays["calibration_ids"]) == ([CALIBRATION], [TODAYS])
        name = used["name"]
        assert name.startswith("room-2-one-")
        assert name.endswith(COPC)
        fetched = client.get(f"/api/fleet/clouds/{name}").raise_for_status()
        assert fetched.headers["content-disposition"] == f'attachment; filename="{name}"'
        assert fetched.content[:4] == b"LASF"
        part = client.get(f"/api/fleet/clouds/{name}", headers={"Range": "bytes=0-3"})
        assert (part.status_code, part.content) == (206, b"LASF")
        check_points(filled, kept / name)
        times = {path.name: path.stat().st_ino for path in kept.iterdir()}
        assert order(client).is_success
        ended(client)
        assert {path.name: path.stat().st_ino for path in kept.iterdir()} == times
        assert len(times) == 4
        check_refusals(client)


def check_points(filled: Path, cloud: Path) -> None:
    session, direct = filled / "data/sessions" / CALIBRATION, cloud.parent.parent / "direct.ply"
    recording = filled / "data/scans/one/scan.mcap"
    calibration = read_calibration(session / CALIBRATION_FILE)
    reconstruct_cloud(recording, calibration, read_any_arm(session / "arm.json"), direct)
    made, expected = (read_cloud(one).points_mm for one in (cloud, direct))
    assert len(made) == len(expected)
    apart_mm = np.linalg.norm(made[:, None] - expected, axis=2)
    assert apart_mm.min(axis=0).max() < 0.02


def check_refusals(client: httpx.Client) -> None:
    """Unknown scans, calibrations, formats and clouds, and the calibration of another sensor."""
    assert client.get(CLOUDS.format("none")).status_code == 404
    assert order(client, "none").status_code == 404
    for stranger in ("none", "../../data/sessions", "/etc"):
        assert order(client, calibration_id=stranger).status_code == 404
    assert order(client, format="exe").status_code == 422
    for name in ("none", "..%2F..%2Ffleet.toml", "room-2-one-0123456789abcdef.ply"):
        assert client.get(f"/api/fleet/clouds/{name}").status_code == 404
    foreign = {"Origin": "https://evil.example"}
    assert client.post(CLOUDS.format("one"), json={}, headers=foreign).status_code == 403
    order(client, "two", calibration_id=FOREIGN).raise_for_status()
    assert "batch-other-device" in failure(client, "two")


@pytest.mark.soak
def test_what_waits_is_made_once_and_in_order_after_a_restart(folder: Path) -> None:
    settings = write_settings(folder)
    kept = folder / "fleet-clouds"
    with collected(settings) as client:
        order(client).raise_for_status()
        (first,) = ended(client)["made"]
        order(client, "long").raise_for_status()
        with worker_held(kept, settings) as pid:
            (working,) = state_of(client, "long")["orders"]
            assert client.delete(f"/api/fleet/cloud-orders/{working['id']}").status_code == 204
            until(lambda: is_asked_to_end(pid))
        until(lambda: not state_of(client, "long")["orders"])
        assert len(names_in(kept)) == 2
        order(client, "long").raise_for_status()
        order(client, "two").raise_for_status()
        order(client, format="ply").raise_for_status()
        (cancelled,) = state_of(client, "one")["orders"]
        client.delete(f"/api/fleet/cloud-orders/{cancelled['id']}").raise_for_status()
        until_part_of(kept)
        hold(worker_of(settings))  # which the server kills, as it does not end
    # it was ended regularly in the middle
    left = [name for name in names_in(kept) if ORDERS_FILE not in name]
    assert left == [first["name"], first["name"].replace(COPC, ".json")]
    killed = False
    with suppress(AssertionError), running_fleet(settings):
        with worker_held(kept, settings):
            os.kill(pid_with(str(settings)), signal.SIGKILL)
        killed = True
    assert killed
    with running_fleet(settings) as client:
        until(lambda: not (kept / ORDERS_FILE).exists())
        (made,) = ended(client, "long")["made"]
        assert made["points"] > LONG_FRAMES
        assert [one["name"] for one in state_of(client)["made"]] == [first["name"]]
        (later,) = ended(client, "two")["made"]
    by_time = sorted(kept.glob("*.json"), key=lambda path: path.stat().st_mtime_ns)
    expected = [first["name"], made["name"], later["name"]]
    assert [json.loads(path.read_bytes())["cloud"] for path in by_time] == expected
    assert len(names_in(kept)) == 6


def test_bad_orders_are_no_hindrance(tmp_path: Path, caplog: pytest.LogCaptureFixture) -> None:
    orders = KeptOrders(tmp_path / "clouds" / ORDERS_FILE)
    assert orders.read() == ()
    wanted = [KeptOrder(station="room-2", scan_id=one, format="ply") for one in ("b", "a")]
    orders.write(wanted)
    assert list(orders.read()) == wanted
    orders.write([])
    assert names_in(tmp_path / "clouds") == []
    (tmp_path / "clouds" / ORDERS_FILE).write_text("{")
    assert orders.read() == ()
    assert "clouds that waited are not made" in caplog.text
    shutil.rmtree(tmp_path / "clouds")
    (tmp_path / "clouds").write_text("")
    orders.write(wanted)
    assert "would be forgotten" in caplog.text


def until_part_of(kept: Path) -> None:
    end_s = time.monotonic() + 60.0
    while not any(kept.glob(".room-2-*.part")):
        assert time.monotonic() < end_s
        time.sleep(0.002)


@contextmanager
def worker_held(kept: Path, settings: Path) -> Iterator[int]:
    """The process that makes a cloud, which waits while it is half-written."""
    until_part_of(kept)
    pid = worker_of(settings)
    hold(pid)
    try:
        yield pid
    finally:
        with suppress(ProcessLookupError):
            os.kill(pid, signal.SIGCONT)


def hold(pid: int) -> None:
    os.kill(pid, signal.SIGSTOP)


def worker_of(settings: Path) -> int:
    return pid_with("spawn_main", pid_with(str(settings)))


def is_asked_to_end(pid: int) -> bool:
    """Whether SIGTERM waits for a process that is held."""
    lines = Path(f"/proc/{pid}/status").read_text().splitlines()
    status = dict(line.split(":\t", 1) for line in lines)
    return bool(int(status["ShdPnd"], 16) >> (signal.SIGTERM - 1) & 1)


def pid_with(word: str, parent: int | None = None) -> int:
    """Of the process whose command has a word; None: whosever child it is."""
    for entry in Path("/proc").iterdir():
        with suppress(OSError):
            words = (entry / "cmdline").read_bytes().decode().split("\0")
            its_parent = (entry / "stat").read_text().rpartition(")")[2].split()[1]
            if any(word in one for one in words) and parent in (None, int(its_parent)):
                return int(entry.name)
    raise AssertionError(f"no process has {word}")


@pytest.mark.soak
def test_what_prevents_a_cloud_is_said_in_a_sentence(folder: Path) -> None:
    archive = folder / "plant/room-2"
    settings = write_settings(folder)
    with collected(settings) as client:
        shutil.rmtree(archive / "scans/two")
        order(client, "two").raise_for_status()
        assert "batch-no-recording" in failure(client, "two")
        archive.rename(folder / "away")
        order(client).raise_for_status()
        assert "archive-missing" in failure(client)
        (folder / "away").rename(archive)
        order(client, "long").raise_for_status()
        with worker_held(folder / "fleet-clouds", settings) as pid:
            os.kill(pid, signal.SIGKILL)
        assert "fleet-cloud-process-ended" in failure(client, "long")
        assert names_in(folder / "fleet-clouds") == []
        # the folder of the clouds is a file
        shutil.rmtree(folder / "fleet-clouds", ignore_errors=True)
        (folder / "fleet-clouds").write_text("")
        order(client).raise_for_status()
        (failed,) = ended(client)["orders"]
        assert failed["problem"]
        (folder / "fleet-clouds").unlink()
        order(client).raise_for_status()
        assert ended(client)["orders"] == []
        assert len(state_of(client)["made"]) == 1
    # the station is not in the settings any more
    (folder / "fleet.toml").write_text('[catalogue]\ndatabase = "sqlite:///catalogue.db"\n')
    with running_fleet(settings) as client:
        assert "fleet-clouds-no-place" in ids_in(state_of(client)["problem"])
        refused = order(client)
        assert (refused.status_code, refused.json()["code"]) == (422, "no-place")
        assert len(state_of(client)["made"]) == 1
    within = write_settings(folder, more='[clouds]\nfolder = "plant/room-2/clouds"\n')
    assert "Name a folder of its own" in refused_start(within)


def test_viewers_fetch_clouds_and_operators_order_them(folder: Path) -> None:
    (folder / "password").write_text(PASSWORD[1])
    with mock_provider() as provider:
        provider.register(f"http://{HOST}/sign-in")
        provider.put("1", preferred_username="Anna", groups=["measuring-room"])
        provider.put("3", preferred_username="Vera", groups=["visitors"])
        (folder / "secret").write_text(provider.secret)
        sign_in_table = SIGN_IN.format(issuer=provider.issuer, client=provider.client_id)
        more = f'[server]\npassword_file = "password"\n{sign_in_table}\n"visitors" = "viewer"\n'
        with running_fleet(write_settings(folder, more=more), "--host", "0.0.0.0") as client:
            with browser_of(client) as anna, browser_of(client) as vera:
                sign_in(anna, "1").raise_for_status()
                sign_in(vera, "3").raise_for_status()
                until(lambda: count(anna) == RECORDS)
                assert order(client).status_code == 401
                denied = order(vera)
                assert (denied.status_code, denied.json()["code"]) == (403, "role")
                assert "Vera may not do this" in denied.json()["detail"]
                assert vera.delete("/api/fleet/cloud-orders/1").status_code == 403
                order(anna).raise_for_status()
                (made,) = ended(vera)["made"]
                assert vera.get(f"/api/fleet/clouds/{made['name']}").is_success
            assert client.post(CLOUDS.format("one"), json={}, auth=PASSWORD).is_success


@pytest.mark.soak
def test_workers_of_a_scheduler_make_clouds(folder: Path) -> None:
    with ExitStack() as stack:
        dask = DaskProcesses(folder, os.environ)
        stack.callback(dask.close)
        dask.start_scheduler()
        dask.start_worker()
        settings = write_settings(folder, more=f'[clouds]\nscheduler = "{dask.address}"\n')
        client = stack.enter_context(collected(settings))
        order(client).raise_for_status()
        (made,) = ended(client)["made"]
        assert made["name"].endswith(COPC)
        dask.close()
        order(client, format="ply").raise_for_status()
        assert "batch-no-scheduler" in failure(client)


@pytest.mark.soak
def test_a_full_disk_is_said_and_room_on_it_used(folder: Path, small: Path) -> None:
    settings = write_settings(folder, more=f'[clouds]\nfolder = "{small}/clouds"\n')
    with collected(settings) as client:
        order(client).raise_for_status()
        assert len(ended(client)["made"]) == 1
        order(client, "long").raise_for_status()  # 3.8 MB, and room for sorting
        assert "fleet-clouds-make-room" in failure(client, "long")
        assert len(names_in(small / "clouds")) == 2
        filler = fill(small)
        order(client, format="ply").raise_for_status()
        assert "fleet-clouds-make-room" in failure(client)
        filler.unlink()
        order(client, format="ply").raise_for_status()
        assert len(ended(client)["made"]) == 2


def test_a_recording_in_the_data_folder_needs_no_archive(filled: Path, tmp_path: Path) -> None:
    """And the same recording has one result, wherever it is."""
    away = Place(settings_for(str(tmp_path / "away")), True)
    data = Place(settings_for(str(filled / "data")), False)
    archive = Place(settings_for(str(filled / "plant/room-2")), True)
    output = settings_for(str(tmp_path / "out"))

    def task_in(*places: Place, scan_id: str = "one", calibration_id: str = "") -> str:
        wanted = (calibration_id,) if calibration_id else ()
        return plan_cloud(CloudOrder(places, scan_id, wanted, output, COPC, tmp_path)).key

    assert task_in(data, away) == task_in(archive) == task_in(away, archive)
    assert task_in(data) == task_in(data, calibration_id=CALIBRATION)
    assert task_in(data) != task_in(data, calibration_id=TODAYS)
    for places, wanted, code in (
        ((data,), {"scan_id": "none"}, "no-recording"),
        ((data, away), {"scan_id": "none"}, "archive-missing"),
        ((data,), {"calibration_id": "none"}, "no-calibration"),
    ):
        with refused(code):
            task_in(*places, **wanted)


def test_each_sensor_of_a_scan_can_have_another_calibration(filled: Path, tmp_path: Path) -> None:
    data, output = tmp_path / "data", settings_for(str(tmp_path / "out"))
    shutil.copytree(filled / "data", data)
    sessions = data / "sessions"
    for name, serial in (("new-left", "S-1"), ("new-right", "S-2"), ("other-arm", "S-2")):
        shutil.copytree(sessions / (CALIBRATION if serial == "S-1" else FOREIGN), sessions / name)
    arm = sessions / "other-arm/arm.json"
    arm.write_text(arm.read_text().replace(" ", "  ", 1))
    write_recording_of_two(data / "scans/one/scan.mcap")

    place = Place(settings_for(str(data)), False)

    def used_by(*wanted: str) -> dict[str, str]:
        made = CloudOrder((place,), "one", wanted, output, COPC, tmp_path)
        return {sensor: one.id for sensor, one in plan_cloud(made).calibrations.items()}

    ResultStore(output).prepare()

    def warnings_about_arms() -> str:
        task = plan_cloud(CloudOrder((place,), "one", (), output, ".ply", tmp_path))
        return ids_in(perform(task, tmp_path, 1).result["warnings"])

    assert used_by() == used_by(FOREIGN) == OF_TWO
    assert "of left is used" not in warnings_about_arms()
    shutil.copy(arm, sessions / FOREIGN)
    assert "of left is used" in warnings_about_arms()
    shutil.copy(sessions / CALIBRATION / "arm.json", sessions / FOREIGN)
    assert used_by("new-right") == {**OF_TWO, "right": "new-right"}
    assert used_by("new-right", "new-left") == {"left": "new-left", "right": "new-right"}
    for wanted, code in (
        (("new-right", "other-arm"), "same-sensor"),
        (("other-arm",), "different-arms"),
        (("none",), "no-calibration"),
    ):
        with refused(code):
            used_by(*wanted)


def test_the_cloud_that_was_used_least_recently_is_removed_first(tmp_path: Path) -> None:
    key = key_of("test", "", {})[:16]
    names = [f"room-2-scan{number}-{key}{COPC}" for number in range(4)]
    for number, name in enumerate(names):
        for path in (tmp_path / name, tmp_path / name.replace(COPC, ".json")):
            path.write_bytes(b"x" * 500)
            os.utime(path, (1000.0 + number,) * 2)
    (tmp_path / "notes.txt").write_bytes(b"x" * 10_000)
    for remains in (PROBE, f".{names[0]}.0123.part"):
        (tmp_path / remains).write_bytes(b"")
    KeptClouds(tmp_path, 1e6).clear()
    assert len(names_in(tmp_path)) == 9
    kept = KeptClouds(tmp_path, 3000.0)
    kept.note_use(names[0])
    kept.keep_limit()
    left = {name for name in names_in(tmp_path) if name.endswith(COPC)}
    assert left == {names[0], names[2], names[3]}
    KeptClouds(tmp_path, 100.0).keep_limit(names[2])
    assert names_in(tmp_path) == ["notes.txt", names[2], names[2].replace(COPC, ".json")]
