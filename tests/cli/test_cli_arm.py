"""The arm on the command line: identification, articulation, and the delay to the camera."""

import json
from pathlib import Path

import numpy as np
import pytest

from crenel.formats.clouds.files import read_cloud
from crenel.formats.datasheets.arm import read_arm
from crenel.formats.recording.reader import ARM_DELAY, ARM_DELAY_AT, ARM_DRIFT
from crenel.formats.recording.writer import RecordingWriter
from crenel.metrology.arm.kinematics import flange_pose
from crenel.metrology.fitting.plane_sphere import fit_plane
from crenel.metrology.sensor.camera import project
from crenel.metrology.stripe import Stripe
from crenel.metrology.transforms import Floats
from tests.cli.test_cli import crenel, done, names_in, printed, refused
from tests.datasheets import write_arm
from tests.formats.builders import ARM, HEIGHT, POSE_DEG, WIDTH, little_calibration
from tests.formats.test_documents import calibration_file
from tests.simulated_arm_sessions import ArmSessionPlan, render_arm_session
from tests.workflows.test_reconstruct import MS, NAMES

pytestmark = pytest.mark.slow

PLAN = ArmSessionPlan(
    seats=6, points_per_seat=14, spheres=0, bar_lengths_mm=(600.0,), positions_per_bar=4
)
DELAY_MS = 12.0


@pytest.fixture
def session(tmp_path: Path) -> Path:
    render_arm_session(tmp_path / "s", 5, PLAN)
    return tmp_path / "s"


def test_identify_writes_the_arm_and_shows_before_and_after(tmp_path: Path, session: Path) -> None:
    out = tmp_path / "new.json"
    result = done("identify", session, "-o", out)
    words = ("before", "after", "J2.theta_deg", "Unchanged parameters", "Correlated", "µm")
    for word in (*words, str(out), "calibrate the arm's sensors"):
        assert word in result.stdout
    assert read_arm(out) != read_arm(session / "arm.json")
    fields = printed("identify", session, "-o", out)
    part = fields["identification"]
    assert part["volume_after_um"] < part["volume_before_um"] / 10
    assert fields["file"] == str(out)
    written = json.loads(out.read_text())["identification"]
    pairs, names = written["correlated"], {one["name"] for one in written["parameters"]}
    assert all(abs(pair["coefficient"]) > 0.95 for pair in pairs)
    assert pairs
    assert {pair["first"] for pair in pairs} <= names


def test_a_model_is_imported_once_everything_is_said(tmp_path: Path) -> None:
    out, table = tmp_path / "new.json", tmp_path / "table.txt"
    rows = [f"{number} {100 * number} 0 π/2 q{number}" for number in range(1, 7)]
    table.write_text("joint d a alpha theta\n" + "\n".join(rows))
    command = ("import-arm", table, "--tip", 0, 0, 150, 6, "-o", out)
    said = refused(*command)
    assert "length (mm | cm | m | inch; likely mm" in said
    assert "convention (dh-standard | dh-modified)" in said
    assert "KEY=VALUE" in crenel(*command, "--say", "length").stderr
    assert not out.exists()
    result = done(*command, "--say", "length=mm", "--say", "convention=dh-standard")
    assert "±180°" in result.stderr
    assert read_arm(out).joints[5].d_mm == 600


def test_identify_refuses_on_one_line_and_writes_nothing(tmp_path: Path, session: Path) -> None:
    before = names_in(tmp_path)
    assert "no such folder" in refused("identify", tmp_path / "none")
    assert "computed from" in refused("identify", session, "-o", session / "arm.json")
    lines = (session / "articulation.csv").read_text().splitlines()
    (session / "articulation.csv").write_text("\n".join(lines[:3]) + "\n")
    assert "seat S1" in refused("identify", session, "-o", tmp_path / "new.json")
    assert names_in(tmp_path) == before


def test_without_a_bar_the_scale_is_said_to_be_unobservable(tmp_path: Path, session: Path) -> None:
    (session / "ballbars.csv").unlink()
    result = done("identify", session, "-o", tmp_path / "new.json")
    assert "ball bar" in result.stderr
    assert "not observable" in result.stdout


def test_articulation_passes_or_fails_by_the_limit(tmp_path: Path, session: Path) -> None:
    shown = done("articulation", session).stdout
    assert "S1" in shown
    assert "FAIL" not in shown
    done("articulation", session, "--limit-um", "2000")
    failed = crenel("articulation", session / "articulation.csv", "--limit-um", "50")
    assert failed.exit_code == 1
    assert "beyond the limit" in failed.stderr
    fields = printed("articulation", session, "--limit-um", "2000")
    assert (fields["verdict"], len(fields["sets"])) == ("pass", 6)
    assert "arm.json" in refused("articulation", tmp_path)


def test_points_of_the_fit_are_no_check(tmp_path: Path, session: Path) -> None:
    before = names_in(tmp_path)
    reported = refused("identify", session, "-o", tmp_path / "new.json", "--check", session)
    assert "other places" in reported
    assert names_in(tmp_path) == before


def test_articulation_refuses_points_of_two_places(session: Path) -> None:
    table = session / "articulation.csv"
    lines = table.read_text().splitlines()
    mixed = [lines[0], *(f"S1,{line.split(',', 1)[1]}" for line in lines[1:29])]
    table.write_text("\n".join(mixed) + "\n")
    assert "another place" in refused("articulation", session)
    table.write_text(table.read_text().replace(mixed[3].split(",")[2], "nan"))
    assert refused("articulation", session).count("articulation.csv") == 1


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
    sync = ("--sync", output, "-o", folder / "cloud.ply")
    ran = crenel("reconstruct", folder / "back.mcap", *given(folder), *sync)
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
