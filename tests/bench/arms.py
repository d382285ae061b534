"""Identification of simulated arms: their error over the volume before and after.

python -m tests.bench arms [--arms 30] [--json]
"""

import numpy as np

from crenel.metrology.arm.identification.identify import identify
from tests.bench.rows import bench_parser, measured_rows
from tests.metrology.arm_sessions import collect_observations, nominal_arm, volumetric_error_um
from tests.simulated_arm_sessions import ArmSessionPlan, draw_arm_session

FIRST_SEED = 100


def errors_um(seed: int) -> tuple[float, float]:
    """Rms on poses outside the fit: of the datasheet's arm, and of the identified one."""
    session = draw_arm_session(seed, ArmSessionPlan(joints=6 + seed % 2))
    arm = nominal_arm(session.nominal_arm)
    result = identify(arm, collect_observations(session))
    return volumetric_error_um(session.arm, arm), volumetric_error_um(session.arm, result.arm)


def main() -> None:
    parser = bench_parser(__doc__)
    parser.add_argument("--arms", type=int, default=30)
    given = parser.parse_args()
    found = np.array([errors_um(FIRST_SEED + number) for number in range(given.arms)])
    with measured_rows(given.json) as rows:
        for name, of in (("median", np.median), ("worst", np.max)):
            before, after = of(found, axis=0)
            rows.add(name, {"before, µm": before, "after, µm": after})


if __name__ == "__main__":
    main()
