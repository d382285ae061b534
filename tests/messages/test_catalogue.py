"""Texts in the words of a language: numbers beside limits, plurals, texts within texts."""

import ast
import json
from collections.abc import Callable, Iterator, Sequence
from decimal import Decimal
from pathlib import Path

import pytest
from hypothesis import given
from hypothesis import strategies as st

from crenel.messages.catalogue import Catalogue, in_english, isolate_names, renderer
from crenel.messages.language_file import languages, read_sources
from crenel.messages.limits import MOST_DECIMALS, beside_limit, decimals_beside
from crenel.messages.message import (
    Message,
    MessageList,
    Quantity,
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
from crenel.report.fonts.pdf_fonts import replace_missing
from crenel.report.html import escape
from tests.sources import READS_TREE, name_of, python_files, reads_tree

pytestmark = READS_TREE

HEBREW, ARABIC = "זרוע מדידה", "ذراع القياس"
ENGLISH, GERMAN = renderer("en"), renderer("de")
LIMITS = {"limit", "good", "most", "least", "wanted", "noisy", "edge_rms_px"}
"""Names of the values of messages that are limits."""
NUMBERS = {"quantity", "rounded", "signed"}


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
        (rms(12000), "Contact points, rms of 12000 points", "Antastpunkte, rms von 12000 Punkten"),
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
    left_out = message("excluded-for-reason", text=message("arm-model-arm", serial_number="A7"))
    assert ENGLISH(left_out) == "Excluded: the arm model belongs to arm A7."


def test_lists_join_texts() -> None:
    texts = join([word("front"), quantity(0.5, "mm", 1), "J2.alpha"], "; ")
    assert ENGLISH(texts) == "front; 0.5 mm; J2.alpha"
    assert GERMAN(texts).endswith("; 0,5 mm; J2.alpha")
    assert ENGLISH(message("take-one", languages=join(["en", "de"]))) == "Choose one of en, de"
    assert ENGLISH(join([])) == ""


def test_a_text_as_a_sentence_and_with_a_capital() -> None:
    half = message("arm-not-held-still")
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
    assert replace_missing("a\u202eb") == "a□b"


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

    monkeypatch.setattr("crenel.messages.language_file.COMMON", tmp_path)
    monkeypatch.setattr("crenel.messages.language_file._package_folders", lambda: [tmp_path])
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
    for text in (message("arm-not-held-still"), quantity(1, "mm"), join([])):
        with pytest.raises(TypeError, match="value of a message"):
            f"{text}"
    moved = message("arm-not-held-still")
    assert str(moved) == in_english(moved) == "the arm was not held still"


@pytest.mark.parametrize(
    "text",
    [
        "plain",
        "",
        quantity(-2.5, "µm", 1),
        signed(3.0),
        message("arm-not-held-still"),
        message("contacts-rms", count=3),
        message("excluded-for-reason", text=message("known-k-1", known=quantity(2.5, "µm", 1))),
        join(["one", join([message("arm-not-held-still"), quantity(1.0, "%")], " · ")], "; "),
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


def shown(number: Quantity) -> Decimal:
    """What a reader sees."""
    return Decimal(renderer("en")(number).replace(",", "").split()[0].replace("−", "-"))


@given(
    st.floats(0.001, 900),
    st.one_of(st.sampled_from([0.0, 0.004, -0.004, 0.06, -0.4, 1e-4]), st.floats(-9, 9)),
    st.integers(0, 3),
)
def test_no_number_is_rounded_over_its_limit(limit: float, off: float, decimals: int) -> None:
    value = limit + off
    if 0 < abs(value - limit) < 10**-MOST_DECIMALS:
        return
    number, beside = beside_limit(value, limit, "", decimals)
    assert (shown(number) > shown(beside)) == (value > limit)
    assert (shown(number) < shown(beside)) == (value < limit)
    assert number.decimals >= decimals


def test_a_limit_that_somebody_set_is_shown_as_it_is() -> None:
    assert [one.value for one in beside_limit(1.5, 0.25, "s", 1)] == [1.5, 0.25]
    assert [one.value for one in beside_limit(13.0, 12.5, "µm")] == [13.0, 12.5]
    assert str(beside_limit(13.0, 12.3456, "µm")[1]) == "12 µm"
    assert beside_limit(13.0, 12.3456, "µm")[1].value == 12.3456  # for whom it is shown in inch


@pytest.mark.parametrize(
    ("value", "limits", "decimals", "enough"),
    [
        (0.31, [0.3], 2, 2),
        (0.3004, [0.3], 1, 4),
        (24.96, [25.0], 0, 2),
        (25.0, [25.0], 0, 0),
        (189.6, [120.0, 190.0], 0, 1),
    ],
)
def test_it_has_as_many_decimals_as_show_it(
    value: float, limits: list[float], decimals: int, enough: int
) -> None:
    assert decimals_beside(value, limits, decimals) == enough


@reads_tree
def rounded_alone(nodes: Sequence[ast.AST]) -> list[int]:
    """Lines of messages with a limit that is rounded without the number beside it."""
    found = []
    for node in nodes:
        if isinstance(node, ast.Call) and getattr(node.func, "id", "") == "message":
            numbers = {
                one.arg
                for one in node.keywords
                if isinstance(one.value, ast.Call) and getattr(one.value.func, "id", "") in NUMBERS
            }
            if numbers & LIMITS and numbers - LIMITS:
                found.append(node.lineno)
    return found


def test_limits_are_rounded_with_the_numbers_beside_them() -> None:
    found = [
        f"{name_of(path)}:{line}"
        for path in python_files("app/crenel")
        for line in rounded_alone(path)
    ]
    assert not found
