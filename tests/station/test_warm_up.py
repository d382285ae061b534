"""What is compiled before the station opens, and on what."""

import multiprocessing

from app.metrology.detection.corners import detect_object
from app.station.warm_up import BLOCK, PARTS, drawn_block
from tests.loops import loops


def test_the_search_comes_to_its_end_on_the_drawn_block() -> None:
    found = detect_object(drawn_block(), BLOCK)
    assert len(found.corners) >= 8
    assert found.rms_px < 0.3


def test_no_loop_is_compiled_by_two_processes() -> None:
    with multiprocessing.get_context("spawn").Pool(1, maxtasksperchild=1) as pool:
        first, second = (pool.apply(loops_of, (number,)) for number in range(len(PARTS)))
    assert first
    assert second
    assert not first & second


def loops_of(part: int) -> set[str]:
    PARTS[part]()
    return set(loops())
