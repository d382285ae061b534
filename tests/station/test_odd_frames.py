"""A sensor that sends other pictures than it was calibrated with, while a scan runs."""

from pathlib import Path

import numpy as np
import pytest

from app.formats.recording.decoders import StripeRecord
from app.formats.recording.reader import open_recording
from app.station.devices.rig import Rig
from app.station.scan.scanner import Scanner
from tests.station.conftest import HEIGHT, WIDTH, Bench, until
from tests.station.test_scanner import scanner, scene

pytestmark = pytest.mark.device

__all__ = ["scanner", "scene"]  # fixtures


@pytest.mark.parametrize(
    ("picture", "words"),
    [
        (np.zeros((HEIGHT // 2, WIDTH), np.uint8), "pictures of 320 × 120 pixels"),
        (np.zeros((HEIGHT, WIDTH), np.float32), "grey pictures of 8 to 16 bits"),
        (np.zeros((HEIGHT, WIDTH, 3), np.uint8), "pictures of 3 × 320 × 240"),
    ],
)
def test_odd_pictures_end_the_scan_with_a_reason_and_the_station_lives(
    scanner: Scanner, bench: Bench, rig: Rig, tmp_path: Path, picture: np.ndarray, words: str
) -> None:
    scan_id = scanner.start("odd")
    until(lambda: scanner.state().points > 1000)
    bench.picture = picture
    until(lambda: scanner.state().state == "idle")
    (finding,) = [one for one in scanner.state().findings if one.quality == "bad"]
    assert words in str(finding.text)
    recording = open_recording(tmp_path / "scans" / scan_id / "scan.mcap")
    records = [one for one in recording.records() if isinstance(one, StripeRecord)]
    assert recording.cut == ""
    assert {(one.width_px, one.height_px) for one in records} == {(WIDTH, HEIGHT)}
    bench.picture = None
    assert rig.sensor.fresh
    scanner.start("again")
    until(lambda: scanner.state().points > 1000)
    assert scanner.stop() is not None


@pytest.mark.parametrize("level", [0, 255])
def test_dark_and_bright_pictures_give_no_points_and_say_so(
    scanner: Scanner, bench: Bench, level: int
) -> None:
    scanner.start("blind")
    bench.picture = np.full((HEIGHT, WIDTH), level, np.uint8)
    until(lambda: any("No laser line" in str(one.text) for one in scanner.state().findings))
    points = scanner.state().points
    bench.picture = None
    until(lambda: scanner.state().points > points)
    assert scanner.stop() is not None
    assert not any(one.quality == "bad" for one in scanner.state().findings)
