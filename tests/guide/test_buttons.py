"""What the arm's buttons mean, by how long they are held."""

import threading
from collections.abc import Iterator
from dataclasses import dataclass, field

import pytest

from crenel.guide.common import buttons
from crenel.guide.common.buttons import Buttons, Press

PATIENCE_S = 240.0


@dataclass(frozen=True)
class Edge:
    stamp_ns: int
    button: str
    pressed: bool


@dataclass
class Pressed:
    """The buttons under test, and the presses that came of them."""

    there: bool = True
    presses: list[Press] = field(default_factory=list)
    _came: threading.Semaphore = field(default_factory=lambda: threading.Semaphore(0))

    def __post_init__(self) -> None:
        self.buttons = Buttons(self._press, lambda: self.there)

    def _press(self, press: Press) -> None:
        self.presses.append(press)
        self._came.release()

    def edge(self, seconds: float, button: str, pressed: bool) -> None:
        self.buttons.edge(Edge(round(seconds * 1e9), button, pressed))

    def wait(self) -> Press:
        assert self._came.acquire(timeout=PATIENCE_S)
        return self.presses[-1]


@pytest.fixture
def pressed() -> Iterator[Pressed]:
    made = Pressed()
    yield made
    made.buttons.close()


def test_main_counts_down_and_undo_up(pressed: Pressed, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(buttons, "LONG_PRESS_S", PATIENCE_S)
    pressed.edge(1.0, "undo", True)
    pressed.edge(1.2, "undo", False)
    assert pressed.wait() == Press(1_000_000_000, "undo")
    for second, button in ((2, "primary"), (3, "back")):
        pressed.edge(second, button, True)
        press = pressed.wait()
        assert (press.stamp_ns, press.button) == (second * 10**9, button)
        pressed.edge(second + 0.1, button, False)
    pressed.edge(4.0, "primary", True)
    pressed.wait()
    assert [press.button for press in pressed.presses] == ["undo", "primary", "back", "primary"]


def test_undo_held_is_back_once(pressed: Pressed, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(buttons, "LONG_PRESS_S", 0.05)
    pressed.edge(1.0, "undo", True)
    assert pressed.wait() == Press(1_000_000_000, "back")
    pressed.edge(1.4, "undo", False)
    pressed.edge(2.0, "primary", True)
    pressed.wait()
    assert [press.button for press in pressed.presses] == ["back", "primary"]


def test_a_release_that_was_late_by_the_arms_own_clock_is_back(pressed: Pressed) -> None:
    pressed.edge(1.0, "undo", True)
    pressed.edge(2.0, "undo", False)
    assert pressed.wait().button == "back"


def test_a_pulled_cable_is_no_press(pressed: Pressed, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(buttons, "LONG_PRESS_S", 0.05)
    pressed.there = False
    pressed.edge(1.0, "undo", True)
    threading.Event().wait(0.2)
    pressed.there = True
    pressed.edge(5.0, "undo", True)
    assert pressed.wait() == Press(5_000_000_000, "back")
    assert len(pressed.presses) == 1
