"""Hostile certificates, messages and datasheets at a station that runs, or is started with them."""

import json
import logging
import random
import time
from collections.abc import Callable, Iterator
from contextlib import contextmanager, suppress
from pathlib import Path

import httpx
from websockets.exceptions import ConnectionClosed
from websockets.sync.client import connect

from tests.api.calibrated import use_truth
from tests.api.conftest import Server, running_server
from tests.api.test_bad_files import BAD, CERTIFICATES, CONTENTS, DOCUMENTS, FOLDERS, PAGES, TINY
from tests.bench.hostile.falling import FallenError, one_of, vary
from tests.entering import cookie
from tests.gauges.exchange.certificates import DIAMETER, certificate

AT_ONCE = 25
"""Files with which a station is started."""
LOOK_EVERY = 20
OWN = logging.getLogger("hostile")
"""Of the sender: what it cannot read is no error of the station."""
OWN.addHandler(logging.NullHandler())
OWN.propagate = False
Try = Callable[[random.Random], str]


@contextmanager
def station(folder: Path) -> Iterator[Server]:
    """A station with a calibration in use, in a folder of its own."""
    with running_server(folder / "data") as server:
        use_truth(server, "truth")
        yield server


def check_works(server: Server, since_s: float) -> None:
    """Raises ``FallenError`` if a page does not answer, or an error of the program was logged."""
    for page in PAGES:
        check_answer(server.http.get(f"/api/{page}"))
    logs = server.context.monitoring.logs
    if logs.errors_since(since_s):
        newest = logs.read("error", "", 1)[0]
        raise FallenError("logged error", f"{newest.text!s} {newest.trace[-500:]}")


def check_answer(answer: httpx.Response) -> str:
    if answer.status_code >= 500:
        raise FallenError(str(answer.status_code), f"{answer.url.path} {answer.text[:300]}")
    return "taken" if answer.status_code < 400 else "refused"


@contextmanager
def certificates(folder: Path) -> Iterator[Try]:
    """Certificates that an operator uploads; what is kept is taken away again."""
    with station(folder) as server:
        gauges, number = server.data / "gauges", 0
        before = set(gauges.iterdir())

        def attempt(rng: random.Random) -> str:
            nonlocal number
            number += 1
            began_s = time.time()
            tag, depth = rng.choice(("list", "data", "quantity", "a")), rng.randint(1, 9000)
            text = one_of(
                rng,
                {
                    "known": lambda: rng.choice(list(CERTIFICATES.values())).encode(),
                    "good": lambda: certificate(DIAMETER).encode(),
                    "deep": lambda: certificate(
                        f"<dcc:{tag}>" * depth + DIAMETER + f"</dcc:{tag}>" * depth
                    ).encode(),
                    "value": lambda: (
                        certificate(DIAMETER)
                        .replace("25", rng.choice((TINY, "1e308", "-0", "0x19", "25 25", "٢٥")))
                        .encode()
                    ),
                },
            ).decode("utf-8", "replace")
            body = {"name": f"{number}.xml", "text": text}
            answer = server.http.post("/api/performance/certificate", json=body)
            outcome = check_answer(answer)
            if outcome == "taken" or number % LOOK_EVERY == 0:
                check_works(server, began_s)
            for path in set(gauges.iterdir()) - before:
                path.unlink()
            return outcome

        yield attempt


@contextmanager
def live_messages(folder: Path) -> Iterator[Try]:
    """Messages of a browser on the live connection, a few on each."""
    with station(folder) as server:
        number = 0

        def attempt(rng: random.Random) -> str:
            nonlocal number
            number += 1
            began_s, closed = time.time(), False
            with connect(server.live, additional_headers=cookie(server.http), logger=OWN) as live:
                for _ in range(rng.randint(1, 4)):
                    with suppress(ConnectionClosed):
                        live.send(_message(rng))
                with suppress(ConnectionClosed, TimeoutError):
                    live.recv(timeout=0.05)
                    live.recv(timeout=0.05)
            code = live.close_code
            closed = code in (1003, 1007, 1008, 1009)
            if code not in (1000, 1001, 1003, 1005, 1006, 1007, 1008, 1009):
                raise FallenError("close code", str(code))
            if number % LOOK_EVERY == 0:
                check_works(server, began_s)
            else:
                check_answer(server.http.get("/api/session"))
            return "refused" if closed else "taken"

        yield attempt


def _message(rng: random.Random) -> bytes | str:
    whole: list[dict[str, object]] = [
        {"type": "preview", "on": True},
        {"type": "stations", "on": False},
        {"type": "preview_ack", "seq": rng.choice((0, -1, 1 << 70, 3))},
        {"type": "beat"},
        {"type": "beat", "more": [None] * rng.choice((1, 5000))},
    ]
    deep = rng.choice((10, 3000, 100_000))
    content = one_of(
        rng,
        {
            "whole": lambda: json.dumps(rng.choice(whole)).encode(),
            "nested": lambda: b'{"type":' * deep,
            "lists": lambda: b"[" * deep + b"]" * deep,
            "number": lambda: b'{"type": "preview_ack", "seq": ' + b"9" * deep + b"}",
            "noise": lambda: rng.randbytes(rng.randrange(300)),
        },
    )
    return content if rng.random() < 0.3 else content.decode("utf-8", "replace")


@contextmanager
def started_with(folder: Path) -> Iterator[Try]:
    """Bad files among the datasheets; with each 25 of them the station is started again."""
    data = folder / "data"
    with station(folder):
        pass
    good = {one: next((data / one).glob("*.json")).read_text() for one in FOLDERS}
    waiting: list[Path] = []

    def attempt(rng: random.Random) -> str:
        name = rng.choice(FOLDERS)
        path = data / name / f"zz-{len(waiting)}.{rng.choice(('json', 'json', 'json', 'xml'))}"
        waiting.append(path)
        if path.suffix == ".json" and rng.random() < 0.4:
            BAD[rng.choice(list(BAD))](path, json.loads(good[name]))
        else:
            path.write_bytes(
                one_of(
                    rng,
                    {
                        "good": good[name].encode,
                        "spoilt": lambda: DOCUMENTS[rng.choice(list(DOCUMENTS))](
                            json.loads(good[name])
                        ).encode("utf-8", "surrogatepass"),
                        "content": lambda: rng.choice(list(CONTENTS.values())),
                        "certificate": lambda: rng.choice(list(CERTIFICATES.values())).encode(),
                        "varied": lambda: vary(rng, good[name].encode()),
                    },
                )
            )
        if len(waiting) < AT_ONCE:
            return "taken"
        began_s = time.time()
        try:
            with running_server(data) as server:
                check_works(server, began_s)
                active = server.http.get("/api/home").json()["calibration"]["active"]
                if not active:
                    raise FallenError("calibration", "none is in use any more")
        finally:
            for one in waiting:
                one.rmdir() if one.is_dir() and not one.is_symlink() else one.unlink()
            waiting.clear()
        return "taken"

    yield attempt
