"""What the station tells the operator: sentences with their weight."""

from dataclasses import dataclass
from typing import Literal

Quality = Literal["good", "attention", "bad", "neutral"]


@dataclass(frozen=True, slots=True)
class Finding:
    """One sentence with the number and the limit, and what to do about it; ``pose`` names the
    one of several poses that it is about."""

    quality: Quality
    text: str
    remedy: str = ""
    pose: int | None = None


def capital(text: str) -> str:
    """With a capital letter, as a sentence begins."""
    return text[:1].upper() + text[1:]


def figures(value: float, decimals: int = 0) -> str:
    """A number with a true minus sign, and none where nothing is left of it."""
    text = f"{abs(value):.{decimals}f}"
    return f"−{text}" if value < 0 and float(text) else text


def format_signed(value: float, decimals: int = 0) -> str:
    """With its sign always, but for nothing."""
    text = figures(value, decimals)
    return f"+{text}" if value > 0 and float(text) else text
