"""The longer works of a verification: measuring a cloud, and writing the record."""

import shutil
from collections.abc import Mapping
from dataclasses import asdict
from datetime import UTC, datetime
from pathlib import Path

from crenel.errors import OperationError
from crenel.formats.io_errors import convert_io_errors
from crenel.formats.json_document import SOFTWARE, file_sha256
from crenel.formats.results.calibration import CALIBRATION, CalibrationFile, Input
from crenel.formats.results.decision_rule import RulePart
from crenel.formats.session.calibration_session import ARM
from crenel.gauges.judgement.evaluate_measured_data import RECORDING
from crenel.gauges.quick.document import (
    CONTACTS,
    GAUGE,
    CloudPart,
    GaugePart,
    PlacingPart,
    TemperaturePart,
    UsedCalibration,
    VerificationFile,
    write_verification,
)
from crenel.gauges.quick.evaluate import CloudErrors
from crenel.gauges.quick.evaluate_deviation_maps import MAP
from crenel.gauges.quick.evaluate_gauge import GaugeFit, filters_of, measure_recording
from crenel.gauges.quick.guide.guide import VerifyGuide
from crenel.gauges.quick.guide.rules import VerifyLive
from crenel.gauges.quick.guide.state import VerificationCloud, VerifyState
from crenel.gauges.quick.maths.errors import ARCSEC_PER_RAD
from crenel.gauges.quick.maths.probed_gauge import ProbedPlane, ProbedSphere
from crenel.gauges.session.acts import keep_measured, recording_of
from crenel.guide.common.flow import DECISION_QUALITY
from crenel.messages.message import Text, message, quantity
from crenel.station.jobs import Progress


def confirm_gauge(guide: VerifyGuide, key: str | None) -> None:
    """From here on the session uses its own copies of gauge, arm and calibration."""
    guide.keep_datasheets()
    guide.append("gauge_confirmed", {}, key)
    _, arm = guide.datasheets()
    if arm is not None and arm.tip is None:
        guide.append("touch_skipped", {})


def begin_cloud(guide: VerifyGuide, key: str | None) -> None:
    """Starts the scan of the next cloud; raises ``OperationError`` where it cannot start."""
    number = len(guide.state.clouds) + 1
    folder = guide.folder / VerificationCloud(number, "", "").name
    # of a process that was killed before the row below was kept
    shutil.rmtree(folder, ignore_errors=True)
    guide.station.scanner.start(str(message("verification-cloud", number=number)), folder)
    guide.append("cloud_begun", {"number": number}, key)


def end_cloud(guide: VerifyGuide, kind: str, key: str | None) -> VerificationCloud:
    """Ends the cloud that is scanned, as ``cloud_ended`` or ``cloud_voided``."""
    cloud = guide.state.open_cloud
    assert cloud is not None
    guide.append(kind, {"number": cloud.number, "ended": True, "voided": True}, key)
    return cloud


def end_scan(guide: VerifyGuide) -> float:
    """Stops the cloud's scan; how long it took, 0 where it had ended already."""
    result = guide.station.scanner.stop()
    return result.seconds if result is not None else 0.0


def measure(
    guide: VerifyGuide, cloud: VerificationCloud, seconds: float, progress: Progress
) -> None:
    """Rebuilds a cloud from its recording and fits the gauge to it; a refusal is kept, too."""
    progress(message("measuring-cloud-of-number", number=cloud.number), 0.5)
    keep_measured(
        guide,
        cloud.name,
        cloud.number,
        ("cloud_measured", "cloud_refused"),
        lambda: _measure(guide, cloud, seconds),
    )


def _measure(
    guide: VerifyGuide, cloud: VerificationCloud, seconds: float
) -> tuple[Mapping[str, object], Text]:
    """What a cloud shows of the gauge, as its row has it, and in a sentence."""
    with guide.lock:
        gauge, arm = guide.datasheets()
    if gauge is None or arm is None:
        raise OperationError("datasheets-unreadable", message("sessions-gauge-arm-cannot-read-any"))
    recording = recording_of(guide, cloud.name)
    measured = measure_recording(recording, guide.calibration(), arm, gauge)
    measured.map.write(recording.parent / MAP)
    rms = quantity(measured.fit.rms_um, "µm")
    text = message("cloud-rms-about-gauge", number=cloud.number, rms=rms)
    return {"fit": measured.fit.model_dump(mode="json"), "seconds": seconds}, text


def accept(guide: VerifyGuide, key: str | None) -> None:
    """Writes the record and keeps the verification.

    Raises:
        OperationError: a file cannot be read or written; nothing is kept then.
    """
    live, state = guide.live(), guide.state
    document = build_record(guide, live)
    write_verification(guide.folder, document)
    figures = {
        "result": document.verdict.result,
        "text": document.verdict.text,
        "shape": document.gauge.shape,
        "gauge": document.gauge.name,
        "clouds": len(document.clouds),
        "touched": document.placing is not None,
        "operator": document.operator,
    }
    guide.keep(
        lambda check: guide.verifications.accept(
            state.session_id, state.calibration_id, guide.folder, figures, key, check
        )
    )
    quality = DECISION_QUALITY[document.verdict.result]
    guide.station.bus.event("accepted", message("verified", text=document.verdict.text), quality)


def build_record(guide: VerifyGuide, live: VerifyLive) -> VerificationFile:
    """The record as of now."""
    provenance = guide.provenance
    state, gauge, verdict = guide.state, live.gauge, live.judged.verdict
    active = guide.active()
    assert gauge is not None
    assert verdict is not None
    assert active is not None
    calibration = CalibrationFile.read(guide.folder / CALIBRATION)
    accepted_at = datetime.now(UTC).isoformat(timespec="seconds").replace("+00:00", "Z")
    probe = (
        live.touched if state.by_probe and not isinstance(live.touched, OperationError) else None
    )
    return VerificationFile(
        id=state.session_id,
        station=provenance.station,
        simulated=provenance.is_simulated(),
        operator=provenance.operator(),
        started_at=state.started_at,
        accepted_at=accepted_at,
        gauge=GaugePart(
            shape=gauge.shape,
            name=gauge.name or state.gauge,
            serial_number=gauge.serial_number,
            certificate=gauge.certificate,
            radius_mm=gauge.radius_mm,
            standard_uncertainty_um=gauge.standard_uncertainty_um,
            form_um=gauge.form_um,
        ),
        serial_numbers=calibration.serial_numbers,
        calibration=UsedCalibration(
            id=active.id,
            name=active.name,
            accepted_at=active.accepted_at,
            total_um=calibration.uncertainty.total_um if calibration.uncertainty else 0.0,
        ),
        placing=build_placing(probe),
        clouds=tuple(
            cloud_part(cloud, live.judged.fits[cloud.number], live.judged.errors[cloud.number])
            for cloud in state.good
        ),
        rule=RulePart.of(guide.rule),
        filters=filters_of(gauge.shape),
        figures=live.judged.figures,
        verdict=verdict,
        notes=_notes(state),
        temperature=TemperaturePart(
            start_c=provenance.celsius_near(state.started_at),
            end_c=provenance.celsius_near(accepted_at),
        ),
        inputs=_inputs(guide.folder, state),
        software=SOFTWARE,
    )


def build_placing(touched: ProbedPlane | ProbedSphere | None) -> PlacingPart | None:
    """Where the touches have the gauge."""
    if touched is None:
        return None
    values: dict[str, object] = {
        "touches": len(touched.residuals_mm),
        "rms_um": touched.rms_mm * 1e3,
    }
    if isinstance(touched, ProbedPlane):
        at = touched.nominal.point_mm
        values |= {
            "point_mm": at.tolist(),
            "normal": touched.nominal.normal.tolist(),
            "standard_uncertainty_um": touched.height_sd_mm(at) * 1e3,
            "standard_uncertainty_arcsec": touched.angle_sd_rad * ARCSEC_PER_RAD,
        }
    else:
        values |= {
            "point_mm": touched.nominal.centre_mm.tolist(),
            "radius_mm": touched.radius_mm,
            "standard_uncertainty_um": touched.centre_sd_mm * 1e3,
        }
    return PlacingPart.model_validate(values)


def cloud_part(cloud: VerificationCloud, fit: GaugeFit, errors: CloudErrors) -> CloudPart:
    """One cloud as the record has it."""
    return CloudPart(
        name=f"Cloud {cloud.number}",
        recording=f"{cloud.name}/{RECORDING}",
        taken_at=cloud.at,
        seconds=cloud.seconds,
        frames=fit.frames,
        points=fit.points,
        used=fit.used,
        rms_um=fit.rms_um,
        form_um=fit.form_um,
        in_gate=fit.in_gate,
        form_all_um=fit.form_all_um,
        range_all_um=fit.range_all_um,
        centre_mm=fit.centre_mm,
        normal=fit.normal,
        offset_mm=fit.offset_mm,
        radius_mm=fit.radius_mm,
        **asdict(errors),
    )


def _notes(state: VerifyState) -> tuple[Text, ...]:
    notes: list[Text] = []
    if state.by_probe:
        notes.append(message("scan-and-probe-errors-in-common-not-shown"))
    else:
        notes.append(message("gauge-touched-only-shape-size-judged"))
    aside = sum(cloud.voided or cloud.refused is not None for cloud in state.listed)
    if aside:
        notes.append(message("further-cloud-aside-one-other-s", aside=aside))
    return tuple(notes)


def _inputs(folder: Path, state: VerifyState) -> tuple[Input, ...]:
    names = [CALIBRATION, ARM, GAUGE]
    if state.by_probe:
        names.append(CONTACTS)
    names += [f"{cloud.name}/{RECORDING}" for cloud in state.good]
    with convert_io_errors(folder):
        return tuple(Input(file=name, sha256=file_sha256(folder / name)) for name in names)
