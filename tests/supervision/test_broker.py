"""Stations on a real broker: seen, killed, paused, ended, and the broker itself lost."""

import asyncio
import json
import signal
import subprocess
import sys
import time
from collections.abc import AsyncIterator, Callable, Coroutine, Iterator
from contextlib import asynccontextmanager, contextmanager
from functools import partial
from pathlib import Path

import aiomqtt
import pytest
import trustme
from jsonschema import Draft202012Validator

from crenel.supervision.broker import Broker
from crenel.supervision.broker_settings import BrokerSettings
from crenel.supervision.messages import new_instance, parse_topic, schema
from crenel.supervision.remote_stations import Fleet, RemoteStation
from tests.bench.faults.broker.mosquitto import PASSWORD, USER, Mosquitto
from tests.bench.faults.broker.usual_messages import make_event, make_report
from tests.bench.station.subprocess_station import free_port
from tests.present import present
from tests.supervision.publishing import publish

pytestmark = pytest.mark.device

ROOT = Path(__file__).resolve().parents[2]
PATIENCE_S = 240.0


@contextmanager
def started(port: int, name: str) -> Iterator[subprocess.Popen[str]]:
    """A station's publisher as a process of its own."""
    command = [sys.executable, "-m", "tests.supervision.publishing", str(port), name]
    with subprocess.Popen(command, cwd=ROOT, stdout=subprocess.PIPE, text=True) as process:
        try:
            yield process
        finally:
            process.kill()


def connected(process: subprocess.Popen[str]) -> None:
    assert present(process.stdout).readline() == "connected\n"


@asynccontextmanager
async def station(port: int, name: str) -> AsyncIterator[None]:
    """The same, within this process."""
    running = asyncio.create_task(publish(port, name))
    try:
        yield
    finally:
        running.cancel()
        await asyncio.gather(running, return_exceptions=True)


class Watch:
    """One more station, which looks on."""

    def __init__(self, settings: BrokerSettings, name: str) -> None:
        self.fleet, self.instance, self.name = Fleet(), new_instance(), name
        self.broker = Broker(settings, name, name, self.instance, self.fleet)

    def shown(self, name: str) -> RemoteStation | None:
        return next((one for one in self.fleet.stations() if one.id == name), None)

    def state(self, name: str) -> str:
        found = self.shown(name)
        return found.state if found else "unheard"

    async def until(self, ready: Callable[[], object]) -> None:
        began_s = time.monotonic()
        while not ready():
            assert time.monotonic() - began_s < PATIENCE_S, self.fleet.stations()
            await asyncio.sleep(0.02)


def watching(
    port: int, look: Callable[[Watch], Coroutine[object, object, None]], name: str = "watcher"
) -> None:
    async def run() -> None:
        watch = Watch(BrokerSettings(host="127.0.0.1", port=port), name)
        running = asyncio.create_task(watch.broker.run())
        try:
            await look(watch)
        finally:
            running.cancel()
            await asyncio.wait({running}, timeout=PATIENCE_S)
            assert running.cancelled()

    asyncio.run(run())


def test_a_station_that_is_killed_or_hangs_is_lost(broker: Mosquitto) -> None:
    async def look(watch: Watch) -> None:
        for name in ("killed", "paused", "well"):
            await watch.until(partial(lambda name: watch.state(name) == "live", name))
        await watch.until(lambda: (shown := watch.shown("killed")) and shown.events)
        killed.kill()
        paused.send_signal(signal.SIGSTOP)
        await watch.until(lambda: watch.state("killed") == watch.state("paused") == "lost")
        await watch.until(lambda: watch.state("well") == "live")
        found = present(watch.shown("paused"))
        assert found.report is not None, "what it last said is kept"

    async def look_later(watch: Watch) -> None:
        await watch.until(lambda: watch.state("killed") == watch.state("paused") == "lost")
        await watch.until(lambda: watch.state("well") == "live")
        paused.send_signal(signal.SIGCONT)
        await watch.until(lambda: watch.state("paused") == "live")

    port = broker.port
    with (
        started(port, "killed") as killed,
        started(port, "paused") as paused,
        started(port, "well") as well,
    ):
        for process in (killed, paused, well):
            connected(process)
        watching(port, look)
        watching(port, look_later)


def test_a_station_that_ends_in_order_says_so(broker: Mosquitto) -> None:
    async def ends(watch: Watch) -> None:
        watch.broker.report(make_report("ordered", watch.instance))
        await watch.until(lambda: watch.broker.state.connected)

    watching(broker.port, ends, "ordered")

    async def look(watch: Watch) -> None:
        await watch.until(lambda: watch.state("ordered") == "off")

    watching(broker.port, look)


def test_a_second_station_of_the_same_name_is_noticed(broker: Mosquitto) -> None:
    async def look(watch: Watch) -> None:
        async with station(broker.port, "twice"):
            await watch.until(lambda: watch.broker.doubled_at_s is not None)

    watching(broker.port, look, "twice")


def test_a_lost_broker_is_reported_and_found_again(tmp_path: Path, broker: Mosquitto) -> None:
    with Mosquitto(tmp_path) as own:

        async def look(watch: Watch) -> None:
            await watch.until(lambda: watch.broker.state.connected)
            async with station(own.port, "other"):
                await watch.until(lambda: watch.state("other") == "live")
                own.kill()
                await watch.until(lambda: not watch.broker.state.connected)
                assert watch.state("other") == "unknown", "it is the broker that is lost"
                assert watch.broker.state.text
                for number in range(300):
                    watch.broker.event(make_event("watcher", watch.instance, number))
                assert watch.broker.events_dropped == 200
                own.start()
                await watch.until(lambda: watch.broker.state.connected)
                await watch.until(lambda: watch.state("other") == "live")

        watching(own.port, look)


def test_a_broker_with_passwords(tmp_path: Path, broker: Mosquitto) -> None:
    with Mosquitto(tmp_path, passwords=True) as own:
        (tmp_path / "right").write_text(f"{PASSWORD}\n")
        (tmp_path / "wrong").write_text("another\n")

        async def look() -> None:
            for name, connects in (("right", True), ("wrong", False), ("none", False)):
                settings = BrokerSettings(
                    host="127.0.0.1", port=own.port, user=USER, password_file=tmp_path / name
                )
                watch = Watch(settings, "watcher")
                running = asyncio.create_task(watch.broker.run())
                state = watch.broker.state
                await watch.until(
                    partial(lambda watch, state: watch.broker.state is not state, watch, state)
                )
                assert watch.broker.state.connected is connects, name
                assert PASSWORD not in str(watch.broker.state.text)
                running.cancel()
                await asyncio.gather(running, return_exceptions=True)

        asyncio.run(look())


# paho lets the socket of a refused handshake go without closing it
@pytest.mark.filterwarnings("ignore:.*SSLSocket:pytest.PytestUnraisableExceptionWarning")
def test_what_keeps_a_station_from_its_broker_is_said(tmp_path: Path, broker: Mosquitto) -> None:
    authority = trustme.CA()
    authority.cert_pem.write_to_path(str(tmp_path / "ca.pem"))
    other = tmp_path / "other.pem"
    trustme.CA().cert_pem.write_to_path(str(other))
    own = authority.issue_cert("127.0.0.1")
    own.private_key_pem.write_to_path(str(tmp_path / "key.pem"))
    own.cert_chain_pems[0].write_to_path(str(tmp_path / "cert.pem"))
    lines = [f"keyfile {tmp_path / 'key.pem'}", f"certfile {tmp_path / 'cert.pem'}"]
    with (
        Mosquitto(tmp_path, settings=lines) as encrypted,
        Mosquitto(folder_of(tmp_path, "passwords"), passwords=True) as secret,
    ):
        there, ca_file = encrypted.port, tmp_path / "ca.pem"
        for options, remedy in (
            ({"port": there, "ca_file": ca_file}, ""),
            ({"port": there}, "Set tls = true"),
            ({"port": there, "ca_file": other}, "Set ca_file"),
            ({"port": broker.port, "tls": True}, "remove tls"),
            ({"port": secret.port}, "Check user and password_file"),
            ({"port": free_port()}, "Check that the broker runs"),
            ({"host": "no-such-host.invalid"}, "host and port"),
        ):
            settings = BrokerSettings.model_validate({"host": "127.0.0.1", **options})
            assert remedy in asyncio.run(first_remedy(settings)), options


def folder_of(parent: Path, name: str) -> Path:
    (parent / name).mkdir()
    return parent / name


async def first_remedy(settings: BrokerSettings) -> str:
    """What helps a station that tries once; nothing, if it connects."""
    watch = Watch(settings, "watcher")
    running = asyncio.create_task(watch.broker.run())
    state = watch.broker.state
    await watch.until(lambda: watch.broker.state is not state)
    running.cancel()
    await asyncio.gather(running, return_exceptions=True)
    assert watch.broker.state.connected == (not watch.broker.state.remedy)
    return str(watch.broker.state.remedy)


def test_what_is_published_is_as_the_schema_says(broker: Mosquitto) -> None:
    document = json.loads(json.dumps(schema()))
    Draft202012Validator.check_schema(document)
    topics = {name.rpartition("/")[2]: ref for name, ref in document["topics"].items()}

    async def listen() -> None:
        heard: dict[str, aiomqtt.Message] = {}
        async with (
            station(broker.port, "lasting"),
            aiomqtt.Client("127.0.0.1", broker.port) as early,
        ):
            await early.subscribe("crenel/lasting/#")
            async for message in early.messages:
                found = present(parse_topic("crenel", message.topic.value))
                heard[found[1]] = message
                if set(heard) == {"presence", "report", "event"}:
                    break
        async with aiomqtt.Client("127.0.0.1", broker.port) as later:
            await later.subscribe("crenel/lasting/#")
            message = await anext(aiter(later.messages))
            assert message.retain
        for kind, message in heard.items():
            payload = json.loads(bytes(message.payload))
            validator = Draft202012Validator({**document, **topics[kind]})
            validator.validate(payload)
            assert not validator.is_valid({**payload, "station": 5})

    asyncio.run(asyncio.wait_for(listen(), PATIENCE_S))


def test_a_station_ends_at_once_also_amid_its_events(broker: Mosquitto) -> None:
    """A cancellation that comes together with the broker's answer is not forgotten."""

    async def run() -> None:
        for turn in range(40):
            watch = Watch(BrokerSettings(host="127.0.0.1", port=broker.port), "ending")
            running = asyncio.create_task(watch.broker.run())
            await watch.until(partial(lambda watch: watch.broker.state.connected, watch))
            for number in range(60):
                watch.broker.event(make_event("ending", watch.instance, number))
            await asyncio.sleep(0.0004 * turn)
            running.cancel()
            done, _ = await asyncio.wait([running], timeout=PATIENCE_S)
            assert done, f"still there in turn {turn}"

    asyncio.run(run())
