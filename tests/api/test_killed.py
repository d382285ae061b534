"""A server that is killed in the steps of calibrations, verifications and performance tests."""

from pathlib import Path

import pytest

from tests.api.forked_station import ForkedStation
from tests.bench.faults import kills
from tests.bench.faults.row import FaultRow, table

pytestmark = [pytest.mark.device, pytest.mark.soak]

BUSY_LOST_S = 2.9
"""Nearly a whole one of these scans; how little is lost on a quiet machine, a bench measures."""

ALIKE = {
    *(("flow", "touch", count) for count in (5, 20)),
    *(("verify", step, count) for step, count in (("touch", 2), ("scan", 1))),
    *(("performance", step, 0) for step in ("artefact", "pattern", "location", "scan", "end")),
    *(("performance", *place) for place in (("pattern", 12), ("scan", 3), ("end", 2))),
    *(("performance", *place) for place in (("temperatures", 0), ("review", 0), ("review", 1))),
    *(("lengths", *place) for place in (("artefact", 0), ("lengths", 0), ("lengths", 4))),
    *(("lengths", "lengths", count) for count in (13, 20)),
    *(("lengths", "review", count) for count in (0, 1)),
    *(("scanned-lengths", *place) for place in (("artefact", 0), ("lengths", 1), ("lengths", 7))),
    *(("plane", *place) for place in (("artefact", 0), ("plate", 0), ("plate", 5))),
    *(("plane", *place) for place in (("temperatures", 0), ("review", 1))),
    *(("contact", "diameter", count) for count in (0, 9, 13)),
    *(("contact", *place) for place in (("artefact", 0), ("seats", 0), ("seats", 14))),
    *(("contact", "bar", count) for count in (0, 3, 12, 50, 90, 130)),
    *(("contact", *place) for place in (("temperatures", 0), ("review", 1))),
}
"""Places of the bench that are like others of their step or beside them, and left to it."""


def assert_kept(row: FaultRow) -> None:
    assert row.tries
    assert (row.survived, row.lost) == (row.tries, 0), table([row])
    assert row.stop_s >= 0


FLOWS = [flow for flow in kills.KILL_POINTS if flow != "parts"]
"""That of parts has a test of its own, of its result, too."""


@pytest.mark.parametrize("flow", FLOWS)
@pytest.mark.timeout(900)
def test_kills_in_every_step_lose_nothing(tmp_path: Path, flow: str) -> None:
    places = tuple(place for place in kills.KILL_POINTS[flow] if (flow, *place) not in ALIKE)
    assert_kept(kills.kill_guides(tmp_path / "data", flow, places, start=ForkedStation))


@pytest.mark.timeout(300)
def test_kills_in_scans_lose_nothing(tmp_path: Path) -> None:
    assert_kept(
        kills.kill_scans(tmp_path / "data", kills=3, start=ForkedStation, most_lost_s=BUSY_LOST_S)
    )
