"""The check of messages on the broker, and the result of a check that failed."""

from collections.abc import Callable, Mapping

from crenel.errors import reason_sentence
from crenel.messages.message import Text, join, message
from crenel.monitoring.health import HealthItem

REPORTED_S = 3600.0
"""Reported for this long after the newest one."""
PARTS: dict[str, Callable[[int], Text]] = {
    "long": lambda count: message("messages-too-long", count=count),
    "strange": lambda count: message("messages-of-no-station", count=count),
    "often": lambda count: message("messages-too-often", count=count),
    "crowded": lambda count: message("messages-of-too-many-stations", count=count),
}
"""Number of unread messages, by reason."""


def messages(counts: Mapping[str, int], ago_s: float | None) -> list[HealthItem]:
    """Messages on the broker that were not read, by reason; None if there were none for an hour."""
    if ago_s is None or ago_s > REPORTED_S:
        return []
    parts = [part(counts[why]) for why, part in PARTS.items() if counts.get(why)]
    return [
        HealthItem(
            "messages",
            message("messages-stations"),
            "attention",
            message("broker-messages-not-read", count=sum(counts.values()), reasons=join(parts)),
            message("somebody-publishes-what-no-station-does"),
            message("let-each-station-write-under-own"),
        )
    ]


def not_made(name: str, why: Text) -> HealthItem:
    """A check that failed to run, whatever its result would have been."""
    return HealthItem(
        f"not-made-{name}",
        message("check-failed"),
        "attention",
        message("check-cannot-made", name=name, reason=why),
        message("what-looks-may-good-bad"),
        message("look-log-below-send-support-bundle"),
    )


def sign_in(provider: str, trouble: Text) -> HealthItem:
    """Whether people can sign in with their accounts of the plant's provider."""
    title, why = message("sign-in-health"), message("sign-in-health-why")
    if trouble:
        remedy = message("sign-in-health-remedy")
        return HealthItem("sign-in", title, "attention", reason_sentence(trouble), why, remedy)
    what = message("sign-in-provider-answers", name=provider)
    return HealthItem("sign-in", title, "good", what, why, "")
