"""What must never stand in the project's files."""

import re
import subprocess
from pathlib import Path

from tests.sources import PACKAGES, ROOT, python_files, text_of

STARTED_MODULES = ()  # Git
OPTION = re.compile(r"(?<![\w-])-o\b")
BELOW = ("formats", "workflows", "store", "station", "api", "guide", "report", "metrology")
"""Layers below the commands, of which only some have the option."""
UNWANTED = {
    "an unfinished place": re.compile(r"\b(TODO|FIXME|XXX|HACK)\b"),
    "a download address": re.compile(r'"resolved":|registry\.[a-z]+js\.|files\.python' + "hosted"),
}


def test_files_are_written_for_commands_with_and_without_o() -> None:
    for path in python_files(*(f"{PACKAGES['crenel']}/{folder}" for folder in BELOW)):
        assert not OPTION.search(text_of(path)), path


def test_no_file_holds_what_must_not_be_there() -> None:
    command, found = ["git", "ls-files", "-z"], []
    listed = subprocess.run(command, cwd=ROOT, capture_output=True, text=True, check=True).stdout
    for path in [ROOT / name for name in listed.split("\0") if name]:
        if not path.is_file() or path == Path(__file__) or path.name == "LICENSE":
            continue
        try:
            text = path.read_text(encoding="utf-8")
        except UnicodeDecodeError:
            continue
        for what, pattern in UNWANTED.items():
            for match in pattern.finditer(text):
                line = text.count("\n", 0, match.start()) + 1
                found.append(f"{path.relative_to(ROOT)}:{line}: {what}: {match.group()}")
    assert not found, "\n".join(found)
