"""What moved from one calibration to the next, from their files."""

import json
from pathlib import Path

import numpy as np
import pytest

from app.formats.results.acceptance import ACCEPTANCE, Acceptance
from app.formats.results.calibration import BudgetPart, MapPart, PlanePart, Uncertainty
from app.workflows.calibration_history import read_history
from tests.formats.test_documents import calibration_file

UV = tuple((float(u), float(v)) for u in (10, 20, 30, 40) for v in (15, 24, 33))


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
