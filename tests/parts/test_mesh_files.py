"""Files of parts are read, or refused in one line; their surface is checked and mended."""

from collections.abc import Callable
from pathlib import Path

import numpy as np
import pytest
from typer.testing import CliRunner

from crenel.cli.main import cli
from crenel.errors import OperationError
from crenel.metrology.transforms import Floats
from crenel.parts.cad.evaluate_part import Part, read_part
from tests.parts.meshes import (
    box_corners,
    cylinder_corners,
    sphere_corners,
    stl_bytes,
    stl_text,
    write_stl,
)

SIZE_MM = np.array([140.0, 100.0, 20.0])
BOX = box_corners(SIZE_MM, 2)


def read(tmp_path: Path, content: bytes | str, name: str = "part.stl") -> Part:
    path = tmp_path / name
    path.write_bytes(content if isinstance(content, bytes) else content.encode())
    return read_part(path)


def ids(part: Part) -> set[str]:
    return {note.message_id for note in part.notes if hasattr(note, "message_id")}


@pytest.mark.parametrize(
    "content",
    [
        stl_bytes(BOX),
        stl_bytes(BOX, b"solid part".ljust(80)),
        stl_bytes(BOX, b"solid part\n facet normal".ljust(80)),
        stl_text(BOX),
        stl_text(BOX).replace("\n", "\r\n"),
        stl_text(BOX).replace("\n", "\r"),
        stl_text(BOX).upper(),
    ],
    ids=["binary", "solid", "solid-facet", "text", "crlf", "cr", "capitals"],
)
def test_each_form_of_stl_gives_the_same_part(tmp_path: Path, content: bytes | str) -> None:
    part = read(tmp_path, content)
    assert part.is_closed
    assert part.mesh.size_mm == pytest.approx(SIZE_MM)
    assert part.mesh.volume_mm3 == pytest.approx(280_000)
    assert part.chord_error_mm == 0.0
    assert ids(part) == {"part-without-unit"}


def spoil(change: Callable[[Floats], None]) -> bytes:
    corners = BOX.copy()
    change(corners)
    return stl_bytes(corners)


def turn_one(corners: Floats) -> None:
    corners[5] = corners[5, ::-1].copy()


def turn_all(corners: Floats) -> None:
    corners[:] = corners[:, ::-1].copy()


def put_nan(corners: Floats) -> None:
    corners[3, 1, 2] = np.nan


@pytest.mark.parametrize(
    ("content", "said"),
    [
        (spoil(turn_all), "part-normals-inward-turned"),
        (spoil(turn_one), "part-triangles-turned"),
        (spoil(put_nan), "part-triangles-not-numbers"),
        (stl_bytes(np.concatenate([BOX, BOX[:1, [0, 0, 1]]])), "part-triangles-without-area"),
        (stl_bytes(BOX[:-1]), "part-surface-open"),
    ],
)
def test_a_spoiled_surface_is_mended_as_far_as_it_can_be(
    tmp_path: Path, content: bytes, said: str
) -> None:
    part = read(tmp_path, content)
    assert said in ids(part)
    assert not part.mesh.edges.turned.any()
    middle_of_top = np.array([[10.0, 10.0, 10.5]])
    assert part.tree.closest(middle_of_top).distance_mm[0] == pytest.approx(0.5)


def test_open_edges_are_named_by_their_places(tmp_path: Path) -> None:
    part = read(tmp_path, stl_bytes(BOX[1:]))
    (note,) = (one for one in part.notes if "open" in str(one))
    ends = part.mesh.vertices_mm[part.mesh.edges.ends[part.mesh.edges.is_open]]
    x, y, z = ends[np.argmax(np.linalg.norm(ends[:, 1] - ends[:, 0], axis=1))].mean(axis=0)
    assert "3 edges" in str(note)
    assert f"longest at {x:.2f}, {y:.2f}, {z:.2f} mm".replace("-", "−") in str(note)


@pytest.mark.parametrize(
    ("content", "code", "said"),
    [
        (stl_bytes(BOX)[:-70], "mesh-cut-off", f"{len(BOX) - 2} of {len(BOX)} triangles"),
        (stl_bytes(BOX, announced=2**32 - 1), "mesh-cut-off", "of 4294967295 triangles"),
        (stl_text(BOX).replace(".", ","), "mesh-malformed", "line 4 have decimal commas"),
        (stl_text(BOX)[:-300], "mesh-malformed", "ends within a facet"),
        (stl_text(BOX).replace("vertex", "vertex one", 1), "mesh-malformed", "line 4"),
        (stl_bytes(1e10 * BOX), "mesh-too-far", "7e+11 mm"),
        (stl_bytes(BOX[:0]), "mesh-malformed", "no triangle"),
        (stl_bytes(BOX[:, [0, 0, 1]]), "mesh-malformed", "no triangle"),
        ("<!doctype html><html></html>", "mesh-format-unknown", "known format"),
        (b"", "mesh-format-unknown", "known format"),
    ],
)
def test_a_file_that_is_none_is_refused_in_one_line(
    tmp_path: Path, content: bytes | str, code: str, said: str
) -> None:
    with pytest.raises(OperationError) as refused:
        read(tmp_path, content)
    assert refused.value.code == code
    assert said in refused.value.line
    assert "\n" not in refused.value.line


def test_the_unit_is_stated_by_the_user_and_never_guessed(tmp_path: Path) -> None:
    path = write_stl(tmp_path / "inch.stl", BOX / 25.4)
    as_it_is, inch = read_part(path), read_part(path, "inch")
    assert as_it_is.mesh.size_mm == pytest.approx(SIZE_MM / 25.4)
    assert "part-without-unit" in ids(as_it_is)
    assert inch.mesh.size_mm == pytest.approx(SIZE_MM)
    assert not inch.notes


@pytest.mark.parametrize("segments", [24, 60])
def test_the_chord_error_of_facets_is_that_of_their_circle(tmp_path: Path, segments: int) -> None:
    sagitta = 15.0 * (1 - np.cos(np.pi / segments))
    bar = read(tmp_path, stl_bytes(cylinder_corners(15.0, 30.0, segments)))
    assert bar.chord_error_mm == pytest.approx(sagitta, rel=0.02)
    ball = read(tmp_path, stl_bytes(sphere_corners(15.0, segments)))
    middles = np.linalg.norm(ball.mesh.corners_mm.mean(axis=1), axis=1)
    assert 15.0 - middles.min() <= ball.chord_error_mm <= 2.5 * sagitta


def test_planes_at_a_small_angle_are_no_curved_surface(tmp_path: Path) -> None:
    corners = box_corners(SIZE_MM)
    corners[:, :, 2] += 0.08 * np.abs(corners[:, :, 0]) * (corners[:, :, 2] > 0)
    assert read(tmp_path, stl_bytes(corners)).chord_error_mm == 0.0


def test_the_command_says_what_the_file_holds(tmp_path: Path) -> None:
    path = write_stl(tmp_path / "part.stl", BOX)
    said = CliRunner().invoke(cli, ["part", str(path), "--unit", "mm"])
    assert said.exit_code == 0
    assert "140 × 100 × 20 mm" in said.output
    fields = CliRunner().invoke(cli, ["part", str(path), "--json"])
    assert '"closed": true' in fields.stdout
    path.write_bytes(path.read_bytes()[:-1])
    refused = CliRunner().invoke(cli, ["part", str(path)])
    assert refused.exit_code == 1
    assert len(refused.stderr.splitlines()) == 1
