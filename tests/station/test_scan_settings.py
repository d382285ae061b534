"""The operator's settings on a running scan: line, zones, speed, pictures, delay."""

import asyncio
import json
import time
from pathlib import Path

import numpy as np
import pytest

from crenel.errors import OperationError
from crenel.formats.clouds.files import read_cloud
from crenel.formats.recording.decoders import ImageRecord, StripeRecord
from crenel.formats.recording.reader import EXTRACTION, open_recording
from crenel.formats.settings.scan_settings import AUTOMATIC, ScanSettings
from crenel.metrology.sensor.line_thinning import LINES_AT_A_PLACE
from crenel.metrology.time_delay.course import NO_DELAY
from crenel.station.bus import Bus
from crenel.station.devices.rig import Rig
from crenel.station.jobs import Jobs
from crenel.station.operator_settings import OperatorSettings, PassRecord, SettingsChange
from crenel.station.preview.preview import Preview
from crenel.station.scan.scanner import Scanner
from crenel.workflows.reconstruct import reconstruct_cloud
from tests.formats.test_mask import settings
from tests.station.conftest import HEIGHT, REST_RAD, WIDTH, Bench, until
from tests.station.simulated import check_rebuilt, end_scan, file_calibration, recorded
from tests.station.test_scanner import calibration, scanner, scene

pytestmark = pytest.mark.device
__all__ = ["scanner", "scene"]  # fixtures
LEFT_HALF = (((-2.0, -2.0), (WIDTH / 2, -2.0), (WIDTH / 2, HEIGHT + 2.0), (-2.0, HEIGHT + 2.0)),)


class Operator(OperatorSettings):
    """Keeps the settings in place of the store."""

    def __init__(
        self, bus: Bus, rig: Rig, scanner: Scanner, settings: ScanSettings = AUTOMATIC
    ) -> None:
        preview = Preview(bus, rig.arm, rig.sensor)
        super().__init__(bus, rig, scanner, preview, settings, lambda new: self.keep(new))
        self.scanner, self.kept = scanner, settings

    def keep(self, new: ScanSettings) -> None:
        self.kept = new


@pytest.fixture
def operator(bus: Bus, rig: Rig, scanner: Scanner) -> Operator:
    return Operator(bus, rig, scanner)


def test_settings_reach_a_running_scan_and_its_recording(operator: Operator) -> None:
    operator.scanner.start("zones")
    until(lambda: operator.scanner.state().points > 1000)
    operator.change(SettingsChange(zones=LEFT_HALF))
    frames = operator.scanner.state().frames
    until(lambda: operator.scanner.state().frames > frames + 60)
    operator.change(SettingsChange(threshold=250.0, smoothing_px=2.0))
    frames = operator.scanner.state().frames
    until(lambda: operator.scanner.state().frames > frames + 60)
    folder = end_scan(operator.scanner).folder
    seen = recorded(folder, StripeRecord)
    assert seen[0].stripe.u.min() < WIDTH / 4
    middle = [one.stripe.u.min() for one in seen if 0 < len(one.stripe.u) < 0.6 * WIDTH]
    assert len(middle) >= 30
    assert min(middle) > WIDTH / 2
    assert len(seen[-1].stripe.u) == 0
    recording = open_recording(folder / "scan.mcap")
    list(recording.records())
    logged_ns = np.array([recording.first_ns, recording.last_ns])
    assert (np.abs(logged_ns - time.time_ns()) < 600e9).all()  # by the wall clock
    reported = json.loads(recording.station[EXTRACTION])
    assert reported["threshold"] == 250.0
    assert recording.smoothing_px == reported["smoothing_px"] == 2.0
    assert len(reported["mask"]["zones"][0]) == 4
    assert recording.station["arm_serial"] == "A-1"
    assert operator.kept.threshold == 250.0


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
def test_values_out_of_range_change_nothing(operator: Operator, field: str, value: object) -> None:
    before = operator.view()
    with pytest.raises(OperationError, match=field):
        operator.change(SettingsChange.model_validate({field: value}))
    assert operator.view() == before
    assert operator.kept == AUTOMATIC


def test_what_is_not_given_stays(operator: Operator) -> None:
    operator.change(SettingsChange(threshold=20.0, choice="first", zones=LEFT_HALF))
    operator.change(SettingsChange(threshold=None, blur_limit_mm=0.5))
    assert operator.kept.mask is not None
    assert operator.kept.mask.zones == operator.view().zones == LEFT_HALF
    chosen = ScanSettings(choice="first", blur_limit_mm=0.5, mask=operator.kept.mask)
    assert operator.kept == chosen
    operator.change(SettingsChange(zones=()))
    assert operator.kept == ScanSettings(choice="first", blur_limit_mm=0.5)


def test_zones_that_cannot_be_meant_change_nothing(operator: Operator) -> None:
    with pytest.raises(OperationError, match="no area"):
        operator.change(SettingsChange(zones=(((1.0, 1.0), (5.0, 5.0), (9.0, 9.0)),)))
    assert operator.view().zones == ()


def test_the_exposure_is_set_and_found_by_line(operator: Operator, bench: Bench, rig: Rig) -> None:
    operator.change(SettingsChange(exposure_us=2500.0))
    assert bench.exposure_us == 2500.0
    with pytest.raises(OperationError, match="the laser is off"):
        operator.expose_by_the_line()
    rig.sensor.set_laser(True)
    # the line is a hundredth of the picture, and grows with the exposure
    bench.line_level = 100 / 2500
    operator.expose_by_the_line()
    assert operator.kept.exposure_us == pytest.approx(0.7 * 255 / 0.04, rel=0.15)
    assert operator.view().exposure_us == operator.kept.exposure_us
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


def test_a_line_that_stands_still_is_thinned_and_said(operator: Operator, bench: Bench) -> None:
    """By the same rule while scanning and from the recording; a limit of its own holds."""
    operator.change(SettingsChange(blur_limit_mm=50.0))
    scanner = operator.scanner
    scanner.start("still")
    until(lambda: scanner.state().frames_still >= 20)
    state = scanner.state()
    assert 0.9 < state.points / (LINES_AT_A_PLACE * WIDTH) <= 1
    assert "move-sensor-or-stop-scan" in str([one.remedy for one in state.findings])
    assert state.blur_limit_mm == 50.0
    assert state.frames_too_fast == 0
    assert state.step_mm is not None
    assert state.step_mm < 0.05
    bench.joints_at = lambda seconds: REST_RAD + 0.05 * np.sin(seconds)
    until(lambda: scanner.state().points > 3 * LINES_AT_A_PLACE * WIDTH)
    assert "move-sensor-or-stop-scan" not in str([one.remedy for one in scanner.state().findings])
    result = end_scan(scanner)
    use = calibration()
    rebuilt = check_rebuilt(result.folder, file_calibration(use), use.arm)
    assert rebuilt.frames_still == scanner.state().frames_still
    assert "still-lines-left-out" in str([*rebuilt.warnings, *scanner.state().findings])


def test_pictures_are_recorded_beside_their_stripes(operator: Operator) -> None:
    operator.change(SettingsChange(record_pictures=True))
    operator.scanner.start("pictures")
    until(lambda: operator.scanner.state().pictures >= 10)
    result = end_scan(operator.scanner)
    folder = result.folder
    pictures = recorded(folder, ImageRecord)
    assert len(pictures) == operator.scanner.state().pictures
    assert pictures[0].picture().shape == (HEIGHT, WIDTH)
    stamps = {record.stamp_ns for record in recorded(folder, StripeRecord)}
    assert {picture.stamp_ns for picture in pictures} <= stamps
    # beside its stripe a picture gives no points a second time
    rebuilt = check_rebuilt(folder, file_calibration(calibration()), calibration().arm)
    assert rebuilt.points == result.points


def test_a_delay_is_in_cloud_and_recording(scanner: Scanner, bench: Bench, tmp_path: Path) -> None:
    bench.joints_at = lambda seconds: REST_RAD + 0.1 * np.sin(2 * seconds)
    scanner.set_settings(ScanSettings(sync=settings().sync))
    scanner.start("late")
    until(lambda: scanner.state().frames >= 30)
    folder = end_scan(scanner).folder
    document, arm = file_calibration(calibration()), calibration().arm
    check_rebuilt(folder, document, arm)
    live = read_cloud(folder / "cloud.ply").points_mm
    reconstruct_cloud(folder / "scan.mcap", document, arm, tmp_path / "raw.ply", delay=NO_DELAY)
    raw = read_cloud(tmp_path / "raw.ply").points_mm
    assert np.abs(raw[: len(live)] - live[: len(raw)]).max() > 0.1


def test_a_delay_that_is_applied_already_stays(bus: Bus, rig: Rig, scanner: Scanner) -> None:
    late = ScanSettings(sync=settings().sync)
    operator = Operator(bus, rig, scanner, late)
    operator.use_delay(True)
    assert operator.view().delay == late.sync
    assert operator.view().delay_applied
    operator.use_delay(False)
    assert operator.view().delay is None
    assert operator.kept.sync is None


def test_a_delay_that_cannot_be_found_is_said(operator: Operator, bus: Bus, tmp_path: Path) -> None:
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


def test_what_is_not_kept_is_not_used(operator: Operator, monkeypatch: pytest.MonkeyPatch) -> None:
    def full(_: ScanSettings) -> None:
        raise OperationError("disk-full", "scan_settings.json", "the disk is full")

    monkeypatch.setattr(operator, "keep", full)
    with pytest.raises(OperationError, match="the disk is full"):
        operator.change(SettingsChange(threshold=200.0))
    assert operator.view().threshold is None
    operator.scanner.start("as before")
    until(lambda: operator.scanner.state().points > 1000)
    operator.scanner.stop()
