"""The browser's types of the 3D view and the station's shapes are the same."""

import pytest

from app.station import distance, fits, painter, viewing
from tests.api import test_types

SHAPES: dict[str, type] = {
    "Legend": painter.Legend,
    "ShownScan": viewing.ShownScan,
    "Figure": fits.Figure,
    "Fitted": fits.Fitted,
    "Distance": distance.Distance,
    "ViewState": viewing.ViewState,
}


@pytest.fixture
def interfaces(monkeypatch: pytest.MonkeyPatch) -> dict[str, str]:
    monkeypatch.setattr(test_types, "TYPES", (test_types.API / "viewTypes.ts",))
    return test_types.interfaces()


def test_every_interface_has_its_shape(interfaces: dict[str, str]) -> None:
    assert set(interfaces) == set(SHAPES)


@pytest.mark.parametrize("name", SHAPES)
def test_a_shape_has_the_fields_of_its_interface(name: str, interfaces: dict[str, str]) -> None:
    test_types.assert_same(SHAPES[name], interfaces[name])
