"""The browser of a request: its addresses and cookies, and the user as that browser sees them."""

from starlette.requests import HTTPConnection
from starlette.responses import Response

from crenel.api.access.sub_path import sub_path_of
from crenel.store.accounts import Role
from crenel.store.login_sessions import LONGEST, Principal
from crenel.wire.sign_in import CurrentUser, RoleName

A_YEAR_S = 365 * 86400
PORTS = {"http": 80, "ws": 80, "https": 443, "wss": 443}
BACK = "/sign-in"
"""The page to which the provider sends the browser; registered there as the redirect URI."""
ROLE_NAMES: dict[Role, RoleName] = {
    Role.viewer: "viewer",
    Role.operator: "operator",
    Role.admin: "admin",
}


def address_of(connection: HTTPConnection) -> str:
    """The address from which the request came."""
    return connection.client.host if connection.client else ""


def token_of(connection: HTTPConnection) -> str:
    """The cookie of the login session, or an empty string."""
    return connection.cookies.get(cookie_name(connection), "")


def cookie_name(connection: HTTPConnection) -> str:
    """One name per port and sub-path: browsers store cookies by host name, and send those of a
    station at ``/`` to one at ``/crenel/``, too."""
    url, sub_path = connection.url, sub_path_of(connection.scope)
    return cookie_for(url.port or PORTS[url.scheme]) + sub_path.replace("/", "-")


def cookie_for(port: int) -> str:
    """The same, by port."""
    return f"crenel-{port}"


def browser_token(connection: HTTPConnection) -> str:
    """The token that identifies this browser, or an empty string; it gives no access."""
    return connection.cookies.get(f"{cookie_name(connection)}-known", "")


def own_address(connection: HTTPConnection, path: str) -> str:
    """The address of a page, as this browser reaches the server."""
    sub_path = sub_path_of(connection.scope)
    return f"{connection.url.scheme}://{connection.url.netloc}{sub_path}{path}"


def pending_cookie(connection: HTTPConnection) -> str:
    """The cookie of a sign-in that waits for the provider's answer, or an empty string."""
    return connection.cookies.get(f"{cookie_name(connection)}-pending", "")


def set_pending_cookie(
    response: Response, connection: HTTPConnection, value: str, lasts_s: int
) -> None:
    """A sign-in was begun in this browser; an empty value: it is finished."""
    _write_cookie(response, connection, f"{cookie_name(connection)}-pending", value, lasts_s)


def set_cookie(response: Response, connection: HTTPConnection, token: str, kiosk: bool) -> None:
    """Signs this browser in with a token; scripts cannot read it, other pages cannot send it."""
    lasts_s = A_YEAR_S if kiosk else int(LONGEST.total_seconds())
    _write_cookie(response, connection, cookie_name(connection), token, lasts_s)


def set_browser_token(response: Response, connection: HTTPConnection, token: str) -> None:
    """The browser is trusted from now on."""
    _write_cookie(response, connection, f"{cookie_name(connection)}-known", token, A_YEAR_S)


def _write_cookie(
    response: Response, connection: HTTPConnection, name: str, token: str, lasts_s: int
) -> None:
    response.set_cookie(
        name,
        token,
        max_age=lasts_s,
        path=f"{sub_path_of(connection.scope)}/",
        httponly=True,
        samesite="strict",
        secure=connection.url.scheme == "https",
    )


def current_user(visitor: Principal | None) -> CurrentUser | None:
    """A user as their own browser sees them."""
    if visitor is None:
        return None
    role, by_provider = ROLE_NAMES[visitor.role], bool(visitor.provider)
    return CurrentUser(visitor.id, visitor.name, role, visitor.kiosk, by_provider)
