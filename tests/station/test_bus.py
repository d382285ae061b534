"""Live state and long work: newest values, numbered events, jobs off the event loop."""

import asyncio
import threading
from collections.abc import Callable, Coroutine
from functools import wraps

import pytest

from crenel.errors import OperationError
from crenel.station.bus import EVENT_BUFFER, Bus
from crenel.station.jobs import Job, Jobs, Progress
from tests.present import present


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


def run(bus: Bus, jobs: Jobs, work: Callable[[Progress], int]) -> Job[int]:
    async def scenario() -> Job[int]:
        loop = asyncio.get_running_loop()
        bus.attach(loop)
        ended: asyncio.Future[Job[int]] = loop.create_future()
        jobs.start("Solving", work, ended.set_result)
        return await asyncio.wait_for(ended, 240)

    return asyncio.run(scenario())


def test_work_runs_on_a_thread_and_reports_its_progress(bus: Bus) -> None:
    jobs, seen = Jobs(bus), []

    def work(progress: Progress) -> int:
        progress("half of it", 0.5)
        assert jobs.current is not None
        seen.append((threading.current_thread().name, jobs.current.text, jobs.current.fraction))
        return 42

    job = run(bus, jobs, work)
    assert (job.result, job.refusal, job.finished) == (42, None, True)
    assert seen == [("job-Solving", "half of it", 0.5)]
    assert jobs.current is None


def test_a_refusal_and_a_mistake_both_end_as_a_reason(bus: Bus) -> None:
    def refuse(progress: Progress) -> int:
        raise OperationError("too-few-contacts", "four contacts", "six are needed")

    def fail(progress: Progress) -> int:
        return 1 // 0

    jobs = Jobs(bus)
    refused = present(run(bus, jobs, refuse).refusal)
    assert refused.code == "too-few-contacts"
    failed = present(run(bus, jobs, fail).refusal)
    assert "division" in str(failed.why)
    assert jobs.current is None


def test_one_job_at_a_time(bus: Bus) -> None:
    jobs, go_on = Jobs(bus), threading.Event()
    jobs.start("Solving", lambda progress: go_on.wait(240), lambda job: None)
    with pytest.raises(OperationError, match="Solving is still running"):
        jobs.start("Another", lambda progress: 1, lambda job: None)
    go_on.set()
    jobs.wait(240)
    jobs.start("Another", lambda progress: 1, lambda job: None)
    jobs.wait(240)
