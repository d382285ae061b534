"""Waiting after failures."""

import pytest

from crenel.security.login_throttle import (
    FORGOTTEN_S,
    FREE_TRIES,
    LONGEST_WAIT_S,
    Throttle,
    address_key,
)


class Clock:
    now_s = 0.0

    def __call__(self) -> float:
        return self.now_s


def test_after_some_failures_each_doubles_the_wait_up_to_a_minute() -> None:
    clock = Clock()
    throttle = Throttle(clock)
    waits = []
    for _ in range(FREE_TRIES + 10):
        throttle.note_failure("anna", "10.0.0.1")
        waits.append(throttle.wait_s("anna"))
    assert waits[: FREE_TRIES - 1] == [0.0] * (FREE_TRIES - 1)
    assert waits[FREE_TRIES - 1 : FREE_TRIES + 2] == [1.0, 2.0, 4.0]
    assert waits[-1] == LONGEST_WAIT_S
    assert throttle.wait_s("ben", "10.0.0.1") == LONGEST_WAIT_S
    assert throttle.wait_s("ben") == 0.0
    clock.now_s += LONGEST_WAIT_S
    assert throttle.wait_s("anna") == 0.0


def test_success_and_time_forget() -> None:
    clock = Clock()
    throttle = Throttle(clock)
    for _ in range(9):
        throttle.note_failure("anna", "ben")
    throttle.note_success("anna")
    assert throttle.wait_s("anna") == 0.0
    clock.now_s += FORGOTTEN_S + 1
    throttle.note_failure("ben")
    assert throttle.wait_s("ben") == 0.0


@pytest.mark.parametrize(
    ("one", "other", "alike"),
    [
        ("10.0.0.1", "10.0.0.2", False),
        ("10.0.0.1", "::ffff:10.0.0.1", True),
        ("2001:db8::1", "2001:db8::ffff:0:1", True),
        ("2001:db8::1", "2001:db8:0:1::1", False),
        ("fe80::1%eth0", "fe80::1%eth1", True),
        ("testclient", "other", False),
    ],
)
def test_a_machine_with_many_addresses_is_one(one: str, other: str, alike: bool) -> None:
    assert (address_key(one) == address_key(other)) is alike
