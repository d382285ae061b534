"""station.toml: read with its defaults, refused with the key's name, and changed by the program."""

import tomllib
from dataclasses import replace
from pathlib import Path
from typing import Any

import pytest

from crenel.errors import OperationError
from crenel.gauges.plan.document_gauge import DEFAULT_LIMITS
from crenel.guide.common.validity import DUE
from crenel.metrology.decision import EXPANDED_K2, GUARDED_95
from crenel.metrology.limits import LIMITS
from crenel.settings.device_tables import write_device
from crenel.settings.settings import DeviceTable, LimitsTable
from crenel.settings.station_toml import read_settings
from crenel.station.pulses.pulse_trigger import TriggerSettings
from tests.present import present

GOOD = """
[station]
name = "Room 2"
data = "records"
hosts = ["station.local"]
[arm]
driver = "serial-encoder"
url = "/dev/ttyUSB0"
[sensor]
driver = "opencv"
source = 0
[limits]
good_um = 30
"""
FILE = """# Measuring room 2
[station]
name = "Room 2"   # by the window

[arm]
driver = "serial-encoder"  # own firmware
# the port of the left adapter
url = "/dev/ttyUSB0"       # left

# stricter than usual
[limits]
good_um = 30 # agreed with the customer
"""


def write(tmp_path: Path, text: str) -> Path:
    path = tmp_path / "station.toml"
    path.write_text(text)
    return path


def refusal(file: Path) -> OperationError:
    with pytest.raises(OperationError) as caught:
        read_settings(file)
    return caught.value


def test_a_whole_file(tmp_path: Path) -> None:
    settings = read_settings(write(tmp_path, GOOD))
    assert settings.station.name == "Room 2"
    assert settings.station.data == tmp_path / "records"
    assert settings.station.hosts == ("station.local",)
    arm, sensor = settings.devices["arm"], settings.devices["sensor"]
    assert (arm.driver, arm.options) == ("serial-encoder", {"url": "/dev/ttyUSB0"})
    assert (sensor.driver, sensor.options) == ("opencv", {"source": 0})
    assert settings.limits == LimitsTable(good_um=30.0, usable_um=LIMITS.usable_um)


def test_an_archive(tmp_path: Path) -> None:
    assert read_settings(write(tmp_path, GOOD)).archive is None
    more = '\n[archive]\nurl = "copies"\nkeep_days = 90\n'
    archive = present(read_settings(write(tmp_path, GOOD + more)).archive)
    assert (archive.url, archive.keep_days, archive.free_gb) == (f"{tmp_path / 'copies'}", 90, None)
    more = '[archive]\nurl = "s3://bucket/room"\naccess_key = "k"\nsecret_file = "secret"\n'
    (tmp_path / "secret").write_text("hidden\n")
    archive = present(read_settings(write(tmp_path, GOOD + more)).archive)
    assert (archive.url, archive.secret()) == ("s3://bucket/room", "hidden")
    (tmp_path / "secret").unlink()
    with pytest.raises(OperationError, match="secret"):
        archive.secret()


def test_a_broker_and_a_thermometer(tmp_path: Path) -> None:
    (tmp_path / "secret").write_text("a word\n")
    more = '[mqtt]\nhost = "broker.local"\nuser = "station"\npassword_file = "secret"\n'
    more += '[temperature]\nfile = "/sys/room"\n'
    named = 'name = "Room 2"\naddress = "http://room2:8000/"\nbackups = "copies"'
    text = GOOD.replace('name = "Room 2"', named)
    settings = read_settings(write(tmp_path, text + more))
    broker = present(settings.mqtt)
    assert (broker.host, broker.port) == ("broker.local", 1883)
    assert (broker.prefix, broker.tls) == ("crenel", False)
    assert broker.password() == "a word"
    assert present(settings.temperature).file == Path("/sys/room")
    assert settings.station.backups == tmp_path / "copies"
    (tmp_path / "secret").unlink()
    with pytest.raises(OperationError, match="secret"):
        read_settings(write(tmp_path, text + more))


def test_only_the_devices_are_needed(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setenv("XDG_DATA_HOME", str(tmp_path / "share"))
    settings = read_settings(write(tmp_path, '[arm]\ndriver="a"\n[sensor]\ndriver="b"\n'))
    assert settings.station.data == tmp_path / "share/crenel/station"
    assert settings.limits == LimitsTable(good_um=LIMITS.good_um, usable_um=LIMITS.usable_um)
    assert settings.verification.model_dump() == DEFAULT_LIMITS.model_dump()
    assert (settings.decision.decision_rule, settings.due) == (GUARDED_95, DUE)


def test_the_decision_rule_and_who_bears_the_uncertainty(tmp_path: Path) -> None:
    chosen = '[decision]\nrule = "expanded-k2"\nbearer = "supplier"\n[arm]'
    settings = read_settings(write(tmp_path, GOOD.replace("[arm]", chosen)))
    assert settings.decision.decision_rule == replace(EXPANDED_K2, bearer="supplier")


@pytest.mark.parametrize(
    ("change", "named"),
    [
        (("[arm]", "[alm]"), "[alm]"),
        (('driver = "opencv"', ""), "driver"),
        (('name = "Room 2"', "name = 2"), "name"),
        (('name = "Room 2"', 'nmae = "Room 2"'), "nmae"),
        (('"station.local"', "5"), "hosts"),
        (('driver = "serial-encoder"', "driver = [1]"), "driver"),
        (("[sensor]", "[sensor"), "station.toml"),
        (("[sensor]", "[extra]\n[sensor]"), "extra"),
        (("good_um = 30", "good_um = -1"), "good_um"),
        (("good_um = 30", "good_um = nan"), "good_um"),
        (("good_um = 30", 'good_um = "30"'), "good_um"),
        (("good_um = 30", "good_um = 500"), "usable_um = 150 is below good_um = 500"),
        (("good_um = 30", "good_mm = 0.03"), "good_mm"),
        (('name = "Room 2"', 'address = "room-2"'), "begin with http:// or https://"),
        (('["station.local"]', '"room-2"'), "it must be a list"),
        (('name = "Room 2"', 'proxies = ["proxy.local"]'), "it is no address"),
        (('name = "Room 2"', 'root_path = "/api"'), "it is no sub-path"),
        (('name = "Room 2"', 'root_path = "crenel"'), "it is no sub-path"),
        (('name = "Room 2"', 'tls_key = "station.toml"'), "tls_key is given without the other"),
        (('data = "records"', "data = 5"), "data = 5: it must be text in quotes"),
        (('data = "records"', 'data = ""'), "it is empty"),
        (("[arm]", '[decision]\nrule = "hopeful"\n[arm]'), "rule = 'hopeful'"),
        (("[arm]", '[decision]\nbearer = "nobody"\n[arm]'), "bearer = 'nobody'"),
        (("[arm]", '[archive]\nurl = "x"\nkeep_days = 0\n[arm]'), "keep_days"),
        (("[arm]", "[archive]\nkeep_days = 9\n[arm]"), "url is missing"),
        (("[arm]", '[archive]\nurl = "s3://b"\naccess_key = "k"\n[arm]'), "without the other"),
        (("[arm]", '[mqtt]\nhost = "h"\nstation = "Room 2"\n[arm]'), "lower-case letters"),
        (("[arm]", '[mqtt]\nhost = "h"\nca_file = "station.toml"\n[arm]'), "no certificates"),
        (("[arm]", '[mqtt]\nhost = "h"\nca_file = "gone"\n[arm]'), "there is no such file"),
    ],
)
def test_what_is_wrong_is_named(tmp_path: Path, change: tuple[str, str], named: str) -> None:
    assert change[0] in GOOD
    line = refusal(write(tmp_path, GOOD.replace(*change, 1))).line
    assert named in line
    assert "station.toml" in line


def test_certificate_and_key_are_beside_the_file(tmp_path: Path) -> None:
    both = 'name = "Room 2"\ntls_certificate = "cert.pem"\ntls_key = "key.pem"'
    file = write(tmp_path, GOOD.replace('name = "Room 2"', both))
    error = refusal(file)
    assert error.code == "settings-tls"
    gone = f"tls_certificate = {str(tmp_path / 'cert.pem')!r}: there is no such file"
    assert gone in error.line
    for name in ("cert.pem", "key.pem"):
        (tmp_path / name).touch()
    assert read_settings(file).station.tls_key == tmp_path / "key.pem"


def test_a_missing_file_is_named(tmp_path: Path) -> None:
    error = refusal(tmp_path / "station.toml")
    assert error.code == "settings-missing"
    assert "crenel demo" in error.line


def test_limits_of_a_verification_and_what_is_due_are_the_stations_own(tmp_path: Path) -> None:
    file = tmp_path / "station.toml"
    devices = '[arm]\ndriver = "a"\n[sensor]\ndriver = "s"\n'
    file.write_text(f"{devices}[verification]\nform = 40\n[due]\nverification_days = 1\n")
    settings = read_settings(file)
    assert (settings.verification.form, settings.verification.rms) == (40, DEFAULT_LIMITS.rms)
    assert settings.due.verification_days == 1
    assert settings.due.calibration_days == DUE.calibration_days
    for wrong in ("[verification]\nform = -1", "[verification]\nfrom = 4", "[due]\ntip_hours = 0"):
        file.write_text(f"{devices}{wrong}\n")
        with pytest.raises(OperationError, match=r"form|from|tip_hours"):
            read_settings(file)


RIGHT = '[sensor.right]\ndriver = "opencv"\nsource = 1\nlabel = "Inner"\n'
TWO = GOOD.replace("[sensor]", "[sensor.left]") + RIGHT


def test_several_sensors_have_tables_with_names(tmp_path: Path) -> None:
    settings = read_settings(write(tmp_path, TWO))
    assert settings.sensor is None
    assert set(settings.devices) == {"arm"}
    assert list(settings.sensors) == ["left", "right"]
    left, right = settings.sensors.values()
    assert (left.driver, left.options) == ("opencv", {"source": 0})
    assert (right.label, right.options) == ("Inner", {"source": 1})


def test_several_sensors_are_triggered_with_delays_of_their_own(tmp_path: Path) -> None:
    table = "[trigger]\nrate_hz = 20.0\ndelay_us = 12.0\ndelays_us = { right = 30.0 }\n"
    trigger = present(read_settings(write(tmp_path, TWO + table)).trigger)
    used = TriggerSettings(trigger.rate_hz, trigger.delay_us, trigger.delays_us)
    assert [used.delay_of_us(name) for name in ("left", "right")] == [12.0, 30.0]


@pytest.mark.parametrize(
    ("text", "code"),
    [
        (TWO.replace("sensor.right", 'sensor."the right one"'), "settings-sensor-name"),
        (TWO + "[trigger]\nrate_hz = 20.0\ndelays_us = { top = 9.0 }\n", "settings-trigger"),
        (TWO + "[trigger]\nrate_hz = 20.0\ndelays_us = { left = -1.0 }\n", "settings-key-invalid"),
        (TWO.replace("sensor.right", "sensors.right"), "settings-key-unknown"),
        (TWO.replace('driver = "opencv"\nsource = 1', "source = 1"), "settings-key-missing"),
    ],
)
def test_odd_tables_of_sensors_are_refused(tmp_path: Path, text: str, code: str) -> None:
    assert refusal(write(tmp_path, text)).code == code


def table(driver: str, label: str = "", **options: Any) -> DeviceTable:
    return DeviceTable(driver=driver, label=label, **options)


@pytest.fixture
def file(tmp_path: Path) -> Path:
    return write(tmp_path, FILE)


def test_changed_and_new_options_leave_every_comment(file: Path) -> None:
    write_device(file, "arm", table(driver="serial-encoder", url="/dev/ttyUSB1"))
    changed = FILE.replace("ttyUSB0", "ttyUSB1")
    assert file.read_text() == changed
    write_device(file, "arm", table("serial-encoder", url="/dev/ttyUSB1", joint_count=6))
    last = 'url = "/dev/ttyUSB1"       # left\n'
    assert file.read_text() == changed.replace(last, f"{last}joint_count = 6\n")


def test_another_driver_has_only_its_own_options(file: Path) -> None:
    write_device(file, "arm", table(driver="bench", label="Old arm", port=3))
    arm = tomllib.loads(file.read_text())["arm"]
    assert arm == {"driver": "bench", "label": "Old arm", "port": 3}
    assert "# stricter than usual\n[limits]" in file.read_text()


def test_a_new_table_is_read_as_it_was_written(file: Path) -> None:
    options = {"exposure_range_us": [100.0, 2e4], "loop": True}
    camera = table("opencv", 'The "left" one', source="rtsp://10.0.0.9/stream", **options)
    write_device(file, "sensor", camera)
    assert file.read_text().startswith(FILE)
    assert read_settings(file).sensor == camera


def test_a_file_is_created_with_its_folder(tmp_path: Path) -> None:
    path = tmp_path / "data" / "station.toml"
    write_device(path, "sensor", table(driver="opencv", source=0))
    assert path.read_text() == '[sensor]\ndriver = "opencv"\nsource = 0\n'
    assert read_settings(path).arm is None
    assert [one.name for one in path.parent.iterdir()] == ["station.toml"]


def test_the_file_before_is_kept(file: Path) -> None:
    write_device(file, "sensor", table(driver="opencv", source=0))
    assert file.with_name("station.toml.backup").read_text() == FILE


def test_a_device_is_taken_out(file: Path) -> None:
    write_device(file, "arm", None)
    assert read_settings(file).devices == {}
    assert "good_um = 30 # agreed with the customer" in file.read_text()


@pytest.mark.parametrize(
    "text", ["[arm\n", 'arm = "serial-encoder"\n[station]\nnam = "x"\n', "[station]\nname = 5\n"]
)
def test_a_file_with_an_error_stays_as_it_is(file: Path, text: str) -> None:
    file.write_text(text)
    with pytest.raises(OperationError) as caught:
        write_device(file, "sensor", table(driver="opencv", source=0))
    assert caught.value.code == "settings-not-valid"
    assert file.read_text() == text
    assert [one.name for one in file.parent.iterdir()] == ["station.toml"]
