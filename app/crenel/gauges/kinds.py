"""The kinds of performance tests: one more is a folder, and a line here."""

from collections.abc import Mapping
from pathlib import Path

from crenel.gauges.contact.guide import ContactKind
from crenel.gauges.evaluate import evaluate_test
from crenel.gauges.judgement.document import PerformanceFile, read_performance
from crenel.gauges.length.guide import LengthKind
from crenel.gauges.plan.document import RESULT, Kind, read_plan
from crenel.gauges.plane.guide import PlaneKind
from crenel.gauges.session.kind import AnyKind
from crenel.gauges.sphere.guide import SphereKind
from crenel.messages.message import Message, Text

STATION_NOTES = ("performance-aside-note", "performance-touches-taken-back")
"""Notes that the files of a test do not tell."""
KINDS: Mapping[Kind, AnyKind] = {
    one.state.test: one for one in (SphereKind(), LengthKind(), PlaneKind(), ContactKind())
}
"""By their names."""


def evaluate_performance(folder: Path, ended_at: str = "") -> PerformanceFile:
    """Computes every figure of the test in a folder; see ``evaluate_test``."""
    return evaluate_test(folder, KINDS[read_plan(folder).kind].evaluation, ended_at)


def write_performance(folder: Path) -> PerformanceFile:
    """Evaluates the test in a folder and writes the result; raises ``OperationError``.

    What only the station knew, and an earlier result has, is kept: when the test ended, the
    temperatures of the station, and which scans and touches do not count.
    """
    before = read_performance(folder) if (folder / RESULT).is_file() else None
    result = evaluate_performance(folder, "" if before is None else before.ended_at)
    if before is not None:
        notes = (note for note in before.notes if _is_from_station(note))
        kept = {"notes": (*result.notes, *notes), "temperature_c": before.temperature_c}
        result = result.model_copy(update=kept)
    result.write(folder / RESULT)
    return result


def _is_from_station(note: Text) -> bool:
    return isinstance(note, Message) and note.message_id in STATION_NOTES
