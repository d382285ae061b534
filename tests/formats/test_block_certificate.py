"""A block's certificate from readings of its faces: found, stated, and refused."""

from collections.abc import Callable
from dataclasses import replace
from pathlib import Path

import numpy as np
import pytest

from crenel.errors import OperationError
from crenel.formats.certifying.block_certificate import BlockCertificate, certify_block
from crenel.formats.certifying.block_readings import face_name
from crenel.formats.csv_table import table_text
from crenel.formats.datasheets.target import ObjectFile, read_block
from crenel.metrology.calibration.observation_model import coordinates, with_coordinates
from crenel.metrology.targets.block_readings import TIP, tool_sense
from crenel.metrology.targets.crenellated_block import Crenellated
from crenel.report.contents.block_certificate import block_certificate_report
from crenel.report.contents.reports import render
from crenel.timestamps import utc_now
from tests.metrology.builders import BLOCK
from tests.uncertainty_ratio import ratio_of_rms

EDGES = len(BLOCK.edges_x_mm)
FRONT, BACK, CREST, FLOOR, BASE = range(EDGES, EDGES + 5)
NEXT = [(i, i + 1) for i in range(EDGES - 1)]
FROM_LEFT = [(0, i) for i in range(2, EDGES)]
OTHERS = [(FRONT, BACK)] * 3 + [(FLOOR, CREST), (BASE, CREST), (BASE, FLOOR), (BASE, CREST)]
PAIRS = [*NEXT, *FROM_LEFT, *OTHERS]
COLUMNS = ("from", "to", "distance_mm", "standard_uncertainty_mm", "tool", "tool_uncertainty_mm")
SD_MM, ZERO_SD_MM, TIP_MM = 0.004, 0.006, 3.017
Row = list[str | float]


def read_all(made: Crenellated, rng: np.random.Generator, tool: str) -> list[Row]:
    """A reading of every pair, by a calliper with a zero error or by a tip."""
    values = coordinates(made)
    zero_mm = TIP_MM if tool == TIP else rng.normal(0, ZERO_SD_MM)
    rows: list[Row] = []
    for first, second in PAIRS:
        read = values[second] - values[first] + tool_sense(first, second, EDGES) * zero_mm
        names = face_name(first, EDGES), face_name(second, EDGES)
        rows.append([*names, float(read + rng.normal(0, SD_MM)), SD_MM, tool, ZERO_SD_MM])
    return rows


def draw_made(rng: np.random.Generator) -> Crenellated:
    off = rng.uniform(-0.2, 0.2, EDGES + 5)
    return with_coordinates(BLOCK, coordinates(BLOCK) + off)


def certify(folder: Path, rows: list[Row], columns: tuple[str, ...] = COLUMNS) -> BlockCertificate:
    drawing = ObjectFile.model_validate(
        replace(BLOCK, standard_uncertainty_mm=0.05), from_attributes=True
    )
    drawing.write(folder / "drawing.json")
    (folder / "readings.csv").write_text(table_text(columns, rows))
    return certify_block(folder / "drawing.json", folder / "readings.csv", "by hand")


@pytest.mark.parametrize("tool", ["calliper", TIP])
def test_the_edges_are_as_certain_as_stated(tmp_path: Path, tool: str) -> None:
    rng = np.random.default_rng(5)
    errors, claims = [], []
    for _ in range(40):
        made = draw_made(rng)
        rows = read_all(made, rng, tool)
        if tool == TIP:
            width = made.edges_x_mm[-1] - made.edges_x_mm[0] + rng.normal(0, SD_MM)
            rows.append(["edge_1", f"edge_{EDGES}", float(width), SD_MM, "", 0])
        found = certify(tmp_path, rows)
        true, fit = coordinates(made), found.fit
        off = (fit.coordinates_mm - true)[:EDGES]
        errors.append(off - off.mean())
        claims.append(np.sqrt(np.diag(fit.covariance_mm2)[:EDGES]))
    observed, claimed = (float(np.sqrt(np.mean(np.square(one)))) for one in (errors, claims))
    # the edges of one block share the tool's error
    ratio_of_rms(claimed, observed, 80).assert_within(0.9, 1.1)
    if tool == TIP:
        assert found.fit.tools[TIP][0] == pytest.approx(TIP_MM, abs=0.02)


def test_the_certificate_is_an_object_and_a_page(tmp_path: Path) -> None:
    rng = np.random.default_rng(6)
    made = draw_made(rng)
    found = certify(tmp_path, read_all(made, rng, "calliper"))
    found.document.write(tmp_path / "object.json")
    block = read_block(tmp_path / "object.json")
    assert max(block.sds_mm) == pytest.approx(block.standard_uncertainty_mm)
    assert len(set(block.sds_mm)) > 3
    widths = np.diff(block.edges_x_mm) - np.diff(made.edges_x_mm)
    assert np.abs(widths).max() < 0.03
    for language in ("en", "de"):
        page = render(block_certificate_report(found, utc_now()), ".html", language).decode()
        assert "edge_1" in page
        assert "by hand" in page
    assert render(block_certificate_report(found, utc_now()), ".pdf").startswith(b"%PDF")


def _exchange(rows: list[Row]) -> None:
    rows[1][2], rows[2][2] = rows[2][2], rows[1][2]


def _exchange_far(rows: list[Row]) -> None:
    rows[1][2], rows[8][2] = rows[8][2], rows[1][2]


def _exchange_unchecked(rows: list[Row]) -> None:
    """Of two neighbours whose sum alone is read: only the drawing tells."""
    rows[:] = [row for row in rows if row[0] != "edge_1" or row[1] in ("edge_2", "edge_8")]
    rows[5][2], rows[6][2] = rows[6][2], rows[5][2]


def _spoil_one(rows: list[Row]) -> None:
    rows[9][2] = float(rows[9][2]) + 0.08


def _drop_edge(rows: list[Row]) -> None:
    rows[:] = [row for row in rows if "edge_5" not in row[:2]]


def _inches(rows: list[Row]) -> None:
    for row in rows:
        row[2] = float(row[2]) / 25.4


def _decimal_comma(rows: list[Row]) -> None:
    rows[3][2] = f"{rows[3][2]:.3f}".replace(".", ",")


@pytest.mark.parametrize(
    ("spoil", "said"),
    [
        (_exchange, r"agree if those of reading 2 \(edge_2 to edge_3\) and reading 3"),
        (_exchange_unchecked, r"reading 6 .* and reading 7 \(edge_7 to edge_8\) are exchanged"),
        (
            _exchange_far,
            r"agree if those of reading 2 \(edge_2 to edge_3\) and reading 9 .* are exchanged",
        ),
        (_spoil_one, r"contradicts the others: reading 10 .* [+]?[789]\d µm"),
        (_drop_edge, "reaches edge_5"),
        (_inches, r"reading 1 .* and the following: 20 readings .* inches"),
        (_decimal_comma, "line 5: column distance_mm .*decimal point"),
        (lambda rows: rows[0].__setitem__(0, "edge_99"), "line 2: column from is 'edge_99'"),
        (lambda rows: rows[0].__setitem__(1, "crest"), "line 2: .*not two parallel faces"),
        (
            lambda rows: rows[4].__setitem__(2, 700.0),
            r"reading 5 \(edge_5 to edge_6\): 700.000 mm was read where",
        ),
        (lambda rows: rows[4].__setitem__(3, 0), "line 6: column standard_uncertainty_mm"),
    ],
)
def test_readings_that_cannot_be_are_refused_by_name(
    tmp_path: Path, spoil: Callable[[list[Row]], None], said: str
) -> None:
    rng = np.random.default_rng(7)
    rows = read_all(draw_made(rng), rng, "calliper")
    spoil(rows)
    with pytest.raises(OperationError, match=said):
        certify(tmp_path, rows)


def test_a_tip_alone_is_refused(tmp_path: Path) -> None:
    rng = np.random.default_rng(8)
    with pytest.raises(OperationError, match=r"shows the diameter of the tip.*micrometer"):
        certify(tmp_path, read_all(draw_made(rng), rng, TIP))
