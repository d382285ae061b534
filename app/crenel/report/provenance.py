"""The input files of a result, and whether they are unchanged."""

from collections.abc import Sequence
from pathlib import Path
from typing import Literal

from crenel.formats.json_document import file_sha256, has_sha256
from crenel.formats.results.calibration import Input
from crenel.messages.message import Message, Text, message, word
from crenel.report.content import Block, Findings, ReportFinding, ReportTable, Section, TextBlock

FileState = Literal["unchanged", "changed", "missing", "result"]
STATES: dict[FileState, Message] = {
    "unchanged": word("unchanged"),
    "changed": word("changed"),
    "missing": word("missing"),
    "result": message("the-result"),
}


def inputs_section(
    folder: Path, inputs: Sequence[Input], result: str | None, accepted_sha256: str | None = None
) -> Section[Text]:
    """The files with their hashes, and the ``result``, if it is a file, compared with what was
    accepted."""
    files = [(one.file, one.sha256, _state(folder, one)) for one in inputs]
    if result is not None:
        own = file_sha256(folder / result)
        files.append((result, own, "result" if accepted_sha256 in (None, own) else "changed"))
    changed = sum(state in ("changed", "missing") for _, _, state in files)
    table = ReportTable[Text](
        (message("file-column"), "SHA-256", message("now")),
        [(name, sha256, STATES[state]) for name, sha256, state in files],
        (34, 70, 15),
        3,
        small=True,
    )
    blocks: list[Block[Text]]
    if changed:
        text = message("these-files-what-result-made-accepted", changed=changed)
        finding = ReportFinding[Text]("bad", text, message("result-cannot-traced-them"))
        blocks = [Findings([finding]), table]
    else:
        blocks = [table, TextBlock(message("every-file-has-content-result-made"), True)]
    return Section(message("inputs"), blocks, together=False)


def _state(folder: Path, one: Input) -> FileState:
    path = folder / one.file
    if not path.is_file():
        return "missing"
    return "unchanged" if has_sha256(path, one.sha256) else "changed"
