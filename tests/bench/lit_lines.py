"""How laser lines are found by their colour in lit rooms: lines painted on pictures of rooms.

    python -m tests.bench lit-lines FOLDER [--half unseen] [--seed 0] [--each] [--json]

The folder has pictures of rooms without a laser line, in it or in folders below. A line is painted
on each room as it is, and on the same room with coloured paper, wood, skin and cables and another
white balance: red, green or blue, 3 to 30 pixels wide, with gaps and steps, of any strength up to
one that clips to white, with noise, mostly as JPEG. Nothing is said of the line. Rooms in turn
belong to the half that was looked at while the search was made, and to the other.

A column is found with a point within a quarter of the line's width (2 px, if that is more), of
those in which the line rises by at least 18 grey levels and three times the noise. A point is false
if it lies further off than half the width (3 px), or in a gap. ``error_by_stated`` is the middle
picture's median error of the points on the line, over that of normal errors of the stated standard
deviation. The rooms without a line have no
cables: a bright thin thing of one colour across a picture is taken for one.
"""

from dataclasses import asdict, dataclass
from pathlib import Path

import numpy as np
from numpy.typing import NDArray

from crenel.metrology.robust import sigma_from_median
from crenel.metrology.stripe import ANYWHERE, Stripe
from crenel.metrology.transforms import Floats
from crenel.workflows.pictures.colour_pictures import extract_by_colour
from tests.bench.rows import bench_parser, measured_rows
from tests.bench.stripe.lit_rooms import PaintedLine, Picture, furnish, paint_line, read_rooms

HALVES = ("seen", "unseen")
FOUND_WIDTHS, FOUND_PX, FALSE_WIDTHS, FALSE_PX = 0.25, 2.0, 0.5, 3.0
WHOLE = 0.95


@dataclass
class Tally:
    """What was found in the pictures of one kind."""

    pictures: int = 0
    whole: int = 0
    columns: int = 0
    found: int = 0
    false: int = 0
    width_px: int = 0
    error_by_stated: float = float("nan")


def main() -> None:
    parser = bench_parser(__doc__)
    parser.add_argument("folder", type=Path)
    parser.add_argument("--half", choices=HALVES, default="unseen")
    parser.add_argument("--each", action="store_true", help="also state each picture")
    parser.add_argument("--lines", type=int, default=1, help="per room and kind")
    parser.add_argument("--seed", type=int, default=0, help="other lines have other seeds")
    given = parser.parse_args()
    rooms = [room for _, room in read_rooms(given.folder)][HALVES.index(given.half) :: 2]
    with measured_rows(given.json) as rows:
        for kind in ("as they are", "furnished", "without a line", "furnished, without a line"):
            tally, ratios = Tally(), list[float]()
            for number, room in enumerate(rooms):
                for line in range(given.lines):
                    seed = given.seed + 1000 * line + 2 * number + HALVES.index(given.half)
                    said = _measure(room, kind, seed, tally, ratios)
                    if given.each:
                        rows.say(f"{number} {said}")
            if ratios:
                tally.error_by_stated = float(np.median(ratios))
            rows.add(kind, asdict(tally))


def _measure(room: Picture, kind: str, seed: int, tally: Tally, ratios: list[float]) -> str:
    rng = np.random.default_rng(seed)
    has_line = "without" not in kind
    scene = furnish(room, rng, has_line) if "furnished" in kind else room
    tally.pictures += 1
    tally.width_px += scene.shape[1]
    if not has_line:
        stripe = _extract(scene)
        tally.false += 0 if stripe is None else len(stripe.u)
        return f"{0 if stripe is None else len(stripe.u)} points"
    line = paint_line(scene, rng)
    stripe = _extract(line.picture)
    found, false = compare(stripe, line)
    if stripe is not None and found:
        ratios.append(error_by_stated(stripe, line))
    columns = int(line.visible.sum())
    tally.columns += columns
    tally.found += found
    tally.false += false
    tally.whole += found >= WHOLE * columns
    return f"{line.colour} {line.width_px:g} px: {found} of {columns}, {false} false"


def _extract(picture: Picture) -> Stripe | None:
    found = extract_by_colour(picture, "u", ANYWHERE, None)
    return None if found is None else found.found.stripe


def compare(stripe: Stripe | None, line: PaintedLine) -> tuple[int, int]:
    """In how many of the visible columns the line was found, and how many points are false."""
    if stripe is None:
        return 0, 0
    at = np.rint(stripe.u).astype(int)
    off_px = np.abs(stripe.v - line.rows[at])
    on = _on_line(off_px, line)
    near = off_px <= max(FALSE_PX, FALSE_WIDTHS * line.width_px)
    return int((on & line.visible[at]).sum()), int((~near).sum())


def error_by_stated(stripe: Stripe, line: PaintedLine) -> float:
    """The median error of the points on the line, over what their stated deviations let expect."""
    off_px = np.abs(stripe.v - line.rows[np.rint(stripe.u).astype(int)])
    on = _on_line(off_px, line)
    return sigma_from_median(off_px[on] / stripe.sigma_px[on])


def _on_line(off_px: Floats, line: PaintedLine) -> NDArray[np.bool_]:
    return np.asarray(off_px <= max(FOUND_PX, FOUND_WIDTHS * line.width_px))


if __name__ == "__main__":
    main()
