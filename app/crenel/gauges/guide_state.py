"""The state of a performance test: a fold over its journal. Pure."""

from collections.abc import Callable, Mapping
from dataclasses import replace
from functools import partial
from typing import Any

from crenel.gauges.plan.document import Kind
from crenel.gauges.session.changes import Payload, apply_change, restore_touch, void_touch
from crenel.gauges.session.entries import (
    DatasheetLimit,
    SphereContact,
    Temperatures,
    add_scan,
)
from crenel.gauges.session.state import PerformanceState
from crenel.guide.common.journal import SIMULATION_NOTES, JournalEntry, reading_of


def apply_row(
    states: Mapping[Kind, type[PerformanceState]], state: PerformanceState, row: JournalEntry
) -> PerformanceState:
    """The state after one more row of the journal.

    Args:
        states: of the kinds of tests.

    Raises:
        ValueError: a row of a kind that this version does not know.
    """
    return apply_change({**CHANGES, "started": partial(_start, states)}, state, row)


def _start(
    states: Mapping[Kind, type[PerformanceState]], state: PerformanceState, payload: Payload
) -> PerformanceState:
    return states[payload.get("test", "sphere")](
        session_id=state.session_id,
        rev=state.rev,
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
    return replace(
        state,
        touches=(*state.touches, touch),
        undone=(),
        confirmed=state.count_confirmed_at_touch(),
    )


def _begin_scan(state: PerformanceState, payload: Payload) -> PerformanceState:
    scan = state.scan_of_row(payload, len(state.scans) + 1)
    return replace(
        state,
        scans=add_scan(state.scans, scan),
        confirmed=state.count_confirmed_at_scan(),
    )


def _change_scan(state: PerformanceState, number: int, **changes: Any) -> PerformanceState:
    scans = tuple(replace(one, **changes) if one.number == number else one for one in state.scans)
    return replace(state, scans=scans)


def _confirm(state: PerformanceState, payload: Payload) -> PerformanceState:
    if state.step == "artefact":
        state = state.begin(payload)
    if state.step == "temperatures":
        at_end = Temperatures(payload["artefact_c"], payload["arm_c"])
        state = replace(state, at_end=at_end, result="", failed=None)
    return replace(state.next_step(), undone=())


CHANGES: dict[str, Callable[[PerformanceState, Payload], PerformanceState]] = {
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
        state, payload["number"], **state.scan_values(payload)
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
