"""What a result was made from, and whether the files are still the same."""

from collections.abc import Sequence
from pathlib import Path

from app.formats.json_document import file_sha256
from app.formats.results.calibration import Input
from app.report.content import Block, Findings, ReportFinding, ReportTable, Section, TextBlock

SAME, RESULT = "unchanged", "the result"


def inputs_section(
    folder: Path, inputs: Sequence[Input], result: str, promised_sha256: str | None = None
) -> Section:
    """The files with their hashes, and the ``result`` with what was ``promised`` of it."""
    rows = [(one.file, one.sha256, _state(folder, one)) for one in inputs]
    own = file_sha256(folder / result)
    rows.append((result, own, RESULT if promised_sha256 in (None, own) else "changed"))
    changed = sum(row[2] not in (SAME, RESULT) for row in rows)
    table = ReportTable(("File", "SHA-256", "Now"), rows, (34, 70, 15), 3, small=True)
    if changed:
        text = f"{changed} of these files are not what the result was made from and accepted as."
        told = ReportFinding("bad", text, "The result cannot be traced to them.")
        blocks: list[Block] = [Findings([told]), table]
    else:
        blocks = [
            table,
            TextBlock("Every file has the content that the result was made from.", True),
        ]
    return Section("Inputs", blocks, together=False)


def _state(folder: Path, one: Input) -> str:
    path = folder / one.file
    if not path.is_file():
        return "missing"
    return SAME if file_sha256(path) == one.sha256 else "changed"
