"""Words that the glossary replaced are not used again, in names, comments and texts."""

import re
from collections.abc import Iterator
from pathlib import Path

import pytest

from tests.sources import ALL, ROOT, name_of, python_files, text_of

RETIRED = frozenset(
    ("told", "papers", "luck", "lucky", "stray", "strays", "suspect", "suspects", "suspected")
    + ("twin", "twins", "sheet", "sheets", "deed", "deeds", "anew", "forthwith", "astray")
)
WORD = re.compile(r"[A-Za-z][a-z]*")
RETIRED_NAMES = re.compile(
    r"\b((let|stop|has)_hand|hand_(running|started|stopped)|no-hand(?!-)|wall_link|wall_id|scrapers?)\b"
)
"""Of words that are right elsewhere: a person's hand, the wall of a groove."""
LISTED = (Path(__file__).name, "test_names.py")
"""Files that name the words to find them."""
FORMER = (
    "app/guide/common/journal.py",
    "app/server/middleware.py",
    "app/store/schemas.py",
    "app/wire/schema.py",
    "tests/api/test_earlier_version.py",
    "tests/store/test_access.py",
    "tests/store/test_earlier_versions.py",
)
"""Files with names of earlier versions, whose requests and data are still understood."""


def words(text: str) -> Iterator[str]:
    """The words of a name or a text, in small letters."""
    yield from (word.lower() for word in WORD.findall(text))


def retired_words(text: str) -> list[tuple[int, str]]:
    """Each retired word of a text, with its line."""
    small = text.lower()
    likely = [word for word in RETIRED if word in small]  # most files have none
    return [
        (number, word)
        for number, line in enumerate(text.splitlines() if likely else (), 1)
        if any(one in line.lower() for one in likely)
        for word in words(line)
        if word in RETIRED
    ]


def looked_at() -> list[Path]:
    return [path for path in python_files(*ALL) if path.name not in LISTED]


def test_python_uses_no_retired_word() -> None:
    assert not [
        f"{name_of(path)}:{line}: {word}"
        for path in looked_at()
        for line, word in retired_words(text_of(path))
    ]


def test_python_uses_no_retired_name() -> None:
    assert not [
        f"{name_of(path)}: {one[0]}"
        for path in looked_at()
        if name_of(path) not in FORMER
        for one in RETIRED_NAMES.finditer(text_of(path))
    ]


@pytest.mark.parametrize("file", ["app/messages/en.ftl", "frontend/src/messages/en.ftl"])
def test_english_messages_use_no_retired_word(file: str) -> None:
    assert not retired_words((ROOT / file).read_text("utf-8"))


def test_a_retired_word_is_found_in_a_name_and_in_a_comment() -> None:
    text = "told_mm = 1  # by luck\nisTwin = 'anew'\nstraight = 2\n"
    assert retired_words(text) == [(1, "told"), (1, "luck"), (2, "twin"), (2, "anew")]
