"""Ready English sentences in another language, as frontend/src/state/sentences.ts does it.

Pure: a text is looked up as it is, then by the templates with places and in parts, whichever
leaves least in English; what a place caught is looked up in turn. What is not known stays.
"""

import re
from collections.abc import Callable, Iterator, Mapping, Sequence
from dataclasses import dataclass, replace
from functools import cache

from app.strings.files import ENGLISH, languages, load_strings

PLACE = re.compile(r"\{(\w+)\}")
SENTENCE_END = re.compile(r"(?<=[.?]) (?=[A-Z])")
JOINTS = (SENTENCE_END, *map(re.compile, (" · ", ": ", "; ", ", ")))
"""Where a text is put together of others, the loosest joint first."""
MOST_JOINTS = 8
LOOSE = " ,;·"
UNITS = frozenset(
    ["mm", "µm", "µs", "ms", "ns", "px", "rms", "Hz", "fps", "GB", "MB", "UTC", "rad", "min"]
)
CACHE_SIZE = 2000
"""Texts whose wording is remembered: every report has numbers of its own."""
_WORDS = re.compile(r"[^\W\d_]{2,}")


@dataclass(frozen=True)
class Translation:
    """A text in the other language, and how many letters of it are not."""

    text: str
    english_letters: int
    missed: frozenset[str] = frozenset()
    """What of it was not known."""


class Sentences:
    """Every sentence of one language."""

    def __init__(self, strings: Mapping[str, str]) -> None:
        self._strings = strings
        self._templates: dict[str, list[tuple[re.Pattern[str], list[str], str]]] = {}
        self._cache: dict[str, Translation] = {}
        for text in sorted((text for text in strings if "{" in text), key=_template_rank):
            names = PLACE.findall(text)
            literals = (re.escape(literal) for literal in re.split(r"\{\w+\}", text))
            pattern = re.compile("(.*?)".join(literals), re.S)
            self._templates.setdefault(_template_key(text), []).append(
                (pattern, names, strings[text])
            )

    def translate(self, text: str) -> str:
        """The text in the language."""
        return self.best(text).text

    def best(self, text: str) -> Translation:
        """Of all ways to say it, the one that leaves least in English."""
        best = self._cache.get(text)
        if best is None:
            best = self._search(text)
            if len(self._cache) >= CACHE_SIZE:
                self._cache.clear()
            self._cache[text] = best
        return best

    def _search(self, text: str) -> Translation:
        core = text.strip(LOOSE)
        if core and core != text:
            # it goes on with a sentence: what joins it stays
            before, _, after = text.partition(core)
            said = self.best(core)
            return replace(said, text=before + said.text + after)
        best = Translation(text, _letters(text), frozenset({text}))
        if best.english_letters == 0 or "\n" in text:  # what has lines is of the program's log
            return Translation(text, 0)
        for said in self._candidates(text):
            if said.english_letters < best.english_letters:
                best = said
            if best.english_letters == 0:
                break
        return best

    def _candidates(self, text: str) -> Iterator[Translation]:
        """With or without its full stop, with its first letter either way, and in parts."""
        yield from self._case_variants(text)
        stop = text.endswith(".")
        for said in self._case_variants(text[:-1] if stop else f"{text}."):
            yield replace(said, text=f"{said.text}." if stop else said.text.removesuffix("."))
        yield from self._part_variants(text)

    def _case_variants(self, text: str) -> Iterator[Translation]:
        small = text[:1] == text[:1].lower()
        other = (text[:1].upper() if small else text[:1].lower()) + text[1:]
        # a name known whole is not put together of its words: "Contact points" is no "{n} points"
        whole = text not in self._strings and other in self._strings
        if not whole:
            yield from self._match_templates(text)
        if other != text:
            for said in self._match_templates(other):
                yield said if small else replace(said, text=said.text[:1].upper() + said.text[1:])
        if whole:
            yield from self._match_templates(text)

    def _match_templates(self, text: str) -> Iterator[Translation]:
        if text in self._strings:
            yield Translation(self._strings[text], 0)
        words = text.split(" ")
        for key in (f"{words[0]} ", f" {words[-1]}", ""):
            for pattern, names, other in self._templates.get(key, ()):
                match = pattern.fullmatch(text)
                # a place never stands for the end of one sentence and the beginning of the next
                if match is None or any(SENTENCE_END.search(part) for part in match.groups()):
                    continue
                caught = [self.best(part) for part in match.groups()]
                values = {name: said.text for name, said in zip(names, caught, strict=True)}
                yield _join_parts(format_message(other, values), caught)

    def _part_variants(self, text: str) -> Iterator[Translation]:
        """Parted at each joint in turn, where there are few; else at all of a kind at once."""
        for joint in JOINTS:
            found = list(joint.finditer(text))
            if len(found) > MOST_JOINTS:
                said = [self.best(piece) for piece in joint.split(text)]
                yield _join_parts(found[0][0].join(part.text for part in said), said)
                continue
            for at in found:
                said = [self.best(text[: at.start()]), self.best(text[at.end() :])]
                yield _join_parts(at[0].join(part.text for part in said), said)


def format_message(text: str, values: Mapping[str, object]) -> str:
    """The places replaced by their values; one without a value stays."""
    return PLACE.sub(lambda place: str(values.get(place[1], place[0])), text)


@cache
def load_sentences(language: str) -> Sentences:
    """The sentences of a language; English has none to look up.

    Raises:
        FileNotFoundError: there is no such language.
    """
    return Sentences({} if language == ENGLISH else load_strings(language))


def translator(language: str) -> Callable[[str], str] | None:
    """What puts texts into a language; None for English, and where there is none such."""
    return load_sentences(language).translate if language in languages()[1:] else None


def _join_parts(text: str, parts: Sequence[Translation]) -> Translation:
    left = sum(part.english_letters for part in parts)
    return Translation(text, left, frozenset[str]().union(*(part.missed for part in parts)))


def _letters(text: str) -> int:
    """How much of a text is words; units and what is all capitals are none."""
    words = _WORDS.findall(text)
    return sum(len(word) for word in words if word not in UNITS and word != word.upper())


def _template_rank(text: str) -> int:
    """Of two templates that fit alike, the one that says more itself is tried first."""
    return -len(PLACE.sub("", text))


def _template_key(text: str) -> str:
    """What a text must begin or end with to fit: a whole word, where the template has one there."""
    words = text.split(" ")
    if len(words) > 1 and "{" not in words[0]:
        return f"{words[0]} "
    if len(words) > 1 and "{" not in words[-1]:
        return f" {words[-1]}"
    return ""
