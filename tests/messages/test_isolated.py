"""Names from right to left, and signs that turn the text, leave the rest in its place."""

import pytest

from app.messages.catalogue import isolate_names
from app.report.html import escape
from app.report.pdf import _replace_missing

HEBREW, ARABIC = "זרוע מדידה", "ذراع القياس"


@pytest.mark.parametrize(
    ("text", "shown"),
    [
        ("plain, Ø 3 µm and 臂 and 🦾", "plain, Ø 3 µm and 臂 and 🦾"),
        (f"{HEBREW} 12, serial number 7", f"\u2068{HEBREW}\u2069 12, serial number 7"),
        (f"{HEBREW}, {ARABIC}", f"\u2068{HEBREW}\u2069, \u2068{ARABIC}\u2069"),
        ("scan \u202egnp.exe", "scan \ufffdgnp.exe"),
        ("a \u2069\u2067b", "a \ufffd\ufffdb"),
    ],
)
def test_a_text_with_names_in_any_script(text: str, shown: str) -> None:
    assert isolate_names(text) == shown
    assert isolate_names(shown) == shown


def test_reports_isolate_whatever_they_show() -> None:
    assert escape(f"{HEBREW} <12>") == f"\u2068{HEBREW}\u2069 &lt;12&gt;"
    assert "\u202e" not in escape("a\u202eb")
    assert _replace_missing("a\u202eb") == "a□b"
