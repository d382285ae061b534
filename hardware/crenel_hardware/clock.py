"""The common clock of all time stamps."""

import time


def now_ns() -> int:
    """Host-monotonic time in integer nanoseconds."""
    return time.monotonic_ns()
