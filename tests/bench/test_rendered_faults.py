"""Faults planted on the rendered station show by the size that geometry says."""

import pytest

from tests.bench.metrology.rendered_faults import FaultTests, PlantedFaultRow, table
from tests.bench.metrology.rendered_sphere import RenderedStation

pytestmark = pytest.mark.soak


@pytest.fixture(scope="module")
def tests(tmp_path_factory: pytest.TempPathFactory) -> FaultTests:
    station = RenderedStation(width_px=640, height_px=512, frames=40)
    return FaultTests(station, tmp_path_factory.mktemp("tests"))


def show(*rows: PlantedFaultRow, within_um: float) -> None:
    for row in rows:
        assert row.found == pytest.approx(row.expected, abs=within_um), row


def test_a_wrong_probe_matrix_shows_in_location_and_is_implied(tests: FaultTests) -> None:
    location, size, touched, implied = tests.matrix_rows(0)
    # the location without the fault is the noise of five centres
    show(location, within_um=location.without)
    assert location.found > 4 * location.without
    show(size, within_um=3.0)
    show(touched, within_um=0.01)
    show(implied, within_um=3 * 1.7)
    assert len(table([location, implied])) == 2


def test_a_worn_tip_shows_in_the_touched_size_alone(tests: FaultTests) -> None:
    show(*tests.tip_rows(), within_um=0.1)


def test_outliers_show_in_dispersion_and_form(tests: FaultTests) -> None:
    dispersion, form, size = tests.outlier_rows()
    show(dispersion, form, within_um=4.0)
    assert dispersion.found > 1.15 * dispersion.without
    show(size, within_um=3.0)


def test_a_moved_sphere_gives_no_figures(tests: FaultTests) -> None:
    [moved] = tests.movement_rows()
    show(moved, within_um=5.0)


def test_a_wrong_link_shows_in_the_location_of_the_touches(tests: FaultTests) -> None:
    length, location, size = tests.link_rows()
    assert abs(length.found) > 1.3 * abs(length.without)
    show(location, within_um=location.without)
    assert location.found > 2 * location.without
    show(size, within_um=3.0)
