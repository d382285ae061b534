"""An MQTT client with bounded memory, whatever the broker sends.

The libraries collect a complete packet of up to 256 MB, and every message in a queue. This client
keeps only the beginning of a long packet, and passes on each message as it arrives.
"""

import logging
import ssl
from collections.abc import Callable
from types import TracebackType
from typing import Any, Self

import aiomqtt
from paho.mqtt import client as paho
from paho.mqtt.enums import MQTTErrorCode

from crenel.supervision.inbox import LONGEST_BYTES

MessageHandler = Callable[[str, bytes, bool], None]
"""Topic, payload, and whether the broker retained it."""
LONGEST_PAYLOAD = max(LONGEST_BYTES.values())
_BUFFER_BYTES = 2 + 0xFFFF + 2 + LONGEST_PAYLOAD + 1
"""Bytes of a packet: the longest topic, its number, and one more than the longest payload."""
_READ_BYTES = 64 * 1024
_QOS, _EXACTLY_ONCE = 0x06, 0x04
SILENT = logging.getLogger("crenel.mqtt")
"""The broker determines what the libraries log; anything important is also raised."""
SILENT.setLevel(logging.CRITICAL + 1)
NO_TOPIC = ""


class BoundedClient(aiomqtt.Client):
    """Passes each message to ``take`` on the event loop; ``messages`` only ends with an error.

    Of a payload that is too long, the first ``LONGEST_PAYLOAD + 1`` bytes are passed; a topic that
    is not valid text is passed as ``NO_TOPIC``.
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
        will: aiomqtt.Will | None,
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
        # the library creates its own and accepts none
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
            self._disconnected.exception()  # if nobody awaits it, it would be logged

    async def __aexit__(
        self,
        exc_type: type[BaseException] | None,
        exc: BaseException | None,
        tb: TracebackType | None,
    ) -> None:
        """Closes the connection even if the broker does not confirm."""
        try:
            await super().__aexit__(exc_type, exc, tb)
        finally:
            if isinstance(self._client, _BoundedPaho):
                self._client.drop()


class _BoundedBuffer(bytearray):
    """A growing buffer; bytes beyond the limit are discarded."""

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
        # never requested, and the library would keep it until it is released
        if self._in_packet["command"] & _QOS == _EXACTLY_ONCE:
            return MQTTErrorCode.MQTT_ERR_PROTOCOL
        return super()._handle_publish()

    def drop(self) -> None:
        """Closes the socket if it is open."""
        self._sock_close()
