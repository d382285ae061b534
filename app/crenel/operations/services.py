"""The services that monitor the station and report on it."""

import threading
import time
from collections import defaultdict, deque
from collections.abc import Callable, Mapping
from dataclasses import dataclass, field
from pathlib import Path
from typing import TYPE_CHECKING

from crenel.archive.archive import Archive
from crenel.archive.archive_settings import ArchiveSettings
from crenel.archive.pace import Pace
from crenel.archive.records import RecordLists
from crenel.archive.worker import ArchiveWorker
from crenel.errors import OperationError
from crenel.formats.file_names import register_data_folder, unregister_data_folder
from crenel.formats.real_folders import share_disk
from crenel.loops import start_worker
from crenel.messages.message import Text, message
from crenel.monitoring.health import Health
from crenel.monitoring.log_store import LogStore
from crenel.monitoring.loop_watchdog import LoopWatchdog
from crenel.monitoring.system_info import Network, WallClock
from crenel.settings.settings import DeviceKind, DeviceTable
from crenel.station.bus import Bus
from crenel.station.devices.temperature import TemperatureWatch, Thermometer
from crenel.station.jobs import Jobs
from crenel.station.scan.state import ScanResult
from crenel.store.backup import BackupRecord, backup, display_backup, last_backup, new_backup_name
from crenel.store.store import Store
from crenel.supervision.broker_settings import BrokerSettings
from crenel.supervision.message_data import payload_text, readable
from crenel.supervision.messages import new_instance, station_id
from crenel.supervision.notifications import Notice, NoticeDeduplicator, NoticeKind
from crenel.supervision.remote_stations import Fleet
from crenel.supervision.webhook import Webhook, WebhookStore
from crenel.timestamps import utc_now

if TYPE_CHECKING:
    from crenel.supervision.broker import Broker

OPTIONS_KEPT = 200
BUCKETS_S = (0.5, 1.0, 2.0, 5.0, 10.0, 30.0, 60.0, 120.0, 300.0)


@dataclass(frozen=True)
class MonitoringSettings:
    """From ``station.toml``."""

    address: str = ""
    """Address of the station's pages, for links from other stations."""
    backups: Path | None = None
    mqtt: BrokerSettings | None = None
    archive: ArchiveSettings | None = None
    thermometer: Thermometer | None = None
    network: Network = "here"
    effective_settings: Mapping[str, object] = field(default_factory=dict)
    """The settings in use, for the support bundle."""


@dataclass
class JobTimes:
    """Durations of jobs with one title."""

    buckets: list[int] = field(default_factory=lambda: [0] * (len(BUCKETS_S) + 1))
    total_s: float = 0.0

    def add(self, seconds: float) -> None:
        self.total_s += seconds
        self.buckets[sum(seconds > bound for bound in BUCKETS_S)] += 1


class Backups:
    """Makes one backup at a time, in a separate thread."""

    def __init__(self, bus: Bus, data: Path, folder: Path | None) -> None:
        self._bus, self._data = bus, data
        self.folder = folder or data / "backups"
        self.same_disk = share_disk(self.folder, data)
        self.share: float | None = None
        """Completed share of the running backup; null if none is running."""
        self.trouble: Text = ""
        self._lock = threading.Lock()
        self._thread: threading.Thread | None = None
        self.last: BackupRecord | None = last_backup(data)

    def look(self) -> None:
        """Whether another process made or removed a backup."""
        self.last = last_backup(self._data)

    def start(self) -> None:
        """Raises ``OperationError`` while a backup is being made."""
        with self._lock:
            if self.share is not None:
                raise OperationError(
                    "busy", message("backup-being-made-already"), remedy=message("wait")
                )
            self.share, self.trouble = 0.0, ""
        self._thread = start_worker("backup", self._run)

    def _run(self) -> None:
        register_data_folder(self.folder.parent)
        try:
            self.last = backup(self._data, self.folder / new_backup_name(), self._progress)
            self._bus.event(
                "backup", message("backup-is-in", folder=display_backup(self.last.folder)), "good"
            )
        except OperationError as error:
            self.trouble = error.text
            self._bus.event("backup", message("no-backup-made", error=error.text), "bad")
        finally:
            unregister_data_folder(self.folder.parent)
            self.share = None

    def _progress(self, share: float, text: Text) -> None:
        self.share = share


class MonitoringServices:
    """The services of one station."""

    def __init__(
        self, settings: MonitoringSettings, name: str, bus: Bus, store: Store, jobs: Jobs
    ) -> None:
        self.settings = settings
        self._chosen: dict[str, object] = {}
        self._options: deque[Mapping[str, object]] = deque(maxlen=OPTIONS_KEPT)
        self.instance = new_instance()
        mqtt = settings.mqtt
        self.station = (mqtt.station if mqtt else None) or station_id(name)
        self.name = name
        self.started_s = time.monotonic()
        self.logs = LogStore(store.folder)
        self.watchdog = LoopWatchdog()
        self.clock = WallClock()
        self.temperature = TemperatureWatch(
            settings.thermometer, lambda celsius: store.temperatures.add(celsius, "thermometer")
        )
        self.fleet = Fleet()
        self.broker = None if mqtt is None else self._make_broker(mqtt)
        self.webhooks = WebhookStore(store.folder)
        self.webhook = Webhook(self.webhooks.read())
        self.backups = Backups(bus, store.folder, settings.backups)
        self.archive: ArchiveWorker | None = None
        """Set by ``open_archive``, if the station has an archive."""
        self.health: Health | None = None
        self.job_times: dict[str, JobTimes] = defaultdict(JobTimes)
        jobs.on_ended = lambda title, seconds: self.job_times[title].add(seconds)
        self.scans = self.points = self.frames = self.frames_lost = 0
        """Over all scans that ended since the start."""
        self.events = 0
        self.tabs = 0
        """Number of open live connections."""
        self._bus = bus
        self._numbers = 0
        self._repeats = NoticeDeduplicator()
        self.warned = NoticeDeduplicator()
        """Events that are logged as warnings: those that may repeat, like Stop, are only
        reported."""

    def open_archive(self, store: Store, is_scanning: Callable[[], bool]) -> None:
        """Starts to copy finished records, if the settings name an archive."""
        settings = self.settings.archive
        if settings is None:
            return
        lists = RecordLists(store.journal, store.scans, store.calibrations, store.verifications)
        pace = Pace(settings.scan_rate_mb_s * 1e6, is_scanning)
        self.archive = ArchiveWorker(
            Archive(settings, self.name, store.folder, lists, pace),
            lambda text: self._bus.event("archive", text, "attention"),
        )
        self.archive.start()

    def _make_broker(self, settings: BrokerSettings) -> "Broker":
        # most stations have no broker, and need not import the protocol
        from crenel.supervision.broker import Broker

        return Broker(settings, self.station, self.name, self.instance, self.fleet)

    @property
    def effective_settings(self) -> Mapping[str, object]:
        """The settings in use, with the devices that were chosen since the start."""
        return {**self.settings.effective_settings, **self._chosen}

    @property
    def settings_with_secrets(self) -> Mapping[str, object]:
        """Those, and every option of a device that was tried or used: the log may quote them."""
        return {**self.effective_settings, "options": [dict(one) for one in self._options]}

    def note_options(self, options: Mapping[str, object]) -> None:
        """Called with the options of a device before it is opened."""
        self._options.append(options)

    def note_devices(self, tables: Mapping[DeviceKind, DeviceTable]) -> None:
        """Called when another device was chosen."""
        for kind, table in tables.items():
            self._chosen[kind] = dict(table.options)
        drivers = {kind: table.driver for kind, table in tables.items()}
        before = self.settings.effective_settings.get("drivers")
        self._chosen["drivers"] = before | drivers if isinstance(before, dict) else drivers

    def note_scan(self, result: ScanResult) -> None:
        """Called at the end of a scan."""
        self.scans += 1
        self.points += result.points
        self.frames += result.frames
        self.frames_lost += result.lost_frames

    def notify(self, kind: NoticeKind, text: Text) -> None:
        """Notifies absent users, and the browsers that asked for it."""
        if kind != "test" and not self._repeats.is_new(kind, text):
            return
        self._numbers += 1
        notice = Notice.model_validate(
            {
                "number": self._numbers,
                "station": self.station,
                "instance": self.instance,
                "name": self.name,
                "kind": kind,
                "at": utc_now(),
                **payload_text(text=text),
            }
        )
        self.webhook.offer(notice)
        if kind != "test":
            self._bus.publish("notice", readable(notice))

    def close(self) -> None:
        """Closes all services, the log last."""
        self.watchdog.stop()
        self.logs.close()
