"""The symbols of performance tests over time, from the files of the tests."""

from collections.abc import Sequence
from dataclasses import dataclass
from functools import lru_cache
from pathlib import Path

from crenel.errors import OperationError
from crenel.formats.results.decision_rule import describe_rule
from crenel.gauges.judgement.document import PerformanceFigure, read_performance
from crenel.gauges.plan.document import RESULT
from crenel.gauges.plan.document_symbols import is_signed
from crenel.messages.message import Text
from crenel.metrology.decision import Decision

CACHE_SIZE = 1024


@dataclass(frozen=True)
class SymbolValue:
    """One symbol of a test, in µm, with the limit by which that test was judged."""

    quantity: str
    symbol: str
    title: Text
    signed: bool
    value: float | None
    """None if the test could not state it."""
    test_uncertainty: float | None
    """Expanded, k = 2."""
    limit: float | None
    decision: Decision


@dataclass(frozen=True)
class PerformanceSymbols:
    """What one test found. Tests are compared on the same kind of artefact and the same arm."""

    id: str
    ended_at: str
    artefact_kind: str
    """``sphere``, ``ball-bar``, ``step-gauge``, ``plane``, or ``contact`` for B89.4.22."""
    arm_serial: str
    rule: Text
    """The decision rule as of the test."""
    symbols: tuple[SymbolValue, ...]


def read_symbols(folders: Sequence[Path]) -> list[PerformanceSymbols]:
    """Reads the symbols of the folders of tests, in their order.

    A test without a result, as one that was cancelled, and one that cannot be read any more are
    passed over. What was read once is remembered until its file is written again.
    """
    found = []
    for folder in folders:
        try:
            found.append(_read(folder, (folder / RESULT).stat().st_mtime_ns))
        except (OperationError, OSError):
            continue
    return found


@lru_cache(maxsize=CACHE_SIZE)
def _read(folder: Path, written_ns: int) -> PerformanceSymbols:
    document = read_performance(folder)
    length = document.length if document.kind == "lengths" else None
    return PerformanceSymbols(
        id=document.id,
        ended_at=document.ended_at,
        artefact_kind=document.kind if length is None else length.kind,
        arm_serial=document.serial_numbers.arm,
        rule=describe_rule(document.rule),
        symbols=tuple(map(_value, document.figures)),
    )


def _value(figure: PerformanceFigure) -> SymbolValue:
    return SymbolValue(
        quantity=figure.quantity,
        symbol=figure.symbol,
        title=figure.title,
        signed=is_signed(figure.quantity),
        value=figure.value,
        test_uncertainty=figure.test_uncertainty,
        limit=figure.limit,
        decision=figure.decision,
    )
