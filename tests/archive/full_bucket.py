"""A proxy in front of a real S3-compatible server whose buckets have room for so many bytes."""

import threading
from collections.abc import Iterator
from contextlib import contextmanager
from http.client import HTTPConnection
from http.server import BaseHTTPRequestHandler, ThreadingHTTPServer

ANSWERS = {
    "MinIO": (507, "XMinioStorageFull", "Storage backend has reached its minimum free threshold."),
    "Ceph": (403, "QuotaExceeded", ""),
}
"""Status, code and message by which these stores refuse what does not fit."""
HOP = {"connection", "transfer-encoding", "keep-alive"}


class FullBucket(ThreadingHTTPServer):
    """Forwards requests to a port; one for which there is no ``room`` left (bytes) is answered as
    ``store`` answers it."""

    daemon_threads = True

    def __init__(self, port: int, store: str, room: int) -> None:
        super().__init__(("127.0.0.1", 0), _Forwarder)
        self.behind, self.room = port, room
        self.answer = ANSWERS[store]
        self.refused = 0

    @property
    def port(self) -> int:
        return int(self.server_address[1])


class _Forwarder(BaseHTTPRequestHandler):
    protocol_version = "HTTP/1.1"
    server: FullBucket

    def forward(self) -> None:
        body = self.rfile.read(int(self.headers.get("Content-Length", 0)))
        if self.command == "PUT" and len(body) > self.server.room:
            self.server.refused += 1
            status, code, message = self.server.answer
            content = f"<Error><Code>{code}</Code><Message>{message}</Message></Error>".encode()
            self.reply(status, {"Content-Type": "application/xml"}, content)
            return
        if self.command == "PUT":
            self.server.room -= len(body)
        behind = HTTPConnection("127.0.0.1", self.server.behind, timeout=60)
        try:
            behind.request(self.command, self.path, body, dict(self.headers))
            answer = behind.getresponse()
            kept = {name: value for name, value in answer.getheaders() if name.lower() not in HOP}
            self.reply(answer.status, kept, answer.read())
        finally:
            behind.close()

    do_GET = do_HEAD = do_PUT = do_POST = do_DELETE = forward  # noqa: N815

    def reply(self, status: int, headers: dict[str, str], body: bytes) -> None:
        self.send_response_only(status)
        for name, value in headers.items():
            if name.lower() != "content-length" or self.command == "HEAD":
                self.send_header(name, value)
        if self.command != "HEAD":
            self.send_header("Content-Length", str(len(body)))
        self.end_headers()
        if self.command != "HEAD":
            self.wfile.write(body)

    def log_message(self, *_: object) -> None:
        """Nothing is printed."""


@contextmanager
def full_bucket(port: int, store: str, room: int) -> Iterator[FullBucket]:
    with FullBucket(port, store, room) as proxy:
        serving = threading.Thread(target=proxy.serve_forever, daemon=True)
        serving.start()
        yield proxy
        proxy.shutdown()
        serving.join()
