"""Publishes the station's reports and events."""

import asyncio
import logging
from collections.abc import Coroutine

from app.errors import OperationError, sentence
from app.messages.message import join
from app.operations.context import Context
from app.operations.health_checks import HealthChecker
from app.operations.status_report import build_report
from app.station.bus import Event
from app.supervision.message_data import payload_text, readable
from app.supervision.messages import StationEvent
from app.supervision.notifications import notice_kind
from app.timestamps import utc_now
from app.wire.schema import Home

log = logging.getLogger(__name__)
REPORT_S = 0.5
STATIONS_S = 1.0
HEALTH_S = 3.0
TEMPERATURE_S = 5.0
END_S = 1.5
DueKey = tuple[str, str | None]
"""Id and time of a check that is due."""


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
    while True:
        try:
            report = await asyncio.to_thread(build_report, context)
            context.bus.publish("report", readable(report))
            if context.monitoring.broker is not None:
                context.monitoring.broker.report(report)
            due = _notify_due(context, due)
        except OperationError as refusal:  # from a damaged database or its disk; Health shows it
            log.warning("the station's report could not be made: %s", refusal.line)
        except Exception:  # the station continues, and the next attempt may succeed
            log.exception("the station's report could not be made")
        await asyncio.sleep(REPORT_S)


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
    with context.bus.subscribe(without=_topics(context)) as subscription:
        while True:
            updates = await subscription.next()
            for topic in updates.topics:
                subscription.want(topic, False)
            for event in updates.events:
                _pass_on(context, event)


def _topics(context: Context) -> set[str]:
    return {"devices", "report", "stations", "flow", "scan", "preview", "view", "home", "arm"}


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
    while True:
        try:
            context.monitoring.health = await asyncio.to_thread(examiner.look)
        except OperationError as refusal:
            log.warning("the station's health could not be looked at: %s", refusal.line)
        except Exception:
            log.exception("the station's health could not be looked at")
        await asyncio.sleep(HEALTH_S)


async def _temperature(context: Context) -> None:
    while context.monitoring.temperature.there:
        try:
            await asyncio.to_thread(context.monitoring.temperature.read)
        except OperationError as refusal:
            log.warning("the temperature could not be kept: %s", refusal.line)
        except Exception:
            log.exception("the temperature could not be read")
        await asyncio.sleep(TEMPERATURE_S)
