"""Taking points back, and putting them back again, in any session that takes points. Pure."""

from collections.abc import Iterable
from dataclasses import replace
from typing import Any, TypeVar

T = TypeVar("T", bound=Any)  # a dataclass with ``index`` and ``voided``
Undone = tuple[int, ...]
"""Indices of what was taken back since the last one was taken, the last of them last."""


def take_back(taken: Iterable[T], undone: Undone, index: int) -> tuple[tuple[T, ...], Undone]:
    """What was taken, without the one of an index; and what can be put back now."""
    return _mark(taken, index, voided=True), (*undone, index)


def put_back(taken: Iterable[T], undone: Undone, index: int) -> tuple[tuple[T, ...], Undone]:
    """The inverse."""
    return _mark(taken, index, voided=False), tuple(i for i in undone if i != index)


def _mark(taken: Iterable[T], index: int, voided: bool) -> tuple[T, ...]:
    return tuple(replace(one, voided=voided) if one.index == index else one for one in taken)
