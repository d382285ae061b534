"""The font of reports: Inter, reduced to Latin, Greek and Cyrillic, with tabular figures. Its
licence is next to it."""

from pathlib import Path

FONTS = Path(__file__).parent
REGULAR, SEMIBOLD = FONTS / "Inter-Regular.ttf", FONTS / "Inter-SemiBold.ttf"
