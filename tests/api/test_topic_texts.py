"""Topics as texts: one for all tabs, and none for what cannot be sent."""

import json
import logging

import pytest

from crenel.wire.topic_texts import TopicTexts
from tests.present import present


def test_all_tabs_receive_the_same_text_until_the_value_changes() -> None:
    texts = TopicTexts()
    value = {"points": 5}
    first = present(texts.of("scan", value))
    assert json.loads(first) == {"type": "topic", "name": "scan", "value": value}
    assert texts.of("scan", value) is first
    assert texts.of("home", value) != first
    changed = present(texts.of("scan", {"points": 6}))
    assert json.loads(changed)["value"] == {"points": 6}


def test_a_value_that_cannot_be_sent_is_logged_once(caplog: pytest.LogCaptureFixture) -> None:
    texts = TopicTexts()
    with caplog.at_level(logging.ERROR):
        for _ in range(3):
            assert texts.of("scan", object()) is None
    assert [record.getMessage() for record in caplog.records] == ["the topic scan cannot be sent"]
    assert texts.of("scan", 5) is not None
