"""The inspection programs that a station knows, from ``programs/*.json`` of its data folder."""

from collections.abc import Mapping
from dataclasses import dataclass
from pathlib import Path
from typing import TYPE_CHECKING

from crenel.errors import OperationError
from crenel.findings import Finding
from crenel.formats.atomic_write import ensure_folder, write_atomically
from crenel.formats.file_names import check_name
from crenel.formats.io_errors import convert_all_errors, convert_io_errors
from crenel.formats.open_file import read_bounded
from crenel.guide.common.datasheet_library import list_files
from crenel.messages.message import Text, message

if TYPE_CHECKING:
    from crenel.parts.document_program import ProgramFile

PROGRAMS, ENDING = "programs", ".json"


@dataclass(frozen=True)
class ProgramEntry:
    """One readable program; its id is the file's name without its ending."""

    id: str
    path: Path
    program: "ProgramFile"


@dataclass(frozen=True)
class Programs:
    """What can be chosen; files that cannot be read are findings."""

    known: Mapping[str, ProgramEntry]
    findings: tuple[Finding, ...]


def read_programs(data_folder: Path) -> Programs:
    """Reads all programs of a data folder."""
    from crenel.parts.document_program import ProgramFile

    findings: list[Finding] = []
    known = {}
    for path in list_files(data_folder / PROGRAMS, ENDING, findings):
        try:
            with convert_all_errors(path):
                check_name(path)
                known[path.stem] = ProgramEntry(path.stem, path, ProgramFile.read(path))
        except OperationError as error:
            findings.append(Finding("attention", error.text, message("part-correct-program")))
    return Programs(known, tuple(findings))


def add_program(data_folder: Path, name: str, text: str) -> str:
    """Keeps a program that was sent, once it is checked whole; returns its id.

    Raises:
        OperationError: it is no program, with the place; or another one has its name.
    """
    from crenel.parts.document_program import ProgramFile

    path = data_folder / PROGRAMS / Path(name).name
    ProgramFile.parse_text(text, Path(name))
    if path.suffix != ENDING or path.name.startswith("."):
        path = path.with_name(f"{path.name.lstrip('.')}{ENDING}")
    with convert_io_errors(path):
        check_name(path)
        ensure_folder(path.parent)
        if path.exists() and read_bounded(path) != text.encode():
            raise OperationError(
                "program-exists",
                message("part-program-exists", name=path.name),
                remedy=message("part-rename-program"),
            )
        write_atomically(path, text.encode())
    return path.stem


def means_reason(program: "ProgramFile") -> Text:
    """Why a program cannot be measured by touch alone; empty if it can."""
    scanned = sorted({name for name, means in program.list_wanted() if means == "scan"})
    return message("part-program-needs-scans", names=", ".join(scanned)) if scanned else ""
