"""The files of this folder: one a language, the English text to the other, sorted."""

import json
from collections.abc import Mapping
from functools import cache
from pathlib import Path

FOLDER = Path(__file__).parent
ENGLISH = "en"
Strings = Mapping[str, str]


def languages() -> tuple[str, ...]:
    """The codes of all languages there are, English first."""
    others = sorted(path.stem for path in FOLDER.glob("*.json") if path.stem != ENGLISH)
    return (ENGLISH, *others)


@cache
def load_strings(language: str) -> Strings:
    """A language's texts.

    Raises:
        FileNotFoundError: there is no such language.
    """
    strings: Strings = json.loads((FOLDER / f"{language}.json").read_text(encoding="utf-8"))
    return strings


def write(language: str, strings: Strings) -> None:
    """Writes a language's file, sorted as translators and differences like it."""
    ordered = {text: strings[text] for text in sorted(strings)}
    text = json.dumps(ordered, ensure_ascii=False, indent=1)
    (FOLDER / f"{language}.json").write_text(text + "\n", encoding="utf-8")
