"""A part that moves while it is measured is noticed before anything is decided."""

from pathlib import Path

import numpy as np
import pytest

from crenel.parts.evaluate import inspect_part
from crenel.parts.evaluate_folder import find_files
from tests.parts.bracket_program import datum_touches, write_program
from tests.parts.draws import first_setting
from tests.parts.simulated_inspection import (
    draw_truth,
    scan_part,
    touch_rows,
    write_station,
    write_touches,
)
from tests.parts.simulated_nests import small_motion

pytestmark = pytest.mark.slow
SLIP_MM = 0.1


def write_slip(folder: Path, case: str, seed: int) -> None:
    """An inspection of the bracket, which slips at a place of it."""
    setting = first_setting()
    station, passes = setting.station, setting.planned
    truth, half = draw_truth(station, seed), len(passes) // 2
    slip = small_motion(np.random.default_rng(seed), SLIP_MM)
    (folder / "scans").mkdir(parents=True)
    write_station(folder, station)
    first, second = folder / "scans" / "1.mcap", folder / "scans" / "2.mcap"
    if case == "recordings":
        scan_part(first, setting.true, truth, passes[:half], seed)
        scan_part(second, setting.true, truth, passes[half:], seed + 1, (0, slip))
    else:
        start = {"passes": half, "touches": 0}.get(case)
        slipped = None if start is None else (start, slip)
        scan_part(first, setting.true, truth, passes, seed, slipped)
    write_touches(folder, station, touch_rows(station, truth, datum_touches(setting.true), seed))
    write_program(folder / "program.json", setting.nominal, setting.true)


@pytest.mark.parametrize(
    ("case", "said"),
    [
        ("passes", "moved during the scan"),
        ("recordings", "moved between two recordings"),
        ("touches", "moved between touches and scan"),
    ],
)
def test_a_slip_is_named_and_nothing_is_decided(tmp_path: Path, case: str, said: str) -> None:
    write_slip(tmp_path, case, 611)
    result = inspect_part(find_files(tmp_path))
    assert said in str(result.warnings[0])
    assert {one.decision for one in result.dimensions} <= {"undecided", "none"}
    assert result.verdict == "undecided"


def test_a_part_that_stays_is_not_said_to_have_moved(tmp_path: Path) -> None:
    for seed in (621, 622):
        write_slip(tmp_path / str(seed), "nothing", seed)
        result = inspect_part(find_files(tmp_path / str(seed)))
        assert not [text for text in result.warnings if "moved" in str(text)]
        assert "pass" in {one.decision for one in result.dimensions}
