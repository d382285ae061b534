"""In words, what took the pieces of a line and what left others, and whether there is one."""

from collections.abc import Iterator, Mapping

import numpy as np

from crenel.messages.message import Text, message
from crenel.metrology.stripe import LineEvidence, LineReason, PieceReason
from crenel.metrology.stripe.line_evidence import PIECE_REASONS

PIECE_TEXTS: Mapping[PieceReason, Text] = {
    "main": message("piece-taken-most-light"),
    "bright": message("piece-taken-brighter-than-clutter"),
    "continued": message("piece-taken-line-goes-on"),
    "dim": message("piece-left-dim-as-clutter"),
    "ghost": message("piece-left-beneath-line"),
    "no-line": message("piece-left-without-line"),
}
LINE_TEXTS: Mapping[LineReason, Text] = {
    "no-rival": message("line-hardly-rivalled"),
    "alone": message("line-stands-alone"),
    "long": message("line-crosses-most-of-picture"),
    "wide": message("line-in-nearly-all-columns"),
    "in-the-dark": message("line-bright-in-the-dark"),
    "bright": message("line-outshines-picture"),
    "no-points": message("line-without-points"),
    "cluttered": message("line-as-bright-as-clutter"),
    "dim-picture": message("line-as-bright-as-picture"),
}


def count_pieces(why: LineEvidence) -> Iterator[tuple[PieceReason, int]]:
    """How many points each reason took or left; none of those that did nothing."""
    counts = np.bincount(np.concatenate([why.taken, why.left]), minlength=len(PIECE_REASONS))
    for reason, count in zip(PIECE_REASONS, counts.tolist(), strict=True):
        if count:
            yield reason, count
