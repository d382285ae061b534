"""The article's study by calibrations, and what moved from one calibration to the next."""

import csv
import json
from dataclasses import replace
from pathlib import Path

import numpy as np
import pytest

from crenel.errors import OperationError
from crenel.formats.clouds.files import read_cloud
from crenel.formats.recording.writer import RecordingWriter
from crenel.formats.results.acceptance import ACCEPTANCE, Acceptance
from crenel.formats.results.calibration import BudgetPart, MapPart, PlanePart, Uncertainty
from crenel.gauges.quick.clouds.evaluate_repeatability import Study, range_rows, run_study
from crenel.metrology.arm.kinematics import flange_pose
from crenel.metrology.fitting.plane_sphere import fit_plane
from crenel.metrology.sensor.camera import project
from crenel.metrology.stripe import Stripe
from crenel.metrology.transforms import apply, inverse, rigid, rotation_from_vector
from crenel.workflows.calibration_history import read_history
from crenel.workflows.reconstruct import reconstruct_cloud
from tests.formats.builders import ARM, HEIGHT, WIDTH, joints_every, little_calibration, q_at
from tests.formats.test_documents import calibration_file
from tests.workflows.test_reconstruct import MS, NAMES

NORMAL = np.array([0.2, -0.3, 0.9]) / np.linalg.norm([0.2, -0.3, 0.9])
MIDDLE = (flange_pose(ARM, q_at(200 * MS)) @ little_calibration().T_flange_sensor)[:3, 3]
UV = tuple((float(u), float(v)) for u in (10, 20, 30, 40) for v in (15, 24, 33))


def scan_a_plane(path: Path, offset_mm: float) -> Path:
    """True pixels of the plane that the sensor passes over; one sensor line a frame."""
    use = little_calibration()
    with RecordingWriter(path, NAMES) as writer:
        joints_every(writer, 0, 600 * MS, 4 * MS)
        for i in range(40):
            stamp = 50 * MS + i * 10 * MS
            T = inverse(flange_pose(ARM, q_at(stamp)) @ use.T_flange_sensor)
            n, p = T[:3, :3] @ NORMAL, apply(T, (MIDDLE + offset_mm * NORMAL)[None])[0]
            x = np.linspace(-10, 10, 30)
            y = (n @ p - n[0] * x) / n[1]
            uv = project(use.camera, np.column_stack([x, y, np.zeros(30)]))
            stripe = Stripe(uv[:, 0], uv[:, 1], np.full(30, 99.0), np.full(30, 0.05))
            writer.stripe(stamp, stripe, WIDTH, HEIGHT)
    return path


def test_planes_turn_and_shift_by_what_the_calibrations_differ(tmp_path: Path) -> None:
    recordings = [scan_a_plane(tmp_path / f"{i}.mcap", 0.02 * i) for i in range(3)]
    true = little_calibration()
    wrong = rigid(rotation_from_vector(np.array([1e-3, -5e-4, 2e-4])), np.array([0.1, 0.05, -0.2]))
    off = replace(true, T_flange_sensor=true.T_flange_sensor @ wrong)
    named = [(Path("true.json"), true), (Path("off.json"), off)]
    done = run_study(recordings, named, ARM)
    assert done.warnings == ()
    assert [(row.recording, row.calibration) for row in done.rows[:3]] == [
        (str(recordings[0]), "true.json"),
        (str(recordings[0]), "off.json"),
        (str(recordings[1]), "true.json"),
    ]
    for recording, between in zip(recordings, done.between_calibrations, strict=True):
        fits = []
        for _, calibration in named:
            reconstruct_cloud(recording, calibration, ARM, tmp_path / "c.ply")
            fits.append(fit_plane(read_cloud(tmp_path / "c.ply").points_mm))
        cosine = abs(float(fits[0].normal @ fits[1].normal))
        arcsec = np.degrees(np.arccos(cosine)) * 3600
        assert arcsec > 20
        assert between.angle_arcsec == pytest.approx(arcsec, rel=1e-3)
    # between clouds: the plane itself was shifted, by any calibration
    assert done.between_recordings[0].offset_um == pytest.approx(40, abs=0.01)
    assert done.between_recordings[0].angle_arcsec < 0.1
    assert done.between_recordings[1].offset_um == pytest.approx(40, abs=1)
    assert [row[0] for row in range_rows(done)] == ["between calibrations", "between clouds"]
    done.write_csv(tmp_path / "t.csv")
    table = list(csv.DictReader((tmp_path / "t.csv").read_text().splitlines()))
    assert len(table) == 6
    assert float(table[0]["offset_um"]) == pytest.approx(done.rows[0].offset_um, abs=1e-3)


def test_against_a_nominal(tmp_path: Path) -> None:
    recording = scan_a_plane(tmp_path / "a.mcap", 0.0)
    use = little_calibration()
    place = {"point_mm": (MIDDLE - 0.013 * NORMAL).tolist(), "normal": (-NORMAL).tolist()}
    nominal = {"format": "crenel/nominal", "version": 1, "shape": "plane", **place}
    (tmp_path / "n.json").write_text(json.dumps(nominal))
    done: Study = run_study([recording] * 2, [(Path("c.json"), use)], ARM, tmp_path / "n.json")
    assert done.rows[0].offset_um == pytest.approx(-13, abs=0.01)
    assert done.rows[0].angle_arcsec < 0.1
    assert done.between_calibrations == ()


def test_what_is_no_study_is_refused(tmp_path: Path) -> None:
    recording = scan_a_plane(tmp_path / "a.mcap", 0.0)
    with pytest.raises(OperationError, match="one plane"):
        run_study([recording], [(Path("c.json"), little_calibration())], ARM)


def write(folder: Path, name: str, shift_mm: float, arm: str = "A-1") -> tuple[str, Path]:
    own = folder / name
    own.mkdir()
    document = calibration_file()
    matrix = np.array(document.probe_matrix)
    matrix[0, 3] += shift_mm
    serials = document.serial_numbers.model_copy(update={"arm": arm})
    known = Uncertainty(
        total_um=3.0,
        budget=(BudgetPart(source="stripe", value_um=3.0),),
        depth_range_mm=(90.0, 110.0),
        plane=PlanePart(angle_arcsec=6.0, offset_um=2.0),
        map=MapPart(
            uv_px=UV,
            points_mm=((0.0, 0.0, 0.0),) * len(UV),
            u_um=(3.0,) * len(UV),
            calibrated=(True,) * len(UV),
        ),
    )
    changed = {
        "probe_matrix": tuple(map(tuple, matrix.tolist())),
        "serial_numbers": serials,
        "uncertainty": known,
    }
    path = own / "calibration.json"
    document.model_copy(update=changed).write(path)
    Acceptance(
        name=name, accepted_at="2026-11-21", calibration_sha256="0", good_um=40, temperature_c=21.0
    ).write(own / ACCEPTANCE)
    return name, path


def test_each_is_compared_with_the_one_before_of_the_same_arm(tmp_path: Path) -> None:
    files = [
        write(tmp_path, "first", 0.0),
        write(tmp_path, "other", 1.0, arm="A-2"),
        write(tmp_path, "second", 0.02),
    ]
    first, other, second = read_history(files)
    assert first.since is None
    assert other.since is None
    assert (first.good_um, first.temperature_c) == (40, 21.0)
    assert second.since is not None
    assert second.since.drift.sensor_um == pytest.approx(20)
    assert second.since.expected_um == pytest.approx(2 * np.hypot(3, 3))
    assert second.since.expected_arcsec == pytest.approx(2 * np.hypot(6, 6))


def test_a_file_that_is_gone_is_passed_over(tmp_path: Path) -> None:
    files = [write(tmp_path, "first", 0.0), write(tmp_path, "second", 0.01)]
    files[0][1].write_text(json.dumps({}))
    (second,) = read_history(files)
    assert (second.id, second.since) == ("second", None)
