"""What took the pieces of a line, and what left others, as the extraction decided it."""

from dataclasses import dataclass
from typing import Literal, get_args

import numpy as np
from numpy.typing import NDArray

from crenel.metrology.stripe.scales import Scale
from crenel.metrology.stripe.workspace import Workspace
from crenel.metrology.transforms import Floats

PieceReason = Literal["main", "bright", "continued", "dim", "ghost", "no-line"]
"""What takes a piece, or leaves it (from ``dim`` on), in the order of ``workspace.h``."""
LineReason = Literal[
    "no-rival",
    "alone",
    "long",
    "wide",
    "in-the-dark",
    "bright",
    "no-points",
    "cluttered",
    "dim-picture",
]
"""What decides that there is a line, or none (from ``no-points`` on)."""
PIECE_REASONS: tuple[PieceReason, ...] = get_args(PieceReason)
LINE_REASONS: tuple[LineReason, ...] = get_args(LineReason)


@dataclass(frozen=True, slots=True)
class LineEvidence:
    """What decided about a line.

    ``taken``: (N,) index in ``PIECE_REASONS`` of what took each point of the stripe. ``along``,
    ``across``, ``left``: (M,) points of pieces that were left, in the pixels of the turned image,
    and the index of what left them.
    """

    decision: LineReason
    taken: NDArray[np.int32]
    along: Floats
    across: Floats
    left: NDArray[np.int32]


def read_evidence(workspace: Workspace, points: int, scale: Scale) -> LineEvidence:
    """What the last extraction in a workspace decided; ``points``: how many it took."""
    fields, left = workspace.fields, workspace.fields.left
    reasons = workspace.view("rows", np.int32)
    along, across = workspace.view("scratch", np.float64)[:, :left].copy()
    return LineEvidence(
        LINE_REASONS[fields.decision],
        reasons[:points].copy(),
        along,
        across if scale.factor == 1 else scale.across_px(across),
        reasons[fields.width - left :][::-1].copy(),
    )
