"""The check of what runs in the background: loops that fail or failed, and threads that died."""

from collections.abc import Sequence

from crenel.findings import Quality
from crenel.loop_states import LoopFailure, LoopHang, LoopState
from crenel.messages.message import Text, join, message, quantity
from crenel.monitoring.health import HealthItem

REPORTED_S = 3600.0
"""Reported for this long after the newest failure."""


def background(
    loops: Sequence[LoopState], deaths: Sequence[LoopFailure], now_s: float, since_s: float
) -> HealthItem:
    """Whether everything runs that runs all the time.

    Args:
        now_s, since_s: now, and when the station began (``time.monotonic``).
    """
    since_s = max(since_s, now_s - REPORTED_S)
    failed = [one for one in loops if one.newest is not None and one.newest.at_s >= since_s]
    failing = [one for one in failed if one.failing]
    dead = [one for one in deaths if one.at_s >= since_s]
    stood = [(one.name, one.hang) for one in loops if one.hang and one.hang.at_s >= since_s]
    standing = [one for one in stood if one[1].is_now]
    parts: list[Text] = [_hang(*one, now_s) for one in standing]
    parts += [_loop(one, now_s) for one in failing]
    parts += [_hang(*one, now_s) for one in stood if one not in standing]
    parts += [_loop(one, now_s) for one in failed if not one.failing]
    parts += [_death(one, now_s) for one in dead]
    quality: Quality = "bad" if failing or standing else "attention" if parts else "good"
    running = sum(one.running for one in loops)
    return HealthItem(
        "background",
        message("background-work"),
        quality,
        join(parts, " ") if parts else message("background-work-runs", count=running),
        message("background-work-why"),
        message("background-work-remedy") if parts else "",
    )


def _loop(one: LoopState, now_s: float) -> Text:
    assert one.newest is not None
    values = {"part": loop_name(one.name), "count": one.failures, "error": one.newest.error}
    if one.failing:
        return message("loop-fails-now", **values)
    return message("loop-works-again", **values, ago=quantity(now_s - one.newest.at_s, "s"))


def _hang(name: str, hang: LoopHang, now_s: float) -> Text:
    values = {"part": loop_name(name), "stood": quantity(hang.stood_s, "s"), "where": hang.where}
    if hang.is_now:
        return message("loop-stands-now", **values)
    return message("loop-goes-on", **values, ago=quantity(now_s - hang.at_s, "s"))


def _death(one: LoopFailure, now_s: float) -> Text:
    ago = quantity(now_s - one.at_s, "s")
    return message("thread-has-died", name=one.name, error=one.error, ago=ago)


def loop_name(name: str) -> Text:
    """What a loop does, in words."""
    return message("loop-name", name=name)
