"""What the station knows: what can be chosen, and what is said of all else."""

import json
from pathlib import Path

from app.files.objects import write_object
from app.guide.library import read_library
from app.metrology.chessboard.board import Chessboard
from app.metrology.crenellated import Crenellated
from app.strings.sentences import sentences_of


def test_a_chessboard_among_the_objects_is_told_how_it_is_used(
    tmp_path: Path, block: Crenellated
) -> None:
    folder = tmp_path / "objects"
    folder.mkdir()
    write_object(folder / "block.json", block)
    write_object(folder / "board.json", Chessboard("sheet 7", "", (7, 6), 10.0, 0.05))
    (folder / "damaged.json").write_text(json.dumps({"format": "crenel/object"}))
    library = read_library(tmp_path)
    assert list(library.objects) == ["block"]
    damaged, board = sorted(library.findings, key=lambda finding: finding.quality)
    assert damaged.remedy == "Correct or remove the file."
    assert board.quality == "neutral"
    assert board.text.startswith("sheet 7 is a flat chessboard")
    assert "crenel calibrate" in board.remedy
    assert not sentences_of("de").best(board.remedy).left
