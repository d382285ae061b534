"""Texts in files and columns: English for every reader, the message next to it."""

import json
from typing import Any

import pytest

from crenel.messages.message import Message, Text, join, message, quantity, signed, word
from crenel.messages.stored import decode_text, encode_data, restore_text, restore_texts

KNOWN: list[Text] = [
    message("file-cut-off"),
    message("cloud-name-proposal", name="a.ply"),
    message("row-place", path="a.csv", line=3),
    join([message("file-cut-off"), "b", signed(-1.5, "µm", 1)], "; "),
    word("plane"),
    quantity(3.25, "mm", 2),
]


@pytest.mark.parametrize("text", KNOWN)
def test_a_text_is_restored_from_its_data(text: Text) -> None:
    data = encode_data(text)
    assert data is not None
    assert decode_text(str(text), data) == text


@pytest.mark.parametrize(
    "data",
    [
        None,
        "no JSON",
        "[" * 3000,
        "17",
        '{"message_id": "of-a-later-version", "values": {}}',
        '{"message_id": "row-place", "values": {"path": {"message_id": "unknown", "values": {}}}}',
        '{"message_id": "row-place", "values": 7}',
        '{"value": 1.0, "unit": "mm", "decimals": 1000000000}',
        '{"value": 1e999, "unit": "mm", "decimals": 2}',
        '{"items": [{"message_id": "unknown", "values": {}}], "separator": ", "}',
    ],
)
def test_english_is_shown_where_the_data_say_nothing(data: str | None) -> None:
    assert decode_text("in English", data) == "in English"


def test_a_plain_text_and_one_of_great_length_have_no_data() -> None:
    assert encode_data("a name") is None
    assert encode_data(message("cloud-name-proposal", name="a" * 5000)) is None


def test_texts_of_an_object_are_restored_wherever_they_are() -> None:
    cut = {"message_id": "file-cut-off", "values": {}}
    fields: dict[str, Any] = {
        "text": "the file is incomplete",
        "text_message": cut,
        "rows": [{"text": "b", "text_message": cut}, {"text": "c"}],
        "notes": ["d", "e", "f"],
        "notes_message": ["d", cut, {"message_id": "unknown", "values": {}}],
        "short": ["g"],
        "short_message": [cut, cut],
        "number": 1,
        "number_message": cut,
        "points": [[1, 2], [3, 4]],
    }
    restored = restore_texts(json.loads(json.dumps(fields)))
    file_cut = message("file-cut-off")
    assert restored["text"] == file_cut
    assert [row["text"] for row in restored["rows"]] == [file_cut, "c"]
    assert restored["notes"] == ["d", file_cut, "f"]
    assert (restored["short"], restored["number"]) == (["g"], 1)
    assert restored["points"] == [[1, 2], [3, 4]]
    assert restore_texts("text") == "text"


def test_a_message_is_not_made_of_a_value_of_another_kind() -> None:
    assert restore_text("one", ["a"]) == "one"
    assert isinstance(restore_text("one", {"message_id": "file-cut-off", "values": {}}), Message)
