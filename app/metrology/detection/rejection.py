"""Why an image is rejected, and where the block lies elsewhere."""

from dataclasses import dataclass

import numpy as np

from app.messages.message import Text, message, quantity


@dataclass(frozen=True)
class RejectionReason:
    """Why the picture does not confirm a hypothesis.

    ``definite``: it shows other measures, rather than too little; ``edges``: rows in the
    wireframe of those that disagree. ``alone``: a single edge shows it, and nothing confirms
    it; a shadow or something before the block may look like that. ``off_px``: how far the
    picture shows them elsewhere, at most. ``hidden``: what shows is in its place, but edges
    without which it cannot be decided do not.
    """

    text: Text
    definite: bool = False
    edges: tuple[int, ...] = ()
    alone: bool = False
    off_px: float = np.inf
    hidden: bool = False


def describe_edge(edge: str) -> Text:
    """The name of an edge for people: merlons and grooves counted from the left.

    ``crest:1:L`` is the left edge of merlon 2's crest, ``wall:0:R:front`` the upright
    front edge on merlon 1's right.
    """
    sides = {"L": "left", "R": "right", "front": "front", "back": "back"}
    kind, *rest = edge.split(":")
    if kind == "base":
        return message("edge-of-base", side=sides[rest[0]])
    number, side = int(rest[0]) + 1, sides[rest[1]]
    if kind == "wall":
        return message("upright-edge-of-merlon", end=rest[2], number=number, side=side)
    if kind == "crest":
        return message("edge-of-crest", side=side, number=number)
    return message("edge-of-floor", side=side, number=number)


def size_mismatch(
    edge: str, off_mm: float, off_px: float, edges: tuple[int, ...], alone: bool = False
) -> RejectionReason:
    """The objection that a size differs: an edge of it, how far it lies off, all its edges."""
    return RejectionReason(
        message(
            "seems-lie-where-certificate-puts",
            edge=describe_edge(edge),
            off=quantity(off_mm, "mm", 2),
        ),
        True,
        edges,
        alone,
        off_px,
    )
