"""Validation by a schema before writing: small schemas of our own, in several files."""

from pathlib import Path

import pytest

from crenel.errors import OperationError
from crenel.formats.exchange.check_schema import check_schema
from crenel.gauges.exchange.export import export_result
from tests.gauges.judgement.results import plane_result
from tests.refusals import refused_as

pytest.importorskip("lxml")
XS = 'xmlns:xs="http://www.w3.org/2001/XMLSchema"'
CONTENT = b'<a xmlns="urn:a" kind="x">\n<b>1</b>\n<b>2</b>\n</a>\n'


def main_schema(links: str, pattern: str = "[a-z]{1}") -> str:
    """A list of numbers, whose type stands in another namespace."""
    return f"""<xs:schema {XS} xmlns:o="urn:o" targetNamespace="urn:a"
        elementFormDefault="qualified">{links}
      <xs:element name="a"><xs:complexType>
        <xs:sequence><xs:element name="b" type="o:number" maxOccurs="unbounded"/></xs:sequence>
        <xs:attribute name="kind"><xs:simpleType><xs:restriction base="xs:string">
          <xs:pattern value="{pattern}"/></xs:restriction></xs:simpleType></xs:attribute>
      </xs:complexType></xs:element></xs:schema>"""


def import_of(location: str) -> str:
    return f'<xs:import namespace="urn:o" schemaLocation="{location}"/>'


NUMBER = f"""<xs:schema {XS} targetNamespace="urn:o">
  <xs:simpleType name="number"><xs:restriction base="xs:int"/></xs:simpleType></xs:schema>"""


def write_schemas(folder: Path, location: str, number: str = NUMBER) -> Path:
    """``main.xsd``, which imports ``location``, and ``number.xsd``."""
    schema = folder / "main.xsd"
    schema.write_text(main_schema(import_of(location)), encoding="utf-8")
    (folder / "number.xsd").write_text(number, encoding="utf-8")
    return schema


@pytest.mark.parametrize(
    "location", ["number.xsd", "./number.xsd", "https://example.org/v2.2.1/number.xsd"]
)
def test_a_file_that_complies_passes(tmp_path: Path, location: str) -> None:
    check_schema(CONTENT, write_schemas(tmp_path, location), tmp_path / "out.xml")


def test_schemas_that_include_each_other_are_read(tmp_path: Path) -> None:
    schema = write_schemas(tmp_path, "lower/number.xsd")
    (tmp_path / "lower").mkdir()
    (tmp_path / "number.xsd").rename(tmp_path / "lower" / "types.xsd")
    again = '<xs:include schemaLocation="{}.xsd"/>'
    both = f'<xs:schema {XS} targetNamespace="urn:o">{again.format("types")}</xs:schema>'
    (tmp_path / "lower" / "number.xsd").write_text(both, encoding="utf-8")
    back = NUMBER.replace("<xs:simpleType", f"{again.format('number')}<xs:simpleType", 1)
    (tmp_path / "lower" / "types.xsd").write_text(back, encoding="utf-8")
    check_schema(CONTENT, schema, tmp_path / "out.xml")


def test_entities_of_the_schema_itself_are_resolved_and_no_others(tmp_path: Path) -> None:
    (tmp_path / "secret").write_text("xs:int", encoding="utf-8")
    own = '<!DOCTYPE s PUBLIC "-//X" "http://example.org/x.dtd" [<!ENTITY n "urn:o">]>'
    schema = write_schemas(tmp_path, "number.xsd", own + NUMBER.replace('"urn:o"', '"&n;"'))
    check_schema(CONTENT, schema, tmp_path / "out.xml")
    read = f'<!DOCTYPE s [<!ENTITY n SYSTEM "secret">]>{NUMBER}'
    read = read.replace("<xs:simpleType", "<xs:annotation>&n;</xs:annotation><xs:simpleType")
    (tmp_path / "number.xsd").write_text(read, encoding="utf-8")
    with refused_as("schema-unusable"):
        check_schema(CONTENT, schema, tmp_path / "out.xml")


def test_errors_are_named_with_line_and_element(tmp_path: Path) -> None:
    schema = write_schemas(tmp_path, "number.xsd")
    wrong = CONTENT.replace(b">1<", b">one<").replace(b'"x"', b'"12"')
    with pytest.raises(OperationError) as raised:
        check_schema(wrong, schema, tmp_path / "out.xml")
    assert raised.value.code == "schema-violated"
    said = raised.value.line
    assert "line 1: Element 'a', attribute 'kind'" in said
    assert "[a-z]{1}" in said
    assert "line 2: Element 'b'" in said
    assert "urn:a" not in said


def test_of_many_errors_the_first_are_named(tmp_path: Path) -> None:
    lines = b"".join(b"<b>x</b>\n" for _ in range(9))
    content = b'<a xmlns="urn:a">\n' + lines + b"</a>"
    with pytest.raises(OperationError) as raised:
        check_schema(content, write_schemas(tmp_path, "number.xsd"), tmp_path / "out.xml")
    assert "line 6" in raised.value.line
    assert "line 7" not in raised.value.line
    assert "and 4 more errors" in raised.value.line


@pytest.mark.parametrize("location", ["https://example.org/v2/other.xsd", "other.xsd"])
def test_a_schema_that_is_missing_is_named_and_not_fetched(tmp_path: Path, location: str) -> None:
    with refused_as("schema-incomplete", location, "Put other.xsd into"):
        check_schema(CONTENT, write_schemas(tmp_path, location), tmp_path / "out.xml")


@pytest.mark.parametrize(
    ("text", "code"),
    [
        ("<a", "schema-unusable"),
        ("<a/>", "schema-unusable"),
        (main_schema(""), "schema-unusable"),
        (None, "file-missing"),
    ],
)
def test_an_unusable_schema_is_refused(tmp_path: Path, text: str | None, code: str) -> None:
    schema = tmp_path / "main.xsd"
    if text is not None:
        schema.write_text(text, encoding="utf-8")
    with refused_as(code, "main.xsd"):
        check_schema(CONTENT, schema, tmp_path / "out.xml")


@pytest.mark.parametrize("allowed", [True, False])
def test_nothing_is_written_unless_the_schema_allows_it(tmp_path: Path, allowed: bool) -> None:
    document = plane_result(tmp_path / "test")
    schema, output = tmp_path / "qif.xsd", tmp_path / "out.qif"
    output.write_text("before", encoding="utf-8")
    name = "QIFDocument" if allowed else "Other"
    schema.write_text(
        f'<xs:schema {XS} targetNamespace="http://qifstandards.org/xsd/qif3">'
        f'<xs:element name="{name}"/></xs:schema>',
        encoding="utf-8",
    )
    if allowed:
        assert export_result(document, "qif", output, schema=schema) == ([output], [])
        assert "QIFDocument" in output.read_text("utf-8")
        return
    with refused_as("schema-violated"):
        export_result(document, "qif", output, schema=schema)
    assert output.read_text("utf-8") == "before"
    assert len(list(tmp_path.iterdir())) == 3


def test_the_schema_is_not_overwritten(tmp_path: Path) -> None:
    document = plane_result(tmp_path / "test")
    with refused_as("output-is-source"):
        export_result(document, "qif", tmp_path / "a.xsd", schema=tmp_path / "a.xsd")


@pytest.mark.parametrize("form", ["csv", "xlsx"])
def test_tables_have_no_schema(tmp_path: Path, form: str) -> None:
    document = plane_result(tmp_path / "test")
    with refused_as("schema-without-xml"):
        export_result(document, form, tmp_path / "out", schema=tmp_path / "a.xsd")
    assert not (tmp_path / "out").exists()
