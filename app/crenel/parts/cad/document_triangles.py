"""Triangles as a file has them, before they are one surface, and how a file of them is refused."""

from dataclasses import dataclass
from pathlib import Path

import numpy as np
from numpy.typing import NDArray

from crenel.errors import OperationError
from crenel.formats.file_names import display_path
from crenel.messages.message import Message, Text, message, rounded
from crenel.metrology.transforms import Floats

MOST_TRIANGLES = 50_000_000
FARTHEST_MM = 1e7
"""As of clouds: an arm measures no points further away than this."""


@dataclass(frozen=True)
class Triangles:
    """The triangles of a file, in its unit."""

    corners: Floats
    """(T, 3, 3), anticlockwise as seen from outside."""
    form: str
    """Its format, as users call it."""
    mm_per_unit: float | None = None
    """Of its numbers, if the file states it."""
    body: NDArray[np.int32] | None = None
    """(T,) which of several bodies each is of, from 0; None: they are not known."""


def scale_triangles(path: Path, read: Triangles, mm_per_unit: float) -> tuple[Floats, int]:
    """The corners (T, 3, 3) in mm, and how many triangles have none and are left out.

    Raises:
        OperationError: one is too far away, or there are none.
    """
    corners = read.corners * mm_per_unit
    finite = np.isfinite(corners).all(axis=(1, 2))
    corners = corners if finite.all() else corners[finite]
    largest = float(np.abs(corners).max(initial=0.0))
    if largest > FARTHEST_MM:
        raise OperationError(
            "mesh-too-far",
            message("has-coordinate", path=display_path(path), coordinate=f"{largest:.3g} mm"),
            message("arm-measures-within", farthest=rounded(FARTHEST_MM / 1000, "m")),
            message("mesh-state-unit"),
        )
    if not len(corners):
        raise mesh_error(path, message("mesh-without-triangles"))
    return corners, int(np.sum(~finite))


def mesh_error(path: Path, why: Text) -> OperationError:
    """A file that is not as its format has it."""
    return OperationError("mesh-malformed", display_path(path), why, export_again())


def mesh_truncation_error(path: Path, found: int, announced: int) -> OperationError:
    """A file that holds fewer triangles than its header says."""
    return OperationError(
        "mesh-cut-off",
        message(
            "mesh-contains-triangles-of",
            path=display_path(path),
            found=found,
            announced=announced,
        ),
        message("file-cut-off"),
        export_again(),
    )


def check_triangle_count(path: Path, count: int) -> None:
    """Raises ``OperationError`` for more triangles than a part has."""
    if count > MOST_TRIANGLES:
        raise mesh_error(path, message("mesh-of-too-many-triangles", most=MOST_TRIANGLES))


def export_again() -> Message:
    """The remedy of a damaged file."""
    return message("mesh-export-again")
