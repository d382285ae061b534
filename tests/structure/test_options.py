"""What a layer below the commands says names no option that only some of them have."""

import re

from tests.sources import python_files, text_of

OPTION = re.compile(r"(?<![\w-])-o\b")
BELOW = ("formats", "workflows", "store", "station", "api", "guide", "report", "metrology")


def test_files_are_written_for_commands_with_and_without_o() -> None:
    for path in python_files(*(f"app/{folder}" for folder in BELOW)):
        assert not OPTION.search(text_of(path)), path
