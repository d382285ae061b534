"""The drawing and the solid of a designed block, as other programs read them."""

from collections import Counter
from pathlib import Path
from typing import Any

import numpy as np
import pypdfium2
import pytest
from ezdxf.filemanagement import readfile

from crenel.formats.drawings.dxf import write_dxf
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
