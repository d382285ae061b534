"""The browser's types of the arm's flows and the server's shapes are the same."""

import pytest

from app.guide.arm import state, view
from tests.api import test_types

SHAPES: dict[str, type] = {
    "JointSwing": view.JointSwing,
    "Artefact": state.Artefact,
    "SeatLine": view.SeatLine,
    "Before": view.Before,
    "ParameterLine": view.ParameterLine,
    "ArmResult": view.ArmResult,
    "ArmPicture": view.ArmPicture,
    "ArmView": view.ArmView,
    "ArmCheckSummary": view.ArmCheckSummary,
}


@pytest.fixture
def interfaces(monkeypatch: pytest.MonkeyPatch) -> dict[str, str]:
    monkeypatch.setattr(test_types, "TYPES", (test_types.API / "armTypes.ts",))
    return test_types.interfaces()


def test_every_interface_has_its_shape(interfaces: dict[str, str]) -> None:
    assert set(interfaces) == set(SHAPES)


@pytest.mark.parametrize("name", SHAPES)
def test_a_shape_has_the_fields_of_its_interface(name: str, interfaces: dict[str, str]) -> None:
    test_types.assert_same(SHAPES[name], interfaces[name])
