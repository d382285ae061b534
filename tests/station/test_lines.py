"""A sensor whose camera finds the laser line itself: lines for scans, pictures for the rest."""

import json
from collections.abc import Iterator
from dataclasses import replace
from pathlib import Path

import cv2
import numpy as np
import pytest

from app.errors import OperationError
from app.formats.clouds.files import read_cloud
from app.formats.recording.decoders import ImageRecord, StripeRecord
from app.formats.recording.reader import open_recording
from app.formats.results.calibration import Calibration, SerialNumbers
from app.formats.settings.scan_settings import ScanSettings
from app.metrology.fitting.plane_sphere import fit_sphere
from app.station.bus import Bus
from app.station.devices.rig import Rig
from app.station.preview.line_picture import draw_line
from app.station.preview.preview import Preview
from app.station.pulses.pulse_pairing import PulsePairing
from app.station.scan.extraction import Extraction
from app.station.scan.scanner import Scanner
from app.station.scan.state import ScanResult
from app.station.view3d.scene import Scene
from app.workflows.reconstruct import reconstruct_cloud
from hardware.interfaces import Delivery, Frame, Line
from hardware.registry import arm_driver
from hardware.simulator.station import SimulatedStation
from tests.station.conftest import until
from tests.station.test_on_simulation import CONFIG, true_calibration

pytestmark = pytest.mark.device

BOTH: frozenset[Delivery] = frozenset({"picture", "line"})


@pytest.fixture(scope="module")
def simulation() -> Iterator[SimulatedStation]:
    with SimulatedStation(replace(CONFIG, delivers=BOTH)) as simulation:
        yield simulation


def start_rig(simulation: SimulatedStation, bus: Bus, folder: Path) -> Rig:
    options = {"url": simulation.arm_url}
    rig = Rig(bus, lambda: arm_driver("serial-encoder", options), simulation.sensor, folder)
    rig.arm.set_model(true_calibration(simulation, folder).arm)
    rig.start()
    until(lambda: rig.arm.fresh and rig.sensor.fresh)
    return rig


@pytest.fixture
def rig(simulation: SimulatedStation, bus: Bus, tmp_path: Path) -> Iterator[Rig]:
    rig = start_rig(simulation, bus, tmp_path)
    yield rig
    rig.stop()
    simulation.clear_faults()


@pytest.fixture
def scanner(simulation: SimulatedStation, rig: Rig, bus: Bus, tmp_path: Path) -> Iterator[Scanner]:
    scene = Scene(point_budget=100_000)
    scanner = Scanner(bus, rig, scene, tmp_path / "scans")
    scanner.set_calibration(true_calibration(simulation, tmp_path))
    until(lambda: scanner.why_not() is None)
    yield scanner
    scanner.close()
    scene.close()


def scan_sphere(scanner: Scanner, simulation: SimulatedStation) -> ScanResult:
    scanner.start("sphere")
    assert simulation.operator.scan_part("sphere")
    result = scanner.stop()
    assert result is not None
    return result


def records_of(result: ScanResult) -> tuple[list[StripeRecord], list[ImageRecord]]:
    records = list(open_recording(result.folder / "scan.mcap").records())
    stripes = [one for one in records if isinstance(one, StripeRecord)]
    return stripes, [one for one in records if isinstance(one, ImageRecord)]


def test_lines_and_pictures_give_the_same_sphere(
    simulation: SimulatedStation, rig: Rig, scanner: Scanner, tmp_path: Path
) -> None:
    """And the recorded lines, rebuilt, give the very points that were saved live."""
    nominal = json.loads(json.dumps(simulation.datasheets()["sphere.nominal.json"]))
    results, fits, sds_mm = [], [], []
    for record_pictures in (False, True):
        scanner.set_settings(ScanSettings(record_pictures=record_pictures))
        result = scan_sphere(scanner, simulation)
        points = read_cloud(result.folder / "cloud.ply").points_mm
        near = np.linalg.norm(points - nominal["centre_mm"], axis=1) < nominal["radius_mm"] + 0.5
        fit = fit_sphere(points[near])
        away_mm = np.linalg.norm(points[near] - fit.centre_mm, axis=1) - fit.radius_mm
        results.append(result)
        fits.append(fit)
        sds_mm.append(1.4826 * np.median(np.abs(away_mm)))
    for fit in fits:
        assert fit.radius_mm == pytest.approx(nominal["radius_mm"], abs=0.03)
        np.testing.assert_allclose(fit.centre_mm, nominal["centre_mm"], atol=0.06)
    np.testing.assert_allclose(fits[0].centre_mm, fits[1].centre_mm, atol=0.05)
    assert sds_mm[0] < 1.5 * sds_mm[1]

    stripes, pictures = records_of(results[0])
    assert len(stripes) == results[0].frames
    assert not pictures
    assert records_of(results[1])[1]
    assert isinstance(rig.sensor.frames.wait(lambda _: True, 240), Frame)

    use = true_calibration(simulation, tmp_path)
    serials = SerialNumbers(arm=use.arm_serial, sensor=use.sensor_serial, object="B-1")
    rebuilt = reconstruct_cloud(
        results[0].folder / "scan.mcap",
        Calibration(use.camera, use.plane, use.T_flange_sensor, "u", serials),
        use.arm,
        tmp_path / "again.ply",
    )
    assert rebuilt.all_frames == results[0].frames
    np.testing.assert_allclose(
        read_cloud(tmp_path / "again.ply").points_mm,
        read_cloud(results[0].folder / "cloud.ply").points_mm,
        atol=1e-6,
    )


def is_line(rig: Rig) -> bool:
    return isinstance(rig.sensor.frames.newest, Line)


def test_captures_and_exposure_get_pictures_while_a_scan_has_lines(
    simulation: SimulatedStation, rig: Rig, scanner: Scanner
) -> None:
    assert simulation.operator.hold_over("block", 0)
    until(lambda: rig.arm.stillness().still)
    scanner.start("lines")
    until(lambda: is_line(rig))
    taken = rig.capture_pair()
    assert taken.laser is not None
    assert taken.ambient.image.shape == taken.laser.image.shape
    until(lambda: is_line(rig))
    assert rig.sensor.auto_exposure() > 0
    until(lambda: is_line(rig))
    scanner.stop()
    until(lambda: not is_line(rig))


def test_a_sensor_that_comes_back_in_a_scan_sends_lines_again(
    simulation: SimulatedStation, rig: Rig, scanner: Scanner
) -> None:
    scanner.start("lines")
    until(lambda: is_line(rig))
    simulation.camera_faults.lost = True
    until(lambda: rig.sensor.info is None)
    rig.sensor.frames.clear()
    simulation.camera_faults.lost = False
    until(lambda: rig.sensor.frames.newest is not None)
    until(lambda: is_line(rig))
    assert scanner.stop() is not None
    until(lambda: not is_line(rig))


def test_the_preview_draws_the_line_that_a_scan_gets(
    simulation: SimulatedStation, rig: Rig, scanner: Scanner, bus: Bus
) -> None:
    assert simulation.operator.hold_over("block", 0)
    preview = Preview(bus, rig.arm, rig.sensor)
    preview.start()
    try:
        with preview.watch():
            until(lambda: preview.latest() is not None)
            scanner.start("lines")
            until(lambda: (latest := preview.latest()) is not None and latest.header.stripe)
            latest = preview.latest()
            assert latest is not None
            assert (latest.header.width_px, latest.header.height_px) == (640, 512)
            picture = cv2.imdecode(np.frombuffer(latest.jpeg, np.uint8), cv2.IMREAD_GRAYSCALE)
            assert picture is not None
            u, v = np.array(latest.header.stripe[len(latest.header.stripe) // 2]).astype(int)
            assert picture[v - 2 : v + 3, u].max() > 60
            assert np.median(picture) < 5
            assert not latest.header.saturated
    finally:
        preview.stop()


def test_a_sensor_of_lines_alone_scans_and_refuses_captures(bus: Bus, tmp_path: Path) -> None:
    with SimulatedStation(replace(CONFIG, delivers=frozenset({"line"}))) as simulation:
        rig = start_rig(simulation, bus, tmp_path)
        scene = Scene(point_budget=1000)
        scanner = Scanner(bus, rig, scene, tmp_path / "scans")
        try:
            scanner.set_calibration(true_calibration(simulation, tmp_path))
            assert simulation.operator.hold_over("block", 0)
            until(lambda: rig.arm.stillness().still)
            for needs_picture in (rig.capture_pair, rig.sensor.auto_exposure):
                with pytest.raises(OperationError) as caught:
                    needs_picture()
                assert caught.value.code == "no-pictures"
            scanner.start("lines")
            until(lambda: scanner.state().points > 1000)
            assert scanner.stop() is not None
        finally:
            scanner.close()
            scene.close()
            rig.stop()


def a_line(**changes: object) -> Line:
    u, v = np.arange(40.0), np.linspace(10.0, 20.0, 40)
    line = Line(1, 2, u, v, np.full(40, 90.0), np.full(40, 0.1), 40, 30, 100.0, True)
    return replace(line, **changes)  # type: ignore[arg-type]


def test_points_in_zones_and_points_that_are_no_numbers_are_left_out() -> None:
    where = np.ones((30, 40), np.bool_)
    where[:, :7] = False
    v = np.linspace(10.0, 20.0, 40)
    v[20], v[21] = np.nan, 30.0
    sigma = np.full(40, 0.1)
    sigma[22] = 0.0
    stripe = Extraction(where=where).line_stripe(a_line(v=v, sigma_px=sigma))
    kept = [column for column in range(7, 40) if column not in (20, 21, 22)]
    np.testing.assert_array_equal(stripe.u, kept)
    np.testing.assert_array_equal(stripe.v, v[kept])
    assert len(Extraction().line_stripe(a_line()).u) == 40


def test_a_line_with_missing_numbers_is_refused() -> None:
    with pytest.raises(OperationError, match="incomplete"):
        Extraction().line_stripe(a_line(sigma_px=np.ones(39)))


def test_an_empty_line_is_dark_and_gives_no_points() -> None:
    none = np.empty(0)
    line = a_line(u=none, v=none, intensity=none, sigma_px=none)
    assert draw_line(line).shape == (30, 40)
    assert not draw_line(line).any()
    assert len(Extraction().line_stripe(line).u) == 0


def test_lines_are_paired_with_their_pulses() -> None:
    pairing, period_ns = PulsePairing(delay_us=20.0), 40_000_000
    times = []
    pairing.restart()
    assert pairing.pair(a_line(pulse=70, mid_exposure_ns=0)) is None
    for pulse in range(1, 6):
        at_ns = 500_000_000 + pulse * period_ns
        pairing.note_pulse(pulse, at_ns)
        paired = pairing.pair(a_line(pulse=70 + pulse, mid_exposure_ns=at_ns + 7_000_000))
        if paired is not None:
            times.append(paired.mid_exposure_ns - at_ns)
    assert times[-1] == 20_000 + 50_000
