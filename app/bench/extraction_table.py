"""The table in which the extraction stands beside its peers."""

from collections.abc import Sequence
from dataclasses import dataclass

COLUMNS = ("measure", "Crenel", "OpenCV Gauss + parabola", "numpy argmax + centroid")


@dataclass(frozen=True)
class Measured:
    """One line of the table; the peers' cells may be empty."""

    measure: str
    crenel: str
    opencv: str = ""
    centroid: str = ""


def table(rows: Sequence[Measured]) -> list[list[str]]:
    return [[row.measure, row.crenel, row.opencv, row.centroid] for row in rows]
