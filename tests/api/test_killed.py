"""A server that is killed twenty times on the way through a calibration and a verification."""

import contextlib
import os
import signal
import time
import uuid
from collections.abc import Callable, Iterator
from dataclasses import dataclass
from pathlib import Path
from typing import Any

import httpx
import pytest

from tests.api.processes import PATIENCE_S, demonstration

PLACES = {
    "flow": (
        *(("devices", 0), ("setup", 0), ("touch", 0), ("touch", 1), ("touch", 5), ("touch", 12)),
        *(("touch", 20), ("touch", 26), ("place", 0), ("capture", 0), ("solve", 0), ("review", 0)),
    ),
    "verify": (
        *(("gauge", 0), ("touch", 0), ("touch", 2), ("touch", 5)),
        *(("scan", 0), ("scan", 1), ("scan", 2), ("review", 0)),
    ),
}
"""The steps in which it is killed, and after how many points, pictures or clouds."""
View = dict[str, Any]


@dataclass
class Run:
    """A server from its start until it is killed."""

    http: httpx.Client
    pid: int

    def view(self, flow: str) -> View:
        return dict(self.http.get(f"/api/{flow}").json())

    def ask(self, flow: str, name: str, **args: object) -> bool:
        """Gives a command on the present view; whether it was done."""
        rev = self.view(flow)["rev"]
        body = {"name": name, "args": args, "rev": rev, "key": uuid.uuid4().hex}
        return self.http.post(f"/api/{flow}/command", json=body).status_code == 200

    def command(self, flow: str, name: str, **args: object) -> None:
        """A command that must be done; a device that has just come back may be late for it."""
        deadline = time.monotonic() + PATIENCE_S
        while not self.ask(flow, name, **args):
            assert time.monotonic() < deadline, (name, self.view(flow)["findings"])
            time.sleep(0.05)

    def watch(self, flow: str, enough: Callable[[View], bool]) -> View:
        deadline = time.monotonic() + PATIENCE_S
        while not enough(view := self.view(flow)):
            assert time.monotonic() < deadline, (view["step"], view["busy"], view["findings"])
            time.sleep(0.03)
        return view

    def kill(self) -> None:
        os.kill(self.pid, signal.SIGKILL)


@contextlib.contextmanager
def running(data: Path, flow: str) -> Iterator[Run]:
    with demonstration(data, calibrated=flow == "verify") as (http, pid):
        yield Run(http, pid)


def taken(view: View) -> set[Any]:
    """What an operator has done in this step, as the page shows it."""
    picture, step = view["picture"], view["step"]
    if step == "touch":
        return {
            (point.get("face"), point["index"])
            for point in picture.get("points") or picture.get("touches") or []
        }
    return {c["number"] for c in picture.get("clouds", []) if c["state"] == "good"}


def reached(view: View, step: str, count: int) -> bool:
    order = [each["id"] for each in view["steps"]]
    return (order.index(view["step"]), len(taken(view))) >= (order.index(step), count)


@pytest.mark.parametrize("flow", PLACES)
@pytest.mark.timeout(900)
def test_kills_in_every_step_lose_nothing(tmp_path: Path, flow: str) -> None:
    """Twenty in both flows together."""
    before: View | None = None
    for step, count in PLACES[flow]:
        with running(tmp_path, flow) as run:
            if before is None:
                begin(run, flow)
            else:
                assert_resumed(before, run.view(flow))
            before = go_on(run, flow, step, count)
            run.kill()
    with running(tmp_path, flow) as run:
        assert before is not None
        assert_resumed(before, run.view(flow))


def begin(run: Run, flow: str) -> None:
    run.http.post(f"/api/{flow}/start").raise_for_status()
    if flow == "verify":
        run.command(flow, "choose_gauge", id="plate")


def go_on(run: Run, flow: str, step: str, count: int) -> View:
    """Until so much is done in a step: by the operator in the first ones, then by the hand."""
    if step == "setup":
        run.command(flow, "confirm_devices")

    def there(view: View) -> bool:
        """So far by the hand, which rests where something was declined until it is let again."""
        done = reached(view, step, count)
        if not done and view["busy"] is None and step != "setup":
            run.ask(flow, "let_hand", all=True)
        return done

    return run.watch(flow, there)


def assert_resumed(before: View, after: View) -> None:
    """Nothing that was shown is lost, and the flow goes on where it was."""
    assert after["session_id"] == before["session_id"]
    assert after["running"]
    order = [step["id"] for step in after["steps"]]
    # what the hand did between the last look and the kill may have ended the step
    assert order.index(after["step"]) - order.index(before["step"]) in (0, 1)
    if after["step"] == before["step"]:
        assert taken(before) <= taken(after)
