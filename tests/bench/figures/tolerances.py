"""By how much a measured figure may be worse than the printed one: its sample's own scatter."""

import math

from tests.bench.figures.figure import Tolerance

K = 3
"""Standard errors."""
SPEED = 0.2
"""Share by which rates of one run, over each other, differ from run to run on a shared machine."""


def share_of(share: float, reason: str) -> Tolerance:
    """A share of the printed value."""
    return Tolerance(lambda printed: share * abs(printed), reason)


def within(amount: float, reason: str) -> Tolerance:
    """An amount, whatever is printed."""
    return Tolerance(lambda _: amount, reason)


def exactly(reason: str) -> Tolerance:
    """Nothing but the rounding of what is printed."""
    return within(0.0, reason)


def rms_of(count: int, what: str) -> Tolerance:
    """Of the rms of ``count`` independent deviations: 1/√(2 n) of it."""
    return share_of(K / math.sqrt(2 * count), f"{K}/√(2·{count}): the rms of {count} {what}")


def mean_of(count: int, scatter: float, what: str) -> Tolerance:
    """Of a mean or a median of ``count`` values that scatter by a share of themselves."""
    share = K * scatter / math.sqrt(count)
    return share_of(share, f"{K}·{scatter:g}/√{count}: {count} {what}")


def count_of(total: int, what: str, unit: float = 1.0) -> Tolerance:
    """Of a count among ``total`` trials, or of a share of them in ``unit``/total, by Laplace's
    rule."""

    def of(printed: float) -> float:
        p = (printed / unit + 1) / (total + 2)
        return K * unit * math.sqrt(total * p * (1 - p))

    return Tolerance(of, f"{K}·√(n·p·(1 − p)) of {total} {what}")


def speed() -> Tolerance:
    """Of a rate over that of a peer in the same run."""
    return share_of(SPEED, f"{100 * SPEED:.0f} %: rates of one run over each other")
