"""Texts of payloads as data: what is published, and what is taken from any publisher."""

import json

import jsonschema
import pytest

from crenel.messages.message import Message, Text, join, message, quantity
from crenel.supervision.inbox import LONGEST_BYTES
from crenel.supervision.message_data import MOST_CHARACTERS, MOST_DEPTH, MOST_PARTS, message_data
from crenel.supervision.messages import KINDS, StationEvent, schema
from crenel.supervision.remote_stations import Fleet
from tests.bench.faults.broker.usual_messages import make_event, make_report

SILENT = message("no-data", title=message("word-arm"), silent=quantity(0.9, "s", 1))
ENGLISH = "No data from the arm for 0.9 s"


def event_with(data: object, text: str = ENGLISH) -> bytes:
    plain = make_event("a", "1", 1).model_dump()
    return json.dumps({**plain, "text": text, "text_message": data}).encode()


def shown(data: object) -> tuple[object, dict[str, int]]:
    """The text of an event with this data as the browser gets it, and what was not read."""
    fleet = Fleet()
    fleet.take("a", "report", make_report("a", "1").model_dump_json().encode(), False)
    fleet.take("a", "event", event_with(data), False)
    (station,) = fleet.stations()
    events = station.model_dump(mode="json")["events"]
    return (events[0]["text"] if events else None), dict(fleet.unread.counts)


@pytest.mark.parametrize(
    "text",
    [
        SILENT,
        join([SILENT, "DESK-1"], "; "),
        quantity(-1.5, "mm", 2),
        message("errors-or-none-last-hour", count=3),
    ],
)
def test_a_text_arrives_as_its_data(text: Text) -> None:
    data = message_data(text)
    event = StationEvent.model_validate_json(event_with(data))
    assert event.text_message == text
    assert json.loads(event.model_dump_json())["text_message"] == data
    assert shown(data) == (data, {})


def test_without_data_or_with_that_of_another_version_the_english_is_shown() -> None:
    unknown: tuple[object, ...] = (
        None,
        {"message_id": "of-a-later-version", "values": {}},
        {"message_id": "no-data", "values": {"title": {"message_id": "later", "values": {}}}},
        {"value": 1.0, "unit": "furlong", "decimals": 0, "signed": False},
        {"value": 1.0, "unit": "mm", "decimals": 400, "signed": False},
        {"something": "else"},
        "a sentence",
        ["a", "list"],
        7,
    )
    for data in unknown:
        assert shown(data) == (ENGLISH, {}), data


def nested(depth: int) -> object:
    data: object = "x"
    for _ in range(depth):
        data = {"items": [data], "separator": ""}
    return data


HOSTILE: dict[str, object] = {
    "deep": nested(MOST_DEPTH),
    "very deep": nested(90),
    "many": {"items": ["x"] * MOST_PARTS, "separator": ""},
    "long": {"message_id": "no-data", "values": {"title": "x" * MOST_CHARACTERS, "silent": ""}},
    "long names": {"message_id": "no-data", "values": {"x" * MOST_CHARACTERS: ""}},
    "large": {"message_id": "errors-or-none-last-hour", "values": {"count": 10**300}},
    "larger": {"value": 10**400, "unit": "mm", "decimals": 0, "signed": False},
}


@pytest.mark.parametrize("data", HOSTILE.values(), ids=HOSTILE)
def test_what_is_no_message_in_size_or_shape_is_not_read(data: object) -> None:
    assert shown(data) == (None, {"strange": 1})


def test_numbers_that_json_does_not_have_are_not_read() -> None:
    for number in ("1e999", "NaN", "-Infinity"):
        payload = event_with({"value": 0.5, "unit": "mm", "decimals": 0, "signed": False})
        fleet = Fleet()
        fleet.take("a", "event", payload.replace(b"0.5", number.encode()), False)
        assert fleet.unread.counts == {"strange": 1}, number


def test_what_is_too_large_is_not_published() -> None:
    assert message_data(message("no-data", title="x" * MOST_CHARACTERS, silent="")) is None
    assert message_data("plain") is None
    longest = message("no-data", title="x" * 1100, silent="")
    assert len(event_with(message_data(longest), "x" * 400)) < LONGEST_BYTES["event"]


def test_reports_are_shown_with_messages_and_published_with_both() -> None:
    report = make_report("a", "1")
    device = report.devices[0].model_copy(update={"text": ENGLISH, "text_message": SILENT})
    report = report.model_copy(update={"devices": (device,)})
    payload = report.model_dump_json().encode()
    sent = json.loads(payload)["devices"][0]
    assert (sent["text"], sent["text_message"]) == (ENGLISH, message_data(SILENT))
    jsonschema.validate(json.loads(payload), schema())
    fleet = Fleet()
    fleet.take("a", "report", payload, False)
    view = fleet.stations()[0].model_dump(mode="json")["report"]
    assert view["devices"][0]["text"] == message_data(SILENT)
    assert view["activity"]["title"] == "Nothing is running"
    assert "_message" not in json.dumps(dict.fromkeys(_names(view)))


def _names(value: object) -> list[str]:
    if isinstance(value, dict) and "message_id" not in value:
        return [*value, *(name for inner in value.values() for name in _names(inner))]
    if isinstance(value, list):
        return [name for inner in value for name in _names(inner)]
    return []


def test_every_payload_may_have_data_beside_each_of_its_texts() -> None:
    def models(kind: type) -> set[str]:
        return {name for name in kind.model_fields if name.endswith("_message")}  # type: ignore[attr-defined]

    assert models(KINDS["event"]) == {"text_message"}
    assert isinstance(
        StationEvent.model_validate_json(event_with(message_data(SILENT))).text_message, Message
    )
