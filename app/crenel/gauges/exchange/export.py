"""The result of a performance test in one of the formats for other programs."""

from pathlib import Path

from crenel.errors import OperationError
from crenel.formats.atomic_write import check_output_path, write_atomically
from crenel.formats.exchange.check_schema import check_schema
from crenel.formats.exchange.write_tables import write_csv_folder, write_workbook
from crenel.formats.file_names import display_path
from crenel.gauges.exchange.result_tables import result_tables
from crenel.gauges.exchange.write_certificate import Issuer, certificate_bytes
from crenel.gauges.exchange.write_qif import qif_bytes
from crenel.gauges.judgement.document import PerformanceFile
from crenel.messages.message import Text, message

NAMES = {
    "csv": "performance-csv",
    "xlsx": "performance.xlsx",
    "qif": "performance.qif",
    "dcc": "performance-dcc.xml",
}
"""Where a format is written if no other place is named."""


def export_result(
    document: PerformanceFile,
    form: str,
    output: Path | None,
    issuer: Issuer | None = None,
    schema: Path | None = None,
) -> tuple[list[Path], list[Text]]:
    """Writes a result; returns the files, and what should be known of them.

    Args:
        form: one of ``NAMES``.
        output: the file, or the folder of CSV tables.
        issuer: of a certificate alone.
        schema: an XSD file that QIF or a certificate is checked by before it is written.

    Raises:
        OperationError: the file cannot be written, an extra is missing, or the issuer; the
            schema cannot be used or does not allow the file.
    """
    path = output or Path(NAMES[form])
    if form in ("csv", "xlsx") and schema is not None:
        raise OperationError(
            "schema-without-xml",
            display_path(path),
            message("schema-is-of-xml"),
            message("schema-leave-out"),
        )
    if form == "csv":
        return write_csv_folder(result_tables(document), path), []
    if form == "xlsx":
        write_workbook(result_tables(document), path, document.id, document.ended_at)
        return [path], []
    check_output_path(path, [] if schema is None else [schema])
    if form == "qif":
        content = qif_bytes(document)
    else:
        content = certificate_bytes(document, issuer or Issuer("", ""))
    if schema is not None:
        check_schema(content, schema, path)
    write_atomically(path, content)
    return [path], _remarks(form, is_validated=schema is not None)


def _remarks(form: str, is_validated: bool) -> list[Text]:
    """What should be known of a written XML file."""
    if form == "qif":
        return [] if is_validated else [message("qif-not-validated")]
    if is_validated:
        return [message("certificate-not-signed")]
    return [message("certificate-not-validated")]
