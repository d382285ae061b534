"""The state of a performance test: a fold over its journal. Pure."""

from collections.abc import Callable, Mapping
from dataclasses import dataclass, field, replace
from typing import Any

from crenel.gauges.contact.guide_sequence import features_of, next_feature
from crenel.gauges.length.guide_passes import next_pass, whole_place
from crenel.gauges.length.guide_sequence import LengthEnd, LengthSequence
from crenel.gauges.plan.document import ARTICULATIONS, ORIENTATIONS, Kind, sphere_feature
from crenel.gauges.plan.maths_temperature import (
    MeanTemperature,
    TemperatureSpan,
    mean_temperature,
)
from crenel.gauges.session.changes import Payload, apply_change, restore_touch, void_touch
from crenel.gauges.session.entries import (
    NOT_MEASURED,
    AnyScan,
    BarPass,
    BarScan,
    DatasheetLimit,
    PlateScan,
    SphereContact,
    SphereScan,
    Temperatures,
    add_scan,
    scan_from_row,
    values_from_row,
)
from crenel.guide.common.journal import SIMULATION_NOTES, JournalEntry, reading_of

CONTACT_STEPS = ("diameter", "seats", "bar")
STEPS = (
    *("artefact", "pattern", "location", "scan", "end", "lengths", "plate"),
    *CONTACT_STEPS,
    *("temperatures", "review"),
)
TEST_STEPS: Mapping[Kind, tuple[str, ...]] = {
    "sphere": ("artefact", "pattern", "location", "scan", "end", "temperatures", "review"),
    "lengths": ("artefact", "lengths", "temperatures", "review"),
    "plane": ("artefact", "plate", "temperatures", "review"),
    "contact": ("artefact", *CONTACT_STEPS, "temperatures", "review"),
}
BY_TOUCH: tuple[Kind, ...] = ("lengths", "contact")
"""Tests that can be done without a calibrated sensor."""
TOUCHING = ("pattern", "location", "end", "lengths", *CONTACT_STEPS)
"""Steps in which places are touched."""
SCANNING = ("scan", "plate")
"""Steps in which only scans are made."""


@dataclass(frozen=True)
class PerformanceState:
    """Where a performance test stands."""

    session_id: str = ""
    rev: int = 0
    test: Kind = "sphere"
    started_at: str = ""
    calibration_id: str = ""
    """Empty if a test by touch is done without one."""
    arm: str = ""
    """Without a calibration: of the data folder's arms, by the name of its file."""
    step: str = "artefact"
    reached: str = "artefact"
    gauge: str = ""
    """The gauge of the data folder, by the name of its file; in a contact test the sphere, empty if
    it is done without one."""
    bar: str = ""
    """The bar of the contact test; empty if it is done without one."""
    positions: int = 1
    position: int = 1
    by_scan: bool = False
    """Whether the lengths of a ball bar are measured by scan, too."""
    sequence: LengthSequence | None = None
    """The touches of a length test, from the choice of the standard on."""
    confirmed: int = 0
    """Touches of lengths that are confirmed: they are not taken back any more."""
    limits: Mapping[str, DatasheetLimit] = field(default_factory=dict)
    """Maximum permissible errors by the quantity."""
    at_begin: Temperatures = NOT_MEASURED
    at_end: Temperatures | None = None
    """None until they are set or confirmed at the end."""
    expanded_c: float = 0.0
    """Uncertainty of the artefact's temperature, k = 2."""
    plan_sha256: str = ""
    """The hash of the plan's file, from the first touch on."""
    setup: Payload = field(default_factory=dict)
    """The station's settings of scans at the first touch."""
    touches: tuple[SphereContact, ...] = ()
    undone: tuple[int, ...] = ()
    """Touches that were taken back since the last one was taken; they can be put back."""
    scans: tuple[AnyScan, ...] = ()
    result: str = ""
    """The result of the evaluation; empty until it was evaluated."""
    failed: Payload | None = None
    """Why it could not be evaluated."""
    ended: str = ""
    """accepted or abandoned; empty while the session is open."""

    @property
    def frozen(self) -> bool:
        """Whether the plan stands."""
        return bool(self.plan_sha256)

    @property
    def steps(self) -> tuple[str, ...]:
        """The steps of this test; the contact test has none for an artefact that it is done
        without."""
        steps = TEST_STEPS[self.test]
        if self.test != "contact":
            return steps
        left_out = {"diameter": not self.gauge, "bar": not self.bar}
        return tuple(step for step in steps if not left_out.get(step, False))

    @property
    def temperatures(self) -> Temperatures:
        """Those that are asked for now: at the end, first those of the beginning."""
        return self.at_begin if self.step == "artefact" else self.at_end or self.at_begin

    @property
    def artefact(self) -> MeanTemperature | None:
        """The temperature of the artefact, as far as it is known; None: not measured."""
        end_c = None if self.at_end is None else self.at_end.artefact_c
        return mean_temperature(
            TemperatureSpan(self.at_begin.artefact_c, end_c), self.expanded_c / 2
        )

    @property
    def counted(self) -> tuple[SphereContact, ...]:
        """Touches that count."""
        return tuple(touch for touch in self.touches if not touch.voided)

    @property
    def articulation(self) -> int:
        """The one that is touched or scanned now, from 1; 0 once all are done."""
        for number in range(1, ARTICULATIONS + 1):
            if self.step == "location":
                done = len(self.of(sphere_feature(self.position, "location", number))) >= 5
            else:
                done = self.scan_of(number) is not None
            if not done:
                return number
        return 0

    @property
    def end(self) -> LengthEnd | None:
        """The end of a length that is touched next; None without any, and while a scan is due."""
        if self.step != "lengths" or self.sequence is None or self.due is not None:
            return None
        return self.sequence.end_at(len(self.counted))

    @property
    def whole_place(self) -> int:
        """The place of a bar that was touched last, if it has all its touches; else 0."""
        if self.step != "lengths" or self.sequence is None:
            return 0
        return whole_place(self.sequence, len(self.counted))

    @property
    def due(self) -> BarPass | None:
        """The scan of a bar that is to be made next in its present place; None without any."""
        if self.sequence is None or not self.sequence.by_scan or not self.whole_place:
            return None
        return next_pass(self.whole_place, self.bar_scans)

    @property
    def place(self) -> int:
        """The place of a length standard now, from 1; 0 without any, and once all is done."""
        if self.due is not None:
            return self.due.place
        return 0 if self.end is None else self.end.place

    @property
    def in_scan(self) -> bool:
        """Whether scans are made now, not touches."""
        return self.step in SCANNING or self.due is not None

    @property
    def feature(self) -> str:
        """The part of the test that is touched now; empty while none is."""
        if self.step == "lengths":
            return self.end.feature if self.end is not None else ""
        if self.step in CONTACT_STEPS:
            return next_feature(self.step, len(self.of_step))
        if self.step == "location" and self.articulation:
            return sphere_feature(self.position, "location", self.articulation)
        if self.step == "pattern":
            return sphere_feature(self.position, "pattern")
        return sphere_feature(self.position, "end") if self.step == "end" else ""

    @property
    def of_step(self) -> tuple[SphereContact, ...]:
        """Touches of the present step, in their order."""
        if self.step == "lengths":
            return self.counted
        if self.step in CONTACT_STEPS:
            parts = set(features_of(self.step))
            return tuple(touch for touch in self.counted if touch.feature in parts)
        start = f"p{self.position}-{self.step}"
        return tuple(touch for touch in self.counted if touch.feature.startswith(start))

    def of(self, feature: str) -> tuple[SphereContact, ...]:
        """Touches that count of a part of the test."""
        return tuple(touch for touch in self.counted if touch.feature == feature)

    @property
    def here(self) -> tuple[SphereScan, ...]:
        """Scans of the present position, those set aside, too."""
        return tuple(
            scan
            for scan in self.scans
            if isinstance(scan, SphereScan) and scan.position == self.position
        )

    @property
    def bar_scans(self) -> tuple[BarScan, ...]:
        """Scans of a ball bar, those set aside, too."""
        return tuple(scan for scan in self.scans if isinstance(scan, BarScan))

    @property
    def plate_scans(self) -> tuple[PlateScan, ...]:
        """Scans of the plate, those set aside, too."""
        return tuple(scan for scan in self.scans if isinstance(scan, PlateScan))

    @property
    def orientation(self) -> int:
        """In which the plate is scanned next, from 1; 0 once it is scanned in all."""
        done = {scan.orientation for scan in self.plate_scans if scan.good}
        left = (number for number in range(1, ORIENTATIONS + 1) if number not in done)
        return next(left, 0)

    def scan_of(self, articulation: int) -> SphereScan | None:
        """The scan that counts of an articulation at the present position."""
        found = [one for one in self.here if one.articulation == articulation and one.good]
        return found[-1] if found else None

    @property
    def open_scan(self) -> AnyScan | None:
        """The one that is under way."""
        last = self.scans[-1] if self.scans else None
        return last if last is not None and not last.ended and not last.aside else None


def apply_row(state: PerformanceState, row: JournalEntry) -> PerformanceState:
    """The state after one more row of the journal.

    Raises:
        ValueError: a row of a kind that this version does not know.
    """
    return apply_change(CHANGES, STEPS, state, row)


def _start(state: PerformanceState, payload: Payload) -> PerformanceState:
    return replace(
        state,
        test=payload.get("test", "sphere"),
        calibration_id=payload["calibration_id"],
        arm=payload.get("arm", ""),
        gauge=payload["gauge"],
        bar=payload.get("bar", ""),
        positions=payload["positions"],
        by_scan=payload.get("by_scan", False),
        limits={name: _limit_of(limit) for name, limit in payload["limits"].items()},
        started_at=payload["at"],
    )


def _limit_of(limit: Any) -> DatasheetLimit:
    """The limit in a journal's row; before there were lengths, ``A`` alone."""
    if isinstance(limit, Mapping):
        return DatasheetLimit(limit["a_um"], limit.get("k"), limit.get("b_um"))
    return DatasheetLimit(limit)


def _set_limit(state: PerformanceState, payload: Payload) -> PerformanceState:
    limits = {name: limit for name, limit in state.limits.items() if name != payload["quantity"]}
    if payload["a_um"]:
        limits[payload["quantity"]] = _limit_of(payload)
    return replace(state, limits=limits)


def _set_temperature(state: PerformanceState, payload: Payload) -> PerformanceState:
    """Rows of earlier versions have the artefact's alone."""
    found = Temperatures(payload["celsius"], payload.get("arm_c"))
    if state.step == "temperatures":
        return replace(state, at_end=found)
    return replace(state, at_begin=found, expanded_c=payload["expanded_c"])


def _go_back(state: PerformanceState, payload: Payload) -> PerformanceState:
    """A result that was computed is computed again."""
    return replace(state, step=payload["to"], result="", failed=None)


def _freeze(state: PerformanceState, payload: Payload) -> PerformanceState:
    return replace(state, plan_sha256=payload["plan_sha256"], setup=payload["setup"])


def _add_touch(state: PerformanceState, payload: Payload) -> PerformanceState:
    touch = SphereContact(
        len(state.touches), payload["feature"], payload["place"], reading_of(payload), payload["at"]
    )
    confirmed = state.confirmed
    if state.sequence is not None:  # the first touch of a length confirms the one before
        whole = len(state.counted) // state.sequence.of_measurement
        confirmed = max(confirmed, whole * state.sequence.of_measurement)
    return replace(state, touches=(*state.touches, touch), undone=(), confirmed=confirmed)


def _begin_scan(state: PerformanceState, payload: Payload) -> PerformanceState:
    """A scan of a bar confirms the touches before it."""
    scan = scan_from_row(payload, len(state.scans) + 1, state.position)
    confirmed = len(state.counted) if isinstance(scan, BarScan) else 0
    return replace(
        state,
        scans=add_scan(state.scans, scan),
        confirmed=max(state.confirmed, confirmed),
    )


def _change_scan(state: PerformanceState, number: int, **changes: Any) -> PerformanceState:
    scans = tuple(replace(one, **changes) if one.number == number else one for one in state.scans)
    return replace(state, scans=scans)


def _confirm(state: PerformanceState, payload: Payload) -> PerformanceState:
    if state.step == "end" and state.position < state.positions:
        return replace(state, step="pattern", position=state.position + 1, undone=())
    steps = state.steps
    if state.step == "artefact" and state.test == "lengths":
        sequence = LengthSequence(
            payload["lengths"], payload["touches_each"], payload.get("by_scan", False)
        )
        state = replace(state, sequence=sequence)
    if state.step == "temperatures":
        at_end = Temperatures(payload["artefact_c"], payload["arm_c"])
        state = replace(state, at_end=at_end, result="", failed=None)
    return replace(state, step=steps[steps.index(state.step) + 1], undone=())


CHANGES: dict[str, Callable[[PerformanceState, Payload], PerformanceState]] = {
    "started": _start,
    "gauge_chosen": lambda state, payload: replace(state, gauge=payload["id"]),
    "bar_chosen": lambda state, payload: replace(state, bar=payload["id"]),
    "positions_set": lambda state, payload: replace(state, positions=payload["number"]),
    "by_scan_set": lambda state, payload: replace(state, by_scan=payload["by_scan"]),
    "limit_set": _set_limit,
    "temperature_set": _set_temperature,
    "plan_frozen": _freeze,
    "touched": _add_touch,
    "touch_voided": void_touch,
    "touch_restored": restore_touch,
    "scan_begun": _begin_scan,
    "scan_ended": lambda state, payload: _change_scan(state, payload["number"], ended=True),
    "scan_dropped": lambda state, payload: _change_scan(
        state, payload["number"], ended=True, aside="dropped"
    ),
    "scan_measured": lambda state, payload: _change_scan(
        state, payload["number"], **values_from_row(payload)
    ),
    "scan_refused": lambda state, payload: _change_scan(
        state, payload["number"], refused=payload["refused"]
    ),
    "step_confirmed": _confirm,
    "went_back": _go_back,
    "evaluated": lambda state, payload: replace(state, result=payload["result"], failed=None),
    "evaluation_failed": lambda state, payload: replace(state, failed=payload["refused"]),
    **dict.fromkeys(SIMULATION_NOTES, lambda state, payload: state),
    "accepted": lambda state, payload: replace(state, ended="accepted"),
    "abandoned": lambda state, payload: replace(state, ended="abandoned"),
}
