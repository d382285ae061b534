"""Notifications by HTTP to an address that the administrator sets.

Each is one POST of a JSON ``Notice`` with the headers

    Crenel-Delivery: INSTANCE-NUMBER, the same at each try
    Crenel-Timestamp: seconds since 1970
    Crenel-Signature: sha256=HEX, where there is a secret

The signature is the HMAC-SHA256 of ``TIMESTAMP.BODY`` with the secret. An answer of 200 to 299
counts as received; after 408, 425, 429, 5xx or no answer, the delivery is repeated.
"""

import asyncio
import hashlib
import hmac
import logging
import math
import ssl
import time
from collections.abc import Callable
from pathlib import Path
from typing import Annotated
from urllib.parse import urlsplit

import httpx
from pydantic import AfterValidator, BaseModel, ConfigDict, Field, ValidationError

from crenel.errors import OperationError
from crenel.formats.atomic_write import atomic_path
from crenel.formats.io_errors import error_from_os, error_from_validation
from crenel.formats.open_file import read_bounded
from crenel.messages.message import Text, message, quantity
from crenel.supervision.notifications import Notice

log = logging.getLogger(__name__)
FILE = "notifications.json"
ANSWER_S = 10.0
PAUSES_S = (1.0, 2.0, 5.0, 15.0, 30.0, 60.0)
POLL_S = 0.2
MOST_WAITING = 100
TRIES_AT_ONCE = 4
RETRY_STATUSES = {408, 425, 429}


def check_url(url: str) -> str:
    """The address without surrounding spaces.

    Raises:
        OperationError: it is not an http or https address.
    """
    url = url.strip()
    try:
        parts = urlsplit(url)
        good = parts.scheme in ("http", "https") and bool(parts.hostname) and parts.port != 0
    except ValueError:
        good = False
    if url and not (good and url.isprintable()):
        raise OperationError(
            "webhook-url",
            message("address-none-message-can-sent"),
            message("must-begin-http-https-name-machine"),
            message("copy-whole-service-receives"),
        )
    return url


class WebhookSettings(BaseModel):
    """The notifications to send, and their address; without an address, none are sent.

    Raises:
        OperationError: the address is invalid (``check_url``).
    """

    model_config = ConfigDict(frozen=True, extra="ignore")

    url: Annotated[str, Field(max_length=500), AfterValidator(check_url)] = ""
    secret: Annotated[str, Field(max_length=200)] = ""
    done: bool = True
    fault: bool = True
    due: bool = True

    @property
    def host(self) -> str:
        """Host of the address; the rest of it may be a secret."""
        return urlsplit(self.url).hostname or ""


class WebhookStore:
    """One file in the data folder, which only its owner can read."""

    def __init__(self, folder: Path) -> None:
        self._path = folder / FILE

    def read(self) -> WebhookSettings:
        """The saved settings; none if the file is missing or unreadable, which is logged."""
        try:
            return WebhookSettings.model_validate_json(read_bounded(self._path))
        except FileNotFoundError:
            return WebhookSettings()
        except OSError as error:
            why = error_from_os(error).why
        except ValidationError as error:
            why = error_from_validation(FILE, error).why
        except OperationError as error:
            why = error.text
        log.warning(message("log-file-not-used", file=FILE, reason=why))
        return WebhookSettings()

    def save(self, settings: WebhookSettings) -> None:
        """Raises ``OperationError`` if they cannot be written to the disk."""
        with atomic_path(self._path) as part:
            part.touch(mode=0o600)
            part.write_text(settings.model_dump_json(indent=1) + "\n")


class Webhook:
    """Sends notifications on the event loop, independently of each other; adding one never waits.

    A notification that is not accepted is sent again later while the others continue.
    """

    def __init__(self, settings: WebhookSettings, pauses_s: tuple[float, ...] = PAUSES_S) -> None:
        self.settings = settings
        self._pauses_s = pauses_s
        self._offered: asyncio.Queue[Notice] = asyncio.Queue(MOST_WAITING)
        self._deliveries: list[asyncio.Task[None]] = []
        """Oldest first."""
        self._tries = asyncio.Semaphore(TRIES_AT_ONCE)
        self.sent = self.failed = 0
        """Delivered; given up."""
        self.trouble: Text = ""
        """Error of the last attempt; empty after a delivery."""
        self.on_change: Callable[[], None] = lambda: None

    @property
    def waiting(self) -> int:
        return self._offered.qsize() + len(self._deliveries)

    def offer(self, notice: Notice) -> None:
        """Sends a notification if its kind is wanted; if too many wait, the oldest is given up."""
        if not self.settings.url:
            return
        if not (notice.kind == "test" or getattr(self.settings, notice.kind)):
            return
        if self.waiting >= MOST_WAITING:
            self._give_up_oldest()
        self._offered.put_nowait(notice)

    def _give_up_oldest(self) -> None:
        if self._deliveries:
            self._deliveries.pop(0).cancel()
        else:
            self._offered.get_nowait()
        self.failed += 1

    async def run(self) -> None:
        """Runs until cancelled."""
        trusted = await asyncio.to_thread(_tls_context)
        async with (
            httpx.AsyncClient(
                timeout=ANSWER_S, trust_env=False, follow_redirects=False, verify=trusted
            ) as client,
            asyncio.TaskGroup() as group,
        ):
            while True:
                notice = await self._offered.get()
                self._deliveries.append(group.create_task(self._send(client, notice)))

    async def _send(self, client: httpx.AsyncClient, notice: Notice) -> None:
        """Delivers the notification, and counts it as sent or failed when it no longer waits."""
        delivery = asyncio.current_task()
        try:
            delivered = await self._deliver(client, notice)
        finally:
            self._deliveries = [other for other in self._deliveries if other is not delivery]
        if delivered:
            self.sent, self.trouble = self.sent + 1, ""
        else:
            self.failed += 1
            log.warning(message("log-notification-not-delivered", reason=self.trouble))
        self.on_change()

    async def _deliver(self, client: httpx.AsyncClient, notice: Notice) -> bool:
        for pause_s in (*self._pauses_s, None):
            async with self._tries:
                settings = self.settings
                if not settings.url:
                    return False
                again, self.trouble = await self._try_present(client, notice)
            if not self.trouble:
                return True
            self.on_change()
            if not again or pause_s is None:
                return False
            await self._wait_for_change(settings, pause_s)
        return False

    async def _try_present(self, client: httpx.AsyncClient, notice: Notice) -> tuple[bool, Text]:
        """One attempt; repeated if the settings are corrected in the meantime."""
        while True:
            settings = self.settings
            trying = asyncio.ensure_future(self._try(client, settings, notice))
            corrected = asyncio.ensure_future(self._wait_for_change(settings))
            try:
                await asyncio.wait((trying, corrected), return_when=asyncio.FIRST_COMPLETED)
                if trying.done():
                    return trying.result()
            finally:
                trying.cancel()
                corrected.cancel()

    async def _wait_for_change(self, settings: WebhookSettings, pause_s: float = math.inf) -> None:
        """Waits for other settings, at most for a pause."""
        until_s = time.monotonic() + pause_s
        while self.settings is settings and (left_s := until_s - time.monotonic()) > 0:
            await asyncio.sleep(min(left_s, POLL_S))

    async def _try(
        self, client: httpx.AsyncClient, settings: WebhookSettings, notice: Notice
    ) -> tuple[bool, Text]:
        """Whether another attempt may help, and the error; empty if there is none."""
        body = notice.model_dump_json().encode()
        headers = {
            "Content-Type": "application/json",
            "User-Agent": "Crenel",
            "Crenel-Delivery": f"{notice.instance}-{notice.number}",
            **signature(settings.secret, body, int(time.time())),
        }
        try:
            # only the beginning is read, however long and slow an answer is
            async with (
                asyncio.timeout(ANSWER_S),
                client.stream("POST", settings.url, content=body, headers=headers) as answer,
            ):
                status, good = answer.status_code, answer.is_success
        except (httpx.HTTPError, httpx.InvalidURL, TimeoutError, ValueError) as error:
            return True, _error_text(error)
        again = status in RETRY_STATUSES or status >= 500
        return again, "" if good else message("http-status", status=str(status))


def signature(secret: str, body: bytes, at: int) -> dict[str, str]:
    """The headers by which the receiver verifies the sender and the time."""
    headers = {"Crenel-Timestamp": str(at)}
    if secret:
        signed = hmac.new(secret.encode(), f"{at}.".encode() + body, hashlib.sha256)
        headers["Crenel-Signature"] = f"sha256={signed.hexdigest()}"
    return headers


def _tls_context() -> ssl.SSLContext:
    """The public authorities, and those that this machine trusts, such as one of the local
    network."""
    context = httpx.create_ssl_context(trust_env=False)
    context.load_default_certs()
    return context


def _error_text(error: Exception) -> Text:
    """The error without the address, which may contain a secret."""
    if isinstance(error, (httpx.TimeoutException, TimeoutError)):
        return message("no-answer-within", limit=quantity(ANSWER_S, "s"))
    if "CERTIFICATE_VERIFY_FAILED" in str(error):
        return message("certificate-not-trusted-here")
    if isinstance(error, httpx.ConnectError):
        return message("no-connection")
    return message("request-failed")
