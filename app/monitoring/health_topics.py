"""The check of what stations publish, and what is told of a check that could not be made."""

from collections.abc import Mapping

from app.monitoring.health import HealthItem

REPORTED_S = 3600.0
"""For so long after the newest."""


def messages(counts: Mapping[str, int], ago_s: float | None) -> list[HealthItem]:
    """What on the broker was not read, by the reason; nothing where all was for an hour."""
    if ago_s is None or ago_s > REPORTED_S:
        return []
    number = sum(counts.values())
    parts = [_part(why, counts.get(why, 0)) for why in ("long", "strange", "often", "crowded")]
    told = ", ".join(part for part in parts if part)
    return [
        HealthItem(
            "messages",
            "Messages of stations",
            "attention",
            f"{number} messages on the broker were not read: {told}.",
            "Somebody publishes what no station does, and may hide or falsify what is shown.",
            "Let each station write under its own topic alone, and remove from the broker "
            "what it keeps of others.",
        )
    ]


def not_made(name: str, why: str) -> HealthItem:
    """A check that failed itself, whatever it would have found."""
    reason = why.rstrip(".")
    return HealthItem(
        f"not-made-{name}",
        "A check that failed",
        "attention",
        f"The check {name} cannot be made: {reason}.",
        "What it looks at may be good or bad.",
        "Look at the log below, and send the support bundle to whoever helps.",
    )


def _part(why: str, number: int) -> str:
    if not number:
        return ""
    return {
        "long": f"{number} too long",
        "strange": f"{number} of no station's kind",
        "often": f"{number} faster than they are read",
        "crowded": f"{number} of more stations than are shown",
    }[why]
