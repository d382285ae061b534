"""The one-sphere test at two positions of the sphere."""

from app.formats.performance.plan import sphere_features
from tests.guide.builders import Row
from tests.guide.performance_sessions import started, state_after

ARTICULATIONS = 5
START = started("sphere", gauge="sphere")
CONFIRM: Row = ("step_confirmed", {})


def at_position(position: int) -> list[Row]:
    """The rows of all touches and scans at one position."""
    rows: list[Row] = []
    for feature in (name for name in sphere_features(2) if name.startswith(f"p{position}")):
        if feature.endswith("end"):
            for number in range(1, ARTICULATIONS + 1):
                rows += [
                    ("scan_begun", {"articulation": number, "at": "2026-05-01T06:00:00Z"}),
                    ("scan_ended", {"number": (position - 1) * ARTICULATIONS + number}),
                ]
            rows.append(CONFIRM)
        rows.append(("touched", {"feature": feature, "place": 0, "q_rad": [0.0] * 6}))
        if not feature.startswith(f"p{position}-location") or feature.endswith("5"):
            rows.append(CONFIRM)
    return rows


def test_the_second_position_follows_the_first() -> None:
    begin = (START, ("positions_set", {"number": 2}), CONFIRM)
    state = state_after(*begin, *at_position(1))
    assert (state.step, state.position, state.feature) == ("pattern", 2, "p2-pattern")
    assert (state.of_step, state.here, len(state.scans)) == ((), (), ARTICULATIONS)
    assert state.articulation == 1
    state = state_after(*begin, *at_position(1), *at_position(2))
    assert (state.step, state.position) == ("temperatures", 2)
    assert [touch.feature for touch in state.counted] == sphere_features(2)
    assert [scan.name for scan in state.scans] == [
        f"p{position}-a{number}" for position in (1, 2) for number in range(1, ARTICULATIONS + 1)
    ]


def test_one_position_is_enough_unless_two_are_asked_for() -> None:
    state = state_after(START, CONFIRM, *at_position(1))
    assert (state.step, state.position) == ("temperatures", 1)
