"""Digital certificates among a station's gauges: what they offer, and what is said of others."""

from pathlib import Path

import pytest

from app.formats.datasheets.gauge import GaugeFile
from app.guide.common.datasheet_library import read_gauges
from tests.formats.certificates import DIAMETER, FORM, certificate, quantity, real

SPHERE = certificate(DIAMETER, FORM)
BARE = certificate(quantity("Diameter", real("25", "\\milli\\metre")))


def folder_with(data: Path, **certificates: str) -> Path:
    """A data folder with these certificates of gauges."""
    (data / "gauges").mkdir()
    for name, text in certificates.items():
        (data / f"gauges/{name}.xml").write_text(text)
    return data


def test_a_certificate_is_a_gauge_with_all_that_it_states(tmp_path: Path) -> None:
    entry = read_gauges(folder_with(tmp_path, k=SPHERE)).known["k"]
    gauge = entry.datasheet
    named = (gauge.name, gauge.serial_number, gauge.certificate)
    assert named == ("Ceramic sphere", "K-17", "4711-2026")
    assert gauge.valid_until == "2028-03-12"
    assert gauge.radius_mm == pytest.approx(12.5006)
    assert gauge.standard_uncertainty_um == pytest.approx(0.15)
    assert gauge.form_um == pytest.approx(0.08)
    assert gauge.form_sd_um == pytest.approx(0.025)


def test_a_certificate_without_uncertainty_is_listed_with_its_reason(tmp_path: Path) -> None:
    gauges = read_gauges(folder_with(tmp_path, bare=BARE))
    assert not gauges.known
    assert not gauges.findings
    (refused,) = gauges.refused
    assert refused.id == "bare"
    assert "has no uncertainty" in str(refused.reason)
    assert str(refused.reason).count(". ") == 0


def test_a_datasheet_counts_before_a_certificate_of_its_name(tmp_path: Path) -> None:
    folder_with(tmp_path, k=SPHERE)
    GaugeFile(shape="sphere", radius_mm=10.0, name="own").write(tmp_path / "gauges/k.nominal.json")
    assert read_gauges(tmp_path).known["k"].datasheet.name == "own"
