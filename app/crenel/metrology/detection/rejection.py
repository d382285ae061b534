"""Reasons for rejecting a hypothesis, and where the picture shows the block instead."""

from dataclasses import dataclass

import numpy as np

from crenel.messages.message import Text, message, quantity


@dataclass(frozen=True)
class RejectionReason:
    """Why the picture does not confirm a hypothesis.

    ``definite``: the picture shows different dimensions, rather than too little; ``edges``: rows in
    the wireframe of the edges that disagree. ``alone``: a single edge shows it, and nothing
    confirms it; a shadow or an object in front of the block may look like that. ``off_px``: the
    largest distance at which the picture shows them. ``hidden``: the visible edges are in place,
    but edges that are necessary for a decision are hidden.
    """

    text: Text
    definite: bool = False
    edges: tuple[int, ...] = ()
    alone: bool = False
    off_px: float = np.inf
    hidden: bool = False


def describe_edge(edge: str) -> Text:
    """The display name of an edge; merlons and grooves are counted from the left.

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
    """The rejection because a dimension differs: an edge of it, its distance, and all its edges."""
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
