"""Texts in the words of a language: numbers, plurals, texts within texts, and what is unknown."""

import json
from collections.abc import Callable, Iterator
from pathlib import Path

import pytest

from app.messages.catalogue import Catalogue, in_english, isolate_names, renderer
from app.messages.language_file import languages, read_sources
from app.messages.message import (
    Message,
    MessageList,
    Text,
    join,
    message,
    quantity,
    rounded,
    signed,
    text_from_json,
    text_to_json,
    word,
)
from app.report.html import escape
from app.report.pdf import _replace_missing

HEBREW, ARABIC = "זרוע מדידה", "ذراع القياس"
ENGLISH, GERMAN = renderer("en"), renderer("de")


def test_english_is_the_first_language() -> None:
    assert languages()[0] == "en"
    assert "de" in languages()


def rms(count: int) -> Message:
    return message("contacts-rms", count=count)


@pytest.mark.parametrize(
    ("text", "english", "german"),
    [
        (quantity(12.345, "mm", 2), "12.35 mm", "12,35 mm"),
        (quantity(1234567.0), "1234567", "1234567"),
        (quantity(21.5, "°C", 1), "21.5 °C", "21,5 °C"),
        (quantity(1.5, "°", 1), "1.5°", "1,5°"),
        (quantity(7, "″"), "7″", "7″"),
        (quantity(50, "%"), "50 %", "50 %"),
        (quantity(-3.25, "µm", 1), "−3.2 µm", "−3,2 µm"),
        (quantity(-0.04, "mm", 1), "0.0 mm", "0,0 mm"),
        (quantity(3, "µm"), "3 µm", "3 µm"),
        (signed(3, "µm"), "+3 µm", "+3 µm"),
        (signed(-3, "µm"), "−3 µm", "−3 µm"),
        (signed(0.001, "µm", 1), "0.0 µm", "0,0 µm"),
        (rounded(0.1, "mm"), "0.1 mm", "0,1 mm"),
        (rounded(25.0, "mm"), "25 mm", "25 mm"),
        (rounded(2000.0), "2000", "2000"),
        (rounded(5.98765, "mm", 4), "5.988 mm", "5,988 mm"),
        (rounded(float("inf"), "mm"), "inf mm", "inf mm"),
        (rms(0), "Contact points, rms of 0 points", "Antastpunkte, rms von 0 Punkten"),
        (rms(1), "Contact points, rms of 1 point", "Antastpunkte, rms von 1 Punkt"),
        (
            rms(12000),
            "Contact points, rms of 12000 points",
            "Antastpunkte, rms von 12000 Punkten",
        ),
        ("Found at 12.5 mm.", "Found at 12.5 mm.", "Found at 12.5 mm."),
        (Message("no-such-message"), "no-such-message", "no-such-message"),
    ],
)
def test_numbers_plurals_and_what_stays_the_same(text: Text, english: str, german: str) -> None:
    assert ENGLISH(text) == english
    assert GERMAN(text) == german
    assert str(text) == english


def test_texts_within_texts() -> None:
    known = message("known-k-1", known=quantity(2.5, "µm", 1))
    square = rounded(12.5, "mm")
    board = message("inner-corners-mm-apart", columns=8, rows=5, square=square, known=known)
    assert ENGLISH(board) == "8 × 5 inner corners, 12.5 mm apart, uncertainty 2.5 µm (k = 1)"
    german = "8 × 5 innere Ecken, Abstand 12,5 mm, Standardunsicherheit 2,5 µm (k = 1)"
    assert GERMAN(board) == german
    left_out = message("left-out-3", text=message("arm-model-arm", serial_number="A7"))
    assert ENGLISH(left_out) == "Excluded: the arm model belongs to arm A7."


def test_lists_join_texts() -> None:
    texts = join([word("front"), quantity(0.5, "mm", 1), "J2.alpha"], "; ")
    assert ENGLISH(texts) == "front; 0.5 mm; J2.alpha"
    assert GERMAN(texts).endswith("; 0,5 mm; J2.alpha")
    assert ENGLISH(message("take-one", languages=join(["en", "de"]))) == "Choose one of en, de"
    assert ENGLISH(join([])) == ""


def test_a_text_as_a_sentence_and_with_a_capital() -> None:
    half = message("arm-still")
    assert ENGLISH(message("capital", text=half)) == "The arm was not held still"
    assert ENGLISH(message("sentence", text=half)) == "The arm was not held still."
    assert ENGLISH(message("sentence", text="it is over.")) == "It is over."
    file = "gauges/plate.json: is cut off"
    assert ENGLISH(message("sentence", text=file)) == f"{file}."


def test_names_from_right_to_left_leave_the_rest_in_its_place() -> None:
    text = message("name-and-serial-number", name=HEBREW, serial_number="12")
    assert ENGLISH(text) == f"\u2068{HEBREW}\u2069, serial number 12"
    assert "\u202e" not in ENGLISH(message("serial-number", serial_number="a\u202eb"))


@pytest.mark.parametrize(
    ("text", "shown"),
    [
        ("plain, Ø 3 µm and 臂 and 🦾", "plain, Ø 3 µm and 臂 and 🦾"),
        (f"{HEBREW} 12, serial number 7", f"\u2068{HEBREW}\u2069 12, serial number 7"),
        (f"{HEBREW}, {ARABIC}", f"\u2068{HEBREW}\u2069, \u2068{ARABIC}\u2069"),
        ("scan \u202egnp.exe", "scan \ufffdgnp.exe"),
        ("a \u2069\u2067b", "a \ufffd\ufffdb"),
    ],
)
def test_a_text_with_names_in_any_script(text: str, shown: str) -> None:
    assert isolate_names(text) == shown
    assert isolate_names(shown) == shown


def test_reports_isolate_whatever_they_show() -> None:
    assert escape(f"{HEBREW} <12>") == f"\u2068{HEBREW}\u2069 &lt;12&gt;"
    assert "\u202e" not in escape("a\u202eb")
    assert _replace_missing("a\u202eb") == "a□b"


def test_a_missing_value_leaves_the_rest() -> None:
    assert "serial number" in ENGLISH(Message("serial-number"))


@pytest.fixture
def own_files(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> Iterator[Callable[..., None]]:
    """Writes language files by their names; the languages are then these alone."""

    def forget() -> None:
        renderer.cache_clear()
        read_sources.cache_clear()

    def write(**texts: str) -> None:
        for language, text in texts.items():
            (tmp_path / f"{language}.ftl").write_text(text)
        forget()

    monkeypatch.setattr("app.messages.language_file.FOLDER", tmp_path)
    yield write
    forget()


def test_what_a_language_lacks_is_in_english(own_files: Callable[..., None]) -> None:
    own_files(en="here = here\nsize = { $size } wide\n", fr="here = ici\n")
    assert languages() == ("en", "fr")
    french = renderer("fr")
    assert french(message("here")) == "ici"
    assert french(message("size", size=quantity(2, "mm"))) == "2 mm wide"


def test_messages_that_refer_to_each_other_end(own_files: Callable[..., None]) -> None:
    own_files(en="first = 1 { second }\nsecond = 2 { third }\nthird = 3\n")
    assert Catalogue("en").render(message("first")) == "1 2 3"
    own_files(en="first = 1 { second }\nsecond = 2 { first }\n")
    assert Catalogue("en").render(message("second")).startswith("2 1")


def test_an_unknown_language_is_an_error() -> None:
    with pytest.raises(FileNotFoundError):
        renderer("xx")


def test_a_text_in_an_f_string_is_an_error() -> None:
    for text in (message("arm-still"), quantity(1, "mm"), join([])):
        with pytest.raises(TypeError, match="value of a message"):
            f"{text}"
    moved = message("arm-still")
    assert str(moved) == in_english(moved) == "the arm was not held still"


@pytest.mark.parametrize(
    "text",
    [
        "plain",
        "",
        quantity(-2.5, "µm", 1),
        signed(3.0),
        message("arm-still"),
        message("contacts-rms", count=3),
        message("left-out-3", text=message("known-k-1", known=quantity(2.5, "µm", 1))),
        join(["one", join([message("arm-still"), quantity(1.0, "%")], " · ")], "; "),
        message("titled-text", title=join([word("front")]), text=HEBREW),
    ],
)
def test_a_text_goes_into_a_file_and_back(text: Text) -> None:
    data = json.loads(json.dumps(text_to_json(text)))
    back = text_from_json(data)
    assert back == text
    assert GERMAN(back) == GERMAN(text)


@pytest.mark.parametrize(
    "data",
    [None, 3, [], {}, {"message_id": "a"}, {"items": ["a"]}, {"value": "1", "unit": "mm"}]
    + [{"message_id": "a", "values": {"b": None}}, {"items": [None], "separator": ", "}],
)
def test_other_data_is_no_text(data: object) -> None:
    with pytest.raises(ValueError, match="no text"):
        text_from_json(data)


def test_messages_are_equal_by_id_and_values() -> None:
    assert message("tip") == Message("tip", {})
    assert {message("known-k-1", known=quantity(1, "µm")): 1} == {
        message("known-k-1", known=quantity(1, "µm")): 1
    }
    assert message("titled-text", title="a", text=Path("b")).values["text"] == "b"
    assert isinstance(join(["a"]), MessageList)
