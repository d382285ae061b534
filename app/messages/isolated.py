"""Names in any script within sentences of another, as frontend/src/state/isolated.ts has it."""

import re

FIRST_STRONG, POP = "\u2068", "\u2069"
TURNING = re.compile("[\u202a-\u202e\u2066-\u2069]")
"""Signs that turn all that follows."""
_LEFTWARDS = (
    "[\u0590-\u08ff\u200f\ufb1d-\ufdff\ufe70-\ufefc\U00010800-\U00010fff\U0001e800-\U0001efff]"
)
_RUN = re.compile(f"{_LEFTWARDS}(?:[\\d _'’-]*{_LEFTWARDS})*")
"""Letters from right to left with what stands between them."""
_ISOLATES = re.compile(f"\u2068[^\u202a-\u202e\u2066-\u2069]*\u2069|{TURNING.pattern}")
"""Those that are not of a text that was isolated before."""


def isolate_names(text: str) -> str:
    """A text in which what is written from right to left leaves the rest in its place.

    Signs that turn the text are seen and do nothing.
    """
    if text.isascii():
        return text
    plain = _ISOLATES.sub(lambda found: found[0] if len(found[0]) > 1 else "\ufffd", text)
    if FIRST_STRONG in plain:
        return plain
    return _RUN.sub(lambda run: f"{FIRST_STRONG}{run[0]}{POP}", plain)
