"""The guided sessions of the arm: its daily check, and its identification."""

from fastapi import APIRouter, Request
from starlette.responses import Response

from app.guide.arm.commands import command
from app.guide.arm.view import (
    ArmCheckSummary,
    ArmView,
    IdentificationSummary,
    TipCheckSummary,
)
from app.guide.common.audit_labels import audit_label
from app.operations.context import TheContext
from app.wire.encoding import encode_json
from app.wire.schema import ArmStart, FlowCommand

router = APIRouter(prefix="/api/arm")


def _answer(view: ArmView) -> Response:
    return Response(encode_json(view), media_type="application/json")


@router.get("", response_model=ArmView)
def arm(context: TheContext) -> Response:
    """The current view of the session."""
    return _answer(context.arm_guide.view())


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
    """Starts a check or an identification, or resumes the open session."""
    return _answer(context.arm_guide.start(asked.purpose))


@router.post("/command", response_model=ArmView)
def run_command(asked: FlowCommand, request: Request, context: TheContext) -> Response:
    """Performs one of the view's actions; once per key, and only for the current view."""
    request.state.detail = audit_label(asked.name)
    return _answer(command(context.arm_guide, asked.name, asked.args, asked.rev, asked.key))
