"""The routes that every guided session has."""

from collections.abc import Callable
from typing import Any

from fastapi import APIRouter, Request
from starlette.responses import Response

from crenel.guide.common.audit_labels import audit_label
from crenel.guide.common.commands import Commands
from crenel.guide.common.guided_session import GuidedSession
from crenel.operations.context import Context, TheContext
from crenel.wire.json_response import json_response
from crenel.wire.schema import FlowCommand


def add_session_routes(
    router: APIRouter,
    path: str,
    view: type,
    guide_of: Callable[[Context], GuidedSession[Any, Any, Any]],
    commands: Commands[Any],
) -> None:
    """Adds the routes of the present view, and of its commands."""

    @router.get(path, response_model=view)
    def present_view(context: TheContext) -> Response:
        """The present view."""
        return json_response(guide_of(context).view())

    @router.post(path + "/command", response_model=view)
    def run_command(asked: FlowCommand, request: Request, context: TheContext) -> Response:
        """One of the view's actions; once for each key, and only on the present view."""
        request.state.detail = audit_label(asked.name)
        guide = guide_of(context)
        return json_response(commands.run(guide, asked.name, asked.args, asked.rev, asked.key))
