"""An S3-compatible server (moto, by others) in a process of its own, and a proxy that cuts its
connections."""

import contextlib
import random
import shutil
import signal
import socket
import subprocess
import sys
import threading
import time
from pathlib import Path
from types import TracebackType
from typing import Any, Self
from urllib.request import Request, urlopen

from crenel.errors import OperationError
from tests.bench.station.subprocess_station import free_port, stuck_error

STARTED_MODULES = ()  # programs of others

BINARY = shutil.which("moto_server") or shutil.which(
    "moto_server", path=str(Path(sys.executable).parent)
)
DEADLINE_S = 60.0
BUCKET = "station-archive"
PLAIN = {"Content-Type": "text/plain"}


class S3Server:
    """Runs until the block is left.

    Raises:
        OperationError: moto is not installed, or its server does not start.
    """

    def __enter__(self) -> Self:
        if BINARY is None:
            raise OperationError(
                "bench-moto",
                "This needs moto, an S3-compatible server",
                remedy="Install it with: pip install 'moto[server]'",
            )
        import boto3  # comes with moto

        self.port = free_port()
        self._process = subprocess.Popen(
            [BINARY, "-H", "127.0.0.1", "-p", f"{self.port}"],
            stdout=subprocess.DEVNULL,
            stderr=subprocess.DEVNULL,
        )
        try:
            self._wait()
        except OperationError:
            self._process.kill()
            raise
        self.client: Any = boto3.client(
            "s3",
            endpoint_url=self.url,
            aws_access_key_id="key",
            aws_secret_access_key="secret",
            region_name="us-east-1",
        )
        self.client.create_bucket(Bucket=BUCKET)
        return self

    def __exit__(
        self,
        kind: type[BaseException] | None,
        error: BaseException | None,
        trace: TracebackType | None,
    ) -> None:
        self._process.send_signal(signal.SIGTERM)
        self._process.wait(DEADLINE_S)

    @property
    def url(self) -> str:
        """Its endpoint."""
        return f"http://127.0.0.1:{self.port}"

    def check_keys(self, checks: bool) -> None:
        """Whether the server refuses keys that it does not know; at first it takes any."""
        count = b"0" if checks else b"1000000"
        address = f"{self.url}/moto-api/reset-auth"
        urlopen(Request(address, data=count, headers=PLAIN, method="POST")).close()

    def names(self, prefix: str) -> list[str]:
        """The keys of all objects that begin with the prefix, without it."""
        pages = self.client.get_paginator("list_objects_v2").paginate(Bucket=BUCKET, Prefix=prefix)
        keys = [one["Key"] for page in pages for one in page.get("Contents", ())]
        return [str(key).removeprefix(prefix) for key in keys]

    def read(self, key: str) -> bytes:
        """The content of an object."""
        return bytes(self.client.get_object(Bucket=BUCKET, Key=key)["Body"].read())

    def content(self, prefix: str) -> dict[str, bytes]:
        """All objects whose keys begin with the prefix, by the rest of their keys."""
        return {name: self.read(prefix + name) for name in self.names(prefix)}

    def _wait(self) -> None:
        deadline_s = time.monotonic() + DEADLINE_S
        while time.monotonic() < deadline_s:
            with contextlib.suppress(OSError), socket.create_connection(("127.0.0.1", self.port)):
                return
            time.sleep(0.05)
        raise stuck_error("the S3 server does not answer", DEADLINE_S)


class CuttingProxy:
    """Forwards connections; after a random number of bytes, it cuts them all and takes no more
    until ``restore``."""

    def __init__(self, port: int, seed: int) -> None:
        self._target, self._random = port, random.Random(seed)
        self._listening = socket.create_server(("127.0.0.1", 0))
        self.port: int = self._listening.getsockname()[1]
        self.cuts = 0
        self.passed_bytes = 0
        """In both directions."""
        self._left: float = 0
        self._open: set[socket.socket] = set()
        self._lock = threading.Lock()
        threading.Thread(target=self._accept, daemon=True).start()

    def restore(self, most: float) -> None:
        """Forwards again, up to a random number of bytes below ``most``; infinite: all."""
        self._left = most if most == float("inf") else self._random.uniform(0, most)

    def close(self) -> None:
        """Takes no more connections, and cuts those that are open."""
        with contextlib.suppress(OSError):
            self._listening.shutdown(socket.SHUT_RDWR)
        self._listening.close()
        self._cut()

    def _accept(self) -> None:
        with contextlib.suppress(OSError):
            while True:
                near = self._listening.accept()[0]
                if self._left <= 0:
                    near.close()
                    continue
                try:
                    far = socket.create_connection(("127.0.0.1", self._target))
                except OSError:  # the next connection may be taken again
                    near.close()
                    continue
                with self._lock:
                    self._open |= {near, far}
                for source, sink in ((near, far), (far, near)):
                    threading.Thread(target=self._pump, args=(source, sink), daemon=True).start()

    def _pump(self, source: socket.socket, sink: socket.socket) -> None:
        with contextlib.suppress(OSError):
            while piece := source.recv(1 << 16):
                self._left -= len(piece)
                self.passed_bytes += len(piece)
                if self._left <= 0:
                    self.cuts += 1
                    self._cut()
                    return
                sink.sendall(piece)
        for end in (source, sink):
            with contextlib.suppress(OSError):
                end.shutdown(socket.SHUT_RDWR)

    def _cut(self) -> None:
        with self._lock:
            for end in self._open:
                with contextlib.suppress(OSError):
                    end.shutdown(socket.SHUT_RDWR)
                end.close()
            self._open.clear()
