"""The guided sessions of the arm: its daily check, and its identification."""

from starlette.responses import Response

from crenel.api.access.authorization import StationRouter
from crenel.api.sessions.routes import add_session_routes
from crenel.guide.arm.commands import COMMANDS
from crenel.guide.arm.view import (
    ArmCheckSummary,
    ArmView,
    IdentificationSummary,
    TipCheckSummary,
)
from crenel.operations.context import TheContext
from crenel.wire.json_response import json_response
from crenel.wire.schema import ArmStart

router = StationRouter(prefix="/api/arm")
add_session_routes(router, "", ArmView, lambda context: context.arm_guide, COMMANDS)


@router.get("/checks")
def checks(context: TheContext) -> list[ArmCheckSummary]:
    """Lists all finished arm checks, newest first."""
    return context.arm_guide.history.checks()


@router.get("/tips")
def tips(context: TheContext) -> list[TipCheckSummary]:
    """Lists all finished tip checks, newest first."""
    return context.arm_guide.history.tip_checks()


@router.get("/identifications")
def identifications(context: TheContext) -> list[IdentificationSummary]:
    """Lists all identifications of the arm, newest first."""
    return context.arm_guide.history.identifications()


@router.post("/start", response_model=ArmView)
def start(asked: ArmStart, context: TheContext) -> Response:
    """Begins a check or an identification, or resumes the open session."""
    return json_response(context.arm_guide.start(asked.purpose))
