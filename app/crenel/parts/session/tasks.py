"""What ends an inspection: its evaluation, its record."""

from collections.abc import Mapping
from typing import TYPE_CHECKING

from crenel.errors import OperationError
from crenel.findings import Quality
from crenel.guide.common.journal import error_payload
from crenel.messages.message import message
from crenel.parts.session.guide import PartGuide
from crenel.parts.session.picture import VERDICTS
from crenel.parts.session.view import Outcome
from crenel.station.jobs import Progress

if TYPE_CHECKING:
    from crenel.parts.document_results import InspectionFile

QUALITIES: dict[Outcome, Quality] = {
    "pass": "good",
    "fail": "bad",
    "undecided": "attention",
    "none": "neutral",
}


def evaluate(guide: PartGuide, progress: Progress) -> None:
    """Inspects the part by the session's folder, as the command does, and writes the result there;
    a refusal is kept, too."""
    from crenel.parts.document_program import ProgramFile
    from crenel.parts.document_results import RESULTS
    from crenel.parts.evaluate import inspect_part
    from crenel.parts.evaluate_folder import find_files

    progress(message("inspection-evaluating"), 0.2)
    try:
        with guide.lock:
            files = find_files(guide.folder)
            guide.write_program(ProgramFile.read(files.program))
            guide.keep_touches()
        found = inspect_part(find_files(guide.folder), guide.rule)
        found.write(guide.folder / RESULTS)
    except OperationError as error:
        guide.append("evaluation_failed", {"refused": error_payload(error)})
        guide.station.bus.event("refused", error.text, "attention")
        return
    guide.append("evaluated", {"result": found.verdict})


def accept(guide: PartGuide, key: str | None) -> None:
    """Lists the finished inspection; raises ``OperationError``, and nothing is kept then."""
    found = guide.result()
    assert found is not None
    _close(guide, found, key)
    guide.station.bus.event("accepted", VERDICTS[found.verdict], QUALITIES[found.verdict])


def _close(guide: PartGuide, found: "InspectionFile", key: str | None) -> None:
    state = guide.state
    words = [one.decision for one in found.dimensions]
    figures: Mapping[str, object] = {
        "result": found.verdict,
        "text": VERDICTS[found.verdict],
        "program": found.program,
        "part": found.part,
        "serial_number": found.serial_number,
        "passed": words.count("pass"),
        "failed": words.count("fail"),
        "undecided": words.count("undecided") + len(found.not_measured),
        "operator": state.operator,
    }
    guide.keep(
        lambda check: guide.inspections.close(
            state.session_id,
            {"result": found.verdict},
            state.calibration_id,
            guide.folder,
            figures,
            key,
            check,
        )
    )
