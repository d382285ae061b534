"""An inspection whose server is killed in its steps ends as one that is not."""

import sqlite3
from pathlib import Path

import pytest

from crenel.parts.document_nominal import ADVISED_TOUCHES
from crenel.parts.document_program import ProgramFile
from crenel.parts.document_results import InspectionFile
from crenel.parts.evaluate import inspect_part
from crenel.parts.evaluate_folder import find_files
from tests.api.forked_station import ForkedStation
from tests.bench.faults import kills
from tests.bench.faults.row import table

pytestmark = [pytest.mark.device, pytest.mark.soak]
PLACES = (("setup", 0), ("align", 4), ("measure", 1), ("measure", 30), ("review", 0), ("review", 1))


@pytest.mark.timeout(900)
def test_it_ends_with_the_same_result_and_nothing_is_asked_twice(tmp_path: Path) -> None:
    data = tmp_path / "data"
    row = kills.kill_guides(data, "parts", PLACES, start=ForkedStation)
    assert (row.tries, row.survived, row.lost) == (len(PLACES), len(PLACES), 0), table([row])
    (folder,) = (data / "inspections").iterdir()
    program = ProgramFile.read(folder / "program.json")
    found = inspect_part(find_files(folder))
    assert found == InspectionFile.read(folder / "results.json")
    assert [one.id for one in found.dimensions] == [one.id for one in program.dimensions]
    with sqlite3.connect(data / "station.db") as database:
        rows = database.execute("SELECT kind, payload FROM journal").fetchall()
    kinds = [kind for kind, _ in rows]
    assert kinds.count("touched") == sum(ADVISED_TOUCHES[one.kind] for one in program.features)
    assert kinds.count("set_up") == 1
    assert kinds.count("evaluated") == 1
