"""The type that reports are set in: Inter, cut to Latin, Greek and Cyrillic, its figures of one
width. Its licence lies beside it."""

from pathlib import Path

FONTS = Path(__file__).parent / "fonts"
REGULAR, SEMIBOLD = FONTS / "Inter-Regular.ttf", FONTS / "Inter-SemiBold.ttf"
