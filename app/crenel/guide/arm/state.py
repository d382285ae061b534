"""The state of an arm session, a fold over its journal, and the station beside it. Pure."""

import re
from collections.abc import Callable, Mapping
from dataclasses import dataclass, replace
from typing import Any, Literal

from crenel.guide.common.datasheet_library import DatasheetLibrary
from crenel.guide.common.journal import SIMULATION_NOTES, JournalEntry
from crenel.guide.common.rules import SessionLive
from crenel.messages.message import Text, Value, message
from crenel.metrology.arm.kinematics import Arm
from crenel.station.devices.link_state import DeviceState

Purpose = Literal["check", "tip", "identify"]
Kind = Literal["seat", "bar", "sphere"]
Payload = Mapping[str, Any]
Angles = tuple[float, ...]

POINTS = "points"
"""Points come by themselves while the arm swings: they make no view stale."""


@dataclass(frozen=True)
class Artefact:
    """What the tip measures: a seat, an end of a ball bar, or a sphere touched from outside.

    ``size_mm`` is the length of the bar or the diameter of the sphere, from its certificate.
    """

    kind: Kind = "seat"
    size_mm: float | None = None
    standard_uncertainty_mm: float = 0.0


_NAME = re.compile(r"\w+ (\d+)(?:, end ([AB]))?")


def place_name(kind: Kind, number: int, end: str = "") -> str:
    """What a place is called in the journal and in the session's tables."""
    if kind == "bar":
        return f"Bar {number}, end {end}"
    return f"Sphere {number}" if kind == "sphere" else f"Seat {number}"


@dataclass(frozen=True)
class SeatSamples:
    """One seat, end of a bar, or sphere, and the points taken there."""

    name: str
    """Its ``place_name``."""
    q_rad: tuple[Angles, ...] = ()
    artefact: Artefact = Artefact()

    @property
    def title(self) -> Text:
        """The place for people, by itself."""
        values = self._values()
        return message("arm-place-title", **values) if values else self.name

    @property
    def place(self) -> Text:
        """The same within a sentence."""
        values = self._values()
        return message("arm-place-name", **values) if values else self.name

    def _values(self) -> dict[str, Value]:
        """What the name consists of; nothing of a name that is none of ``place_name``."""
        named = _NAME.fullmatch(self.name)
        if named is None:
            return {}
        return {"kind": self.artefact.kind, "number": int(named[1]), "end": named[2] or ""}


@dataclass(frozen=True)
class ArmState:
    """Where an arm session stands."""

    session_id: str = ""
    rev: int = 0
    """Number of the last row that was more than points."""
    purpose: Purpose = "check"
    arm: str = ""
    """Which of the station's arms, by the id of its file."""
    limit_um: float | None = None
    """Largest (max - min)/2 along any axis that the operator accepts."""
    artefact: Artefact = Artefact()
    """What comes next."""
    seats: tuple[SeatSamples, ...] = ()
    coordinates: int = 0
    """Points that a tracker or measuring machine measured, of the file taken last."""
    swinging: bool = False
    """Whether points are being taken in the last seat."""
    checked: Payload | None = None
    solved: Payload | None = None
    refused: Payload | None = None
    saved: str = ""
    """Name of the arm's file while the identified arm is in use."""
    replaced: str = ""
    """Name that the file of the arm before is kept by."""
    ended: bool = False

    @property
    def has_points(self) -> bool:
        """Whether anything was taken with the arm that was chosen."""
        return bool(self.seats) or self.coordinates > 0

    @property
    def touching(self) -> bool:
        """Whether a sphere is being touched: its points are taken by the button."""
        return self.swinging and self.seats[-1].artefact.kind == "sphere"

    @property
    def bar_ends(self) -> int:
        """Ends of the ball bar that were taken, in pairs; the last may lack its other end."""
        return sum(seat.artefact.kind == "bar" for seat in self.seats)

    @property
    def half_bar(self) -> bool:
        """Whether one end of the bar waits for the other."""
        return self.bar_ends % 2 == 1

    @property
    def step(self) -> str:
        """seat, swing or result."""
        if self.swinging:
            return "swing"
        done = self.checked is not None or self.solved is not None
        return "result" if done else "seat"


@dataclass(frozen=True)
class ArmLive(SessionLive):
    """The station as the arm session sees it."""

    library: DatasheetLibrary
    arm: Arm | None
    """The chosen one's model."""
    link: DeviceState
    connected_joints: int | None
    q_rad: Angles | None
    """The newest sample."""
    left_mm: float | None
    """How far the tip is from its seat, where it has left it."""


def apply_row(state: ArmState, row: JournalEntry) -> ArmState:
    """The state after one more row of the journal.

    Raises:
        ValueError: a row of a kind that this version does not know.
    """
    if row.kind not in CHANGES:
        raise ValueError(f"row of an unknown kind: {row.kind}")
    changed = CHANGES[row.kind](state, row.payload)
    rev = state.rev if row.kind == POINTS else row.number
    return replace(changed, session_id=row.session_id, rev=rev)


def _start(state: ArmState, payload: Payload) -> ArmState:
    return _with_sphere(
        replace(state, purpose=payload["purpose"], arm=payload["arm"], limit_um=payload["limit_um"])
    )


def _with_sphere(state: ArmState) -> ArmState:
    """The tip is checked on a sphere."""
    sphere = state.purpose == "tip" and state.artefact.kind != "sphere"
    return replace(state, artefact=Artefact("sphere")) if sphere else state


def _seat_begun(state: ArmState, payload: Payload) -> ArmState:
    taken = SeatSamples(payload["name"], artefact=Artefact(**payload.get("artefact", {})))
    return replace(state, seats=(*state.seats, taken), swinging=True)


def _points(state: ArmState, payload: Payload) -> ArmState:
    *before, last = state.seats
    taken = (*last.q_rad, *(tuple(q) for q in payload["q_rad"]))
    return replace(state, seats=(*before, replace(last, q_rad=taken)))


def _seat_dropped(state: ArmState, payload: Payload) -> ArmState:
    seats = tuple(seat for seat in state.seats if seat.name != payload["name"])
    return replace(state, seats=seats, swinging=False, solved=None, refused=None)


CHANGES: dict[str, Callable[[ArmState, Payload], ArmState]] = {
    "started": _start,
    "arm_chosen": lambda state, payload: replace(state, arm=payload["id"]),
    "artefact_chosen": lambda state, payload: replace(state, artefact=Artefact(**payload)),
    "limit_set": lambda state, payload: replace(state, limit_um=payload["limit_um"]),
    "seat_begun": _seat_begun,
    POINTS: _points,
    "seat_ended": lambda state, payload: replace(state, swinging=False, solved=None, refused=None),
    "seat_dropped": _seat_dropped,
    "coordinates_taken": lambda state, payload: replace(
        state, coordinates=payload["points"], solved=None, refused=None
    ),
    "coordinates_dropped": lambda state, payload: replace(
        state, coordinates=0, solved=None, refused=None
    ),
    "checked": lambda state, payload: replace(state, checked=payload),
    "tip_checked": lambda state, payload: replace(state, checked=payload),
    "solved": lambda state, payload: replace(state, solved=payload, refused=None),
    "fit_refused": lambda state, payload: replace(state, refused=payload, solved=None),
    "reopened": lambda state, payload: replace(state, solved=None),
    "saved": lambda state, payload: replace(
        state, saved=payload["name"], replaced=payload["replaced"]
    ),
    "restored": lambda state, payload: replace(state, saved="", replaced=""),
    **dict.fromkeys(SIMULATION_NOTES, lambda state, payload: state),
    "ended": lambda state, payload: replace(state, ended=True, swinging=False),
}
