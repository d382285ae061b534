"""Camera and mounting of an earlier calibration, kept while the laser plane is solved again."""

from dataclasses import dataclass
from pathlib import Path

import numpy as np

from crenel.errors import OperationError
from crenel.formats.file_names import display_path
from crenel.formats.json_document import file_sha256
from crenel.formats.results.calibration import CalibrationFile, Input
from crenel.messages.message import message
from crenel.metrology.adjustment.core.kept_sensor import KeptSensor


@dataclass(frozen=True)
class KeptCalibration:
    """The sensor, and the file that it is from."""

    sensor: KeptSensor
    source: Input


def read_kept_calibration(path: Path) -> KeptCalibration:
    """Reads camera, mounting and their covariance; a laser plane is not needed.

    Raises:
        OperationError: the file is damaged, or from one pose, or has no covariance.
    """
    document = CalibrationFile.read(path)
    known = document.covariance
    if known is None or document.method != "joint":
        raise OperationError(
            "no-covariance",
            message("calibration-has-no-covariance", file=display_path(path)),
            "",
            message("give-a-calibration-of-several-poses"),
        )
    sensor = KeptSensor(
        document.camera.model(),
        np.array(document.probe_matrix),
        known.parameters,
        np.array(known.matrix),
        np.array(known.pivot_mm),
    )
    return KeptCalibration(sensor, Input(file=path.name, sha256=file_sha256(path)))
