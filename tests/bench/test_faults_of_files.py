"""Short forms of the bench: a station with damaged files, on a full disk, flooded, and on a hostile
broker."""

from collections.abc import Iterator
from contextlib import ExitStack
from functools import partial
from pathlib import Path
from unittest.mock import patch

import pytest

from tests.bench.faults import damage, disk, floods, furnished
from tests.bench.faults.broker import hostile_broker
from tests.bench.faults.broker.mosquitto import BINARY
from tests.bench.faults.furnished import FolderRecords
from tests.bench.faults.row import FaultRow, table
from tests.bench.faults.served import HALF, HALF_SIZE, prepare
from tests.bench.faults.station import StationProcess

pytestmark = [pytest.mark.timeout(400), pytest.mark.device, pytest.mark.soak]
Folder = tuple[Path, FolderRecords]


@pytest.fixture(scope="module", autouse=True)
def small_pictures() -> Iterator[None]:
    """All stations of these benches draw a quarter of the usual pixels, less often."""
    station = partial(StationProcess, options=HALF_SIZE)
    with ExitStack() as stack:
        for module in (furnished, floods):
            stack.enter_context(patch.object(module, "prepare", partial(prepare, config=HALF)))
        for module in (furnished, damage, disk, floods):
            stack.enter_context(patch.object(module, "StationProcess", station))
        yield


@pytest.fixture(scope="module")
def folder(small_pictures: None, tmp_path_factory: pytest.TempPathFactory) -> Folder:
    """A data folder with something in every place; it is copied, and stays as it is."""
    data = tmp_path_factory.mktemp("furnished") / "data"
    return data, furnished.furnish(data)


def assert_survived(row: FaultRow) -> None:
    assert row.tries
    assert (row.survived, row.lost) == (row.tries, 0), table([row])


def test_a_calibration_of_no_moment_is_reported_and_the_rest_served(folder: Folder) -> None:
    data, kept = folder
    assert_survived(damage.run(data, words="calibration: a date that is none", kept=kept))


def test_a_disk_that_is_full_for_a_while_loses_nothing(folder: Folder) -> None:
    data, kept = folder
    assert_survived(disk.run(data, tries=1, kept=kept))


def test_no_flood_is_answered_by_a_fault(tmp_path: Path) -> None:
    for row in floods.run(tmp_path / "data", seconds=0.5):
        assert row.tries, row.kind
        assert row.survived == row.tries, table([row])
        assert row.stop_s >= 0, "Stop was never answered"


@pytest.mark.skipif(BINARY is None, reason="mosquitto is not installed")
def test_what_strangers_publish_hides_no_station_and_holds_up_no_stop(tmp_path: Path) -> None:
    rows = hostile_broker.run(tmp_path / "data", seconds=4.0, floods=("200 stations",), settled_s=0)
    (row,) = rows
    # on a busy machine the usual station itself may be late now and then
    assert row.survived > row.tries / 2, table([row])
    assert row.stop_s >= 0, "Stop was never answered"
