"""The server as a process: started twice, asked to end, refused; scans of one that was killed."""

import json
import os
import re
import signal
import socket
import ssl
import time
import tomllib
from collections.abc import Callable, Iterator
from contextlib import contextmanager
from pathlib import Path
from typing import Any
from urllib.parse import urlsplit

import httpx
import numpy as np
import pytest
import trustme

from crenel.formats.clouds.files import read_cloud
from crenel.formats.images import write_png
from crenel.formats.json_document import SOFTWARE
from crenel.formats.recording.raw import MAGIC
from crenel.store.store import Store
from crenel_hardware.simulator.station import SimulatedStation
from tests.api.conftest import PATIENCE_S, code_of, wait_for
from tests.api.processes import demonstration
from tests.forked import COMMAND_LINE, ROOT, ForkedProgram
from tests.formats.test_recording_bombs import LARGE, lz4_zeros, zstd
from tests.sent_texts import english

pytestmark = [pytest.mark.device, pytest.mark.usefixtures("fork_server")]

Scan = dict[str, Any]


@contextmanager
def running(*arguments: str, folder: Path = ROOT) -> Iterator[tuple[ForkedProgram, str]]:
    """A server's process and its address; killed at the end if it still runs."""
    with ForkedProgram(COMMAND_LINE, arguments, folder) as process:
        try:
            reported = ""
            for line in process.stdout:
                reported += line
                if line.startswith("Ready"):
                    break
            yield process, next(word for word in reported.split() if word.startswith("http"))
        finally:
            process.kill()


def refusal(*arguments: str) -> str:
    """The one line with which a command is refused."""
    with ForkedProgram(COMMAND_LINE, arguments) as process:
        (line,) = process.stderr.read().strip().splitlines()
        assert process.wait(PATIENCE_S) == 1
        return line


def wait_in(path: str, http: httpx.Client, ready: Callable[[Any], bool]) -> Any:
    return wait_for(lambda: http.get(path).json(), ready)


def end(process: ForkedProgram) -> None:
    process.send_signal(signal.SIGTERM)
    assert process.wait(PATIENCE_S) in (0, 128 + signal.SIGTERM)


def test_the_demo_takes_the_next_port_and_ends_well_when_interrupted(tmp_path: Path) -> None:
    asked = ("demo", "--no-open", "--data", str(tmp_path), "--port")
    with socket.socket() as taken:
        taken.bind(("127.0.0.1", 0))
        taken.listen()
        port = taken.getsockname()[1]
        with running(*asked, str(port)) as (process, address):
            assert int(urlsplit(address).port or 0) > port
            assert f"process {process.pid}" in refusal(*asked, "0")
            process.send_signal(signal.SIGINT)
            time.sleep(0.02)
            process.send_signal(signal.SIGINT)
            assert process.wait(PATIENCE_S) in (0, 128 + signal.SIGINT, -signal.SIGINT)


NOWHERE = "socket://127.0.0.1:9"
SETTINGS = """
[station]
name = "Room 2"

[arm]
driver = "serial-encoder"
url = "{url}"

[sensor]
driver = "folder"
path = "{folder}"
"""


def serve(folder: Path, settings: str) -> tuple[str, ...]:
    """The command that serves a station with these settings and data in this folder."""
    (folder / "station.toml").write_text(settings)
    config, data = str(folder / "station.toml"), str(folder / "data")
    return ("serve", "--config", config, "--data", data, "--port", "0")


def test_a_station_on_real_drivers(tmp_path: Path) -> None:
    write_png(tmp_path / "picture.png", np.full((240, 320), 90, np.uint8))
    with SimulatedStation() as simulation:
        text = SETTINGS.format(folder=tmp_path, url=simulation.arm_url)
        with (
            running(*serve(tmp_path, text)) as (process, address),
            httpx.Client(base_url=address) as http,
        ):
            assert http.get("/api/home").status_code == 401
            make_admin(process, http)
            about: dict[str, object] = {"has_simulation": False, "simulated": False}
            about |= {"name": "Room 2", "version": SOFTWARE.version}
            assert http.get("/api/home").json()["station"] == about
            http.post("/api/flow/start").raise_for_status()
            view = wait_in("/api/flow", http, lambda view: view["actions"][0]["enabled"])
            assert "TWIN-A1" in english(view["picture"]["devices"][0]["text"])
            assert "run_simulation" not in [action["name"] for action in view["actions"]]
            assert code_of(http.post("/api/laser/on")) == (422, "no-laser-switch")
            assert http.post("/api/laser/off").status_code == 200
            end(process)


def test_a_new_station_gets_its_devices_in_the_browser(tmp_path: Path) -> None:
    write_png(tmp_path / "picture.png", np.full((240, 320), 90, np.uint8))
    asked = running("serve", "--data", str(tmp_path / "data"), "--port", "0", folder=tmp_path)
    with asked as (process, address), httpx.Client(base_url=address) as http:
        make_admin(process, http)
        shown = http.get("/api/devices").json()
        assert [one["driver"] for one in shown["devices"]] == ["", ""]
        assert "Choose one" in english(shown["devices"][1]["state"]["text"])
        chosen = {"kind": "sensor", "driver": "folder", "options": {"path": str(tmp_path)}}
        http.post("/api/devices", json=chosen).raise_for_status()
        wait_in(
            "/api/devices", http, lambda view: view["devices"][1]["state"]["state"] == "connected"
        )
        end(process)
    tables = tomllib.loads((tmp_path / "station.toml").read_text())
    assert tables == {"sensor": {"driver": "folder", "path": str(tmp_path)}}
    created = [tmp_path / "station.toml", tmp_path / "data", *(tmp_path / "data").rglob("*")]
    assert [path for path in created if path.stat().st_mode & 0o077] == []


def test_a_station_over_tls(tmp_path: Path) -> None:
    authority = trustme.CA()
    issued = authority.issue_cert("localhost", "127.0.0.1")
    issued.cert_chain_pems[0].write_to_path(tmp_path / "cert.pem")
    issued.private_key_pem.write_to_path(tmp_path / "key.pem")
    text = SETTINGS.format(folder=tmp_path, url=NOWHERE)
    tls = '[station]\ntls_certificate = "cert.pem"\ntls_key = "key.pem"'
    trusted = ssl.create_default_context()
    authority.configure_trust(trusted)
    with running(*serve(tmp_path, text.replace("[station]", tls))) as (process, address):
        assert address.startswith("https://")
        with httpx.Client(base_url=address, verify=trusted) as http:
            make_admin(process, http)
            answer = http.post("/api/session", json={"name": "Ada", "password": "correct horse"})
            assert "secure" in answer.headers["set-cookie"].lower()
            assert http.get("/api/home").status_code == 200
        end(process)


@pytest.mark.parametrize(
    ("keys", "reported"),
    [
        ('tls_certificate = "none.pem"', "tls_certificate is given without the other"),
        ('tls_certificate = "none.pem"\ntls_key = "none.pem"', "there is no such file"),
        ('tls_certificate = "picture.png"\ntls_key = "picture.png"', "they are not a certificate"),
    ],
)
def test_a_useless_certificate_is_refused(tmp_path: Path, keys: str, reported: str) -> None:
    write_png(tmp_path / "picture.png", np.full((24, 32), 90, np.uint8))
    text = SETTINGS.format(folder=tmp_path, url=NOWHERE)
    assert reported in refusal(*serve(tmp_path, text.replace("[station]", f"[station]\n{keys}")))


def make_admin(process: ForkedProgram, http: httpx.Client) -> None:
    """What the one who sets the station up does with the code on the console."""
    code = re.search(r"code (\w+)", process.stdout.readline())
    assert code
    asked = {"code": code.group(1), "name": "Ada", "password": "correct horse"}
    http.post("/api/session/admin", json=asked).raise_for_status()
    assert http.get("/api/session").json()["you"]["role"] == "admin"
    again = http.post("/api/session/admin", json={**asked, "name": "Eve"})
    assert again.json()["code"] == "not-first-start"


@pytest.mark.skipif(not hasattr(os, "geteuid") or os.geteuid() == 0, reason="root may write all")
def test_a_folder_that_may_not_be_written_is_refused(tmp_path: Path) -> None:
    tmp_path.chmod(0o500)
    line = refusal("demo", "--no-open", "--port", "0", "--data", str(tmp_path / "data"))
    assert json.dumps(str(tmp_path))[1:-1] in line


def until(http: httpx.Client, path: str, enough: Callable[[Any], bool]) -> Any:
    return wait_for(lambda: http.get(path).json(), enough)


def health(http: httpx.Client, name: str) -> Scan:
    items = http.get("/api/health").json()["health"]["items"]
    return next(dict(item) for item in items if item["id"] == name)


def test_scans_under_way_when_the_process_dies_are_listed_with_their_clouds(tmp_path: Path) -> None:
    with demonstration(tmp_path, calibrated=True) as (http, pid):
        until(http, "/api/scan", lambda scan: scan["state"] == "idle")
        http.post("/api/scan/start", json={"name": "Bracket"}).raise_for_status()
        http.post("/api/scan/simulation", json={"on": True}).raise_for_status()
        before = until(http, "/api/scan", lambda scan: scan["seconds"] > 2.0)
        os.kill(pid, signal.SIGKILL)
    scans = tmp_path / "scans"
    (folder,) = scans.iterdir()
    (scans / ".deleted-20260101-000000").mkdir()
    assert list(folder.glob(".*.part")), "the cloud's part was left"
    with demonstration(tmp_path, calibrated=True) as (http, _):
        (scan,) = http.get("/api/scans").json()
        assert scan["name"] == "Bracket"
        assert english(scan["note"]).startswith("The station ended during this scan.")
        (scan,) = until(http, "/api/scans", lambda scans: scans[0]["points"] > 0)
        assert english(scan["note"]).endswith("All recorded data is kept.")
        # what was shown less than half a second before may be lost
        assert scan["frames"] > 0.5 * before["frames"]
        assert len(read_cloud(folder / "cloud.ply").points_mm) == scan["points"]
        names = [folder.name, "cloud.ply", "readings.ply", "scan.mcap"]
        assert sorted(path.name for path in scans.rglob("*")) == sorted(names)
        assert health(http, "recordings")["quality"] == "good"
        (folder / "scan.mcap").write_bytes((folder / "scan.mcap").read_bytes()[:-1])
        assert "is incomplete" in english(http.get("/api/scans").json()[0]["note"])
        (folder / "scan.mcap").unlink()
        assert "is missing" in english(http.get("/api/scans").json()[0]["note"])
    (folder / "scan.mcap").write_bytes(b"")
    with demonstration(tmp_path, calibrated=True) as (http, _):
        (scan,) = http.get("/api/scans").json()
        assert english(scan["note"]) == "The recording is empty."
        item = health(http, "recordings")
        assert item["quality"] == "bad"
        assert english(item["what"]) == "Bracket: the recording is empty."
    store = Store(tmp_path)
    assert store.check() == ""
    store.close()


def test_recordings_that_open_to_gigabytes_hold_up_no_start(tmp_path: Path) -> None:
    Store(tmp_path).close()
    bombs = {"lz4": lz4_zeros(LARGE, LARGE), "zstd": zstd(LARGE, LARGE), "holes": b"\1"}
    for name, bomb in bombs.items():
        (tmp_path / "scans" / name).mkdir(parents=True)
        (tmp_path / "scans" / name / "scan.mcap").write_bytes(MAGIC + bomb)
    os.truncate(tmp_path / "scans" / "holes" / "scan.mcap", 1 << 40)
    with demonstration(tmp_path, calibrated=True) as (http, pid):
        scans = http.get("/api/scans").json()
        assert {scan["name"] for scan in scans} == set(bombs)
        said = "Its points cannot be computed"
        until(http, "/api/scans", lambda scans: all(said in english(one["note"]) for one in scans))
        status = Path(f"/proc/{pid}/status").read_text()
        assert int(status.split("VmHWM:")[1].split()[0]) < 1_500_000
