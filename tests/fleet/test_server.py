"""``crenel fleet`` as a process: it collects, answers, and survives the loss of its database."""

import socket
import subprocess
import sys
import time
from collections.abc import Callable, Iterator
from contextlib import contextmanager
from pathlib import Path

import httpx
import pytest
from typer.testing import CliRunner

from crenel.cli.main import cli
from crenel.fleet.catalogue.catalogue import FleetCatalogue
from crenel.store.store import Store
from tests.bench.faults.broker.mosquitto import BINARY, Mosquitto
from tests.fleet.postgres import PostgresServer
from tests.fleet.records import add_every_kind, add_recorded_scan
from tests.fleet.test_questions import ten_months

pytestmark = pytest.mark.device
DEADLINE_S = 300.0


@contextmanager
def running_fleet(settings: Path, *options: str) -> Iterator[httpx.Client]:
    command = [sys.executable, "-c", "from crenel.cli.main import main; main()", "fleet"]
    with (
        (settings.parent / "fleet.log").open("wb") as log,
        subprocess.Popen(
            [*command, "--config", str(settings), "--port", "0", *options],
            stdout=subprocess.PIPE,
            stderr=log,
            text=True,
        ) as process,
    ):
        try:
            assert process.stdout is not None
            address = process.stdout.readline().split()[3]
            with httpx.Client(base_url=address, timeout=30.0, trust_env=False) as client:
                yield client
        finally:
            process.terminate()
            assert process.wait(DEADLINE_S) in (0, -15, 143)


def refused_start(settings: Path, *options: str) -> str:
    """The one line with which a start ends that these settings do not allow."""
    refused = CliRunner().invoke(cli, ["fleet", "--config", str(settings), *options])
    assert (refused.exit_code, refused.stderr.count("\n")) == (1, 1)
    return refused.stderr


def until(ready: Callable[[], object]) -> None:
    end_s = time.monotonic() + DEADLINE_S
    while not ready():
        assert time.monotonic() < end_s
        time.sleep(0.1)


def count(client: httpx.Client) -> int:
    answer = client.get("/api/fleet/overview")
    return sum(one["records"] for one in answer.json()["stations"]) if answer.is_success else -1


def write_settings(tmp_path: Path, database: str, look_s: float, more: str = "") -> Path:
    path = tmp_path / "fleet.toml"
    path.write_text(
        f'[catalogue]\ndatabase = "{database}"\nlook_s = {look_s}\n'
        f'[stations.room-1]\nname = "Room 1"\ndata = "data"\n{more}'
    )
    return path


@pytest.fixture
def store(store: Store) -> Store:
    """Of a station that has a record of every kind."""
    add_every_kind(store)
    return store


def test_it_collects_and_answers(store: Store, own: FleetCatalogue, tmp_path: Path) -> None:
    own.add(ten_months((120, 150), by_calibration=True))
    with running_fleet(write_settings(tmp_path, "sqlite:///catalogue.db", 1.0)) as client:
        until(lambda: count(client) == 417)
        add_recorded_scan(store, "20260504-121500", "Housing 4712")
        until(lambda: count(client) == 418)
        found = client.get("/api/fleet/records", params={"text": "housing 4712"}).json()
        assert [one["id"] for one in found["records"]] == ["20260504-121500"]
        first = client.get("/api/fleet/records").json()
        assert first["more"]
        last = first["records"][-1]
        after = {"before": last["at"], "before_key": last["key"]}
        second = client.get("/api/fleet/records", params=after).json()["records"]
        assert not {one["key"] for one in second} & {one["key"] for one in first["records"]}
        detail = client.get("/api/fleet/records/room-1/tip_check/20260504-080000-dd44").json()
        assert detail["figures"][0]["value"] == -100.0
        assert detail["figures"][0]["title"]["message_id"] == "fleet-tip-diameter-error"
        known = {one["id"]: one for one in client.get("/api/fleet/overview").json()["quantities"]}
        assert known["laser-plane-offset"]["of_calibrations"]
        assert known["location-scan"]["unit"] == "µm"
        (spread,) = client.get("/api/fleet/spread/laser-plane-offset").json()["spreads"]
        assert (spread["station"], len(spread["values"])) == ("room-1", 1)
        aged = client.get("/api/fleet/ageing/location-scan", params={"station": "room-3"}).json()
        assert aged["stations"][0]["since"] == "calibration"
        assert aged["stations"][0]["per_1000_h"]["groups"] == 10
        missing = client.get("/api/fleet/records/room-1/scan/none")
        assert (missing.status_code, missing.json()["code"]) == (404, "not-found")
        (period,) = client.get("/api/fleet/drift/location-scan").json()["periods"]
        assert (period["station"], period["calibration_ids"]) == ("room-3", ["cal-4"])
        assert len(period["recordings"]) == 30
        calibrations = client.get("/api/fleet/calibrations").json()["calibrations"]
        assert {one["station"] for one in calibrations} == {"room-1", "room-3"}
        assert client.get("/api/fleet/stations").json() == {"broker": None, "stations": []}
        assert "text/html" in client.get("/").headers["content-type"]
        assert client.get("/api/other").status_code == 404
        for wrong in (
            {"since": "soon"},
            {"until": "0001-01-01T00:00:00+14:00"},
            {"before": "9999-12-31T23:59:59-14:00"},
            {"before": "2026-05-01T00:00:00Z", "before_key": str(2**63)},
        ):
            assert client.get("/api/fleet/records", params=wrong).status_code == 422, wrong


def test_a_lost_database_comes_back(store: Store, postgres: PostgresServer, tmp_path: Path) -> None:
    with running_fleet(write_settings(tmp_path, postgres.new_database(), 1.0)) as client:
        until(lambda: count(client) == 7)
        postgres.stop()
        try:
            until(lambda: count(client) == -1)
            refused = client.get("/api/fleet/overview")
            assert refused.status_code == 503
            assert "cannot be used now" in refused.json()["detail"]
            add_recorded_scan(store, "20260504-121500", "Housing 4712")
        finally:
            postgres.start()
        until(lambda: count(client) == 8)
        assert client.get("/api/fleet/overview").json()["problem"] == ""


def test_an_event_of_a_station_is_followed_by_a_look_at_it(store: Store, tmp_path: Path) -> None:
    if BINARY is None:
        pytest.skip("mosquitto is not installed")
    with Mosquitto(tmp_path) as broker:
        mqtt = f'[mqtt]\nhost = "127.0.0.1"\nport = {broker.port}\n'
        settings = write_settings(tmp_path, "sqlite:///catalogue.db", 86_400.0, mqtt)
        with running_fleet(settings) as client:
            until(lambda: count(client) == 7)
            add_recorded_scan(store, "20260504-121500", "Housing 4712")
            command = [sys.executable, "-m", "tests.supervision.publishing", str(broker.port)]
            with subprocess.Popen([*command, "room-1"], stdout=subprocess.DEVNULL) as station:
                until(lambda: count(client) == 8)
                heard = client.get("/api/fleet/stations").json()
                station.terminate()
            assert heard["broker"]
            assert [one["id"] for one in heard["stations"]] == ["room-1"]


def test_a_password_is_required_of_every_request(store: Store, tmp_path: Path) -> None:
    (tmp_path / "password").write_text("a page's password\n")
    more = '[server]\npassword_file = "password"\n'
    settings = write_settings(tmp_path, "sqlite:///catalogue.db", 60.0, more)
    with running_fleet(settings, "--host", "0.0.0.0") as client:
        for path in ("/", "/api/fleet/overview", "/favicon.svg"):
            refused = client.get(path)
            assert refused.status_code == 401
            assert refused.headers["www-authenticate"].startswith("Basic")
            assert client.get(path, auth=("anyone", "wrong")).status_code == 401
            assert client.get(path, auth=("anyone", "a page's password")).is_success
        assert client.get("/", headers={"Authorization": "Basic %"}).status_code == 401
        for _ in range(50):
            with socket.create_connection((client.base_url.host, client.base_url.port)) as stranger:
                stranger.sendall(b"no request\r\n\r\n")
                assert b" 400 " in stranger.recv(100)
    assert 0 < (tmp_path / "fleet.log").read_bytes().count(b"Invalid HTTP request") <= 4


def test_nobody_elsewhere_reads_it_without_a_sign_in_or_a_password(tmp_path: Path) -> None:
    settings = write_settings(tmp_path, "sqlite:///catalogue.db", 60.0)
    assert "could read the catalogue" in refused_start(settings, "--host", "0.0.0.0")
