"""A visit to a page: what goes wrong in it, what it looks like, and how far the station is."""

import time
from collections.abc import Callable
from pathlib import Path
from typing import Any

from playwright.sync_api import ConsoleMessage, Page

from tests.e2e.conftest import PATIENCE_S
from tests.sent_texts import english

SCREENSHOT_MS = 120_000
"""The 3D view is drawn without a graphics processor."""
SETTLING_MS = 500
"""Before a screenshot."""
FEW_PICTURES = """
if (location.pathname.includes("/viewer/")) {
  const draw = window.requestAnimationFrame.bind(window);
  window.requestAnimationFrame = (callback) => setTimeout(() => draw(callback), 500);
  window.cancelAnimationFrame = clearTimeout;
}
"""
"""The 3D view draws two pictures a second, so that it leaves the processor to the station."""

ASK = "path => fetch(path).then(answer => (answer.ok ? answer.json() : null))"


class Visit:
    """A page that keeps what went wrong in it, and takes numbered screenshots if there is a folder
    for them."""

    def __init__(self, page: Page, screenshots: Path | None = None, sub_path: str = "") -> None:
        self.page = page
        self.screenshots = screenshots
        self.sub_path = sub_path
        self.taken = 0
        self.faults: list[str] = []
        page.add_init_script(FEW_PICTURES)
        page.on("console", self._console)
        page.on("pageerror", lambda error: self.faults.append(str(error)))

    def _console(self, message: ConsoleMessage) -> None:
        if message.type == "error":
            self.faults.append(f"{message.text} ({message.location.get('url')})")

    def look(self, name: str) -> None:
        """Takes a screenshot, for people to look at."""
        if self.screenshots is None:
            return
        self.page.wait_for_timeout(SETTLING_MS)
        self.taken += 1
        path = self.screenshots / f"{self.taken:02d}-{name}.png"
        self.page.screenshot(path=path, timeout=SCREENSHOT_MS)

    def ask(self, path: str) -> Any:
        """What the server answers to the page's own question, once it lets it ask."""
        end = time.monotonic() + PATIENCE_S
        while (answer := self.page.evaluate(ASK, self.sub_path + path)) is None:
            assert time.monotonic() < end, f"{path} is not answered"
            self.page.wait_for_timeout(300)
        return answer

    def wait_until(self, what: str, path: str, done: Callable[[dict[str, Any]], bool]) -> None:
        """Asks until the answer satisfies; the page goes on meanwhile."""
        last = self.ask(path)
        end = time.monotonic() + PATIENCE_S
        while not done(last):
            assert time.monotonic() < end, f"{what}: still {last}"
            self.page.wait_for_timeout(300)
            last = self.ask(path)


def is_at(step: str, view: dict[str, Any]) -> bool:
    return view["step"] == step and view["busy"] is None and not lost_devices(view)


def is_verifying(step: str, view: dict[str, Any]) -> bool:
    return view["running"] is True and is_at(step, view)


def lost_devices(view: dict[str, Any]) -> bool:
    return any("Connecting" in english(finding["text"]) for finding in view["findings"])


def take_poses(visit: Visit) -> None:
    """The simulated operator takes pose after pose as advised, until the result is there."""
    poses: set[int] = set()
    for _ in range(30):
        visit.wait_until("the simulated operator", "/api/flow", lambda view: view["busy"] is None)
        view = visit.ask("/api/flow")
        if view["step"] == "review":
            assert len(view["picture"]["poses"]) >= 3
            return
        if view["step"] == "capture":
            poses.add(view["rev"])
            assert view["picture"]["target"]
            visit.look(f"pose-{len(poses) + 1}")
        visit.page.get_by_role("button", name="Let the simulated operator do it").click()
        visit.page.wait_for_timeout(500)
    raise AssertionError("the simulated operator never came to the result")
