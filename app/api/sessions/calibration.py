"""The guided calibration."""

from pathlib import Path

from fastapi import APIRouter
from starlette.responses import Response

from app.api.lookups import send_file
from app.api.sessions.routes import add_session_routes
from app.guide.calibration.commands import COMMANDS
from app.guide.common.view import FlowView
from app.messages.message import message
from app.operations.context import TheContext
from app.wire.json_response import json_response

router = APIRouter(prefix="/api/flow")
add_session_routes(router, "", FlowView, lambda context: context.guide, COMMANDS)


@router.post("/start", response_model=FlowView)
def start(context: TheContext) -> Response:
    """Begins a calibration, or resumes the open one."""
    return json_response(context.guide.start())


@router.get("/image/{name}")
def image(name: str, context: TheContext) -> Response:
    """A captured picture of the current session."""
    path: Path | None = context.guide.folder.image(name)
    return send_file(path, message("session-has-no-picture", name=name), "image/png", cached=True)
