"""Which cases of a test the usual run takes; the others have a mark by which they are asked for."""

from collections.abc import Collection, Iterable

import pytest


def usual(
    cases: Iterable[object], kept: int | Collection[int], others: pytest.MarkDecorator
) -> list[object]:
    """Cases of ``parametrize``, of which all but some have a mark, written out at the call as marks
    are read from the text of a file. ``kept``: the places of those without, or how many of the
    first."""
    chosen = range(kept) if isinstance(kept, int) else kept
    return [
        case
        if place in chosen
        else pytest.param(*(case if isinstance(case, tuple) else (case,)), marks=others)
        for place, case in enumerate(cases)
    ]
