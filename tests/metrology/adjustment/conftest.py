"""The sample of eight poses, detected and calibrated once for the files that a worker runs."""

from pathlib import Path

import pytest

from crenel.formats.session.calibration_session import read_session
from crenel.metrology.adjustment.block.calibrate import BlockCalibration, calibrate_block
from crenel.metrology.adjustment.block.problem import BlockInputs
from crenel.workflows.calibrate import joint_inputs


@pytest.fixture(scope="session")
def inputs(samples: Path) -> BlockInputs:
    """What its pictures and contacts show; not to be changed in place."""
    return joint_inputs(read_session(samples / "many-poses"))


@pytest.fixture(scope="session")
def found(inputs: BlockInputs) -> BlockCalibration:
    """Its calibration with everything as it is."""
    return calibrate_block(inputs)
