"""Slows down password guessing."""

import ipaddress
import threading
import time
from collections.abc import Callable

FREE_TRIES = 5
LONGEST_WAIT_S = 60.0
FORGOTTEN_S = 900.0
MAX_KEYS = 10_000


class Throttle:
    """Failures by key: an address, or a name. After some failures, each one doubles the wait."""

    def __init__(self, clock: Callable[[], float] = time.monotonic) -> None:
        self._clock = clock
        self._lock = threading.Lock()
        self._failures: dict[str, tuple[int, float]] = {}

    def wait_s(self, *keys: str) -> float:
        """Seconds until the next attempt is allowed."""
        with self._lock:
            return max(self._key_wait_s(key) for key in keys)

    def note_failure(self, *keys: str) -> None:
        """Records a failure."""
        now = self._clock()
        with self._lock:
            if len(self._failures) > MAX_KEYS:
                recent = {k: v for k, v in self._failures.items() if now - v[1] < LONGEST_WAIT_S}
                self._failures = recent
            for key in keys:
                count, at = self._failures.get(key, (0, now))
                self._failures[key] = (1 if now - at > FORGOTTEN_S else count + 1, now)

    def note_success(self, *keys: str) -> None:
        """Clears the failures."""
        with self._lock:
            for key in keys:
                self._failures.pop(key, None)

    def _key_wait_s(self, key: str) -> float:
        count, at = self._failures.get(key, (0, 0.0))
        if count < FREE_TRIES:
            return 0.0
        wait_s = min(2.0 ** (count - FREE_TRIES), LONGEST_WAIT_S)
        return max(at + wait_s - self._clock(), 0.0)


def address_key(address: str) -> str:
    """The key for attempts and connections: a machine may have a whole IPv6 network."""
    try:
        plain = ipaddress.ip_address(address.partition("%")[0])
    except ValueError:
        return f"address {address}"
    if isinstance(plain, ipaddress.IPv4Address):
        return f"address {plain}"
    return f"address {plain.ipv4_mapped or ipaddress.ip_network((int(plain) >> 64 << 64, 64))}"
