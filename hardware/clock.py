"""The one clock that every stamp is on."""

import time


def now_ns() -> int:
    """Host-monotonic time in integer nanoseconds."""
    return time.monotonic_ns()
