"""The guided calibration."""

from pathlib import Path

from fastapi import APIRouter, Request
from starlette.responses import Response

from app.api.files.file_response import send_file
from app.guide.calibration.commands import command
from app.guide.common.audit_labels import audit_label
from app.guide.common.view import FlowView
from app.messages.message import message
from app.operations.context import TheContext
from app.wire.encoding import encode_json
from app.wire.schema import FlowCommand

router = APIRouter(prefix="/api/flow")


def _answer(view: FlowView) -> Response:
    return Response(encode_json(view), media_type="application/json")


@router.get("", response_model=FlowView)
def flow(context: TheContext) -> Response:
    """The current view of the calibration."""
    return _answer(context.guide.view())


@router.post("/start", response_model=FlowView)
def start(context: TheContext) -> Response:
    """Starts a calibration, or resumes the open one."""
    return _answer(context.guide.start())


@router.post("/command", response_model=FlowView)
def run_command(asked: FlowCommand, request: Request, context: TheContext) -> Response:
    """Performs one of the view's actions; once per key, and only for the current view."""
    request.state.detail = audit_label(asked.name)
    return _answer(command(context.guide, asked.name, asked.args, asked.rev, asked.key))


@router.get("/image/{name}")
def image(name: str, context: TheContext) -> Response:
    """A captured picture of the current session."""
    path: Path | None = context.guide.folder.image(name)
    return send_file(path, message("session-has-no-picture", name=name), "image/png", cached=True)
