"""Why an image is rejected, and where the block lies elsewhere."""

from dataclasses import dataclass

import numpy as np


@dataclass(frozen=True)
class RejectionReason:
    """Why the picture does not bear a placing out.

    ``definite``: it shows other measures, rather than too little; ``edges``: rows in the
    wireframe of those that disagree. ``alone``: a single edge says so, and nothing bears it
    out; a shadow or something before the block may look like that. ``off_px``: how far the
    picture shows them elsewhere, at most. ``hidden``: what shows is in its place, but edges
    without which it cannot be told do not.
    """

    text: str
    definite: bool = False
    edges: tuple[int, ...] = ()
    alone: bool = False
    off_px: float = np.inf
    hidden: bool = False


def describe_edge(edge: str) -> str:
    """The name of an edge in an operator's words: merlons and grooves counted from the left.

    ``crest:1:L`` is the left edge of merlon 2's crest, ``wall:0:R:front`` the upright
    front edge on merlon 1's right.
    """
    sides = {"L": "left", "R": "right", "front": "front", "back": "back"}
    kind, *rest = edge.split(":")
    if kind == "base":
        return f"the base's {sides[rest[0]]} edge"
    number, side = int(rest[0]) + 1, sides[rest[1]]
    if kind == "wall":
        return f"the upright {rest[2]} edge on merlon {number}'s {side}"
    return f"the {side} edge of " + (
        f"merlon {number}'s crest" if kind == "crest" else f"groove {number}'s floor"
    )


def size_mismatch(
    edge: str, off_mm: float, off_px: float, edges: tuple[int, ...], alone: bool = False
) -> RejectionReason:
    """The objection that a size differs: an edge of it, how far it lies off, all its edges."""
    return RejectionReason(
        f"{describe_edge(edge)} seems to lie {off_mm:.2f} mm from where the certificate puts it",
        True,
        edges,
        alone,
        off_px,
    )
