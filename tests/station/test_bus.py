"""Live state: newest values, numbered events, readers that delay nobody."""

import asyncio
import threading
from collections.abc import Callable, Coroutine
from functools import wraps

from app.station.bus import EVENT_BUFFER, Bus


def on_its_loop(test: Callable[[Bus], Coroutine[None, None, None]]) -> Callable[[Bus], None]:
    """Runs a test on an event loop that the bus is attached to."""

    @wraps(test)
    def run(bus: Bus) -> None:
        async def attached() -> None:
            bus.attach(asyncio.get_running_loop())
            await test(bus)

        asyncio.run(attached())

    return run


@on_its_loop
async def test_a_new_reader_gets_the_whole_snapshot_and_then_only_what_changes(bus: Bus) -> None:
    bus.publish("scan", 1)
    bus.publish("devices", 2)
    with bus.subscribe() as reader:
        assert (await reader.next()).topics == {"scan": 1, "devices": 2}
        bus.publish("scan", 3)
        assert (await reader.next()).topics == {"scan": 3}


@on_its_loop
async def test_a_slow_reader_finds_the_newest_value_and_holds_up_nobody(bus: Bus) -> None:
    slow, quick = bus.subscribe(), bus.subscribe()
    seen = []
    for value in range(50):
        bus.publish("devices", value)
        seen.append((await quick.next()).topics["devices"])
    assert seen == list(range(50))
    assert (await slow.next()).topics == {"devices": 49}


@on_its_loop
async def test_publishing_from_many_threads_reaches_the_loop(bus: Bus) -> None:
    reader = bus.subscribe()
    called: list[int] = []
    loop_thread = threading.get_ident()

    def work(number: int) -> None:
        for value in range(100):
            bus.publish(f"topic{number}", value)
        bus.call(lambda: called.append(threading.get_ident()))

    threads = [threading.Thread(target=work, args=(n,)) for n in range(4)]
    for thread in threads:
        thread.start()
    newest: dict[str, object] = {}
    while newest != {f"topic{n}": 99 for n in range(4)}:
        newest |= (await asyncio.wait_for(reader.next(), 240)).topics
    for thread in threads:
        thread.join()
    await asyncio.sleep(0)
    assert called == [loop_thread] * 4


@on_its_loop
async def test_events_are_numbered_and_a_reader_knows_what_it_missed(bus: Bus) -> None:
    bus.event("before", "received by nobody")
    reader = bus.subscribe()
    for number in range(EVENT_BUFFER + 10):
        bus.event("beep", str(number))
    updates = await reader.next()
    assert updates.events_missed == 10
    assert [event.text for event in updates.events] == [
        str(number) for number in range(10, EVENT_BUFFER + 10)
    ]
    ids = [event.id for event in updates.events]
    assert ids == list(range(ids[0], ids[0] + EVENT_BUFFER))
    bus.event("beep", "last")
    updates = await reader.next()
    assert (updates.events_missed, [e.text for e in updates.events]) == (0, ["last"])


@on_its_loop
async def test_a_topic_that_is_not_wanted_waits_until_it_is(bus: Bus) -> None:
    reader = bus.subscribe(without={"preview"})
    bus.publish("preview", "one")
    bus.publish("scan", 1)
    assert (await reader.next()).topics == {"scan": 1}
    bus.publish("preview", "two")
    reader.want("preview", True)
    assert (await reader.next()).topics == {"preview": "two"}
    reader.want("preview", False)
    bus.publish("preview", "three")
    bus.publish("scan", 2)
    assert (await reader.next()).topics == {"scan": 2}


def test_a_bus_without_a_loop_drops_calls_and_keeps_values() -> None:
    bus = Bus()
    bus.call(lambda: 1 / 0)
    bus.publish("scan", 5)
    assert bus.latest("scan") == 5
