"""The station's health: each check a finding with its number, why it matters, what to do.

Checks take plain values and are free of clocks and devices.
"""

from collections.abc import Sequence
from dataclasses import dataclass

from app.errors import OperationError
from app.findings import Quality, capital, figures, format_signed
from app.monitoring.loop_watchdog import Stalls
from app.monitoring.system_info import Memory
from app.station.devices.link_state import DeviceState, Losses
from app.station.devices.temperature import Temperature

LOSS_ATTENTION, LOSS_BAD = 0.001, 0.01
DISK_ATTENTION_GB, DISK_BAD_GB = 10.0, 1.0
PROCESS_MEMORY_BYTES, MEMORY_FREE_BYTES = 3_000_000_000, 500_000_000
STALLS_BAD_S = 2.0
BACKUP_DAYS = 7.0
READINGS_BAD_S = 600.0
TEMPERATURE_CHANGE_C = 2.0
ORDER: dict[Quality, int] = {"bad": 0, "attention": 1, "neutral": 2, "good": 3}


@dataclass(frozen=True)
class HealthItem:
    """One check."""

    id: str
    title: str
    quality: Quality
    what: str
    why: str
    remedy: str
    """Empty where there is nothing to do."""


@dataclass(frozen=True)
class Health:
    """All checks, the worst first."""

    at: str
    quality: Quality
    items: Sequence[HealthItem]


def summarise_health(items: Sequence[HealthItem], at: str) -> Health:
    """The worst check says how the station is."""
    ordered = sorted(items, key=lambda item: ORDER[item.quality])
    worst: Quality = ordered[0].quality if ordered else "good"
    return Health(at, "good" if worst == "neutral" else worst, ordered)


def device(state: DeviceState) -> HealthItem:
    """Whether a device sends."""
    name = state.title.lower()
    quality: Quality = {"connected": "good", "connecting": "attention"}.get(state.state, "bad")  # type: ignore[assignment]
    what = f"{state.text.rstrip('.')}."
    if state.state == "connected" and state.age_s is not None and state.rate_hz is not None:
        what = f"{state.text}: {state.rate_hz:.0f} a second, the newest {state.age_s:.2f} s old."
    return HealthItem(
        f"device-{name}",
        state.title,
        quality,
        what,
        "Without it nothing is measured; what was taken is kept.",
        ""
        if quality == "good"
        else "Check its cable and its power. It is looked for again by itself.",
    )


def losses(title: str, lately: Losses) -> HealthItem:
    """Whether all that a device sends arrives."""
    name = title.lower()
    quality: Quality = "good"
    if lately.share > LOSS_BAD:
        quality = "bad"
    elif lately.share > LOSS_ATTENTION:
        quality = "attention"
    missing = lately.lost + lately.corrupt
    what = "No data yet."
    if lately.received or missing:
        what = (
            f"{missing} of {lately.received + missing} lost or garbled in the last ten minutes "
            f"({100 * lately.share:.2f} %)."
        )
    return HealthItem(
        f"losses-{name}",
        f"Losses of the {name}",
        quality,
        what,
        "A frame without joints around it gives no points.",
        ""
        if quality == "good"
        else "Use a shorter cable and a port of its own; close what else uses the machine.",
    )


def readings(kept_back: int, newest: OperationError | None, ago_s: float | None) -> HealthItem:
    """Whether what the arm's encoders say can be true.

    Args:
        ago_s: since the newest reading that could not.
    """
    why = "Nothing is taken from a reading that cannot be true: no contact, no pose, no points."
    if newest is None or ago_s is None:
        what = "Every reading of the joints could be true."
        return HealthItem("readings", "Readings of the arm", "good", what, why, "")
    return HealthItem(
        "readings",
        "Readings of the arm",
        "bad" if ago_s < READINGS_BAD_S else "attention",
        f"{kept_back} could not be true, the last {ago_s:.0f} s ago: {newest.what}.",
        why,
        f"{capital(newest.remedy)}.",
    )


def clock(jumps: int, last_jump_s: float, ahead_days: float) -> HealthItem:
    """Whether the wall clock can be believed.

    Args:
        ahead_days: by how much the newest record is later than now.
    """
    why = "Ages of calibrations and the order of records go by it; measuring does not."
    if ahead_days > 0:
        return HealthItem(
            "clock",
            "Clock",
            "bad",
            f"The newest record is {ahead_days:.1f} days later than the clock.",
            why,
            "Set the machine's clock, and let it be kept by a time server.",
        )
    if jumps:
        return HealthItem(
            "clock",
            "Clock",
            "attention",
            f"The clock was set {_times(jumps)} since the start, "
            f"last by {format_signed(last_jump_s)} s.",
            why,
            "Let it be kept by a time server, which moves it gently.",
        )
    return HealthItem("clock", "Clock", "good", "It runs on steadily.", why, "")


def disk(free_gb: float, megabytes_s: float | None) -> HealthItem:
    """Whether there is room to record."""
    quality: Quality = "good"
    if free_gb < DISK_BAD_GB:
        quality = "bad"
    elif free_gb < DISK_ATTENTION_GB:
        quality = "attention"
    lasts = ""
    if megabytes_s:
        lasts = f", enough for {1000 * free_gb / megabytes_s / 3600:.1f} hours of this scan"
    return HealthItem(
        "disk",
        "Disk",
        quality,
        f"{free_gb:.1f} GB are free{lasts}.",
        "A scan does not start with less than 0.5 GB, and stops at 0.1 GB.",
        "" if quality == "good" else "Delete scans under Records, or use a larger disk.",
    )


def folder(trouble: str) -> HealthItem:
    """Whether records can be written."""
    return HealthItem(
        "folder",
        "Data folder",
        "bad" if trouble else "good",
        f"It cannot be written: {trouble}." if trouble else "It can be written.",
        "Recordings, calibrations and the journal are kept there.",
        "Check the folder's owner and whether its disk is mounted." if trouble else "",
    )


def database(size_mb: float, trouble: str) -> HealthItem:
    """Whether the database is whole."""
    return HealthItem(
        "database",
        "Database",
        "bad" if trouble else "good",
        f"It is damaged: {trouble}." if trouble else f"It is whole, {size_mb:.1f} MB.",
        "It holds the journal of every step, accounts, and what calibration is in use.",
        "Stop the station, keep a copy of the data folder, and start from the last backup."
        if trouble
        else "",
    )


def records(aside: Sequence[str]) -> HealthItem:
    """Whether all that was kept can be read; ``aside``: a sentence for each that cannot."""
    more = f" And {len(aside) - 3} more." if len(aside) > 3 else ""
    return HealthItem(
        "records",
        "Records",
        "bad" if aside else "good",
        f"{' '.join(aside[:3])}{more}" if aside else "All that was kept can be read.",
        "What cannot be read is set aside as it is; everything else is served.",
        "Put the file back from the last backup, or leave it and go on." if aside else "",
    )


def recordings(damaged: Sequence[str]) -> HealthItem:
    """Whether what was recorded is there as it was recorded."""
    more = f", and {len(damaged) - 1} more" if len(damaged) > 1 else ""
    return HealthItem(
        "recordings",
        "Recordings",
        "bad" if damaged else "good",
        f"{damaged[0]}{more}." if damaged else "All are there, as they were recorded.",
        "A scan can be made again of its recording, and a verification be shown to be right.",
        "Bring it back from the last backup, or delete it under Records." if damaged else "",
    )


def event_loop(stalls: Stalls, limit_s: float) -> HealthItem:
    """Whether browsers are answered without a hitch."""
    why = "Held up, live numbers stand, and a press is answered late; devices are read on."
    if not stalls.count and not stalls.pauses:
        what = f"Never held up for more than {limit_s:.2f} s."
        return HealthItem("loop", "Answers to browsers", "good", what, why, "")
    parts = []
    if stalls.count:
        parts.append(
            f"Held up {_times(stalls.count)} for more than {limit_s:.2f} s, "
            f"{stalls.longest_s:.1f} s the longest"
        )
    if stalls.pauses:
        parts.append(
            f"the whole program stood still {_times(stalls.pauses)}, "
            f"{stalls.longest_pause_s:.1f} s the longest"
        )
    quality: Quality = "neutral" if stalls.longest_s < STALLS_BAD_S else "attention"
    text = "; ".join(parts)
    remedy = "Close what else uses the machine."
    if stalls.count:
        remedy = "The log has what held it up; send the support bundle if it happens again."
    what = f"{text[:1].upper()}{text[1:]}."
    return HealthItem("loop", "Answers to browsers", quality, what, why, remedy)


def memory_use(used: Memory) -> HealthItem:
    """Whether memory suffices."""
    short = used.free is not None and used.free < MEMORY_FREE_BYTES
    much = used.process > PROCESS_MEMORY_BYTES
    free = "" if used.free is None else f"; {used.free / 1e9:.1f} GB are free"
    return HealthItem(
        "memory",
        "Memory",
        "attention" if short or much else "good",
        f"The station uses {used.process / 1e6:.0f} MB{free}.",
        "Without free memory the whole machine slows down, and frames are lost.",
        "Close other programs, or restart the station between two scans." if short or much else "",
    )


def log_errors(count: int) -> HealthItem:
    """Whether something failed lately that nobody foresaw."""
    what = f"{count} errors in the last hour." if count else "No error in the last hour."
    if count == 1:
        what = "One error in the last hour."
    return HealthItem(
        "log",
        "Log",
        "attention" if count else "good",
        what,
        "An error there is something that the program did not foresee.",
        "Look at them below, and send the support bundle." if count else "",
    )


def backup(days: float | None, place: str, same_disk: bool, trouble: str) -> HealthItem:
    """Whether the station could be set up again from a copy."""
    why = "A disk that fails takes every calibration and scan with it."
    remedy = "Make one below, or with crenel backup."
    if trouble:
        return HealthItem("backup", "Backup", "bad", trouble, why, remedy)
    if days is None:
        return HealthItem("backup", "Backup", "attention", "There is none yet.", why, remedy)
    what = f"The last is {days:.1f} days old, in {place}."
    if days > BACKUP_DAYS:
        return HealthItem("backup", "Backup", "attention", what, why, remedy)
    if same_disk:
        what += " It is on the same disk as the data."
        remedy = "Name a folder on another disk with backups in station.toml."
        return HealthItem("backup", "Backup", "attention", what, why, remedy)
    return HealthItem("backup", "Backup", "good", what, why, "")


def temperature(now: Temperature, change_c: float | None) -> HealthItem:
    """Whether it is as warm as it was when the station was calibrated."""
    why = "Everything grows with it, a metre of aluminium by 23 µm a degree."
    if now.celsius is None and not now.trouble:
        return HealthItem("room", "Temperature", "neutral", "Not read yet.", why, "")
    if now.celsius is None:
        return HealthItem("room", "Temperature", "attention", now.trouble, why, "Check the sensor.")
    what = f"{figures(now.celsius, 1)} °C"
    if change_c is None:
        return HealthItem("room", "Temperature", "good", f"{what}.", why, "")
    moved = abs(change_c) > TEMPERATURE_CHANGE_C
    return HealthItem(
        "room",
        "Temperature",
        "attention" if moved else "good",
        f"{what}, {format_signed(change_c, 1)} °C since the calibration.",
        why,
        "Verify against a gauge, or calibrate again." if moved else "",
    )


def broker(host: str, connected: bool, text: str, for_s: float, doubled: bool) -> HealthItem:
    """Whether other stations see this one."""
    why = "By it other stations see this one, and this one them. Nothing else needs it."
    if doubled:
        return HealthItem(
            "broker",
            "Broker",
            "bad",
            "Another station publishes under this one's name.",
            why,
            "Give each its own name with station in [mqtt] of station.toml.",
        )
    if connected:
        return HealthItem("broker", "Broker", "good", f"Connected to {host}.", why, "")
    return HealthItem(
        "broker",
        "Broker",
        "attention",
        f"Not connected to {host} for {for_s:.0f} s: {text}.",
        why,
        "Check that the broker runs and that user and password are right. It is tried again.",
    )


def webhook(host: str, failed: int, trouble: str) -> HealthItem:
    """Whether notifications arrive."""
    why = "It tells whoever is away of what is done, at fault or due."
    if trouble:
        return HealthItem(
            "webhook",
            "Webhook",
            "attention",
            f"{host} does not take notifications: {trouble} ({failed} given up).",
            why,
            "Check its address below, and try it.",
        )
    return HealthItem("webhook", "Webhook", "good", f"{host} takes notifications.", why, "")


def network(how: str) -> HealthItem:
    """Whether what browsers send and are sent can be read on the way."""
    what = {
        "here": "Only this machine's browsers reach the station.",
        "encrypted": "Other machines reach it, encrypted.",
        "proxied": "Other machines reach it by a proxy.",
        "open": "Other machines reach it, and nothing is encrypted.",
    }[how]
    return HealthItem(
        "network",
        "Network",
        "neutral" if how == "open" else "good",
        what,
        "Who reads along has passwords, and can act in other people's names.",
        "Name tls_certificate and tls_key in station.toml, or put a proxy before it."
        if how == "open"
        else "",
    )


def software(versions: dict[str, str]) -> HealthItem:
    """What runs here."""
    told = ", ".join(f"{name} {version}" for name, version in versions.items())
    why = "Whoever helps you asks for this first."
    return HealthItem("software", "Software", "good", f"{told}.", why, "")


def _times(count: int) -> str:
    return "once" if count == 1 else f"{count} times"
