"""``/metrics`` for Prometheus, collected at each request in its own registry."""

import shutil
import time
from collections.abc import Iterator
from typing import TypeVar

from prometheus_client import CollectorRegistry, ProcessCollector, generate_latest
from prometheus_client.core import (
    CounterMetricFamily,
    GaugeMetricFamily,
    HistogramMetricFamily,
    InfoMetricFamily,
)
from prometheus_client.exposition import CONTENT_TYPE_LATEST
from prometheus_client.metrics_core import Metric
from prometheus_client.registry import Collector
from starlette.responses import Response

from crenel.api.access.authorization import StationRouter
from crenel.guide.common.validity import SECONDS_A_DAY
from crenel.loops import LOOPS
from crenel.operations.context import Context, TheContext
from crenel.operations.home import calibration_summary
from crenel.operations.services import BUCKETS_S
from crenel.station.devices.arm_device import StationArm
from crenel.station.devices.sensor_device import StationSensor

router = StationRouter()
VERDICTS = ("good", "attention", "bad")
F = TypeVar("F", GaugeMetricFamily, CounterMetricFamily)


@router.get("/metrics")
def metrics(context: TheContext) -> Response:
    """The metrics for Prometheus, which needs its own API token."""
    registry = CollectorRegistry(auto_describe=False)
    ProcessCollector(registry=registry)
    registry.register(_StationCollector(context))
    return Response(generate_latest(registry), media_type=CONTENT_TYPE_LATEST)


class _StationCollector(Collector):
    """The present metrics of one station. Names and base units follow Prometheus' conventions."""

    def __init__(self, context: Context) -> None:
        self._context = context

    def describe(self) -> Iterator[Metric]:
        """Registration collects nothing."""
        return iter(())

    def collect(self) -> Iterator[Metric]:
        context = self._context
        yield InfoMetricFamily(
            "crenel_build", "What runs here", value={"version": context.station.version}
        )
        yield _gauge("start_time_seconds", "When the station was started", self._start_time_s())
        yield from self._devices()
        yield from self._scans()
        yield from self._calibration()
        yield from self._program()
        yield from self._jobs()
        yield from self._others()

    def _start_time_s(self) -> float:
        return time.time() - (time.monotonic() - self._context.monitoring.started_s)

    def _devices(self) -> Iterator[Metric]:
        rig = self._context.rig
        up = _family(GaugeMetricFamily, "device_up", "Whether the device sends", "device")
        age = _family(
            GaugeMetricFamily, "device_data_age_seconds", "Age of the newest data", "device"
        )
        counters = {
            name: _family(CounterMetricFamily, f"device_records_{name}", text, "device")
            for name, text in (
                ("received", "Samples or frames that arrived"),
                ("lost", "Samples or frames that the device counted and that did not arrive"),
                ("corrupt", "Samples or frames that arrived garbled"),
            )
        }
        cameras = {f"camera-{k}" if k else "camera": one for k, one in rig.sensors.items()}
        sides: dict[str, StationArm | StationSensor] = {"arm": rig.arm, **cameras}
        for name, side in sides.items():
            state = side.link()
            up.add_metric([name], float(state.state == "connected"))
            if state.age_s is not None:
                age.add_metric([name], state.age_s)
            counters["received"].add_metric([name], state.received)
            counters["lost"].add_metric([name], state.lost)
            counters["corrupt"].add_metric([name], state.corrupt)
        yield from (up, age, *counters.values())
        laser = {"on": 1.0, "off": 0.0, "unknown": float("nan")}[rig.laser.state]
        yield _gauge("laser_on", "Whether the laser is on; NaN where that is not known", laser)

    def _scans(self) -> Iterator[Metric]:
        watch, scan = self._context.monitoring, self._context.scanner.state()
        load = self._context.scanner.load()
        running = load is not None
        now = (scan.points, scan.frames, scan.lost_frames) if running else (0, 0, 0)
        yield _gauge("scan_running", "Whether a scan is running", running)
        yield _counter("scans", "Scans that have ended", watch.scans)
        yield _counter("scan_points", "Points scanned", watch.points + now[0])
        yield _counter("scan_frames", "Frames taken into scans", watch.frames + now[1])
        yield _counter(
            "scan_frames_lost", "Frames that scans have lost", watch.frames_lost + now[2]
        )
        yield _gauge(
            "scan_queue_ratio",
            "How full the fullest queue of the running scan is; frames are lost at 1",
            load.backlog if load else 0.0,
        )

    def _calibration(self) -> Iterator[Metric]:
        record = self._context.store.calibrations.active(self._context.rig.selected)
        verdict = _family(
            GaugeMetricFamily,
            "calibration_verdict",
            "1 for the verdict on the calibration in use",
            "verdict",
        )
        for name in VERDICTS:
            verdict.add_metric([name], float(record is not None and record.figures.verdict == name))
        yield verdict
        if record is None:
            return
        summary = calibration_summary(record)
        yield _gauge(
            "calibration_age_seconds",
            "Age of the calibration in use",
            summary.age_days * SECONDS_A_DAY,
        )
        yield _gauge(
            "calibration_point_uncertainty_meters",
            "Standard uncertainty of a scanned point, k = 1",
            summary.total_um * 1e-6,
        )

    def _program(self) -> Iterator[Metric]:
        context, watch = self._context, self._context.monitoring
        disk = shutil.disk_usage(context.store.folder)
        stalls = watch.watchdog.stalls
        yield _gauge("disk_free_bytes", "Free on the disk of the data folder", disk.free)
        yield _gauge("disk_size_bytes", "Size of the disk of the data folder", disk.total)
        yield _counter("event_loop_stalls", "Times that the event loop was blocked", stalls.count)
        yield _gauge(
            "event_loop_stall_longest_seconds",
            "The longest blocking of the event loop",
            stalls.longest_s,
        )
        yield _counter(
            "program_pauses", "Times that the whole program was suspended", stalls.pauses
        )
        yield _counter("events", "Events sent to the browsers", watch.events)
        yield from _background()
        yield _counter("log_lines_lost", "Lines that the log has lost", watch.logs.lost_lines)
        clients = _family(GaugeMetricFamily, "clients", "Open connections of browsers", "kind")
        clients.add_metric(["live"], watch.tabs)
        clients.add_metric(["view"], len(context.view_controller.pages))
        yield clients
        yield _gauge("control_held", "Whether somebody has control", _has_holder(context))
        findings = _family(GaugeMetricFamily, "health_checks", "Health checks", "quality")
        items = watch.health.items if watch.health else ()
        for quality in ("good", "neutral", "attention", "bad"):
            findings.add_metric([quality], sum(item.quality == quality for item in items))
        yield findings

    def _jobs(self) -> Iterator[Metric]:
        family = HistogramMetricFamily(
            "crenel_job_duration_seconds", "How long jobs took", labels=["job"]
        )
        for title, times in sorted(self._context.monitoring.job_times.items()):
            buckets, total = [], 0
            for bound, count in zip((*BUCKETS_S, None), times.buckets, strict=True):
                total += count
                buckets.append(("+Inf" if bound is None else f"{bound:g}", total))
            family.add_metric([title], buckets, times.total_s)
        yield family

    def _others(self) -> Iterator[Metric]:
        watch = self._context.monitoring
        celsius = watch.temperature.now.celsius
        if celsius is not None:
            yield _gauge("temperature_celsius", "Temperature of the room", celsius)
        if watch.broker is not None:
            connected = watch.broker.state.connected
            yield _gauge("broker_connected", "Whether the MQTT broker is connected", connected)
        yield _counter("notifications_sent", "Notifications delivered", watch.webhook.sent)
        yield _counter("notifications_failed", "Notifications not delivered", watch.webhook.failed)
        yield _gauge("notifications_waiting", "Notifications not sent yet", watch.webhook.waiting)


def _background() -> Iterator[Metric]:
    """The loops of the program, by name, and what died beside them."""
    up = _family(
        GaugeMetricFamily, "loops_up", "Loops that run, and neither fail nor stand now", "loop"
    )
    failures = _family(
        CounterMetricFamily, "loop_failures", "Failed steps of a loop, which was restarted", "loop"
    )
    hangs = _family(CounterMetricFamily, "loop_hangs", "How often a loop stood still", "loop")
    for one in LOOPS.states():
        up.add_metric([one.name], 0.0 if one.failing or one.stands else one.running)
        hangs.add_metric([one.name], one.hangs)
        failures.add_metric([one.name], one.failures)
    yield from (up, failures, hangs)
    deaths = LOOPS.death_count
    yield _counter("threads_died", "Threads and tasks that an error has ended", deaths)


def _has_holder(context: Context) -> bool:
    return context.lease.control.holder is not None


def _gauge(name: str, text: str, value: float) -> Metric:
    return GaugeMetricFamily(f"crenel_{name}", text, value=float(value))


def _counter(name: str, text: str, value: float) -> Metric:
    return CounterMetricFamily(f"crenel_{name}", text, value=float(value))


def _family(kind: type[F], name: str, text: str, label: str) -> F:
    return kind(f"crenel_{name}", text, labels=[label])
