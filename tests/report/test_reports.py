"""Reports from folders alone: what they say, that they are safe, and the same bytes again."""

import html
import json
import re
import shutil
from collections.abc import Iterator, Mapping, Sequence
from dataclasses import fields, is_dataclass, replace
from pathlib import Path
from typing import Any

import numpy as np
import pypdfium2
import pytest
from reportlab.pdfbase.pdfmetrics import stringWidth
from typer.testing import CliRunner

from crenel.cli.main import cli
from crenel.errors import OperationError
from crenel.formats.json_document import SOFTWARE, file_sha256
from crenel.formats.results.acceptance import ACCEPTANCE, Acceptance, ComparisonPart
from crenel.formats.results.arm_checks import ARM_CHECK, TIP_CHECK, ArmCheckFile, TipCheckFile
from crenel.formats.results.calibration import CalibrationFile, Input
from crenel.formats.results.decision_rule import RulePart
from crenel.formats.session.arm_session import write_observations
from crenel.gauges.judgement.document import PerformanceFigure
from crenel.gauges.quick.document import FIGURE_TITLES, VerificationFile, write_verification
from crenel.gauges.quick.evaluate_deviation_maps import MAP, MapFile, OutlierPart
from crenel.gauges.quick.evaluate_gauge import filters_of
from crenel.gauges.quick.report_figures import LABELS
from crenel.gauges.quick.report_tables import results_table
from crenel.gauges.report.tables import limit_text, value_text
from crenel.messages.catalogue import renderer
from crenel.messages.language_file import languages
from crenel.messages.message import Message, Text, message, quantity
from crenel.metrology.arm.identification.observations import ArmObservations, Seat, Sphere
from crenel.metrology.decision import EXPANDED_K2, GUARDED_95, SIMPLE
from crenel.report.content import Pictures, Report, ReportTable, Section, TextBlock, Verdict
from crenel.report.contents import arm_check, tip_check
from crenel.report.contents.calibration import calibration_report
from crenel.report.contents.identification import BARS
from crenel.report.contents.reports import folder_report, render_report
from crenel.report.figure import Figure, magnification
from crenel.report.formatting import format_moment, in_both_units, join_units, limit_beside
from crenel.report.html import html_page
from crenel.report.pdf import pdf_document
from crenel.report.translation import translate_report
from crenel.workflows.calibrate import calibrate_session
from crenel.workflows.identify_arm import IdentificationProvenance, identify_folder
from crenel_hardware.simulator.session import SessionPlan, render_session
from tests.datasheets import write_arm
from tests.formats.builders import ARM, edit_text
from tests.formats.test_arm_identification import PLAN
from tests.gauges.quick.test_study import RECORD
from tests.present import present
from tests.simulated_arm_sessions import render_arm_session

pytestmark = pytest.mark.slow

TWO_WORDS = re.compile(r"\b[a-z]{2,}\b \b[a-z]{2,}\b")
DECIMAL_POINT = re.compile(r"(?<![\d.])\d+\.\d+ ?(?:µm|mm|px|°|″)")
SIMULATED = ("Drawn at random", "Simulated stripe sensor", "Simulated crenellated block")
"""Names in the session's datasheets."""
HOSTILE = '<script>alert(1)</script>"><img src=x onerror=alert(1)> & 井上'


def accept(folder: Path, operator: str) -> None:
    Acceptance(
        name="Calibration 1",
        accepted_at="2026-11-21T10:00:00+00:00",
        operator=operator,
        station="Room 2",
        calibration_sha256=file_sha256(folder / "calibration.json"),
        good_um=50,
        usable_um=150,
        rule=RulePart.of(EXPANDED_K2),
        temperature_c=20.4,
        compared=ComparisonPart(name="Calibration 0", rms_um=4.2, max_um=9.1),
    ).write(folder / ACCEPTANCE)


@pytest.fixture(scope="module")
def folder(tmp_path_factory: pytest.TempPathFactory) -> Path:
    """An accepted calibration of two poses."""
    path = tmp_path_factory.mktemp("reports") / "session-7"
    path.mkdir()
    render_session(path, 11, SessionPlan(contacts_per_face=9, poses=2))
    calibrate_session(path, path / "calibration.json")
    accept(path, "Anna")
    return path


def text_of(pdf: bytes) -> str:
    document = pypdfium2.PdfDocument(pdf)
    try:
        text = "\n".join(page.get_textpage().get_text_range() for page in document)
    finally:
        document.close()
    return " ".join(text.replace("\u00a0", " ").split())


def printed(folder: Path) -> str:
    return text_of(render_report(folder, ".pdf"))


def shown(folder: Path, language: str = "en") -> str:
    page = render_report(folder, ".html", language).decode()
    return html.unescape(page).replace("\u00a0", " ")


def assert_says(text: str, *said: str) -> None:
    """A text has all of these, which are given in rows, with a bar between them."""
    assert not [one for row in said for one in row.split(" | ") if one not in text]


def copied(folder: Path, copy: Path) -> Path:
    return Path(shutil.copytree(folder, copy))


def plain_texts(value: object) -> Iterator[str]:
    """Every string of a report's content, those within its messages too."""
    if isinstance(value, str):
        yield value
    elif is_dataclass(value):
        for field in fields(value):
            yield from plain_texts(getattr(value, field.name))
    elif isinstance(value, Mapping):
        for item in value.values():
            yield from plain_texts(item)
    elif isinstance(value, Sequence) and not isinstance(value, bytes):
        for item in value:
            yield from plain_texts(item)


def assert_german(folder: Path, *own: str) -> None:
    """A report has no prose that is not a message, but for a test's own words; no decimal point
    in German; and the same bytes again."""
    texts = list(plain_texts(folder_report(folder)))
    assert not [text for text in texts if TWO_WORDS.search(text) and text not in own]
    assert not DECIMAL_POINT.search(text_of(render_report(folder, ".pdf", "de")))
    for form in (".html", ".pdf"):
        assert render_report(folder, form, "de") == render_report(folder, form, "de")


def test_a_report_in_german(folder: Path, tmp_path: Path) -> None:
    assert_german(folder, *SIMULATED)
    written = tmp_path / "bericht.html"
    asked = ["report", str(folder), "-o", str(written), "--language", "de"]
    result = CliRunner().invoke(cli, asked)
    assert result.exit_code == 0, result.output
    page = html.unescape(written.read_text(encoding="utf-8"))
    assert_says(page, '<html lang="de"> | Kalibrierbericht | Bediener: Anna | Standardunsicherheit')
    assert "Kalibrierbericht" in text_of(render_report(folder, ".pdf", "de"))
    with pytest.raises(OperationError, match="no language 'xx'"):
        render_report(folder, ".pdf", "xx")


def test_a_calibrations_report_says_what_a_certificate_does(folder: Path) -> None:
    record = CalibrationFile.read(folder / "calibration.json")
    total_um = present(record.uncertainty).total_um
    page = shown(folder)
    for text in (page, printed(folder)):
        assert_says(
            text,
            "Anna | Room 2 | session-7 | 20.4 °C | 2026-11-21 10:00 UTC | Certificate | simulated",
            *record.serial_numbers.model_dump().values(),
            f"{total_um:.1f} µm | {total_um / 1e3:.4f} mm | {2 * total_um:.1f} µm | good ≤ 50 µm",
            f"ISO 14253-1:1998 | the guard band is {2 * total_um:.1f} µm",
            "Whoever has to prove something bears the uncertainty",
            "Calibration 0 | 4.2 µm | Operator: Anna | Approved",
            "Every file has the content that the result was computed from.",
        )
    assert all(one.sha256 in page and one.file in page for one in record.inputs)
    for finding in present(record.verdict).findings:
        assert isinstance(finding.text, Message)
        assert join_units(str(finding.text)).replace("\u00a0", " ") in page


def test_a_pose_without_its_laser_line_is_marked(folder: Path, tmp_path: Path) -> None:
    copy = copied(folder, tmp_path / "copy")
    calibration = json.loads((copy / "calibration.json").read_text())
    reason = "its laser line was excluded, 2 mm off the plane of the others"
    pose = calibration["poses"][0]
    pose.update(reason=reason, stripe_rms_px=0.0, stripe_points=0, stripe_off_px=[])
    (copy / "calibration.json").write_text(json.dumps(calibration))
    page = shown(copy)
    assert page.count(f"used, but {reason}") == 1
    assert page.count("no stripe. Edges") == 1
    assert ">0.000<" not in page
    assert_german(copy, reason, *SIMULATED)


def test_its_pictures_are_in_both_forms(folder: Path) -> None:
    page = render_report(folder, ".html").decode()
    titles = ["Residuals of the contact points on the object", "Error budget"]
    titles += [f"Residuals of pose {number} in its picture" for number in (0, 1)]
    for title in (*titles, "Uncertainty over the measuring volume"):
        assert f'aria-label="{title}"' in page
    assert page.count("data:image/jpeg;base64,") == 2
    document = pypdfium2.PdfDocument(render_report(folder, ".pdf"))
    kinds = [item.type for page in document for item in page.get_objects()]
    document.close()
    assert kinds.count(pypdfium2.raw.FPDF_PAGEOBJ_IMAGE) == 2


def test_the_same_folder_gives_the_same_bytes(folder: Path, tmp_path: Path) -> None:
    for name in ("report.pdf", "report.html"):
        result = CliRunner().invoke(cli, ["report", str(folder), "-o", str(tmp_path / name)])
        assert result.exit_code == 0, result.output
        assert (tmp_path / name).read_bytes() == render_report(folder, Path(name).suffix)


def test_a_page_needs_nothing_and_runs_nothing(folder: Path, tmp_path: Path) -> None:
    own = copied(folder, tmp_path / "hostile")
    accept(own, HOSTILE)
    for name in ("object.json", "arm.json", "sensor.json"):
        fields = json.loads((own / name).read_text())
        fields["name"] = fields["serial_number"] = HOSTILE
        (own / name).write_text(json.dumps(fields))
    page = render_report(own, ".html").decode()
    assert "<script" not in page
    assert "<img" not in page
    assert html.escape(HOSTILE) in page
    assert "http" not in page.replace("http-equiv", "")
    assert "default-src 'none'" in page
    # a face without these letters shows boxes, and nothing fails
    assert "<script>" in printed(own)


def test_changed_inputs_are_marked(folder: Path, tmp_path: Path) -> None:
    own = copied(folder, tmp_path / "changed")
    with open(own / "probing.csv", "a") as table:
        table.write("\n")
    assert "1 of these files differs from what the result was computed from" in shown(own)
    (own / ACCEPTANCE).unlink()
    assert "was not accepted at a station" in shown(own)


BY_BEN: dict[str, Any] = {
    "checked_at": "2026-11-21T07:30:00+00:00",
    "operator": "Ben",
    "arm_name": ARM.name,
    "arm_serial": ARM.serial_number,
    "limit_um": 60.0,
    "software": SOFTWARE,
}


def inputs_of(folder: Path, *names: str) -> list[Input]:
    return [Input(file=name, sha256=file_sha256(folder / name)) for name in names]


def test_an_arm_checks_report(tmp_path: Path) -> None:
    swing = np.random.default_rng(3).normal(0.2, 0.4, (40, 6))
    write_arm(tmp_path / "arm.json", ARM)
    write_observations(tmp_path, ArmObservations((Seat("Seat 1", swing),), (), ()))
    ArmCheckFile.model_validate(
        {
            **BY_BEN,
            "points": 40,
            "half_range_um": (20.0, 71.0, 30.0),
            "two_sigma_um": (15.0, 40.0, 20.0),
            "encoders_two_sigma_um": (10.0, 10.0, 10.0),
            "largest_um": 83.4,
            "two_s_um": 55.1,
            "verdict": "bad",
            "inputs": inputs_of(tmp_path, "arm.json", "articulation.csv"),
        }
    ).write(tmp_path / ARM_CHECK)
    assert_says(
        printed(tmp_path),
        "Beyond the limit | 71.0 µm | 0.0710 mm | 83.4 µm | 55.1 µm | ≤ 60 µm",
        "ILAC-G8 | Ben | Not according to a standard",
    )
    assert render_report(tmp_path, ".pdf") == render_report(tmp_path, ".pdf")
    assert_german(tmp_path, ARM.name)


def test_a_tip_checks_report(tmp_path: Path) -> None:
    touches = np.random.default_rng(5).normal(0.2, 0.3, (9, 6))
    write_arm(tmp_path / "arm.json", ARM)
    write_observations(tmp_path, ArmObservations((), (Sphere("Sphere 1", 25.0, touches),), ()))
    TipCheckFile.model_validate(
        {
            **BY_BEN,
            "sphere_mm": 25.0,
            "touches": 9,
            "diameter_mm": 5.9,
            "expected_mm": 6.0,
            "error_um": -100.0,
            "expanded_uncertainty_um": 20.0,
            "scatter_um": 12.0,
            "rule": RulePart.of(replace(GUARDED_95, bearer="user")),
            "decision": "fail",
            "words": "The tip is worn.",
            "inputs": inputs_of(tmp_path, "arm.json"),
        }
    ).write(tmp_path / TIP_CHECK)
    assert_says(
        printed(tmp_path),
        "Fail | The tip is worn. | −100.0 µm | ± 20.0 µm | 5.9000 mm | not stated",
        "The user bears the uncertainty",
    )
    assert_german(tmp_path, ARM.name, "The tip is worn.")


def test_an_identifications_report(tmp_path: Path) -> None:
    render_arm_session(tmp_path, 3, PLAN)
    identified = tmp_path / "identified.json"
    signature = IdentificationProvenance(
        operator="Ben", station="Room 2", simulated=True, temperature_c=21.5
    )
    record, _ = identify_folder(tmp_path, identified, signature=signature)
    assert_says(
        printed(tmp_path),
        f"Identified | Ben | Room 2 | 21.5 °C | {record.serial_number} | k = 1 | unchanged",
        "articulation.csv | ballbars.csv | Approved | a demonstration",
    )
    assert render_report(tmp_path, ".pdf") == render_report(tmp_path, ".pdf")
    assert_german(tmp_path, record.name, "Room 2")
    assert "1 in 4 Lagen" in text_of(render_report(tmp_path, ".pdf", "de"))
    edit_text(tmp_path / "articulation.csv", "\n", "\n\n")
    assert "changed" in printed(tmp_path)
    write_arm(identified, ARM)
    with pytest.raises(OperationError, match="contains no identification"):
        folder_report(tmp_path)


def test_a_verifications_report(tmp_path: Path) -> None:
    more = [{**RECORD["clouds"][0], "name": f"Cloud {n}"} for n in (1, 2)]
    write_verification(tmp_path, VerificationFile.model_validate({**RECORD, "clouds": more}))
    (tmp_path / "cloud-1").mkdir()
    residuals = MapFile(cell_mm=2, x_mm=(0, 2, 4), y_mm=(0, 0, 2), deviation_um=(5, -8, 1))
    ends = [
        {"x_mm": 1, "y_mm": y, "deviation_um": off, "at_mm": (0, 0, 0), "frame": 9, "points": 7}
        for y, off in ((0, 560.04), (2, -33.0))
    ]
    outliers = tuple(OutlierPart.model_validate({**end, "is_end": True}) for end in ends)
    residuals = residuals.model_copy(update={"outliers": outliers, "outlier_points": 14})
    residuals.write(tmp_path / "cloud-1" / MAP)
    assert_says(
        printed(tmp_path),
        "Pass | Radius error | −20.0 µm | ± 6.0 µm | Not according to a standard",
        # a record that does not state its rule is of before it did
        "acceptance with the expanded uncertainty (k = 2) as guard band",
        "14 points are further off than noise explains | −33.0 µm and +560.0 µm | −10 µm | +10 µm",
    )
    assert_says(
        html.unescape(render_report(tmp_path, ".html").decode()),
        "Verification on a gauge sphere | cloud by cloud | Residuals of Cloud 1 on the gauge",
    )
    assert_german(tmp_path, *plain_texts(RECORD))


def test_a_verifications_report_states_rule_uncertainties_and_filters(tmp_path: Path) -> None:
    cloud = {**RECORD["clouds"][0], "form_all_um": 130.5, "range_all_um": 410.5, "in_gate": 3990}
    budget = {"gauge": 0.4, "points": float(np.sqrt(3.0**2 - 0.4**2))}
    figure = {
        **RECORD["figures"][0],
        "test_uncertainty": 0.4,
        "judged_by": "test",
        "budget": budget,
    }
    rule = RulePart.of(replace(GUARDED_95, bearer="supplier"))
    values = {"clouds": [cloud], "figures": [figure], "filters": filters_of("sphere"), "rule": rule}
    document = VerificationFile.model_validate({**RECORD, **values})
    write_verification(tmp_path, document)
    text = printed(tmp_path)
    assert_says(
        text,
        "ISO 14253-1:2017 | 1.65 times the standard uncertainty | ± 6.0 µm | ± 0.8 µm *",
        "The supplier bears the uncertainty | 3 standard deviations | 130.5 | 410.5",
        "within 0.05 mm of an earlier one | within 3 mm of the calibrated sphere",
    )
    assert "as guard band" not in text
    simple = document.model_copy(update={"rule": RulePart.of(SIMPLE)})
    write_verification(tmp_path, simple)
    assert "ILAC-G8:09/2019. There is no guard band" in printed(tmp_path)
    assert_german(tmp_path, *plain_texts(RECORD))


def test_a_folder_without_a_record_has_no_report(tmp_path: Path) -> None:
    with pytest.raises(OperationError, match="contains no record"):
        render_report(tmp_path, ".pdf")
    with pytest.raises(OperationError, match="no such folder"):
        render_report(tmp_path / "nowhere", ".pdf")
    with pytest.raises(OperationError, match="cannot be written"):
        render_report(tmp_path, ".doc")


@pytest.mark.parametrize(("largest", "factor"), [(0.021, 200), (1.0, 5), (0.0, 1), (30.0, 0.1)])
def test_magnification_is_round(largest: float, factor: float) -> None:
    assert magnification(largest, 5.0) == pytest.approx(factor)


def test_words_are_printed_as_read() -> None:
    assert join_units("-3 µm at 20261121-2026") == "−3\u00a0µm at 20261121-2026"
    assert join_units("tip Ø 3 mm, ≤ 5 µm") == "tip\u00a0Ø\u00a03\u00a0mm, ≤\u00a05\u00a0µm"
    assert format_moment("2026-11-21T12:00:00+02:00") == "2026-11-21 10:00 UTC"
    assert format_moment("yesterday") == "yesterday"


@pytest.mark.parametrize("lines", range(24, 40, 2))
def test_a_title_is_not_left_behind_by_its_pictures(lines: int) -> None:
    """A row of pictures that finds no space below takes its title along to the next page."""
    picture = (Figure(100, 60, "A picture"), "What it shows")
    filling = Section("Before", [TextBlock("A line.")] * lines, together=False)
    pictures = Section("Pictures", [Pictures([picture])], together=False)
    verdict = Verdict("good", "Good", "")
    report = Report("Report", "1", "Room", "", verdict, [filling, pictures])
    document = pypdfium2.PdfDocument(pdf_document(report))
    pages = [page.get_textpage().get_text_range() for page in document]
    assert next("What it shows" in page for page in pages if "Pictures" in page)


FACE_FACTOR = 1.08
"""The report's own face is wider than the one that the tests measure with."""


@pytest.mark.parametrize("language", languages())
def test_titles_of_figures_and_before_bars_fit_in_every_language(language: str) -> None:
    render = renderer(language)

    def widest(*texts: Text, size: float) -> float:
        widths = [stringWidth(render(one), "Helvetica", size) for one in texts]
        return float(FACE_FACTOR * max(widths))

    assert widest(*FIGURE_TITLES.values(), size=7.5) < LABELS - 8
    titles = (message("lengths-ball-bars-held-out"), message("tip-over-whole-reach"))
    marks = (message("before-mark"), message("after-mark"))
    assert 2 + widest(*titles, size=8) + widest(*marks, size=7) < BARS - 6


def test_a_report_holds_data_and_is_rendered_once(folder: Path) -> None:
    report = calibration_report(folder)
    assert report.title == message("calibration-report")
    german = translate_report(report, "de")
    assert german.title == "Kalibrierbericht"
    assert german.language == "de"
    table = german.sections[1].blocks[0]
    assert isinstance(table, ReportTable)
    cells = [cell for row in table.rows for cell in row]
    assert all(isinstance(cell, str) for cell in cells)
    assert any(re.fullmatch(r"0,\d{4} mm", cell) for cell in cells)


def test_figures_and_axes_have_the_decimal_point_of_their_language() -> None:
    figure = Figure[Text](100, 60, message("tip"))
    figure.label((1, 2), quantity(-1.5, "µm", 1))
    pictures = Pictures[Text]([(figure, message("wide", wide=quantity(2.5, "mm", 1)))])
    sections = [Section[Text](message("results"), [pictures])]
    report = Report[Text]("Report", "1", "Room", "", Verdict("good", "Good", ""), sections)
    page = html.unescape(html_page(translate_report(report, "de")).decode())
    assert "−1,5\u00a0µm" in page
    assert "2,5\u00a0mm breit" in page


def tables_of(value: float, limit: float) -> Iterator[tuple[Text, Text]]:
    """A value and its limit as each table of a report prints them, in one row."""
    arm = ArmCheckFile.model_construct(
        **BY_BEN | {"limit_um": limit},
        largest_um=None,
        two_s_um=None,
        half_range_um=(value,) * 3,
        two_sigma_um=(1.0, 1.0, 1.0),
        encoders_two_sigma_um=(1.0, 1.0, 1.0),
    )
    rows = [arm_check._table(arm).rows[0]]
    tip = TipCheckFile.model_construct(
        **BY_BEN | {"limit_um": limit},
        expected_mm=6.0,
        diameter_mm=6.0,
        error_um=-value,
        scatter_um=value,
        expanded_uncertainty_um=1.0,
        bend_um=None,
    )
    rows += tip_check._table(tip).rows[2:4]
    figure = {**RECORD["figures"][0], "value": -value, "limit": limit}
    verified = VerificationFile.model_validate({**RECORD, "figures": [figure]})
    rows += results_table(verified).rows
    for row in rows:
        for shown in row[1:3]:
            yield (
                shown,
                next(cell for cell in row[::-1] if "µm" in str(cell) and "±" not in str(cell)),
            )
    for of in ("form_error", "location"):
        performed = PerformanceFigure.model_construct(quantity=of, value=value, limit=limit)
        yield value_text(performed), limit_text(performed)
    limits = limit_beside(value, limit, "µm")
    yield from ((one, limits) for one in in_both_units(value, [limit, 2 * limit]))


def test_a_value_in_a_table_never_seems_on_the_other_side_of_its_limit() -> None:
    rng = np.random.default_rng(4)
    for limit in (0.3, 7.0, 12.25, 60.0, 123.4, 1234.5):
        for off in (*rng.normal(0.0, 0.03, 20), *rng.normal(0.0, 3.0, 20), 0.0):
            value = max(limit + float(off), 0.01)
            for cells in tables_of(value, limit):
                shown, most = (number_in(cell) for cell in cells)
                assert np.sign(shown - most) == np.sign(value - limit), (value, limit, cells)


def number_in(cell: Text) -> float:
    """The size of what a cell says, in µm."""
    found = re.search(r"([\d.]+) (µm|mm)", str(cell))
    assert found is not None
    return round(float(found[1]) * (1000.0 if found[2] == "mm" else 1.0), 6)
