"""Models of who uses a station: sign-in, accounts, tokens, and the questions about control."""

from dataclasses import dataclass
from typing import Annotated, Literal

from pydantic import Field

from crenel.messages.message import Text
from crenel.wire.schema import RequestBody

Secret = Annotated[str, Field(max_length=256)]
Name = Annotated[str, Field(max_length=80)]
RoleName = Literal["viewer", "operator", "admin"]


class SignIn(RequestBody):
    name: Name
    password: Secret


class SignInCode(RequestBody):
    code: Secret


class ProviderReply(RequestBody):
    """With what a provider of accounts sent the browser back: a code or an error."""

    state: Annotated[str, Field(pattern=r"^[\w-]{1,100}$")]
    code: Annotated[str, Field(pattern="^[ -~]*$", max_length=4096)] = ""
    error: Annotated[str, Field(pattern="^[a-z_]*$", max_length=40)] = ""


class FirstAdmin(RequestBody):
    code: Secret
    name: Name
    password: Secret


class NewPassword(RequestBody):
    old: Secret
    new: Secret


class NewAccount(RequestBody):
    name: Name
    role: RoleName
    password: Secret


class AccountChange(RequestBody):
    """Fields that are not given stay unchanged."""

    role: RoleName | None = None
    password: Secret | None = None


class NewAccessToken(RequestBody):
    name: Annotated[str, Field(min_length=1, max_length=60)]


class ControlReply(RequestBody):
    give: bool


class TakeoverReason(RequestBody):
    reason: Annotated[str, Field(max_length=200)] = ""


@dataclass(frozen=True)
class CurrentUser:
    """The user signed in at this browser; ``id`` is that of the login session, as in
    ``Control``."""

    id: str
    name: str
    role: RoleName
    kiosk: bool
    by_provider: bool = False
    """Whether the account is of the provider, which has its password."""


@dataclass(frozen=True)
class ProviderPage:
    """Where the browser goes to sign in with an account of the provider."""

    address: str


@dataclass(frozen=True)
class SignInState:
    """``first_start``: the console's code creates the administrator; ``by_code``: the code signs
    in; ``provider``: the name of the provider of accounts, empty if there is none, and
    ``provider_trouble``, why it cannot be used; ``sign_out_page``: where it ends its own
    session; ``password_page``: where a browser asks for the password of the fleet's page;
    ``address``: that of the server's pages as the server was asked for it. A browser that knows
    another one is behind a proxy that does not pass everything on."""

    station: str
    you: CurrentUser | None
    first_start: bool
    by_code: bool
    provider: str = ""
    provider_trouble: Text = ""
    sign_out_page: str = ""
    password_page: str = ""
    address: str = ""


@dataclass(frozen=True)
class AccountSummary:
    name: str
    role: RoleName
    made_at: str
    by_provider: bool = False
    """Whether the account is of the provider, which has its password and its role."""


@dataclass(frozen=True)
class AccessTokenSummary:
    """A kiosk link, or an API token for the metrics; ``token`` only directly after its creation."""

    id: str
    name: str
    made_by: str
    made_at: str
    token: str | None = None
