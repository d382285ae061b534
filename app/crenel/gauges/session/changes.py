"""How a row of the journal changes the state of a session on a gauge. Pure."""

from collections.abc import Callable, Mapping
from dataclasses import replace
from typing import Any, TypeVar

from crenel.guide.common.journal import JournalEntry, put_back, take_back

State = TypeVar("State", bound=Any)  # a dataclass with the steps and touches of such a session
Payload = Mapping[str, Any]


def apply_change(
    changes: Mapping[str, Callable[[State, Payload], State]],
    state: State,
    row: JournalEntry,
) -> State:
    """The state after one more row of the journal.

    Args:
        changes: what the rows of each kind change.

    Raises:
        ValueError: a row of a kind that this version does not know.
    """
    if row.kind not in changes:
        raise ValueError(f"row of an unknown kind: {row.kind}")
    changed = changes[row.kind](state, {**row.payload, "at": row.at})
    reached = max(changed.reached, changed.step, key=changed.all_steps.index)
    return replace(changed, session_id=row.session_id, rev=row.number, reached=reached)


def void_touch(state: State, payload: Payload) -> State:
    """Takes a touch back."""
    touches, undone = take_back(state.touches, state.undone, payload["index"])
    return replace(state, touches=touches, undone=undone)


def restore_touch(state: State, payload: Payload) -> State:
    """Puts a touch back that was taken back."""
    touches, undone = put_back(state.touches, state.undone, payload["index"])
    return replace(state, touches=touches, undone=undone)
