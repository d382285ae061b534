"""The stripe of a colour picture: by its colour, and by the channel of that colour."""

from dataclasses import dataclass, replace

import numpy as np

from crenel.messages.message import Text, message
from crenel.metrology.bayer import BayerPlane
from crenel.metrology.channel import Channel, describe_channel, select_channel
from crenel.metrology.colour import PLANES, Colours, ColourWeights, LaserColour
from crenel.metrology.coloured_line import ColouredLine, find_coloured_line
from crenel.metrology.stripe import FoundLine, LineSearch, StripeSettings, find_stripe
from crenel.metrology.stripe.smoothing import smooth_stripe

ON_LINE_PX = 3.0
"""Two points of a column are of one line if they lie no further apart, or half its width."""
AGREES, AS_MUCH, HALF = 0.9, 0.97, 0.5
"""Shares of common columns in which two lines agree, and of the other's columns that a line has."""


@dataclass(frozen=True)
class ColourStripe:
    """A stripe of a colour picture. ``text``: what was measured. ``channel``: that of its colour,
    None without a stripe."""

    found: FoundLine
    channel: Channel | None
    text: Text = ""


def is_by_colour(settings: StripeSettings, channel: Channel | None) -> bool:
    """Whether a colour picture's line is looked for by its colour, too: neither the operator nor
    the weights of channels say how it stands out."""
    return settings.is_automatic and not isinstance(channel, BayerPlane | ColourWeights)


def extract_by_colour(
    picture: Colours,
    axis: str,
    search: LineSearch,
    colour: LaserColour | None,
) -> ColourStripe | None:
    """The stripe of a colour picture; None without one in any colour.

    Args:
        search: what is set of the line.
        colour: of the laser; None: the one that shows most of a line.
    """
    settings, where = search.settings, search.usable_pixels(axis)
    unsmoothed = replace(settings, smoothing_px=0.0)
    line = find_coloured_line(picture, axis, tuple(PLANES) if colour is None else (colour,), where)
    channel = line.colour if line is not None else colour
    if channel is None:
        return None
    grey = select_channel(picture, channel)
    assert grey is not None
    plain = find_stripe(grey, axis, search.where, unsmoothed, search.bounds)
    found, text = plain, describe_channel(channel)
    if line is not None:
        found = choose_line(plain, line.found)
        text = text if found is plain else describe_combination(line)
    stripe = smooth_stripe(found.stripe, settings.smoothing_px, found.saturated)
    return ColourStripe(replace(found, stripe=stripe), channel, text)


def describe_combination(line: ColouredLine) -> Text:
    """What of the picture a coloured line was measured on, in words."""
    if line.combination == "all":
        return message("channel-mean-of-all")
    colour = describe_channel(line.colour)
    if line.combination == "beyond":
        return message("channel-beyond-others", colour=colour)
    return colour


def choose_line(plain: FoundLine, line: FoundLine) -> FoundLine:
    """The line by its channel alone if that shows as much, otherwise the one by its colour.

    The channel alone measures more exactly; colour shows more of a line in a lit room.
    """
    if not len(plain.stripe.u):
        return line
    along, across = line.stripe.along_across
    plain_along, plain_across = plain.stripe.along_across
    _, ours, theirs = np.intersect1d(np.rint(along), np.rint(plain_along), return_indices=True)
    apart = np.abs(across[ours] - plain_across[theirs])
    agrees = apart <= max(ON_LINE_PX, line.width_px / 2)
    if len(ours) < HALF * min(len(along), len(plain_along)) or agrees.mean() < AGREES:
        return line if len(along) >= HALF * len(plain_along) else plain
    return plain if len(theirs) >= AS_MUCH * len(along) else line
