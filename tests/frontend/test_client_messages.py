"""The client's language files and CSS modules have all that it uses, and no others."""

import re
from pathlib import Path

import pytest
from fluent.syntax import FluentParser
from fluent.syntax.ast import Comment, Junk, Message, ResourceComment

from crenel.messages.language_file import languages
from tests.frontend.node import FRONTEND
from tests.frontend.test_client_checks import places_by_id

SOURCES = FRONTEND / "src"
COMMON = "messages"
USED = re.compile(r'"(ui-[a-z0-9-]+)"')
IMPORT = re.compile(r'import (\w+) from "(\.[^"]+\.module\.css)"')


def language_files(language: str) -> list[Path]:
    return sorted(SOURCES.rglob(f"{language}.ftl"))


def source(language: str) -> str:
    return "".join(file.read_text(encoding="utf-8") for file in language_files(language))


def used_ids() -> set[str]:
    """As literals in the code; nothing composes an id."""
    return {
        text_id for path in sources() for text_id in USED.findall(path.read_text(encoding="utf-8"))
    }


def sources() -> list[Path]:
    return [
        path
        for path in SOURCES.rglob("*.ts*")
        if path.name != "places.ts" and ".test." not in path.name
    ]


def test_every_language_of_the_station_is_one_of_the_client() -> None:
    assert {path.stem for path in SOURCES.rglob("*.ftl")} == set(languages())


def test_the_ids_are_those_that_are_used() -> None:
    ids = places_by_id(source("en")).keys()
    assert sorted(used_ids() - ids) == []
    assert sorted(ids - used_ids()) == []
    assert len(ids) > 500


@pytest.mark.parametrize("language", languages())
def test_a_file_has_nothing_but_messages(language: str) -> None:
    for file in language_files(language):
        body = FluentParser().parse(file.read_text("utf-8")).body
        assert [entry.content for entry in body if isinstance(entry, Junk)] == []
        assert all(isinstance(entry, (Message, Comment, ResourceComment)) for entry in body)
        ids = [entry.id.name for entry in body if isinstance(entry, Message)]
        assert ids == sorted(set(ids))
        assert all(text_id.startswith("ui-") for text_id in ids)


def test_a_text_stands_beside_the_code_that_uses_it() -> None:
    """The common folder has what several folders use, and no other has what one outside uses."""
    users: dict[str, set[str]] = {}
    for path in sources():
        for text_id in USED.findall(path.read_text("utf-8")):
            place = path.relative_to(SOURCES).parts
            users.setdefault(text_id, set()).add(place[0] if place[1:] else COMMON)
    assert not [
        f"{file.relative_to(SOURCES)}: {text_id}"
        for file in language_files("en")
        for text_id in places_by_id(file.read_text("utf-8"))
        if (folder := file.parent.name)
        and (
            len(users[text_id] - {COMMON}) == len(users[text_id]) == 1
            if folder == COMMON
            else users[text_id] != {folder}
        )
    ]


def test_every_id_stands_once() -> None:
    ids = [one for file in language_files("en") for one in places_by_id(file.read_text("utf-8"))]
    assert len(ids) == len(set(ids))


@pytest.mark.parametrize("language", languages()[1:])
def test_a_language_has_the_same_texts_with_the_same_places(language: str) -> None:
    assert places_by_id(source(language)) == places_by_id(source("en"))


def unknown_classes(component: Path) -> list[str]:
    """The classes in a component that their CSS module does not have."""
    text = component.read_text("utf-8")
    found = []
    for name, address in IMPORT.findall(text):
        css = (component.parent / address).read_text("utf-8")
        known = set(re.findall(r"\.([A-Za-z]\w*)", css))
        used = set(re.findall(rf"\b{name}\.(\w+)", text))
        found += [f"{component.name}: {name}.{one}" for one in sorted(used - known)]
    return found


def test_every_class_is_in_its_css_module() -> None:
    components = sorted((FRONTEND / "src").rglob("*.tsx"))
    assert len(components) > 100
    assert not [one for component in components for one in unknown_classes(component)]


def test_an_unknown_class_is_found(tmp_path: Path) -> None:
    (tmp_path / "a.module.css").write_text(".row { color: red }")
    component = tmp_path / "A.tsx"
    component.write_text('import styles from "./a.module.css";\nstyles.row; styles.column;')
    assert unknown_classes(component) == ["A.tsx: styles.column"]
