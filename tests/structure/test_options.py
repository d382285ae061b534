"""What a layer below the commands says names no option that only some of them have."""

import re
from pathlib import Path

ROOT = Path(__file__).parents[2]
OPTION = re.compile(r"(?<![\w-])-o\b")


def test_files_are_written_for_commands_with_and_without_o() -> None:
    for folder in (
        "formats",
        "workflows",
        "store",
        "station",
        "api",
        "guide",
        "report",
        "metrology",
    ):
        for path in sorted((ROOT / "app" / folder).rglob("*.py")):
            assert not OPTION.search(path.read_text()), path
