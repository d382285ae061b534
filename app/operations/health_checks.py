"""Brings the health checks and the station together."""

import shutil
import sys
import time
from collections.abc import Callable
from datetime import UTC, datetime
from importlib.metadata import PackageNotFoundError, version
from typing import TypeVar, cast
from urllib.parse import urlsplit

from app.formats.software import SOFTWARE
from app.guide.common.validity import SECONDS_A_DAY, age_days
from app.monitoring import health
from app.monitoring import health_topics as health_messages
from app.monitoring.health import Health, HealthItem
from app.monitoring.system_info import memory, versions, writable
from app.operations.context import Context
from app.operations.unreadable_files import set_aside
from app.store.backup import shown_backup
from app.timestamps import is_moment, moment_of, utc_now

T = TypeVar("T")
DATABASE_EVERY_S = 600.0
RECORDS_EVERY_S = 30.0
"""What asks the disk is looked at less often than the rest."""
AN_HOUR_S = 3600.0
AHEAD_S = 60.0
PACKAGES = ("numpy", "scipy", "opencv-python-headless", "fastapi", "uvicorn", "viser")


class Examiner:
    """Looks at everything; called every few seconds away from the event loop."""

    def __init__(self, context: Context) -> None:
        self._context = context
        self._kept: dict[str, tuple[float, object]] = {}

    def look(self) -> Health:
        """All checks as of now."""
        watch = self._context.watch
        watch.clock.look()
        watch.backups.look()
        items = [*self._devices(), *self._records(), *self._program(), *self._others()]
        return health.health_of(items, utc_now())

    def _devices(self) -> list[HealthItem]:
        rig, items = self._context.rig, []
        for name, side in (("arm", rig.arm), ("sensor", rig.sensor)):
            state = side.link()
            counts = (state.received, state.lost, state.corrupt)
            window = self._context.watch.losses[name]
            window.note(*counts)
            items += [health.device(state), health.losses(state.title, window.over(*counts))]
        arm = rig.arm
        items.append(health.readings(arm.kept_back, arm.newest_kept_back, arm.kept_back_ago_s))
        temperature = self._context.watch.temperature
        if temperature.there:
            items.append(health.room(temperature.now, self._warmer_c()))
        return items

    def _warmer_c(self) -> float | None:
        """Than when the station was calibrated."""
        store = self._context.store
        record = store.calibrations.active()
        return None if record is None else store.temperatures.change_since(record.accepted_at)

    def _records(self) -> list[HealthItem]:
        store, watch = self._context.store, self._context.watch
        free_gb = shutil.disk_usage(store.folder).free / 1e9
        damage = self._every(DATABASE_EVERY_S, "database", store.check)
        trouble = self._every(RECORDS_EVERY_S, "folder", lambda: writable(store.folder / "scans"))
        ahead_days = self._every(RECORDS_EVERY_S, "ahead", self._ahead_days)
        aside = self._every(DATABASE_EVERY_S, "records", lambda: set_aside(self._context))
        damaged = self._every(DATABASE_EVERY_S, "damaged", self._context.recovery.damaged)
        size_mb = (store.folder / "station.db").stat().st_size / 1e6
        last, load = watch.backups.last, self._context.scanner.load()
        pace = load.bytes_written / 1e6 / max(load.seconds, 1.0) if load else None
        return [
            health.disk(free_gb, pace),
            health.folder(trouble),
            health.database(size_mb, damage),
            health.records(aside),
            health.recordings(damaged),
            health.backup(
                None if last is None else age_days(last.at, datetime.now(UTC)),
                "" if last is None else shown_backup(last.folder),
                watch.backups.same_disk,
                watch.backups.trouble,
            ),
            health.clock(watch.clock.jumps, watch.clock.last_jump_s, ahead_days),
        ]

    def _every(self, period_s: float, name: str, look: Callable[[], T]) -> T:
        """What was seen the last time, looked at again after the period."""
        known = self._kept.get(name)
        if known is None or time.monotonic() - known[0] > period_s:
            known = (time.monotonic(), look())
            self._kept[name] = known
        return cast(T, known[1])

    def _ahead_days(self) -> float:
        """By how much the newest record is later than now."""
        store = self._context.store
        calibration, scan = store.calibrations.newest(), store.scans.newest()
        newest = [calibration.accepted_at] if calibration else []
        newest += [scan.started_at] if scan else []
        now = datetime.now(UTC)
        ahead = [(moment_of(at) - now).total_seconds() for at in newest if is_moment(at)]
        ahead_s = max(ahead, default=0.0)
        return ahead_s / SECONDS_A_DAY if ahead_s > AHEAD_S else 0.0

    def _program(self) -> list[HealthItem]:
        watch = self._context.watch
        stalls = watch.watchdog.stalls
        return [
            health.event_loop(stalls, watch.watchdog.limit_s),
            health.memory_use(memory()),
            health.log_errors(watch.logs.errors_since(time.time() - AN_HOUR_S)),
            health.network(watch.settings.network),
            health.software(software(self._context)),
        ]

    def _others(self) -> list[HealthItem]:
        watch, items = self._context.watch, []
        if watch.broker is not None:
            state, doubled_at_s = watch.broker.state, watch.broker.doubled_at_s
            items.append(
                health.broker(
                    watch.broker.settings.host,
                    state.connected,
                    state.text,
                    time.monotonic() - state.since_s,
                    doubled_at_s is not None and time.monotonic() - doubled_at_s < 10.0,
                )
            )
            unread = watch.fleet.unread
            items += health_messages.messages(unread.counts, unread.ago_s)
        if watch.webhook.settings.url:
            host = urlsplit(watch.webhook.settings.url).hostname or ""
            items.append(health.webhook(host, watch.webhook.failed, watch.webhook.trouble))
        return items


def software(context: Context) -> dict[str, str]:
    """Versions of what runs, and the drivers in use."""
    drivers = context.watch.settings.told.get("drivers", {})
    told = {str(k): str(v) for k, v in drivers.items()} if isinstance(drivers, dict) else {}
    return {"Crenel": SOFTWARE.version, **versions(), **told}


def packages() -> dict[str, str]:
    """Versions of the packages that matter most."""
    found = {"python": sys.version.split()[0]}
    for name in PACKAGES:
        try:
            found[name] = version(name)
        except PackageNotFoundError:
            continue
    return found
