"""The result of a performance test in one of the formats for other programs."""

from pathlib import Path

from app.formats.atomic_write import check_output_path, write_atomically
from app.formats.exchange.write_certificate import Issuer, certificate_bytes
from app.formats.exchange.write_qif import qif_bytes
from app.formats.exchange.write_tables import write_csv_tables, write_workbook
from app.formats.performance.results import PerformanceFile
from app.messages.message import Text, message

NAMES = {
    "csv": "performance-csv",
    "xlsx": "performance.xlsx",
    "qif": "performance.qif",
    "dcc": "performance-dcc.xml",
}
"""Where a format is written if no other place is named."""


def export_result(
    document: PerformanceFile, form: str, output: Path | None, issuer: Issuer | None = None
) -> tuple[list[Path], list[Text]]:
    """Writes a result; returns the files, and what should be known of them.

    Args:
        form: one of ``NAMES``.
        output: the file, or the folder of CSV tables.
        issuer: of a certificate alone.

    Raises:
        OperationError: the file cannot be written, an extra is missing, or the issuer.
    """
    path = output or Path(NAMES[form])
    if form == "csv":
        return write_csv_tables(document, path), []
    if form == "xlsx":
        write_workbook(document, path)
        return [path], []
    check_output_path(path)
    if form == "qif":
        write_atomically(path, qif_bytes(document))
        return [path], [message("qif-not-validated")]
    write_atomically(path, certificate_bytes(document, issuer or Issuer("", "")))
    return [path], [message("certificate-not-validated")]
