"""The result of an inspection in one of the forms for other programs, by a file's name."""

from pathlib import Path

from crenel.formats.atomic_write import check_output_path, write_atomically
from crenel.formats.exchange.check_schema import check_schema
from crenel.formats.exchange.write_tables import table_csv, write_workbook
from crenel.messages.message import Text, message
from crenel.parts.document_results import InspectionFile
from crenel.parts.exchange.result_tables import dimensions_table, result_tables
from crenel.parts.exchange.write_qif import qif_bytes

FORMS = (".json", ".csv", ".xlsx", ".qif")
"""Endings of the names; ``.csv`` has the dimensions alone."""


def export_inspection(
    document: InspectionFile, path: Path, schema: Path | None = None
) -> list[Text]:
    """Writes a result in the form that the name ends with; returns what should be known of it.

    Args:
        schema: an XSD file that QIF is checked by before it is written.

    Raises:
        OperationError: the file cannot be written, an extra is missing, or the schema does not
            allow the file.
    """
    form = path.suffix.lower()
    if form == ".json":
        document.write(path)
    elif form == ".csv":
        write_atomically(path, table_csv(dimensions_table(document)))
    elif form == ".xlsx":
        title = document.part or document.program
        write_workbook(result_tables(document), path, title, document.measured_at)
    else:
        check_output_path(path, [] if schema is None else [schema])
        content = qif_bytes(document)
        if schema is not None:
            check_schema(content, schema, path)
        write_atomically(path, content)
        return [] if schema is not None else [message("qif-not-validated")]
    return []
