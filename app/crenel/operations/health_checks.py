"""Connects the health checks with the station."""

import logging
import shutil
import sys
import time
from collections.abc import Callable
from dataclasses import replace
from datetime import UTC, datetime
from importlib.metadata import PackageNotFoundError, version
from typing import TypeVar, cast

from crenel.errors import OperationError
from crenel.formats.json_document import SOFTWARE
from crenel.guide.common.datasheet_library import list_set_aside
from crenel.guide.common.validity import SECONDS_A_DAY, age_days
from crenel.loops import LOOPS
from crenel.messages.message import join
from crenel.monitoring import health, storage_health
from crenel.monitoring import health_topics as health_messages
from crenel.monitoring.background_health import background
from crenel.monitoring.health import DeviceKind, Health, HealthItem
from crenel.monitoring.system_info import memory, versions, writable
from crenel.operations.context import Context
from crenel.operations.unreadable_files import list_unreadable
from crenel.station.devices.arm_device import StationArm
from crenel.station.devices.sensor_device import StationSensor
from crenel.store.backup import display_backup
from crenel.timestamps import is_moment, parse_moment, utc_now

log = logging.getLogger(__name__)
T = TypeVar("T")
DATABASE_EVERY_S = 600.0
RECORDS_EVERY_S = 30.0
"""Checks that access the disk run less often than the others."""
PROVIDER_EVERY_S = 300.0
AN_HOUR_S = 3600.0
AHEAD_S = 60.0
PACKAGES = ("numpy", "scipy", "opencv-python-headless", "fastapi", "uvicorn", "viser")


class HealthChecker:
    """Runs all checks; called every few seconds outside the event loop."""

    def __init__(self, context: Context) -> None:
        self._context = context
        self._cached: dict[str, tuple[float, object]] = {}

    def look(self) -> Health:
        """All current checks; a check that fails becomes a finding, and the others continue."""
        items: list[HealthItem] = []
        for name, check in self._checks().items():
            try:
                items += check()
            except OperationError as refusal:
                items.append(health_messages.not_made(name, refusal.text))
            except Exception as error:
                log.exception("the health check %s failed", name)
                items.append(health_messages.not_made(name, type(error).__name__))
        return health.summarise_health(items, utc_now())

    def _checks(self) -> dict[str, Callable[[], list[HealthItem]]]:
        rig = self._context.rig
        return {
            "arm": lambda: self._device("arm", rig.arm),
            "sensor": self._sensors,
            "readings": self._readings,
            "room": self._temperature,
            "disk": self._disk,
            "folder": self._folder,
            "database": self._database,
            "records": self._records,
            "datasheets": self._datasheets,
            "recordings": self._recordings,
            "backup": self._backup,
            "archive": self._archive,
            "clock": self._clock,
            "loop": self._loop,
            "background": self._background,
            "memory": lambda: [health.memory_use(memory())],
            "log": self._log,
            "network": lambda: [health.network(self._context.monitoring.settings.network)],
            "software": lambda: [health.software(software(self._context))],
            "broker": self._broker,
            "sign-in": self._sign_in,
            "webhook": self._webhook,
        }

    def _sensors(self) -> list[HealthItem]:
        """The items of the only sensor, or of each by its name."""
        found: list[HealthItem] = []
        for name, sensor in self._context.rig.sensors.items():
            items = self._device("sensor", sensor)
            if name:
                items = [
                    replace(one, id=f"{one.id}-{name}", title=join([one.title, name], " "))
                    for one in items
                ]
            found += items
        return found

    def _device(self, name: DeviceKind, side: StationArm | StationSensor) -> list[HealthItem]:
        state = side.link()
        return [
            health.device(name, state),
            *health.stamps(name, state),
            health.losses(name, state.lately, state.losing, state.loss_remedy),
        ]

    def _readings(self) -> list[HealthItem]:
        arm = self._context.rig.arm
        newest, ago_s = arm.newest_rejection, arm.rejection_age_s
        return [health.readings(arm.link().received, arm.rejected_count, newest, ago_s)]

    def _temperature(self) -> list[HealthItem]:
        temperature = self._context.monitoring.temperature
        return [health.temperature(temperature.now, self._warmer_c())] if temperature.there else []

    def _warmer_c(self) -> float | None:
        """Relative to the time of calibration."""
        store = self._context.store
        record = store.calibrations.active(self._context.rig.selected)
        return None if record is None else store.temperatures.change_since(record.accepted_at)

    def _disk(self) -> list[HealthItem]:
        free_gb = shutil.disk_usage(self._context.store.folder).free / 1e9
        load = self._context.scanner.load()
        pace = load.bytes_written / 1e6 / max(load.seconds, 1.0) if load else None
        return [storage_health.disk(free_gb, pace)]

    def _folder(self) -> list[HealthItem]:
        scans = self._context.store.folder / "scans"
        return [
            storage_health.folder(self._every(RECORDS_EVERY_S, "folder", lambda: writable(scans)))
        ]

    def _database(self) -> list[HealthItem]:
        store = self._context.store
        damage = self._every(DATABASE_EVERY_S, "database", store.check)
        return [storage_health.database((store.folder / "station.db").stat().st_size / 1e6, damage)]

    def _records(self) -> list[HealthItem]:
        aside = self._every(DATABASE_EVERY_S, "records", lambda: list_unreadable(self._context))
        return [storage_health.records(aside)]

    def _datasheets(self) -> list[HealthItem]:
        folder = self._context.store.folder
        aside = self._every(RECORDS_EVERY_S, "datasheets", lambda: list_set_aside(folder))
        return [storage_health.datasheets(aside)]

    def _recordings(self) -> list[HealthItem]:
        damaged = self._context.recovery.find_damage
        return [storage_health.recordings(self._every(DATABASE_EVERY_S, "damaged", damaged))]

    def _backup(self) -> list[HealthItem]:
        backups = self._context.monitoring.backups
        backups.look()
        last = backups.last
        days = None if last is None else age_days(last.at, datetime.now(UTC))
        place = "" if last is None else display_backup(last.folder)
        return [storage_health.backup(days, place, backups.same_disk, backups.trouble)]

    def _archive(self) -> list[HealthItem]:
        worker = self._context.monitoring.archive
        if worker is None:
            return []
        state = self._every(RECORDS_EVERY_S, "archive", worker.state)
        trouble, retry_s = worker.trouble, worker.retry_in_s
        return [
            storage_health.archive(
                worker.place,
                state.waiting,
                state.waiting_bytes / 1e9,
                state.archived,
                state.away,
                trouble,
                retry_s,
            ),
            *storage_health.archive_disk(worker.place, worker.is_on_same_disk),
        ]

    def _clock(self) -> list[HealthItem]:
        clock = self._context.monitoring.clock
        clock.look()
        ahead_days = self._every(RECORDS_EVERY_S, "ahead", self._ahead_days)
        return [health.clock(clock.jumps, clock.last_jump_s, ahead_days)]

    def _every(self, period_s: float, name: str, look: Callable[[], T]) -> T:
        """The last value, renewed after the period."""
        known = self._cached.get(name)
        if known is None or time.monotonic() - known[0] > period_s:
            known = (time.monotonic(), look())
            self._cached[name] = known
        return cast(T, known[1])

    def _ahead_days(self) -> float:
        """How far the newest record is in the future."""
        store = self._context.store
        calibration, scan = store.calibrations.newest(), store.scans.newest()
        newest = [calibration.accepted_at] if calibration else []
        newest += [scan.started_at] if scan else []
        now = datetime.now(UTC)
        ahead = [(parse_moment(at) - now).total_seconds() for at in newest if is_moment(at)]
        ahead_s = max(ahead, default=0.0)
        return ahead_s / SECONDS_A_DAY if ahead_s > AHEAD_S else 0.0

    def _loop(self) -> list[HealthItem]:
        watchdog = self._context.monitoring.watchdog
        return [health.event_loop(watchdog.stalls, watchdog.limit_s)]

    def _background(self) -> list[HealthItem]:
        since_s = self._context.monitoring.started_s
        return [background(LOOPS.states(), LOOPS.deaths(), time.monotonic(), since_s)]

    def _log(self) -> list[HealthItem]:
        errors = self._context.monitoring.logs.errors_since(time.time() - AN_HOUR_S)
        return [health.log_errors(errors)]

    def _broker(self) -> list[HealthItem]:
        watch = self._context.monitoring
        if watch.broker is None:
            return []
        state, doubled_at_s = watch.broker.state, watch.broker.doubled_at_s
        doubled = doubled_at_s is not None and time.monotonic() - doubled_at_s < 10.0
        for_s = time.monotonic() - state.since_s
        host, unread = watch.broker.settings.host, watch.fleet.unread
        return [
            health.broker(host, state.connected, state.text, state.remedy, for_s, doubled),
            *health_messages.messages(unread.counts, unread.ago_s),
        ]

    def _sign_in(self) -> list[HealthItem]:
        provider = self._context.provider
        if provider is None:
            return []
        trouble = self._every(PROVIDER_EVERY_S, "sign-in", provider.check)
        return [health_messages.sign_in(provider.name, trouble)]

    def _webhook(self) -> list[HealthItem]:
        webhook = self._context.monitoring.webhook
        if not webhook.settings.url:
            return []
        return [health.webhook(webhook.settings.host, webhook.failed, webhook.trouble)]


def software(context: Context) -> dict[str, str]:
    """Versions of the software, and the drivers in use."""
    drivers = context.monitoring.effective_settings.get("drivers", {})
    driver_names = {str(k): str(v) for k, v in drivers.items()} if isinstance(drivers, dict) else {}
    return {"Crenel": SOFTWARE.version, **versions(), **driver_names}


def packages() -> dict[str, str]:
    """Versions of the most important packages."""
    found = {"python": sys.version.split()[0]}
    for name in PACKAGES:
        try:
            found[name] = version(name)
        except PackageNotFoundError:
            continue
    return found
