"""Gauges scanned with a calibration from one pose: the errors against where they truly are.

python -m tests.bench gauges SAMPLES [--json]
"""

import json
import subprocess
import sys
import tempfile
from pathlib import Path
from typing import Any

from tests.bench.rows import bench_parser, measured_rows

CRENEL = (sys.executable, "-c", "from crenel.cli.main import main; main()")
GAUGES = {"plane": "plane", "plane_tilted": "plane", "sphere": "sphere"}
VALUES = ("angle_arcsec", "offset_error_um", "radius_error_um", "centre_error_um")


def crenel(*words: object) -> str:
    """What a command prints."""
    command = [*CRENEL, *(str(word) for word in words)]
    return subprocess.run(command, check=True, stdout=subprocess.PIPE, text=True).stdout


def measure_gauge(session: Path, name: str, calibration: Path, cloud: Path) -> dict[str, float]:
    """The errors of a recorded scan that ``crenel reconstruct`` and ``crenel verify`` give."""
    arguments = ("--calibration", calibration, "--arm", session / "arm.json", "-o", cloud)
    crenel("reconstruct", session / f"{name}.mcap", *arguments)
    nominal = session / f"{name}.nominal.json"
    found = crenel("verify", GAUGES[name], cloud, "--nominal", nominal, "--json")
    one: dict[str, Any]
    (one,) = json.loads(found)["clouds"]
    return {value: abs(one[value]) for value in VALUES if one.get(value) is not None}


def main() -> None:
    parser = bench_parser(__doc__)
    parser.add_argument("samples", type=Path)
    given = parser.parse_args()
    session = given.samples / "one-pose"
    with measured_rows(given.json) as rows, tempfile.TemporaryDirectory() as scratch:
        calibration = Path(scratch) / "calibration.json"
        crenel("calibrate", session, "--method", "one-pose", "-o", calibration)
        for name in GAUGES:
            cloud = Path(scratch) / f"{name}.ply"
            rows.add(name, measure_gauge(session, name, calibration, cloud))


if __name__ == "__main__":
    main()
