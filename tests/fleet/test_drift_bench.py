"""``crenel bench drift``: what the tables of docs/fleet.md say about false and found changes."""

import json

import pytest
from typer.testing import CliRunner

from app.bench.fleet.drift import CASES, run_months, run_series
from app.cli.main import cli

pytestmark = pytest.mark.slow


def test_healthy_recordings_are_rarely_accused() -> None:
    for one in run_months(60):
        assert one.accused <= 0.07, one.case
        if one.case.spread_um == 0.0 and one.case.every_days < 15:
            assert one.found is None or one.found >= 0.85, one.case


def test_series_without_a_change_rarely_have_one() -> None:
    for one in run_series(300, counts=(12, 60)):
        assert one.independent <= 0.06
        assert one.correlated <= 0.2


@pytest.mark.parametrize(
    ("option", "key", "rows"), [((), "cases", len(CASES)), (("--series",), "series", 7)]
)
def test_the_command_prints_its_tables(option: tuple[str, ...], key: str, rows: int) -> None:
    run = CliRunner().invoke(cli, ["bench", "drift", "--repeats", "10", "--json", *option])
    assert len(json.loads(run.stdout)[key]) == rows
    table = CliRunner().invoke(cli, ["bench", "drift", "--repeats", "10", *option]).stdout
    assert "accused" in table or "correlated" in table
