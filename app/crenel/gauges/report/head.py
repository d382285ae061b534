"""What the reports of verifications and performance tests have alike: words, head, devices."""

from collections.abc import Sequence

from crenel.formats.results.calibration import SerialNumbers
from crenel.gauges.judgement.document import PerformanceFile
from crenel.gauges.quick.document import VerificationFile
from crenel.messages.message import Message, Text, message, quantity, word
from crenel.metrology.decision import Decision
from crenel.report.content import Quality, Report, Section, Verdict
from crenel.report.formatting import UNKNOWN, format_moment, simulation_notes, temperature

WORDS: dict[Decision, Message] = {
    "pass": message("pass"),
    "fail": message("fail"),
    "uncertain": message("undecided"),
    "none": message("no-limit-set-heading"),
}
DECISIONS: dict[Decision, Message] = {
    "pass": word("pass"),
    "fail": word("fail"),
    "uncertain": word("undecided"),
    "none": message("no-limit"),
}
"""In a table."""
QUALITIES: dict[Decision, Quality] = {
    "pass": "good",
    "fail": "bad",
    "uncertain": "attention",
    "none": "neutral",
}


def report_with_verdict(
    document: VerificationFile | PerformanceFile,
    title: Text,
    ended_at: str,
    sections: list[Section[Text]],
    notes: Sequence[Text] = (),
) -> Report[Text]:
    """The report of a record, with its verdict in the head.

    Args:
        ended_at: ISO 8601.
        notes: beside the head.
    """
    verdict = document.verdict
    return Report(
        title=title,
        number=document.id,
        station=document.station,
        date=format_moment(ended_at),
        verdict=Verdict(QUALITIES[verdict.result], WORDS[verdict.result], verdict.text),
        notes=[*notes, *simulation_notes(document.simulated)],
        sections=sections,
    )


def device_facts(serials: SerialNumbers) -> list[tuple[Text, Text]]:
    """Arm and sensor."""
    names = ((message("arm"), serials.arm), (message("sensor-heading"), serials.sensor))
    return [
        (title, message("serial-number", serial_number=number or UNKNOWN))
        for title, number in names
    ]


def temperatures_text(start_c: float | None, end_c: float | None) -> Text:
    """Both temperatures, or one if they do not differ, or only one is known."""
    if start_c is None or end_c is None or round(start_c, 1) == round(end_c, 1):
        return temperature(start_c if start_c is not None else end_c)
    return message("from-to", low=quantity(start_c, "", 1), high=quantity(end_c, "°C", 1))
