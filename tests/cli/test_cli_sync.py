"""The delay between arm and camera on the command line."""

import json
from pathlib import Path

import numpy as np
import pytest

from app.formats.clouds.files import read_cloud
from app.formats.recording.reader import ARM_DELAY, ARM_DELAY_AT, ARM_DRIFT
from app.formats.recording.writer import RecordingWriter
from app.metrology.arm.kinematics import flange_pose
from app.metrology.fitting.plane_sphere import fit_plane
from app.metrology.sensor.camera import project
from app.metrology.stripe import Stripe
from app.metrology.transforms import Floats
from tests.cli.test_cli import crenel, done, names_in, printed, refused
from tests.datasheets import write_arm
from tests.formats.builders import ARM, HEIGHT, POSE_DEG, WIDTH, little_calibration
from tests.formats.test_documents import calibration_file
from tests.workflows.test_reconstruct import MS, NAMES

pytestmark = pytest.mark.slow

DELAY_MS = 12.0


def q_of(seconds: float) -> Floats:
    """Of a manual pass over a plate in waves."""
    waves = [0.012 * np.sin(5 * seconds), 0.05 * np.sin(6 * seconds), 0.02 * np.sin(1.3 * seconds)]
    waves += [0.01 * np.sin(2 * seconds), 0.0, 0.0]
    return np.asarray(np.deg2rad(POSE_DEG) + np.array(waves))


def pass_over_a_plate(
    path: Path, station: dict[str, str] | None = None, back_ms: float = 0.0
) -> None:
    """Frames of a plane that stands across the light plane; the arm's stamps late, and its clock
    set back in the middle."""
    use, rng = little_calibration(), np.random.default_rng(3)
    there = flange_pose(ARM, q_of(0.0)) @ use.T_flange_sensor
    normal = there[:3, :3] @ np.array([0.0, 0.9, 0.43589])
    offset = float(normal @ (there @ [0.0, 1.5, 0.0, 1.0])[:3])
    with RecordingWriter(path, NAMES, station) as writer:
        for ms in range(0, 5200, 2):
            late_ms = DELAY_MS - back_ms * (ms > 2600)
            writer.joints(round((ms + late_ms) * MS), q_of(ms / 1e3) + 1e-6 * rng.normal(size=6))
        for ms in range(60, 5100, 40):
            T = flange_pose(ARM, q_of(ms / 1e3)) @ use.T_flange_sensor
            nx, ny, _ = T[:3, :3].T @ normal
            x = np.linspace(-12, 12, 60)
            y = (offset - normal @ T[:3, 3] - nx * x) / ny
            uv = project(use.camera, np.column_stack([x, y, np.zeros(60)]))
            v = uv[:, 1] + 0.02 * rng.normal(size=60)
            stripe = Stripe(uv[:, 0], v, np.full(60, 99.0), np.full(60, 0.02))
            writer.stripe(ms * MS, stripe, WIDTH, HEIGHT)


@pytest.fixture
def folder(tmp_path: Path) -> Path:
    pass_over_a_plate(tmp_path / "scan.mcap")
    calibration_file().write(tmp_path / "calibration.json")
    write_arm(tmp_path / "arm.json", ARM)
    return tmp_path


def given(folder: Path) -> tuple[str | Path, ...]:
    return ("--calibration", folder / "calibration.json", "--arm", folder / "arm.json")


def rms_um(folder: Path, *more: str | Path, scan: str = "scan.mcap") -> float:
    cloud = folder / "cloud.ply"
    done("reconstruct", folder / scan, *given(folder), "-o", cloud, *more)
    return 1e3 * fit_plane(read_cloud(cloud).points_mm).rms_mm


def test_the_delay_is_found_and_a_rebuild_takes_it_out(folder: Path) -> None:
    output = folder / "sync.json"
    reported = printed("sync", folder / "scan.mcap", *given(folder), "-o", output)
    uncertainty_ms = reported["standard_uncertainty_ms"]
    assert reported["delay_ms"] == pytest.approx(DELAY_MS, abs=4 * uncertainty_ms)
    assert uncertainty_ms < 0.2
    assert json.loads(output.read_text())["delay_ms"] == reported["delay_ms"]
    without, found = rms_um(folder), rms_um(folder, "--sync", output)
    assert found < 30 < 80 < without
    assert rms_um(folder, "--delay-ms", str(DELAY_MS)) == pytest.approx(found, rel=0.05)
    assert without == pytest.approx(reported["rms_without_um"], rel=0.1)


def test_a_clock_that_was_set_back_is_named_and_taken_out(folder: Path) -> None:
    pass_over_a_plate(folder / "back.mcap", back_ms=200.0)
    output = folder / "sync.json"
    ran = crenel("sync", folder / "back.mcap", *given(folder), "-o", output)
    assert ran.exit_code == 0
    assert "a clock was set" in ran.stderr
    (jump,) = json.loads(output.read_text())["jumps"]
    assert jump["change_ms"] == pytest.approx(-200.0, abs=4 * jump["standard_uncertainty_ms"])
    assert jump["at_s"] == pytest.approx(2.54, abs=4 * jump["at_standard_uncertainty_s"])
    assert rms_um(folder, "--sync", output, scan="back.mcap") < 30
    ran = crenel("reconstruct", folder / "back.mcap", *given(folder), "--sync", output)
    assert "a clock was set back around their time stamps" in ran.stderr


def test_a_rebuild_takes_out_what_the_station_took_out(folder: Path) -> None:
    pass_over_a_plate(folder / "late.mcap", {ARM_DELAY: "12000000"})
    assert rms_um(folder, scan="late.mcap") < 30
    assert rms_um(folder, "--delay-ms", "0", scan="late.mcap") > 80
    drifting = {ARM_DELAY: "12004000", ARM_DELAY_AT: str(2000 * MS), ARM_DRIFT: "2.0"}
    pass_over_a_plate(folder / "drift.mcap", drifting)
    assert rms_um(folder, scan="drift.mcap") < 30
    pass_over_a_plate(folder / "odd.mcap", {ARM_DELAY: "soon"})
    assert rms_um(folder, scan="odd.mcap") > 80


def test_what_does_not_show_the_delay_is_refused_and_nothing_written(folder: Path) -> None:
    with RecordingWriter(folder / "one-way.mcap", NAMES) as writer:
        for ms in range(0, 2000, 2):
            writer.joints(ms * MS, q_of(ms / 1e3))
    before = names_in(folder)
    assert "no frames" in refused("sync", folder / "one-way.mcap", *given(folder))
    here = folder / "calibration.json"
    assert "would overwrite" in refused("sync", folder / "scan.mcap", *given(folder), "-o", here)
    assert "not an MCAP" in refused("sync", here, *given(folder), "-o", folder / "sync.json")
    assert names_in(folder) == before


def test_a_delay_of_other_devices_is_refused(folder: Path) -> None:
    output = folder / "sync.json"
    done("sync", folder / "scan.mcap", *given(folder), "-o", output)
    output.write_text(json.dumps({**json.loads(output.read_text()), "arm_serial": "A-2"}))
    line = refused("reconstruct", folder / "scan.mcap", *given(folder), "--sync", output)
    assert "belongs to arm A-2" in line
    both = ("--sync", output, "--delay-ms", "1")
    assert crenel("reconstruct", folder / "scan.mcap", *given(folder), *both).exit_code == 2
