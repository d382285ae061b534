"""The guided performance test, and the list of tests."""

from pathlib import Path

from starlette.responses import Response

from crenel.api.access.authorization import StationRouter
from crenel.api.answers.lookups import find_performance, send_file
from crenel.api.sessions.routes import add_session_routes
from crenel.gauges.exchange.read_certificate import parse_sphere_certificate
from crenel.gauges.guide_commands import COMMANDS
from crenel.gauges.guide_view import ArtefactOption, PerformanceView
from crenel.gauges.judgement.evaluate_history import PerformanceSymbols, read_symbols
from crenel.gauges.plan.document import RESULT
from crenel.messages.message import message
from crenel.operations.context import TheContext
from crenel.operations.datasheets.files import split_ending
from crenel.store.session_records import PerformanceRecord
from crenel.wire.json_response import json_response
from crenel.wire.schema import PerformanceStart, PerformanceSummary, UploadedCertificate

router = StationRouter(prefix="/api")


add_session_routes(
    router, "/performance", PerformanceView, lambda context: context.performance_guide, COMMANDS
)


@router.post("/performance/start", response_model=PerformanceView)
def start(context: TheContext, asked: PerformanceStart | None = None) -> Response:
    """Begins a performance test, of one sphere unless asked otherwise, or resumes the open one."""
    test = asked.test if asked is not None else "sphere"
    return json_response(context.performance_guide.start_test(test))


@router.post("/performance/certificate")
def add_certificate(asked: UploadedCertificate, context: TheContext) -> ArtefactOption | None:
    """Puts the digital certificate (DCC) of a sphere among the datasheets of gauges."""
    parse_sphere_certificate(asked.text, Path(asked.name))  # other datasheets have their own page
    added = context.datasheets.add(asked.name, asked.text)
    return context.performance_guide.sphere_option(split_ending(added.file)[0])


@router.get("/performances")
def performances(context: TheContext) -> list[PerformanceSummary]:
    """Lists all performance tests in which a point was taken, newest first."""
    return [_summary(record) for record in context.store.performances.all()]


@router.get("/performance-history")
def performance_history(context: TheContext) -> list[PerformanceSymbols]:
    """Every symbol of all tests with a readable result, oldest first."""
    records = context.store.performances.all()
    return read_symbols([record.folder for record in reversed(records)])


def _summary(record: PerformanceRecord) -> PerformanceSummary:
    figures = record.figures
    return PerformanceSummary(
        id=record.id,
        ended_at=record.ended_at,
        kind=figures.kind,
        result=figures.result,
        text=figures.text,
        artefact=figures.artefact,
        operator=figures.operator,
    )


@router.get("/performances/{performance_id}")
def performance(performance_id: str, context: TheContext) -> Response:
    """The result of a performance test, as stored in its file."""
    path = find_performance(context, performance_id).folder / RESULT
    missing = message("record-no-longer-in-data-folder")
    return send_file(path, missing, "application/json", f"performance-{performance_id}.json")
