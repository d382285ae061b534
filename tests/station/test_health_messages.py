"""The check of what stations publish."""

from app.monitoring.health_topics import REPORTED_S, messages
from app.strings.sentences import load_sentences


def test_what_was_not_read_is_told_by_its_reason_for_an_hour() -> None:
    counts = {"crowded": 12, "long": 3, "strange": 0}
    assert messages({}, None) == []
    assert messages(counts, REPORTED_S + 1.0) == []
    (told,) = messages(counts, 5.0)
    assert told.quality == "attention"
    assert told.what == (
        "15 messages on the broker were not read: 3 too long, 12 of more stations than are shown."
    )
    assert told.remedy


def test_it_is_said_in_german_too() -> None:
    counts = {"crowded": 1, "long": 2, "strange": 3, "often": 4}
    (told,) = messages(counts, 5.0)
    for text in (told.title, told.what, told.why, told.remedy):
        said = load_sentences("de").best(text)
        assert said.english_letters == 0, said
