"""Sizes told by the adjustment: the tip's, and the block's between opposite faces."""

from dataclasses import replace

import numpy as np
import pytest

from app.bench.simulated import USUAL, SetUp, Station, drawn, station_of
from app.metrology.adjustment.scales import Scales
from app.metrology.adjustment.sizes_told import about_sizes
from app.metrology.adjustment.solve import Adjusted, adjust
from app.metrology.findings import LIMITS, Finding

ALL_AROUND = ("crest", "front", "back", "left", "right")


def station(scales: Scales = USUAL, faces: tuple[str, ...] = ALL_AROUND) -> Station:
    return station_of(SetUp("sizes", 3, faces=faces, contacts_per_face=8, scales=scales))


def solved(on: Station, seed: int, wrong: dict[str, float] | None = None) -> Adjusted:
    """An adjustment by papers that are ``wrong`` by so much (mm) on these faces."""
    session = drawn(on, np.random.default_rng(seed))
    touches = session.problem.touches
    assert touches is not None
    outward = np.array([(wrong or {}).get(face, 0.0) for face in touches.features])
    wrongly = replace(session.problem, touches=replace(touches, outward_mm=outward))
    return adjust(wrongly, session.start)


def said(on: Station, wrong: dict[str, float]) -> Finding:
    (finding,) = about_sizes(solved(on, 3, wrong), LIMITS)
    return finding


def test_errors_of_the_arms_links_are_not_taken_for_a_size() -> None:
    poor = station(replace(USUAL, links_mm=0.03, links_rad=7.5e-5))
    for seed in range(12):
        found = solved(poor, seed)
        assert [one.quality for one in about_sizes(found, LIMITS)] == ["good"]


@pytest.mark.parametrize("pair", [("front", "back"), ("left", "right")])
@pytest.mark.parametrize("by_mm", [-0.06, 0.06])
def test_a_wrong_size_of_the_block_is_told_with_its_faces(
    pair: tuple[str, str], by_mm: float
) -> None:
    told = said(station(), dict.fromkeys(pair, by_mm / 2))
    assert (told.code, told.quality) == ("size", "attention")
    assert f"on {pair[0]} and {pair[1]} lie" in told.text
    assert ("closer together" if by_mm > 0 else "further apart") in told.text
    off_um = float(told.text.split(" µm")[0].split()[-1])
    assert off_um == pytest.approx(1e3 * abs(by_mm), abs=15)


def test_what_is_wrong_all_around_is_the_tip() -> None:
    told = said(station(), dict.fromkeys(ALL_AROUND, 0.03))
    assert (told.code, told.quality) == ("tip-diameter", "attention")


def test_sizes_are_unchecked_where_no_two_opposite_faces_were_touched() -> None:
    assert said(station(faces=("crest", "front", "left")), {}).code == "size-unchecked"
