"""What of the data folder cannot be read. It is set aside, and the rest is served."""

from collections.abc import Callable
from pathlib import Path

from app.errors import OperationError
from app.formats.datasheets.arm import read_arm
from app.formats.results.calibration import CalibrationFile
from app.formats.results.verification import VERIFICATION, VerificationFile
from app.formats.session.calibration_session import ARM
from app.operations.context import Context


def list_unreadable(context: Context) -> list[str]:
    """Each a sentence. It reads every record, which may take seconds."""
    store, sessions = context.store, (context.guide, context.arm_guide, context.verify_guide)
    found = [session.unreadable_reason for session in sessions if session.unreadable_reason]
    rows = store.unreadable_rows()
    if rows:
        found.append(f"The journal has {len(rows)} rows that cannot be read, first row {rows[0]}.")
    found += [
        f"The calibration {one.name} cannot be read." for one in store.calibrations.unreadable()
    ]
    found += [f"The verification {one} cannot be read." for one in store.verifications.unreadable()]
    for record in store.calibrations.all():
        found += _trouble(record.file, CalibrationFile.read)
        found += _trouble(record.file.parent / ARM, read_arm)
    for verification in store.verifications.all():
        found += _trouble(verification.folder / VERIFICATION, VerificationFile.read)
    return found


def _trouble(path: Path, read: Callable[[Path], object]) -> list[str]:
    try:
        read(path)
    except OperationError as refusal:
        return [refusal.line]
    return []
