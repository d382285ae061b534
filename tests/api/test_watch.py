"""What watches over the station: its report, metrics, health, log, support bundle, backups."""

import io
import json
import logging
import re
import time
import zipfile
from dataclasses import replace
from pathlib import Path
from typing import Any

import httpx
import pytest
from jsonschema import Draft202012Validator
from prometheus_client import REGISTRY
from prometheus_client.parser import text_string_to_metric_families
from websockets.sync.client import connect

from crenel.api.access.browser import cookie_for
from crenel.api.monitoring.health import BUNDLING
from crenel.errors import sentence
from crenel.findings import GRAVEST_FIRST
from crenel.messages.message import message
from crenel.operations.publishers import _notify_due, _pass_on
from crenel.operations.services import MonitoringSettings
from crenel.operations.status_report import build_report
from crenel.station.bus import Event
from crenel.store.accounts import Role
from crenel.store.store import Store
from crenel.supervision.broker_settings import BrokerSettings
from crenel.supervision.messages import schema
from crenel.wire.schema import Home
from tests.api.conftest import PATIENCE_S, Server, until, wait_for
from tests.sent_texts import english
from tests.supervision.test_webhook import Receiver, receiver

pytestmark = pytest.mark.device

__all__ = ["receiver"]


def as_role(server: Server, role: Role) -> httpx.Client:
    store, name = server.context.store, f"the watching {role.name}"
    if store.accounts.get(name) is None:
        store.accounts.add(name, role, "three unrelated words")
    cookies = {cookie_for(server.port): store.login_sessions.begin(name, "test")}
    return httpx.Client(base_url=server.address, cookies=cookies, timeout=PATIENCE_S)


def topics(server: Server, wanted: set[str]) -> dict[str, Any]:
    found: dict[str, Any] = {}
    with connect(server.live, additional_headers=server.cookie) as socket:
        if "stations" in wanted:
            socket.send(json.dumps({"type": "stations", "on": True}))
        while set(found) != wanted:
            message = json.loads(socket.recv(PATIENCE_S))
            if message["type"] == "topic" and message["name"] in wanted:
                found[message["name"]] = message["value"]
    return found


def notify(server: Server, url: str, secret: str | None = "", **changes: bool) -> httpx.Response:
    kinds = {"done": True, "fault": True, "due": True}
    body = {"url": url, "secret": secret, **kinds, **changes}
    return server.http.post("/api/notifications", json=body).raise_for_status()


def test_the_report_is_as_the_schema_says(server: Server) -> None:
    until(lambda: server.context.monitoring.temperature.now.celsius)
    report = wait_for(
        lambda: build_report(server.context).model_dump(mode="json"),
        lambda report: report["devices"][0]["state"] == "connected",
    )
    document = json.loads(json.dumps(schema()))
    Draft202012Validator({**document, "$ref": "#/$defs/StationReport"}).validate(report)
    assert report["name"] == "Demonstration"
    assert [device["name"] for device in report["devices"]] == ["arm", "camera"]
    assert report["devices"][0]["state"] == "connected"
    assert 20 < report["temperature_c"] < 23
    assert report["disk_free_gb"] > 0
    shown = topics(server, {"report", "stations"})["report"]
    assert shown["activity"]["title"] == report["activity"]["title_message"]
    assert "title_message" not in shown["activity"]


def test_what_is_repeated_warns_once(server: Server, caplog: pytest.LogCaptureFixture) -> None:
    caplog.set_level(logging.INFO, "crenel.operations.publishers")
    for _ in range(5):
        _pass_on(server.context, Event(1, "stopped", "attention", "Stopped: as a test."))
    _pass_on(server.context, Event(2, "arm-lost", "bad", "The arm is lost: as a test."))
    levels = [one.levelname for one in caplog.records if "as a test" in one.getMessage()]
    assert levels == ["WARNING", "INFO", "INFO", "INFO", "INFO", "WARNING"]


def test_what_runs_is_reported_step_by_step(touching: Server) -> None:
    def activity() -> dict[str, object]:
        report = topics(touching, {"report"})["report"]
        assert isinstance(report, dict)
        return dict(report["activity"])

    until(lambda: activity()["step"] == 3)
    reported = activity()
    assert (reported["kind"], reported["steps"]) == ("calibrating", 7)
    assert reported["title"] == touching.flow()["title"]


def test_metrics_are_for_those_who_have_a_token(server: Server) -> None:
    made = server.http.post("/api/tokens", json={"name": "Prometheus"}).json()
    token = made["token"]
    assert "token" in made
    assert token not in json.dumps(server.http.get("/api/tokens").json())
    with httpx.Client(base_url=server.address) as http:
        assert http.get("/metrics").status_code == 401, "loopback is no right"
        wrong = http.get("/metrics", headers={"Authorization": f"Bearer {token}x"})
        assert wrong.status_code == 401
        good = {"Authorization": f"Bearer {token}"}
        assert http.get("/metrics", headers=good).status_code == 200
        for path in ("/api/home", "/api/health", "/api/audit"):
            assert http.get(path, headers=good).status_code == 401, "it opens nothing else"
        assert server.http.delete(f"/api/tokens/{made['id']}").status_code == 204
        assert http.get("/metrics", headers=good).status_code == 401
    assert server.http.delete(f"/api/tokens/{made['id']}").status_code == 404


def test_metrics_are_named_and_counted_as_prometheus_wants_them(server: Server) -> None:
    before = set(REGISTRY._names_to_collectors)
    answer = server.http.get("/metrics")
    assert answer.headers["content-type"].startswith("text/plain; version=")
    families = {one.name: one for one in text_string_to_metric_families(answer.text)}
    assert set(REGISTRY._names_to_collectors) == before
    for name, family in families.items():
        assert name.startswith(("crenel_", "process_")), name
        assert family.documentation, name
        units = re.search(r"_(ms|us|um|mm|gb|mb|minutes|hours|days|percent)(_|$)", name)
        assert not units, f"{name}: base units only"

    def value(name: str, **labels: str) -> float:
        samples = families[name.removesuffix("_total")].samples
        (found,) = (one for one in samples if (one.name, one.labels) == (name, labels))
        return float(found.value)

    assert value("crenel_device_up", device="arm") in (0.0, 1.0)
    assert 0 <= value("crenel_device_data_age_seconds", device="camera") < 60
    assert value("crenel_device_records_received_total", device="arm") > 100
    assert value("crenel_disk_free_bytes") > 0
    assert value("crenel_scan_running") == 0.0
    assert value("crenel_event_loop_stalls_total") >= 0
    assert 20 < value("crenel_temperature_celsius") < 23
    assert value("process_resident_memory_bytes") > 1e7
    assert families["crenel_device_records_received"].type == "counter"
    assert families["crenel_job_duration_seconds"].type == "histogram"
    assert "crenel_clients" in families


def test_jobs_are_timed(server: Server) -> None:
    server.wait_until_idle()
    server.context.jobs.start("A test's job", lambda progress: time.sleep(0.6), lambda job: None)
    until(lambda: "A test's job" in server.context.monitoring.job_times)
    text = server.http.get("/metrics").text
    bucket = 'crenel_job_duration_seconds_bucket{job="A test\'s job",le="%s"}'
    assert f"{bucket % '0.5'} 0.0" in text
    assert f"{bucket % '+Inf'} 1.0" in text


def health(server: Server) -> dict[str, Any]:
    items = server.http.get("/api/health").json()["health"]["items"]
    return {item["id"]: item for item in items}


def test_health_says_what_why_and_what_to_do(server: Server) -> None:
    until(lambda: server.context.monitoring.health)
    found = health(server)
    assert set(found) >= {
        *("device-arm", "device-sensor", "losses-arm", "losses-sensor", "room", "disk"),
        *("folder", "database", "backup", "clock", "loop", "memory", "log", "software"),
    }
    ranks = [GRAVEST_FIRST.index(item["quality"]) for item in found.values()]
    assert ranks == sorted(ranks)
    for item in found.values():
        assert item["what"]
        assert item["why"]
        assert item["remedy"] or item["quality"] in ("good", "neutral"), item
    assert found["database"]["quality"] == "good"


def test_the_log_is_for_operators(server: Server) -> None:
    logging.getLogger("crenel.test").warning("a strange noise of the gearbox")
    until(lambda: server.http.get("/api/logs", params={"words": "gearbox"}).json())
    (line,) = server.http.get("/api/logs", params={"level": "warning", "words": "GEARBOX"}).json()
    assert (line["level"], line["logger"]) == ("warning", "crenel.test")
    assert server.http.get("/api/logs", params={"level": "error", "words": "gearbox"}).json() == []
    assert server.http.get("/api/logs", params={"level": "loud"}).status_code == 422
    logging.getLogger("crenel.test").warning(message("no-such-file-or-folder"))
    german = {"words": "Datei strange", "lang": "de"}
    assert server.http.get("/api/logs", params=german).json() == []
    german["words"] = "DATEI crenel.test"
    until(lambda: server.http.get("/api/logs", params=german).json())
    assert server.http.get("/api/logs", params={**german, "lang": "en"}).json() == []
    with as_role(server, Role.viewer) as viewer:
        assert viewer.get("/api/logs").status_code == 403
        assert viewer.get("/api/support.zip").status_code == 403
        assert viewer.get("/api/health").status_code == 200


PLANTED = {
    "a webhook's secret": "wh-s3cret-of-the-hook",
    "its address": "k3y-in-the-address",
    "an MQTT password": 'broker "pass" wörd',
    "a camera password": "camera-pa55",
    "a driver's key": "key-of-a-driver",
    "a private key": "MIIEvgIBADANBgkqhkiG9w0BAQEFAASCBKgwggSkAgEAAoIBAQC7VJTUt9Us8cKj",
    "a person": "Philippa Nobody",
    "a remote address": "10.20.30.40",
}


def test_one_support_bundle_is_made_at_a_time(server: Server) -> None:
    with BUNDLING:
        answer = server.http.get("/api/support.zip")
        assert (answer.status_code, answer.json()["code"]) == (422, "busy")
    assert server.http.get("/api/support.zip").status_code == 200


def test_the_support_bundle_holds_no_secret_and_nobody(
    server: Server, tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    """Planted wherever they might be, and said into the log, too."""
    context, store = server.context, server.context.store
    person = PLANTED["a person"]
    store.accounts.add(person, Role.operator, "three unrelated words")
    cookie = store.login_sessions.begin(person, "a browser")
    _, kiosk = store.kiosk_links.add("Hall", person)
    _, api_token = store.api_tokens.add("Prometheus", person)
    store.audit.note(person, PLANTED["a remote address"], f"hello from {person}")
    (tmp_path / "password").write_text(PLANTED["an MQTT password"])
    reported = {
        **context.monitoring.settings.effective_settings,
        "sensor": {
            "url": f"rtsp://admin:{PLANTED['a camera password']}@{PLANTED['a remote address']}/1",
            "nested": [{"api_key": PLANTED["a driver's key"]}],
        },
    }
    watching = MonitoringSettings(
        mqtt=BrokerSettings(host="broker.local", password_file=tmp_path / "password"),
        effective_settings=reported,
    )
    monkeypatch.setattr(context.monitoring, "settings", watching)
    notify(server, f"http://127.0.0.1:9/{PLANTED['its address']}", PLANTED["a webhook's secret"])
    log = logging.getLogger("crenel.test")
    code = context.authenticator.code or ""
    hashed = store._database.read("SELECT password FROM account WHERE name = ?", person)
    key = f"-----BEGIN PRIVATE KEY-----\n{PLANTED['a private key']}\n-----END PRIVATE KEY-----"
    more = {"cookie": cookie, "kiosk": kiosk, "api token": api_token, "code": code}
    for words in (*PLANTED.values(), *more.values(), key, hashed[0]["password"]):
        log.warning("somebody said %s to %s", words, person)
    log.warning("password=%s", "another-one-nobody-knows")
    log.warning("open http://station/#wall=%s", kiosk)
    until(lambda: server.http.get("/api/logs", params={"words": "#wall="}).json())

    answer = server.http.get("/api/support.zip")
    assert answer.headers["content-type"] == "application/zip"
    with zipfile.ZipFile(io.BytesIO(answer.content)) as archive:
        files = {name: archive.read(name).decode() for name in archive.namelist()}
    assert set(files) >= {"README.txt", "health.json", "settings.json", "logs/station.jsonl"}
    whole = "\n".join([*files, *files.values()])
    secrets = {**PLANTED, **more, "a hash": hashed[0]["password"], "unknown": "another-one-nobody"}
    for what, words in secrets.items():
        assert words, what
        for spelled in (words, json.dumps(words)[1:-1]):
            assert spelled not in whole, what
    assert str(store.folder) not in whole
    for name, text in files.items():
        if name.endswith(".json"):
            json.loads(text)
        elif name.endswith(".jsonl"):
            for line in text.splitlines():
                json.loads(line)
    assert "somebody said" in files["logs/station.jsonl"]
    assert '"kind": "started"' in files["journal.jsonl"] or not store.journal.last_number()
    notify(server, "")


def test_notifications_go_where_the_administrator_says(server: Server, receiver: Receiver) -> None:
    secret = "never shown again"
    answer = notify(server, receiver.url, secret, due=False)
    assert answer.json()["has_secret"]
    assert secret not in answer.text
    assert secret not in server.http.get("/api/notifications").text
    server.http.post("/api/notifications/test").raise_for_status()
    until(lambda: receiver.taken)
    headers, body = receiver.taken[0]
    assert json.loads(body)["kind"] == "test"
    assert headers["Crenel-Signature"].startswith("sha256=")
    server.context.bus.event("arm-lost", "The arm is lost, says a test", "bad")
    server.context.bus.event("arm-lost", "The arm is lost, says a test", "bad")
    server.context.bus.event("scan-saved", "A scan of a test is saved", "good")
    until(lambda: len(receiver.taken) == 3)
    kinds = [json.loads(body)["kind"] for _, body in receiver.taken]
    # those of one moment go side by side, in any order
    assert (kinds[0], set(kinds[1:])) == ("test", {"fault", "done"})
    assert topics(server, {"notice"})["notice"]["text"] == "A scan of a test is saved"

    assert notify(server, receiver.url, None, due=False).json()["has_secret"]
    moved = notify(server, f"{receiver.url}&more", None, due=False).json()
    assert not moved["has_secret"], "a secret goes to no address that it was not given for"
    with pytest.raises(httpx.HTTPStatusError) as wrong:
        notify(server, "file:///etc/passwd", secret, due=False)
    assert wrong.value.response.json()["code"] == "webhook-url"
    notify(server, "", due=False)
    assert server.http.post("/api/notifications/test").json()["code"] == "no-webhook"


def test_what_comes_due_is_notified_once(server: Server, receiver: Receiver) -> None:
    home = server.context.bus.latest("home")
    assert isinstance(home, Home)
    notify(server, receiver.url, done=False, fault=False)
    at = "2026-01-01T00:00:00Z"
    old = replace(home.checks[0], state="due", text="It is old, says a test.", at=at)
    reported = _notify_due(server.context, set())
    server.context.bus.publish("home", replace(home, checks=(old, *home.checks[1:])))
    for _ in range(3):
        reported = _notify_due(server.context, reported)
    server.context.bus.publish("home", home)
    until(lambda: receiver.taken)
    texts = [json.loads(body)["text"] for _, body in receiver.taken]
    assert texts.count(f"Calibration: It is old, says a test. {sentence(old.action)!s}") == 1
    notify(server, "", done=False, fault=False)


def test_a_backup_of_the_running_station_is_a_station(server: Server) -> None:
    notify(server, "")
    began = server.http.post("/api/backup")
    assert began.status_code == 200, began.text
    until(lambda: server.http.get("/api/health").json()["backup"]["share"] is None)
    state = server.http.get("/api/health").json()["backup"]
    assert state["trouble"] == ""
    last = server.context.monitoring.backups.last
    assert last is not None
    assert last.folder.endswith(state["last"]["folder"])
    copy = Store(Path(last.folder))
    assert copy.check() == ""
    names = {account.name for account in copy.accounts.all()}
    assert names == {account.name for account in server.context.store.accounts.all()}
    assert copy.journal.last_number() <= server.context.store.journal.last_number()
    assert (copy.folder / "arms/simulated.json").is_file()
    assert (copy.folder / "notifications.json").is_file()
    copy.close()
    until(lambda: "same disk" in english(health(server)["backup"]["what"]))
