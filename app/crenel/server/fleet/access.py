"""Who may see the fleet's page: people with accounts of a provider, and whoever knows the page's
password."""

import hmac
import logging
from base64 import b64decode
from http import HTTPStatus
from pathlib import Path

from starlette.requests import HTTPConnection

from crenel.api.access.admission import admit_person
from crenel.api.access.browser import address_of, token_of
from crenel.errors import OperationError
from crenel.loops import on_thread, repeat
from crenel.messages.message import message
from crenel.security.authentication import AccessDeniedError, TooManyAttemptsError
from crenel.security.login_throttle import Throttle, address_key
from crenel.security.permissions import Right, has_right
from crenel.single_sign_on.person import ProviderPerson
from crenel.single_sign_on.settings import SignInSettings
from crenel.store.accounts import AccountStore, Role
from crenel.store.database import Database
from crenel.store.login_sessions import LoginSessionStore, Principal

log = logging.getLogger(__name__)
CHECK_S = 60.0
"""Between two checks whether the provider answers."""


class FleetPeople:
    """The people with accounts of one provider who signed in, kept over restarts.

    Raises:
        OperationError: the file of the accounts cannot be used.
    """

    def __init__(self, settings: SignInSettings, file: Path) -> None:
        # a server without a provider need not have the library
        from crenel.single_sign_on.provider import Provider

        self.provider = Provider(settings)
        self._database = Database(file)
        self._accounts = AccountStore(self._database)
        self.sessions = LoginSessionStore(self._database)
        for account in self._accounts.all():
            if account.provider != settings.issuer:
                self._accounts.remove(account.name)

    def admit(self, person: ProviderPerson, device: str) -> str:
        """Signs a browser in; returns its cookie.

        Raises:
            OperationError: the person is in no group with a role, or has no usable name.
        """
        issuer = self.provider.settings.issuer
        known = self._accounts.find_subject(issuer, person.subject)
        namesake = self._accounts.get(person.name)
        if person.role and namesake and (known is None or known.name != namesake.name):
            # the provider gave the name to somebody else: the former bearer is signed out
            self._accounts.remove(namesake.name)
        settings, accounts, sessions = self.provider.settings, self._accounts, self.sessions
        account = admit_person(person, settings, accounts, sessions, lambda name: None)
        return sessions.begin(account.name, device)

    async def watch_provider(self) -> None:
        """Until it is cancelled: notes whether the provider answers, for the entrance page."""
        check = self.provider.check
        await repeat("provider", lambda: on_thread(check), period_s=CHECK_S, longest_s=CHECK_S)

    def close(self) -> None:
        """No request is answered any more."""
        self._database.close()


class FleetAccess:
    """Decides about every request; without people and password, everyone may see everything.

    Args:
        password: of the page, by HTTP Basic with any user name; empty: there is none.
    """

    def __init__(self, people: FleetPeople | None = None, password: str = "") -> None:
        self.people, self.has_password = people, bool(password)
        self._password = password.encode()
        self._throttle = Throttle()

    @property
    def is_open(self) -> bool:
        """Whether nobody has to sign in."""
        return self.people is None and not self.has_password

    def visitor(self, connection: HTTPConnection) -> Principal | None:
        """The person who signed in at this browser."""
        token = token_of(connection)
        return self.people.sessions.principal(token) if self.people and token else None

    def check_may_act(self, connection: HTTPConnection) -> None:
        """Raises ``AccessDeniedError`` for a visitor who may only view; who knows the password may
        do everything."""
        if self.is_open or self.knows_password(connection):
            return
        visitor = self.visitor(connection)
        if visitor is None or not has_right(Right.operate, visitor.role, visitor.kiosk):
            name = "" if visitor is None else visitor.name
            raise AccessDeniedError(
                HTTPStatus.FORBIDDEN,
                "role",
                message("may-not-do-this", name=name, role=Role.operator.name),
                message("ask-somebody-with-role", role=Role.operator.name),
            )

    def knows_password(self, connection: HTTPConnection) -> bool:
        """Whether a request has the page's password.

        Raises:
            TooManyAttemptsError: too many wrong ones from this address.
        """
        given = _read_password(connection.headers.get("authorization", ""))
        if given is None or not self.has_password:
            return False
        address = address_of(connection)
        self.check_attempts(address)
        good = hmac.compare_digest(given, self._password)
        self.note_attempt(good, address)
        return good

    def check_attempts(self, address: str) -> None:
        """Raises ``TooManyAttemptsError`` after many failed attempts from an address."""
        if (wait_s := self._throttle.wait_s(address_key(address))) > 0:
            raise TooManyAttemptsError(wait_s)

    def note_attempt(self, good: bool, address: str) -> None:
        """Notes a password or a sign-in, which was right or failed."""
        note = self._throttle.note_success if good else self._throttle.note_failure
        note(address_key(address))


def open_access(sign_in: SignInSettings | None, accounts: Path, password: str) -> FleetAccess:
    """The access by these settings.

    Args:
        accounts: the file with the people who signed in.

    Raises:
        OperationError: the file cannot be used.
    """
    return FleetAccess(None if sign_in is None else FleetPeople(sign_in, accounts), password)


def log_refusal(error: OperationError, address: str) -> None:
    """Notes a failed sign-in in the log."""
    log.warning("a sign-in from %s failed: %s", address, error.line)


def _read_password(header: str) -> bytes | None:
    """The password of HTTP Basic; None if there is none."""
    scheme, _, encoded = header.partition(" ")
    if scheme.lower() != "basic":
        return None
    try:
        return b64decode(encoded, validate=True).partition(b":")[2]
    except ValueError:
        return None
