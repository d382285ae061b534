"""The scripts of ``docs/examples`` run as a reader runs them, and print what they promise."""

import os
import re
import subprocess
import sys
from pathlib import Path

import pytest

from crenel_hardware.registry import arm_drivers, sensor_drivers
from tests.sources import ROOT

pytestmark = pytest.mark.device

STARTED_MODULES = ("docs.examples",)
EXAMPLES = ROOT / "docs/examples"


OTHERS = ("app", "hardware", "frontend", "docs")
"""Names of packages that somebody's own project may have."""


def run_example(name: str, project: Path) -> str:
    """What a script prints in somebody's own project; it ends with status 0 and without errors."""
    for other in OTHERS:
        (project / other).mkdir()
        (project / other / "__init__.py").touch()
    done = subprocess.run(
        [sys.executable, str(EXAMPLES / name)],
        cwd=project,
        env=os.environ | {"PYTHONPATH": os.pathsep.join(map(str, (project, ROOT)))},
        capture_output=True,
        text=True,
        timeout=240,
    )
    assert (done.returncode, done.stderr) == (0, ""), done.stdout + done.stderr
    return done.stdout


def number(text: str, label: str) -> float:
    """The number after a label at the start of a line."""
    (found,) = re.findall(rf"^{label}: ([\d.]+)", text, re.MULTILINE)
    return float(found)


def test_every_script_is_run_here_and_linked() -> None:
    source, index = Path(__file__).read_text("utf-8"), (ROOT / "docs/README.md").read_text("utf-8")
    scripts = sorted(path.name for path in EXAMPLES.glob("*.py"))
    assert len(scripts) >= 4
    for name in scripts:
        assert f'run_example("{name}", ' in source, name
        assert f"(examples/{name})" in index, name


def test_a_session_is_calibrated(tmp_path: Path) -> None:
    text = run_example("calibrate_session.py", tmp_path)
    assert "session: arm.json, images, images.csv, object.json, probing.csv, sensor.json" in text
    assert "poses used: 4 of 4\nverdict: " in text
    claimed_um = number(text, "standard uncertainty of a point")
    parts = [float(value) for value in re.findall(r"^  [a-z ]+: ([\d.]+) µm$", text, re.MULTILINE)]
    assert len(parts) >= 6
    assert abs(sum(part**2 for part in parts) ** 0.5 - claimed_um) < 0.05 * claimed_um
    assert claimed_um < 20
    assert number(text, "true error of a point") < 3 * claimed_um


def test_a_stripe_is_extracted(tmp_path: Path) -> None:
    text = run_example("extract_stripe.py", tmp_path)
    assert "image: 640 x 512 px, uint8" in text
    assert number(text, "points") > 600
    assert len(re.findall(r"^  u +\d+  v +[\d.]+  intensity", text, re.MULTILINE)) == 5
    claimed_px = number(text, "standard deviation by the fits")
    assert 0.01 < claimed_px < 0.2
    assert 0.7 < number(text, "true error") / claimed_px < 1.4
    assert "all with u < 320: True" in text


def test_a_recording_is_reconstructed(tmp_path: Path) -> None:
    text = run_example("reconstruct_recording.py", tmp_path)
    assert "warning" not in text
    assert "frames: 41 of 41" in text
    assert number(text, "points") > 5000
    assert abs(number(text, "radius") - 12.7) < 0.03
    assert number(text, "distance of the points from the sphere") < 30


def test_a_driver_package_is_found_by_name_and_meets_the_conformance_suite(tmp_path: Path) -> None:
    text = run_example("write_a_driver.py", tmp_path)
    arms, sensors = {*arm_drivers()}, {*sensor_drivers()}
    assert f"arm drivers: {', '.join(sorted(arms | {'my-arm'}))}\n" in text
    assert f"sensor drivers: {', '.join(sorted(sensors | {'my-camera'}))}\n" in text
    assert "arm: ArmInfo(name='Vendor arm', serial_number='VA-17', joint_count=6" in text
    assert "joints: [0.175, 0.349, 0.524" in text
    assert "frame: (64, 96) uint8, laser on: True" in text
    assert "the driver has no option 'adress'. Did you mean address?" in text
    suite = (ROOT / "tests/hardware/conformance.py").read_text("utf-8")
    tests = suite.count("    def test_")
    # this arm sends all the time; this camera has no counter, trigger, control or lines
    skipped = 8
    assert f"\n{tests - skipped} passed, {skipped} skipped in " in text
