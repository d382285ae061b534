"""Digital certificates among a station's gauges: what they offer, and what is said of others."""

from pathlib import Path

import pytest

from app.errors import OperationError
from app.formats.datasheets.gauge import GaugeFile
from app.guide.common.datasheet_library import read_gauges
from app.guide.gauge.certificates import store_certificate
from tests.formats.certificates import DIAMETER, FORM, certificate, quantity, real

SPHERE = certificate(DIAMETER, FORM)
BARE = certificate(quantity("Diameter", real("25", "\\milli\\metre")))


def test_a_certificate_is_a_gauge_with_all_that_it_states(tmp_path: Path) -> None:
    assert store_certificate(tmp_path, "Kugel 25 (K-17).xml", SPHERE) == "Kugel-25-K-17"
    entry = read_gauges(tmp_path).known["Kugel-25-K-17"]
    gauge = entry.datasheet
    named = (gauge.name, gauge.serial_number, gauge.certificate)
    assert named == ("Ceramic sphere", "K-17", "4711-2026")
    assert gauge.valid_until == "2028-03-12"
    assert gauge.radius_mm == pytest.approx(12.5006)
    assert gauge.standard_uncertainty_um == pytest.approx(0.15)
    assert gauge.form_um == pytest.approx(0.08)
    assert gauge.form_sd_um == pytest.approx(0.025)


def test_a_certificate_without_uncertainty_is_listed_with_its_reason(tmp_path: Path) -> None:
    (tmp_path / "gauges").mkdir()
    (tmp_path / "gauges/bare.xml").write_text(BARE)
    gauges = read_gauges(tmp_path)
    assert not gauges.known
    assert not gauges.findings
    (refused,) = gauges.refused
    assert refused.id == "bare"
    assert "has no uncertainty" in str(refused.reason)
    assert str(refused.reason).count(". ") == 0


def test_no_file_is_replaced_and_the_same_certificate_is_kept_once(tmp_path: Path) -> None:
    assert store_certificate(tmp_path, "k.xml", SPHERE) == "k"
    assert store_certificate(tmp_path, "k.xml", SPHERE) == "k"
    assert store_certificate(tmp_path, "../k.xml", certificate(DIAMETER)) == "k-2"
    GaugeFile(shape="plane", name="plate").write(tmp_path / "gauges/plate.nominal.json")
    assert store_certificate(tmp_path, "plate.xml", SPHERE) == "plate-2"
    kept = {path.name for path in (tmp_path / "gauges").iterdir()}
    assert kept == {"k-2.xml", "k.xml", "plate-2.xml", "plate.nominal.json"}


def test_a_datasheet_counts_before_a_certificate_of_its_name(tmp_path: Path) -> None:
    store_certificate(tmp_path, "k.xml", SPHERE)
    GaugeFile(shape="sphere", radius_mm=10.0, name="own").write(tmp_path / "gauges/k.nominal.json")
    assert read_gauges(tmp_path).known["k"].datasheet.name == "own"


@pytest.mark.parametrize(
    "text", ["", "<a/>", "<!DOCTYPE a><a/>", SPHERE.replace("3.3.0", "2.1.0"), BARE]
)
def test_what_is_no_certificate_is_not_kept(tmp_path: Path, text: str) -> None:
    with pytest.raises(OperationError) as raised:
        store_certificate(tmp_path, "k.xml", text)
    assert "k.xml" in str(raised.value.what)
    assert not (tmp_path / "gauges").exists()
