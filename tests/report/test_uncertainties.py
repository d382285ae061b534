"""Every expanded uncertainty that is printed is the root of what is listed beside it."""

import json
import re
from itertools import groupby
from pathlib import Path

import numpy as np
import pypdfium2
import pytest
from pydantic import ValidationError

from crenel.gauges.plan.document_gauge import DEFAULT_LIMITS, GaugeFile, Shape
from crenel.gauges.quick.clouds.document import GaugeReport, SpreadReport
from crenel.gauges.quick.clouds.evaluate import verify_clouds
from crenel.gauges.quick.clouds.evaluate_tables import budget_table, report_table
from crenel.gauges.quick.document import FigurePart, VerificationFile, write_verification
from crenel.gauges.quick.evaluate import gauge_figures
from crenel.gauges.quick.evaluate_gauge import GaugeFit
from crenel.gauges.quick.maths.errors import NominalPlane, NominalSphere
from crenel.gauges.quick.maths.probed_gauge import ProbedGauge, ProbedPlane, ProbedSphere
from crenel.gauges.quick.report_tables import budget_sections, results_table
from crenel.messages.message import Quantity, Text, Unit
from crenel.messages.uncertainty import part_quantity, uncertainty_quantity
from crenel.report.content import ReportTable
from crenel.report.contents.reports import render_report
from tests.gauges.quick.test_study import RECORD
from tests.sources import ROOT, python_files

CASES = ROOT / "frontend/src/controls/uncertaintyCases.json"


def figures_of(shape: Shape, seed: int) -> tuple[FigurePart, ...]:
    """Of three clouds with any uncertainties of gauge, probe and points."""
    rng = np.random.default_rng(seed)

    def drawn() -> float:
        return float(10 ** rng.uniform(-1.5, 1.0))

    gauge = GaugeFile(
        shape=shape,
        radius_mm=None if shape == "plane" else 10.0,
        standard_uncertainty_um=drawn(),
        form_um=drawn(),
    )
    normal = np.array([0.6, 0.0, 0.8])
    touched: ProbedGauge = ProbedPlane(
        NominalPlane(np.zeros(3), normal),
        np.zeros(6),
        np.diag([1e-6, 1e-10, 1e-10]) * drawn(),
        np.zeros(6, np.bool_),
    )
    if shape == "sphere":
        touched = ProbedSphere(
            NominalSphere(np.zeros(3), 10.0),
            np.zeros(7),
            1e-6 * drawn() * np.eye(3),
            10.0,
            0.1,
            np.zeros(7, np.bool_),
        )
    fits = []
    for offset_mm in rng.normal(0.0, 0.01, 3).tolist():
        values: dict[str, object] = {
            "points": 1000,
            "used": 950,
            "frames": 60,
            "width_mm": 40.0,
            **{name: drawn() for name in ("rms_um", "form_um", "form_all_um", "range_all_um")},
            **{f"{name}_sd_um": drawn() for name in ("rms", "form", "form_all", "range_all")},
            "covariance": (np.diag([1e-6, 1e-10, 1e-10, 1e-6]) * drawn()).tolist(),
            "centre_mm": (offset_mm * normal).tolist(),
        }
        if shape == "plane":
            values |= {"normal": normal.tolist(), "offset_mm": offset_mm}
        else:
            values |= {"radius_mm": 10.0 + offset_mm}
        fits.append(GaugeFit.model_validate(values))
    return gauge_figures(fits, gauge, touched, DEFAULT_LIMITS)


def assert_root(whole: str, parts: list[str]) -> None:
    """To half a digit of the whole, and of each part, which has one digit more."""
    digit = 10.0 ** -len(whole.partition(".")[2])
    root = float(np.linalg.norm([float(part) for part in parts]))
    assert abs(float(whole) - root) <= 0.5 * digit + 0.1 * digit, (whole, parts)


def number(text: Text | None) -> str:
    assert isinstance(text, Quantity)
    return f"{text.value:.{text.decimals}f}"


@pytest.mark.parametrize("seed", range(3))
@pytest.mark.parametrize("shape", ["plane", "sphere"])
def test_a_report_lists_parts_of_uncertainties(tmp_path: Path, shape: Shape, seed: int) -> None:
    figures = figures_of(shape, seed)
    document = VerificationFile.model_validate({**RECORD, "figures": figures})
    write_verification(tmp_path, document)
    pdf = pypdfium2.PdfDocument(render_report(tmp_path, ".pdf"))
    printed = " ".join(page.get_textpage().get_text_range() for page in pdf)
    stated = [str(cell) for row in results_table(document).rows for cell in row[3:5]]
    ((table, _),) = (section.blocks for section in budget_sections(document))
    assert isinstance(table, ReportTable)
    spreads = sum(len(figure.spread) for figure in figures)
    assert len(table.rows) == len(figures) + spreads > 3 * 7
    for row in table.rows:
        parts = [number(cell) for cell in row[3:] if isinstance(cell, Quantity)]
        assert_root(number(row[2]), parts)
        assert all(re.search(rf"\b{one}\b", printed) for one in (number(row[2]), *parts))
    for figure, (measured, test) in zip(
        figures, zip(*[iter(stated)] * 2, strict=True), strict=True
    ):
        assert str(uncertainty_quantity(figure.expanded_uncertainty, figure.unit)) in measured
        assert figure.test_uncertainty == figure.budget["gauge"] < figure.expanded_uncertainty / 2
        assert str(uncertainty_quantity(2 * figure.budget["gauge"], figure.unit)) in test


def test_a_record_whose_uncertainty_is_not_its_root_is_refused() -> None:
    budget = {"gauge": 1.4, "points": 0.3}
    figure = {**RECORD["figures"][0], "budget": budget}
    spread = {"mean": 1.0, "standard_deviation": 0.1, "range": 0.2, "budget": {"mean": budget}}
    for part, fields in ((FigurePart, figure), (SpreadReport, spread)):
        with pytest.raises(ValidationError, match="root of the sum of squares"):
            part.model_validate(fields)


OWN_ROUNDING = re.compile(
    r"\b(?:quantity|rounded|micrometres|error_value|measured|signedLength)"
    r"\([^()]*(?:expanded|test|judging)_?[uU]ncertainty"
)


def test_expanded_uncertainties_are_rounded_in_one_place() -> None:
    texts = {path: path.read_text() for path in python_files("app/crenel")}
    texts |= {path: path.read_text() for path in (ROOT / "frontend/src").rglob("*.ts*")}
    assert not [path for path, text in texts.items() if OWN_ROUNDING.search(text)]


@pytest.mark.parametrize("one", json.loads(CASES.read_text()), ids=lambda one: str(one["value"]))
def test_an_uncertainty_is_rounded_as_in_the_browser(one: dict[str, str]) -> None:
    value, unit = float(one["value"]), one["unit"]
    whole: Unit = "µm" if unit == "µm" else "mm" if unit == "mm" else "″"
    assert number(uncertainty_quantity(value, whole)) == one["shown"]
    assert number(part_quantity(value, value, whole)) == one["part"]


@pytest.mark.parametrize("count", [1, 3])
@pytest.mark.parametrize("with_nominal", [False, True])
@pytest.mark.parametrize("shape", ["plane", "sphere"])
def test_it_prints_the_parts(tmp_path: Path, shape: Shape, with_nominal: bool, count: int) -> None:
    rng = np.random.default_rng(count)
    clouds = [tmp_path / f"{i}.xyz" for i in range(count)]
    for path in clouds:
        points = rng.normal(size=(800, 3))
        if shape == "plane":
            points = points * [20, 20, 0.01]
        else:
            points *= (10 + rng.normal(0, 0.01, (800, 1))) / np.linalg.norm(points, axis=1)[:, None]
        np.savetxt(path, points)
    place = (
        {"point_mm": [0, 0, 0], "normal": [0, 0, 1]}
        if shape == "plane"
        else {"centre_mm": [0, 0, 0], "radius_mm": 10}
    )
    nominal = tmp_path / "n.json"
    head = {"format": "crenel/nominal", "version": 1, "shape": shape}
    certified = {"standard_uncertainty_um": 0.4, "form_um": 1.3}
    nominal.write_text(json.dumps({**head, **place, **certified}))
    report, _ = verify_clouds(shape, clouds, nominal if with_nominal else None)
    assert GaugeReport.model_validate_json(report.model_dump_json()) == report
    _, rows = report_table(report)
    figures = [cell for row in rows for cell in row[3:]]
    assert len(rows) == (1 if count == 1 else count + 3)
    assert all(" ± " in cell for cell in figures)
    headings, budgets = budget_table(report)
    assert ("gauge" in headings) == with_nominal
    for row in budgets:
        assert_root(row[2], [cell for cell in row[3:] if cell])
    printed = [[cell.split(" ± ")[1] for cell in row[3:]] for row in rows]
    by_cloud = [[row[2] for row in part] for _, part in groupby(budgets, lambda row: row[0])]
    assert by_cloud == printed
