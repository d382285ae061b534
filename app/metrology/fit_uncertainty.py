"""Standard uncertainty of a fitted shape's parameters, by the scatter of the scan itself.

Points of one frame share the frame's own error, and neighbouring frames share the arm's;
taken for independent, a million points would promise nanometres. So the points are taken
together in runs of consecutive frames, and the covariance is the one of clustered
residuals (Liang and Zeger, 1986): what one run pulls at the parameters is independent
only of what another pulls.
"""

import numpy as np
from numpy.typing import NDArray

from app.metrology.frames import Floats

MOST_RUNS = 12
FEWEST_RUNS = 10


def parameter_covariance(
    jacobian: Floats, residuals: Floats, frame: NDArray[np.int64]
) -> Floats | None:
    """Covariance (p, p) of least-squares parameters, k = 1.

    Args:
        jacobian: (N, p) change of the residuals with the parameters.
        residuals: (N,) at the least-squares solution.
        frame: (N,) which frame each point came from, numbered in the order of time.

    Returns:
        None where too few frames took part to tell.
    """
    numbers, of_frame = np.unique(frame, return_inverse=True)
    parameters = jacobian.shape[1]
    runs = min(MOST_RUNS, len(numbers))
    if runs < max(FEWEST_RUNS, parameters + 2):
        return None
    # of about equally many points each
    points_before = np.concatenate([[0], np.cumsum(np.bincount(of_frame))[:-1]])
    run_of_frame = np.minimum(points_before * runs // len(residuals), runs - 1)
    run = np.unique(run_of_frame, return_inverse=True)[1][of_frame]
    runs = int(run.max()) + 1
    if runs < max(FEWEST_RUNS, parameters + 2):
        return None
    pull = np.column_stack([np.bincount(run, column * residuals, runs) for column in jacobian.T])
    inverse = np.linalg.inv(jacobian.T @ jacobian)
    # a parameter each makes the scatter of the runs look smaller than it is
    return np.asarray(runs / (runs - parameters) * (inverse @ (pull.T @ pull) @ inverse))
