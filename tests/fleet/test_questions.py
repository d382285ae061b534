"""A wrong calibration is found with its dates and its recordings, and no other recording."""

from collections.abc import Iterable, Sequence
from dataclasses import replace
from datetime import datetime, timedelta
from typing import Any

import numpy as np
import pytest

from crenel.fleet.calibration_doubts import find_calibration_doubts
from crenel.fleet.catalogue.catalogue import FleetCatalogue
from crenel.fleet.catalogue.entry import CatalogueEntry
from crenel.fleet.catalogue.reading import SearchQuery, search
from crenel.fleet.questions import (
    AffectedPeriod,
    StationDrift,
    drift_of,
    find_affected,
    find_calibrations,
    find_doubted,
)
from tests.bench.fleet.invented import START, PlantedStep, invent_entries
from tests.fleet.entries import entry_of, figure_of
from tests.present import present
from tests.running.usual import usual

pytestmark = pytest.mark.device

DAY = timedelta(days=1)


def ten_months(
    wrong: tuple[int, int],
    by_calibration: bool,
    station: str = "room-3",
    more_um: Sequence[float] = (0.0,) * 10,
) -> list[CatalogueEntry]:
    """A station with two tests a week, scans every day, and a calibration every thirty days; of the
    days ``wrong``, the location error is 12 µm larger, and that of each month by ``more_um``."""
    rng = np.random.default_rng(7)
    found = []
    for day in range(300):
        month = day // 30
        about: dict[str, Any] = {"at": START + DAY * day, "station": station}
        about["calibration_id"] = f"cal-{month}" if by_calibration else "cal-0"
        if day % 30 == 0:
            found.append(entry_of(kind="calibration", id=f"cal-{month}", **about))
        found.append(entry_of(id=f"scan-{day}", label=f"Part {4700 + day}", **about))
        if day % 3 == 1:
            value = 28.0 + float(rng.normal(0, 2.0)) + (12.0 if wrong[0] <= day < wrong[1] else 0.0)
            figures = (figure_of(value + more_um[month]),)
            found.append(entry_of(kind="performance", id=f"test-{day}", figures=figures, **about))
    return found


def day_of(at: datetime) -> int:
    return (at - START) // DAY


def ids_of(entries: Iterable[CatalogueEntry]) -> list[str]:
    return [one.id for one in entries]


def scans_of(first: int, end: int) -> list[str]:
    return [f"scan-{day}" for day in range(first, end)]


def only_period(catalogue: FleetCatalogue) -> tuple[StationDrift, AffectedPeriod]:
    """The drift of the only station, and what is affected by its only change."""
    with catalogue.reading() as connection:
        (drift,) = drift_of(connection, "location-scan")
        (period,) = find_affected(connection, drift)
    return drift, period


def test_a_wrong_calibration_of_a_month_names_its_recordings(catalogue: FleetCatalogue) -> None:
    catalogue.add(ten_months((120, 150), by_calibration=True))
    catalogue.add(ten_months((0, 0), by_calibration=True, station="room-4"))
    with catalogue.reading() as connection:
        wrong, right = drift_of(connection, "location-scan")
        assert right.changes == ()
        assert find_affected(connection, right) == []
        (period,) = find_affected(connection, wrong)
        (doubt,) = find_calibration_doubts(connection, "room-3")
        assert find_calibration_doubts(connection, "room-4") == []
    assert (doubt.calibration_id, doubt.quantity) == ("cal-4", "location-scan")
    assert (doubt.is_wrong, doubt.size) == (True, period.size)
    assert period.station == "room-3"
    assert period.calibration_ids == ("cal-4",)
    assert ids_of(period.recordings) == scans_of(120, 150)
    assert period.possible == ()
    assert period.change is not None
    assert period.ended is not None
    assert day_of(period.change.earliest) < 120 <= day_of(period.change.latest)
    assert day_of(period.ended.earliest) < 150 <= day_of(period.ended.latest)
    assert abs(period.change.size - 12.0) < 4 * period.change.standard_uncertainty


def test_a_change_that_no_calibration_explains_is_bounded(catalogue: FleetCatalogue) -> None:
    catalogue.add(ten_months((103, 300), by_calibration=False))
    with catalogue.reading() as connection:
        (drift,) = drift_of(connection, "location-scan", ["room-3"])
        (period,) = find_affected(connection, drift)
    assert (period.ended, period.calibration_ids) == (None, ())
    sure, possible = set(ids_of(period.recordings)), set(ids_of(period.possible))
    affected = set(scans_of(103, 300))
    assert sure <= affected
    assert affected <= sure | possible
    assert len(possible) <= 14


def test_two_wrong_calibrations_in_a_row_name_their_recordings(catalogue: FleetCatalogue) -> None:
    more_um = [0.0, 0.0, 0.0, 12.0, 6.0, 0.0, 0.0, 0.0, 0.0, 0.0]
    catalogue.add(ten_months((0, 0), by_calibration=True, more_um=more_um))
    _, period = only_period(catalogue)
    assert period.calibration_ids == ("cal-3", "cal-4")
    assert ids_of(period.recordings) == scans_of(90, 150)
    assert period.ended is not None


@pytest.mark.parametrize("by_calibration", [True, False])
def test_a_wrong_first_month_is_named(catalogue: FleetCatalogue, by_calibration: bool) -> None:
    catalogue.add(ten_months((0, 30), by_calibration))
    drift, period = only_period(catalogue)
    with catalogue.reading() as connection:
        (chosen,) = drift_of(connection, "location-scan", right_since=START)
        (later,) = find_affected(connection, chosen)
    assert present(drift.history.right).because == "most"
    assert period.change is None
    first, sure = set(scans_of(0, 30)), set(ids_of(period.recordings))
    assert sure <= first <= sure.union(ids_of(period.possible))
    assert not by_calibration or sure == first
    assert not first.intersection(ids_of(later.recordings))
    assert len(later.recordings) >= 265


def test_own_errors_of_calibrations_name_no_recording(catalogue: FleetCatalogue) -> None:
    for seed in range(1, 6):
        own_um = np.random.default_rng(seed).normal(0, 3.0, 10).tolist()
        catalogue.add(ten_months((0, 0), True, f"room-{seed}", own_um))
    with catalogue.reading() as connection:
        for drift in drift_of(connection, "location-scan"):
            assert find_affected(connection, drift) == [], drift.station


def test_a_doubtful_calibration_names_what_would_be_affected(catalogue: FleetCatalogue) -> None:
    own_um = np.random.default_rng(2).normal(0, 3.0, 10)
    own_um[4] = own_um.mean() + 15.0
    catalogue.add(ten_months((0, 0), True, more_um=own_um.tolist()))
    with catalogue.reading() as connection:
        (drift,) = drift_of(connection, "location-scan")
        assert find_affected(connection, drift) == []
        (doubted,) = find_doubted(connection, drift)
        (doubt,) = find_calibration_doubts(connection, "room-3")
    assert (doubt.calibration_id, doubt.is_wrong) == ("cal-4", False)
    assert doubted.calibration_id == "cal-4"
    assert ids_of(doubted.recordings) == scans_of(120, 150)


@pytest.mark.slow
@pytest.mark.parametrize("seed", usual([1, 2], 1, pytest.mark.soak))
def test_a_planted_month_is_found_among_invented_stations(seed: int, tmp_path: object) -> None:
    begin, end = START + 120 * DAY, START + 150 * DAY
    step = PlantedStep("room-2", begin, end, 14.0)
    entries = invent_entries(3, 9000, seed, timedelta(hours=2.4), [step])
    with FleetCatalogue(f"sqlite:///{tmp_path}/catalogue.db") as catalogue:
        catalogue.add(list(entries))
        with catalogue.reading() as connection:
            drifts = drift_of(connection, "location-scan")
            found = [one for drift in drifts for one in find_affected(connection, drift)]
    (period,) = found
    assert period.station == "room-2"
    assert period.change is not None
    assert period.change.earliest <= begin <= period.change.latest
    assert period.ended is not None
    assert period.ended.earliest <= end <= period.ended.latest


def test_a_test_without_calibration_is_assigned_by_its_hash(catalogue: FleetCatalogue) -> None:
    hashed = [
        replace(
            entry,
            calibration_id="" if entry.kind == "performance" else entry.calibration_id,
            calibration_sha256="" if entry.kind == "scan" else f"{entry.calibration_id:0<64}",
        )
        for entry in ten_months((120, 150), by_calibration=True)
    ]
    catalogue.add(hashed)
    assert only_period(catalogue)[1].calibration_ids == ("cal-4",)


def test_a_part_with_a_longer_number_is_another_one(catalogue: FleetCatalogue) -> None:
    named = {"a": "Housing 4711", "b": "Housing 471152", "c": "4711-B", "d": "Cover 471152"}
    catalogue.add([entry_of(id=one, label=label) for one, label in named.items()])

    def found(text: str) -> list[str]:
        with catalogue.reading() as connection:
            return sorted(one.recording.id for one in find_calibrations(connection, text))

    assert found("4711") == ["a", "c"]
    assert found("housing 4711") == ["a"]
    assert found("4711 hous") == ["a", "b"]
    assert found("47115") == ["b", "d"]


def test_the_calibration_in_use_when_a_part_was_scanned(catalogue: FleetCatalogue) -> None:
    catalogue.add(ten_months((0, 0), by_calibration=True))
    with catalogue.reading() as connection:
        (used,) = find_calibrations(connection, "part 4711")
        assert search(connection, SearchQuery(text="part 4711"))[0].entry == used.recording
    assert (used.recording.id, present(used.calibration).id) == ("scan-11", "cal-0")
    assert present(used.newest).id == "cal-9"


def test_a_calibration_that_becomes_known_later_is_added(catalogue: FleetCatalogue) -> None:
    catalogue.add([entry_of(id="cal", kind="calibration"), entry_of(id="a", calibration_id="")])
    catalogue.add([entry_of(id="a", calibration_id="cal")])
    catalogue.add([entry_of(id="a", calibration_id="")])
    with catalogue.reading() as connection:
        (found,) = find_calibrations(connection, "a")
    assert found.recording.calibration_id == "cal"
    assert found.calibration is not None
