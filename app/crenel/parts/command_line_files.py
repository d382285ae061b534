"""The files that ``crenel inspect`` writes, each in the form that its name ends with."""

from collections.abc import Sequence
from pathlib import Path

from crenel.errors import OperationError
from crenel.formats.atomic_write import check_output_path, write_atomically
from crenel.formats.exchange.write_tables import workbook_obstacle
from crenel.formats.file_names import display_path
from crenel.messages.message import Text, message
from crenel.parts.document_results import InspectionFile
from crenel.parts.exchange.export import FORMS, export_inspection

REPORTS = (".html", ".pdf")
MAPS = (".ply",)


def check_result_files(
    paths: Sequence[Path], maps: Sequence[Path], inputs: Sequence[Path], language: str
) -> None:
    """Refuses before anything is measured what could not be written in the end.

    Raises:
        OperationError: a form or a language that is not known, a missing extra, a place that
            cannot be written or is an input.
    """
    from crenel.messages.language_file import languages

    for given, known in ((paths, (*FORMS, *REPORTS)), (maps, MAPS)):
        for path in given:
            if path.suffix.lower() not in known:
                raise OperationError(
                    "result-form",
                    message("part-result-form-unknown", path=display_path(path)),
                    "",
                    message("part-end-name-with", endings=", ".join(known)),
                )
            check_output_path(path, inputs)
            if path.suffix.lower() == ".xlsx" and (obstacle := workbook_obstacle()):
                raise OperationError("extra-missing", display_path(path), obstacle)
    if language not in languages():
        raise OperationError(
            "language-unknown",
            message("part-language-unknown", language=language),
            "",
            message("part-choose-language", languages=", ".join(languages())),
        )


def write_result_files(
    result: InspectionFile,
    folder: Path,
    paths: Sequence[Path],
    language: str = "en",
    schema: Path | None = None,
) -> list[Text]:
    """Writes a result in all forms; returns what should be known of them.

    Args:
        folder: that of the inspection.
        schema: by which QIF is checked before it is written.

    Raises:
        OperationError: a file cannot be written, or the schema does not allow it.
    """
    notes: list[Text] = []
    for path in paths:
        if path.suffix.lower() in REPORTS:
            from crenel.parts.report.contents import inspection_report
            from crenel.report.contents.reports import render

            report = inspection_report(result, folder)
            write_atomically(path, render(report, path.suffix, language))
        else:
            notes += export_inspection(result, path, schema)
    return notes
