"""The calibration session's state: a fold over its journal. Pure."""

import json
from collections.abc import Callable, Mapping
from dataclasses import dataclass, field, replace
from typing import Any

from crenel.guide.common.journal import (
    SIMULATION_NOTES,
    JournalEntry,
    RecordedError,
    error_from_payload,
    put_back,
    reading_of,
    take_back,
)
from crenel.station.devices.capture import Lighting

STEPS = ("devices", "setup", "touch", "place", "capture", "solve", "review")
FIELDS = ("arm", "object", "sensor")
DEVICE = "device"
"""The choice of the connected sensor, at a station with several."""
CAMERA = "camera"
"""The choice of a calibration whose camera and mounting are kept, so that the session adds the
laser alone; empty or missing where everything is calibrated."""

Payload = Mapping[str, Any]
"""A row's own JSON; each kind of row has the fields that its function below reads."""


@dataclass(frozen=True)
class Contact:
    """One touched point, as it was taken."""

    index: int
    face: str
    reading: tuple[float, ...]
    """The arm's: joint angles (n,) in rad, or its pose (7,)."""
    arm: str
    object: str
    """The arm and the object that were chosen then; for others the point does not count."""
    voided: bool = False


@dataclass(frozen=True)
class PoseCapture:
    """The pictures of one pose, with the arm's reading."""

    number: int
    ambient: str
    """File names within the session's folder."""
    laser: str | None
    lighting: Lighting
    reading: tuple[float, ...]
    """The arm's: joint angles (n,) in rad, or its pose (7,)."""
    width_px: int
    height_px: int
    arm: str
    object: str
    sensor: str
    outcome: Payload
    """What was found in the picture as it was taken."""
    exposure_us: float | None = None
    gone: str = ""
    """``aside``: set aside, and can be taken back; ``retaken``: another took its place."""


@dataclass(frozen=True)
class SolveResult:
    """A finished solve: which inputs it had, and what came out."""

    inputs: str
    outcome: Payload


@dataclass(frozen=True)
class AdviceRecord:
    """Which pose was advised next, for which inputs."""

    inputs: str
    advice: Payload


@dataclass(frozen=True)
class SolveFailure:
    """A solve that was declined."""

    inputs: str
    error: RecordedError


@dataclass(frozen=True)
class CalibrationState:
    """Where a calibration session stands."""

    session_id: str = ""
    rev: int = 0
    step: str = "devices"
    reached: str = "devices"
    """The furthest step so far; what lies between is stale after going back."""
    choices: Mapping[str, str] = field(default_factory=dict)
    face: str = "crest"
    contacts: tuple[Contact, ...] = ()
    undone: tuple[int, ...] = ()
    """Points that were taken back since the last one was taken; they can be put back."""
    captures: tuple[PoseCapture, ...] = ()
    advised: AdviceRecord | None = None
    solved: SolveResult | None = None
    line: Payload = field(default_factory=dict)
    """What is set of the laser's line; empty where all is automatic."""
    refused: SolveFailure | None = None
    ended: str = ""
    """accepted, abandoned or repeated; empty while the session is open."""

    @property
    def counted(self) -> tuple[Contact, ...]:
        """The points that count: not taken back, and of the chosen arm and object."""
        return tuple(
            c
            for c in self.contacts
            if not c.voided
            and c.arm == self.choices.get("arm")
            and c.object == self.choices.get("object")
        )

    @property
    def pictures(self) -> tuple[PoseCapture, ...]:
        """The pictures that count, one pose each: not set aside, and of the chosen arm,
        object and sensor."""
        return tuple(capture for capture in self.listed if not capture.gone)

    @property
    def listed(self) -> tuple[PoseCapture, ...]:
        """The pictures that count, and those set aside that could."""
        chosen = tuple(self.choices.get(name) for name in FIELDS)
        return tuple(
            c
            for c in self.captures
            if c.gone != "retaken" and (c.arm, c.object, c.sensor) == chosen
        )

    @property
    def picture(self) -> PoseCapture | None:
        """The newest of the pictures that count."""
        return self.pictures[-1] if self.pictures else None

    @property
    def inputs(self) -> str:
        """Names all that a solve now would use; equal names, equal inputs."""
        pictures = ",".join(str(picture.number) for picture in self.pictures)
        points = ",".join(str(contact.index) for contact in self.counted)
        chosen = "/".join(self.choices.get(name, "") for name in FIELDS)
        kept = f" camera {self.choices[CAMERA]}" if self.choices.get(CAMERA) else ""
        line = f" line {json.dumps(self.line, sort_keys=True)}" if self.line else ""
        return f"{chosen} points {points} pictures {pictures or '-'}{kept}{line}"

    @property
    def outcome(self) -> Payload | None:
        """What the solve left, unless an input changed since."""
        return self.solved.outcome if self.solved and self.solved.inputs == self.inputs else None

    @property
    def advice(self) -> Payload | None:
        """What was advised, unless an input changed since."""
        return self.advised.advice if self.advised and self.advised.inputs == self.inputs else None


def apply_row(state: CalibrationState, row: JournalEntry) -> CalibrationState:
    """The state after one more row of the journal.

    Raises:
        ValueError: a row of a kind that this version does not know.
    """
    changed = _apply(state, row.kind, row.payload)
    reached = max(changed.reached, changed.step, key=STEPS.index)
    return replace(changed, session_id=row.session_id, rev=row.number, reached=reached)


FORWARD = {
    "devices_confirmed": "setup",
    "setup_confirmed": "touch",
    "touch_confirmed": "place",
    "place_confirmed": "capture",
    "capture_kept": "solve",
}
ENDS = ("accepted", "abandoned", "repeated")
NOTES = ("capture_started", "solve_started", "poses_started", "poses_stopped", *SIMULATION_NOTES)
"""Rows that record what was done, and change nothing that the flow hangs on."""


def _apply(state: CalibrationState, kind: str, payload: Payload) -> CalibrationState:
    if kind in FORWARD:
        return replace(state, step=FORWARD[kind])
    if kind in ENDS:
        return replace(state, ended=kind)
    if kind in NOTES:
        return state
    if kind in CHANGES:
        return CHANGES[kind](state, payload)
    raise ValueError(f"row of an unknown kind: {kind}")


def _start(state: CalibrationState, payload: Payload) -> CalibrationState:
    return replace(state, choices=dict(payload["choices"]), step=payload["step"])


def _choose(state: CalibrationState, payload: Payload) -> CalibrationState:
    choices = {**state.choices, payload["field"]: payload["id"]}
    if payload["field"] in ("arm", "sensor", DEVICE):
        choices.pop(CAMERA, None)  # it is of the devices before
    return replace(state, choices=choices, undone=())


def _point_taken(state: CalibrationState, payload: Payload) -> CalibrationState:
    return replace(state, contacts=(*state.contacts, _contact(state, payload)), undone=())


def _point_voided(state: CalibrationState, payload: Payload) -> CalibrationState:
    index = payload["index"]
    if all(c.index != index for c in state.counted):
        return state
    contacts, undone = take_back(state.contacts, state.undone, index)
    return replace(state, contacts=contacts, undone=undone)


def _point_restored(state: CalibrationState, payload: Payload) -> CalibrationState:
    contacts, undone = put_back(state.contacts, state.undone, payload["index"])
    return replace(state, contacts=contacts, undone=undone)


def _image_captured(state: CalibrationState, payload: Payload) -> CalibrationState:
    return replace(state, captures=(*state.captures, _capture(state, payload)), step="solve")


def _retake(state: CalibrationState, payload: Payload) -> CalibrationState:
    newest = state.picture.number if state.picture else None
    return replace(_with_pose(state, newest, "retaken"), step="capture")


def _pose_voided(state: CalibrationState, payload: Payload) -> CalibrationState:
    left = _with_pose(state, payload["number"], "aside")
    return left if left.pictures else replace(left, step="place")


def _pose_restored(state: CalibrationState, payload: Payload) -> CalibrationState:
    return _with_pose(state, payload["number"], "")


def _take_new_look(state: CalibrationState, payload: Payload) -> CalibrationState:
    captures = (
        replace(c, outcome=payload["outcome"]) if c.number == payload["number"] else c
        for c in state.captures
    )
    return replace(state, captures=tuple(captures))


def _with_pose(state: CalibrationState, number: int | None, gone: str) -> CalibrationState:
    captures = (
        replace(c, gone=gone) if c.number == number and c.gone != "retaken" else c
        for c in state.captures
    )
    return replace(state, captures=tuple(captures))


def _solve_refused(state: CalibrationState, payload: Payload) -> CalibrationState:
    """The calibration of before is gone with its file."""
    step = "solve" if state.step == "review" else state.step
    failure = SolveFailure(payload["inputs"], error_from_payload(payload))
    return replace(state, refused=failure, solved=None, step=step)


def _finish_solve(state: CalibrationState, payload: Payload) -> CalibrationState:
    solved = SolveResult(payload["inputs"], payload["outcome"])
    step = "review" if solved.inputs == state.inputs else state.step
    return replace(state, solved=solved, refused=None, step=step)


CHANGES: dict[str, Callable[[CalibrationState, Payload], CalibrationState]] = {
    "started": _start,
    "chosen": _choose,
    "face_selected": lambda state, payload: replace(state, face=payload["face"]),
    "point_taken": _point_taken,
    "point_voided": _point_voided,
    "point_restored": _point_restored,
    "image_captured": _image_captured,
    "retaken": _retake,
    "pose_voided": _pose_voided,
    "pose_restored": _pose_restored,
    "line_set": lambda state, payload: replace(state, line=payload["line"]),
    "looked_again": _take_new_look,
    "another_pose": lambda state, payload: replace(state, step="place"),
    "advised": lambda state, payload: replace(state, advised=AdviceRecord(**payload)),
    "solved": _finish_solve,
    "solve_refused": _solve_refused,
    "went_back": lambda state, payload: replace(state, step=payload["to"]),
}


def _contact(state: CalibrationState, payload: Payload) -> Contact:
    return Contact(
        index=len(state.contacts),
        face=payload["face"],
        reading=reading_of(payload),
        arm=state.choices["arm"],
        object=state.choices["object"],
    )


def _capture(state: CalibrationState, payload: Payload) -> PoseCapture:
    return PoseCapture(
        number=len(state.captures) + 1,
        ambient=payload["ambient"],
        laser=payload["laser"],
        # rows of earlier versions do not name it
        lighting=payload.get("lighting") or ("pair" if payload["laser"] else "both"),
        reading=reading_of(payload),
        width_px=payload["width_px"],
        height_px=payload["height_px"],
        outcome=payload["outcome"],
        exposure_us=payload.get("exposure_us"),
        arm=state.choices["arm"],
        object=state.choices["object"],
        sensor=state.choices["sensor"],
    )
