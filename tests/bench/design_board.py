"""Boards to print: lengths in the PDF rasterised at 300 dpi, and how often pictures show them.

    python -m tests.bench design-board [--pictures 100] [--first 700] [--json]

Boards of random squares are designed; their page is rasterised, lengths on it are measured in the
pixels, and it is photographed by a virtual camera from random directions, with blur, noise and
uneven light. A picture counts as found if the corners lie where the page has them.
"""

import cv2
import numpy as np
import pypdfium2

from crenel.errors import OperationError
from crenel.metrology.chessboard.detect_board import detect_board
from crenel.metrology.targets.chessboard import Chessboard, corner_points
from crenel.metrology.transforms import Floats
from crenel.report.printed.board_pdf import BAR_MM, FOOT_MM, GAP_MM, MARGIN_MM, board_pdf
from crenel.workflows.design.board_files import plan_board
from tests.bench.rows import Rows, bench_parser, measured_rows

DPI = 300
PX_PER_MM = DPI / 25.4
PICTURE = (1280, 1024)
OFF_PX = 1.0
"""A corner that lies farther off the truth was not found."""


def random_board(rng: np.random.Generator) -> Chessboard:
    """A board for A4 to A3, half of them with markers."""
    squares = int(rng.integers(6, 13)), int(rng.integers(5, 10))
    side = float(rng.choice([8.0, 10.0, 12.5, 15.0, 20.0]))
    return plan_board("Board", squares, side, bool(rng.uniform() < 0.5))


def rasterise(board: Chessboard) -> Floats:
    """The page at 300 dpi, 0 (black) to 1."""
    page = pypdfium2.PdfDocument(board_pdf(board, "en"))[0]
    image = page.render(scale=DPI / 72).to_pil().convert("L")
    return np.asarray(image, dtype=np.float64) / 255


def ink_mm(profile: Floats) -> float:
    """Length of ink along a profile across something black: from its first to its last edge."""
    dark = 1 - profile
    rows = np.flatnonzero(dark > 0.5)
    first, last = int(rows[0]), int(rows[-1])
    # what the pixels beside the ends hold is the rest of the length
    whole = last - first - 1 + dark[first] + dark[last]
    rest = dark[max(first - 1, 0)] + (dark[last + 1] if last + 1 < len(dark) else 0.0)
    return float((whole + rest) / PX_PER_MM)


def length_errors_mm(board: Chessboard, page: Floats) -> dict[str, float]:
    """What the bar and the pattern measure on the page, less what they should be."""
    height = len(page)
    width_mm, height_mm = (board.square_mm * (count + 1) for count in board.inner_corners)
    left = (page.shape[1] / PX_PER_MM - width_mm) / 2
    low = MARGIN_MM + FOOT_MM + GAP_MM

    def row(mm: float) -> int:
        return round(height - mm * PX_PER_MM)

    bar = page[row(MARGIN_MM + 22.0 + 1.0), : round((MARGIN_MM + BAR_MM + 4) * PX_PER_MM)]
    # the whole width and height: over all rows, or columns, of squares
    squares = page[row(low + height_mm + 2) : row(low - 2)]
    area = squares[:, round((left - 2) * PX_PER_MM) : round((left + width_mm + 2) * PX_PER_MM)]
    line_mm = 0.2
    return {
        "bar": ink_mm(bar) - BAR_MM - line_mm,
        "width": ink_mm(area.min(axis=0)) - width_mm,
        "height": ink_mm(area.min(axis=1)) - height_mm,
    }


def take_picture(
    board: Chessboard, page: Floats, rng: np.random.Generator
) -> tuple[np.ndarray, Floats]:
    """A picture (H, W) of the page from a random direction, and its corners (N, 2)."""
    width_mm, height_mm = (board.square_mm * (count + 1) for count in board.inner_corners)
    left = (page.shape[1] / PX_PER_MM - width_mm) / 2
    origin = np.array([left, MARGIN_MM + FOOT_MM + GAP_MM]) + board.square_mm
    corners_mm = corner_points(board)[:, :2] + origin
    centre = corners_mm.mean(axis=0)
    tilt = rng.uniform(-0.5, 0.5, 2)
    turn = float(rng.uniform(-np.pi, np.pi)) if board.markers else float(rng.uniform(-0.6, 0.6))
    R, _ = cv2.Rodrigues(np.array([tilt[0], tilt[1], 0.0]))
    Z, _ = cv2.Rodrigues(np.array([0.0, 0.0, turn]))
    distance = 2.6 * float(np.hypot(width_mm, height_mm))
    focal = 0.78 * PICTURE[1] * distance / float(np.hypot(width_mm, height_mm))
    K = np.array([[focal, 0, PICTURE[0] / 2], [0, focal, PICTURE[1] / 2], [0, 0, 1.0]])
    # the page's Y points up, the picture's down
    pose = K @ np.column_stack([(R @ Z @ np.diag([1.0, -1.0, -1.0]))[:, :2], [0, 0, distance]])
    from_mm = pose @ np.array([[1, 0, -centre[0]], [0, 1, -centre[1]], [0, 0, 1.0]])
    to_mm = np.array(
        [[1 / PX_PER_MM, 0, 0.5 / PX_PER_MM], [0, -1 / PX_PER_MM, (len(page) - 0.5) / PX_PER_MM]]
    )
    H = from_mm @ np.vstack([to_mm, [0, 0, 1.0]])
    smooth = cv2.GaussianBlur(page, (0, 0), 0.5 * max(1.0, PX_PER_MM * distance / focal))
    shown = cv2.warpPerspective(smooth, H, PICTURE, flags=cv2.INTER_LINEAR, borderValue=0.55)
    bright = rng.uniform(0.75, 1.0, 2)
    light = np.linspace(float(bright[0]), float(bright[1]), PICTURE[0])[None, :]
    levels = 25 + 190 * shown * light + rng.normal(0.0, 2.0, shown.shape)
    seen = np.column_stack([corners_mm, np.ones(len(corners_mm))]) @ from_mm.T
    return np.clip(levels, 0, 255).astype(np.uint8), seen[:, :2] / seen[:, 2:]


def is_found(board: Chessboard, picture: np.ndarray, corners_px: Floats) -> bool:
    """Whether all corners are found, each where it is, in one of the numberings that are equal."""
    try:
        found = detect_board(picture, board)
    except OperationError:
        return False
    if len(found) < len(corners_px):
        return False
    return any(
        bool((np.linalg.norm(found.uv_px - corners_px[number], axis=1) < OFF_PX).all())
        for number in (found.number, *found.other_numbers)
    )


def measure_boards(pictures: int, first: int, rows: Rows) -> None:
    """A row of lengths, and one of pictures."""
    errors, found = [], 0
    for seed in range(first, first + pictures):
        rng = np.random.default_rng(seed)
        board = random_board(rng)
        page = rasterise(board)
        errors.append(length_errors_mm(board, page))
        ok = is_found(board, *take_picture(board, page, rng))
        found += ok
        if not ok:
            rows.say(f"{seed}: not found")
    worst = {name: max(abs(one[name]) for one in errors) for name in errors[0]}
    rows.add("largest error of a length, mm", worst)
    rows.add("pictures", {"found": found, "of": pictures})


def main() -> None:
    parser = bench_parser(__doc__)
    parser.add_argument("--pictures", type=int, default=100)
    parser.add_argument("--first", type=int, default=700)
    given = parser.parse_args()
    with measured_rows(given.json) as rows:
        measure_boards(given.pictures, given.first, rows)


if __name__ == "__main__":
    main()
