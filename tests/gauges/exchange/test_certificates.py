"""Digital Calibration Certificates: of a sphere read, of a performance test written."""

from contextlib import suppress
from pathlib import Path
from xml.etree import ElementTree as ET

import pytest
from hypothesis import HealthCheck, given, settings
from hypothesis import strategies as st

from crenel.errors import OperationError
from crenel.formats.xml_text import local_name
from crenel.gauges.exchange.certificate_values import DCC, SI, result_lengths
from crenel.gauges.exchange.read_certificate import (
    CertifiedSphere,
    read_length_certificate,
    read_sphere_certificate,
)
from crenel.gauges.exchange.write_certificate import Issuer, certificate_bytes
from crenel.gauges.judgement.document import PerformanceFile
from crenel.gauges.plan.document_gauge import read_gauge
from crenel.gauges.plan.document_symbols import is_signed
from tests.gauges.exchange.certificates import (
    DIAMETER,
    FORM,
    certificate,
    coverage_interval,
    expanded,
    expanded_mu,
    quantity,
    real,
    real_list,
    standard_mu,
)
from tests.gauges.judgement.results import Build, contact_result, lengths_result, sphere_result
from tests.refusals import refused_as

ISSUER = Issuer("Lab <A> & B", "DE", "Customer")
NAMES = {"dcc": DCC, "si": SI}
ORDER = {
    "digitalCalibrationCertificate": "administrativeData measurementResults",
    "administrativeData": (
        "dccSoftware coreData items calibrationLaboratory respPersons customer statements"
    ),
    "coreData": (
        "countryCodeISO3166_1 usedLangCodeISO639_1 usedLangCodeISO639_1 mandatoryLangCodeISO639_1 "
        "uniqueIdentifier beginPerformanceDate endPerformanceDate performanceLocation"
    ),
    "measurementResult": (
        "name usedMethods usedSoftware measuringEquipments influenceConditions results"
    ),
    "measurementResults": "measurementResult",
    "influenceCondition": "name data",
    "result": "name data",
    "measuringEquipment": "name identifications",
    "identification": "issuer value",
    "software": "name release",
    "contact": "name location",
    "customer": "name location",
    "measurementUncertaintyUnivariate": "expandedMU",
    "expandedMU": "valueExpandedMU coverageFactor coverageProbability distribution",
    "item": "name identifications",
    "respPerson": "person mainSigner",
}
"""The children of elements that are always the same, in the order of the schema of DCC 3.3.0."""
ORDER_OF_SOME = {
    "usedMethod": "name description norm",
    "quantity": "name real measurementMetaData",
    "real": "value unit measurementUncertaintyUnivariate",
    "statement": "norm declaration conformity",
    "metaData": "declaration conformityXMLList data",
}
"""The children of elements that may lack some, in the same order."""
SHORT_TEXTS = ("release", "uniqueIdentifier", "value", "norm")
"""Never empty, and without space about them."""
CONFORMITIES = {"pass", "fail", "conditionalPass", "conditionalFail", "noPass", "noFail"}


OF_25_MM = real("25", "\\milli\\metre", expanded("0.0006"))


def xml_file(tmp_path: Path, text: str) -> Path:
    path = tmp_path / "certificate.xml"
    path.write_text(text, encoding="utf-8")
    return path


def read(tmp_path: Path, text: str, **names: str) -> CertifiedSphere:
    return read_sphere_certificate(xml_file(tmp_path, text), **names)


def test_a_sphere_is_read_with_everything_that_its_certificate_states(tmp_path: Path) -> None:
    found = read(tmp_path, certificate(DIAMETER, FORM))
    sphere = found.sphere
    assert sphere.diameter_mm == pytest.approx(25.0012)
    assert sphere.diameter_sd_um == pytest.approx(0.3)
    assert sphere.form_um == pytest.approx(0.08)
    assert sphere.form_sd_um == pytest.approx(0.025)
    assert (sphere.name, sphere.serial_number) == ("Ceramic sphere", "K-17")
    assert (sphere.certificate, sphere.valid_until) == ("4711-2026", "2028-03-12")
    assert (found.head.laboratory, found.head.calibrated_on) == ("Lab A", "2026-03-12")


@pytest.mark.parametrize(
    "inner",
    [
        real("0.025", "\\metre", expanded("6e-7")),
        real("25000", "\\micro\\metre", expanded_mu("0.9", "3")),
        real("25", "\\milli\\metre", standard_mu("0.0003")),
        real("25", "\\milli\\metre", coverage_interval("0.0003")),
        "<si:hybrid>" + real("298.15", "\\kelvin") + OF_25_MM + "</si:hybrid>",
        real_list("25", "\\milli\\metre", "0.0006"),
    ],
)
def test_units_and_uncertainties_of_every_edition(tmp_path: Path, inner: str) -> None:
    sphere = read(tmp_path, certificate(quantity("Kugeldurchmesser", inner))).sphere
    assert sphere.diameter_mm == pytest.approx(25.0)
    assert sphere.diameter_sd_um == pytest.approx(0.3)
    assert sphere.form_um == 0.0


def test_a_radius_is_doubled_with_its_uncertainty(tmp_path: Path) -> None:
    inner = real("12.5", "\\milli\\metre", expanded("0.0006"))
    sphere = read(tmp_path, certificate(quantity("Radius", inner))).sphere
    assert sphere.diameter_mm == pytest.approx(25.0)
    assert sphere.diameter_sd_um == pytest.approx(0.6)


def test_the_measured_diameter_precedes_the_nominal_one(tmp_path: Path) -> None:
    measured = quantity(
        "Diameter", real("25.0012", "\\milli\\metre", expanded("0.0006")), "basic_measuredValue"
    )
    nominal = quantity("Nominal diameter", real("25", "\\milli\\metre"), "basic_nominalValue")
    sphere = read(tmp_path, certificate(nominal, measured)).sphere
    assert sphere.diameter_mm == pytest.approx(25.0012)


def test_one_of_several_diameters_is_named(tmp_path: Path) -> None:
    other = quantity("Diameter at 25 °C", real("25.002", "\\milli\\metre", expanded("0.001")))
    text = certificate(DIAMETER, other)
    with refused_as("certificate-ambiguous", "Diameter at 25 °C", "--diameter"):
        read(tmp_path, text)
    found = read(tmp_path, text, diameter_name="at 25")
    assert found.sphere.diameter_mm == pytest.approx(25.002)


def diameter(value: str, unit: str, uncertainty: str) -> str:
    return certificate(quantity("Diameter", real(value, unit, expanded(uncertainty))))


WITHOUT_UNCERTAINTY = certificate(quantity("Diameter", real("25", "\\milli\\metre")))
DEVIATION = quantity("Deviation of the diameter", real("1.2", "\\micro\\metre", expanded("0.6")))
NOMINAL = quantity("Nominal diameter", real("25", "\\milli\\metre"))
HUGE_FORM = quantity("Form", real("1", "\\metre", expanded("1e30")))


@pytest.mark.parametrize(
    ("text", "code"),
    [
        ("<a/>", "no-certificate"),
        ("<a>", "xml-malformed"),
        ("<!DOCTYPE a [<!ENTITY b 'c'>]><a>&b;</a>", "xml-with-document-type"),
        (certificate(DIAMETER, version="2.4.0"), "certificate-version"),
        (certificate(FORM), "certificate-incomplete"),
        (certificate(), "certificate-incomplete"),
        (WITHOUT_UNCERTAINTY, "certificate-without-uncertainty"),
        (certificate(NOMINAL, DEVIATION), "certificate-without-uncertainty"),
        (diameter("-25", "\\milli\\metre", "1"), "certificate-implausible"),
        (diameter("25", "\\kilo\\metre", "1"), "certificate-implausible"),
        (diameter("25", "\\milli\\metre", "60"), "certificate-implausible"),
        (certificate(DIAMETER, HUGE_FORM), "certificate-implausible"),
        (diameter("nan", "\\milli\\metre", "1"), "certificate-incomplete"),
        (diameter("25", "\\kilogram", "1"), "certificate-incomplete"),
    ],
)
def test_what_cannot_be_used_is_refused(tmp_path: Path, text: str, code: str) -> None:
    with refused_as(code, "certificate.xml"):
        read(tmp_path, text)


def lengths(values: str, uncertainties: str, units: str = "\\milli\\metre") -> str:
    return quantity("Centre distance", real_list(values, units, uncertainties))


TWO_UNITS = "\\metre \\milli\\metre"


def test_a_ball_bar_is_read_with_every_length(tmp_path: Path) -> None:
    text = certificate(lengths("600.018 300.012", "0.0012 0.0010"), DIAMETER)
    found = read_length_certificate(xml_file(tmp_path, text), "ball-bar")
    assert [one.length_mm for one in found.lengths] == pytest.approx([300.012, 600.018])
    assert [one.standard_uncertainty_um for one in found.lengths] == pytest.approx([0.5, 0.6])
    assert found.sphere_diameter_mm == pytest.approx(25.0012)
    assert (found.serial_number, found.valid_until) == ("K-17", "2028-03-12")


@pytest.mark.parametrize(
    ("text", "code"),
    [
        (certificate(DIAMETER), "certificate-incomplete"),
        (certificate(lengths("300 600 900", "0.001 0.002")), "certificate-without-uncertainty"),
        (certificate(lengths("300 600 900", "0.001", TWO_UNITS)), "certificate-incomplete"),
    ],
)
def test_lengths_that_do_not_fit_lists_are_refused(tmp_path: Path, text: str, code: str) -> None:
    with refused_as(code):
        read_length_certificate(xml_file(tmp_path, text), "step-gauge")


def test_quantities_of_conditions_are_no_results(tmp_path: Path) -> None:
    names = [one.label for one in result_lengths(ET.fromstring(certificate(DIAMETER, FORM)))]
    assert names == ["Diameter", "Roundness"]


def test_a_certificate_becomes_a_gauge(tmp_path: Path) -> None:
    read(tmp_path, certificate(DIAMETER, FORM)).gauge.write(tmp_path / "gauge.nominal.json")
    gauge = read_gauge(tmp_path / "gauge.nominal.json")
    assert gauge.radius_mm == pytest.approx(12.5006)
    assert gauge.standard_uncertainty_um == pytest.approx(0.15)
    assert gauge.serial_number == "K-17"


def written(document: PerformanceFile, issuer: Issuer = ISSUER) -> ET.Element:
    return ET.fromstring(certificate_bytes(document, issuer))


def values(quantity: ET.Element) -> tuple[float, float]:
    value = quantity.findtext("si:real/si:value", "", NAMES)
    uncertainty = quantity.findtext("si:real//si:valueExpandedMU", "nan", NAMES)
    return float(value), float(uncertainty)


def quantities_of(document: PerformanceFile) -> list[ET.Element]:
    return written(document).findall(".//dcc:result/dcc:data/dcc:quantity", NAMES)


def limits_of(quantity: ET.Element) -> list[float]:
    limits = quantity.findall(".//dcc:metaData/dcc:data/dcc:quantity", NAMES)
    return [values(one)[0] for one in limits]


@pytest.mark.parametrize("build", [sphere_result, lengths_result, contact_result])
def test_a_written_certificate_has_its_elements_in_order(tmp_path: Path, build: Build) -> None:
    root = written(build(tmp_path))
    for element in root.iter():
        name = local_name(element)
        if name in ORDER:
            assert [local_name(child) for child in element] == ORDER[name].split()
        if name in ORDER_OF_SOME:
            places = [ORDER_OF_SOME[name].split().index(local_name(child)) for child in element]
            assert places == sorted(set(places))
    said = {one.text for one in root.iter(f"{{{DCC}}}conformity")}
    said |= {one.text for one in root.iter(f"{{{DCC}}}conformityXMLList")}
    assert said <= CONFORMITIES
    languages = [one.text for one in root.iter(f"{{{DCC}}}usedLangCodeISO639_1")]
    for element in root.iter():
        spoken = [one.get("lang") for one in element.findall("dcc:content", NAMES)]
        assert spoken in ([], [None], languages)


def test_every_value_is_written_with_uncertainty_limits_and_conformity(tmp_path: Path) -> None:
    document = sphere_result(tmp_path)
    quantities = quantities_of(document)
    figures = [one for one in document.figures if one.value is not None]
    assert len(quantities) == len(figures) == 9
    for found, figure in zip(quantities, figures, strict=True):
        value, uncertainty = values(found)
        assert figure.value == pytest.approx(value, abs=6e-4)
        assert figure.test_uncertainty == pytest.approx(uncertainty, abs=6e-4)
        assert figure.symbol in found.findtext("dcc:name/dcc:content", "", NAMES)
        said = found.findtext(".//dcc:conformityXMLList", None, NAMES)
        assert said == (figure.decision if figure.decision in ("pass", "fail") else None)
        limits = limits_of(found)
        assert len(limits) == (0 if figure.limit is None else 2 + is_signed(figure.quantity))
    # of the dispersion, 1.65 times half the expanded uncertainty within the limit of 32 µm
    assert limits_of(quantities[5]) == pytest.approx([32.0, 32.0 - 1.65 * 0.4])
    # what the user cannot prove to be beyond it is accepted
    of_user = document.rule.model_copy(update={"bearer": "user"})
    quantities = quantities_of(document.model_copy(update={"rule": of_user}))
    assert limits_of(quantities[5]) == pytest.approx([32.0, 32.0 + 1.65 * 0.4])


def test_a_written_certificate_is_the_same_again_and_safe(tmp_path: Path) -> None:
    document = sphere_result(tmp_path)
    odd = document.model_copy(update={"operator": "A\x00<b>&"})
    assert certificate_bytes(odd, ISSUER) == certificate_bytes(odd, ISSUER)
    root = written(odd)
    assert root.findtext(".//dcc:respPerson/dcc:person/dcc:name/dcc:content", "", NAMES) == (
        "A\ufffd<b>&"
    )
    laboratory = ".//dcc:calibrationLaboratory/dcc:contact/dcc:name/dcc:content"
    assert root.findtext(laboratory, "", NAMES) == "Lab <A> & B"


def test_short_texts_are_never_empty_or_with_space_about_them(tmp_path: Path) -> None:
    document = sphere_result(tmp_path)
    serials = document.serial_numbers.model_copy(update={"arm": " A 1\n", "sensor": " "})
    odd = document.model_copy(update={"serial_numbers": serials, "standards": ("Own rule ",)})
    texts = [one.text or "" for one in written(odd).iter() if local_name(one) in SHORT_TEXTS]
    assert {"A 1", "–", "Own rule"} <= set(texts)
    assert all(text and text == text.strip() for text in texts)


def test_a_test_without_temperatures_says_so(tmp_path: Path) -> None:
    document = sphere_result(tmp_path).model_copy(update={"temperature_c": (None, None)})
    data = written(document).find(".//dcc:influenceCondition/dcc:data", NAMES)
    assert data is not None
    assert data.findtext("dcc:text/dcc:content", "", NAMES) == "not measured"


def test_the_temperatures_of_artefact_and_arm_are_conditions(tmp_path: Path) -> None:
    conditions = written(lengths_result(tmp_path)).findall(".//dcc:influenceCondition", NAMES)
    names = [one.findtext("dcc:name/dcc:content", "", NAMES) for one in conditions]
    assert names == ["Temperature", "Temperature of the artefact", "Temperature of the arm"]
    kelvin = [value.text for value in conditions[2].findall(".//si:value", NAMES)]
    assert kelvin == ["294.45", "295.05"]


@pytest.mark.parametrize("issuer", [Issuer("", "DE"), Issuer("Lab", ""), Issuer("Lab", "Germany")])
def test_an_issuer_without_name_or_country_is_refused(tmp_path: Path, issuer: Issuer) -> None:
    with refused_as("issuer-unknown"):
        written(sphere_result(tmp_path), issuer)


def test_the_days_of_a_test_are_those_in_utc(tmp_path: Path) -> None:
    moments = {"started_at": "2026-11-25T00:30:00+02:00", "ended_at": "2026-11-24T23:00:00Z"}
    root = written(sphere_result(tmp_path / "T").model_copy(update=moments))
    for day in ("begin", "end"):
        assert root.findtext(f".//dcc:{day}PerformanceDate", "", NAMES) == "2026-11-24"


def test_a_test_that_ended_on_a_day_before_it_began_is_refused(tmp_path: Path) -> None:
    moments = {"started_at": "2026-11-25T10:00:00Z", "ended_at": "2026-11-24T10:00:00Z"}
    document = sphere_result(tmp_path / "T").model_copy(update=moments)
    with pytest.raises(OperationError, match="began on 2026-11-25 and ended on 2026-11-24"):
        certificate_bytes(document, ISSUER)


def test_a_written_certificate_is_no_sphere(tmp_path: Path) -> None:
    content = certificate_bytes(contact_result(tmp_path / "test"), ISSUER)
    with pytest.raises(OperationError, match="diameter"):
        read(tmp_path, content.decode(), diameter_name="of a sphere")


PIECES = st.sampled_from(
    [
        *("<dcc:data>", "</dcc:data>", "<si:hybrid/>", "<si:real/>", DIAMETER, FORM),
        quantity("Diameter", real("1e300", "\\kilo\\metre", expanded("1e300", "1e-300"))),
        quantity("Diameter", real("25", "\\metre \\metre", expanded("1 2", "0"))),
        quantity("", real("1 2 3", "\\milli\\metre", standard_mu("-1"))),
        quantity("Length", real("1 2", "\\milli\\metre", expanded_mu("inf"))),
        "&#0;",
        "\u202e",
    ]
)


@pytest.mark.slow
@given(pieces=st.lists(PIECES | st.text(max_size=20), max_size=6), cut=st.integers(0, 3000))
@settings(max_examples=200, suppress_health_check=[HealthCheck.function_scoped_fixture])
def test_any_file_is_read_or_refused(tmp_path: Path, pieces: list[str], cut: int) -> None:
    path = tmp_path / "any.xml"
    text = certificate(*pieces)
    for written in (text, text[: len(text) - cut]):
        path.write_text(written, "utf-8", "replace")
        with suppress(OperationError):
            assert read_sphere_certificate(path).gauge.radius_mm
        with suppress(OperationError):
            assert read_length_certificate(path, "ball-bar").lengths
