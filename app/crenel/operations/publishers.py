"""Publishes the station's reports and events."""

import asyncio
import logging
import time
from collections import deque
from collections.abc import Awaitable, Callable, Coroutine
from itertools import count
from math import inf

from crenel.errors import sentence
from crenel.gauges.guide_commands import measure_waiting as measure_waiting_scan
from crenel.gauges.quick.guide.commands import measure_waiting
from crenel.loop_states import waiting
from crenel.loops import on_thread, repeat
from crenel.messages.message import join
from crenel.operations.context import Context
from crenel.operations.health_checks import HealthChecker
from crenel.operations.home import build_home
from crenel.operations.status_report import build_report
from crenel.parts.session.commands import evaluate_waiting
from crenel.station.bus import Event
from crenel.supervision.message_data import payload_text, readable
from crenel.supervision.messages import StationEvent
from crenel.supervision.notifications import notice_kind
from crenel.timestamps import utc_now
from crenel.wire.schema import Home

log = logging.getLogger(__name__)
LIVE_S = 0.2
HOME_EVERY = 5
"""Home is looked at less often than the guided sessions."""
REPORT_S = 0.5
UNATTENDED_S = 0.5
STATIONS_S = 1.0
HEALTH_S = 3.0
LONGEST_MEASURE_S = 60.0
"""A scan of a gauge is measured in a moment, the data folder looked through, also on a slow
machine."""
LOSING_S = 0.1
"""Health is looked at sooner when a device begins to lose its data."""
TEMPERATURE_S = 5.0
END_S = 1.5
DEVICE_TOPICS = {"devices", "sensors"}
TOPICS = DEVICE_TOPICS | {
    "report",
    "stations",
    "flow",
    "scan",
    "preview",
    "view",
    "home",
    "arm",
    "activity",
    "demonstration",
    "library",
    "compare",
}
"""What browsers want, and the passing on of events does not."""
Step = Callable[[], Awaitable[object]]
DueKey = tuple[str, str | None]
"""Id and time of a check that is due."""


async def tick(context: Context) -> None:
    """Refreshes the live part of guided sessions, and home; runs until cancelled.

    Only what changed is published. What fails in one guide stops neither the others nor recovery.
    """
    home: Home | None = None

    def step_of(work: Callable[[], object]) -> Step:
        return lambda: on_thread(work)

    def now_and_then(work: Callable[[], object]) -> Step:
        numbers = count()

        async def step() -> None:
            if next(numbers) % HOME_EVERY == 0:
                await on_thread(work)

        return step

    def publish_home() -> None:
        nonlocal home
        found = build_home(context)
        if found != home:
            home = found
            context.bus.publish("home", home)

    await repeat(
        "live-state",
        step_of(context.guide.refresh),
        step_of(context.arm_guide.refresh),
        step_of(lambda: measure_waiting(context.verify_guide)),
        step_of(context.verify_guide.refresh),
        step_of(lambda: measure_waiting_scan(context.performance_guide)),
        step_of(context.performance_guide.refresh),
        step_of(lambda: evaluate_waiting(context.part_guide)),
        step_of(context.part_guide.refresh),
        now_and_then(context.recovery.step),
        now_and_then(publish_home),
        period_s=LIVE_S,
        longest_s=LONGEST_MEASURE_S,
    )


async def observe(context: Context) -> None:
    """Runs until cancelled; other stations then learn that this one has ended."""
    watch = context.monitoring
    watch.watchdog.start(asyncio.get_running_loop())
    coroutines: list[Coroutine[object, object, None]] = [
        _watch_arm(context),
        _reports(context),
        _stations(context),
        _events(context),
        _health(context),
        _temperature(context),
        repeat("notifications", watch.webhook.run, longest_s=inf),
    ]
    if watch.broker is not None:
        coroutines.append(repeat("broker", watch.broker.run, longest_s=inf))
    tasks = [asyncio.create_task(work) for work in coroutines]
    try:
        await asyncio.wait(tasks)
    finally:  # each is cancelled once: the last messages to the broker follow
        for task in tasks:
            task.cancel()
        await asyncio.wait(tasks, timeout=END_S)


async def _watch_arm(context: Context) -> None:
    """Stops what runs unattended, and says when an activity has ended by itself."""

    def look() -> None:
        context.unattended.look()
        context.activities.release_ended()

    await repeat("unattended", lambda: on_thread(look), period_s=UNATTENDED_S)


async def _reports(context: Context) -> None:
    due: set[DueKey] = set()

    async def step() -> None:
        nonlocal due
        report = await on_thread(lambda: build_report(context))
        context.bus.publish("report", readable(report))
        if context.monitoring.broker is not None:
            context.monitoring.broker.report(report)
        due = _notify_due(context, due)

    await repeat("report", step, period_s=REPORT_S)


def _notify_due(context: Context, known: set[DueKey]) -> set[DueKey]:
    """Notifies once of each check that has become due; returns the checks that are due now."""
    home = context.bus.latest("home")
    if not isinstance(home, Home):
        return known
    due = {(line.id, line.at): line for line in home.checks if line.state == "due"}
    for key in due.keys() - known:
        line = due[key]
        what = join([line.title, line.text], ": ")
        context.monitoring.notify("due", join([what, sentence(line.action)], " "))
    return set(due)


async def _stations(context: Context) -> None:
    """The other stations, after a change; the duration of silence is not a change."""
    published: object = None

    async def step() -> None:
        nonlocal published
        shown = context.monitoring.fleet.stations()
        news = [one.model_copy(update={"silent_s": None}) for one in shown]
        if news != published:
            context.bus.publish("stations", shown)
            published = news

    await repeat("stations", step, period_s=STATIONS_S)


async def _events(context: Context) -> None:
    events: deque[Event] = deque()
    with context.bus.subscribe(without=TOPICS) as subscription:

        async def step() -> None:
            if not events:
                with waiting():
                    updates = await subscription.next()
                for topic in updates.topics:
                    subscription.want(topic, False)
                events.extend(updates.events)
            while events:
                _pass_on(context, events.popleft())

        await repeat("events", step, period_s=0.0)


def _pass_on(context: Context, event: Event) -> None:
    watch = context.monitoring
    watch.events += 1
    # an error is a fault of the program; a lost device or a refusal is not
    warns = event.quality in ("bad", "attention") and watch.warned.is_new(event.kind, event.text)
    level = logging.WARNING if warns else logging.INFO
    log.log(level, "%s: %s", event.kind, event.text)
    if watch.broker is not None:
        watch.broker.event(
            StationEvent.model_validate(
                {
                    "station": watch.station,
                    "instance": watch.instance,
                    "number": event.id,
                    "at": utc_now(),
                    "kind": event.kind[:80],
                    "quality": event.quality,
                    **payload_text(text=event.text),
                }
            )
        )
    kind = notice_kind(event)
    if kind is not None:
        watch.notify(kind, event.text)


async def _health(context: Context) -> None:
    examiner = HealthChecker(context)
    looked_s, losing = float("-inf"), frozenset[str]()

    async def step() -> None:
        nonlocal looked_s, losing
        before, losing = losing, context.rig.losing()
        if losing == before and time.monotonic() - looked_s < HEALTH_S:
            return
        looked_s = time.monotonic()
        context.monitoring.health = await on_thread(examiner.look)

    await repeat("health", step, period_s=LOSING_S, longest_s=LONGEST_MEASURE_S)


async def _temperature(context: Context) -> None:
    watch = context.monitoring.temperature
    if watch.there:
        await repeat("temperature", lambda: on_thread(watch.read), period_s=TEMPERATURE_S)
