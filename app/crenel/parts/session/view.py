"""What the browser is shown of a guided inspection."""

from collections.abc import Sequence
from dataclasses import dataclass
from typing import Literal

from crenel.guide.common.view import ChoiceOption, SessionView, Vec3
from crenel.messages.message import Text

Outcome = Literal["pass", "fail", "undecided", "none"]
"""The words of decisions on dimensions, as in ``results.json``."""
FeatureState = Literal["todo", "now", "done", "skipped"]


@dataclass(frozen=True)
class FeatureMark:
    """A feature of the program: how far it is, and how it is drawn."""

    id: str
    title: Text
    """Its kind, in words."""
    is_datum: bool
    state: FeatureState
    is_next: bool
    """Whether the next touch belongs to it."""
    touches: int
    least: int
    advised: int
    outcome: Outcome
    """The gravest word of its dimensions so far."""
    reason: str
    """Why it is skipped."""
    lines: Sequence[Sequence[Vec3]]
    """Outlines in the part frame, mm."""


@dataclass(frozen=True)
class TouchMark:
    """A touch of the feature in hand."""

    number: int
    """Among the touches of its feature, from 1."""
    at_mm: Vec3 | None
    """Of the tip's centre in the part frame; None before that is known."""
    residual_um: float | None


@dataclass(frozen=True)
class DimensionLine:
    """A dimension with its limits; all in its unit."""

    id: str
    title: Text
    unit: str
    nominal: float
    lower: float | None
    upper: float | None
    """Limits as deviations from the nominal."""
    value: float
    expanded: float | None
    """U, k = 2; None where only the scatter is known."""
    scatter: float | None
    """The same of the scatter, which is no uncertainty."""
    decimals: int
    decision: Outcome


@dataclass(frozen=True)
class PartResultView:
    """The result of an inspection."""

    verdict: Outcome
    text: Text
    dimensions: Sequence[DimensionLine]
    warnings: Sequence[Text]
    uncertainty_known: bool


@dataclass(frozen=True)
class PartRecordView:
    """A finished inspection, opened."""

    part: Text
    """Name and serial number."""
    ended_at: str
    operator: str
    frame: Text
    """What the part frame is known to."""
    result: PartResultView


@dataclass(frozen=True)
class PartView(SessionView):
    """The whole state of the guided inspection."""

    programs: Sequence[ChoiceOption]
    program: str
    part: Text
    """Name and serial number of the part, once the program stands."""
    serial_number: str
    operator: str
    calibration: str
    """The name of the one that is used."""
    feature: str
    """The feature in hand."""
    features: Sequence[FeatureMark]
    touches: Sequence[TouchMark]
    frame: Text
    """What the part frame is known to; empty before it is."""
    dimensions: Sequence[DimensionLine]
    """Those of the feature in hand, as far as they can be stated."""
    result: PartResultView | None
