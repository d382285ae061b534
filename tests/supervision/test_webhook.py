"""Notices to a real receiver on this machine."""

import asyncio
import contextlib
import hashlib
import hmac
import json
import socket
import threading
import time
from collections.abc import Awaitable, Callable, Iterator
from http.server import BaseHTTPRequestHandler, ThreadingHTTPServer
from pathlib import Path

import pytest

from crenel.errors import OperationError
from crenel.findings import Quality
from crenel.messages.message import message
from crenel.station.bus import Event
from crenel.supervision import webhook as webhook_module
from crenel.supervision.notifications import Notice, NoticeDeduplicator, NoticeKind, notice_kind
from crenel.supervision.webhook import (
    MOST_WAITING,
    Webhook,
    WebhookSettings,
    WebhookStore,
    check_url,
)

pytestmark = pytest.mark.device

SECRET = "a secret of the webhook"
PAUSES_S = (0.02, 0.02, 0.02)


class Receiver(ThreadingHTTPServer):
    """Keeps what it is sent; answers by ``answers``, then with 204."""

    def __init__(self) -> None:
        super().__init__(("127.0.0.1", 0), _Taking)
        self.answers: list[int] = []
        self.refused: dict[int, int] = {}
        """How notices of these numbers are answered, each time."""
        self.taken: list[tuple[dict[str, str], bytes]] = []

    @property
    def url(self) -> str:
        return f"http://127.0.0.1:{self.server_address[1]}/hook?key=of-the-address"


class _Taking(BaseHTTPRequestHandler):
    def do_POST(self) -> None:
        receiver = self.server
        assert isinstance(receiver, Receiver)
        body = self.rfile.read(int(self.headers["Content-Length"]))
        receiver.taken.append((dict(self.headers), body))
        usual = receiver.answers.pop(0) if receiver.answers else 204
        self.send_response(receiver.refused.get(json.loads(body)["number"], usual))
        self.send_header("Location", "/elsewhere")
        self.send_header("Content-Length", "0")
        self.end_headers()

    def log_message(self, *_: object) -> None:
        pass


@pytest.fixture
def receiver() -> Iterator[Receiver]:
    with Receiver() as running:
        thread = threading.Thread(target=running.serve_forever, args=(0.02,))
        thread.start()
        yield running
        running.shutdown()
        thread.join()


def notice(number: int, kind: NoticeKind = "done") -> Notice:
    at, text = "2026-11-21T12:00:00Z", f"scan {number} is saved"
    return Notice(number=number, station="a", instance="i", name="A", kind=kind, at=at, text=text)


def sending(webhook: Webhook, act: Callable[[], Awaitable[None]]) -> None:
    async def run() -> None:
        running = asyncio.create_task(webhook.run())
        try:
            await asyncio.wait_for(act(), 240.0)
        finally:
            running.cancel()
            await asyncio.gather(running, return_exceptions=True)

    asyncio.run(run())


def send(webhook: Webhook, count: int, ended: Callable[[], object]) -> None:
    """Offers so many notices, numbered from 1, and waits for what comes of them."""

    async def act() -> None:
        for number in range(1, count + 1):
            webhook.offer(notice(number))
        await until(ended)

    sending(webhook, act)


async def until(ready: Callable[[], object]) -> None:
    while not ready():
        await asyncio.sleep(0.01)


def test_a_notice_arrives_signed_and_is_tried_again_until_it_does(receiver: Receiver) -> None:
    receiver.answers = [503, 429, 200]
    webhook = Webhook(WebhookSettings(url=receiver.url, secret=SECRET), PAUSES_S)
    send(webhook, 1, lambda: webhook.sent == 1)
    assert (webhook.failed, webhook.trouble) == (0, "")
    assert len(receiver.taken) == 3
    for headers, body in receiver.taken:
        signed = f"{headers['Crenel-Timestamp']}.".encode() + body
        expected = hmac.new(SECRET.encode(), signed, hashlib.sha256).hexdigest()
        assert headers["Crenel-Signature"] == f"sha256={expected}"
        assert headers["Crenel-Delivery"] == "i-1"
        assert json.loads(body)["text"] == "scan 1 is saved"
        assert SECRET.encode() not in body


@pytest.mark.parametrize(("status", "tries"), [(500, 4), (404, 1), (302, 1)])
def test_what_is_never_taken_is_given_up(receiver: Receiver, status: int, tries: int) -> None:
    receiver.refused = {1: status}
    webhook = Webhook(WebhookSettings(url=receiver.url), PAUSES_S)
    troubles: list[str] = []
    webhook.on_change = lambda: troubles.append(str(webhook.trouble))
    send(webhook, 2, lambda: webhook.sent == 1 and webhook.failed == 1)
    assert f"status {status}" in troubles
    numbers = [json.loads(body)["number"] for _, body in receiver.taken]
    assert sorted(numbers) == [1] * tries + [2]
    assert "Crenel-Signature" not in receiver.taken[0][0]


def test_an_address_where_nobody_is_holds_nobody_up() -> None:
    webhook = Webhook(WebhookSettings(url="http://127.0.0.1:9/x?key=k", secret=SECRET), (60.0,))

    async def act() -> None:
        webhook.offer(notice(0))
        await until(lambda: webhook.trouble)
        for number in range(MOST_WAITING + 20):
            webhook.offer(notice(number))
        assert (webhook.waiting, webhook.failed) == (MOST_WAITING, 21)

    sending(webhook, act)
    assert webhook.trouble == message("no-connection")


def test_a_notice_that_is_not_taken_holds_up_none_of_the_others(receiver: Receiver) -> None:
    receiver.refused = dict.fromkeys(range(1, 11), 500)
    webhook = Webhook(WebhookSettings(url=receiver.url), (60.0,))

    async def act() -> None:
        for number in range(1, 16):
            webhook.offer(notice(number))
        await until(lambda: webhook.sent == 5)
        assert (webhook.waiting, webhook.failed) == (10, 0)

    sending(webhook, act)


def test_a_try_without_an_answer_is_left_once_the_address_is_corrected(receiver: Receiver) -> None:
    with socket.create_server(("127.0.0.1", 0)) as silent:
        port = silent.getsockname()[1]
        webhook = Webhook(WebhookSettings(url=f"http://127.0.0.1:{port}/"))

        async def act() -> None:
            for number in range(1, 11):
                webhook.offer(notice(number))
            connection, _ = await asyncio.to_thread(silent.accept)
            with connection:
                webhook.settings = WebhookSettings(url=receiver.url)
                await until(lambda: webhook.sent == 10)

        sending(webhook, act)
    assert webhook.failed == 0


def test_a_corrected_address_is_tried_at_once(receiver: Receiver) -> None:
    webhook = Webhook(WebhookSettings(url="http://127.0.0.1:9/"), (60.0,))

    async def act() -> None:
        webhook.offer(notice(1))
        await until(lambda: webhook.trouble)
        webhook.settings = WebhookSettings(url=receiver.url)
        await until(lambda: webhook.sent == 1)

    sending(webhook, act)
    assert len(receiver.taken) == 1


def test_an_answer_that_never_ends_holds_nobody_up(monkeypatch: pytest.MonkeyPatch) -> None:
    """One receiver talks on for ever, the other begins to answer and never gets to the point."""
    monkeypatch.setattr(webhook_module, "ANSWER_S", 0.5)

    def drip(words: bytes, more: bytes) -> tuple[socket.socket, threading.Thread]:
        listening = socket.create_server(("127.0.0.1", 0))

        def serve() -> None:
            with contextlib.suppress(OSError):
                while True:
                    connection, _ = listening.accept()
                    with connection, contextlib.suppress(OSError):
                        connection.recv(65536)
                        connection.sendall(words)
                        while True:
                            connection.sendall(more)
                            time.sleep(0.05)

        thread = threading.Thread(target=serve, daemon=True)
        thread.start()
        return listening, thread

    for words, sent, trouble in (
        (b"HTTP/1.1 200 OK\r\n\r\n", 1, ""),
        (b"HTTP/1.1 200 OK\r\nX: ", 0, "no answer within 0 s"),
    ):
        listening, serving = drip(words, b"x" * 100)
        url = f"http://127.0.0.1:{listening.getsockname()[1]}/"
        webhook = Webhook(WebhookSettings(url=url), PAUSES_S[:1])
        send(webhook, 1, lambda webhook=webhook: webhook.sent + webhook.failed)  # type: ignore[misc]
        listening.shutdown(socket.SHUT_RDWR)
        serving.join()
        listening.close()
        assert (webhook.sent, str(webhook.trouble)) == (sent, trouble)


def test_only_what_is_wanted_is_sent() -> None:
    webhook = Webhook(WebhookSettings(url="http://127.0.0.1:9/", done=False))
    for kind in ("done", "fault", "due", "test"):
        webhook.offer(notice(1, kind))
    assert webhook.waiting == 3
    nowhere = Webhook(WebhookSettings())
    nowhere.offer(notice(1))
    assert nowhere.waiting == 0


def test_the_settings_are_for_the_owner_alone(tmp_path: Path) -> None:
    store = WebhookStore(tmp_path)
    assert store.read() == WebhookSettings()
    settings = WebhookSettings(url="https://x.example/", secret=SECRET, due=False)
    store.save(settings)
    assert store.read() == settings
    (file,) = tmp_path.iterdir()
    assert file.stat().st_mode & 0o077 == 0
    strange_secret = '{"url": "http://x/", "secret": "\\ud800"}'
    for wrong in ("{", '{"url": "http://["}', '{"url": 7}', strange_secret):
        file.write_text(wrong)
        assert store.read() == WebhookSettings()


def test_addresses() -> None:
    assert check_url(" https://x.example/a?b ") == "https://x.example/a?b"
    assert check_url("") == ""
    for wrong in ("ftp://x/", "x.example", "http://", "javascript:1", "http://[::1", "http://x\0/"):
        with pytest.raises(OperationError):
            check_url(wrong)
        with pytest.raises(OperationError):
            WebhookSettings(url=wrong)


def test_what_is_notified_to_those_away() -> None:
    def kind(kind: str, quality: Quality) -> str | None:
        return notice_kind(Event(1, kind, quality, ""))

    assert kind("scan-saved", "good") == "done"
    assert kind("accepted", "good") == "done"
    assert kind("arm-lost", "bad") == "fault"
    assert kind("refused", "bad") is None
    assert kind("point_taken", "good") is None
    now_s = 0.0
    repeats = NoticeDeduplicator(lambda: now_s)
    assert repeats.is_new("fault", "the arm is lost")
    assert not repeats.is_new("fault", "the arm is lost")
    assert repeats.is_new("fault", "the camera is lost")
    now_s = 61.0
    assert repeats.is_new("fault", "the arm is lost")
