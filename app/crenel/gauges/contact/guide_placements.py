"""The twenty placements of the ball bar in words."""

from crenel.gauges.plan.maths_length_places import FAR, NEAR, TWENTY
from crenel.messages.message import Text, message

LIES = {
    (1.0, 0.0, 0.0): "away",
    (0.0, 1.0, 0.0): "across",
    (0.0, 0.0, 1.0): "up",
    (1.0, 0.0, 1.0): "rising-away",
    (0.0, 1.0, 1.0): "rising-left",
    (1.0, 1.0, 1.0): "rising-away-left",
    (1.0, -1.0, 1.0): "rising-away-right",
}
"""How a bar lies, by its direction: away from the arm, left, up."""


def placement_words(number: int) -> Text:
    """How the bar lies in a placement (1 to 20), how far away, and where as seen from the arm.

    Example:
        >>> print(placement_words(1))
        horizontal, across, near, 60° to the right
    """
    bearing_deg, share, direction = TWENTY[number - 1]
    return message(
        "performance-placement",
        lies=LIES[direction],
        at="near" if share == NEAR else "far" if share == FAR else "middle",
        side="left" if bearing_deg > 0 else "right" if bearing_deg < 0 else "ahead",
        bearing=round(abs(bearing_deg)),
    )
