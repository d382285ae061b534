"""The check of what stations publish."""

from crenel.messages.catalogue import renderer
from crenel.monitoring.health_topics import REPORTED_S, messages


def test_what_was_not_read_is_reported_with_its_reason_for_an_hour() -> None:
    counts = {"crowded": 12, "long": 3, "strange": 0}
    assert messages({}, None) == []
    assert messages(counts, REPORTED_S + 1.0) == []
    (reported,) = messages(counts, 5.0)
    assert reported.quality == "attention"
    assert str(reported.what) == (
        "15 messages on the broker were not read: 3 too long, "
        "12 from more stations than are displayed."
    )
    assert reported.remedy


def test_it_is_in_german_too() -> None:
    counts = {"crowded": 1, "long": 2, "strange": 3, "often": 4}
    (reported,) = messages(counts, 5.0)
    assert renderer("de")(reported.what) == (
        "10 Nachrichten auf dem Broker wurden nicht gelesen: 2 zu lang, 3 ohne das Format einer "
        "Station, 4 schneller, als sie gelesen werden, 1 von mehr Stationen, als angezeigt werden."
    )
