"""Reports of performance tests: what they say and draw, in every language, byte for byte."""

from pathlib import Path

import numpy as np
import pytest
from reportlab.pdfbase.pdfmetrics import stringWidth

from crenel.gauges.exchange.export import NAMES, export_result
from crenel.gauges.exchange.write_certificate import Issuer
from crenel.gauges.kinds import write_performance
from crenel.gauges.plan.document import RESULT, LimitPart
from crenel.gauges.plan.document_symbols import TITLES
from crenel.gauges.report.contents import performance_report
from crenel.gauges.report.figures import LABELS, bars_figure, lengths_figure
from crenel.gauges.sphere.maths_location import location_error_mm
from crenel.gauges.sphere.maths_pattern import pattern_directions
from crenel.gauges.sphere.report_figures import (
    centres_figure,
    hemisphere_figure,
    offset_figure,
    pattern_places,
)
from crenel.messages.catalogue import renderer
from crenel.messages.language_file import languages
from crenel.report.content import Pictures
from crenel.report.contents.reports import render_report
from crenel.report.figure import Dot, Label
from crenel.report.pdf_figure import PLAIN
from tests.bench.metrology.synthetic_sphere import Faults, SphereSession
from tests.gauges.judgement.results import (
    BUILDERS,
    STATUS,
    Build,
    contact_result,
    lengths_result,
    sphere_result,
)
from tests.report.test_reports import assert_german, text_of

pytestmark = pytest.mark.slow

OWN = (STATUS, "See the figures.", "Patch 17 has no points.", "The probe matrix is off.")


@pytest.mark.parametrize("build", BUILDERS)
def test_a_report_names_every_figure_and_every_file(tmp_path: Path, build: Build) -> None:
    document = build(tmp_path / "test-1")
    text = printed(tmp_path / "test-1")
    together = text.replace(" ", "")
    assert STATUS in text
    for figure in document.figures:
        assert figure.symbol.replace(" ", "") in together
        for group in figure.data[:: max(len(figure.data) - 1, 1) if len(figure.data) > 40 else 1]:
            assert group in together
    for one in document.inputs:
        assert one.sha256 in together
    assert "ISO 14253-1:2017" in text
    if document.temperatures is not None:
        assert "artefact 20.2 to 20.7 °C" in text
        assert "arm 21.3 to 21.9 °C" in text
    assert "What the figures mean" in text


@pytest.mark.parametrize("build", BUILDERS)
def test_a_report_is_translated_and_the_same_again(tmp_path: Path, build: Build) -> None:
    document = build(tmp_path)
    names = [document.sphere, document.length, document.plate]
    own = [text for one in names if one is not None for text in (one.name, one.certificate)]
    assert_german(tmp_path, *OWN, *own, "Points seen once are kept.", "All kept.", "Room 2")


def printed(folder: Path) -> str:
    return text_of(render_report(folder, ".pdf"))


def test_values_limits_and_uncertainties_are_those_of_the_file(tmp_path: Path) -> None:
    document = sphere_result(tmp_path)
    text = printed(tmp_path)
    figures = {one.quantity: one for one in document.figures}
    location, size = figures["location-scan"], figures["size-scan"]
    assert f"{location.value:.1f} µm ≤ 80 µm ± 1.1 µm fail" in text
    assert f"{size.value:.1f} µm".replace("-", "−") + " ± 40 µm" in text
    assert "within 10 mm of the surface" in text
    assert "Ceramic sphere 25" in text
    assert "Patch 17 has no points." in text


def test_a_laboratory_with_the_standards_has_no_status_line(tmp_path: Path) -> None:
    document = sphere_result(tmp_path)
    document.model_copy(update={"status": ""}).write(tmp_path / RESULT)
    assert STATUS not in printed(tmp_path)


def test_a_changed_scan_is_named(tmp_path: Path) -> None:
    sphere_result(tmp_path)
    assert "cannot be traced" not in printed(tmp_path)
    (tmp_path / "p1-a3" / "scan.mcap").write_bytes(b"other")
    assert " changed " in printed(tmp_path)


def test_places_are_drawn_where_the_pattern_has_them() -> None:
    pole = np.array([0.0, 0.0, 1.0])
    directions = pattern_directions(pole)
    places = np.array(pattern_places())
    assert len(places) == len(directions) == 25
    tilts_deg = np.degrees(np.arccos(np.clip(directions @ pole, -1, 1)))
    assert np.linalg.norm(places, axis=1) * 90 == pytest.approx(tilts_deg, abs=1e-9)
    # turned by one angle for all: neighbours stay neighbours
    turns = np.arctan2(places[1:, 1], places[1:, 0])
    turns -= np.arctan2(directions[1:, 1], directions[1:, 0])
    assert np.exp(1j * turns) == pytest.approx(np.full(24, np.exp(1j * turns[0])), abs=1e-9)


def test_a_place_without_a_touch_is_an_open_dot() -> None:
    figure, _ = hemisphere_figure([None, *[2.0] * 24], "touched")
    labels = [one.text for one in figure.items if isinstance(one, Label)]
    assert len(labels) == 24
    assert sum(one.stroke == "#c8232a" for one in figure.items if isinstance(one, Dot)) == 1


def test_the_drawn_sphere_is_the_location_error(tmp_path: Path) -> None:
    centres = sphere_result(tmp_path).spheres[0].scan_centres_mm
    figure, caption = centres_figure(centres, "scanned")
    error_mm = location_error_mm(np.array(centres))
    sphere = max((one for one in figure.items if isinstance(one, Dot)), key=lambda one: one.radius)
    factor = sphere.radius / (error_mm / 2)
    assert factor == pytest.approx(1000)
    said = renderer("en")(caption)
    assert f"{1e3 * error_mm:.1f}" in said
    assert "Open dots" not in said


def test_where_no_location_is_stated_no_sphere_about_the_centres_is_drawn(tmp_path: Path) -> None:
    drawn = "Location over the articulations"
    sphere_result(tmp_path / "a")
    assert drawn in printed(tmp_path / "a")
    moved = Faults(articulations=0, touch_sd_mm=0.003, moved_mm=(0.1, 0.0, 0.0))
    folder = SphereSession(tmp_path / "b", moved).write()
    write_performance(folder)
    text = printed(folder)
    assert "Sphere or arm moved by" in text
    assert drawn not in text


def test_the_implied_error_is_drawn_with_its_direction(tmp_path: Path) -> None:
    offset = sphere_result(tmp_path).offset
    assert offset is not None
    figure, caption = offset_figure(offset)
    text = renderer("en")
    values = [text(one.text) for one in figure.items if isinstance(one, Label)]
    assert [one for one in values if one.startswith("+48.4")]
    assert "calibrate the sensor again" in text(caption)


def test_lengths_beyond_their_limit_are_red_and_named(tmp_path: Path) -> None:
    lengths = lengths_result(tmp_path).lengths
    figure, _ = lengths_figure(lengths)
    outside = [one for one in lengths if one.limit_um and abs(one.error_um) > one.limit_um]
    red = [one for one in figure.items if isinstance(one, Dot) and one.fill == "#c8232a"]
    assert len(lengths) == 105
    assert len(red) == len(outside) == 5
    named = [one.text for one in figure.items if isinstance(one, Label) and one.colour == "#c8232a"]
    assert named == ["4"] * 5


def test_every_placement_has_a_bar(tmp_path: Path) -> None:
    volumetric = contact_result(tmp_path).figures[3]
    figure, _ = bars_figure(volumetric)
    filled = [one for one in figure.items if getattr(one, "fill", "") == "#1d5bd0"]
    assert len(filled) == len(volumetric.values) == 20


@pytest.mark.parametrize("build", BUILDERS)
def test_every_test_has_a_figure_without_limits_too(tmp_path: Path, build: Build) -> None:
    document = build(tmp_path)
    plain = [one.model_copy(update={"limit": None, "decision": "none"}) for one in document.figures]
    (tmp_path / RESULT).unlink()
    document.model_copy(update={"figures": tuple(plain)}).write(tmp_path / RESULT)
    drawn = performance_report(tmp_path).sections
    assert any(isinstance(block, Pictures) for section in drawn for block in section.blocks)


@pytest.mark.parametrize("language", sorted(languages()))
def test_the_titles_have_room_beside_the_limits(tmp_path: Path, language: str) -> None:
    contact_result(tmp_path)
    render_report(tmp_path, ".pdf")  # registers the fonts
    render = renderer(language)
    for title in TITLES.values():
        assert stringWidth(render(title), PLAIN, 7.5) < LABELS - 8, render(title)


def test_a_test_from_touches_and_recordings_is_reported_and_exported(tmp_path: Path) -> None:
    """Every number from the files of a test, with a probe matrix that is 50 µm off."""
    faults = Faults(touch_sd_mm=0.003, point_sd_mm=0.008, matrix_offset_mm=(0.05, 0.0, 0.0))
    limits = (LimitPart(quantity="location-scan", a_um=60.0),)
    folder = SphereSession(tmp_path / "test", faults, limits=limits).write()
    document = write_performance(folder)
    text = printed(folder)
    location = next(one for one in document.figures if one.quantity == "location-scan")
    assert f"{location.value:.1f} µm ≤ 60 µm" in text
    assert "calibrate the sensor again" in text
    assert "+50." in text
    assert "unchanged" in text
    assert "cannot be traced" not in text
    for form in NAMES:
        written, _ = export_result(document, form, tmp_path / form, Issuer("Lab", "DE"))
        assert all(path.stat().st_size for path in written)
