"""The command line: results, exit statuses, one line for each refusal, nothing half-written."""

import json
import os
import re
import signal
import socket
import subprocess
import sys
import time
from collections.abc import Iterable
from pathlib import Path
from typing import Any

import cv2
import numpy as np
import pytest
from typer.testing import CliRunner, Result

from crenel.cli.main import cli
from crenel.formats.clouds.files import cloud_writer, read_cloud
from crenel.formats.recording.writer import RecordingWriter
from crenel.gauges.quick.clouds.document import GaugeReport
from crenel.gauges.quick.clouds.evaluate import FIGURES
from crenel.metrology.transforms import Floats
from tests.datasheets import write_arm
from tests.formats.builders import ARM, edit_text, joints_every, write_session
from tests.formats.test_documents import calibration_file
from tests.pictures import read_picture
from tests.workflows.test_reconstruct import MS, NAMES, record_stripe

pytestmark = pytest.mark.device

ROOT = Path(__file__).resolve().parents[2]
Files = dict[str, Path]


def crenel(*arguments: object) -> Result:
    return CliRunner().invoke(cli, [str(argument) for argument in arguments])


def done(*arguments: object) -> Result:
    result = crenel(*arguments)
    assert result.exit_code == 0, result.output
    return result


def printed(*arguments: object) -> dict[str, Any]:
    """What a command that ends with status 0 prints for programs."""
    return dict(json.loads(done(*arguments, "--json").stdout))


def refused(*arguments: object) -> str:
    """The one line on stderr of a command that ends with status 1 and prints nothing else."""
    result = crenel(*arguments)
    assert result.exit_code == 1, result.output
    assert result.stdout == ""
    assert result.stderr.startswith("crenel: ")
    assert result.stderr.count("\n") == 1
    return str(result.stderr)


def names_in(folder: Path) -> list[str]:
    return sorted(str(path.relative_to(folder)) for path in folder.rglob("*"))


@pytest.fixture
def stripe_picture(tmp_path: Path) -> Path:
    rows = np.arange(100)[:, None]
    v = 40 + 0.1 * np.arange(200)
    grey = 10 + 180 * np.exp(-((rows - v) ** 2) / 8)
    noise = np.random.default_rng(0).normal(0, 1, grey.shape)
    path = tmp_path / "stripe.png"
    cv2.imwrite(str(path), np.clip(np.rint(grey + noise), 0, 255).astype(np.uint8))
    return path


@pytest.fixture
def scan(tmp_path: Path) -> Files:
    paths = {name: tmp_path / name for name in ("scan.mcap", "calibration.json", "arm.json")}
    write_scan(paths["scan.mcap"], [*range(50, 150, 10), 500])
    calibration_file().write(paths["calibration.json"])
    write_arm(paths["arm.json"], ARM)
    return paths


def write_scan(path: Path, stamps_ms: Iterable[int]) -> None:
    """A recording of frames, with joints over its first 200 ms."""
    with RecordingWriter(path, NAMES) as writer:
        joints_every(writer, 0, 200 * MS, 4 * MS)
        for stamp_ms in stamps_ms:
            record_stripe(writer, stamp_ms * MS)


def write_plane(path: Path, z_mm: float = 0.0) -> Path:
    rng = np.random.default_rng(int(z_mm * 1000))
    points = np.column_stack([rng.uniform(-20, 20, (500, 2)), rng.normal(z_mm, 0.01, 500)])
    return write_cloud(path, points)


def write_cloud(path: Path, points: Floats) -> Path:
    with cloud_writer(path) as cloud:
        cloud.write(points, np.zeros(len(points)), np.zeros(len(points)), 0)
    return path


def write_nominal(path: Path, shape: str) -> Path:
    plane = {"point_mm": [0, 0, 0], "normal": [0, 0, 1]}
    sphere = {"centre_mm": [0, 0, 0], "radius_mm": 10}
    nominal = {"format": "crenel/nominal", "version": 1, "shape": shape}
    path.write_text(json.dumps(nominal | (plane if shape == "plane" else sphere)))
    return path


def write_points(path: Path, points: Floats) -> Path:
    np.savetxt(path, points)
    return path


def sphere_points(radius_mm: float) -> Floats:
    """(800, 3)"""
    directions = np.random.default_rng(0).normal(size=(800, 3))
    return np.asarray(radius_mm * directions / np.linalg.norm(directions, axis=1)[:, None])


def test_extract_writes_the_columns_of_the_contract(tmp_path: Path, stripe_picture: Path) -> None:
    out = tmp_path / "out.csv"
    result = done("extract", stripe_picture, "-o", out)
    lines = out.read_text().splitlines()
    assert lines[0] == "u,v,intensity,sigma_px"
    table = np.array([[float(cell) for cell in line.split(",")] for line in lines[1:]])
    assert len(table) > 190
    assert np.abs(table[:, 1] - (40 + 0.1 * table[:, 0])).max() < 0.2
    assert str(out) in result.stdout


def test_extract_distinguishes_several_pictures(tmp_path: Path, stripe_picture: Path) -> None:
    other = tmp_path / "other.png"
    other.write_bytes(stripe_picture.read_bytes())
    out = tmp_path / "out.csv"
    done("extract", stripe_picture, other, "-o", out)
    lines = out.read_text().splitlines()
    assert lines[0] == "u,v,intensity,sigma_px,image"
    assert {line.split(",")[4] for line in lines[1:]} == {str(stripe_picture), str(other)}


def test_extract_along_rows_and_for_programs(tmp_path: Path, stripe_picture: Path) -> None:
    turned = tmp_path / "turned.png"
    cv2.imwrite(str(turned), read_picture(stripe_picture).T)
    out = tmp_path / "out.csv"
    along_u = printed("extract", stripe_picture, "-o", out)
    along_v = printed("extract", turned, "-o", out, "--axis", "v")
    assert along_u["images"][0]["u"] == along_v["images"][0]["v"]
    assert along_u["images"][0]["v"] == along_v["images"][0]["u"]
    assert along_u["file"] == str(out)


def test_extract_refuses_bad_pictures(tmp_path: Path) -> None:
    out = tmp_path / "out.csv"
    black, colour = tmp_path / "black.png", tmp_path / "colour.png"
    cv2.imwrite(str(black), np.zeros((100, 200), np.uint8))
    cv2.imwrite(str(colour), np.arange(60_000).reshape(100, 200, 3).astype(np.uint8))
    assert "no laser stripe: it is dark" in refused("extract", black, "-o", out)
    assert "shows no laser stripe: no" in refused("extract", colour, "-o", out)
    assert "none.png" in refused("extract", tmp_path / "none.png", "-o", out)
    assert not out.exists()


@pytest.mark.parametrize("kind", [np.uint8, np.uint16])
def test_a_dark_or_bright_picture_is_called_so(tmp_path: Path, kind: type) -> None:
    out, full = tmp_path / "out.csv", np.iinfo(kind).max
    rng = np.random.default_rng(0)
    for name, picture, words in (
        ("dark", rng.normal(8, 2, (100, 200)).clip(0, 20), "it is dark"),
        ("bright", np.full((100, 200), full), "100 % of its pixels are at full scale"),
        ("half", np.repeat([0, full], 50)[:, None] * np.ones((1, 200)), "50 % of its pixels"),
        ("grey", np.full((100, 200), 2 * full // 5), "no bright line"),
        ("tiny", np.full((2, 2), 2 * full // 5), "no bright line"),
    ):
        path = tmp_path / f"{name}.png"
        cv2.imwrite(str(path), picture.astype(kind))
        assert words in refused("extract", path, "-o", out), name
    assert not out.exists()


def test_reconstruct_writes_a_cloud(tmp_path: Path, scan: Files) -> None:
    out = tmp_path / "cloud.ply"
    result = done(*reconstruct_arguments(scan), "-o", out)
    assert len(read_cloud(out).points_mm) == 250
    assert "1 of 11 frames excluded: no arm readings" in result.stderr
    assert str(out) in result.stdout
    fields = printed(*reconstruct_arguments(scan), "-o", out)
    assert (fields["points"], fields["frames"], fields["frames_without_joints"]) == (250, 10, 1)
    assert fields["warnings"]
    assert not fields["incomplete"]


def test_reconstruct_of_an_incomplete_scan_needs_an_option(tmp_path: Path, scan: Files) -> None:
    scan["scan.mcap"].unlink()
    write_scan(scan["scan.mcap"], (50, 60, 500))
    out = tmp_path / "cloud.ply"
    assert "1 of 3 pictures with a line (33.3" in refused(*reconstruct_arguments(scan), "-o", out)
    assert not out.exists()
    wanted = crenel(*reconstruct_arguments(scan), "-o", out, "--allow-incomplete", "--json")
    assert wanted.exit_code == 3
    assert json.loads(wanted.stdout)["incomplete"]
    assert "incomplete" in wanted.stderr
    assert len(read_cloud(out).points_mm) == 50


def reconstruct_arguments(scan: Files) -> list[str | Path]:
    calibration, arm = scan["calibration.json"], scan["arm.json"]
    return ["reconstruct", scan["scan.mcap"], "--calibration", calibration, "--arm", arm]


def test_reconstruct_of_a_cut_recording_says_so(tmp_path: Path, scan: Files) -> None:
    path = scan["scan.mcap"]
    path.unlink()
    with RecordingWriter(path, NAMES) as writer:
        for stamp in range(0, 2000 * MS, 4 * MS):
            joints_every(writer, stamp, stamp, MS)
            record_stripe(writer, stamp)
            writer.image(stamp, np.random.default_rng(stamp).integers(0, 9, (99, 99), np.uint8))
    whole = path.read_bytes()
    path.write_bytes(whole[: int(len(whole) * 0.7)])
    assert "incomplete" in done(*reconstruct_arguments(scan), "-o", tmp_path / "cloud.ply").stderr
    assert len(read_cloud(tmp_path / "cloud.ply").points_mm) > 1000


def test_reconstruct_refuses_what_does_not_fit(tmp_path: Path, scan: Files) -> None:
    arguments = [*reconstruct_arguments(scan), "-o", tmp_path / "cloud.ply"]
    before = names_in(tmp_path)
    whole = scan["arm.json"].read_text()
    edit_text(scan["arm.json"], '"A-1"', '"A-2"')
    assert "A-2" in refused(*arguments)
    scan["arm.json"].write_text(whole[: len(whole) // 2])
    assert "arm.json" in refused(*arguments)
    scan["arm.json"].unlink()
    assert "arm.json" in refused(*arguments)
    scan["arm.json"].write_text(whole)
    scan["scan.mcap"].write_text("not a recording")
    assert "not an MCAP" in refused(*arguments)
    assert names_in(tmp_path) == before


def test_clouds_of_another_kind_are_wrong_usage(tmp_path: Path, scan: Files) -> None:
    assert crenel(*reconstruct_arguments(scan), "-o", ".").exit_code == 2
    result = crenel(*reconstruct_arguments(scan), "-o", tmp_path / "cloud.stl")
    assert result.exit_code == 2
    assert ".ply" in result.stderr


def test_verify_a_plane(tmp_path: Path) -> None:
    cloud, report = write_plane(tmp_path / "a.ply", 0.05), tmp_path / "report.json"
    nominal = write_nominal(tmp_path / "n.json", "plane")
    fields = printed("verify", "plane", cloud, "--nominal", nominal, "-o", report)
    assert fields.pop("warnings") == []
    assert fields == GaugeReport.read(report).fields()
    (found,) = fields["clouds"]
    assert found["z_error_um"] == pytest.approx(-50, abs=3)
    assert found["offset_error_um"] == pytest.approx(50, abs=3)
    assert found["angle_arcsec"] < 60
    assert found["in_gate"] >= found["used"]
    assert found["range_all_um"] >= 0.99 * found["form_um"] > 0


def test_verify_several_clouds_gives_their_spread(tmp_path: Path) -> None:
    clouds = [write_plane(tmp_path / f"{i}.ply", 0.1 * i) for i in range(3)]
    nominal = write_nominal(tmp_path / "n.json", "plane")
    fields = printed("verify", "plane", *clouds, "--nominal", nominal)
    errors = [cloud["z_error_um"] for cloud in fields["clouds"]]
    spread = fields["spread"]["z_error_um"]
    assert spread["range"] == pytest.approx(max(errors) - min(errors))
    assert spread["standard_deviation"] == pytest.approx(np.std(errors, ddof=1))
    shown = crenel("verify", "plane", *clouds, "--nominal", nominal).stdout
    assert all(str(cloud) in shown for cloud in clouds)
    assert "standard deviation" in shown


def test_verify_a_sphere(tmp_path: Path) -> None:
    cloud = write_points(tmp_path / "s.xyz", sphere_points(10.02) + [0, 0.03, 0])
    nominal = write_nominal(tmp_path / "n.json", "sphere")
    (found,) = printed("verify", "sphere", cloud, "--nominal", nominal)["clouds"]
    assert found["radius_error_um"] == pytest.approx(-20, abs=0.1)
    assert found["centre_error_um"] == pytest.approx(30, abs=0.1)


def test_a_cloud_in_metres_is_warned_of_and_read_with_its_unit(tmp_path: Path) -> None:
    cloud = write_points(tmp_path / "s.xyz", sphere_points(0.0003))
    assert "--unit m" in crenel("verify", "sphere", cloud).stderr
    (found,) = printed("verify", "sphere", cloud, "--unit", "m")["clouds"]
    assert found["radius_mm"] == pytest.approx(0.3)
    write_points(cloud, sphere_points(0.05))
    result = done("verify", "sphere", cloud, "--unit", "m", "--json")
    assert json.loads(result.stdout)["clouds"][0]["radius_mm"] == pytest.approx(50)
    assert result.stderr == ""


@pytest.mark.parametrize(("unit", "mm"), [("inch", 25.4), ("m", 1000.0)])
def test_a_nominal_radius_in_another_unit_warns(tmp_path: Path, unit: str, mm: float) -> None:
    cloud = write_points(tmp_path / "s.xyz", sphere_points(10.02 / mm))
    given = ("verify", "sphere", cloud, "--nominal")
    nominal = write_nominal(tmp_path / "n.json", "sphere")
    (warning,) = printed(*given, nominal)["warnings"]
    assert f"has the nominal radius if its unit is {unit}. Give --unit {unit}" in warning
    assert crenel(*given, nominal, "--unit", unit).stderr == ""


def ball(rng: np.random.Generator, count: int, noise_mm: float = 0.01) -> Floats:
    """Points of the upper half of the sphere of ``write_nominal``."""
    outward = rng.normal(size=(count, 3))
    outward[:, 2] = np.abs(outward[:, 2])
    outward /= np.linalg.norm(outward, axis=1)[:, None]
    return np.asarray((10 + rng.normal(0, noise_mm, (count, 1))) * outward)


def test_a_sphere_beside_a_table_is_found_by_its_nominal(tmp_path: Path) -> None:
    rng = np.random.default_rng(0)
    table = np.column_stack([rng.uniform(-150, 150, (20_000, 2)), rng.normal(-25, 0.01, 20_000)])
    np.savetxt(tmp_path / "s.xyz", np.concatenate([table, ball(rng, 1500)]))
    nominal = write_nominal(tmp_path / "n.json", "sphere")
    result = crenel("verify", "sphere", tmp_path / "s.xyz", "--nominal", nominal, "--json")
    (found,) = json.loads(result.stdout)["clouds"]
    stated = found["expanded_uncertainty"]
    assert found["rms_um"] == pytest.approx(10, abs=1)
    assert 0.1 < stated["radius_error_um"] < 5
    for name in ("radius_error_um", "centre_error_um"):
        assert abs(found[name]) < 2 * stated[name]
    assert set(stated) == {name for name in FIGURES if name in found}


@pytest.mark.parametrize("away_mm", [3e4, 2e6, 9.9e6])
def test_other_coordinates_keep_what_does_not_need_them(tmp_path: Path, away_mm: float) -> None:
    points = ball(np.random.default_rng(0), 1500) + [0.0, away_mm, 0.0]
    np.savetxt(tmp_path / "s.xyz", points, fmt="%.6f")
    nominal = write_nominal(tmp_path / "n.json", "sphere")
    result = crenel("verify", "sphere", tmp_path / "s.xyz", "--nominal", nominal, "--json")
    (found,) = json.loads(result.stdout)["clouds"]
    assert found["radius_error_um"] == pytest.approx(0, abs=2)
    assert "centre_error_um" not in found
    assert f"{away_mm / 1000:.0f} m from the nominal" in result.stderr


def test_half_a_cloud_that_is_exact_is_no_measurement(tmp_path: Path) -> None:
    rng = np.random.default_rng(0)
    points = rng.uniform(-50, 50, (2000, 3)) * [1, 1, 0.0004]
    points[:1100, 2] = 0.0
    np.savetxt(tmp_path / "p.xyz", points)
    assert "1100 of 2000 points lie on one plane exactly" in refused(
        "verify", "plane", tmp_path / "p.xyz"
    )
    np.savetxt(tmp_path / "p.xyz", points[:1100])
    shown = crenel("verify", "plane", tmp_path / "p.xyz").stdout
    assert "< 0.1" in shown
    assert " 0.0 " not in shown


@pytest.mark.parametrize("unit", [(), ("--unit", "mm")])
def test_an_e57_is_in_metres_unless_a_unit_is_given(tmp_path: Path, unit: tuple[str, ...]) -> None:
    points = ball(np.random.default_rng(0), 1500) * (1000 if unit else 1)
    with cloud_writer(tmp_path / "s.e57") as cloud:
        cloud.write(points, points[:, 0], points[:, 0], 0)
    nominal = write_nominal(tmp_path / "n.json", "sphere")
    given = ("verify", "sphere", tmp_path / "s.e57", "--nominal", nominal)
    result = crenel(*given, *unit, "--json")
    assert abs(json.loads(result.stdout)["clouds"][0]["radius_error_um"]) < 2
    if unit:
        assert "Give --unit mm" in crenel(*given).stderr
        assert "internal error" not in crenel(*given, "--unit", "inch").stderr


def test_a_line_of_points_is_no_plane(tmp_path: Path) -> None:
    rng = np.random.default_rng(0)
    line = np.column_stack([np.linspace(0, 50, 500), *rng.normal(0, 0.02, (2, 500))])
    cloud = write_points(tmp_path / "p.xyz", line)
    (warning,) = printed("verify", "plane", cloud)["warnings"]
    assert "they hardly determine a plane" in warning
    line[:, 1] += np.tile([0.0, 5.0], 250)
    assert crenel("verify", "plane", write_points(cloud, line)).stderr == ""


def test_points_that_are_missing_or_far_away_say_nothing_of_the_unit(tmp_path: Path) -> None:
    points = sphere_points(12.7)
    points[::5] = np.nan
    points[1], points[2] = np.inf, 1e6
    cloud = write_points(tmp_path / "s.xyz", points)
    result = crenel("verify", "sphere", cloud, "--json")
    assert json.loads(result.stdout)["clouds"][0]["radius_mm"] == pytest.approx(12.7)
    assert result.stderr == ""
    write_points(cloud, points / 1000)
    assert "0.043 mm large" in crenel("verify", "sphere", cloud).stderr


def test_points_that_are_no_plane_are_warned_of(tmp_path: Path) -> None:
    cloud = write_points(tmp_path / "s.xyz", sphere_points(50))
    result = crenel("verify", "plane", cloud, "--json")
    (warning,) = json.loads(result.stdout)["warnings"]
    assert "plane" in warning
    assert result.stderr.strip()


def test_verify_without_a_nominal_reports_the_form(tmp_path: Path) -> None:
    (found,) = printed("verify", "plane", write_plane(tmp_path / "a.ply"))["clouds"]
    assert found["rms_um"] == pytest.approx(10, abs=1)
    assert "angle_arcsec" not in found


def test_verify_refuses(tmp_path: Path) -> None:
    cloud = write_plane(tmp_path / "a.ply")
    sphere = write_nominal(tmp_path / "s.json", "sphere")
    assert "of a sphere" in refused("verify", "plane", cloud, "--nominal", sphere)
    (tmp_path / "few.xyz").write_text("1 2 3\n4 5 6\n")
    assert "few.xyz" in refused("verify", "plane", tmp_path / "few.xyz")
    assert "none.ply" in refused("verify", "plane", cloud, tmp_path / "none.ply")
    flat = np.random.default_rng(0).uniform(-20, 20, (100, 3)) * [1, 1, 0]
    assert "a.ply" in refused("verify", "sphere", write_cloud(cloud, flat))
    assert "report" in refused("verify", "plane", cloud, "-o", tmp_path / "no/report.json")


@pytest.mark.parametrize(
    "arguments",
    [
        *("", "fly", "extract", "extract a.png --axis w", "calibrate session --method guess"),
        *("identify", "articulation folder --limit-um -3", "reconstruct scan.mcap"),
        *("verify cone a.ply", "verify plane", "serve --port 99999"),
    ],
)
def test_wrong_usage_ends_with_two(arguments: str) -> None:
    assert crenel(*arguments.split()).exit_code == 2


def test_help_and_version() -> None:
    shown = done("--help").stdout
    for command in ("demo", "serve", "calibrate", "extract", "reconstruct", "verify"):
        assert command in shown
        done(command, "--help")
    assert re.fullmatch(r"crenel \S+\n", crenel("--version").stdout)


def test_a_place_that_takes_no_file_is_refused_first(tmp_path: Path, stripe_picture: Path) -> None:
    (tmp_path / "folder").mkdir()
    assert "folder" in refused("extract", stripe_picture, "-o", tmp_path / "folder")
    assert "no folder" in refused("extract", stripe_picture, "-o", tmp_path / "none" / "a.csv")


def test_no_result_replaces_its_source(tmp_path: Path, stripe_picture: Path, scan: Files) -> None:
    session = write_session(tmp_path / "s")
    cloud = tmp_path / "cloud.ply"
    cloud.write_bytes(scan["scan.mcap"].read_bytes())
    files = [stripe_picture, cloud, session / "arm.json", session / "images/l.png"]
    before = [path.read_bytes() for path in files]
    given = ("--calibration", scan["calibration.json"], "--arm", scan["arm.json"])
    assert "computed from" in refused("extract", stripe_picture, "-o", stripe_picture)
    assert "computed from" in refused("reconstruct", cloud, *given, "-o", cloud)
    assert "computed from" in refused("verify", "plane", cloud, "-o", cloud)
    for name in ("arm.json", "images/../images/l.png"):
        assert "computed from" in refused("calibrate", session, "-o", session / name)
    assert [path.read_bytes() for path in files] == before


def test_calibrate_refuses_a_bad_session_and_leaves_nothing(tmp_path: Path) -> None:
    folder = write_session(tmp_path / "s")
    out = tmp_path / "c.json"
    before = names_in(tmp_path)
    assert "none" in refused("calibrate", tmp_path / "none", "-o", out)
    line = refused("calibrate", folder, "-o", out)  # its pictures are black, its contacts few
    assert "Traceback" not in line
    assert names_in(tmp_path) == before
    edit_text(folder / "probing.csv", "-84.5", "nan")
    assert "probing.csv line 2" in refused("calibrate", folder, "-o", out)
    assert names_in(tmp_path) == before


def process(*arguments: object, cwd: Path, first: str = "") -> subprocess.Popen[str]:
    code = f"{first}from crenel.cli.main import main; main()"
    return subprocess.Popen(
        [sys.executable, "-c", code, *map(str, arguments)],
        cwd=cwd,
        env={**os.environ, "PYTHONPATH": str(ROOT)},
        stdout=subprocess.PIPE,
        stderr=subprocess.PIPE,
        text=True,
    )


def test_a_real_process_refuses_on_one_line_with_status_one(tmp_path: Path) -> None:
    with process("extract", "none.png", cwd=tmp_path) as run:
        out, error = run.communicate(timeout=60)
    assert (run.returncode, out) == (1, "")
    assert error == "crenel: none.png: there is no such file or folder. Check the path.\n"


def test_a_disk_that_takes_no_more_is_reported(tmp_path: Path, scan: Files) -> None:
    before = names_in(tmp_path)
    limit = (  # compiled modules that it writes would be cut off as well
        "import resource, sys; sys.dont_write_bytecode = True; "
        "resource.setrlimit(resource.RLIMIT_FSIZE, (1000, 1000)); "
    )
    with process(*reconstruct_arguments(scan), cwd=tmp_path, first=limit) as run:
        out, error = run.communicate(timeout=60)
    assert (run.returncode, out) == (1, "")
    full = r"(cloud|readings)\.ply: .* of the disk .*\n"
    assert re.fullmatch(rf"crenel: (warning: .*\ncrenel: )?{full}", error)
    assert names_in(tmp_path) == before


def test_help_imports_nothing_heavy(tmp_path: Path) -> None:
    heavy = "cv2 fastapi foxglove mcap numpy pydantic scipy uvicorn viser"
    # printed when the command has ended
    said = f"print(sorted({heavy!r}.split() & sys.modules.keys()), file=sys.stderr)"
    first = f"import atexit, sys; atexit.register(lambda: {said}); "
    with process("--help", cwd=tmp_path, first=first) as run:
        _, error = run.communicate(timeout=60)
    assert (run.returncode, error.strip()) == (0, "[]")


@pytest.mark.parametrize(("number", "status"), [(signal.SIGINT, 130), (signal.SIGTERM, 143)])
def test_interrupts_leave_nothing(tmp_path: Path, scan: Files, number: int, status: int) -> None:
    scan["scan.mcap"].unlink()
    with RecordingWriter(scan["scan.mcap"], NAMES) as writer:
        for stamp in range(0, 20_000 * MS, MS):
            writer.joints(stamp, [0.0] * 6)
            writer.image(stamp, np.zeros((48, 64), np.uint8))
    before = names_in(tmp_path)
    # a shell that runs the tests in the background lets its children ignore Ctrl-C
    heard = "import signal; signal.signal(signal.SIGINT, signal.default_int_handler); "
    with process(*reconstruct_arguments(scan), "-o", "cloud.ply", cwd=tmp_path, first=heard) as run:
        deadline = time.monotonic() + 60
        while names_in(tmp_path) == before and time.monotonic() < deadline:
            time.sleep(0.01)
        run.send_signal(number)
        out, error = run.communicate(timeout=60)
    assert (run.returncode, out) == (status, "")
    assert "Traceback" not in error
    assert names_in(tmp_path) == before


DEVICES = """
[arm]
driver = "serial-encoder"
url = "socket://127.0.0.1:9"
[sensor]
driver = "folder"
"""


def test_serve_refuses_what_it_cannot_start(tmp_path: Path) -> None:
    config = tmp_path / "station.toml"
    assert "station.toml" in refused("serve", "--config", config)
    config.write_text('[arm]\ndriver = "none-such"\n[sensor]\ndriver = "opencv"\n')
    assert "none-such" in refused("serve", "--config", config)
    config.write_text(f'[station]\ndata = "data"\n{DEVICES}'.replace("encoder", "encodr"))
    line = refused("serve", "--config", config, "--port", "0")
    assert "serial-encodr" in line
    assert "serial-encoder" in line
    assert not (tmp_path / "data").exists()
    config.write_text("[arm\n")
    assert "station.toml" in refused("serve", "--config", config)


def test_serve_refuses_a_busy_port(tmp_path: Path) -> None:
    (tmp_path / "pictures").mkdir()
    config = tmp_path / "station.toml"
    config.write_text(f'[station]\ndata = "data"\n{DEVICES}path = "{tmp_path / "pictures"}"\n')
    with socket.socket() as taken:
        taken.bind(("127.0.0.1", 0))
        taken.listen()
        port = str(taken.getsockname()[1])
        assert port in refused("serve", "--config", config, "--port", port)


def test_study_compares_calibrations(tmp_path: Path, scan: Files) -> None:
    paths = [scan[name] for name in ("scan.mcap", "calibration.json", "calibration.json")]
    reported = printed("study", *paths, "--arm", scan["arm.json"], "-o", tmp_path / "t.csv")
    assert reported["between_calibrations"][0]["offset_um"] == 0
    assert len((tmp_path / "t.csv").read_text().splitlines()) == 3
    assert crenel("study", scan["scan.mcap"], "--arm", scan["arm.json"]).exit_code == 2
    before = names_in(tmp_path)
    assert "one plane" in refused("study", *paths[:2], "--arm", scan["arm.json"])
    assert names_in(tmp_path) == before
