"""A covariance for the calibration of a simulated station, so that inspections have U."""

import json
from pathlib import Path

import numpy as np

from tests.parts.simulated_inspection import CAMERA_NAMES, LINK_AXES

LINKS_RAD, LINKS_MM = 1e-5, 5e-3


def add_covariance(calibration: Path) -> None:
    """Says how well sensor and arm are known."""
    document = json.loads(calibration.read_text())
    joints = len(json.loads((calibration.parent / "arm.json").read_text())["joints"])
    links = [f"link{n}_{axis}" for n in range(1, joints + 1) for axis in LINK_AXES]
    sds = [1e-3] * len(CAMERA_NAMES) + joints * [*(3 * [LINKS_RAD]), *(3 * [LINKS_MM])]
    document["covariance"] = {
        "parameters": [*CAMERA_NAMES, *links],
        "matrix": np.diag(np.square(sds)).tolist(),
        "pivot_mm": [0.0, 0.0, 0.0],
        "links": [0.0] * len(links),
    }
    document["scales"] = {
        "links_rad": LINKS_RAD,
        "links_mm": LINKS_MM,
        "reading_factor": 1.0,
        "touch_mm": 0.006,
    }
    calibration.write_text(json.dumps(document))
