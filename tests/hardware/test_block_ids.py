"""Block ids of GigE Vision and USB3 Vision, unwrapped."""

from itertools import accumulate

import pytest
from hypothesis import given
from hypothesis import strategies as st

from crenel_hardware.sensor.genicam.block_ids import BlockCounter

steps = st.lists(st.integers(1, 1000), min_size=1, max_size=200)


def count_all(ids: list[int]) -> list[int | None]:
    counter = BlockCounter()
    return [counter.count(block_id) for block_id in ids]


@pytest.mark.parametrize(
    ("ids", "numbers"),
    [
        pytest.param([65533, 65534, 65535, 1, 2], [0, 1, 2, 3, 4], id="zero-is-skipped"),
        pytest.param([65534, 3, 4], [0, 4, 5], id="losses-across-the-wrap"),
        pytest.param([65534, 65535, 65536, 65537, 70000], [0, 1, 2, 3, 4466], id="64-bits"),
        pytest.param([0, 1, 2, 5], [0, 1, 2, 5], id="usb-begins-at-zero"),
        pytest.param([10, 11, 11, 12, 11, 13], [0, 1, None, 2, None, 3], id="repeated-or-late"),
        pytest.param([100_000, 100_001, 1, 2], [0, 1, 2, 3], id="a-long-counter-begins-again"),
    ],
)
def test_pictures_are_numbered_from_zero(ids: list[int], numbers: list[int | None]) -> None:
    assert count_all(ids) == numbers


PERIOD_NS = 40_000_000


def count_stamped(pictures: list[tuple[int, int]]) -> list[int | None]:
    """Of ids with stamps in periods."""
    counter = BlockCounter()
    return [counter.count(number, stamp_ns=at * PERIOD_NS) for number, at in pictures]


@pytest.mark.parametrize("last", [1000, 30_000, 60_000])
@pytest.mark.parametrize("first", [1, 2, 900])
@pytest.mark.parametrize("clock", [100_100, 3])
def test_a_count_that_begins_again_goes_on(last: int, first: int, clock: int) -> None:
    """It falls by less or more than half the range; the camera's clock goes on, or begins again."""
    before = [(last - 4 + i, 100_000 + i) for i in range(5)]
    after = [(first + i, clock + i) for i in range(3)]
    assert count_stamped(before + after) == [0, 1, 2, 3, 4, 5, 6, 7]


def test_stamps_do_not_mislead_the_count() -> None:
    with_late_ones = [(11, 11), (12, 12), (14, 14), (13, 13), (15, 15), (9, 9), (16, 16)]
    assert count_stamped(with_late_ones) == [0, 1, 3, None, 4, None, 5]
    lost_across_the_wrap = [(65_000, 0), (65_001, 1), (500, 1035), (501, 1036)]
    assert count_stamped(lost_across_the_wrap) == [0, 1, 1035, 1036]
    paused_before_the_wrap = [(65_534, 0), (65_535, 1), (1, 90_000), (2, 90_001)]
    assert count_stamped(paused_before_the_wrap) == [0, 1, 2, 3]


@given(st.integers(1, 65535), steps)
def test_stamps_change_nothing_for_a_count_that_goes_on(first: int, gaps: list[int]) -> None:
    numbers = list(accumulate(gaps, initial=0))
    pictures = [((first - 1 + number) % 65535 + 1, number) for number in numbers]
    assert count_stamped(pictures) == numbers


@given(st.integers(1, 65535), steps)
def test_any_16_bit_counter_is_unwrapped(first: int, gaps: list[int]) -> None:
    wanted = list(accumulate(gaps, initial=0))
    assert count_all([(first - 1 + number) % 65535 + 1 for number in wanted]) == wanted


@given(st.integers(65536, 2**63), steps)
def test_any_64_bit_counter_is_taken_as_it_is(first: int, gaps: list[int]) -> None:
    wanted = list(accumulate(gaps, initial=0))
    assert count_all([first + number for number in wanted]) == wanted


def test_an_incomplete_picture_may_have_no_number() -> None:
    counter = BlockCounter()
    assert counter.count(0, whole=False) is None
    numbers = [counter.count(65_401), counter.count(0, whole=False), counter.count(65_403)]
    assert numbers == [0, None, 2]


def test_a_whole_picture_may_have_the_number_zero() -> None:
    """USB3 Vision counts from 0."""
    counter = BlockCounter()
    assert [counter.count(0), counter.count(1, whole=False), counter.count(2)] == [0, 1, 2]


def test_pictures_follow_one_another_over_a_stop_of_the_camera() -> None:
    counter = BlockCounter()
    assert [counter.count(block_id) for block_id in (70_000, 70_002)] == [0, 2]
    counter.restart()
    assert [counter.count(block_id) for block_id in (1, 2, 4)] == [3, 4, 6]
    counter.restart()
    assert [counter.count(block_id) for block_id in (65_535, 1)] == [7, 8]
