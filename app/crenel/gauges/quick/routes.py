"""The guided verification, and the records of accepted verifications."""

from typing import Annotated

from fastapi import Path, Query
from starlette.responses import Response

from crenel.api.access.authorization import StationRouter, TheVisitor
from crenel.api.answers.lookups import find_verification, send_file
from crenel.api.answers.problems import NotFoundError
from crenel.api.sessions.routes import add_session_routes
from crenel.errors import OperationError
from crenel.gauges.quick.document import STUDY, VERIFICATION
from crenel.gauges.quick.evaluate_deviation_maps import read_maps, scale_end_um
from crenel.gauges.quick.evaluate_study import AcceptedCalibration, StudyFile, study_verification
from crenel.gauges.quick.guide.commands import COMMANDS
from crenel.gauges.quick.guide.view import VerifyView
from crenel.messages.message import message
from crenel.operations.context import Context, TheContext
from crenel.station.jobs import Job, Progress
from crenel.store.session_records import VerificationRecord
from crenel.wire.json_response import json_response
from crenel.wire.schema import CloudMap, NewTemperature, StudyState, VerificationSummary

router = StationRouter(prefix="/api")
CloudNumber = Annotated[int, Path(ge=1, le=999)]
SeveralClouds = Annotated[tuple[CloudNumber, ...], Query(max_length=999)]
STUDY_TITLE = message("rebuilding-clouds-every-calibration")


add_session_routes(router, "/verify", VerifyView, lambda context: context.verify_guide, COMMANDS)


@router.post("/verify/start", response_model=VerifyView)
def start(context: TheContext) -> Response:
    """Begins a verification, or resumes the open one."""
    return json_response(context.verify_guide.start())


@router.post("/temperature")
def temperature(asked: NewTemperature, context: TheContext, visitor: TheVisitor) -> None:
    """Sets the present temperature at the station."""
    context.store.temperatures.add(asked.celsius, visitor.name)


@router.get("/verifications")
def verifications(context: TheContext) -> list[VerificationSummary]:
    """Lists all accepted verifications, newest first."""
    names = {record.id: record.name for record in context.store.calibrations.all()}
    return [
        verification_summary(record, names.get(record.calibration_id, ""))
        for record in context.store.verifications.all()
    ]


def verification_summary(record: VerificationRecord, calibration: str) -> VerificationSummary:
    """A verification as it appears in the list."""
    figures = record.figures
    return VerificationSummary(
        id=record.id,
        accepted_at=record.accepted_at,
        calibration_id=record.calibration_id,
        calibration=calibration,
        result=figures.result,
        text=figures.text,
        shape=figures.shape,
        gauge=figures.gauge,
        clouds=figures.clouds,
        touched=figures.touched,
        operator=figures.operator,
    )


@router.get("/verifications/{verification_id}")
def verification(verification_id: str, context: TheContext) -> Response:
    """The record of a verification, as stored in its file."""
    path = find_verification(context, verification_id).folder / VERIFICATION
    missing = message("record-no-longer-in-data-folder")
    return send_file(path, missing, "application/json", f"verification-{verification_id}.json")


@router.get("/verifications/{verification_id}/cloud/{number}/map")
def cloud_map(
    verification_id: str, number: CloudNumber, context: TheContext, of: SeveralClouds = ()
) -> CloudMap:
    """The deviations of a cloud from its fitted shape, also for an open session, and the scale
    that it shares with the clouds ``of`` these numbers."""
    guide = context.verify_guide
    if guide.running and guide.state.session_id == verification_id:
        folder = guide.folder
    else:
        folder = find_verification(context, verification_id).folder
    wanted = folder / f"cloud-{number}"
    maps = read_maps([wanted, *(folder / f"cloud-{other}" for other in of)])
    if wanted not in maps:
        raise NotFoundError(message("there-no-map-cloud", number=number))
    return CloudMap(maps[wanted], scale_end_um([*maps.values()]))


@router.get("/verifications/{verification_id}/study")
def study(verification_id: str, context: TheContext) -> StudyState:
    """Whether the clouds were rebuilt with every calibration, and with which ones."""
    return _study_state(verification_id, context)


@router.post("/verifications/{verification_id}/study")
def make_study(verification_id: str, context: TheContext) -> StudyState:
    """Rebuilds the clouds with every accepted calibration, in the background."""
    record = find_verification(context, verification_id)
    sources = [
        AcceptedCalibration(calibration.id, calibration.name, calibration.file.parent)
        for calibration in reversed(context.store.calibrations.all())
    ]

    def work(progress: Progress) -> None:
        done = study_verification(record.folder, sources, lambda share, text: progress(text, share))
        done.write(record.folder / STUDY)

    def ended(job: Job[None]) -> None:
        if job.refusal is not None:
            context.bus.event("refused", job.refusal.text, "bad")
        else:
            context.bus.event("step_done", message("clouds-rebuilt-every-calibration"), "good")

    context.jobs.start(STUDY_TITLE, work, ended)
    return _study_state(verification_id, context)


def _study_state(verification_id: str, context: Context) -> StudyState:
    record = find_verification(context, verification_id)
    job = context.jobs.current
    running = job is not None and job.title == STUDY_TITLE
    path = record.folder / STUDY
    accepted = len(context.store.calibrations.all())
    text = job.text if running and job else ""
    fraction = job.fraction if running and job else None
    if not path.is_file():
        return StudyState(running, text, fraction, accepted, None)
    try:
        return StudyState(running, text, fraction, accepted, StudyFile.read(path))
    except OperationError:
        return StudyState(running, text, fraction, accepted, None)
