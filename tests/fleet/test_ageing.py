"""How figures change with hours and temperature, and how much calibrations differ, is found."""

from dataclasses import replace
from datetime import timedelta
from typing import Any

import numpy as np
import pytest

from crenel.fleet.ageing import StationAgeing, ageing_of, spread_of
from crenel.fleet.catalogue.catalogue import FleetCatalogue
from crenel.fleet.catalogue.entry import CatalogueEntry
from tests.fleet.entries import START, entry_of, figure_of
from tests.present import present

pytestmark = pytest.mark.device

DAY = timedelta(days=1)
PER_1000_H, PER_K = 6.0, 1.5


def ageing_station(station: str, per_1000_h: float, per_k: float) -> list[CatalogueEntry]:
    """Six calibrations, each with a level of its own, and a verification on each second day."""
    rng = np.random.default_rng(len(station))
    found = []
    for number in range(6):
        accepted = START + 30 * DAY * number
        level, warm = float(rng.normal(30, 6)), 20.0 + float(rng.normal(0, 0.3))
        about: dict[str, Any] = {"station": station, "calibration_id": f"cal-{number}"}
        calibration = entry_of(
            kind="calibration",
            id=f"cal-{number}",
            at=accepted,
            temperature_c=warm,
            calibration_sha256=f"{number:064d}",
            figures=(figure_of(20.0 + number, "point-uncertainty", limit=60.0),),
            **about,
        )
        found.append(calibration)
        for day in range(1, 30, 2):
            warmer = float(rng.normal(0, 1.0))
            value = level + per_1000_h * day * 24 / 1000 + per_k * warmer
            check = entry_of(
                kind="verification",
                id=f"check-{number}-{day}",
                at=accepted + day * DAY,
                temperature_c=warm + warmer,
                figures=(figure_of(value + float(rng.normal(0, 0.5)), "gauge-offset"),),
                **about,
            )
            found.append(check)
    return found


def slopes_of(ageing: StationAgeing) -> tuple[float, float, float, float]:
    hours, kelvin = ageing.per_1000_h, ageing.per_kelvin
    assert hours is not None
    assert kelvin is not None
    return hours.value, hours.expanded_uncertainty, kelvin.value, kelvin.expanded_uncertainty


def test_ageing_is_found_where_it_is_and_nowhere_else(catalogue: FleetCatalogue) -> None:
    catalogue.add(ageing_station("room-1", PER_1000_H, PER_K))
    catalogue.add(ageing_station("room-22", 0.0, 0.0))
    with catalogue.reading() as connection:
        aged, steady = ageing_of(connection, "gauge-offset")
        (alone,) = ageing_of(connection, "gauge-offset", ["room-22"])
        (later,) = ageing_of(connection, "gauge-offset", ["room-1"], START + 60 * DAY)
    assert (aged.station, aged.since, aged.left_out) == ("room-1", "calibration", 0)
    assert len(aged.points) == 90
    assert aged.points[0].hours == pytest.approx(24.0)
    per_1000_h, hours_u, per_k, kelvin_u = slopes_of(aged)
    assert abs(per_1000_h - PER_1000_H) < 1.5 * hours_u < PER_1000_H
    assert abs(per_k - PER_K) < 1.5 * kelvin_u < PER_K
    assert not present(steady.per_1000_h).is_significant
    assert alone == steady
    assert len(later.points) == 60


def test_values_without_their_calibration_are_only_counted(catalogue: FleetCatalogue) -> None:
    entries = ageing_station("room-1", PER_1000_H, PER_K)
    for place, one in enumerate(entries):
        if one.kind == "verification":
            sha256 = f"{int(one.calibration_id[4:]):064d}"
            entries[place] = replace(one, calibration_id="", calibration_sha256=sha256)
    catalogue.add([one for one in entries if one.id != "cal-5"])
    with catalogue.reading() as connection:
        (found,) = ageing_of(connection, "gauge-offset")
    assert (len(found.points), found.left_out) == (75, 15)


def test_figures_of_calibrations_count_from_the_first_one(catalogue: FleetCatalogue) -> None:
    catalogue.add(ageing_station("room-1", PER_1000_H, PER_K))
    with catalogue.reading() as connection:
        (found,) = ageing_of(connection, "point-uncertainty")
        (spread,) = spread_of(connection, "point-uncertainty")
        assert spread_of(connection, "gauge-offset") == []
    assert found.since == "first"
    assert [one.hours for one in found.points] == [720.0 * number for number in range(6)]
    assert present(found.per_1000_h).value == pytest.approx(1 / 0.72)
    assert [one.value for one in spread.values] == [20.0, 21.0, 22.0, 23.0, 24.0, 25.0]
    assert (spread.station, spread.sensor_serial, spread.limit) == ("room-1", "L-3", 60.0)
    assert spread.median == 22.5
    assert spread.standard_deviation == pytest.approx(1.8708, abs=1e-4)


def test_each_sensor_of_a_station_is_listed(catalogue: FleetCatalogue) -> None:
    figures = (figure_of(20.0, "point-uncertainty"),)
    for number in (2, 1):
        serial = f"L-{number}"
        one = entry_of(number, kind="calibration", sensor_serial=serial, figures=figures)
        catalogue.add([one])
    with catalogue.reading() as connection:
        found = spread_of(connection, "point-uncertainty")
    assert [one.sensor_serial for one in found] == ["L-1", "L-2"]
    assert [one.standard_deviation for one in found] == [None, None]


def test_newest_values_count(catalogue: FleetCatalogue, monkeypatch: pytest.MonkeyPatch) -> None:
    """The oldest of them first, within the period."""
    monkeypatch.setattr("crenel.fleet.ageing.MOST_OF_STATION", 20)
    until = START + 100 * DAY
    entries = {name: ageing_station(name, 0.0, 0.0) for name in ("hall", "lab", "workshop")}
    catalogue.add([entry for own in entries.values() for entry in own])
    with catalogue.reading() as connection:
        found = ageing_of(connection, "gauge-offset", ["workshop", "hall"], START, until)
    assert [one.station for one in found] == ["hall", "workshop"]
    for one in found:
        checks = [entry for entry in entries[one.station] if entry.kind == "verification"]
        values = [(entry.at, entry.figures[0].value) for entry in checks if entry.at < until]
        assert [(point.at, point.value) for point in one.points] == sorted(values)[-20:]
