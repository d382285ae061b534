"""Names of functions and classes: verbs or quantities, one meaning each, no retired words."""

import ast
import re
from collections import defaultdict
from collections.abc import Sequence
from pathlib import Path

from tests.sources import ALL, PROGRAM, READS_TREE, ROOT, name_of, python_files, reads_tree, text_of

pytestmark = READS_TREE

IRREGULAR = frozenset(
    (
        *("told", "said", "seen", "held", "known", "shown", "drawn", "given", "taken", "made"),
        *("kept", "found", "left", "lost", "sent", "got", "met", "begun", "done", "gone"),
        *("written", "chosen", "broken", "worn", "driven", "hidden", "thrown", "grown", "bound"),
        *("bent", "built", "dealt", "felt", "heard", "hung", "laid", "led", "lent", "spent"),
        *("stood", "struck", "swept", "taught", "thought", "won"),
    )
)
REGULAR = re.compile(r"^(?!need|seed|feed|speed|exceed|embed|proceed|succeed|shed)\w+ed$")
QUANTITIES = frozenset(
    # an adjective before its noun, or with the noun "quantity" left out
    ("saturated_rms_px", "signed", "rounded")
)

RETIRED = frozenset(
    ("told", "papers", "luck", "lucky", "stray", "strays", "suspect", "suspects", "suspected")
    + ("twin", "twins", "sheet", "sheets", "deed", "deeds", "anew", "forthwith", "astray")
)
WORD = re.compile(r"[A-Za-z][a-z]*")
RETIRED_NAMES = re.compile(
    r"\b((let|stop|has)_hand|hand_(running|started|stopped)|no-hand(?!-)|wall_link|wall_id|scrapers?)\b"
)
"""Of words that are right elsewhere: a person's hand, the wall of a groove."""
FORMER = (
    "app/crenel/guide/common/journal.py",
    "app/crenel/store/schemas.py",
    "tests/store/test_access.py",
    "tests/store/test_earlier_versions.py",
)
"""Files with names of earlier versions, whose requests and data are still understood."""


@reads_tree
def functions(nodes: Sequence[ast.AST]) -> list[tuple[int, str]]:
    """Line and name of those of modules and classes; properties, read like fields, have such
    names."""
    return [
        (child.lineno, child.name)
        for node in nodes
        if isinstance(node, ast.Module | ast.ClassDef)
        for child in node.body
        if isinstance(child, ast.FunctionDef | ast.AsyncFunctionDef)
        and not any("property" in ast.unparse(decorator) for decorator in child.decorator_list)
    ]


@reads_tree
def classes(nodes: Sequence[ast.AST]) -> list[str]:
    module = nodes[0]
    assert isinstance(module, ast.Module)
    return [node.name for node in module.body if isinstance(node, ast.ClassDef)]


def is_participle(word: str) -> bool:
    return word in IRREGULAR or REGULAR.match(word) is not None


def test_no_function_is_named_by_a_participle() -> None:
    named = [
        f"{name_of(path)}:{line} {name}"
        for path in python_files(*PROGRAM)
        for line, name in functions(path)
        if is_participle(name.strip("_").partition("_")[0]) and name not in QUANTITIES
    ]
    assert not named


def test_a_class_name_has_one_meaning() -> None:
    places: dict[str, list[str]] = defaultdict(list)
    for path in python_files(*PROGRAM):
        for name in classes(path):
            places[name].append(name_of(path))
    assert not {name: where for name, where in places.items() if len(where) > 1}


def retired_words(text: str) -> list[tuple[int, str]]:
    """Each word that the glossary replaced, in a name or a text, with its line."""
    small = text.lower()
    likely = [word for word in RETIRED if word in small]  # most files have none
    return [
        (number, word)
        for number, line in enumerate(text.splitlines() if likely else (), 1)
        if any(one in line.lower() for one in likely)
        for word in map(str.lower, WORD.findall(line))
        if word in RETIRED
    ]


def test_python_uses_no_retired_word_and_no_retired_name() -> None:
    assert not [
        f"{name_of(path)}:{line}: {word}"
        for path in python_files(*ALL)
        if path != Path(__file__)
        for line, word in retired_words(text_of(path))
    ]
    assert not [
        f"{name_of(path)}: {one[0]}"
        for path in python_files(*ALL)
        if path != Path(__file__) and name_of(path) not in FORMER
        for one in RETIRED_NAMES.finditer(text_of(path))
    ]


def test_english_messages_use_no_retired_word() -> None:
    files = [
        path
        for folder in ("app/crenel", "hardware/crenel_hardware", "frontend/src")
        for path in (ROOT / folder).rglob("en.ftl")
    ]
    assert files
    assert not [
        f"{name_of(path)}:{line}: {word}"
        for path in files
        for line, word in retired_words(path.read_text("utf-8"))
    ]


def test_a_retired_word_is_found_in_a_name_and_in_a_comment() -> None:
    text = "told_mm = 1  # by luck\nisTwin = 'anew'\nstraight = 2\n"
    assert retired_words(text) == [(1, "told"), (1, "luck"), (2, "twin"), (2, "anew")]
