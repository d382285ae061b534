"""STEP becomes triangles in a process of its own; what is no STEP is refused in one line."""

from pathlib import Path

import numpy as np
import pytest

from crenel.errors import OperationError
from crenel.parts.cad import document_step
from crenel.parts.cad.evaluate_part import read_part

pytest.importorskip("OCP")
pytestmark = pytest.mark.device
RADIUS_MM = 3.0


def write_step(path: Path, bodies: int = 1) -> Path:
    """Balls beside each other."""
    from OCP.BRepPrimAPI import BRepPrimAPI_MakeSphere
    from OCP.gp import gp_Pnt
    from OCP.STEPControl import STEPControl_StepModelType, STEPControl_Writer

    writer = STEPControl_Writer()
    for number in range(bodies):
        ball = BRepPrimAPI_MakeSphere(gp_Pnt(40.0 * number, 0.0, 0.0), RADIUS_MM).Shape()
        writer.Transfer(ball, STEPControl_StepModelType.STEPControl_AsIs)
    writer.Write(str(path))
    return path


def test_triangles_are_within_their_chord_error_of_the_surface(tmp_path: Path) -> None:
    path = write_step(tmp_path / "ball.step")
    for tolerance, chord in ((None, 0.005), (0.04, 0.002)):
        part = read_part(path, tolerance_mm=tolerance)
        away = np.linalg.norm(part.mesh.vertices_mm, axis=1) - RADIUS_MM
        assert np.abs(away).max() < 1e-6
        middles = np.linalg.norm(part.mesh.corners_mm.mean(axis=1), axis=1)
        assert RADIUS_MM - middles.min() <= chord
        assert 0 < part.chord_error_mm <= 1.5 * chord
        assert part.is_closed
        assert part.unit == "mm"
        assert part.has_unit
        assert part.mesh.volume_mm3 > 0


def test_of_several_bodies_one_can_be_chosen(tmp_path: Path) -> None:
    path = write_step(tmp_path / "two.stp", 2)
    both, second = read_part(path), read_part(path, body=2)
    assert both.bodies == 2
    assert any("2 bodies" in str(note) for note in both.notes)
    assert second.mesh.middle_mm == pytest.approx([40.0, 0.0, 0.0], abs=0.01)
    with pytest.raises(OperationError, match="no body 3"):
        read_part(path, body=3)


@pytest.mark.parametrize("kept", [0.0, 0.3, 0.6])
def test_a_damaged_file_is_refused(tmp_path: Path, kept: float) -> None:
    path = write_step(tmp_path / "ball.step")
    content = path.read_bytes()
    path.write_bytes(b"ISO-10303-21;\nHEADER;\n" + content[500 : 500 + int(kept * len(content))])
    with pytest.raises(OperationError) as refused:
        read_part(path)
    assert refused.value.code == "step-unreadable"
    assert "\n" not in refused.value.line


def test_references_in_a_circle_are_refused(tmp_path: Path) -> None:
    path = tmp_path / "circle.step"
    path.write_text(
        "ISO-10303-21;\nHEADER;\nFILE_DESCRIPTION((''),'2;1');\n"
        "FILE_NAME('','',(''),(''),'','','');\nFILE_SCHEMA(('AUTOMOTIVE_DESIGN'));\nENDSEC;\n"
        "DATA;\n#1=SHELL_BASED_SURFACE_MODEL('',(#2));\n#2=OPEN_SHELL('',(#3));\n"
        "#3=FACE_SURFACE('',(#1),#2,.T.);\n#4=SHAPE_REPRESENTATION('',(#4,#1),#4);\n"
        "ENDSEC;\nEND-ISO-10303-21;\n"
    )
    with pytest.raises(OperationError) as refused:
        read_part(path)
    assert refused.value.code == "step-unreadable"


def test_a_page_named_step_is_refused(tmp_path: Path) -> None:
    path = tmp_path / "page.step"
    path.write_text("<!doctype html><html></html>")
    with pytest.raises(OperationError) as refused:
        read_part(path)
    assert refused.value.code == "mesh-format-unknown"


def test_a_file_that_takes_too_long_is_given_up(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    path = write_step(tmp_path / "ball.step")
    monkeypatch.setattr(document_step, "MOST_SECONDS", 0.01)
    with pytest.raises(OperationError, match="takes longer"):
        read_part(path)


def test_without_the_package_it_says_what_to_install(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    path = write_step(tmp_path / "ball.step")
    monkeypatch.setattr(document_step, "find_spec", lambda name: None)
    with pytest.raises(OperationError) as refused:
        read_part(path)
    assert "crenel[cad]" in refused.value.line
