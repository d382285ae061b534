"""The end of a swing or of a sphere's touches, and the daily checks that are judged by it."""

from dataclasses import asdict
from datetime import UTC, datetime

import numpy as np

from crenel.errors import OperationError
from crenel.formats.json_document import SOFTWARE, file_sha256
from crenel.formats.results.arm_checks import ARM_CHECK, TIP_CHECK, ArmCheckFile, TipCheckFile
from crenel.formats.results.calibration import Input
from crenel.formats.results.decision_rule import RulePart
from crenel.formats.session.arm_session import ARM, ARTICULATION, SPHERES
from crenel.gauges.quick.maths.tip_check import check_tip
from crenel.guide.arm.flow import limit_quality
from crenel.guide.arm.guide import ArmGuide
from crenel.guide.arm.history import CHECKED, TIP_CHECKED
from crenel.guide.arm.tip import tip_check_finding, to_payload
from crenel.messages.message import message, quantity, text_to_json
from crenel.metrology.arm.identification.articulation import check_articulation


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
    result = {
        "arm_name": arm.name,
        "arm_serial": arm.serial_number,
        "points": found.points,
        "half_range_um": found.half_range_um.tolist(),
        "two_sigma_um": found.two_sigma_um.tolist(),
        "encoders_two_sigma_um": found.encoders_two_sigma_um.tolist(),
        "largest_um": found.largest_um,
        "two_s_um": found.two_s_um,
        "limit_um": guide.state.limit_um,
        "verdict": limit_quality(found.half_range_um, guide.state.limit_um),
    }
    rule = RulePart.of(guide.rule)
    document = {**_provenance(guide, ARTICULATION), **result, "rule": rule}
    ArmCheckFile.model_validate(document).write(guide.folder / ARM_CHECK)
    guide.append(CHECKED, {**result, "centre_mm": found.centre_mm.tolist()})
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
            guide.rule,
        )
    except OperationError as error:
        guide.append("seat_dropped", {"name": seat.name})
        guide.decline(error)
        return
    result = {
        "arm_name": arm.name,
        "arm_serial": arm.serial_number,
        **to_payload(found, arm.tip.diameter_mm, limit_um),
    }
    finding = tip_check_finding(result)
    document = {
        **_provenance(guide, SPHERES),
        **result,
        "rule": RulePart.of(guide.rule),
        "words": finding.text,
        "sphere_mm": sphere.size_mm,
        "sphere_standard_uncertainty_mm": sphere.standard_uncertainty_mm,
    }
    TipCheckFile.model_validate(document).write(guide.folder / TIP_CHECK)
    text = text_to_json(finding.text)
    row = {**result, "sphere": asdict(sphere), "text": text, "verdict": finding.quality}
    guide.append(TIP_CHECKED, row)
    guide.station.bus.event("step_done", finding.text, finding.quality)


def _provenance(guide: ArmGuide, table: str) -> dict[str, object]:
    """The provenance of a record made now: when, where and by whom, and the files it was made
    from."""
    signing = guide.provenance
    return {
        "checked_at": datetime.now(UTC).isoformat(timespec="seconds"),
        "operator": signing.operator(),
        "station": signing.station,
        "simulated": signing.is_simulated(),
        "temperature_c": signing.temperature_c(),
        "inputs": tuple(
            Input(file=name, sha256=file_sha256(guide.folder / name)) for name in (ARM, table)
        ),
        "software": SOFTWARE,
    }
