"""What the reports on the arm itself have in common: who made it, when, where and with what."""

from collections.abc import Sequence
from pathlib import Path
from typing import Protocol

from crenel.formats.json_document import Software
from crenel.messages.message import Text, message
from crenel.report.content import Facts, Report, Section, Verdict
from crenel.report.formatting import (
    UNKNOWN,
    format_moment,
    simulation_notes,
    software_name,
    temperature,
)


class ArmSessionResult(Protocol):
    """A check or an identification of the arm, as its file has it."""

    @property
    def operator(self) -> str: ...
    @property
    def station(self) -> str: ...
    @property
    def simulated(self) -> bool: ...
    @property
    def temperature_c(self) -> float | None: ...
    @property
    def software(self) -> Software: ...


def arm_facts(
    record: ArmSessionResult, made: tuple[Text, str], rows: Sequence[tuple[Text, Text]]
) -> Facts[Text]:
    """What was looked at: ``made`` is what was done and when, ``rows`` are of this report alone."""
    done, at = made
    return Facts(
        [
            (message("operator"), record.operator or UNKNOWN),
            (done, format_moment(at)),
            (message("temperature"), temperature(record.temperature_c)),
            *rows,
            (message("software"), software_name(record.software.version)),
        ]
    )


def arm_report(
    folder: Path,
    title: Text,
    record: ArmSessionResult,
    at: str,
    verdict: Verdict[Text],
    sections: Sequence[Section[Text]],
) -> Report[Text]:
    """The report on the record in a session's folder, made ``at`` a moment."""
    return Report(
        title=title,
        number=folder.resolve().name,
        station=record.station or message("measuring-arm"),
        date=format_moment(at),
        verdict=verdict,
        sections=sections,
        notes=simulation_notes(record.simulated),
    )
