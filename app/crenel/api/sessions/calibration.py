"""The guided calibration."""

from pathlib import Path
from typing import Annotated

from fastapi import Path as PathParameter
from starlette.responses import Response

from crenel.api.access.authorization import StationRouter
from crenel.api.answers.lookups import send_file
from crenel.api.answers.problems import NotFoundError
from crenel.api.sessions.picture_bundle import bundle_picture
from crenel.api.sessions.routes import add_session_routes
from crenel.guide.calibration.commands import COMMANDS
from crenel.guide.common.view import FlowView
from crenel.messages.message import message
from crenel.operations.context import TheContext
from crenel.wire.json_response import json_response

router = StationRouter(prefix="/api/flow")
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


@router.get("/picture/{number}.zip")
def picture_bundle(
    number: Annotated[int, PathParameter(ge=1, le=9999)], context: TheContext
) -> Response:
    """A pose's pictures with what was found in them and their context, to send for help."""
    guide = context.guide
    capture = next((one for one in guide.state.captures if one.number == number), None)
    if capture is None:
        raise NotFoundError(message("session-has-no-pose", number=number))
    name = f"crenel-picture-{guide.state.session_id}-{number}.zip"
    headers = {"Content-Disposition": f'attachment; filename="{name}"', "Cache-Control": "no-store"}
    content = bundle_picture(context, capture)
    return Response(content, media_type="application/zip", headers=headers)
