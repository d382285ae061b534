"""The benchmark ``drift``: what the tables of docs/fleet.md say about false and found changes."""

import json

import pytest
from typer.testing import CliRunner

from crenel.metrology.calibration_levels import OUTSIDE_SHARE
from tests.bench.commands import bench
from tests.bench.fleet.drift import CASES, LIMIT_CASES, run_limits, run_months, run_series

pytestmark = pytest.mark.soak


def test_healthy_recordings_are_rarely_accused() -> None:
    for one in run_months(60):
        assert one.accused <= 0.07, one.case
        if one.case.spread_um == 0.0 and one.case.every_days < 15:
            assert one.found is None or one.found >= 0.85, one.case


def test_series_without_a_change_rarely_have_one() -> None:
    for one in run_series(300, counts=(12, 60)):
        assert one.independent <= 0.06
        assert one.correlated <= 0.2


def test_the_limit_in_use_accuses_few_healthy_calibrations() -> None:
    strict, used, loose = run_limits(400, cases=((10, 0.0025), (10, OUTSIDE_SHARE), (10, 0.02)))
    assert strict.accused < used.accused < 0.02 < loose.accused
    assert strict.found < used.found < loose.found
    assert used.noted > 0.6
    (more,) = run_limits(150, cases=((40, OUTSIDE_SHARE),))
    assert more.found > used.found + 0.2


@pytest.mark.parametrize(
    ("option", "key", "rows"),
    [
        ((), "cases", len(CASES)),
        (("--series",), "series", 7),
        (("--limits",), "limits", len(LIMIT_CASES)),
    ],
)
def test_the_command_prints_its_tables(option: tuple[str, ...], key: str, rows: int) -> None:
    run = CliRunner().invoke(bench, ["drift", "--repeats", "10", "--json", *option])
    assert len(json.loads(run.stdout)[key]) == rows
    table = CliRunner().invoke(bench, ["drift", "--repeats", "10", *option]).stdout
    assert "accused" in table or "correlated" in table
