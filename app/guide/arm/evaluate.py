"""The end of a swing or of a sphere's touches, and the daily checks that are judged by it."""

from collections.abc import Mapping, Sequence
from dataclasses import asdict
from datetime import UTC, datetime

import numpy as np

from app.errors import OperationError
from app.findings import Quality
from app.formats.json_document import file_sha256
from app.formats.results.arm_checks import ARM_CHECK, TIP_CHECK, ArmCheckFile, TipCheckFile
from app.formats.results.calibration import Input
from app.formats.session.arm_session import ARM, ARTICULATION, SPHERES
from app.formats.software import SOFTWARE
from app.guide.arm.flow import limit_quality
from app.guide.arm.guide import ArmGuide
from app.guide.arm.history import CHECKED, TIP_CHECKED
from app.guide.arm.state import Artefact
from app.guide.arm.tip import tip_check_finding, to_payload
from app.messages.message import message, quantity, text_to_json
from app.metrology.arm.identification.articulation import Articulation, check_articulation
from app.metrology.arm.kinematics import Arm
from app.metrology.gauges.tip_check import check_tip


def finish_seat(guide: ArmGuide, key: str | None) -> None:
    """Ends the swing; a check is judged and recorded at once."""
    guide.end_seat(key)
    if guide.state.purpose == "check":
        check_the_arm(guide)
    elif guide.state.purpose == "tip":
        check_the_tip(guide)


def check_the_arm(guide: ArmGuide) -> None:
    """Judges the swing in a seat, and records it."""
    arm, seat = guide.arm(), guide.state.seats[-1]
    assert arm is not None
    found = check_articulation(arm, np.array(seat.q_rad), label=seat.name)
    quality = limit_quality(found.half_range_um, guide.state.limit_um)
    _keep_check(guide, arm, found, quality)
    guide.append(
        CHECKED,
        {
            "arm_name": arm.name,
            "arm_serial": arm.serial_number,
            "points": found.points,
            "centre_mm": found.centre_mm.tolist(),
            "half_range_um": found.half_range_um.tolist(),
            "two_sigma_um": found.two_sigma_um.tolist(),
            "encoders_two_sigma_um": found.encoders_two_sigma_um.tolist(),
            "limit_um": guide.state.limit_um,
            "verdict": quality,
        },
    )
    worst = quantity(float(found.half_range_um.max()), "µm")
    guide.station.bus.event("step_done", message("arm-checked", worst=worst))


def check_the_tip(guide: ArmGuide) -> None:
    """Judges the touches of a sphere, and records them; what cannot be judged is dropped."""
    arm, seat = guide.arm(), guide.state.seats[-1]
    assert arm is not None
    sphere, limit_um = seat.artefact, guide.state.limit_um
    assert sphere.size_mm is not None
    try:
        found = check_tip(
            arm,
            np.array(seat.q_rad),
            sphere.size_mm,
            sphere.standard_uncertainty_mm,
            limit_um,
        )
    except OperationError as error:
        guide.append("seat_dropped", {"name": seat.name})
        guide.decline(error)
        return
    payload = to_payload(found, arm.tip.diameter_mm, limit_um)
    finding = tip_check_finding(payload)
    _keep_tip_check(guide, arm, sphere, {**payload, "words": finding.text})
    guide.append(
        TIP_CHECKED,
        {
            "arm_name": arm.name,
            "arm_serial": arm.serial_number,
            "sphere": asdict(sphere),
            "text": text_to_json(finding.text),
            "verdict": finding.quality,
            **payload,
        },
    )
    guide.station.bus.event("step_done", finding.text, finding.quality)


def _provenance(guide: ArmGuide, tables: Sequence[str]) -> dict[str, object]:
    """Of a record made now: when, where and by whom, and the files it was made from."""
    signing = guide.provenance
    return {
        "checked_at": datetime.now(UTC).isoformat(timespec="seconds"),
        "operator": signing.operator(),
        "station": signing.station,
        "simulated": signing.simulated,
        "temperature_c": signing.temperature_c(),
        "inputs": tuple(
            Input(file=name, sha256=file_sha256(guide.folder / name)) for name in (ARM, *tables)
        ),
        "software": SOFTWARE,
    }


def _keep_tip_check(
    guide: ArmGuide, arm: Arm, sphere: Artefact, found: Mapping[str, object]
) -> None:
    TipCheckFile.model_validate(
        {
            **_provenance(guide, [SPHERES]),
            **found,
            "arm_name": arm.name,
            "arm_serial": arm.serial_number,
            "sphere_mm": sphere.size_mm,
            "sphere_standard_uncertainty_mm": sphere.standard_uncertainty_mm,
        }
    ).write(guide.folder / TIP_CHECK)


def _keep_check(guide: ArmGuide, arm: Arm, found: Articulation, verdict: Quality) -> None:
    """What the check found, and what from, so that its report can be made of the folder."""
    ArmCheckFile.model_validate(
        {
            **_provenance(guide, [ARTICULATION]),
            "arm_name": arm.name,
            "arm_serial": arm.serial_number,
            "points": found.points,
            "half_range_um": found.half_range_um.tolist(),
            "two_sigma_um": found.two_sigma_um.tolist(),
            "encoders_two_sigma_um": found.encoders_two_sigma_um.tolist(),
            "limit_um": guide.state.limit_um,
            "verdict": verdict,
        }
    ).write(guide.folder / ARM_CHECK)
