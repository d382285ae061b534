"""A station that is killed in the middle of a scan."""

import subprocess
import sys
import time
from pathlib import Path

import pytest

from crenel.formats.recording.decoders import JointRecord, StripeRecord
from crenel.formats.recording.reader import open_recording

pytestmark = [pytest.mark.device, pytest.mark.soak]

ROOT = Path(__file__).resolve().parents[2]
SCAN = """
import sys, time
from pathlib import Path
from crenel.station.bus import Bus
from crenel.station.devices.rig import Rig
from crenel.station.scan.scanner import Scanner
from crenel.station.view3d.scene import Scene
from tests.station.conftest import Bench, ScriptedArm, ScriptedSensor, six_axis_arm, until
from tests.station.test_scanner import calibration

bench, bus, folder = Bench(), Bus(), Path(sys.argv[1])
bench.frame_period_s = 0.05
rig = Rig(bus, lambda: ScriptedArm(bench), lambda: ScriptedSensor(bench), folder)
rig.arm.set_model(six_axis_arm())
rig.start()
scanner = Scanner(bus, rig, Scene(10_000), folder / "scans")
scanner.set_calibration(calibration())
until(lambda: scanner.why_not() is None)
scanner.start("killed")
until(lambda: scanner.state().frames > 10)
print("scanning", flush=True)
time.sleep(60)
"""


def test_a_killed_scan_loses_no_more_than_its_last_second(tmp_path: Path) -> None:
    """The recording is readable up to there, and no half-written cloud takes its name."""
    with subprocess.Popen(
        [sys.executable, "-c", SCAN, str(tmp_path)], cwd=ROOT, stdout=subprocess.PIPE
    ) as process:
        assert process.stdout is not None
        assert process.stdout.readline() == b"scanning\n"
        time.sleep(2.5)
        killed_ns = time.monotonic_ns()
        process.kill()
    (folder,) = (tmp_path / "scans").iterdir()
    recording = open_recording(folder / "scan.mcap")
    records = list(recording.records())
    assert "incomplete" in str(recording.cut)
    for kind in (StripeRecord, JointRecord):
        last_ns = max(record.stamp_ns for record in records if isinstance(record, kind))
        # one second, and one more for a machine that has other things to do
        assert killed_ns - last_ns < 2_000_000_000
    assert not (folder / "cloud.ply").exists()
