"""An MQTT client that takes a bounded memory, whatever the broker sends.

The libraries below gather a packet whole, of up to 256 MB, and every message in a queue. Here of
a long packet only the beginning is kept, and each message is handed over as it comes.
"""

import logging
import ssl
from collections.abc import Callable
from types import TracebackType
from typing import Any, Self

import aiomqtt
from paho.mqtt import client as paho
from paho.mqtt.enums import MQTTErrorCode

from app.supervision.inbox import LONGEST_BYTES

MessageHandler = Callable[[str, bytes, bool], None]
"""Of a topic, a payload, and whether the broker kept it from before."""
LONGEST_PAYLOAD = max(LONGEST_BYTES.values())
_BUFFER_BYTES = 2 + 0xFFFF + 2 + LONGEST_PAYLOAD + 1
"""Bytes of a packet: the longest topic, its number, and one more than the longest payload."""
_READ_BYTES = 64 * 1024
_QOS, _EXACTLY_ONCE = 0x06, 0x04
SILENT = logging.getLogger("crenel.mqtt")
"""What the libraries log is at the broker's choice; what matters is raised besides."""
SILENT.setLevel(logging.CRITICAL + 1)
NO_TOPIC = ""


class BoundedClient(aiomqtt.Client):
    """Passes each message to ``take`` on the event loop; ``messages`` only ends, by an error.

    A payload that is too long is passed with its first ``LONGEST_PAYLOAD + 1`` bytes; a
    topic that is no text as ``NO_TOPIC``.
    """

    def __init__(
        self,
        host: str,
        port: int,
        take: MessageHandler,
        *,
        user: str | None,
        password: str | None,
        identifier: str,
        will: aiomqtt.Will,
        keepalive_s: int,
        answer_s: float,
        tls: ssl.SSLContext | None,
    ) -> None:
        super().__init__(
            host,
            port,
            username=user,
            password=password,
            identifier=identifier,
            will=will,
            keepalive=keepalive_s,
            timeout=answer_s,
            tls_context=tls,
            logger=SILENT,
        )
        self._take = take
        # the library makes its own, and lets none be given
        self._client.__class__ = _BoundedPaho

    def _on_message(self, client: paho.Client, userdata: Any, message: paho.MQTTMessage) -> None:
        try:
            topic = message.topic
        except UnicodeDecodeError:
            topic = NO_TOPIC
        self._take(topic, bytes(message.payload), message.retain)

    def _on_disconnect(self, *args: Any) -> None:
        super()._on_disconnect(*args)
        if self._disconnected.done():
            self._disconnected.exception()  # where nobody asks for it, it would be logged

    async def __aexit__(
        self,
        exc_type: type[BaseException] | None,
        exc: BaseException | None,
        tb: TracebackType | None,
    ) -> None:
        """Closes the connection also where the broker does not take leave."""
        try:
            await super().__aexit__(exc_type, exc, tb)
        finally:
            if isinstance(self._client, _BoundedPaho):
                self._client.drop()


class _BoundedBuffer(bytearray):
    """Bytes that are added to; beyond the bound they are forgotten."""

    def __iadd__(self, more: Any) -> Self:  # type: ignore[misc]
        self.extend(more[: max(_BUFFER_BYTES - len(self), 0)])
        return self


class _BoundedPaho(paho.Client):
    def _packet_read(self) -> MQTTErrorCode:
        if type(self._in_packet["packet"]) is bytearray:
            self._in_packet["packet"] = _BoundedBuffer(self._in_packet["packet"])
        return super()._packet_read()

    def _sock_recv(self, bufsize: int) -> bytes:
        return super()._sock_recv(min(bufsize, _READ_BYTES))

    def _handle_publish(self) -> MQTTErrorCode:
        # never asked for, and the library would keep it until it is released
        if self._in_packet["command"] & _QOS == _EXACTLY_ONCE:
            return MQTTErrorCode.MQTT_ERR_PROTOCOL
        return super()._handle_publish()

    def drop(self) -> None:
        """Closes the socket if it is open."""
        self._sock_close()
