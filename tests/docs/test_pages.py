"""The pages of the documents: links lead somewhere, and commands exist."""

import re
from pathlib import Path

import pytest
from typer import Typer
from typer.core import TyperGroup
from typer.main import get_command

import crenel
from crenel.cli.main import cli
from tests.bench.__main__ import modules
from tests.bench.commands import bench
from tests.sources import ROOT

PAGES = sorted([*ROOT.glob("*.md"), *ROOT.glob("docs/*.md"), *ROOT.glob("docker/*.md")])
LINK = re.compile(r"!?\[[^\]]+\]\(([^)\s]+)\)")
ELSEWHERE = {"batch", "catalogue", "drift", "figures", "shopping-lists"}
"""Benchmarks whose figures are on another page, and the comparison of all of them."""
FENCED = re.compile(r"^ *```.*?^ *```$", re.MULTILINE | re.DOTALL)


def anchors(page: Path) -> set[str]:
    """Of its headings, as code hosts name them."""
    headings = re.findall(r"^#+ (.+)$", FENCED.sub("", page.read_text("utf-8")), re.MULTILINE)
    return {re.sub(r"[^\w\- ]", "", heading.lower()).replace(" ", "-") for heading in headings}


def test_the_public_interface_is_described() -> None:
    page = (ROOT / "docs/python.md").read_text("utf-8")
    rows = re.findall(r"^\| (`.*?) \|", page, re.MULTILINE)
    described = [name for row in rows for name in re.findall(r"`(\w+)`", row)]
    assert sorted(described) == crenel.__all__
    assert all(getattr(crenel, name).__doc__ for name in described)
    with pytest.raises(AttributeError, match="no attribute 'extract_line'"):
        crenel.extract_line  # type: ignore[attr-defined]  # noqa: B018


def commands_of(program: Typer) -> set[str]:
    group = get_command(program)
    assert isinstance(group, TyperGroup)
    return set(group.commands)


def names(page: str, command: str) -> set[str]:
    return set(re.findall(rf"\b{command} ([a-z][a-z-]+)", (ROOT / page).read_text("utf-8")))


@pytest.mark.parametrize("page", PAGES, ids=lambda page: page.relative_to(ROOT).as_posix())
def test_links_lead_somewhere(page: Path) -> None:
    for link in LINK.findall(FENCED.sub("", page.read_text("utf-8"))):
        if link.startswith("https://"):
            continue
        file, _, anchor = link.partition("#")
        target = (page.parent / file).resolve() if file else page
        assert target.exists(), link
        assert not anchor or anchor in anchors(target), link


def test_every_page_is_in_the_index_and_in_the_readme() -> None:
    index, readme = (ROOT / "docs/README.md").read_text("utf-8"), (ROOT / "README.md").read_text()
    for page in (ROOT / "docs").glob("*.md"):
        if page.name != "README.md":
            assert f"({page.name})" in index, page.name
            assert f"(docs/{page.name})" in readme, page.name


def test_the_readme_is_short() -> None:
    assert len((ROOT / "README.md").read_text("utf-8").splitlines()) <= 150


def test_the_command_line_page_names_the_commands() -> None:
    page = (ROOT / "docs/command-line.md").read_text("utf-8")
    assert set(re.findall(r"^crenel ([a-z-]+)", page, re.MULTILINE)) == commands_of(cli)


@pytest.mark.parametrize("page", ["README.md", "docs/accuracy.md", "docs/operating.md"])
def test_commands_exist(page: str) -> None:
    assert names(page, "`crenel") <= commands_of(cli)


def test_benchmarks_exist_and_the_page_of_figures_names_them() -> None:
    known = commands_of(bench) | set(modules())
    page = (ROOT / "docs/accuracy.md").read_text("utf-8")
    pages = [path.read_text("utf-8") for path in PAGES if path.name != "CHANGELOG.md"]
    named = {
        one for text in pages for one in re.findall(r"python -m tests\.bench ([a-z]\S+)", text)
    }
    assert {one.strip("`.,;:)") for one in named} <= known
    assert not commands_of(bench) & set(modules())
    assert {one for one in known if f"tests.bench {one}" not in page} <= ELSEWHERE
