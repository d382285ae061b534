"""What is drawn and listed of an inspection: features, touches, dimensions. Pure."""

from collections.abc import Iterable, Sequence
from typing import TYPE_CHECKING

from crenel.messages.message import Text, join, message, quantity
from crenel.parts.session.rules import PartLive
from crenel.parts.session.state import PartState
from crenel.parts.session.view import (
    DimensionLine,
    FeatureMark,
    FeatureState,
    Outcome,
    PartResultView,
    TouchMark,
)

if TYPE_CHECKING:
    from crenel.parts.document_results import DimensionResult, InspectionFile

KIND_WORDS: dict[str, Text] = {
    "plane": message("inspection-kind-plane"),
    "circle": message("inspection-kind-circle"),
    "cylinder": message("inspection-kind-cylinder"),
    "cone": message("inspection-kind-cone"),
    "sphere": message("inspection-kind-sphere"),
    "torus": message("inspection-kind-torus"),
    "slot": message("inspection-kind-slot"),
}
DIMENSION_WORDS: dict[str, Text] = {
    "diameter": message("inspection-of-diameter"),
    "width": message("inspection-of-width"),
    "length": message("inspection-of-length"),
    "half-angle": message("inspection-of-half-angle"),
    "distance": message("inspection-of-distance"),
    "angle": message("inspection-of-angle"),
    "coordinate": message("inspection-of-coordinate"),
    "position": message("inspection-of-position"),
    "flatness": message("inspection-of-flatness"),
    "roundness": message("inspection-of-roundness"),
    "cylindricity": message("inspection-of-cylindricity"),
}
VERDICTS: dict[Outcome, Text] = {
    "pass": message("inspection-verdict-pass"),
    "fail": message("inspection-verdict-fail"),
    "undecided": message("inspection-verdict-undecided"),
    "none": message("inspection-verdict-none"),
}
GRAVEST: tuple[Outcome, ...] = ("fail", "undecided", "pass", "none")
COVERAGE = 2.0
SIGNIFICANT = 2
MOST_DECIMALS = {"mm": 4, "um": 1, "deg": 4}


def gravest(outcomes: Iterable[Outcome]) -> Outcome:
    """The word that counts for all."""
    found = set(outcomes)
    return next((word for word in GRAVEST if word in found), "none")


def feature_marks(state: PartState, live: PartLive) -> list[FeatureMark]:
    """All features of the program; before the set-up those of the chosen one."""
    if live.program is None:
        return []
    planned = {one.id: one for one in state.features}
    marks = []
    for part in live.program.features:
        plan = planned.get(part.id)
        count = state.count(part.id)
        how_far: FeatureState = "todo"
        if part.id in state.skipped:
            how_far = "skipped"
        elif plan is not None and count >= plan.least:
            how_far = "done"
        if part.id == state.feature and state.step != "review" and how_far != "skipped":
            how_far = "now"
        marks.append(
            FeatureMark(
                part.id,
                KIND_WORDS[part.kind],
                plan.is_datum if plan else False,
                how_far,
                is_next=part.id == state.target,
                touches=count,
                least=plan.least if plan else 0,
                advised=plan.advised if plan else 0,
                outcome=_outcome(part.id, live),
                reason=state.skipped.get(part.id, ""),
                lines=live.outlines.get(part.id, ()),
            )
        )
    return marks


def _outcome(name: str, live: PartLive) -> Outcome:
    if live.result is not None and live.program is not None:
        features = {one.id: one.features for one in live.program.dimensions}
        own = [one for one in live.result.dimensions if name in features.get(one.id, ())]
        return gravest(one.decision for one in own)
    return gravest(one.decision for one in live.by_feature.get(name, ()))


def touch_marks(state: PartState, live: PartLive) -> list[TouchMark]:
    """The touches of the feature in hand, with what each is off."""
    marks: list[TouchMark] = []
    for number, touch in enumerate(state.counted):
        if touch.feature == state.feature:
            residual = live.found.residuals_um.get(number)
            marks.append(
                TouchMark(
                    len(marks) + 1,
                    live.tips_mm.get(touch.index),
                    None if residual is None else round(residual, 1),
                )
            )
    return marks


def dimension_lines(results: Sequence["DimensionResult"]) -> list[DimensionLine]:
    """Dimensions as they are listed, each with as many decimals as its uncertainty has."""
    return [_dimension_line(one) for one in results]


def _dimension_line(one: "DimensionResult") -> DimensionLine:
    u = one.standard_uncertainty
    spread = u if u is not None else one.scatter
    unit = "um" if one.unit in ("um", "µm") else "deg" if one.unit in ("deg", "°") else "mm"
    return DimensionLine(
        one.id,
        DIMENSION_WORDS.get(one.kind, one.kind),
        {"um": "µm", "deg": "°", "mm": "mm"}[unit],
        one.nominal,
        one.lower,
        one.upper,
        one.value,
        None if u is None else COVERAGE * u,
        None if u is not None or spread is None else COVERAGE * spread,
        _decimals(spread, MOST_DECIMALS[unit]),
        one.decision,
    )


def _decimals(spread: float | None, most: int) -> int:
    """So many that two figures of the expanded uncertainty are shown."""
    decimals = 0
    while decimals < most and (COVERAGE * (spread or 0.0)) * 10**decimals < 10 ** (SIGNIFICANT - 1):
        decimals += 1
    return decimals


def name_part(name: str, serial_number: str) -> Text:
    """A part by its name and serial number, as far as they are known."""
    number = message("serial-number", serial_number=serial_number) if serial_number else ""
    return join([one for one in (name, number) if one])


def frame_text(datums_um: float | None, far_um: float | None) -> Text:
    """What the part frame is known to, k = 1."""
    if datums_um is None or far_um is None:
        return message("inspection-frame-found")
    return message(
        "inspection-frame-known",
        datums=quantity(datums_um, "µm", 0),
        far=quantity(far_um, "µm", 0),
    )


def result_view(result: "InspectionFile") -> PartResultView:
    """The result as the browser shows it."""
    return PartResultView(
        result.verdict,
        VERDICTS[result.verdict],
        dimension_lines(result.dimensions),
        result.warnings,
        result.uncertainty == "full",
    )
