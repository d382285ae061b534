"""The real pictures beside the checkout, laid out as ``python -m tests.bench real`` wants them."""

import json
from pathlib import Path

BOARDS = {"opencv-stereo": (9, 6), "carnd": (9, 6), "wide": (8, 6)}
"""Inner corners. The size of the squares is not known and changes no figure."""
LINES = {
    "calib1": "robot-laser-chessboard/calib1",
    "calib3": "robot-laser-chessboard/calib3",
    "weld": "lines/weld",
}
PICTURES = (".png", ".jpg", ".jpeg", ".bmp")
SQUARE_MM = 25.0


def lay_out(real: Path, folder: Path) -> None:
    """Links to the pictures in a new folder, each set with its board."""
    for name, corners in BOARDS.items():
        place = _link(real / "boards" / name, folder / "boards" / name)
        board = {"name": name, "serial_number": "", "kind": "chessboard"}
        squares = {"inner_corners": corners, "square_mm": SQUARE_MM}
        document = {"format": "crenel/object", "version": 1, **board, **squares}
        (place / "object.json").write_text(json.dumps(document))
    for name, source in LINES.items():
        _link(real / source, folder / "lines" / name)


def _link(source: Path, place: Path) -> Path:
    place.mkdir(parents=True)
    for path in source.iterdir():
        if path.suffix.lower() in PICTURES:
            (place / path.name).symlink_to(path.resolve())
    return place
