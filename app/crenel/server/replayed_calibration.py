"""The calibration with which a recording is replayed, in use as that of a station."""

import shutil
from pathlib import Path

from crenel.formats.results.calibration import CALIBRATION, CalibrationFile
from crenel.formats.session.calibration_session import ARM
from crenel.store.calibrations import MOST_UM
from crenel.store.store import Store
from crenel.timestamps import is_moment

SESSION = "replayed"


def put_in_use(data: Path, calibration: Path, arm: Path) -> None:
    """Accepts the calibration in a new data folder, with the date of the calibration itself.

    One of other origin that states no uncertainty is shown only in the view, since a station uses
    none of which it cannot say how good it is.

    Raises:
        OperationError: a file cannot be read.
    """
    document = CalibrationFile.read(calibration)
    if document.uncertainty is None or document.uncertainty.total_um > MOST_UM:
        return
    created = document.created_at if is_moment(document.created_at) else None
    serials = document.serial_numbers
    figures = {
        "total_um": document.uncertainty.total_um,
        "verdict": document.verdict.quality if document.verdict else "neutral",
        "arm_serial": serials.arm,
        "object_serial": serials.object,
        "sensor_serial": serials.sensor,
    }
    store = Store(data)
    try:
        folder = store.folder / "sessions" / SESSION
        folder.mkdir(parents=True)
        file = folder / CALIBRATION
        shutil.copyfile(calibration, file)
        shutil.copyfile(arm, folder / ARM)
        store.journal.begin_session(SESSION, SESSION)  # no guided session to go on with
        store.calibrations.accept(
            SESSION, calibration.name, file, figures, None, accepted_at=created
        )
    finally:
        store.close()
