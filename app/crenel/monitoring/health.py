"""Health checks of the station: each is a finding with a value, its importance and a remedy.

Checks take plain values and access neither clocks nor devices.
"""

from collections.abc import Sequence
from dataclasses import dataclass
from typing import Literal

from crenel.errors import OperationError, sentence
from crenel.findings import GRAVEST_FIRST, Quality
from crenel.messages.limits import beside_limit
from crenel.messages.message import Text, join, message, quantity, signed, word
from crenel.monitoring.loop_watchdog import Stalls
from crenel.monitoring.system_info import Memory
from crenel.station.devices.link_state import DeviceState, link_quality, loss_quality
from crenel.station.devices.losses import Losses
from crenel.station.devices.temperature import Temperature

PROCESS_MEMORY_BYTES, MEMORY_FREE_BYTES = 3_000_000_000, 500_000_000
STALLS_BAD_S = 2.0
READINGS_BAD_S = 600.0
TEMPERATURE_CHANGE_C = 2.0
DeviceKind = Literal["arm", "sensor"]


@dataclass(frozen=True)
class HealthItem:
    """One check."""

    id: str
    title: Text
    quality: Quality
    what: Text
    why: Text
    remedy: Text
    """Empty if no action is needed."""


@dataclass(frozen=True)
class Health:
    """All checks, the worst first."""

    at: str
    quality: Quality
    items: Sequence[HealthItem]


def summarise_health(items: Sequence[HealthItem], at: str) -> Health:
    """The worst check determines the state of the station."""
    ordered = sorted(items, key=lambda item: GRAVEST_FIRST.index(item.quality))
    worst: Quality = ordered[0].quality if ordered else "good"
    return Health(at, "good" if worst == "neutral" else worst, ordered)


def device(kind: DeviceKind, state: DeviceState) -> HealthItem:
    """Whether a device sends data."""
    quality = link_quality(state.state, state.silent)
    what = sentence(state.text)
    if state.state == "connected" and state.age_s is not None and state.rate_hz is not None:
        what = message(
            "second-newest-old",
            text=state.text,
            rate=quantity(state.rate_hz),
            age=quantity(state.age_s, "s", 2),
        )
    return HealthItem(
        f"device-{kind}",
        state.title,
        quality,
        what,
        message("without-nothing-measured-what-taken-kept"),
        ""
        if state.state in ("connected", "absent")
        else message("check-cable-power-looked-again-itself"),
    )


def stamps(kind: DeviceKind, state: DeviceState) -> list[HealthItem]:
    """Where the time stamps of a device come from; nothing while it is not connected."""
    if state.stamps is None:
        return []
    return [
        HealthItem(
            f"stamps-{kind}",
            message("time-stamps-of", device=kind),
            "neutral" if state.stamps == "arrival" else "good",
            message("time-stamps-come-from", stamps=state.stamps),
            message("time-stamps-explained"),
            "",
        )
    ]


def losses(kind: DeviceKind, lately: Losses, losing: bool = False, remedy: Text = "") -> HealthItem:
    """Whether all data of a device arrives.

    Args:
        losing: much of it is lost, or comes later and later, just now.
        remedy: what to do on this computer, if the driver knows it.
    """
    quality = loss_quality(lately, losing)
    missing = lately.lost + lately.corrupt
    what: Text = message("no-data-yet")
    if lately.received or missing:
        what = message(
            "lost-garbled-last-ten-minutes",
            missing=missing,
            total=lately.received + missing,
            share=quantity(100 * lately.share, "%", 2),
        )
    if losing:
        what = join([message("data-lost-now", title=word(kind)), what], " ")
    return HealthItem(
        f"losses-{kind}",
        message("losses", device=kind),
        quality,
        what,
        message("frame-without-joints-around-gives-no"),
        "" if quality == "good" else remedy or message("use-shorter-cable-port-own-close"),
    )


def readings(
    received: int, rejected: int, newest: OperationError | None, ago_s: float | None
) -> HealthItem:
    """Whether the arm's encoder readings are plausible.

    Args:
        received: by the station since its start.
        ago_s: time since the newest implausible reading.
    """
    why = message("nothing-taken-reading-cannot-true-no")
    if newest is None or ago_s is None:
        what = message("no-data-yet")
        if received:
            what = message("every-reading-joints-could-true")
        return HealthItem("readings", message("readings-arm"), "good", what, why, "")
    return HealthItem(
        "readings",
        message("readings-arm"),
        "bad" if ago_s < READINGS_BAD_S else "attention",
        message("could-true-last-ago", count=rejected, ago=quantity(ago_s, "s"), what=newest.what),
        why,
        sentence(newest.remedy),
    )


def clock(jumps: int, last_jump_s: float, ahead_days: float) -> HealthItem:
    """Whether the wall clock is correct.

    Args:
        ahead_days: how far the newest record is in the future.
    """
    why = message("ages-calibrations-order-records-go-measuring")
    if ahead_days > 0:
        return HealthItem(
            "clock",
            message("clock"),
            "bad",
            message("newest-record-days-later-than-clock", days=quantity(ahead_days, "", 1)),
            why,
            message("set-machines-clock-let-kept-time"),
        )
    if jumps:
        return HealthItem(
            "clock",
            message("clock"),
            "attention",
            message(
                "clock-set-since-start-last",
                count=jumps,
                last_jump=signed(last_jump_s, "s"),
            ),
            why,
            message("let-kept-time-server-which-moves"),
        )
    return HealthItem("clock", message("clock"), "good", message("runs-steadily"), why, "")


def event_loop(stalls: Stalls, limit_s: float) -> HealthItem:
    """Whether browsers are answered without delay."""
    why = message("held-up-live-numbers-stand-press")
    if not stalls.count and not stalls.pauses:
        what = message("never-held-up-more-than", limit=quantity(limit_s, "s", 2))
        return HealthItem("loop", message("answers-browsers"), "good", what, why, "")
    parts: list[Text] = []
    if stalls.count:
        longest, limit = beside_limit(stalls.longest_s, limit_s, "s", 1)
        parts.append(
            message("held-up-more-than-longest", count=stalls.count, limit=limit, longest=longest)
        )
    if stalls.pauses:
        parts.append(
            message(
                "whole-program-stood-still-longest",
                count=stalls.pauses,
                longest=quantity(stalls.longest_pause_s, "s", 1),
            )
        )
    quality: Quality = "neutral" if stalls.longest_s < STALLS_BAD_S else "attention"
    remedy = message("close-what-else-uses-machine")
    if stalls.count:
        remedy = message("log-has-what-held-up-send")
    return HealthItem(
        "loop", message("answers-browsers"), quality, sentence(join(parts, "; ")), why, remedy
    )


def memory_use(used: Memory) -> HealthItem:
    """Whether there is enough memory."""
    short = used.free is not None and used.free < MEMORY_FREE_BYTES
    much = used.process > PROCESS_MEMORY_BYTES
    process = quantity(used.process / 1e6, "MB")
    what = message("station-uses", process=process)
    if used.free is not None:
        free = quantity(used.free / 1e9, "GB", 1)
        what = message("station-uses-and-free", process=process, free=free)
    return HealthItem(
        "memory",
        message("memory"),
        "attention" if short or much else "good",
        what,
        message("without-free-memory-whole-machine-slows"),
        message("close-other-programs-restart-station-between") if short or much else "",
    )


def log_errors(count: int) -> HealthItem:
    """Whether an unexpected error occurred recently."""
    return HealthItem(
        "log",
        message("log"),
        "attention" if count else "good",
        message("errors-or-none-last-hour", count=count),
        message("error-not-foreseen"),
        message("look-them-below-send-support-bundle") if count else "",
    )


def temperature(now: Temperature, change_c: float | None) -> HealthItem:
    """Whether the temperature is the same as during calibration."""
    why = message("everything-grows-metre-aluminium", growth=quantity(23, "µm"))
    if now.celsius is None and not now.trouble:
        return HealthItem(
            "room", message("temperature"), "neutral", message("not-read-yet"), why, ""
        )
    if now.celsius is None:
        return HealthItem(
            "room", message("temperature"), "attention", now.trouble, why, message("check-sensor")
        )
    celsius = quantity(now.celsius, "°C", 1)
    if change_c is None:
        return HealthItem("room", message("temperature"), "good", sentence(celsius), why, "")
    moved = abs(change_c) > TEMPERATURE_CHANGE_C
    return HealthItem(
        "room",
        message("temperature"),
        "attention" if moved else "good",
        message("since-calibration", celsius=celsius, change=signed(change_c, "°C", 1)),
        why,
        message("verify-against-gauge-calibrate-again") if moved else "",
    )


def broker(
    host: str, connected: bool, text: Text, remedy: Text, for_s: float, doubled: bool
) -> HealthItem:
    """Whether other stations see this station."""
    why = message("other-stations-see-one-one-them")
    if doubled:
        return HealthItem(
            "broker",
            message("broker"),
            "bad",
            message("another-station-publishes-under-ones-name"),
            why,
            message("give-each-own-name-station-mqtt"),
        )
    if connected:
        return HealthItem(
            "broker", message("broker"), "good", message("connected", host=host), why, ""
        )
    return HealthItem(
        "broker",
        message("broker"),
        "attention",
        message("no-connection-for", host=host, duration=quantity(for_s, "s"), reason=text),
        why,
        remedy,
    )


def webhook(host: str, failed: int, trouble: Text) -> HealthItem:
    """Whether notifications arrive."""
    why = message("tells-whoever-away-what-done-fault")
    if trouble:
        return HealthItem(
            "webhook",
            message("webhook"),
            "attention",
            message("notifications-not-accepted", host=host, trouble=trouble, failed=failed),
            why,
            message("check-address-below-try"),
        )
    return HealthItem(
        "webhook", message("webhook"), "good", message("takes-notifications", host=host), why, ""
    )


def network(how: str) -> HealthItem:
    """Whether the traffic with browsers can be read on the network."""
    what = {
        "here": message("only-machines-browsers-reach-station"),
        "encrypted": message("other-machines-reach-encrypted"),
        "proxied": message("other-machines-reach-proxy"),
        "open": message("other-machines-reach-nothing-encrypted"),
    }[how]
    return HealthItem(
        "network",
        message("network"),
        "neutral" if how == "open" else "good",
        what,
        message("who-reads-along-has-passwords-can"),
        message("name-tls-certificate-tls-key-station") if how == "open" else "",
    )


def software(versions: dict[str, str]) -> HealthItem:
    """The software and versions in use."""
    parts = [message("software-part", part=name, version=of) for name, of in versions.items()]
    why = message("whoever-helps-you-asks-first")
    return HealthItem("software", message("software"), "good", sentence(join(parts)), why, "")
