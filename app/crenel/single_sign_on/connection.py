"""Requests of this server to the provider; each failure is one sentence."""

import asyncio
import json
import logging
import ssl
import zlib
from collections.abc import Iterator, Mapping
from pathlib import Path
from typing import Any

import httpx

from crenel.formats.json_document import is_deep, is_valid_unicode
from crenel.messages.message import message
from crenel.single_sign_on.errors import ProviderAwayError
from crenel.single_sign_on.settings import is_encrypted_or_local

log = logging.getLogger(__name__)
ANSWER_WITHIN_S = 5.0
LARGEST_ANSWER = 1 << 19
MOST_PARTS = 10_000
"""Objects and lists of an answer: json reads all of them without giving way to other threads."""
COMPRESSED = ("gzip", "x-gzip", "deflate")
"""What some send, though nothing compressed is asked for."""
SERVER_ERROR = 500


class ProviderConnection:
    """Asks one provider; every request has its own connection, for they are rare.

    Args:
        name: the provider's, in messages.
        ca_file: certificates of its authority; by default those of the system.
    """

    def __init__(self, name: str, ca_file: Path | None) -> None:
        self._name = name
        self._tls = ssl.create_default_context(cafile=ca_file)

    async def get_document(self, address: str, token: str = "") -> dict[str, Any]:
        """A JSON object of the provider.

        Args:
            token: an access token that it requires.

        Raises:
            ProviderAwayError: it cannot be reached, or answers something else.
        """
        headers = {"Authorization": f"Bearer {token}"} if token else {}
        status, document = await self._ask("GET", address, headers=headers)
        if status != httpx.codes.OK or document is None:
            log.warning("%s answers %d to %s", self._name, status, address)
            raise self.unusable_error()
        return document

    async def post_form(
        self, address: str, form: Mapping[str, str], auth: tuple[str, str] | None
    ) -> tuple[int, dict[str, Any]]:
        """Status and JSON object of the answer to a form.

        Raises:
            ProviderAwayError: it cannot be reached, or answers something else.
        """
        status, document = await self._ask("POST", address, data=dict(form), auth=auth)
        if document is None or status >= SERVER_ERROR:
            log.warning("%s answers %d to %s", self._name, status, address)
            raise self.unusable_error()
        return status, document

    async def get_status(self, address: str) -> int:
        """The status with which the provider answers a request for a page.

        Raises:
            ProviderAwayError: it cannot be reached.
        """
        return (await self._ask("GET", address))[0]

    async def _ask(
        self, method: str, address: str, **options: Any
    ) -> tuple[int, dict[str, Any] | None]:
        if not is_encrypted_or_local(address):
            log.warning("%s names an address without encryption: %s", self._name, address)
            raise self.unusable_error()
        try:
            async with (
                asyncio.timeout(ANSWER_WITHIN_S),
                httpx.AsyncClient(
                    verify=self._tls,
                    timeout=ANSWER_WITHIN_S,
                    headers={"Accept-Encoding": "identity"},
                ) as client,
                client.stream(method, address, **options) as answer,
            ):
                raw, encoding = await _read(answer), answer.headers.get("Content-Encoding", "")
                # a long document would hold the event loop
                document = await asyncio.to_thread(_parse_object, raw, encoding)
                return answer.status_code, document
        except (
            *(httpx.HTTPError, httpx.InvalidURL, TimeoutError, OSError),
            ValueError,  # of a host name that cannot be encoded
        ) as error:
            raise self.away_error(error) from error

    def away_error(self, error: BaseException) -> ProviderAwayError:
        """The provider cannot be reached."""
        log.warning("%s cannot be reached: %s: %s", self._name, type(error).__name__, error)
        if any(isinstance(cause, ssl.SSLError) for cause in _causes(error)):
            return ProviderAwayError(
                "certificate",
                message("sign-in-certificate-not-trusted", name=self._name),
                message("sign-in-give-ca-file"),
            )
        return ProviderAwayError(
            "provider-away",
            message("sign-in-provider-away", name=self._name),
            message("sign-in-use-local-account"),
        )

    def unusable_error(self) -> ProviderAwayError:
        """What the provider says cannot be used."""
        return ProviderAwayError(
            "provider-unusable",
            message("sign-in-provider-unusable", name=self._name),
            message("sign-in-check-issuer"),
        )


async def _read(answer: httpx.Response) -> bytes:
    """The body as sent; an empty one if it is too large to be an answer to what was asked."""
    read = bytearray()
    async for part in answer.aiter_raw():
        read += part
        if len(read) > LARGEST_ANSWER:
            return b""
    return bytes(read)


def _parse_object(raw: bytes, encoding: str) -> dict[str, Any] | None:
    try:
        content = _unpack(raw, encoding.strip().lower())
        if content.count(b"{") + content.count(b"[") > MOST_PARTS:
            return None
        document = json.loads(content)
        usable = isinstance(document, dict) and not is_deep(document)
    except (ValueError, RecursionError, zlib.error):
        return None
    return document if usable and is_valid_unicode(document) else None


def _unpack(raw: bytes, encoding: str) -> bytes:
    """The body of an answer, compressed or not.

    Raises:
        ValueError: it unpacks to more than an answer has, or in a way that was not asked for.
        zlib.error: it is damaged.
    """
    if encoding in ("", "identity"):
        return raw
    if encoding not in COMPRESSED:
        raise ValueError(encoding)
    unpacker = zlib.decompressobj(zlib.MAX_WBITS | 32)  # tells gzip from deflate
    content = unpacker.decompress(raw, LARGEST_ANSWER)
    if not unpacker.eof:
        raise ValueError(encoding)
    return content


def _causes(error: BaseException | None) -> Iterator[BaseException]:
    while error is not None:
        yield error
        error = error.__cause__ or error.__context__
