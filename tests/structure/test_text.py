"""What must never stand in the project's files."""

import re
import subprocess
from pathlib import Path

STARTED_MODULES = ()  # Git
ROOT = Path(__file__).resolve().parents[2]

UNWANTED = {
    "an unfinished place": re.compile(r"\b(TODO|FIXME|XXX|HACK)\b"),
    "a download address": re.compile(r'"resolved":|registry\.[a-z]+js\.|files\.python' + "hosted"),
}


def tracked_files() -> list[Path]:
    listed = subprocess.run(
        ["git", "ls-files", "-z"], cwd=ROOT, capture_output=True, text=True, check=True
    ).stdout
    return [ROOT / name for name in listed.split("\0") if name and (ROOT / name).is_file()]


def test_no_file_holds_what_must_not_be_there() -> None:
    found = []
    for path in tracked_files():
        if path == Path(__file__) or path.name == "LICENSE":
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
