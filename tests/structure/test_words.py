"""Words that the glossary replaced are not used again, in names, comments and texts."""

import io
import re
import tokenize
from collections.abc import Iterator
from pathlib import Path

import pytest

ROOT = Path(__file__).parents[2]
RETIRED = frozenset(
    ("told", "papers", "luck", "lucky", "stray", "strays", "suspect", "suspects", "suspected")
    + ("twin", "twins", "sheet", "sheets", "deed", "deeds", "anew", "forthwith", "astray")
)
WORD = re.compile(r"[A-Za-z][a-z]*")
SOURCES = ("app", "hardware", "tests")
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


def python_words(path: Path) -> Iterator[tuple[int, str]]:
    """Each word of names, strings and comments, with its line."""
    for token in tokenize.generate_tokens(io.StringIO(path.read_text("utf-8")).readline):
        if token.type in (tokenize.NAME, tokenize.STRING, tokenize.COMMENT):
            yield from ((token.start[0], word) for word in words(token.string))


def python_files(source: str) -> Iterator[tuple[str, Path]]:
    """Files that are looked at, by their names in the project."""
    for path in sorted((ROOT / source).rglob("*.py")):
        if path.name not in LISTED:
            yield path.relative_to(ROOT).as_posix(), path


@pytest.mark.parametrize("source", SOURCES)
def test_python_uses_no_retired_word(source: str) -> None:
    assert not [
        f"{name}:{line}: {word}"
        for name, path in python_files(source)
        for line, word in python_words(path)
        if word in RETIRED
    ]


@pytest.mark.parametrize("source", SOURCES)
def test_python_uses_no_retired_name(source: str) -> None:
    assert not [
        f"{name}: {one[0]}"
        for name, path in python_files(source)
        if name not in FORMER
        for one in RETIRED_NAMES.finditer(path.read_text("utf-8"))
    ]


@pytest.mark.parametrize("file", ["app/messages/en.ftl", "frontend/src/messages/en.ftl"])
def test_english_messages_use_no_retired_word(file: str) -> None:
    lines = (ROOT / file).read_text("utf-8").splitlines()
    assert not [line for line in lines if RETIRED.intersection(words(line))]


def test_a_retired_word_is_found_in_a_name_and_in_a_comment(tmp_path: Path) -> None:
    path = tmp_path / "module.py"
    path.write_text("told_mm = 1  # by luck\nisTwin = 'anew'\nstraight = 2\n")
    found = {word for _, word in python_words(path)} & RETIRED
    assert found == {"told", "luck", "twin", "anew"}
