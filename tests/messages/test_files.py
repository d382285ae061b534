"""The language files have exactly what the code uses, each with the same variables."""

import ast
import re
from collections.abc import Iterator, Mapping, Sequence
from dataclasses import dataclass, replace
from functools import cache
from pathlib import Path

import pytest
from fluent.runtime import FluentBundle, FluentResource
from fluent.syntax import ast as ftl

from crenel.messages.catalogue import FUNCTIONS
from crenel.messages.language_file import COMMON, ENGLISH, language_files, languages
from tests.sources import PROGRAM, READS_TREE, ROOT, name_of, python_files, reads_tree

pytestmark = READS_TREE

OTHERS = languages()[1:]
COMMON_PACKAGES = (None, {COMMON}, {COMMON.parent})
"""What several packages use, or modules of none, stands in the common file."""
MADE_FROM_TERMS = ("word-",)
"""Beginnings of ids that code makes from a term of its own, as ``word`` does."""


@dataclass(frozen=True)
class References:
    """What an entry of a language file refers to."""

    variables: frozenset[str]
    messages: frozenset[str]


@dataclass(frozen=True)
class Call:
    """A use of a message in code; ``complete``: all its values are named there."""

    line: int
    message_id: str
    values: frozenset[str]
    complete: bool
    where: str = ""


@cache
def resource(language: str) -> ftl.Resource:
    return FluentResource("".join(one.read_text("utf-8") for one in language_files(language)))


def walk(node: object) -> Iterator[ftl.BaseNode]:
    """A node of a language file and all below it."""
    if isinstance(node, list):
        for item in node:
            yield from walk(item)
    elif isinstance(node, ftl.BaseNode):
        yield node
        for item in vars(node).values():
            yield from walk(item)


@cache
def references(language: str) -> Mapping[str, References]:
    """Of each message by its id."""
    messages: dict[str, References] = {}
    for entry in resource(language).body:
        if isinstance(entry, ftl.Message):
            nodes = list(walk(entry))
            messages[entry.id.name] = References(
                frozenset(one.id.name for one in nodes if isinstance(one, ftl.VariableReference)),
                frozenset(one.id.name for one in nodes if isinstance(one, ftl.MessageReference)),
            )
    return messages


@cache
def calls() -> tuple[Call, ...]:
    return tuple(
        replace(call, where=f"{name_of(path)}:{call.line}")
        for path in python_files(*PROGRAM)
        for call in calls_of(path)
    )


@reads_tree
def calls_of(nodes: Sequence[ast.AST]) -> list[Call]:
    """The uses of messages in a file; an id that is not written out is empty."""
    found = []
    for node in nodes:
        match node:
            case ast.Call(func=ast.Name(id="message"), args=[first], keywords=keywords):
                message_id = str(first.value) if isinstance(first, ast.Constant) else ""
                names = {keyword.arg for keyword in keywords}
                values = frozenset(name for name in names if name is not None)
                found.append(Call(node.lineno, message_id, values, None not in names))
            case ast.Call(func=ast.Name(id="word"), args=[ast.Constant(value=str(term))]):
                message_id = f"word-{term.replace(' ', '-')}"
                found.append(Call(node.lineno, message_id, frozenset(), True))
    return found


@pytest.mark.parametrize("language", languages())
def test_a_file_parses_and_has_no_id_twice(language: str) -> None:
    junk = [entry.content for entry in resource(language).body if isinstance(entry, ftl.Junk)]
    assert not junk
    ids = [entry.id.name for entry in resource(language).body if isinstance(entry, ftl.Message)]
    assert not {one for one in ids if ids.count(one) > 1}


def test_every_id_is_written_out() -> None:
    assert not [call.where for call in calls() if not call.message_id]


def test_every_message_of_the_code_is_in_english() -> None:
    assert len(calls()) > 1000
    assert not [
        f"{call.where}: {call.message_id}"
        for call in calls()
        if call.message_id not in references(ENGLISH)
    ]


def test_every_variable_has_a_value_from_each_call() -> None:
    assert not [
        f"{call.where}: {call.message_id} lacks {sorted(missing)}"
        for call in calls()
        if call.complete
        and call.message_id in references(ENGLISH)
        and (missing := references(ENGLISH)[call.message_id].variables - call.values)
    ]


def test_every_value_is_used_by_some_language() -> None:
    used: dict[str, set[str]] = {message_id: set() for message_id in references(ENGLISH)}
    for language in languages():
        for message_id, one in references(language).items():
            used.setdefault(message_id, set()).update(one.variables)
    assert not [
        f"{call.where}: {call.message_id} has no place for {sorted(unused)}"
        for call in calls()
        if call.message_id in references(ENGLISH)
        and (unused := call.values - used[call.message_id])
    ]


def test_no_message_is_unused() -> None:
    used = {call.message_id for call in calls()}
    used.update(*(one.messages for one in references(ENGLISH).values()))
    assert not [
        message_id
        for message_id in references(ENGLISH)
        if message_id not in used and not message_id.startswith(MADE_FROM_TERMS)
    ]


def ids_of(file: Path) -> list[str]:
    body = FluentResource(file.read_text("utf-8")).body
    return [entry.id.name for entry in body if isinstance(entry, ftl.Message)]


def test_a_message_stands_beside_the_code_that_uses_it() -> None:
    """No file has what modules outside its folder use, and the common one not what one package
    alone uses."""
    users: dict[str, set[Path]] = {}
    for call in calls():
        module = ROOT / call.where.rpartition(":")[0]
        users.setdefault(call.message_id, set()).add(module)
    assert not [
        f"{name_of(file)}: {one}"
        for file in language_files(ENGLISH)
        for one in ids_of(file)
        if (modules := users.get(one))
        and (
            packages_of(modules) not in COMMON_PACKAGES
            if file.parent == COMMON
            else any(file.parent not in module.parents for module in modules)
        )
    ]


def packages_of(modules: set[Path]) -> set[Path] | None:
    """The folder of the package that has the modules; None if several have them."""
    places = [module.relative_to(ROOT).parts[:-1] for module in modules]
    found = {ROOT.joinpath(*place[: 2 if place[0] == "hardware" else 3]) for place in places}
    return found if len(found) == 1 else None


@pytest.mark.parametrize("language", OTHERS)
def test_every_file_has_the_messages_of_its_english_one_in_order(language: str) -> None:
    for file in language_files(ENGLISH):
        ids = ids_of(file)
        assert ids == sorted(ids), file
        assert ids == ids_of(file.with_name(f"{language}.ftl"))
    assert len(language_files(language)) == len(language_files(ENGLISH))


@pytest.mark.parametrize("language", OTHERS)
def test_every_language_has_every_message_with_the_same_variables(language: str) -> None:
    english, other = references(ENGLISH), references(language)
    assert not english.keys() ^ other.keys()
    assert not [
        message_id
        for message_id, one in english.items()
        if one.variables != other[message_id].variables
    ]


@pytest.mark.parametrize("language", languages())
@pytest.mark.parametrize("value", [1, 7, "name"])
def test_every_message_can_be_rendered(language: str, value: int | str) -> None:
    bundle = FluentBundle([language], FUNCTIONS, use_isolating=False)
    bundle.add_resource(resource(language))
    failed = {}
    for message_id, one in references(language).items():
        pattern = bundle.get_message(message_id).value
        assert pattern is not None, message_id
        text, errors = bundle.format_pattern(pattern, dict.fromkeys(one.variables, value))
        if errors or not str(text).strip():
            failed[message_id] = errors
    assert not failed


ENGLISH_FILES = (*language_files(ENGLISH), *(ROOT / "frontend/src").rglob(f"{ENGLISH}.ftl"))
NEGATIONS = {"not", "no", "none", "nothing", "cannot", "never", "neither", "nor", "without"}
NEGATIVE = {*NEGATIONS, "missing", "lost", "few", "only", "else", "other", "beyond", "too"}
"""Words of an id that say what a negation of its text says."""


def texts() -> Iterator[tuple[str, str]]:
    """Each id of the English files with its text in small letters; variants stand in a row."""
    for file in ENGLISH_FILES:
        for entry in FluentResource(file.read_text("utf-8")).body:
            if isinstance(entry, ftl.Message):
                parts = [one.value for one in walk(entry.value) if isinstance(one, ftl.TextElement)]
                yield entry.id.name, " ".join(parts).lower()


def omits_negation(message_id: str, text: str) -> bool:
    """Whether an id is made of words of the text's first clause, in order, but for a negation."""
    words = re.findall(r"[a-z0-9]+", re.split(r"[.:;]", text)[0])
    name = message_id.removeprefix("ui-").split("-")
    if NEGATIVE.intersection(name) or any(one.startswith(("un", "in", "dis")) for one in name):
        return False
    places: list[int] = []
    for one in name:
        if one not in words[(places[-1] + 1 if places else 0) :]:
            return False
        places.append(words.index(one, places[-1] + 1 if places else 0))
    around = words[max(places[0] - 1, 0) : places[-1] + 2]
    return not NEGATIONS.isdisjoint(around)


def test_an_id_does_not_say_the_opposite_of_its_text() -> None:
    assert not [one for one, text in texts() if omits_negation(one, text)]


def test_an_id_is_not_numbered() -> None:
    """A number in an id is one of its text."""
    for message_id, text in texts():
        number = re.search(r"-(\d+)$", message_id)
        assert number is None or number[1] in re.findall(r"\d+", text), message_id
