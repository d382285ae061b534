"""The longer works of an arm session: the fit, and putting the identified arm into use."""

from datetime import UTC, datetime
from pathlib import Path

from pydantic_core import to_jsonable_python

from crenel.errors import OperationError
from crenel.formats.atomic_write import ensure_folder, write_atomically
from crenel.formats.io_errors import convert_io_errors
from crenel.formats.open_file import read_bounded
from crenel.formats.session.arm_session import IDENTIFIED
from crenel.guide.arm.guide import ArmGuide
from crenel.guide.arm.history import SOLVED
from crenel.guide.common.journal import error_payload
from crenel.messages.message import message
from crenel.metrology.arm.identification.identify import Identification
from crenel.station.jobs import Progress
from crenel.workflows.identify_arm import (
    IdentificationProvenance,
    identify_folder,
    list_fixed_parameters,
    outlier_text,
    parameter_lines,
    strong_correlations,
)

REPLACED = "replaced"
"""Folder beside the station's arms that keeps those that were replaced."""


def fit(guide: ArmGuide, progress: Progress) -> None:
    """Identifies the arm from the session's folder, exactly as the command line does."""
    folder, signing = guide.folder, guide.provenance
    signature = IdentificationProvenance(
        signing.operator(), signing.station, signing.is_simulated(), signing.temperature_c()
    )
    with guide.lock:
        guide.keep_seats()
    try:
        document, result = identify_folder(
            folder,
            folder / IDENTIFIED,
            progress=lambda share, text: progress(text, share),
            signature=signature,
            names_folder=False,
        )
    except OperationError as error:
        guide.append("fit_refused", error_payload(error))
        guide.station.bus.event("refused", error.text, "bad")
        return
    named = {"arm_name": document.name, "arm_serial": document.serial_number}
    guide.append(SOLVED, {**named, **to_jsonable_python(_payload(result))})
    guide.station.bus.event("step_done", message("arm-identified"), "good")


def save(guide: ArmGuide, key: str | None) -> None:
    """Makes the identified arm the station's; the one before is kept aside."""
    target, aside = _places(guide)
    stamp = datetime.now(UTC).strftime("%Y%m%d-%H%M%S")
    kept = aside / f"{guide.state.arm}-{stamp}.json"
    with convert_io_errors(target):
        ensure_folder(kept.parent)
        write_atomically(kept, read_bounded(target))
        write_atomically(target, read_bounded(guide.folder / IDENTIFIED))
    guide.append("saved", {"name": target.name, "replaced": kept.name}, key)
    guide.station.bus.event("accepted", message("identified-arm-use"), "good")


def restore(guide: ArmGuide, key: str | None) -> None:
    """Makes the arm before the identified one the station's again.

    Raises:
        OperationError: the arm's file is no longer what this session wrote, or cannot be replaced.
    """
    target, aside = _places(guide)
    kept = aside / guide.state.replaced
    with convert_io_errors(target):
        now, identified = read_bounded(target), read_bounded(guide.folder / IDENTIFIED)
    if now != identified:
        raise OperationError(
            "arm-changed",
            message("changed-after-session-had-written", name=target.name),
            remedy=message("arm-before-arms-put-back-hand", replaced=REPLACED, name=kept.name),
        )
    with convert_io_errors(kept):
        write_atomically(target, read_bounded(kept))
    guide.append("restored", {"name": target.name}, key)
    guide.station.bus.event("accepted", message("arm-before"), "good")


def _places(guide: ArmGuide) -> tuple[Path, Path]:
    """The file of the session's arm, and the folder that keeps those that were replaced."""
    arms = guide.data_folder / "arms"
    return arms / f"{guide.state.arm}.json", arms / REPLACED


def _payload(result: Identification) -> dict[str, object]:
    before, after = result.validation.before, result.validation.after
    lines = [
        {"title": title, "before_um": was, "after_um": now}
        for title, was, now in (
            (message("seats"), before.seats_um, after.seats_um),
            (message("spheres"), before.spheres_um, after.spheres_um),
            (message("ball-bars-lengths"), before.lengths_um, after.lengths_um),
            (message("coordinates-measured"), before.coordinates_um, after.coordinates_um),
        )
        if was is not None and now is not None
    ]
    return {
        "volume_before_um": result.volume_before_mm * 1e3,
        "volume_after_um": result.volume_after_mm * 1e3,
        "size_known": result.size_known,
        "places": result.validation.places,
        "lines": lines,
        "parameters": parameter_lines(result),
        "kept": [{"names": names, "why": why} for names, why in list_fixed_parameters(result)],
        "correlated": [
            {"first": first, "second": second, "coefficient": rho}
            for first, second, rho in strong_correlations(result)
        ],
        "warnings": list(result.warnings),
        "outliers": [
            message("excluded-for-reason", text=outlier_text(one)) for one in result.outliers
        ],
    }
