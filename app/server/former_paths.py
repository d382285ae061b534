"""Routes by the paths that they had in earlier versions, for scripts that still ask for them."""

from starlette.types import ASGIApp, Receive, Scope, Send

FORMER_PATHS = {
    "/api/scan/hand": "/api/scan/simulation",
    "/api/session/wall": "/api/session/kiosk",
    "/api/walls": "/api/kiosk-links",
    "/api/scrapers": "/api/tokens",
}


class FormerPaths:
    """ASGI middleware that puts the present path in the place of a former one."""

    def __init__(self, app: ASGIApp) -> None:
        self._app = app

    async def __call__(self, scope: Scope, receive: Receive, send: Send) -> None:
        if scope["type"] == "http":
            path = present_path(scope["path"])
            if path != scope["path"]:
                scope = {**scope, "path": path, "raw_path": path.encode()}
        await self._app(scope, receive, send)


def present_path(path: str) -> str:
    """The path, with a former beginning replaced."""
    for former, present in FORMER_PATHS.items():
        if path == former or path.startswith(f"{former}/"):
            return present + path.removeprefix(former)
    return path
