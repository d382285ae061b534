"""A sensor whose camera finds the laser line itself: lines for scans, pictures for the rest."""

from dataclasses import replace
from pathlib import Path

import cv2
import numpy as np
import pytest

from crenel.errors import OperationError
from crenel.formats.recording.decoders import ImageRecord, StripeRecord
from crenel.formats.settings.scan_settings import ScanSettings
from crenel.station.bus import Bus
from crenel.station.devices.rig import Rig
from crenel.station.preview.line_picture import draw_line
from crenel.station.preview.preview import Preview
from crenel.station.pulses.pulse_pairing import PulsePairing
from crenel.station.scan.extraction import Extraction
from crenel_hardware.interfaces import Delivery, Frame, Line
from crenel_hardware.simulator.station import SimulatedStation
from tests.present import present
from tests.refusals import refused
from tests.station.conftest import until
from tests.station.simulated import (
    USUAL,
    Station,
    check_rebuilt,
    check_sphere,
    file_calibration,
    recorded,
    running_station,
    station,
)

pytestmark = pytest.mark.device
__all__ = ["station"]  # a fixture
BOTH: frozenset[Delivery] = frozenset({"picture", "line"})
CONFIG = replace(USUAL, delivers=BOTH)


def test_lines_and_pictures_give_the_same_sphere(station: Station) -> None:
    """And the recorded lines, rebuilt, give the very points that were saved live."""
    results, fits, sds_mm = [], [], []
    for record_pictures in (False, True):
        station.scanner.set_settings(ScanSettings(record_pictures=record_pictures))
        results.append(station.scan("sphere"))
        fit, points = check_sphere(station.simulation, results[-1].folder / "cloud.ply")
        away_mm = np.linalg.norm(points - fit.centre_mm, axis=1) - fit.radius_mm
        fits.append(fit)
        sds_mm.append(1.4826 * np.median(np.abs(away_mm)))
    np.testing.assert_allclose(fits[0].centre_mm, fits[1].centre_mm, atol=0.05)
    assert sds_mm[0] < 1.5 * sds_mm[1]

    lines_alone, with_pictures = (result.folder for result in results)
    assert len(recorded(lines_alone, StripeRecord)) == results[0].frames
    assert not recorded(lines_alone, ImageRecord)
    assert recorded(with_pictures, ImageRecord)
    assert isinstance(station.rig.sensor.frames.wait(lambda _: True, 240), Frame)

    use = station.calibration
    rebuilt = check_rebuilt(lines_alone, file_calibration(use), use.arm)
    assert rebuilt.all_frames == results[0].frames


def is_line(rig: Rig) -> bool:
    return isinstance(rig.sensor.frames.newest, Line)


def test_captures_and_exposure_get_pictures_while_a_scan_has_lines(station: Station) -> None:
    station.hold_over_block()
    until(lambda: station.rig.arm.stillness().still)
    station.scanner.start("lines")
    until(lambda: is_line(station.rig))
    taken = station.rig.capture_pair()
    assert taken.ambient.image.shape == present(taken.laser).image.shape
    until(lambda: is_line(station.rig))
    assert station.rig.sensor.auto_exposure() > 0
    until(lambda: is_line(station.rig))
    station.scanner.stop()
    until(lambda: not is_line(station.rig))


def test_a_sensor_that_comes_back_in_a_scan_sends_lines_again(station: Station) -> None:
    station.scanner.start("lines")
    until(lambda: is_line(station.rig))
    station.simulation.camera_faults.lost = True
    until(lambda: station.rig.sensor.info is None)
    station.rig.sensor.frames.clear()
    station.simulation.camera_faults.lost = False
    until(lambda: station.rig.sensor.frames.newest is not None)
    until(lambda: is_line(station.rig))
    assert station.scanner.stop() is not None
    until(lambda: not is_line(station.rig))


def test_the_preview_draws_the_line_that_a_scan_gets(station: Station, bus: Bus) -> None:
    station.hold_over_block()
    preview = Preview(bus, station.rig.arm, station.rig.sensor)
    preview.start()
    try:
        with preview.watch():
            until(lambda: preview.latest() is not None)
            station.scanner.start("lines")
            until(lambda: (latest := preview.latest()) is not None and latest.header.stripe)
            latest = present(preview.latest())
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
    with (
        SimulatedStation(replace(USUAL, delivers=frozenset({"line"}))) as simulation,
        running_station(simulation, bus, tmp_path) as station,
    ):
        station.hold_over_block()
        until(lambda: station.rig.arm.stillness().still)
        for needs_picture in (station.rig.capture_pair, station.rig.sensor.auto_exposure):
            with refused("no-pictures"):
                needs_picture()
        station.scanner.start("lines")
        until(lambda: station.scanner.state().points > 1000)
        assert station.scanner.stop() is not None


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
