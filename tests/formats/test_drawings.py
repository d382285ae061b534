"""The drawing and the solid of a designed block, as other programs read them."""

import re
from collections import Counter
from dataclasses import replace
from pathlib import Path
from typing import Any

import numpy as np
import pypdfium2
import pytest
from ezdxf.filemanagement import readfile

from crenel.formats.drawings.dxf import write_dxf
from crenel.formats.drawings.step import write_step
from crenel.formats.drawings.stl import write_stl
from crenel.messages.catalogue import renderer
from crenel.metrology.design.expected_accuracy import ExpectedAccuracy
from crenel.metrology.design.making_tolerance import ToleranceEffect
from crenel.metrology.design.propose_block import BlockDesign
from crenel.metrology.design.stripe_sensor import StripeSensor
from crenel.metrology.targets.crenellated_block import Crenellated
from crenel.report.printed.drawing_pdf import drawing_pdf
from crenel.workflows.design.block_drawing import draw_block, edge_break_mm

X = (-21.0, -9.0, 1.0, 9.5, 16.0, 21.0)
BLOCK = Crenellated("Block 7", "", X, -10.0, 16.0, 16.0, 0.0, -11.0, 0.002)
ACCURACY = ExpectedAccuracy(1, 10.0, ())
DESIGN = BlockDesign(
    StripeSensor(55.0, 115.0, 20.0, 1280, 1024),
    BLOCK,
    ACCURACY,
    ACCURACY,
    (ToleranceEffect(None, 10.0, 5.0),),
    0.01,
)
SIZES = [12.0, 22.0, 30.5, 37.0, 42.0, 11.0, 16.0, 27.0, 26.0]


def test_the_solid_is_closed_and_has_the_blocks_volume(tmp_path: Path) -> None:
    write_stl(tmp_path / "block.stl", BLOCK)
    content = (tmp_path / "block.stl").read_bytes()
    count = int(np.frombuffer(content[80:84], "<u4")[0])
    kind = np.dtype([("normal", "<f4", 3), ("corners", "<f4", (3, 3)), ("rest", "<u2")])
    triangles = np.frombuffer(content[84:], kind)["corners"].astype(float)
    assert len(triangles) == count
    sides = Counter((tuple(one[i]), tuple(one[(i + 1) % 3])) for one in triangles for i in range(3))
    assert set(sides.values()) == {1}
    assert all((b, a) in sides for a, b in sides)
    a, b, c = triangles.swapaxes(0, 1)
    volume = np.sum(a * np.cross(b, c)) / 6
    assert volume == pytest.approx(26.0 * (42.0 * 27.0 - (10.0 + 6.5) * 16.0))


def test_the_faces_of_the_step_solid_close_about_the_blocks_volume(tmp_path: Path) -> None:
    write_step(tmp_path / "block.step", replace(BLOCK, name="Blöck '7"))
    text = (tmp_path / "block.step").read_text("ascii")
    assert "PRODUCT('Bl\\X4\\000000F6\\X0\\ck ''7'" in text
    entities = dict(re.findall(r"^(#\d+)=(.*);$", text, re.M))
    assert set(re.findall(r"#\d+", text)) == set(entities)

    def inside(number: str) -> list[str]:
        return re.findall(r"#\d+", entities[number])

    def numbers(number: str) -> np.ndarray:
        return np.array([float(one) for one in re.findall(r"-?\d+\.\d*", entities[number])])

    used: Counter[tuple[str, bool]] = Counter()
    vertices, volume = set(), 0.0
    faces = [number for number, content in entities.items() if content.startswith("ADVANCED_FACE")]
    for face in faces:
        bound, plane = inside(face)
        corners = []
        ends: list[str] = []
        for oriented in inside(inside(bound)[0]):
            (edge,), forward = inside(oriented), entities[oriented].endswith(".T.)")
            used[edge, forward] += 1
            start, end = inside(edge)[:2][:: 1 if forward else -1]
            assert not ends or ends[-1] == start
            ends.append(end)
            vertices.add(start)
            corners.append(numbers(inside(start)[0]))
        a, others = corners[0], np.array(corners[1:])
        area = np.sum(np.cross(others[:-1] - a, others[1:] - a), axis=0) / 2
        at, normal, _ = (numbers(one) for one in inside(inside(plane)[0]))
        np.testing.assert_allclose(area, np.linalg.norm(area) * normal, atol=1e-9)
        np.testing.assert_allclose((np.array(corners) - at) @ normal, 0.0, atol=1e-9)
        volume += float(a @ area) / 3
    assert set(used.values()) == {1}
    assert all((edge, not forward) in used for edge, forward in used)
    assert len(vertices) - len(used) // 2 + len(faces) == 2
    assert volume == pytest.approx(26.0 * (42.0 * 27.0 - (10.0 + 6.5) * 16.0))


def measure(dimension: Any) -> float:
    """The length that a dimension says; the library does not type its entities."""
    return float(dimension.get_measurement())


def test_the_dxf_has_true_dimensions(tmp_path: Path) -> None:
    write_dxf(tmp_path / "block.dxf", draw_block(DESIGN), renderer("de"))
    document = readfile(tmp_path / "block.dxf")
    assert not document.audit().errors
    space = document.modelspace()
    assert [measure(one) for one in space.query("DIMENSION")] == pytest.approx(SIZES)
    assert any("Maßstab 2 : 1" in one.dxf.text for one in space.query("TEXT"))


def test_the_pdf_is_to_scale_and_states_sizes_and_tolerances() -> None:
    content = drawing_pdf(draw_block(DESIGN), "en")
    assert content == drawing_pdf(draw_block(DESIGN), "en")
    page = pypdfium2.PdfDocument(content)[0]
    text = page.get_textpage().get_text_range()
    assert all(f"{size:.2f}" in text for size in SIZES)
    assert "± 0.01 mm" in text
    assert edge_break_mm(DESIGN) == 0.01
    assert "Scale 2 : 1" in text
    # the block's base is the longest line within the frame
    dark = np.asarray(page.render(scale=300 / 72).to_pil().convert("L"))[150:-150, 150:-150] < 100
    run = max(len(row) for line in dark for row in "".join("#" if d else " " for d in line).split())
    assert run * 25.4 / 300 == pytest.approx(2 * 42.0, abs=0.7)
