"""Which cases of a test the usual run takes; the others have a mark by which they are asked for."""

from collections.abc import Collection, Iterable

import pytest


def usual(
    cases: Iterable[object], kept: int | Collection[int], others: pytest.MarkDecorator
) -> list[object]:
    """Cases of ``parametrize``, of which all but some have a mark.

    Args:
        cases: values of one argument, or tuples of several.
        kept: the places of those without the mark, or how many of the first.
        others: written out where it is given, as marks are read from the text of a file.
    """
    chosen = range(kept) if isinstance(kept, int) else kept
    return [
        case
        if place in chosen
        else pytest.param(*(case if isinstance(case, tuple) else (case,)), marks=others)
        for place, case in enumerate(cases)
    ]
