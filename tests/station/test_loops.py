"""Loops go on after whatever kills a step; silence is measured by a clock that stands with them."""

import asyncio
import gc
import json
import logging
import os
import signal
import subprocess
import sys
import threading
import time
from collections.abc import Callable, Iterator
from contextlib import contextmanager
from dataclasses import replace
from functools import partial
from pathlib import Path

import pytest

from crenel.errors import OperationError
from crenel.formats.datasheets.target import read_block
from crenel.loop_states import LONGEST_TURN_S, LoopState, Supervision, note_progress, waiting
from crenel.loops import (
    LOOPS,
    Loop,
    LoopRegistry,
    on_thread,
    repeat,
    reporting_deaths,
    start_worker,
)
from crenel.monitoring.background_health import background
from crenel.operations import publishers
from crenel.operations.context import Context
from crenel.operations.health_checks import HealthChecker
from crenel.server.application import build_app
from crenel.station.devices.rig import Devices
from crenel.supervision.webhook import WebhookSettings
from crenel_hardware.simulator.station import SimulatedStation
from tests.guide.stations import Station
from tests.station.conftest import until

pytestmark = pytest.mark.device

DEATHS = (
    ValueError("a mistake"),
    OSError(24, "too many open files"),
    OperationError("disk-full", "the disk is full"),
    SystemExit(1),
    KeyboardInterrupt(),
)
THREADS = {
    *("arm-reader", "sensor-reader", "awake", "rig-state", "scan-state", "scene", "view"),
    *("preview", "object-watch", "loop-watchdog", "hang-watch", "log-writer", "simulated-arm"),
}
TASKS = {"live-state", "report", "stations", "events", "health", "temperature", "notifications"}
SCRIPT = """
import sys, time
from crenel.station.devices.awake_clock import AWAKE
begin_s, awake_s = time.monotonic(), AWAKE.now_s()
for line in sys.stdin:
    print(time.monotonic() - begin_s, AWAKE.now_s() - awake_s, flush=True)
"""


def state_of(name: str) -> LoopState:
    return next(one for one in LOOPS.states() if one.name == name)


def lines(caplog: pytest.LogCaptureFixture, name: str) -> list[str]:
    """The messages that were logged of a loop's failures."""
    found = [(str(one.msg), str(getattr(one.msg, "message_id", ""))) for one in caplog.records]
    return [kind for text, kind in found if kind.startswith("log-loop-") and f" {name} " in text]


@pytest.mark.parametrize("death", DEATHS, ids=lambda one: type(one).__name__)
@pytest.mark.parametrize("times", [1, 3])
def test_a_loop_goes_on_and_one_kind_of_error_is_logged_once(
    death: BaseException, times: int, caplog: pytest.LogCaptureFixture
) -> None:
    name = f"killed-{times}-{type(death).__name__}"
    done: list[int] = []

    def step() -> None:
        done.append(len(done))
        if 1 < len(done) <= 1 + times:
            raise death

    with caplog.at_level(logging.INFO):
        loop = Loop(name, step, 0.001)
        loop.start()
        until(lambda: len(done) > times + 3)
        state = state_of(name)
        loop.stop()
    assert not loop.is_alive()
    assert (state.running, state.failures, state.failing) == (1, times, False)
    assert state.newest is not None
    assert len(lines(caplog, name)) == 1
    assert state_of(name).running == 0


def test_a_step_that_fails_stops_no_other_and_a_cancelled_task_ends() -> None:
    done: list[str] = []

    async def broken() -> None:
        done.append("broken")
        raise ValueError("a mistake")

    async def cancelled_inside() -> None:
        raise asyncio.CancelledError

    async def whole() -> None:
        done.append("whole")

    async def run() -> LoopState:
        task = asyncio.create_task(repeat("three", broken, cancelled_inside, whole, period_s=0.001))
        while done.count("whole") < 2:
            await asyncio.sleep(0)
        state = state_of("three")
        task.cancel()
        with pytest.raises(asyncio.CancelledError):
            await task
        return state

    state = asyncio.run(run())
    assert done[:4] == ["broken", "whole"] * 2
    assert state.failing
    assert state.failures >= 4


@pytest.mark.filterwarnings("ignore::pytest.PytestUnhandledThreadExceptionWarning")
def test_what_dies_unsupervised_is_reported(caplog: pytest.LogCaptureFixture) -> None:
    def die(error: BaseException) -> None:
        raise error

    async def task() -> None:
        raise ValueError("a task")

    async def run() -> None:
        hook = threading.excepthook
        with reporting_deaths():
            for error in (ValueError("a thread"), SystemExit(3)):
                await asyncio.to_thread(start_worker("worker-that-dies", die, error).join)
            doomed = asyncio.create_task(task())
            await asyncio.wait([doomed])
            del doomed
            gc.collect()
            await asyncio.sleep(0)
        assert threading.excepthook is hook

    before = LOOPS.death_count
    asyncio.run(run())
    assert LOOPS.death_count == before + 3
    said = [str(one.error) for one in LOOPS.deaths()[-3:]]
    assert said == ["ValueError: a thread", "SystemExit: 3", "ValueError: a task"]
    item = background((), LOOPS.deaths()[-3:], LOOPS.deaths()[-1].at_s, 0.0)
    assert item.quality == "attention"
    assert str(item.what).count("Ended by an error") == 3
    assert sum("was ended by an error" in one.getMessage() for one in caplog.records) == 3


class Turns:
    """A loop's step that stands in its second turn until it is let go."""

    def __init__(self) -> None:
        self.reached, self.let_go, self.after = (threading.Event() for _ in range(3))
        self.count = 0

    def take(self) -> None:
        self.count += 1
        if self.count == 2:
            self.reached.set()
            self.stand_here()
        elif self.count > 2:
            self.after.set()

    def stand_here(self) -> None:
        self.let_go.wait()

    def wait_as_declared(self) -> None:
        with waiting():
            self.let_go.wait()

    def go_on_slowly(self) -> None:
        while not self.let_go.wait(0.001):
            note_progress()


class Looks:
    """The looks of the watch, by a clock that only the test moves."""

    def __init__(self, monkeypatch: pytest.MonkeyPatch) -> None:
        self.registry, self.now_s = LoopRegistry(), 1000.0
        monkeypatch.setattr("crenel.loops.LOOPS", self.registry)
        monkeypatch.setattr("crenel.loop_states.OWN", (__file__,))

    def let_pass(self, seconds: float, at_once: bool = False) -> None:
        self.registry.find_hangs(self.now_s)
        count = 1 if at_once else round(2 * seconds)
        for _ in range(count):
            self.now_s += seconds / count
            self.registry.find_hangs(self.now_s)

    def state(self) -> LoopState:
        (state,) = self.registry.states()
        return state


@contextmanager
def standing(kind: str, turns: Turns) -> Iterator[None]:
    """A loop of a kind that stands, as its turns want, while the block is open."""
    if kind == "thread":
        loop = Loop("stands", turns.take, 0.001)
        loop.start()
        turns.reached.wait()
        try:
            yield
        finally:
            turns.let_go.set()
            loop.stop()
        return
    ends = threading.Event()

    async def run() -> None:
        task = asyncio.create_task(repeat("stands", lambda: on_thread(turns.take), period_s=0.001))
        await asyncio.to_thread(ends.wait)
        task.cancel()
        await asyncio.wait([task])

    thread = threading.Thread(target=asyncio.run, args=(run(),))
    thread.start()
    turns.reached.wait()
    try:
        yield
    finally:
        turns.let_go.set()
        ends.set()
        thread.join()


@pytest.mark.parametrize("kind", ["thread", "task"])
def test_a_loop_that_stands_still_is_named_once_and_so_is_its_going_on(
    kind: str, monkeypatch: pytest.MonkeyPatch, caplog: pytest.LogCaptureFixture
) -> None:
    looks, turns = Looks(monkeypatch), Turns()
    with caplog.at_level(logging.INFO), standing(kind, turns):
        looks.let_pass(LONGEST_TURN_S)
        assert (looks.state().stands, lines(caplog, "stands")) == (False, [])
        looks.let_pass(2.0)
        assert looks.state().stands
        looks.let_pass(60.0)
        state = looks.state()
        item = background([state], (), looks.now_s, 0.0)
        assert item.quality == "bad"
        said = "Has stood still for 1 min 12 s: stands (in stand_here, test_loops.py:"
        assert str(item.what).startswith(said)
        assert lines(caplog, "stands") == ["log-loop-stands"]
        trace = str(vars(caplog.records[-1])["trace"])
        assert "self.let_go.wait()" in trace
        turns.let_go.set()
        turns.after.wait()
        looks.let_pass(1.0)
        state = looks.state()
        item = background([state], (), looks.now_s, 0.0)
    assert (state.hangs, state.stands, state.failures) == (1, False, 0)
    assert item.quality == "attention"
    assert str(item.what).startswith(
        "Stood still for 1 min 12 s until 1 s ago, and goes on: stands"
    )
    assert lines(caplog, "stands") == ["log-loop-stands", "log-loop-goes-on"]


def has_moved(loop: Supervision, signs: int) -> bool:
    return loop.signs > signs


@pytest.mark.parametrize("stand", ["wait_as_declared", "go_on_slowly", "stand_here"])
def test_a_loop_that_waits_as_declared_or_goes_on_is_not_accused_nor_is_a_suspended_program(
    stand: str, monkeypatch: pytest.MonkeyPatch
) -> None:
    looks, turns = Looks(monkeypatch), Turns()
    suspended = stand == "stand_here"
    monkeypatch.setattr(turns, "stand_here", getattr(turns, stand))
    with standing("thread", turns):
        (loop,) = looks.registry._running
        for _ in range(8):
            signs = loop.signs
            looks.let_pass(1000.0 if suspended else LONGEST_TURN_S / 4, at_once=suspended)
            if stand == "go_on_slowly":
                until(partial(has_moved, loop, signs))
        state = looks.state()
    assert (state.hangs, state.hang) == (0, None)


class Killed:
    """Something that raises once, and is what it was before and afterwards."""

    def __init__(self, whole: Callable[..., object]) -> None:
        self.whole, self.calls = whole, 0

    def __call__(self, *arguments: object, **named: object) -> object:
        self.calls += 1
        if self.calls == 1:
            raise ZeroDivisionError("killed by the test")
        return self.whole(*arguments, **named)


@contextmanager
def kill_threads() -> Iterator[set[str]]:
    """Kills the present step of each loop that has a thread; their names."""
    targets = [getattr(thread, "_target", None) for thread in threading.enumerate()]
    loops = [one for target in targets if isinstance(one := getattr(target, "__self__", 0), Loop)]
    for loop in loops:
        loop._step = Killed(loop._step)  # type: ignore[assignment]
    yield {loop._name for loop in loops}


def kill_tasks(context: Context, patch: pytest.MonkeyPatch) -> None:
    """Kills a part of each loop that has a task."""
    watch = context.monitoring
    for owner, name in (
        *((publishers, "build_home"), (publishers, "build_report")),
        *((watch.fleet, "stations"), (publishers, "_pass_on"), (context.rig, "losing")),
        *((watch.temperature, "read"), (watch.webhook, "_send")),
    ):
        patch.setattr(owner, name, Killed(getattr(owner, name)))


@pytest.fixture(scope="module")
def simulation() -> Iterator[SimulatedStation]:
    with SimulatedStation() as simulation:
        yield simulation


def test_each_loop_of_a_station_is_restarted_and_its_signs_stay_true(
    simulation: SimulatedStation,
    tmp_path: Path,
    monkeypatch: pytest.MonkeyPatch,
    caplog: pytest.LogCaptureFixture,
) -> None:
    (tmp_path / "object.json").write_text(json.dumps(simulation.datasheets()["object.json"]))
    parts = replace(Station(simulation, tmp_path).parts, simulated_operator=None)

    async def kill_all(context: Context) -> None:
        bus, watch = context.bus, context.monitoring
        await asyncio.to_thread(until, lambda: has_devices(bus.latest("devices"), "connected"))
        before = {one.name: one.failures for one in LOOPS.states()}
        kill_tasks(context, monkeypatch)
        with kill_threads() as threads:
            assert threads >= THREADS
            bus.event("killed", "an event")
            context.library.record_view._wanted.set()  # else it waits for a record
            watch.webhook.settings = WebhookSettings(url="http://127.0.0.1:9/", secret="s")
            watch.notify("test", "a notice")

            def all_work() -> bool:
                states = {one.name: one for one in LOOPS.states()}
                failed = {k for k, one in states.items() if one.failures > before.get(k, 0)}
                return failed >= threads | TASKS and not any(one.failing for one in states.values())

            simulation.arm_faults.unplugged = simulation.camera_faults.lost = True
            await asyncio.to_thread(until, lambda: has_devices(bus.latest("devices"), "lost"))
            simulation.clear_faults()
            await asyncio.to_thread(until, lambda: has_devices(bus.latest("devices"), "connected"))
            await asyncio.to_thread(until, all_work)

    async def run() -> Context:
        app = build_app(parts)
        async with app.router.lifespan_context(app):
            context: Context = app.state.context
            context.preview.detect(read_block(tmp_path / "object.json"))
            with context.preview.watch():
                await kill_all(context)
            item = {one.id: one for one in HealthChecker(context).look().items}["background"]
            assert item.quality == "attention"
            assert "state of the devices (ZeroDivisionError: killed by the test)" in str(item.what)
        return context

    try:
        logs = asyncio.run(run()).monitoring.logs
    finally:
        simulation.clear_faults()
    assert logs.read("error", "killed by the test", 1)
    for name in THREADS | TASKS:
        assert lines(caplog, name) == ["log-loop-failed"], name


def has_devices(devices: object, state: str) -> bool:
    return isinstance(devices, Devices) and devices.arm.state == devices.sensor.state == state


def seconds(process: subprocess.Popen[str]) -> tuple[float, float]:
    """Wall-clock and awake seconds of a process."""
    assert process.stdin is not None
    assert process.stdout is not None
    process.stdin.write("\n")
    process.stdin.flush()
    wall_s, awake_s = process.stdout.readline().split()
    return float(wall_s), float(awake_s)


@pytest.fixture
def process() -> Iterator[subprocess.Popen[str]]:
    command = [sys.executable, "-c", SCRIPT]
    with subprocess.Popen(
        command, stdin=subprocess.PIPE, stdout=subprocess.PIPE, text=True
    ) as running:
        seconds(running)
        yield running


def test_it_stands_while_the_program_is_stopped(process: subprocess.Popen[str]) -> None:
    os.kill(process.pid, signal.SIGSTOP)
    time.sleep(1.5)
    os.kill(process.pid, signal.SIGCONT)
    wall_s, awake_s = seconds(process)
    assert wall_s >= 1.5
    assert awake_s <= wall_s - 1.0


def test_it_goes_on_while_the_program_runs(process: subprocess.Popen[str]) -> None:
    until(lambda: seconds(process)[1] >= 0.5)
    wall_s, awake_s = seconds(process)
    assert awake_s <= wall_s + 0.05
