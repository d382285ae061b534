"""Boards with both lights in one picture, the line 50 to 150 grey levels above white.

    python -m tests.bench lit-boards [SESSIONS] [--first SEED] [--json]

Every session has its own camera, board, line and robot. It is calibrated by its pictures as
``lighting: both`` is; its errors over the measuring volume are compared with what it claims.
"""

import numpy as np

from crenel.errors import OperationError
from crenel.metrology.adjustment.board.calibrate import calibrate_board, observe_board
from crenel.metrology.adjustment.board.problem import BoardInputs
from tests.bench.lit_board_sessions import LitSession, draw_lit_session
from tests.bench.rows import bench_parser, measured_rows, rms


def main() -> None:
    parser = bench_parser(__doc__)
    parser.add_argument("sessions", type=int, nargs="?", default=20)
    parser.add_argument("--first", type=int, default=0)
    asked = parser.parse_args()
    ratios: list[float] = []
    with measured_rows(asked.json) as rows:
        for seed in range(asked.first, asked.first + asked.sessions):
            session = draw_lit_session(seed)
            try:
                error_um, claimed_um, lines = measure(session)
            except OperationError as refusal:
                rows.say(f"session {seed} is refused: {refusal.line}")
                continue
            ratios.append(error_um / claimed_um)
            figures = {"error, µm": error_um, "claimed, µm": claimed_um, "lines": lines}
            rows.add(f"session {seed}", figures | {"pictures": len(session.T_cam_obj)})
        found = {"sessions": asked.sessions, "calibrated": len(ratios)}
        rows.add("all", found | {"error / claimed": rms(np.array(ratios)) if ratios else np.nan})


def measure(session: LitSession) -> tuple[float, float, int]:
    """Observed and claimed error in µm, and in how many pictures the line was found."""
    seen = tuple(
        observe_board(number, session.board, image, None, session.axis)
        for number, image in enumerate(session.pictures(), 1)
    )
    size = session.camera.width_px, session.camera.height_px
    found = calibrate_board(BoardInputs(session.arm, session.board, seen, session.readings, size))
    error_um = rms(session.errors_um(found))
    return error_um, found.uncertainty.total_um, sum(len(one.stripe.u) > 0 for one in seen)


if __name__ == "__main__":
    main()
