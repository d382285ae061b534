"""The page that is there before the station: it says how far it is, and gives way."""

import socket
import threading
from collections.abc import AsyncIterator, Callable, Iterator
from contextlib import asynccontextmanager, contextmanager, suppress
from pathlib import Path

import httpx
import pytest
from starlette.applications import Starlette
from starlette.responses import PlainTextResponse
from starlette.routing import Route
from websockets.exceptions import InvalidStatus
from websockets.sync.client import connect

from crenel.api import static_files
from crenel.errors import OperationError
from crenel.server.listener import LOCAL, make_server
from crenel.server.starting_page import StartingApp, StartStep
from crenel.settings.settings import Serving
from tests.api.conftest import PATIENCE_S, code_of, until

pytestmark = pytest.mark.device


class Station:
    """An application that notes when it is opened and closed."""

    def __init__(self) -> None:
        self.noted: list[str] = []

    def build(self) -> Starlette:
        @asynccontextmanager
        async def lifespan(app: Starlette) -> AsyncIterator[None]:
            self.noted.append("opened")
            yield
            self.noted.append("closed")

        def answer(request: object) -> PlainTextResponse:
            return PlainTextResponse("the station")

        return Starlette(routes=[Route("/{path:path}", answer)], lifespan=lifespan)


def starting_with(work: Callable[[], object], station: Station) -> StartingApp:
    return StartingApp("", [StartStep("Devices", 1.0, work)], StartStep("Data", 1.0, station.build))


@contextmanager
def served(
    starting: StartingApp, serving: Serving = LOCAL
) -> Iterator[tuple[httpx.Client, Callable[[], None]]]:
    """A client of it, and what ends its server and waits for that."""
    with socket.socket() as listening:
        listening.bind(("127.0.0.1", 0))
        listening.listen()
        server = make_server(starting, serving)

        def end() -> None:
            server.should_exit = True
            thread.join(PATIENCE_S)
            assert not thread.is_alive()

        starting.on_failed = lambda: setattr(server, "should_exit", True)
        thread = threading.Thread(target=server.run, kwargs={"sockets": [listening]})
        thread.start()
        address = f"http://127.0.0.1:{listening.getsockname()[1]}"
        try:
            with httpx.Client(base_url=address, timeout=PATIENCE_S) as http:
                yield http, end
        finally:
            end()


def test_it_says_how_far_its_start_is(monkeypatch: pytest.MonkeyPatch, tmp_path: Path) -> None:
    (tmp_path / "starting.html").write_text("<title>Starting</title>")
    (tmp_path / "assets").mkdir()
    (tmp_path / "assets" / "starting.js").write_text("export {}")
    (tmp_path.parent / "outside.txt").write_text("secret")
    monkeypatch.setattr(static_files, "STATIC", tmp_path)
    gate, station = threading.Event(), Station()
    steps = [StartStep("Numerics", 1.0, lambda: None), StartStep("Devices", 2.0, gate.wait)]
    starting = StartingApp("Room 2", steps, StartStep("Data folder", 1.0, station.build))
    with served(starting) as (http, _):
        until(lambda: http.get("/api/starting").json()["done"] == 1)
        state = http.get("/api/starting").json()
        assert state.pop("steps") == ["Numerics", "Devices", "Data folder"]
        assert state == {
            "ready": False,
            "failed": False,
            "station": "Room 2",
            "done": 1,
            "share": 0.25,
        }
        for path in ("/", "/calibrate"):
            page = http.get(path)
            assert (page.status_code, page.text) == (200, "<title>Starting</title>")
            assert page.headers["cache-control"] == "no-store"
            assert "frame-ancestors 'self'" in page.headers["content-security-policy"]
        assert http.get("/assets/starting.js").status_code == 200
        for path in ("/assets/gone.js", "/..%2foutside.txt"):
            assert http.get(path).status_code == 404
        other = "GET /api/session, POST /api/session/code, GET /viewer, GET /metrics, POST /"
        for request in other.split(", "):
            answer = http.request(*request.split())
            assert code_of(answer) == (503, "starting")
            assert answer.headers["retry-after"] == "1"
        assert http.get("/", headers={"host": "evil.example"}).status_code == 403
        live = str(http.base_url).replace("http", "ws") + "/api/live"
        with pytest.raises(InvalidStatus), connect(live):
            pass
        assert station.noted == []
        gate.set()
        until(lambda: http.get("/").text == "the station")
        assert station.noted == ["opened"]
    assert station.noted == ["opened", "closed"]


def test_nobody_is_turned_away_while_it_gives_way() -> None:
    """New connections and kept ones, asking all the time: each question has its answer."""
    gate, station = threading.Event(), Station()
    starting = starting_with(gate.wait, station)
    answers: list[int] = []
    stop = threading.Event()

    def ask(address: httpx.URL, kept: bool) -> None:
        with httpx.Client(base_url=address, timeout=PATIENCE_S) as own:
            while not stop.is_set():
                closing = {} if kept else {"connection": "close"}
                answers.append(own.get("/api/session", headers=closing).status_code)

    with served(starting) as (http, _):
        kinds = (True, False) * 2
        askers = [threading.Thread(target=ask, args=(http.base_url, kept)) for kept in kinds]
        for asker in askers:
            asker.start()
        until(lambda: answers.count(503) > 50)
        gate.set()
        until(lambda: answers.count(200) > 50)
        stop.set()
        for asker in askers:
            asker.join(PATIENCE_S)
    assert set(answers) == {503, 200}


def test_a_step_that_is_refused_ends_the_server_once_open_pages_know() -> None:
    gate, station = threading.Event(), Station()

    def refuse() -> None:
        gate.wait()
        raise OperationError("driver", "There is no driver")

    starting = starting_with(refuse, station)
    with served(starting) as (http, _):
        assert not http.get("/api/starting").json()["failed"]
        gate.set()
        until(lambda: http.get("/api/starting").json()["failed"])
    assert isinstance(starting.failure, OperationError)
    assert station.noted == []


def test_a_start_can_be_ended_while_a_step_hangs() -> None:
    gate, station = threading.Event(), Station()
    starting = starting_with(gate.wait, station)
    with served(starting) as (http, end):
        until(lambda: http.get("/api/starting").status_code == 200)
        end()
        with suppress(httpx.TransportError):
            assert http.get("/api/starting").status_code == 503
    gate.set()
    assert starting.failure is None
    assert station.noted == []
