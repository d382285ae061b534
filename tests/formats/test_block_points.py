"""A block's certificate from touches by a measuring machine or an arm: found, stated, refused."""

from collections.abc import Callable
from dataclasses import replace
from pathlib import Path

import numpy as np
import pytest

from crenel.errors import OperationError
from crenel.formats.certifying.block_certificate import BlockCertificate, certify_block
from crenel.formats.certifying.block_points import read_touching_arm
from crenel.formats.certifying.block_readings import face_name
from crenel.formats.csv_table import table_text
from crenel.formats.datasheets.target import ObjectFile
from crenel.metrology.calibration.observation_model import coordinates
from crenel.metrology.targets.block_readings import TIP, face_axis, outward
from crenel.metrology.targets.crenellated_block import Crenellated
from crenel.metrology.transforms import apply
from crenel.report.contents.block_certificate import block_certificate_report
from crenel.report.contents.reports import render
from crenel.timestamps import utc_now
from tests.bench.block_certificate import CertifiedBlock, certify, draw_touched, measure_block
from tests.formats.test_block_certificate import COLUMNS as READING_COLUMNS
from tests.formats.test_block_certificate import EDGES, Row, draw_made
from tests.metrology.builders import BLOCK, random_pose
from tests.uncertainty_ratio import ratio_of_rms

SD_MM, TIP_MM, TIP_SD_MM = 0.002, 3.0, 0.002
POINT = ("face", "x_mm", "y_mm", "z_mm", "standard_uncertainty_mm")
TIPS = (*POINT, "tip_diameter_mm", "tip_uncertainty_mm")
ON_FACE = 5


def touch_all(
    made: Crenellated, rng: np.random.Generator, tip_mm: float = 0.0, sd_mm: float = SD_MM
) -> list[Row]:
    """Touches of every face by a machine whose frame is anywhere."""
    T, values = random_pose(rng), coordinates(made)
    rows: list[Row] = []
    for face in range(EDGES + 5):
        for _ in range(ON_FACE):
            at = np.array([rng.uniform(-25, 21), rng.uniform(-11, 13), rng.uniform(0, 16)])
            side = outward(face, EDGES)
            at[face_axis(face, EDGES)] = values[face] + side * tip_mm / 2
            point = apply(T, at[None])[0] + rng.normal(0, sd_mm, 3)
            rows.append([face_name(face, EDGES), *map(float, point), SD_MM])
    return rows


def certify_points(
    folder: Path, rows: list[Row], columns: tuple[str, ...] = POINT, width: float | None = None
) -> BlockCertificate:
    drawing = ObjectFile.model_validate(
        replace(BLOCK, standard_uncertainty_mm=0.05), from_attributes=True
    )
    drawing.write(folder / "drawing.json")
    (folder / "points.csv").write_text(table_text(columns, rows))
    readings = None
    if width is not None:
        readings = folder / "readings.csv"
        row: Row = ["edge_1", f"edge_{EDGES}", width, 0.001, "micrometer", 0.0005]
        readings.write_text(table_text(READING_COLUMNS, [row]))
    return certify_block(folder / "drawing.json", readings, "by hand", folder / "points.csv")


@pytest.mark.parametrize("tip", ["compensated", "certified", "unknown"])
def test_the_edges_are_as_certain_as_stated(tmp_path: Path, tip: str) -> None:
    rng = np.random.default_rng(11)
    errors, claims = [], []
    for _ in range(20):
        made = draw_made(rng)
        tip_mm = 0.0 if tip == "compensated" else TIP_MM + rng.normal(0, TIP_SD_MM)
        rows = touch_all(made, rng, tip_mm)
        if tip == "compensated":
            found = certify_points(tmp_path, rows)
        elif tip == "certified":
            found = certify_points(tmp_path, [[*row, TIP_MM, TIP_SD_MM] for row in rows], TIPS)
        else:
            width = made.edges_x_mm[-1] - made.edges_x_mm[0] + rng.normal(0, 0.001)
            rows = [[*row, "unknown", TIP_SD_MM] for row in rows]
            found = certify_points(tmp_path, rows, TIPS, float(width))
            assert found.fit.tools[TIP][0] == pytest.approx(tip_mm, abs=0.01)
        off = (found.fit.coordinates_mm - coordinates(made))[:EDGES]
        errors.append(off - off.mean())
        claims.append(np.sqrt(np.diag(found.fit.covariance_mm2)[:EDGES]))
    observed, claimed = (float(np.sqrt(np.mean(np.square(one)))) for one in (errors, claims))
    # the edges of one block share the tip's error
    ratio_of_rms(claimed, observed, 40).assert_within(0.9, 1.1)


def test_scatter_beyond_what_is_stated_counts_and_form_is_shown(tmp_path: Path) -> None:
    rng = np.random.default_rng(12)
    found = certify_points(tmp_path, touch_all(draw_made(rng), rng, sd_mm=4 * SD_MM))
    touched = found.fit.touched
    assert touched is not None
    assert 2.5 < touched.variance_factor**0.5 < 6
    assert len(touched.forms) == EDGES + 5
    assert all(one.flatness_mm and 0 < one.flatness_mm < 0.05 for one in touched.forms)
    page = render(block_certificate_report(found, utc_now()), ".html", "en").decode()
    assert "Flatness" in page
    assert "touches scatter" in page
    assert "Ebenheit" in render(block_certificate_report(found, utc_now()), ".html", "de").decode()


def _exchange(rows: list[Row]) -> None:
    rows[6][0], rows[12][0] = rows[12][0], rows[6][0]


def _exchange_faces(rows: list[Row]) -> None:
    for row in rows:
        row[0] = {"edge_2": "edge_6", "edge_6": "edge_2"}.get(str(row[0]), row[0])


def _relabel(rows: list[Row]) -> None:
    rows[6][0] = "edge_4"


def _mirror(rows: list[Row]) -> None:
    for row in rows:
        row[1] = -float(row[1])


def _scale(by: float) -> Callable[[list[Row]], None]:
    def spoil(rows: list[Row]) -> None:
        for row in rows:
            row[1:4] = [float(value) * by for value in row[1:4]]

    return spoil


def _slip(rows: list[Row]) -> None:
    rows[7][1:4] = [float(value) + 0.05 for value in rows[7][1:4]]


def _drop_base(rows: list[Row]) -> None:
    rows[:] = [row for row in rows if row[0] != "base"]


def _only_ends(rows: list[Row]) -> None:
    rows[:] = [row for row in rows if str(row[0]).startswith("edge")]


@pytest.mark.parametrize(
    ("spoil", "code", "said"),
    [
        (_exchange, "touches-exchanged", r"line 8 \(edge_3\) and .*line 14 \(edge_2\)"),
        (_exchange_faces, "touches-exchanged", "names of edge_2 and edge_6"),
        (_relabel, "touch-on-other-face", r"line 8: .* beside edge_4: it lies on edge_2"),
        (_mirror, "touches-mirrored", "mirror image"),
        (_scale(1 / 25.4), "touches-in-other-unit", "if they are in inch.*by 25.4"),
        (_scale(1e-3), "touches-in-other-unit", "if they are in m.*by 1000"),
        (_slip, "readings-contradict", r"line 9 \(edge_2\)"),
        (_drop_base, "readings-incomplete", "reaches base"),
        (_only_ends, "readings-incomplete", "back, floor, base"),
        (lambda rows: rows.__delitem__(slice(0, 3)), "face-touched-too-seldom", "edge_1 .* 2 "),
        (lambda rows: rows[0].__setitem__(0, "edge_99"), "reading-of-unknown-face", "line 2"),
        (lambda rows: rows[4].__setitem__(4, 0), "reading-uncertainty", "line 6"),
        (lambda rows: rows[4].__setitem__(2, "1,5"), "cell-not-a-number", "line 6"),
    ],
)
def test_touches_that_cannot_be_are_refused_by_name(
    tmp_path: Path, spoil: Callable[[list[Row]], None], code: str, said: str
) -> None:
    rng = np.random.default_rng(13)
    rows = touch_all(draw_made(rng), rng)
    spoil(rows)
    with pytest.raises(OperationError, match=said) as refused:
        certify_points(tmp_path, rows)
    assert refused.value.code == code


def test_an_unknown_tip_needs_a_width_by_another_tool(tmp_path: Path) -> None:
    rng = np.random.default_rng(14)
    rows = touch_all(draw_made(rng), rng, TIP_MM)
    with pytest.raises(OperationError, match=r"shows the diameter of the tip.*micrometer"):
        certify_points(tmp_path, [[*row, "unknown", 0.002] for row in rows], TIPS)
    with pytest.raises(OperationError, match=r"line 2: the tip's diameter has no uncertainty"):
        certify_points(tmp_path, [[*row, TIP_MM] for row in rows], TIPS[:-1])


def test_directions_into_the_block_are_refused(tmp_path: Path) -> None:
    rng = np.random.default_rng(15)
    rows = touch_all(draw_made(rng), rng)
    fit = certify_points(tmp_path, rows).fit
    assert fit.touched is not None
    T = fit.touched.T_obj_machine
    columns = (*POINT, "i", "j", "k")
    out = [
        T[face_axis(face, EDGES), :3] * outward(face, EDGES)
        for face in range(EDGES + 5)
        for _ in range(ON_FACE)
    ]

    def directed() -> list[Row]:
        return [[*row, *map(float, n)] for row, n in zip(rows, out, strict=True)]

    certify_points(tmp_path, directed(), columns)
    out[3] = -out[3]
    with pytest.raises(OperationError, match=r"line 5: the direction .* into the block at edge_1"):
        certify_points(tmp_path, directed(), columns)


def test_what_a_posture_shares_is_not_averaged_away(tmp_path: Path) -> None:
    rng = np.random.default_rng(16)
    rows = touch_all(draw_made(rng), rng)
    alone = certify_points(tmp_path, rows).fit.sds_mm
    columns = (*POINT, "posture", "posture_uncertainty_mm")
    together = certify_points(tmp_path, [[*row, "one", 0.02] for row in rows], columns).fit.sds_mm
    # one shift of the whole block is no error
    assert together == pytest.approx(alone, rel=0.01)
    each = certify_points(tmp_path, [[*row, row[0], 0.02] for row in rows], columns).fit.sds_mm
    assert min(each[:EDGES]) > 0.015


def test_an_arm_names_exchanged_touches_and_states_its_links(tmp_path: Path) -> None:
    found = measure_block(7)
    assert isinstance(found, CertifiedBlock)
    assert found.exchanged == "named"
    touched = draw_touched(6, tmp_path)
    few = certify(touched, touched.q_deg, tmp_path).fit
    exact = replace(touched.by, error_mm=1e-6)
    sure = certify(replace(touched, by=exact), touched.q_deg, tmp_path).fit
    assert few.sds_mm.max() > sure.sds_mm.max()


def test_a_budget_is_asked_where_the_arm_states_none(tmp_path: Path) -> None:
    draw_touched(6, tmp_path)
    with pytest.raises(OperationError, match=r"does not state the arm's error.*--arm-um"):
        read_touching_arm(tmp_path / "arm.json")
