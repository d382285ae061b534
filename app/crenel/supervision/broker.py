"""The connection to the MQTT broker: messages of this station and of others."""

import asyncio
import contextlib
import logging
import ssl
import time
from collections.abc import Callable
from dataclasses import dataclass

import aiomqtt
from aiomqtt.exceptions import MqttConnectError

from crenel.errors import OperationError
from crenel.messages.message import Text, message
from crenel.supervision.bounded_client import BoundedClient
from crenel.supervision.broker_settings import BrokerSettings
from crenel.supervision.inbox import Inbox, ReceivedMessage
from crenel.supervision.messages import (
    BEAT_S,
    Payload,
    Presence,
    StationEvent,
    StationReport,
    topic,
)
from crenel.supervision.remote_stations import Fleet


def explain_failure(error: Exception, tls: bool) -> tuple[Text, Text]:
    """The reason why a connection to a broker failed or ended, and its remedy.

    Args:
        error: of the client, which keeps that of the network as its context.
        tls: whether the connection is encrypted.
    """
    if isinstance(error, OperationError):
        return error.text, error.remedy
    reason = str(error)
    if isinstance(error, MqttConnectError):
        return reason, message("check-broker-user-and-password")
    cause = error.__context__ if isinstance(error, aiomqtt.MqttError) else error
    if isinstance(cause, ssl.SSLCertVerificationError):
        return reason, message("check-broker-certificate")
    if isinstance(cause, ssl.SSLError) or (tls and isinstance(cause, ConnectionResetError)):
        return message("broker-speaks-no-tls", reason=reason), message("check-broker-tls-off")
    # asyncio's own end of a wait says nothing; one of the network has words or a number
    if not tls and isinstance(cause, TimeoutError) and not cause.args:
        return message("broker-gives-no-answer", reason=reason), message("check-broker-tls-on")
    return reason, message("check-broker-runs")


log = logging.getLogger(__name__)
KEEPALIVE_S = 2
"""The broker sends the last will of a dead connection after one and a half times this interval."""
ANSWER_S = 3.0
FIRST_BACK_OFF_S, LONGEST_BACK_OFF_S = 0.5, 15.0
EVENTS_WAITING = 100
READ_PAUSE_S, READ_BYTES = 0.1, 1_000_000
"""Number of waiting messages processed at a time, and interval; the others wait, or are
overtaken."""


@dataclass(frozen=True)
class BrokerState:
    """State of the connection, for the Health page."""

    connected: bool
    text: Text
    """The last error, while it is not connected."""
    since_s: float
    tries: int
    remedy: Text = ""


class Broker:
    """Maintains one connection permanently; if it is lost, it reconnects with growing pauses.

    Everything runs on the event loop. The station works with or without the connection: only the
    latest report counts, and the oldest waiting events are dropped.

    Args:
        listens_only: it is no station: it appears nowhere, and publishes nothing.
    """

    def __init__(
        self,
        settings: BrokerSettings,
        station: str,
        name: str,
        instance: str,
        fleet: Fleet,
        listens_only: bool = False,
    ) -> None:
        self._listens_only = listens_only
        self._settings, self._station, self._name = settings, station, name
        self._instance, self.fleet = instance, fleet
        self._report: StationReport | None = None
        self._changed = asyncio.Event()
        self._events: asyncio.Queue[StationEvent] = asyncio.Queue(EVENTS_WAITING)
        self._state = BrokerState(False, message("not-connected-yet"), time.monotonic(), 0)
        self.events_dropped = 0
        self.doubled_at_s: float | None = None
        """When another process was last heard under the name of this station."""
        self.on_message: Callable[[], None] = lambda: None
        """Called after a message of another station."""

    @property
    def state(self) -> BrokerState:
        return self._state

    @property
    def settings(self) -> BrokerSettings:
        return self._settings

    def report(self, report: StationReport) -> None:
        """The next report; an older one that was not yet sent is discarded."""
        self._report = report
        self._changed.set()

    def event(self, event: StationEvent) -> None:
        """Publishes an event once; without a broker, the newest ones wait."""
        if self._events.full():
            self._events.get_nowait()
            self.events_dropped += 1
        self._events.put_nowait(event)

    async def run(self) -> None:
        """Runs until cancelled; then publishes that the station has ended regularly."""
        pause_s, tries = FIRST_BACK_OFF_S, 0
        while True:
            began_s = time.monotonic()
            try:
                await self._connection()
            except (aiomqtt.MqttError, OperationError, OSError, ssl.SSLError, ValueError) as error:
                _end_if_cancelled()
                text, remedy = explain_failure(error, self._settings.is_encrypted)
                if self._state.connected:
                    log.warning(message("log-broker-lost", reason=text))
                    tries = 0
                if time.monotonic() - began_s > LONGEST_BACK_OFF_S:
                    pause_s = FIRST_BACK_OFF_S
                tries += 1
                since_s = time.monotonic() if self._state.connected else self._state.since_s
                self._state = BrokerState(False, text, since_s, tries, remedy)
                self.fleet.note_broker(False)
                self.on_message()
            await asyncio.sleep(pause_s)
            pause_s = min(2 * pause_s, LONGEST_BACK_OFF_S)

    async def _connection(self) -> None:
        settings = self._settings
        tls = None
        if settings.is_encrypted:
            tls = ssl.create_default_context(cafile=settings.ca_file)
        lost = aiomqtt.Will(
            self._topic("presence"), self._presence("lost").model_dump_json(), 1, True
        )
        inbox = Inbox(settings.prefix, self.fleet.unread, self._is_known)
        async with BoundedClient(
            settings.host,
            settings.port,
            inbox.put,
            user=settings.user,
            password=await asyncio.to_thread(settings.password),
            identifier=f"crenel-{self._station}-{self._instance}",
            will=None if self._listens_only else lost,
            keepalive_s=KEEPALIVE_S,
            answer_s=ANSWER_S,
            tls=tls,
        ) as client:
            await self._send(client, "presence", self._presence("online"), retain=True)
            for kind, qos in (("presence", 1), ("report", 0), ("event", 1)):
                await client.subscribe(f"{settings.prefix}/+/{kind}", qos=qos)
            _end_if_cancelled()
            self._state = BrokerState(True, "", time.monotonic(), 0)
            self.fleet.note_broker(True)
            log.info(message("log-broker-connected", host=settings.host, port=str(settings.port)))
            tasks = [
                asyncio.create_task(self._publish_reports(client)),
                asyncio.create_task(self._publish_events(client)),
                asyncio.create_task(self._receive(client, inbox)),
                asyncio.create_task(_wait_until_lost(client)),
            ]
            try:
                done, _ = await asyncio.wait(tasks, return_when=asyncio.FIRST_COMPLETED)
                for task in done:
                    task.result()
            except asyncio.CancelledError:
                await _end_tasks(tasks)
                with contextlib.suppress(aiomqtt.MqttError):
                    await self._send(client, "presence", self._presence("off"), retain=True)
                raise
            finally:
                await _end_tasks(tasks)

    async def _publish_reports(self, client: aiomqtt.Client) -> None:
        """Publishes a report at every beat."""
        while True:
            await self._changed.wait()
            self._changed.clear()
            if self._report is not None:
                await self._send(client, "report", self._report, retain=True, qos=0)
            await asyncio.sleep(BEAT_S)

    async def _publish_events(self, client: aiomqtt.Client) -> None:
        while True:
            await self._send(client, "event", await self._events.get(), retain=False)

    async def _receive(self, client: aiomqtt.Client, inbox: Inbox) -> None:
        """Limited in what it reads at a time, so that many messages delay nothing else."""
        while True:
            await inbox.wait()
            left_bytes = READ_BYTES
            while left_bytes > 0 and (heard := inbox.take()) is not None:
                left_bytes -= len(heard.payload)
                await self._handle(client, heard)
                await asyncio.sleep(0)
            self.on_message()
            await asyncio.sleep(READ_PAUSE_S)

    async def _handle(self, client: aiomqtt.Client, heard: ReceivedMessage) -> None:
        if heard.station != self._station:
            self.fleet.take(heard.station, heard.kind, heard.payload, heard.retained)
        elif self._handle_echo(heard.kind, heard.payload, heard.retained):
            await self._send(client, "presence", self._presence("online"), retain=True)

    def _is_known(self, station: str) -> bool:
        return station == self._station or self.fleet.knows(station)

    def _handle_echo(self, kind: str, payload: bytes, retained: bool) -> bool:
        """Whether the presence must be sent again, because the last will of an earlier connection
        came late.

        Two stations with one name would appear as one: this is recorded.
        """
        if retained:
            return False
        if kind == "report" and self._instance.encode() not in payload:
            self.doubled_at_s = time.monotonic()
        return kind == "presence" and b'"state":"online"' not in payload

    async def _send(
        self, client: aiomqtt.Client, kind: str, payload: Payload, *, retain: bool, qos: int = 1
    ) -> None:
        if not self._listens_only:
            text = payload.model_dump_json()
            await client.publish(self._topic(kind), text, qos=qos, retain=retain)
        _end_if_cancelled()

    def _presence(self, state: str) -> Presence:
        return Presence.model_validate(
            {
                "station": self._station,
                "instance": self._instance,
                "name": self._name,
                "state": state,
            }
        )

    def _topic(self, kind: str) -> str:
        return topic(self._settings.prefix, self._station, kind)


def _end_if_cancelled() -> None:
    """Ends the running task if it was cancelled while the client waited for an answer.

    The client waits with ``asyncio.wait_for``, which up to Python 3.11 ignores a cancellation that
    arrives together with the answer; and its error, if the broker does not answer on disconnecting,
    replaces the cancellation.
    """
    task = asyncio.current_task()
    if task is not None and task.cancelling():
        raise asyncio.CancelledError


async def _wait_until_lost(client: aiomqtt.Client) -> None:
    """Raises when the connection is lost."""
    async for _ in client.messages:
        pass


async def _end_tasks(tasks: list[asyncio.Task[None]]) -> None:
    for task in tasks:
        task.cancel()
    await asyncio.gather(*tasks, return_exceptions=True)
