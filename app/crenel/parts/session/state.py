"""The state of a guided inspection: a fold over its journal. Pure."""

from collections.abc import Callable, Mapping
from dataclasses import dataclass, field, replace
from typing import ClassVar

from crenel.gauges.session.changes import Payload, apply_change, restore_touch, void_touch
from crenel.guide.common.journal import SIMULATION_NOTES, JournalEntry, reading_of

STEPS = ("setup", "align", "measure", "review")


@dataclass(frozen=True)
class PlannedFeature:
    """A feature of the program, in its order."""

    id: str
    is_datum: bool
    least: int
    advised: int


@dataclass(frozen=True)
class PartTouch:
    """One touch of a feature."""

    index: int
    feature: str
    reading: tuple[float, ...]
    """The arm's."""
    at: str
    voided: bool = False


@dataclass(frozen=True)
class PartState:
    """Where an inspection stands."""

    all_steps: ClassVar[tuple[str, ...]] = STEPS
    session_id: str = ""
    rev: int = 0
    started_at: str = ""
    calibration_id: str = ""
    step: str = "setup"
    reached: str = "setup"
    program: str = ""
    """By the name of its file in the data folder. Kept for the next inspection."""
    serial_number: str = ""
    """Of the part."""
    operator: str = ""
    features: tuple[PlannedFeature, ...] = ()
    """Empty until the set-up is confirmed."""
    feature: str = ""
    """The feature in hand: the one that is shown."""
    more: bool = False
    """Whether touches beyond the advised ones belong to the feature in hand, too."""
    touches: tuple[PartTouch, ...] = ()
    undone: tuple[int, ...] = ()
    """Touches that were taken back since the last one was taken; they can be put back."""
    skipped: Mapping[str, str] = field(default_factory=dict)
    """Features that are left out, with the reason."""
    result: str = ""
    """The verdict of the evaluation; empty until it was evaluated."""
    failed: Payload | None = None
    """Why it could not be evaluated."""
    ended: str = ""
    """accepted or abandoned; empty while the session is open."""

    @property
    def steps(self) -> tuple[str, ...]:
        """Those of this inspection: without datums nothing is aligned."""
        aligned = not self.features or any(one.is_datum for one in self.features)
        return STEPS if aligned else tuple(step for step in STEPS if step != "align")

    @property
    def counted(self) -> tuple[PartTouch, ...]:
        """Touches that count."""
        return tuple(touch for touch in self.touches if not touch.voided)

    def count(self, feature: str) -> int:
        """How often a feature is touched."""
        return sum(touch.feature == feature for touch in self.counted)

    @property
    def of_step_features(self) -> tuple[PlannedFeature, ...]:
        """The features of the step now: the datums, or all others."""
        if self.step not in ("align", "measure"):
            return ()
        return tuple(one for one in self.features if one.is_datum == (self.step == "align"))

    @property
    def of_step(self) -> tuple[PartTouch, ...]:
        """Touches of the step now."""
        names = {one.id for one in self.of_step_features}
        return tuple(touch for touch in self.counted if touch.feature in names)

    @property
    def unfinished(self) -> tuple[str, ...]:
        """Features of the step that lack their least touches, those after the one in hand first."""
        names = [one.id for one in self.of_step_features]
        start = names.index(self.feature) if self.feature in names else 0
        lacking = {
            one.id
            for one in self.of_step_features
            if self.count(one.id) < one.least and one.id not in self.skipped
        }
        return tuple(name for name in (*names[start:], *names[:start]) if name in lacking)

    @property
    def target(self) -> str:
        """The feature that the next touch belongs to; empty where none is touched."""
        planned = {one.id: one for one in self.of_step_features}
        here = planned.get(self.feature)
        if here is None:
            return next(iter(self.unfinished), "")
        if self.more or (self.count(here.id) < here.advised and here.id not in self.skipped):
            return here.id
        return next(iter(self.unfinished), here.id)


def apply_row(state: PartState, row: JournalEntry) -> PartState:
    """The state after one more row of the journal.

    Raises:
        ValueError: a row of a kind that this version does not know.
    """
    return apply_change(CHANGES, state, row)


def _start(state: PartState, payload: Payload) -> PartState:
    return PartState(
        session_id=state.session_id,
        rev=state.rev,
        started_at=payload["at"],
        calibration_id=payload["calibration_id"],
        program=payload["program"],
        operator=payload["operator"],
    )


def _set_up(state: PartState, payload: Payload) -> PartState:
    planned = tuple(
        PlannedFeature(one["id"], one["is_datum"], one["least"], one["advised"])
        for one in payload["features"]
    )
    changed = replace(state, features=planned, calibration_id=payload["calibration_id"])
    return _enter(changed, changed.steps[1])


def _enter(state: PartState, step: str) -> PartState:
    """Goes to a step, with its first unfinished feature in hand."""
    changed = replace(state, step=step, feature="", more=False, undone=(), result="", failed=None)
    names = [one.id for one in changed.of_step_features]
    return replace(changed, feature=next(iter((*changed.unfinished, *names)), ""))


def _touch(state: PartState, payload: Payload) -> PartState:
    feature = payload["feature"]
    touch = PartTouch(len(state.touches), feature, reading_of(payload), payload["at"])
    more = state.more and feature == state.feature
    touches = (*state.touches, touch)
    return replace(state, touches=touches, undone=(), feature=feature, more=more)


def _take_back(state: PartState, payload: Payload) -> PartState:
    changed = void_touch(state, payload)
    feature = state.touches[payload["index"]].feature
    return replace(changed, feature=feature, more=False)


def _put_back(state: PartState, payload: Payload) -> PartState:
    changed = restore_touch(state, payload)
    return replace(changed, feature=state.touches[payload["index"]].feature, more=False)


def _choose(state: PartState, payload: Payload) -> PartState:
    skipped = {name: why for name, why in state.skipped.items() if name != payload["id"]}
    return replace(state, feature=payload["id"], more=True, skipped=skipped)


def _go_on(state: PartState, payload: Payload) -> PartState:
    """To the next unfinished feature, although the one in hand could have more touches."""
    names = [name for name in state.unfinished if name != state.feature]
    return replace(state, feature=next(iter(names), state.feature), more=False)


def _retake(state: PartState, payload: Payload) -> PartState:
    touches = tuple(
        replace(one, voided=True) if one.feature == payload["id"] else one for one in state.touches
    )
    return replace(state, touches=touches, undone=(), feature=payload["id"], more=False)


def _skip(state: PartState, payload: Payload) -> PartState:
    skipped = {**state.skipped, payload["id"]: payload["reason"]}
    return _go_on(replace(state, skipped=skipped, feature=payload["id"]), payload)


def _confirm(state: PartState, payload: Payload) -> PartState:
    return _enter(state, state.steps[state.steps.index(state.step) + 1])


CHANGES: dict[str, Callable[[PartState, Payload], PartState]] = {
    "started": _start,
    "program_chosen": lambda state, payload: replace(state, program=payload["id"]),
    "part_named": lambda state, payload: replace(
        state, serial_number=payload["serial_number"], operator=payload["operator"]
    ),
    "set_up": _set_up,
    "touched": _touch,
    "touch_voided": _take_back,
    "touch_restored": _put_back,
    "feature_chosen": _choose,
    "went_on": _go_on,
    "feature_retaken": _retake,
    "feature_skipped": _skip,
    "step_confirmed": _confirm,
    "went_back": lambda state, payload: _enter(state, payload["to"]),
    "evaluated": lambda state, payload: replace(state, result=payload["result"], failed=None),
    "evaluation_failed": lambda state, payload: replace(state, failed=payload["refused"]),
    **dict.fromkeys(SIMULATION_NOTES, lambda state, payload: state),
    "accepted": lambda state, payload: replace(state, ended="accepted"),
    "abandoned": lambda state, payload: replace(state, ended="abandoned"),
}
