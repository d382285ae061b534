"""The operator's settings on a running scan: line, zones, speed, pictures, delay."""

import asyncio
import json
from pathlib import Path

import numpy as np
import pytest

from app.errors import OperationError
from app.formats.clouds.files import read_cloud
from app.formats.recording.decoders import ImageRecord, StripeRecord
from app.formats.recording.reader import EXTRACTION, open_recording
from app.formats.results.calibration import Calibration, SerialNumbers
from app.formats.settings.scan_settings import AUTOMATIC, ScanSettings
from app.station.bus import Bus
from app.station.devices.rig import Rig
from app.station.jobs import Jobs
from app.station.operator_settings import OperatorSettings, PassRecord, SettingsChange
from app.station.preview.preview import Preview
from app.station.scan.scanner import Scanner
from app.workflows.reconstruct import reconstruct_cloud
from tests.formats.test_mask import settings
from tests.station.conftest import HEIGHT, REST_RAD, WIDTH, Bench, until
from tests.station.test_scanner import calibration, scanner, scene

pytestmark = pytest.mark.device

__all__ = ["scanner", "scene"]  # fixtures

LEFT_HALF = (((-2.0, -2.0), (WIDTH / 2, -2.0), (WIDTH / 2, HEIGHT + 2.0), (-2.0, HEIGHT + 2.0)),)


class Kept:
    """Stands where the store does."""

    def __init__(self) -> None:
        self.settings = AUTOMATIC

    def keep(self, new: ScanSettings) -> None:
        self.settings = new


@pytest.fixture
def kept() -> Kept:
    return Kept()


@pytest.fixture
def operator(bus: Bus, rig: Rig, scanner: Scanner, kept: Kept) -> OperatorSettings:
    preview = Preview(bus, rig.arm, rig.sensor)
    return OperatorSettings(bus, rig, scanner, preview, AUTOMATIC, lambda new: kept.keep(new))


def stripes(path: Path) -> list[StripeRecord]:
    return [record for record in open_recording(path).records() if isinstance(record, StripeRecord)]


def test_settings_reach_a_running_scan_and_its_recording(
    scanner: Scanner, operator: OperatorSettings, kept: Kept, tmp_path: Path
) -> None:
    scan_id = scanner.start("zones")
    until(lambda: scanner.state().points > 1000)
    operator.change(SettingsChange(zones=LEFT_HALF))
    frames = scanner.state().frames
    until(lambda: scanner.state().frames > frames + 60)
    operator.change(SettingsChange(threshold=250.0, smoothing_px=2.0))
    frames = scanner.state().frames
    until(lambda: scanner.state().frames > frames + 60)
    scanner.stop()
    seen = stripes(tmp_path / "scans" / scan_id / "scan.mcap")
    assert seen[0].stripe.u.min() < WIDTH / 4
    middle = [one.stripe.u.min() for one in seen if 0 < len(one.stripe.u) < 0.6 * WIDTH]
    assert len(middle) >= 30
    assert min(middle) > WIDTH / 2
    assert len(seen[-1].stripe.u) == 0
    recording = open_recording(tmp_path / "scans" / scan_id / "scan.mcap")
    list(recording.records())
    reported = json.loads(recording.station[EXTRACTION])
    assert reported["threshold"] == 250.0
    assert recording.smoothing_px == reported["smoothing_px"] == 2.0
    assert len(reported["mask"]["zones"][0]) == 4
    assert recording.station["arm_serial"] == "A-1"
    assert kept.settings.threshold == 250.0


@pytest.mark.parametrize(
    ("field", "value"),
    [
        ("threshold", 0.0),
        ("threshold", "12"),
        ("threshold", 1e6),
        ("min_width_px", 0.1),
        ("choice", "second"),
        ("smoothing_px", -1.0),
        ("smoothing_px", 51.0),
        ("exposure_us", -5.0),
        ("blur_limit_mm", float("nan")),
        ("record_pictures", 1),
        ("record_picture", True),
    ],
)
def test_values_out_of_range_change_nothing(
    operator: OperatorSettings, kept: Kept, field: str, value: object
) -> None:
    before = operator.view()
    with pytest.raises(OperationError, match=field):
        operator.change(SettingsChange.model_validate({field: value}))
    assert operator.view() == before
    assert kept.settings == AUTOMATIC


def test_what_is_not_given_stays(operator: OperatorSettings, kept: Kept) -> None:
    operator.change(SettingsChange(threshold=20.0, choice="first", zones=LEFT_HALF))
    operator.change(SettingsChange(threshold=None, blur_limit_mm=0.5))
    assert kept.settings.mask is not None
    assert kept.settings.mask.zones == operator.view().zones == LEFT_HALF
    chosen = ScanSettings(choice="first", blur_limit_mm=0.5, mask=kept.settings.mask)
    assert kept.settings == chosen
    operator.change(SettingsChange(zones=()))
    assert kept.settings == ScanSettings(choice="first", blur_limit_mm=0.5)


def test_zones_that_cannot_be_meant_change_nothing(operator: OperatorSettings) -> None:
    with pytest.raises(OperationError, match="no area"):
        operator.change(SettingsChange(zones=(((1.0, 1.0), (5.0, 5.0), (9.0, 9.0)),)))
    assert operator.view().zones == ()


def test_the_exposure_is_set_and_found_from_the_line(
    operator: OperatorSettings, bench: Bench, rig: Rig, kept: Kept
) -> None:
    operator.change(SettingsChange(exposure_us=2500.0))
    assert bench.exposure_us == 2500.0
    with pytest.raises(OperationError, match="the laser is off"):
        operator.expose_by_the_line()
    rig.sensor.set_laser(True)
    # the line is a hundredth of the picture, and grows with the exposure
    bench.line_level = 100 / 2500
    operator.expose_by_the_line()
    assert kept.settings.exposure_us == pytest.approx(0.7 * 255 / 0.04, rel=0.15)
    assert operator.view().exposure_us == kept.settings.exposure_us
    bench.picture = np.full((HEIGHT, WIDTH), 3, np.uint8)
    held = bench.exposure_us
    with pytest.raises(OperationError, match="no laser line is visible"):
        operator.expose_by_the_line()
    assert bench.exposure_us == held
    rig.sensor.set_laser(False)


def test_too_fast_is_said_while_it_lasts_and_counted(scanner: Scanner, bench: Bench) -> None:
    bench.joints_at = lambda seconds: REST_RAD + 0.2 * np.sin(6 * seconds)
    scanner.start("fast")
    until(lambda: any("Too fast" in str(one.text) for one in scanner.state().findings))
    state = scanner.state()
    assert state.blur_mm is None or state.blur_mm > 0
    scanner.stop()
    ended = scanner.state()
    assert ended.frames_too_fast > 0
    assert any("taken too fast" in str(one.text) for one in ended.findings)
    assert ended.blur_mm is None


def test_standing_still_is_said_and_a_limit_of_its_own_holds(
    scanner: Scanner, operator: OperatorSettings
) -> None:
    operator.change(SettingsChange(blur_limit_mm=50.0))
    scanner.start("still")
    until(lambda: any("Standing still" in str(one.text) for one in scanner.state().findings))
    state = scanner.state()
    assert state.blur_limit_mm == 50.0
    assert state.frames_too_fast == 0
    assert state.step_mm is not None
    assert state.step_mm < 0.05
    scanner.stop()


def test_pictures_are_recorded_beside_their_stripes(
    scanner: Scanner, operator: OperatorSettings, tmp_path: Path
) -> None:
    operator.change(SettingsChange(record_pictures=True))
    scan_id = scanner.start("pictures")
    until(lambda: scanner.state().pictures >= 10)
    result = scanner.stop()
    folder = tmp_path / "scans" / scan_id
    records = list(open_recording(folder / "scan.mcap").records())
    pictures = [record for record in records if isinstance(record, ImageRecord)]
    assert len(pictures) == scanner.state().pictures
    assert pictures[0].picture().shape == (HEIGHT, WIDTH)
    stamps = {record.stamp_ns for record in records if isinstance(record, StripeRecord)}
    assert {picture.stamp_ns for picture in pictures} <= stamps
    # beside its stripe a picture gives no points a second time
    use = calibration()
    document = Calibration(
        use.camera, use.plane, use.T_flange_sensor, "u", SerialNumbers(arm="A-1", sensor="S-1")
    )
    rebuilt = reconstruct_cloud(folder / "scan.mcap", document, use.arm, tmp_path / "again.ply")
    assert result is not None
    assert rebuilt.points == result.points


def test_the_delay_of_the_settings_is_in_cloud_and_recording(
    scanner: Scanner, bench: Bench, tmp_path: Path
) -> None:
    bench.joints_at = lambda seconds: REST_RAD + 0.1 * np.sin(2 * seconds)
    scanner.set_settings(ScanSettings(sync=settings().sync))
    scan_id = scanner.start("late")
    until(lambda: scanner.state().frames >= 30)
    scanner.stop()
    folder = tmp_path / "scans" / scan_id
    use = calibration()
    document = Calibration(
        use.camera, use.plane, use.T_flange_sensor, "u", SerialNumbers(arm="A-1", sensor="S-1")
    )
    live = read_cloud(folder / "cloud.ply").points_mm
    reconstruct_cloud(folder / "scan.mcap", document, use.arm, tmp_path / "again.ply")
    np.testing.assert_allclose(read_cloud(tmp_path / "again.ply").points_mm, live, atol=1e-6)
    reconstruct_cloud(folder / "scan.mcap", document, use.arm, tmp_path / "raw.ply", delay_ns=0)
    raw = read_cloud(tmp_path / "raw.ply").points_mm
    assert np.abs(raw[: len(live)] - live[: len(raw)]).max() > 0.1


def test_a_delay_that_is_applied_already_stays(
    bus: Bus, rig: Rig, scanner: Scanner, kept: Kept
) -> None:
    late = ScanSettings(sync=settings().sync)
    operator = OperatorSettings(
        bus, rig, scanner, Preview(bus, rig.arm, rig.sensor), late, lambda new: kept.keep(new)
    )
    operator.use_delay(True)
    assert operator.view().delay == late.sync
    assert operator.view().delay_applied
    operator.use_delay(False)
    assert operator.view().delay is None
    assert kept.settings.sync is None


def test_a_delay_that_cannot_be_found_is_said(
    operator: OperatorSettings, bus: Bus, tmp_path: Path
) -> None:
    with pytest.raises(OperationError, match="No delay has been determined"):
        operator.use_delay(True)
    nowhere = tmp_path / "nothing"

    async def scenario() -> str:
        bus.attach(asyncio.get_running_loop())
        with bus.subscribe(without={"devices"}) as reader:
            nothing = PassRecord("none", nowhere, nowhere, nowhere)
            operator.find_delay(Jobs(bus), lambda: nothing)
            assert operator.view().finding_delay
            while not (events := (await reader.next()).events):
                continue
        return str(events[0].text)

    assert "nothing: there is no such file" in asyncio.run(scenario())
    assert not operator.view().finding_delay
    assert operator.view().delay is None


def test_what_the_disk_does_not_keep_is_not_used(
    operator: OperatorSettings, kept: Kept, scanner: Scanner, monkeypatch: pytest.MonkeyPatch
) -> None:
    def full(_: ScanSettings) -> None:
        raise OperationError("disk-full", "scan_settings.json", "the disk is full")

    monkeypatch.setattr(kept, "keep", full)
    with pytest.raises(OperationError, match="the disk is full"):
        operator.change(SettingsChange(threshold=200.0))
    assert operator.view().threshold is None
    scanner.start("as before")
    until(lambda: scanner.state().points > 1000)
    scanner.stop()
