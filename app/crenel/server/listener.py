"""The listening socket, TLS and connection limits."""

import asyncio
import errno
import logging
import resource
import socket
import ssl
import sys
import time
import webbrowser
from typing import TypeVar

import uvicorn
from starlette.types import ASGIApp

from crenel.errors import OperationError
from crenel.formats.file_names import escape_unprintable
from crenel.formats.io_errors import convert_io_errors
from crenel.formats.open_file import read_bounded
from crenel.messages.message import Text, message
from crenel.monitoring.log_text import RepeatFilter
from crenel.monitoring.system_info import Network
from crenel.server.behind_proxy import BehindProxy
from crenel.server.connections import BoundedWebSocket, http_protocol, make_space
from crenel.settings.settings import Serving, check_root_path

LOCAL = Serving()
S = TypeVar("S", bound=Serving)
SHUTDOWN_S = 3
LARGEST_MESSAGE = 1 << 16
"""The largest of a browser's messages; all are small."""
SILENT_S = 15.0
"""A connection without requests for this long is closed."""
ACCEPTED_AT_ONCE, WAITING = 2, 4096
"""Connections accepted in one iteration of the loop, and those that the system queues in the
meantime. The number is small because everything that waits, including Stop, waits for each
iteration."""
MOST_FILES = 65536
LONGEST_LINE = 400
"""On the console."""
PORT_REMEDIES: dict[int | None, Text] = {
    errno.EADDRINUSE: message("listen-free-port"),
    errno.EACCES: message("listen-choose-higher-port"),
}
LOOPBACK = ("localhost", "127.0.0.1", "::1")
ELSEWHERE = "Other machines reach it by its address, or by a name in hosts of {file}."
NETWORK_WORDS: dict[Network, list[str]] = {
    "here": [],
    "encrypted": [ELSEWHERE],
    "proxied": [],
    "open": [
        ELSEWHERE,
        "Nothing is encrypted: anyone on the network can read passwords. Set tls_certificate "
        "and tls_key in {file}, or put a proxy in front and name it in proxies.",
    ],
}


def listen(host: str, port: int, tries: int) -> socket.socket:
    """A bound socket, on the port or one of the next ``tries - 1``."""
    family = socket.AF_INET6 if ":" in host else socket.AF_INET
    for offset in range(tries):
        listening = socket.socket(family, socket.SOCK_STREAM)
        listening.setsockopt(socket.SOL_SOCKET, socket.SO_REUSEADDR, 1)
        try:
            listening.bind((host, port + offset))
            listening.listen(128)
        except OSError as error:
            listening.close()
            reason, number = error.strerror or str(error), error.errno
            continue
        if offset:
            print(f"Port {port} is in use; using {port + offset}.", file=sys.stderr)
        return listening
    raise OperationError(
        "port",
        message("listen-failed", host=host, port=str(port)),
        reason,
        PORT_REMEDIES.get(number, message("listen-give-own-address")),
    )


def with_root_path(serving: S, root_path: str) -> S:
    """The settings with the sub-path of ``--root-path``; unchanged if it is empty.

    Raises:
        OperationError: it is no sub-path.
    """
    if not root_path:
        return serving
    checked = check_root_path(root_path, "--root-path")
    return serving.model_copy(update={"root_path": checked})


def network_exposure(host: str, serving: Serving) -> Network:
    """From where the station can be reached, and whether the traffic can be read."""
    if host in LOOPBACK:
        return "here"
    if serving.tls_certificate is not None:
        return "encrypted"
    return "proxied" if serving.proxies else "open"


def network_words(host: str, serving: Serving, file: str) -> list[str]:
    """What the console says about that; ``file`` has the settings."""
    return [line.format(file=file) for line in NETWORK_WORDS[network_exposure(host, serving)]]


def local_address(host: str, listening: socket.socket, serving: Serving) -> str:
    """Address of the station's pages for a browser on this machine."""
    shown = "127.0.0.1" if host in ("0.0.0.0", "::") else host
    bracketed = f"[{shown}]" if ":" in shown else shown
    scheme = "https" if serving.tls_certificate else "http"
    return f"{scheme}://{bracketed}:{listening.getsockname()[1]}{serving.root_path}/"


class OneLineFormatter(logging.Formatter):
    """For the console: what happened, on one line without control characters.

    The log has stacks and tracebacks.
    """

    def format(self, record: logging.LogRecord) -> str:
        plain = logging.makeLogRecord(record.__dict__)
        plain.msg, plain.args = record.getMessage().partition("\n")[0], None
        if record.exc_info and record.exc_info[1] is not None:
            error = " ".join(str(record.exc_info[1]).split())
            plain.msg += f": {type(record.exc_info[1]).__name__}: {error} (the log has more)"
        plain.msg = escape_unprintable(plain.msg[:LONGEST_LINE])
        if repeated := getattr(record, "repeated", None):
            plain.msg += f" {repeated!s}"
        plain.exc_info = plain.exc_text = plain.stack_info = None
        return super().format(plain)


def log_to_console() -> None:
    """Writes warnings and errors to the console from now on, equal ones a few times only: clients
    without an account can cause any number of them."""
    console = logging.StreamHandler()
    console.setLevel(logging.WARNING)  # the rest is in the log of the Health page
    console.setFormatter(OneLineFormatter("%(asctime)s %(name)s: %(message)s"))
    console.addFilter(RepeatFilter())
    logging.getLogger().addHandler(console)


def make_server(app: ASGIApp, serving: Serving = LOCAL) -> "StationServer":
    """The server of an application, not yet running.

    Raises:
        OperationError: certificate and key are not a pair in PEM format, or cannot be read.
    """
    _check_key(serving)
    config = uvicorn.Config(
        app,
        ssl_certfile=serving.tls_certificate,
        ssl_keyfile=serving.tls_key,
        forwarded_allow_ips=list(serving.proxies),
        log_config=None,  # its messages go to the common log
        log_level="warning",
        access_log=False,
        backlog=ACCEPTED_AT_ONCE,
        http=http_protocol(serving.proxies),
        ws=BoundedWebSocket,
        ws_per_message_deflate=False,
        ws_max_size=LARGEST_MESSAGE,
        timeout_graceful_shutdown=SHUTDOWN_S,
        server_header=False,
    )
    try:
        config.load()
    except ssl.SSLError as error:
        certificate, key = str(serving.tls_certificate), str(serving.tls_key)
        raise OperationError(
            "tls",
            message("tls-pair-unusable", certificate=certificate, key=key),
            message("tls-no-pair-reason", reason=error.reason)
            if error.reason
            else message("tls-no-pair"),
            message("tls-give-own-key"),
        ) from error
    config.loaded_app = BehindProxy(config.loaded_app, serving.root_path, serving.proxies)
    return StationServer(config)


def _check_key(serving: Serving) -> None:
    for file in (serving.tls_certificate, serving.tls_key):
        if file is None:
            continue
        with convert_io_errors(file):
            content = read_bounded(file)
        if file == serving.tls_key and b"ENCRYPTED" in content:
            raise OperationError(
                "tls",
                message("tls-key-unusable", file=file),
                message("tls-key-encrypted-nobody-to-ask"),
                message("tls-give-plain-key"),
            )


def raise_file_limit() -> None:
    """Raises the limit of open files, so that many connections do not prevent a recording from
    opening its file."""
    soft, hard = resource.getrlimit(resource.RLIMIT_NOFILE)
    wanted = MOST_FILES if hard == resource.RLIM_INFINITY else min(hard, MOST_FILES)
    if soft != resource.RLIM_INFINITY and soft < wanted:
        resource.setrlimit(resource.RLIMIT_NOFILE, (wanted, hard))


class StationServer(uvicorn.Server):
    """Announces the address when the station can be reached, and closes idle connections."""

    def __init__(self, config: uvicorn.Config) -> None:
        super().__init__(config)
        self.address = ""
        self.first_words: list[str] = []
        self.open_browser = False
        self._wordless: dict[object, tuple[object, float]] = {}
        """For each connection, its last request and the time since then."""

    async def on_tick(self, counter: int) -> bool:
        make_space(self.server_state.connections)
        if counter % 10 == 0:
            self._close_silent()
        return await super().on_tick(counter)

    def _close_silent(self) -> None:
        """Closes connections that were opened, or answered, without a complete request since."""
        now_s, before = time.monotonic(), self._wordless
        self._wordless = {}
        for connection in list(self.server_state.connections):
            cycle = getattr(connection, "cycle", None)
            asking = cycle is not None and not cycle.response_complete
            if asking or not isinstance(connection, self.config.http_protocol_class):
                continue
            asked_last, since_s = before.get(connection, (cycle, now_s))
            if asked_last is not cycle:
                since_s = now_s
            if now_s - since_s > SILENT_S:
                connection.transport.close()
            self._wordless[connection] = cycle, since_s

    async def startup(self, sockets: list[socket.socket] | None = None) -> None:
        await super().startup(sockets)
        for listening in sockets or ():
            listening.listen(WAITING)
        if self.started and self.address:
            print(f"Crenel is at {self.address} (end with Ctrl-C)", flush=True)
            for line in self.first_words:
                print(line, flush=True)
            if self.open_browser:
                await asyncio.to_thread(webbrowser.open, self.address)
