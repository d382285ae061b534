"""What strangers publish on a broker: floods of one kind each, by a process of its own."""

import asyncio
import itertools
import threading
import time
from collections.abc import Callable, Iterator
from contextlib import contextmanager
from typing import Literal

import aiomqtt

from crenel.supervision.inbox import LONGEST_BYTES
from crenel.supervision.messages import MOST_ALARMS, MOST_DEVICES, Alarm, Payload, Presence, topic
from crenel.supervision.remote_stations import MOST_STATIONS
from tests.bench.faults.broker.usual_messages import DEVICE, make_event, make_report

PREFIX = "crenel"
HONEST = "honest"
"""A station that publishes usual reports beside the floods."""
INSTANCE = "1"
STATES: tuple[Literal["online", "off", "lost"], ...] = ("online", "off", "lost")
LONG_TEXT = "W\u0301" * 190
LONG_BYTES = 20 << 20
TOO_MANY_ALARMS = 12_000
PAUSE_S = 0.5
PUBLISH_S = 60.0
Publication = tuple[str, bytes, bool]
"""Topic, payload, and whether the broker is to retain it."""


def make_long_report(station: str, alarms: int = MOST_ALARMS) -> bytes:
    """With the longest texts, in every place of every list."""
    device = DEVICE.model_copy(update={"text": "x" * 400, "sensor": "s" * 60})
    report = make_report(
        station,
        INSTANCE,
        name="\u202e" + station + "Z" + "\u0301" * 30,
        devices=(device,) * MOST_DEVICES,
        alarms=tuple(
            Alarm(quality="bad", text=f"{number} {LONG_TEXT}", remedy=LONG_TEXT)
            for number in range(alarms)
        ),
    )
    return _encode(report)


def _encode(payload: Payload) -> bytes:
    return payload.model_dump_json().encode()


def _topic(station: str, kind: str = "report") -> str:
    return topic(PREFIX, station, kind)


def long_reports() -> Iterator[Publication | None]:
    """Eleven stations with lists of up to 12,000 alarms, retained."""
    while True:
        for number in range(11):
            station = f"long-{number}"
            alarms = TOO_MANY_ALARMS if number % 2 else 30
            yield _topic(station), make_long_report(station, alarms), True
        yield None


def many_stations() -> Iterator[Publication | None]:
    """As many as are kept, each with the longest report, an event and another presence."""
    for turn in itertools.count():
        for number in range(MOST_STATIONS):
            station = f"wide-{number}"
            yield _topic(station), make_long_report(station), False
            event = make_event(station, INSTANCE, turn).model_copy(update={"text": "e" * 400})
            yield _topic(station, "event"), _encode(event), False
            presence = Presence(
                station=station,
                instance=INSTANCE,
                name=f"{station} {turn}",
                state=STATES[turn % len(STATES)],
            )
            yield _topic(station, "presence"), _encode(presence), False
        yield None


def one_topic() -> Iterator[Publication | None]:
    """Reports of the greatest length that is read, all of one station."""
    payload = _encode(make_report("loud", INSTANCE)).ljust(LONGEST_BYTES["report"])
    while True:
        yield _topic("loud"), payload, False


def new_stations() -> Iterator[Publication | None]:
    """Each with a name that was never heard."""
    for number in itertools.count():
        station = f"new-{number}"
        yield _topic(station), make_long_report(station), False


def strange_messages() -> Iterator[Publication | None]:
    """No messages of a station; some in the name of the station itself."""
    for number in itertools.count():
        yield _topic(f"{'x' * 300}-{number}"), b"[" * 50_000, False
        yield _topic(f"strange-{number}", "presence"), b'{"a":' * 800, False
        yield _topic("strange", "event"), b"\xff" * 7_000, False
        yield _topic("bench"), make_long_report("bench"), False
        yield _topic("bench", "presence"), b'{"state":"lost"}', False


def huge_messages() -> Iterator[Publication | None]:
    """Of 20 MB each."""
    payload = b"x" * LONG_BYTES
    while True:
        yield _topic("huge"), payload, False


PUBLISHERS: dict[str, Callable[[], Iterator[Publication | None]]] = {
    "long reports": long_reports,
    "200 stations": many_stations,
    "one topic": one_topic,
    "new stations": new_stations,
    "strange messages": strange_messages,
    "20 MB messages": huge_messages,
}
"""Each goes on for ever; None stands for a pause."""


def publish(names: list[str], port: int, seconds: float) -> int:
    """Publishes floods for so long, side by side; how many messages were sent."""
    return asyncio.run(_publish_all(names, port, seconds))


async def _publish_all(names: list[str], port: int, seconds: float) -> int:
    until_s = time.monotonic() + seconds
    sent = await asyncio.gather(*(_publish_one(name, port, until_s) for name in names))
    return sum(sent)


async def _publish_one(name: str, port: int, until_s: float) -> int:
    sent = 0
    async with aiomqtt.Client("127.0.0.1", port, timeout=PUBLISH_S) as client:
        for one in PUBLISHERS[name]():
            if time.monotonic() > until_s:
                break
            if one is None:
                await asyncio.sleep(PAUSE_S)
                continue
            address, payload, retain = one
            await client.publish(address, payload, retain=retain)
            sent += 1
    return sent


@contextmanager
def honest_station(port: int) -> Iterator[None]:
    """A station that publishes a usual report twice a second from a thread."""
    ended = threading.Event()
    thread = threading.Thread(target=lambda: asyncio.run(_publish_honest(port, ended)))
    thread.start()
    try:
        yield
    finally:
        ended.set()
        thread.join()


async def _publish_honest(port: int, ended: threading.Event) -> None:
    async with aiomqtt.Client("127.0.0.1", port, timeout=PUBLISH_S) as client:
        while not ended.is_set():
            await client.publish(_topic(HONEST), _encode(make_report(HONEST, INSTANCE)))
            await asyncio.sleep(PAUSE_S)
