"""The languages' files are what the code says, and the sentences are found again in them."""

import json
import re

import pytest

from app.strings.collect import collect_texts, python_texts, typescript_texts
from app.strings.files import FOLDER, languages, load_strings
from app.strings.sentences import Sentences, load_sentences

PLACE = re.compile(r"\{\w+\}")
OTHERS = languages()[1:]


def test_english_is_what_the_code_says() -> None:
    """Brought up to it by ``python -m app.strings``."""
    texts = collect_texts()
    assert dict(load_strings("en")) == {text: text for text in texts}
    assert len(texts) > 2000


@pytest.mark.parametrize("language", OTHERS)
def test_every_language_says_all_of_it_with_the_same_places(language: str) -> None:
    strings = load_strings(language)
    assert strings.keys() == load_strings("en").keys()
    for text, other in strings.items():
        assert other.strip(), text
        assert sorted(PLACE.findall(text)) == sorted(PLACE.findall(other)), text


@pytest.mark.parametrize("language", languages())
def test_a_file_is_sorted_and_read_by_people(language: str) -> None:
    text = (FOLDER / f"{language}.json").read_text(encoding="utf-8")
    strings = json.loads(text)
    assert list(strings) == sorted(strings)
    assert text == json.dumps(strings, ensure_ascii=False, indent=1) + "\n"


@pytest.mark.parametrize("language", OTHERS)
def test_what_the_browser_fills_in_itself_is_known(language: str) -> None:
    """A template whose places are filled by numbers is found again, whole."""
    sentences, strings = load_sentences(language), load_strings(language)
    unknown = [
        text
        for text in strings
        if (best := sentences.best(PLACE.sub("7", text))).english_letters and best.text == text
    ]
    assert not unknown


def test_of_python_and_of_the_client_only_what_is_said_is_collected() -> None:
    module = '''"""A docstring is not said."""
log.info("nor is a line of the log")
text = f"{count} point{'s' if count != 1 else ''} of {len(all_points)} lie {off_um:.1f} µm off"
raise Refusal("code", "the arm is lost", remedy="Look at its cable")
path = "/api/home"
'''
    assert sorted(python_texts(module)) == [
        "Look at its cable",
        "the arm is lost",
        "{count} point of {all_points} lie {off_um} µm off",
        "{count} points of {all_points} lie {off_um} µm off",
    ]
    client = (
        't("Take the picture"); words("Poses"); counted(n, "1 point", "{n} points"); other("no")'
    )
    assert sorted(typescript_texts(client)) == [
        "1 point",
        "Poses",
        "Take the picture",
        "{n} points",
    ]


STRINGS = {
    "front": "Vorderseite",
    "Hold still": "Still halten",
    "hold it there": "so halten",
    "Touch {count} more points on the {face} face": "Noch {count} Punkte auf „{face}“ antasten",
    "there is no {thing}": "es gibt nicht: {thing}",
    "there is no calibration": "es gibt keine Kalibrierung",
    "without one nothing is known": "ohne eine ist nichts bekannt",
    "left out": "ausgelassen",
}


@pytest.mark.parametrize(
    ("said", "wanted"),
    [
        ("Hold still", "Still halten"),
        ("Hold still.", "Still halten."),
        ("Hold it there.", "So halten."),
        ("Touch 3 more points on the front face.", "Noch 3 Punkte auf „Vorderseite“ antasten."),
        ("there is no file.txt", "es gibt nicht: file.txt"),
        # the template would leave half of it in English
        (
            "There is no calibration: without one nothing is known. Hold still.",
            "Es gibt keine Kalibrierung: ohne eine ist nichts bekannt. Still halten.",
        ),
        ("27 touches, left out", "27 touches, ausgelassen"),
        ("12.8 µm", "12.8 µm"),
        ("Nobody knows this", "Nobody knows this"),
        ("", ""),
    ],
)
def test_a_sentence_is_said_by_the_way_that_leaves_least(said: str, wanted: str) -> None:
    assert Sentences(STRINGS).translate(said) == wanted


def test_a_name_known_whole_is_not_put_together_of_its_words() -> None:
    strings = {"{n} points": "{n} Punkte", "contact": "Kontakt", "contact points": "Antastpunkte"}
    sentences = Sentences(strings)
    assert sentences.translate("Contact points") == "Antastpunkte"
    assert sentences.translate("9 points") == "9 Punkte"
