"""Publishes the station's reports and events."""

import asyncio
import logging
import time
from collections.abc import Awaitable, Callable, Coroutine
from functools import partial
from itertools import count

from app.errors import OperationError, sentence
from app.guide.performance.commands import measure_waiting as measure_waiting_scan
from app.guide.verify.commands import measure_waiting
from app.messages.message import join
from app.operations.context import Context
from app.operations.health_checks import HealthChecker
from app.operations.home import build_home
from app.operations.status_report import build_report
from app.station.bus import Event
from app.supervision.message_data import payload_text, readable
from app.supervision.messages import StationEvent
from app.supervision.notifications import notice_kind
from app.timestamps import utc_now
from app.wire.schema import Home

log = logging.getLogger(__name__)
LIVE_S = 0.2
HOME_EVERY = 5
"""Home is looked at less often than the guided sessions."""
REPORT_S = 0.5
STATIONS_S = 1.0
HEALTH_S = 3.0
LOSING_S = 0.1
"""Health is looked at sooner when a device begins to lose its data."""
TEMPERATURE_S = 5.0
END_S = 1.5
DEVICE_TOPICS = {"devices", "sensors"}
TOPICS = DEVICE_TOPICS | {"report", "stations", "flow", "scan", "preview", "view", "home", "arm"}
"""What browsers want, and the passing on of events does not."""
DueKey = tuple[str, str | None]
"""Id and time of a check that is due."""


async def _repeat(step: Callable[[], Awaitable[None]], period_s: float, failure: str) -> None:
    """Runs until cancelled; a step that fails is logged, and the next may succeed."""
    while True:
        await _attempt(step, failure)
        await asyncio.sleep(period_s)


async def _attempt(step: Callable[[], Awaitable[object]], failure: str) -> None:
    """Runs a step; one that fails is logged."""
    try:
        await step()
    except OperationError as refusal:  # of a damaged database or its disk; Health shows it
        log.warning("%s: %s", failure, refusal.line)
    except Exception:
        log.exception(failure)


async def tick(context: Context) -> None:
    """Refreshes the live part of guided sessions, and home; runs until cancelled.

    Only what changed is published. What fails in one guide stops neither the others nor recovery.
    """
    ticks = count()
    home: Home | None = None
    failure = "the live state could not be refreshed"
    refreshes: list[Callable[[], object]] = [
        context.guide.refresh,
        context.arm_guide.refresh,
        lambda: measure_waiting(context.verify_guide),
        context.verify_guide.refresh,
        lambda: measure_waiting_scan(context.performance_guide),
        context.performance_guide.refresh,
    ]

    async def step() -> None:
        nonlocal home
        number = next(ticks)
        for refresh in refreshes:
            await _attempt(partial(asyncio.to_thread, refresh), failure)
        if number % HOME_EVERY == 0:
            await _attempt(partial(asyncio.to_thread, context.recovery.step), failure)
            found = await asyncio.to_thread(build_home, context)
            if found != home:
                home = found
                context.bus.publish("home", home)

    await _repeat(step, LIVE_S, failure)


async def observe(context: Context) -> None:
    """Runs until cancelled; other stations then learn that this one has ended."""
    watch = context.monitoring
    watch.watchdog.start(asyncio.get_running_loop())
    coroutines: list[Coroutine[object, object, None]] = [
        _reports(context),
        _stations(context),
        _events(context),
        _health(context),
        _temperature(context),
        watch.webhook.run(),
    ]
    if watch.broker is not None:
        coroutines.append(watch.broker.run())
    tasks = [asyncio.create_task(_run_and_log(work)) for work in coroutines]
    try:
        await asyncio.wait(tasks)
    finally:  # each is cancelled once: the last messages to the broker follow
        for task in tasks:
            task.cancel()
        await asyncio.wait(tasks, timeout=END_S)


async def _run_and_log(work: Coroutine[object, object, None]) -> None:
    """If one of these tasks fails, the others continue."""
    try:
        await work
    except Exception:
        log.exception("a part of the station's supervision has ended")


async def _reports(context: Context) -> None:
    due: set[DueKey] = set()

    async def step() -> None:
        nonlocal due
        report = await asyncio.to_thread(build_report, context)
        context.bus.publish("report", readable(report))
        if context.monitoring.broker is not None:
            context.monitoring.broker.report(report)
        due = _notify_due(context, due)

    await _repeat(step, REPORT_S, "the station's report could not be made")


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
    while True:
        shown = context.monitoring.fleet.stations()
        news = [one.model_copy(update={"silent_s": None}) for one in shown]
        if news != published:
            published = news
            context.bus.publish("stations", shown)
        await asyncio.sleep(STATIONS_S)


async def _events(context: Context) -> None:
    with context.bus.subscribe(without=TOPICS) as subscription:
        while True:
            updates = await subscription.next()
            for topic in updates.topics:
                subscription.want(topic, False)
            for event in updates.events:
                _pass_on(context, event)


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
        context.monitoring.health = await asyncio.to_thread(examiner.look)

    await _repeat(step, LOSING_S, "the station's health could not be looked at")


async def _temperature(context: Context) -> None:
    watch = context.monitoring.temperature
    if watch.there:
        await _repeat(
            lambda: asyncio.to_thread(watch.read),
            TEMPERATURE_S,
            "the temperature could not be read and kept",
        )
