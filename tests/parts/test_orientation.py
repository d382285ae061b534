"""Parallelism, perpendicularity and angularity of planted tilts."""

import json
from collections.abc import Iterator
from contextlib import contextmanager
from pathlib import Path

import numpy as np
import pytest

from crenel.errors import OperationError
from crenel.parts.document_program import DimensionPart, ProgramFile
from crenel.parts.maths.orientation import orientation_deviation
from crenel.parts.maths.shapes import Shape, frame_along
from tests.parts.bracket_program import write_program
from tests.parts.draws import first_setting

TILT_RAD = 1e-3


def plane(normal: tuple[float, float, float]) -> Shape:
    return Shape("plane", frame_along(np.array(normal), np.array([10.0, 5.0, 20.0])), np.zeros(0))


def axis(direction: tuple[float, float, float]) -> Shape:
    T = frame_along(np.array(direction), np.array([3.0, 4.0, 5.0]))
    return Shape("cylinder", T, np.array([6.0]))


CORNERS = np.array([[x, y, 20.0] for x in (0.0, 40.0) for y in (0.0, 10.0)])
UP = (0.0, 0.0, 1.0)


def test_a_plane_parallel_to_a_plane_is_the_range_of_its_corners() -> None:
    tilted = plane((TILT_RAD, 0.5 * TILT_RAD, 1.0))
    found = orientation_deviation(plane(UP), tilted, CORNERS, plane(UP), plane((0.0, 0.0, -1.0)))
    assert found == pytest.approx([TILT_RAD * 40 + 0.5 * TILT_RAD * 10], rel=1e-5)
    with_datum = orientation_deviation(plane(UP), tilted, CORNERS, plane(UP), tilted)
    assert with_datum == pytest.approx([0.0], abs=1e-9)


def test_an_axis_across_a_plane_is_a_cylinder_about_both_of_its_tilts() -> None:
    ends = np.array([[3.0, 4.0, 5.0], [3.0, 4.0, 35.0]])
    found = orientation_deviation(
        axis(UP), axis((3 * TILT_RAD, 4 * TILT_RAD, 1.0)), ends, plane(UP), plane(UP)
    )
    assert np.linalg.norm(found) == pytest.approx(30 * 5 * TILT_RAD, rel=1e-4)


def test_a_plane_at_an_angle_counts_only_the_tilt_towards_its_datum() -> None:
    side = np.array([[0.0, y, z] for y in (0.0, 50.0) for z in (0.0, 20.0)])
    wall = plane((-1.0, 0.0, 0.0))
    towards = orientation_deviation(wall, plane((-1.0, 0.0, TILT_RAD)), side, plane(UP), plane(UP))
    aside = orientation_deviation(wall, plane((-1.0, TILT_RAD, 0.0)), side, plane(UP), plane(UP))
    assert abs(towards) == pytest.approx([20 * TILT_RAD], rel=1e-5)
    assert aside == pytest.approx([0.0], abs=1e-9)


@contextmanager
def refused_with(said: str) -> Iterator[None]:
    """A program is refused with words that name its place."""
    with pytest.raises(OperationError) as caught:
        yield
    assert said in caught.value.line
    assert "'par'" in caught.value.line or "dimensions" in caught.value.line


def test_a_program_is_refused_without_datum_or_region(tmp_path: Path) -> None:
    setting, path = first_setting(), tmp_path / "program.json"
    write_program(path, setting.nominal, setting.true)
    document = json.loads(path.read_text())
    one = {"id": "par", "kind": "parallelism", "features": ["S"], "datums": ["A"], "upper": 0.05}
    document["dimensions"] = [one]
    path.write_text(json.dumps(document))
    (read,) = ProgramFile.read(path).dimensions
    assert isinstance(read, DimensionPart)
    one["datums"] = []
    path.write_text(json.dumps(document))
    with refused_with("needs one datum"):
        ProgramFile.read(path)
    one["datums"] = ["ball"]
    path.write_text(json.dumps(document))
    with refused_with("has no direction"):
        ProgramFile.read(path)
    one["datums"] = ["A"]
    for feature in document["features"]:
        if feature["id"] == "S":
            del feature["region"]
    path.write_text(json.dumps(document))
    with refused_with("needs a region"):
        ProgramFile.read(path)
