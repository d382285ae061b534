"""``crenel certificate block``: from readings, from an arm's touches, and from a session."""

from pathlib import Path

import numpy as np
import pytest

from crenel.formats.certifying.block_readings import face_name
from crenel.formats.csv_table import table_text
from crenel.formats.datasheets.target import read_block
from crenel.formats.session.pose_columns import joint_columns
from crenel.metrology.calibration.observation_model import coordinates
from crenel.metrology.targets.crenellated_block import FACES
from tests.bench.block_certificate import TouchedBlock, certify, draw_touched
from tests.cli.test_cli import printed, refused

READING = ("from", "to", "distance_mm", "standard_uncertainty_mm")


@pytest.fixture
def touched(tmp_path: Path) -> TouchedBlock:
    """Its tip is certified; beside its files lie its touches."""
    made = draw_touched(6, tmp_path)
    certify(made, made.q_deg, tmp_path)
    return made


def test_an_arms_touches_make_a_certificate_and_its_page(
    touched: TouchedBlock, tmp_path: Path
) -> None:
    block = ("certificate", "block", "--drawing", tmp_path / "drawing.json")
    command = (*block, "--points", tmp_path / "points.csv", "-o", tmp_path / "object.json")
    assert "arm.json" in refused(*command, "--arm", tmp_path / "arm.json", "--tip-um", 2)
    assert "--arm" in refused(*command)
    by = ("--arm", tmp_path / "arm.json", "--arm-um", 20)
    assert "diameter of the tip" in refused(*command, *by)
    printed(*command, *by, "--tip-um", 2, "--page", tmp_path / "page.html")
    found = read_block(tmp_path / "object.json")
    off = np.diff(found.edges_x_mm) - np.diff(touched.true_mm[: touched.edges])
    assert np.abs(off).max() < 0.05
    assert "rms of the tip over the arm" in (tmp_path / "page.html").read_text("utf-8")


def test_a_sessions_contact_points_count_with_readings(
    touched: TouchedBlock, tmp_path: Path
) -> None:
    outside = [i for i, face in enumerate(touched.faces) if face in FACES]
    columns = ("feature", *joint_columns(touched.q_deg.shape[1]))
    rows = [[touched.faces[i], *touched.q_deg[i].tolist()] for i in outside]
    (tmp_path / "probing.csv").write_text(table_text(columns, rows))
    block = ("certificate", "block", "--drawing", tmp_path / "drawing.json")
    by = ("--points", tmp_path, "--arm-um", 20, "--tip-um", 2)
    command = (*block, *by, "-o", tmp_path / "o.json")
    assert "reaches the faces edge_2" in refused(*command)
    values, edges = touched.true_mm, touched.edges
    steps = [(0, i) for i in range(1, edges - 1)] + [(edges + 4, edges + 2)]
    readings: list[list[str | float]] = [
        [face_name(a, edges), face_name(b, edges), float(values[b] - values[a]), 0.004]
        for a, b in steps
    ]
    (tmp_path / "readings.csv").write_text(table_text(READING, readings))
    printed(*command, tmp_path / "readings.csv")
    found = coordinates(read_block(tmp_path / "o.json"))
    assert np.abs(np.diff(found - values)[: edges - 1]).max() < 0.05


def test_nothing_measured_is_refused(tmp_path: Path) -> None:
    draw_touched(6, tmp_path)
    said = refused("certificate", "block", "--drawing", tmp_path / "drawing.json")
    assert "neither readings nor points" in said
