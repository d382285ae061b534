"""``crenel bench boards``: sets of real pictures beside OpenCV's finders."""

from pathlib import Path

import pytest

from app.bench.metrology.real_boards import run, table
from app.errors import OperationError
from app.metrology.targets.chessboard import Chessboard
from tests.datasheets import write_object

pytestmark = pytest.mark.soak


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
