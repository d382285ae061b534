"""The benchmarks of the detection, on blocks and on sets of boards, judge as they say."""

from dataclasses import replace
from pathlib import Path

import numpy as np
import pytest

from crenel.errors import OperationError
from crenel.metrology.targets.chessboard import Chessboard
from crenel_hardware.simulator.rendering.degradations import DegradedImage, draw_degraded_image
from tests.bench.metrology.detection import (
    DetectionBench,
    block_certificate,
    corner_errors,
    detect_block,
    search_image,
    search_wrong_certificate,
)
from tests.bench.metrology.real_boards import run, table
from tests.datasheets import write_object

pytestmark = pytest.mark.soak

SEED = 3


@pytest.fixture(scope="module")
def shot() -> DegradedImage:
    return draw_degraded_image(SEED)


def test_a_found_block_is_right_and_one_elsewhere_is_wrong(shot: DegradedImage) -> None:
    assert search_image(shot, SEED).outcome == "right"
    aside = replace(shot.optics, cx_px=shot.optics.cx_px + 2.0)
    assert search_image(replace(shot, optics=aside), SEED).outcome == "wrong"


def test_errors_are_those_of_the_corners(shot: DegradedImage) -> None:
    found = detect_block(shot, block_certificate(shot.certificate))
    errors, _ = corner_errors(found, shot)
    aside = replace(shot.optics, cx_px=shot.optics.cx_px - 2.0)
    moved, sigmas = corner_errors(found, replace(shot, optics=aside))
    assert np.allclose(moved - errors, [2.0, 0.0])
    assert sigmas.min() > 3.0


def test_the_table_counts_every_picture(shot: DegradedImage) -> None:
    one = search_image(shot, SEED)
    refused = replace(one, outcome="object-unclear")
    bench = DetectionBench(
        [one, refused, replace(one, outcome="wrong")], [search_wrong_certificate(shot, SEED)]
    )
    assert (bench.right, bench.wrong, bench.wrongly_accepted) == (1, 1, 0)
    assert any(line.split()[:5] == ["all", "3", "33.3", "%", "1"] for line in bench.lines())
    assert "refused as object-unclear: 1" in bench.lines()
    figures = bench.figures()
    assert (figures["right"], figures["refused"], figures["wrong"]) == (1, 1, 1)
    assert figures["rms_px"] == one.rms_px
    assert DetectionBench([refused], []).figures()["rms_px"] is None


def test_shadows_that_run_along_hidden_sides_are_no_wrong_size() -> None:
    """A comb of one pitch, its crests as bright as its floors: they end where they should."""
    assert search_image(draw_degraded_image(5031), 5031).outcome == "right"


def test_a_narrow_merlon_s_wrong_side_is_found_amid_tool_marks() -> None:
    assert not search_wrong_certificate(draw_degraded_image(5111), 5111).accepted


def test_a_wrong_size_that_the_picture_hides_is_named() -> None:
    """Cut off by the frame, and faces alike: merlon 1's right side does not show."""
    found = search_wrong_certificate(draw_degraded_image(5137), 5137)
    assert found.wrongly_accepted
    assert found.named
    assert any("(1 of them with the remark" in line for line in DetectionBench([], [found]).lines())


def write_set(folder: Path, pictures: list[Path], columns: int, rows: int) -> None:
    folder.mkdir(parents=True)
    write_object(folder / "object.json", Chessboard("B", "1", (columns, rows), 25.0, 0.1))
    for path in pictures:
        (folder / path.name).symlink_to(path)


def test_a_set_is_counted_and_its_corners_are_compared(real: Path, tmp_path: Path) -> None:
    pictures = sorted((real / "boards" / "opencv-stereo").glob("left0[1-4].jpg"))
    write_set(tmp_path / "sets" / "stereo", pictures, 9, 6)
    (found,) = run(tmp_path / "sets")
    assert (found.name, found.pictures, found.wrong) == ("stereo", 4, 0)
    assert found.found == {"crenel": 4, "classic": 4, "sectors": 4}
    assert found.rms_px["crenel"] < min(found.rms_px["classic"], found.rms_px["sectors"])
    assert table([found])[0][:6] == ["stereo", "4", "4", "4", "4", "0"]


def test_corners_that_one_method_leaves_out_count_for_none(real: Path, tmp_path: Path) -> None:
    pictures = [real / "boards" / "wide" / f"GOPR00{number}.jpg" for number in (32, 38, 45, 48)]
    write_set(tmp_path / "sets" / "wide", pictures, 8, 6)
    (found,) = run(tmp_path / "sets")
    assert found.wrong == 0
    assert set(found.rms_px) == {"crenel", "classic", "sectors"}
    assert max(found.rms_px.values()) < 0.6


def test_what_is_no_folder_of_sets_is_refused(tmp_path: Path) -> None:
    with pytest.raises(OperationError, match=r"object\.json"):
        run(tmp_path)
    (tmp_path / "block").mkdir()
    (tmp_path / "block" / "object.json").write_text("{}")
    with pytest.raises(OperationError, match=r"object\.json"):
        run(tmp_path)
