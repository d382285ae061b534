"""The bench of performance tests: every row near what it should be."""

import pytest

from app.bench.metrology.performance import run, table


def test_every_row_is_near_its_expectation() -> None:
    rows = run(200)
    assert len(table(rows)) == len(rows) == 15
    for row in rows:
        if row.expected:
            assert row.found == pytest.approx(row.expected, rel=0.2), row.figure
        else:
            assert row.found > 1, row.figure
