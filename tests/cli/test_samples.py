"""The whole chain on the sample sessions, and sessions spoilt in ways that only pictures show."""

import hashlib
import json
import shutil
from collections.abc import Callable
from pathlib import Path

import cv2
import numpy as np
import pytest
from numpy.typing import NDArray

from crenel.formats.results.calibration import CalibrationFile, read_calibration
from crenel.metrology.sensor.triangulation import sensor_points
from crenel.metrology.transforms import apply, rigid_fit
from tests.cli.test_cli import done, names_in, printed, refused
from tests.formats.builders import edit_json
from tests.pictures import blur, read_picture
from tests.running.usual import usual

pytestmark = pytest.mark.slow

Spoil = Callable[[Path], None]

FILES = ("arm.json", "object.json", "sensor.json", "probing.csv", "images.csv")
"""Of a session, beside its pictures."""


@pytest.fixture(scope="module")
def calibrated(samples: Path, tmp_path_factory: pytest.TempPathFactory) -> Path:
    out = tmp_path_factory.mktemp("calibrated") / "calibration.json"
    result = done("calibrate", samples / "one-pose", "-o", out)
    assert result.stderr == ""
    assert str(out) in result.stdout
    return out


def test_the_calibration_reconstructs_the_true_points(samples: Path, calibrated: Path) -> None:
    truth = json.loads((samples / "one-pose/truth.json").read_text())
    known = read_calibration(calibrated)
    found = sensor_points(known.camera, known.plane, np.array(truth["pixels"]))
    in_sensor = np.array(truth["points_sensor_frame_mm"])
    off_sensor = apply(rigid_fit(in_sensor, found), found) - in_sensor
    off_flange = apply(known.T_flange_sensor, found) - np.array(truth["points_flange_frame_mm"])
    assert 1e3 * np.sqrt(np.mean(np.sum(off_sensor**2, axis=1))) <= 3
    assert 1e3 * np.sqrt(np.mean(np.sum(off_flange**2, axis=1))) <= 20


def test_the_calibration_carries_what_it_came_from(samples: Path, calibrated: Path) -> None:
    document = CalibrationFile.read(calibrated)
    assert document.serial_numbers.model_dump() == {"arm": "J-1", "object": "B-1", "sensor": "S-1"}
    pictures = {"images/pose00_ambient.png", "images/pose00_laser.png"}
    assert {one.file for one in document.inputs} == {*FILES, *pictures}
    for one in document.inputs:
        content = (samples / "one-pose" / one.file).read_bytes()
        assert one.sha256 == hashlib.sha256(content).hexdigest()
    assert document.verdict is not None
    assert document.uncertainty is not None
    assert document.residuals is not None
    assert len(document.residuals.contacts_um) == 45
    assert document.covariance is not None
    matrix = np.array(document.covariance.matrix)
    assert matrix.shape == (len(document.covariance.parameters),) * 2
    document.write(calibrated.with_name("again.json"))
    assert calibrated.with_name("again.json").read_bytes() == calibrated.read_bytes()


@pytest.mark.parametrize("name", ["plane", "plane_tilted", "sphere"])
def test_gauges_come_out_right(samples: Path, calibrated: Path, tmp_path: Path, name: str) -> None:
    session = samples / "one-pose"
    cloud, shape = tmp_path / "cloud.ply", name.partition("_")[0]
    arguments = ("--calibration", calibrated, "--arm", session / "arm.json", "-o", cloud)
    done("reconstruct", session / f"{name}.mcap", *arguments)
    nominal = session / f"{name}.nominal.json"
    (found,) = printed("verify", shape, cloud, "--nominal", nominal)["clouds"]
    if shape == "plane":
        assert found["angle_arcsec"] <= 60
        assert abs(found["offset_error_um"]) <= 25
        assert abs(found["z_error_um"]) <= 25
    else:
        assert abs(found["radius_error_um"]) <= 10
        assert found["centre_error_um"] <= 35


@pytest.mark.parametrize("share", [0.1, 0.4, 0.999])
def test_a_cut_recording_is_read_up_to_the_cut(
    samples: Path, calibrated: Path, tmp_path: Path, share: float
) -> None:
    whole = (samples / "one-pose/plane.mcap").read_bytes()
    (tmp_path / "cut.mcap").write_bytes(whole[: int(share * len(whole))])
    arm = samples / "one-pose/arm.json"
    arguments = ("--calibration", calibrated, "--arm", arm, "-o", tmp_path / "cloud.ply")
    result = done("reconstruct", tmp_path / "cut.mcap", *arguments, "--json")
    fields = json.loads(result.stdout)
    assert "read up to" in fields["cut"]
    assert fields["cut"] in result.stderr
    assert 40 * share - 3 <= fields["frames"] <= 40 * share + 1


def test_one_pose_of_many_says_that_one_is_used(samples: Path, tmp_path: Path) -> None:
    out = tmp_path / "c.json"
    one_pose = ("--method", "one-pose", "--json")
    result = done("calibrate", samples / "many-poses", "-o", out, *one_pose)
    fields = json.loads(result.stdout)
    assert len(fields["warnings"]) == 1
    assert "pose 0 was used" in result.stderr
    assert fields["probe_matrix"] == json.loads(out.read_text())["probe_matrix"]


def every_picture(change: Callable[[NDArray[np.uint8]], NDArray[np.uint8]]) -> Spoil:
    def spoil(session: Path) -> None:
        for path in (session / "images").iterdir():
            cv2.imwrite(str(path), change(read_picture(path)))

    return spoil


def ambient_black(session: Path) -> None:
    path = session / "images/pose00_ambient.png"
    cv2.imwrite(str(path), np.zeros_like(read_picture(path)))


def brighter(grey: NDArray[np.uint8]) -> NDArray[np.uint8]:
    return np.asarray(np.clip(grey.astype(float) * 6 + 60, 0, 255), dtype=np.uint8)


def mirror_object(session: Path) -> None:
    path = session / "object.json"
    edges = json.loads(path.read_text())["edges_x_mm"]
    edit_json(path, lambda block: block.update(edges_x_mm=[-x for x in reversed(edges)]))


def other_object(session: Path) -> None:
    edges = [-25, -19, -12, -4, 4, 7, 16, 25]
    edit_json(session / "object.json", lambda block: block.update(edges_x_mm=edges))


def swap_faces(session: Path) -> None:
    path = session / "probing.csv"
    path.write_text(path.read_text().replace("front,", "back,"))


def keep_faces(*faces: str) -> Spoil:
    def spoil(session: Path) -> None:
        header, *rows = (session / "probing.csv").read_text().splitlines()
        kept = [row for row in rows if row.split(",")[0] in faces]
        (session / "probing.csv").write_text("\n".join([header, *kept]))

    return spoil


@pytest.mark.parametrize(
    ("spoil", "said"),
    usual(
        [
            (every_picture(np.zeros_like), "no contrast"),
            (ambient_black, "no contrast"),
            (every_picture(lambda grey: np.full_like(grey, 255)), "overexposed"),
            (every_picture(brighter), "overexposed"),
            (every_picture(lambda grey: blur(grey, 25)), "blurred"),
            (mirror_object, "mirrored"),
            (other_object, "does not match the certificate"),
            (swap_faces, "contact points miss the face"),
            (keep_faces("crest"), "Touch 3 more on the front or the back face"),
            (keep_faces("crest", "front"), "Touch 3 more on the left or the right face"),
        ],
        {0, 7, 8},
        pytest.mark.soak,
    ),
    ids=[
        "black",
        "dark",
        "white",
        "overexposed",
        "blurred",
        "mirrored",
        "other",
        "faces",
        "one",
        "two",
    ],
)
def test_bad_sessions_are_refused(samples: Path, tmp_path: Path, spoil: Spoil, said: str) -> None:
    session, sample = tmp_path / "session", samples / "one-pose"
    (session / "images").mkdir(parents=True)
    for path in (*(sample / name for name in FILES), *(sample / "images").iterdir()):
        shutil.copyfile(path, session / path.relative_to(sample))
    spoil(session)
    before = names_in(tmp_path)
    line = refused("calibrate", session, "-o", tmp_path / "c.json")
    assert "internal error" not in line
    assert str(session) in line
    assert said in line
    assert names_in(tmp_path) == before
