"""``crenel performance export`` and ``crenel certificate``."""

from pathlib import Path

import pytest

from crenel.gauges.plan.document_gauge import read_gauge
from crenel.gauges.plan.document_length_standard import read_length_standard
from tests.cli.test_cli import crenel, done, printed
from tests.gauges.exchange.certificates import DIAMETER, FORM, certificate, expanded, quantity, real
from tests.gauges.judgement.results import sphere_result


def failed(*arguments: object) -> str:
    result = crenel(*arguments)
    assert result.exit_code == 1, result.output
    return result.output


@pytest.fixture
def judged(tmp_path: Path) -> Path:
    sphere_result(tmp_path / "test")
    return tmp_path / "test"


@pytest.mark.parametrize("form", ["csv", "xlsx", "qif", "dcc"])
def test_a_test_is_exported(tmp_path: Path, judged: Path, form: str) -> None:
    output = tmp_path / "result"
    export = ("performance", "export", judged, "--format", form)
    said = done(*export, "-o", output, "--country", "DE").output
    assert output.is_dir() == (form == "csv")
    assert f"{output}" in said
    assert ("not validated" in said) == (form in ("qif", "dcc"))


def test_a_certificate_without_a_country_is_refused(tmp_path: Path, judged: Path) -> None:
    assert "--country" in failed("certificate", "write", judged, "-o", tmp_path / "c.xml")
    assert not (tmp_path / "c.xml").exists()


def test_a_certificate_is_written_for_a_customer(tmp_path: Path, judged: Path) -> None:
    arguments = ["--laboratory", "Lab", "--country", "CH", "--customer", "Someone"]
    output = tmp_path / "c.xml"
    done("certificate", "write", judged, "-o", output, *arguments)
    assert "Someone" in output.read_text("utf-8")


@pytest.mark.parametrize("command", ["export", "write"])
def test_a_certificate_is_checked_by_a_schema(tmp_path: Path, judged: Path, command: str) -> None:
    pytest.importorskip("lxml")
    schema, output = tmp_path / "dcc.xsd", tmp_path / "c.xml"
    schema.write_text(
        '<xs:schema xmlns:xs="http://www.w3.org/2001/XMLSchema" targetNamespace="https://ptb.de/dcc">'
        '<xs:element name="digitalCalibrationCertificate"/></xs:schema>',
        encoding="utf-8",
    )
    form = ["performance", "export", "--format", "dcc"]
    start = form if command == "export" else ["certificate", "write"]
    arguments = [*start, judged, "-o", output, "--country", "DE"]
    said = done(*arguments, "--schema", schema).output
    assert f"written, valid by {schema}" in said
    assert "not signed" in said
    assert "not validated" not in said
    schema.write_text(schema.read_text("utf-8").replace("digital", "other"), encoding="utf-8")
    output.unlink()
    said = failed(*arguments, "--schema", schema)
    assert "line 2: Element 'digitalCalibrationCertificate'" in said
    assert not output.exists()


def test_a_certificate_is_read(tmp_path: Path) -> None:
    path, gauge = tmp_path / "sphere.xml", tmp_path / "sphere.nominal.json"
    path.write_text(certificate(DIAMETER, FORM), encoding="utf-8")
    said = done("certificate", "read", path, "-o", gauge).output
    assert "25.00120 mm ± 0.60 µm" in said
    assert "expansion_per_c" in said
    assert read_gauge(gauge).certificate == "4711-2026"
    assert printed("certificate", "read", path)["diameter_mm"] == 25.0012


def test_the_certificate_read_is_not_replaced(tmp_path: Path) -> None:
    path = tmp_path / "sphere.xml"
    path.write_text(certificate(DIAMETER, FORM), encoding="utf-8")
    failed("certificate", "read", path, "-o", path)
    assert path.read_text("utf-8").startswith("<?xml")


def test_the_certificate_of_a_ball_bar_is_read(tmp_path: Path) -> None:
    path, bar = tmp_path / "bar.xml", tmp_path / "bar.json"
    inner = real("600.018", "\\milli\\metre", expanded("0.0012"))
    path.write_text(certificate(quantity("Length", inner)), encoding="utf-8")
    said = done("certificate", "read", path, "--kind", "ball-bar", "-o", bar).output
    assert "600.01800 mm ± 1.20 µm" in said
    assert "expansion_per_c" in said
    assert "sphere_diameter_mm" in said
    assert read_length_standard(bar).lengths[0].standard_uncertainty_um == pytest.approx(0.6)


@pytest.mark.parametrize(
    ("kind", "diameter_mm", "is_warned"),
    [("ball-bar", "20.0004", False), ("ball-bar", "", True), ("step-gauge", "", False)],
)
def test_a_ball_bar_read_without_sphere_diameter_is_warned_of(
    tmp_path: Path, kind: str, diameter_mm: str, is_warned: bool
) -> None:
    path = tmp_path / "bar.xml"
    known = expanded("0.0012")
    parts = [quantity("Length", real("600.018", "\\milli\\metre", known))]
    if diameter_mm:
        parts.append(quantity("Diameter", real(diameter_mm, "\\milli\\metre", known)))
    path.write_text(certificate(*parts), encoding="utf-8")
    said = done("certificate", "read", path, "--kind", kind).output
    assert ("sphere_diameter_mm" in said) == is_warned
    assert "expansion_per_c" in said
