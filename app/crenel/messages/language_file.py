"""The language files, whose messages are parsed when they are first shown.

They stand beside the code that uses their messages: one file a language in a folder of a package,
at most two folders deep. What several packages use, and the words, stand in this folder, which has
a file of every language.

Of the four thousand messages a command shows twenty, and to parse them all takes 0.4 s.
"""

import re
import threading
from functools import cache
from importlib.util import find_spec
from pathlib import Path
from typing import TYPE_CHECKING

if TYPE_CHECKING:
    from fluent.runtime import FluentBundle
    from fluent.syntax import ast

PACKAGES = ("crenel", "crenel_hardware")
DEPTHS = ("", "*/", "*/*/")
COMMON = Path(__file__).parent
ENGLISH = "en"
_START = re.compile(r"^([a-zA-Z][\w-]*) *=", re.M)
"""Finds the beginning of a message: its id at the beginning of a line. What belongs to it is
indented."""


def languages() -> tuple[str, ...]:
    """The codes of all languages there are, English first."""
    others = sorted(path.stem for path in COMMON.glob("*.ftl") if path.stem != ENGLISH)
    return (ENGLISH, *others)


def language_files(language: str) -> list[Path]:
    """The files of a language, those of one package after those of another."""
    return [
        path
        for folder in _package_folders()
        for depth in DEPTHS
        for path in sorted(folder.glob(f"{depth}{language}.ftl"))
    ]


def _package_folders() -> list[Path]:
    specs = (find_spec(package) for package in PACKAGES)
    return [Path(one) for spec in specs if spec for one in spec.submodule_search_locations or ()]


@cache
def read_sources(language: str) -> dict[str, str]:
    """The source of each message by its id.

    Raises:
        FileNotFoundError: there is no such language.
    """
    files = language_files(language)
    if not files:
        raise FileNotFoundError(f"{language}.ftl")
    return {one: source for file in files for one, source in _sources_of(file).items()}


def _sources_of(file: Path) -> dict[str, str]:
    text = file.read_text(encoding="utf-8")
    starts = list(_START.finditer(text))
    ends = [start.start() for start in starts[1:]] + [len(text)]
    return {start[1]: text[start.start() : end] for start, end in zip(starts, ends, strict=True)}


class LanguageFile:
    """Adds messages to a bundle as they are needed; from any thread."""

    def __init__(self, language: str, bundle: "FluentBundle") -> None:
        self._unread, self._bundle = dict(read_sources(language)), bundle
        self._lock = threading.Lock()

    def load(self, message_id: str) -> bool:
        """Adds a message and those that it refers to; False where the file does not have it."""
        if self._bundle.has_message(message_id):
            return True
        with self._lock:
            self._add(message_id)
        return self._bundle.has_message(message_id)

    def _add(self, message_id: str) -> None:
        from fluent.runtime import FluentResource

        source = self._unread.pop(message_id, None)
        if source is None:
            return
        resource = FluentResource(source)
        for referenced in _references(resource):
            self._add(referenced)
        self._bundle.add_resource(resource)


def _references(resource: "ast.Resource") -> list[str]:
    """The ids of the messages that a parsed source refers to."""
    from fluent.syntax import ast, visitor

    found: list[str] = []

    class References(visitor.Visitor):
        def visit_MessageReference(self, node: ast.MessageReference) -> None:  # noqa: N802
            found.append(node.id.name)

    References().visit(resource)
    return found
