"""A publisher on a real broker fills no station's memory and hides no other station."""

import asyncio
import contextlib
import logging
import socket
import threading
from collections.abc import Iterator

import aiomqtt
import pytest

from crenel.supervision.bounded_client import LONGEST_PAYLOAD, BoundedClient, MessageHandler
from crenel.supervision.remote_stations import MOST_STATIONS
from tests.bench.faults.broker.mosquitto import Mosquitto
from tests.bench.faults.broker.usual_messages import make_report
from tests.supervision.test_broker import PATIENCE_S, Watch, station, watching

pytestmark = [pytest.mark.device, pytest.mark.soak]

LONG = b"x" * 20_000_000
ACCEPTED = b"\x20\x02\x00\x00"


def client_of(port: int, take: MessageHandler) -> BoundedClient:
    return BoundedClient(
        "127.0.0.1",
        port,
        take,
        user=None,
        password=None,
        identifier="bounded",
        will=aiomqtt.Will("will"),
        keepalive_s=2,
        answer_s=3.0,
        tls=None,
    )


def test_of_a_long_message_only_the_beginning_is_kept(broker: Mosquitto) -> None:
    """And the messages after it arrive whole."""

    async def run() -> None:
        heard: dict[str, tuple[bytes, bool]] = {}

        def take(topic: str, payload: bytes, retained: bool) -> None:
            heard[topic] = payload, retained

        async with (
            aiomqtt.Client("127.0.0.1", broker.port) as other,
            client_of(broker.port, take) as bounded,
        ):
            await bounded.subscribe("long/#", qos=1)
            for number, payload in enumerate((LONG, b"y" * LONGEST_PAYLOAD, LONG, b"z")):
                await other.publish(f"long/{number}", payload, qos=1)
            await other.publish(f"long/{'t' * 60_000}", LONG, qos=1)
            await other.publish("long/last", b"", qos=1)
            async with asyncio.timeout(PATIENCE_S):
                while "long/last" not in heard:
                    await asyncio.sleep(0.01)
        cut = b"x" * (LONGEST_PAYLOAD + 1)
        assert heard["long/0"][0] == heard["long/2"][0]
        assert len(heard["long/0"][0]) > LONGEST_PAYLOAD
        assert heard["long/0"][0].startswith(cut)
        assert len(heard["long/0"][0]) < len(cut) + 2**16
        assert heard[f"long/{'t' * 60_000}"][0].startswith(cut)
        assert heard["long/1"] == (b"y" * LONGEST_PAYLOAD, False)
        assert heard["long/3"] == (b"z", False)

    asyncio.run(run())


def test_a_flood_hides_no_station(broker: Mosquitto, caplog: pytest.LogCaptureFixture) -> None:
    async def flood(until: asyncio.Event) -> None:
        """Of two topics, of many stations, and of no station."""
        padded = make_report("loud", "1").model_dump_json().encode().ljust(60_000)
        async with aiomqtt.Client("127.0.0.1", broker.port) as other:
            for number in range(2 * MOST_STATIONS):
                name = f"kept-{number}"
                report = make_report(name, "1").model_dump_json()
                await other.publish(f"crenel/{name}/report", report, qos=1, retain=True)
            for kind in ("report", "presence", "event"):
                await other.publish(f"crenel/long/{kind}", LONG[:3_000_000], qos=1, retain=True)
            number = 0
            while not until.is_set():
                number += 1
                name = f"invented-{number}"
                await other.publish("crenel/loud/report", padded)
                await other.publish(
                    f"crenel/{name}/report", make_report(name, "1").model_dump_json()
                )
                await other.publish(f"crenel/{'x' * 300}/report", b"[" * 50_000)
                await other.publish("crenel/watcher/presence", b'{"state":"lost"}')

    async def look(watch: Watch) -> None:
        until = asyncio.Event()
        flooding = asyncio.create_task(flood(until))
        unread = watch.fleet.unread
        try:
            await watch.until(lambda: set(unread.counts) == {"long", "strange", "often", "crowded"})
            async with station(broker.port, "real"):
                await watch.until(lambda: watch.state("real") == "live")
                for _ in range(30):
                    await asyncio.sleep(0.1)
                    assert watch.state("real") == "live"
                    assert len(watch.fleet.stations()) <= MOST_STATIONS
        finally:
            until.set()
            await flooding
        assert watch.broker.state.connected

    caplog.set_level(logging.DEBUG)
    watching(broker.port, look)
    assert len(caplog.records) < 10
    watching(broker.port, look_again)


async def look_again(watch: Watch) -> None:
    """After a restart what the broker keeps is bounded in the same way."""
    await watch.until(lambda: set(watch.fleet.unread.counts) == {"long", "crowded"})
    await watch.until(lambda: len(watch.fleet.stations()) == MOST_STATIONS)


@contextlib.contextmanager
def speaking(words: bytes) -> Iterator[tuple[int, list[socket.socket]]]:
    """A broker that takes every connection, says these words once it hears more, and no more."""
    with socket.create_server(("127.0.0.1", 0)) as listening:
        held: list[socket.socket] = []

        def serve() -> None:
            with contextlib.suppress(OSError):
                while True:
                    held.append(listening.accept()[0])
                    held[-1].recv(4096)
                    held[-1].sendall(ACCEPTED)
                    held[-1].recv(4096)
                    held[-1].sendall(words)

        serving = threading.Thread(target=serve)
        serving.start()
        yield listening.getsockname()[1], held
        for one in (listening, *held):
            with contextlib.suppress(OSError):  # which ends a wait, as closing does not
                one.shutdown(socket.SHUT_RDWR)
        serving.join()
        for one in held:
            one.close()


def test_a_broker_that_answers_nothing_holds_nothing_up() -> None:
    with speaking(b"") as (port, held):

        async def look(watch: Watch) -> None:
            await watch.until(lambda: len(held) >= 2)
            assert not watch.broker.state.connected
            assert "timed out" in str(watch.broker.state.text)
            held[0].setblocking(False)
            while held[0].recv(65536):
                pass  # it was closed here

        watching(port, look)


def test_it_ends_while_a_broker_answers_nothing() -> None:
    with speaking(b"") as (port, held):

        async def look(watch: Watch) -> None:
            await watch.until(lambda: held)
            await asyncio.sleep(0.5)  # connected, and waiting for the answer to its presence

        watching(port, look)


def test_what_was_never_asked_for_ends_the_connection() -> None:
    """Messages of the third quality of service, which would be kept until they are released."""
    exactly_once = b"\x34\x09\x00\x04spam\x00\x01x"
    with speaking(exactly_once) as (port, _):

        async def run() -> None:
            async with client_of(port, lambda *_: None) as bounded:
                await bounded.publish("ready")
                await anext(aiter(bounded.messages))

        with pytest.raises(aiomqtt.MqttError) as raised:
            asyncio.run(asyncio.wait_for(run(), PATIENCE_S))
        assert "Protocol error" in str(raised.value.__cause__)
